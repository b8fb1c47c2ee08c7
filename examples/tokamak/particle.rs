//! A charged particle in the field of a tokamak. Units: the major radius, the field on the magnetic axis, the charge and the mass; a
//! speed is the gyroradius on the axis.

use integrator_core::{GaussLegendre, prelude::*};
use std::f64::consts::TAU;

/// A tokamak with circular flux surfaces around the axis R = 1, z = 0.
#[derive(Clone, Copy)]
pub(crate) struct Tokamak {
    /// The safety factor: toroidal turns of a field line per poloidal turn, at a small minor radius.
    pub(crate) safety: f64,
}

/// `H = (p - A)²/2` in the cylindrical coordinates (R, φ, z), with `A_z = -ln R` for the toroidal field 1/R, and with the poloidal flux
/// `R A_φ`. The momentum `p_φ` is conserved, since the field does not depend on φ.
#[hamiltonian(split = none, compose = GaussLegendre<8>)]
impl Tokamak {
    fn hamiltonian(&self, q: [f64; 3], p: [f64; 3]) -> f64 {
        let [radial, toroidal, vertical] = self.velocity(q, p);
        0.5 * (radial * radial + toroidal * toroidal + vertical * vertical)
    }

    fn velocity(&self, [r, _, z]: [f64; 3], [pr, pphi, pz]: [f64; 3]) -> [f64; 3] {
        let flux = ((r - 1.0).powi(2) + z * z) / (2.0 * self.safety);
        [pr, (pphi - flux) / r, pz + r.ln()]
    }
}

impl Tokamak {
    /// Returns the start of a particle with a speed and a pitch, which is the velocity along the field divided by the speed. Its guiding
    /// centre is on the outer side of a flux surface, at R = 1 + `minor` and z = 0.
    pub(crate) fn start(&self, minor: f64, speed: f64, pitch: f64) -> Phase<[f64; 3]> {
        let (r, across) = (1.0 + minor, speed * (1.0 - pitch * pitch).sqrt());
        // The field is (0, 1, minor / safety) / R there, and the particle moves along R across the field.
        let toroidal = self.toroidal(minor);
        let z = -across * r * toroidal * toroidal;
        let along = [speed * pitch * toroidal, speed * pitch * toroidal * minor / self.safety];
        let flux = (minor * minor + z * z) / (2.0 * self.safety);
        Phase::new([r, 0.0, z], [across, r * along[0] + flux, along[1] - r.ln()])
    }

    /// Returns the toroidal component of the direction of the field.
    fn toroidal(&self, minor: f64) -> f64 {
        1.0 / (minor / self.safety).hypot(1.0)
    }

    /// Returns R and z of the guiding centre, `x + v × B / B²`.
    fn centre(&self, Phase { q, p }: &Phase<[f64; 3]>) -> [f64; 2] {
        let ([r, _, z], [radial, toroidal, vertical]) = (*q, self.velocity(*q, *p));
        let field = [-z / (self.safety * r), 1.0 / r, (r - 1.0) / (self.safety * r)];
        let square: f64 = field.iter().map(|component| component * component).sum();
        [
            r + (toroidal * field[2] - vertical * field[1]) / square,
            z + (radial * field[1] - toroidal * field[0]) / square,
        ]
    }

    /// Returns R of the guiding centre where it returns to z = 0.
    ///
    /// # Errors
    /// A step has no solution.
    pub(crate) fn returns(&self, minor: f64, speed: f64, pitch: f64, h: f64) -> Result<f64, Error> {
        // The field points upwards at the start. The time diverges at the boundary of trapped particles, as a logarithm.
        let direction = if pitch > 0.0 { Direction::Falling } else { Direction::Rising };
        let steps = 10.0 * TAU * self.safety / (speed * pitch.abs() * h);
        let run = self.run(self.start(minor, speed, pitch), h)?;
        let mut passages = run.crossings(steps as u64, direction, |state, _| self.centre(state)[1]);
        Ok(passages.next().transpose()?.map_or(f64::NAN, |passage| self.centre(&passage.state)[0]))
    }

    /// Returns the width of a banana orbit in the plane z = 0.
    ///
    /// # Errors
    /// As for [`Tokamak::returns`].
    pub(crate) fn banana(&self, minor: f64, speed: f64, pitch: f64, h: f64) -> Result<f64, Error> {
        Ok((self.returns(minor, speed, pitch, h)? - 1.0 - minor).abs())
    }

    /// Returns the width in the limit of a small gyroradius: both legs of the banana have the same `p_φ`.
    pub(crate) fn banana_of_theory(&self, minor: f64, speed: f64, pitch: f64) -> f64 {
        2.0 * self.safety * (1.0 + minor) * self.toroidal(minor) * speed * pitch.abs() / minor
    }

    /// Returns the largest pitch of a trapped particle by bisection, along the field (`sign` 1) or against it (-1). Beyond it, particles
    /// pass the inner side.
    ///
    /// # Errors
    /// As for [`Tokamak::returns`].
    pub(crate) fn boundary(&self, minor: f64, speed: f64, sign: f64, h: f64) -> Result<f64, Error> {
        let (mut trapped, mut passing) = (0.2, 1.0);
        while passing - trapped > 1e-6 {
            let pitch = f64::midpoint(trapped, passing);
            *if self.returns(minor, speed, sign * pitch, h)? < 1.0 { &mut passing } else { &mut trapped } = pitch;
        }
        Ok(trapped)
    }
}

/// Returns the boundary in the limit of a small gyroradius: the field on a flux surface is proportional to 1/R, and the magnetic
/// moment is conserved.
pub(crate) fn boundary_of_theory(minor: f64) -> f64 {
    (2.0 * minor / (1.0 + minor)).sqrt()
}
