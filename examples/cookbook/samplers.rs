//! Logarithms of densities, for Hamiltonian Monte Carlo.

use integrator_core::prelude::*;

/// A correlated normal distribution (Neal, Handbook of Markov Chain Monte Carlo, chapter 5).
pub(crate) struct Correlated {
    pub(crate) correlation: f64,
}

#[hamiltonian]
impl Correlated {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        (px * px + py * py) / 2.0
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        (x * x + y * y - 2.0 * self.correlation * x * y) / (2.0 * (1.0 - self.correlation.powi(2)))
    }
}

/// A banana-shaped distribution (Haario, Saksman and Tamminen, Computational Statistics 14, 1999).
pub(crate) struct Banana {
    pub(crate) bend: f64,
}

#[hamiltonian]
impl Banana {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        (px * px + py * py) / 2.0
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        x * x / 2.0 + (y + self.bend * (x * x - 1.0)).powi(2) / 2.0
    }
}

/// Neal's funnel in two variables (Neal, Annals of Statistics 31, 2003).
pub(crate) struct Funnel {
    pub(crate) width: f64,
}

#[hamiltonian]
impl Funnel {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        (px * px + py * py) / 2.0
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        x * x / (2.0 * self.width.powi(2)) + x / 2.0 + y * y * (-x).exp() / 2.0
    }
}
