//! A charged particle in a Penning trap: a uniform magnetic field along z, and the quadrupole and the octupole of the
//! electrodes (Brown and Gabrielse 1986, Rev. Mod. Phys. 58, 233).

use integrator_core::prelude::*;
use std::f64::consts::TAU;

/// A trap, given by the frequencies of a particle. Lengths are in units of the trap size, masses in units of the particle
/// mass.
pub(crate) struct Trap {
    /// Cyclotron frequency of the free particle.
    pub(crate) cyclotron: f64,
    /// Frequency of small axial oscillations.
    pub(crate) axial: f64,
    /// Coefficient of the octupole, C₄.
    pub(crate) octupole: f64,
}

#[hamiltonian(split = ideal + octupole, compose = Aba864)]
impl Trap {
    /// `(p - A)²/2` with the vector potential of the magnetic field, and the quadrupole: solved exactly.
    fn ideal(&self, [x, y, z]: [f64; 3], [px, py, pz]: [f64; 3]) -> f64 {
        let (vx, vy) = (px + 0.5 * self.cyclotron * y, py - 0.5 * self.cyclotron * x);
        let quadrupole = z * z - 0.5 * (x * x + y * y);
        0.5 * (vx * vx + vy * vy + pz * pz) + 0.5 * self.axial * self.axial * quadrupole
    }

    /// The octupole, which makes the axial frequency depend on the amplitude.
    fn octupole(&self, q: [f64; 3]) -> f64 {
        let (rho2, z2) = (q[0] * q[0] + q[1] * q[1], q[2] * q[2]);
        0.5 * self.octupole * self.axial * self.axial * (z2 * z2 - 3.0 * z2 * rho2 + 0.375 * rho2 * rho2)
    }
}

impl Trap {
    /// Returns the modified cyclotron frequency and the magnetron frequency, in a trap without octupole.
    pub(crate) fn radial(&self) -> [f64; 2] {
        let root = (self.cyclotron * self.cyclotron - 2.0 * self.axial * self.axial).sqrt();
        [0.5 * (self.cyclotron + root), 0.5 * (self.cyclotron - root)]
    }

    /// Returns the state of a particle with these cyclotron and magnetron radii, at rest axially at this height.
    pub(crate) fn start(&self, radii: [f64; 2], height: f64) -> Phase<[f64; 3]> {
        let (frequencies, x) = (self.radial(), radii[0] + radii[1]);
        let vy = -(frequencies[0] * radii[0] + frequencies[1] * radii[1]);
        Phase::new([x, 0.0, height], [0.0, vy + 0.5 * self.cyclotron * x, 0.0])
    }

    /// Returns the radial position at a time without octupole: the sum of two circular motions.
    pub(crate) fn orbit(&self, radii: [f64; 2], time: f64) -> [f64; 2] {
        let [(fast_sine, fast_cosine), (slow_sine, slow_cosine)] =
            self.radial().map(|frequency| (frequency * time).sin_cos());
        [radii[0] * fast_cosine + radii[1] * slow_cosine, -radii[0] * fast_sine - radii[1] * slow_sine]
    }
}

/// Returns the axial frequency over some steps, from the times of upward crossings of the centre.
///
/// # Errors
/// The state becomes infinite or NaN.
pub(crate) fn axial_frequency(trap: &Trap, start: Phase<[f64; 3]>, h: f64, steps: u64) -> Result<f64, Error> {
    let passages = trap.run(start, h)?.crossings(steps, Direction::Rising, |state, _| state.q[2]);
    let times = passages.map(|passage| passage.map(|passage| passage.time)).collect::<Result<Vec<f64>, Error>>()?;
    let oscillations = times.len().saturating_sub(1) as f64;
    Ok(TAU * oscillations / (times.last().unwrap_or(&0.0) - times.first().unwrap_or(&0.0)))
}
