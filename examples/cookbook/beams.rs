//! Particles in accelerators.

use integrator_core::prelude::*;

/// A sextupole beside the focusing of a ring: the difference resonance of third order (Lee, Accelerator Physics, chapter 2).
pub(crate) struct Sextupole {
    pub(crate) strength: f64,
}

#[hamiltonian]
impl Sextupole {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        (px * px + py * py) / 2.0
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        (x * x + y * y) / 2.0 + self.strength * (x.powi(3) / 3.0 - x * y * y)
    }
}

/// The phase of a particle in an accelerating bucket (Lee, Accelerator Physics, chapter 3).
pub(crate) struct Bucket {
    pub(crate) slip: f64,
    pub(crate) synchronous: f64,
}

#[hamiltonian]
impl Bucket {
    fn kinetic(&self, [p]: [f64; 1]) -> f64 {
        self.slip * p * p / 2.0
    }
    fn potential(&self, [x]: [f64; 1]) -> f64 {
        -(x + self.synchronous).cos() - x * self.synchronous.sin()
    }
}

/// A relativistic electron in a standing wave; T is no quadratic form (Chernikov, Tél, Vattay and Zaslavsky, Physical
/// Review A 40, 1989).
pub(crate) struct StandingWave {
    pub(crate) amplitude: f64,
}

#[hamiltonian]
impl StandingWave {
    fn kinetic(&self, [p]: [f64; 1]) -> f64 {
        (1.0 + p * p).sqrt()
    }
    fn potential(&self, [x]: [f64; 1]) -> f64 {
        self.amplitude * x.cos()
    }
}
