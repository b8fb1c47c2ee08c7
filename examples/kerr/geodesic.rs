//! Geodesics around a rotating black hole. Units: the mass of the hole, G and c are one.

use integrator_core::{GaussLegendre, prelude::*};

/// A black hole of this spin, between 0 and 1.
#[derive(Clone, Copy)]
pub(crate) struct Kerr {
    pub(crate) spin: f64,
}

/// `H = g^{ab} p_a p_b / 2` in the coordinates (t, r, θ, φ) of Boyer and Lindquist; the time of the motion is the proper time of a
/// particle of mass one, for which H = -1/2. H does not separate: every term depends on positions and momenta.
#[hamiltonian(split = none, compose = GaussLegendre<8>)]
impl Kerr {
    fn hamiltonian(&self, [_, r, theta, _]: [f64; 4], [pt, pr, ptheta, pphi]: [f64; 4]) -> f64 {
        let (sine, cosine) = theta.sin_cos();
        let square = r * r + self.spin * self.spin;
        let (sigma, delta) = (r * r + (self.spin * cosine).powi(2), square - 2.0 * r);
        let (radial, polar) = (square * pt + self.spin * pphi, self.spin * sine * pt + pphi / sine);
        (delta * pr * pr + ptheta * ptheta - radial * radial / delta + polar * polar) / (2.0 * sigma)
    }
}

impl Kerr {
    /// Carter's constant of a geodesic (Carter 1968, Physical Review 174, 1559).
    pub(crate) fn carter(&self, Phase { q: [_, _, theta, _], p: [pt, _, ptheta, pphi] }: &Phase<[f64; 4]>) -> f64 {
        let (sine, cosine) = theta.sin_cos();
        ptheta * ptheta + (cosine * self.spin).powi(2) * (1.0 - pt * pt) + (cosine * pphi / sine).powi(2)
    }

    /// A particle on a circular orbit in the plane of the equator, in the direction of the spin (Bardeen, Press and Teukolsky
    /// 1972, The Astrophysical Journal 178, 347, equations 2.12 and 2.13).
    pub(crate) fn circle(&self, r: f64) -> Phase<[f64; 4]> {
        let (a, v) = (self.spin, r.sqrt().recip());
        let root = (1.0 - 3.0 * v.powi(2) + 2.0 * a * v.powi(3)).sqrt();
        let energy = (1.0 - 2.0 * v.powi(2) + a * v.powi(3)) / root;
        let momentum = r * v * (1.0 - 2.0 * a * v.powi(3) + (a * v.powi(2)).powi(2)) / root;
        Phase::new([0.0, r, std::f64::consts::FRAC_PI_2, 0.0], [-energy, 0.0, 0.0, momentum])
    }

    /// The innermost stable circular orbit in closed form (equation 2.21 there).
    pub(crate) fn innermost(&self) -> f64 {
        let a = self.spin;
        let z1 = 1.0 + (1.0 - a * a).cbrt() * ((1.0 + a).cbrt() + (1.0 - a).cbrt());
        let z2 = (3.0 * a * a + z1 * z1).sqrt();
        3.0 + z2 - ((3.0 - z1) * (3.0 + z1 + 2.0 * z2)).sqrt()
    }

    /// Two minus the trace of the radial motion near a circular orbit after the proper time τ: `2 - 2 cos(κ τ)` with the radial
    /// frequency `κ`, and negative if the orbit is unstable.
    ///
    /// # Errors
    /// There is no orbit of this radius.
    pub(crate) fn radial_force(&self, r: f64) -> Result<f64, Error> {
        let none = Phase::new([0.0; 4], [0.0; 4]);
        let mut vectors = [none; 2];
        (vectors[0].q[1], vectors[1].p[1]) = (1.0, 1.0);
        let mut tangent = self.tangent(GaussLegendre::<8>, self.circle(r), vectors, 0.25)?;
        tangent.advance(20)?;
        let images = tangent.vectors();
        Ok(2.0 - images[0].q[1] - images[1].p[1])
    }

    /// The innermost stable circular orbit as the radius at which the radial frequency vanishes, by bisection between the orbit
    /// of light and the orbit of a hole without spin.
    ///
    /// # Errors
    /// As for [`Kerr::radial_force`].
    pub(crate) fn innermost_by_tangents(&self) -> Result<f64, Error> {
        let light = 2.0 * (1.0 + (2.0 / 3.0 * (-self.spin).acos()).cos());
        let (mut unstable, mut stable) = (1.05 * light, 6.1);
        while stable - unstable > 1e-13 * stable {
            let middle = f64::midpoint(unstable, stable);
            *if self.radial_force(middle)? > 0.0 { &mut stable } else { &mut unstable } = middle;
        }
        Ok(stable)
    }
}

/// An inclined, eccentric orbit around a hole of spin 0.9 that comes close to the horizon at 1.436.
pub(crate) fn inclined() -> Phase<[f64; 4]> {
    let (energy, momentum, r, ptheta) = (0.95_f64, 2.5, 8.0, 1.5_f64);
    // The radial momentum from H = -1/2 in the plane of the equator.
    let (a, square) = (0.9_f64, 64.81);
    let delta = square - 2.0 * r;
    let (radial, polar) = (square * energy - a * momentum, momentum - a * energy);
    let pr = (((radial * radial) / delta - polar * polar - ptheta * ptheta - r * r) / delta).sqrt();
    Phase::new([0.0, r, std::f64::consts::FRAC_PI_2, 0.0], [-energy, pr, ptheta, momentum])
}
