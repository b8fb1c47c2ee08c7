//! Independent normal numbers of different widths: a density in closed form with as many coordinates as small models have.

use integrator_core::prelude::*;

/// Number of coordinates.
pub(crate) const COUNT: usize = 256;

/// Squared inverses of the standard deviations.
pub(crate) struct Normal {
    pub(crate) stiffness: [f64; COUNT],
}

#[hamiltonian]
impl Normal {
    fn kinetic(&self, p: [f64; COUNT]) -> f64 {
        let mut energy = 0.0;
        for i in 0..COUNT {
            energy += 0.5 * p[i] * p[i];
        }
        energy
    }
    pub(crate) fn potential(&self, q: [f64; COUNT]) -> f64 {
        let mut energy = 0.0;
        for i in 0..COUNT {
            energy += 0.5 * self.stiffness[i] * q[i] * q[i];
        }
        energy
    }
}

impl Normal {
    /// Returns the density whose inverse standard deviations are equidistant from 1 to 8.
    pub(crate) fn wide() -> Self {
        Self { stiffness: std::array::from_fn(|i| (1.0 + 7.0 * i as f64 / (COUNT - 1) as f64).powi(2)) }
    }
}
