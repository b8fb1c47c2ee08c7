//! Particles in accelerators.

use integrator_core::prelude::*;

/// A sextupole with the linear focusing of a ring, at the third-order difference resonance, `νx = 2 νy` (Lee, Accelerator
/// Physics, chapter 2).
pub(crate) struct Sextupole {
    pub(crate) strength: f64,
}

#[hamiltonian]
impl Sextupole {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        (px * px + py * py) / 2.0
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        (4.0 * x * x + y * y) / 2.0 + self.strength * (x.powi(3) / 3.0 - x * y * y)
    }
}

/// The longitudinal phase of a particle in an accelerating bucket (Lee, Accelerator Physics, chapter 3).
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

/// A relativistic particle in a periodic potential; `T` is not quadratic (Landau and Lifshitz, The Classical Theory of
/// Fields, § 9).
pub(crate) struct PeriodicPotential {
    pub(crate) amplitude: f64,
}

#[hamiltonian]
impl PeriodicPotential {
    fn kinetic(&self, [p]: [f64; 1]) -> f64 {
        (1.0 + p * p).sqrt()
    }
    fn potential(&self, [x]: [f64; 1]) -> f64 {
        self.amplitude * x.cos()
    }
}
