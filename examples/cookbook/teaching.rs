//! Systems of an introductory course.

use integrator_core::prelude::*;

/// The pendulum (Hairer, Lubich and Wanner, Geometric Numerical Integration, section I.1).
pub(crate) struct Pendulum {
    pub(crate) length: f64,
}

#[hamiltonian]
impl Pendulum {
    fn kinetic(&self, [p]: [f64; 1]) -> f64 {
        p * p / (2.0 * self.length.powi(2))
    }
    fn potential(&self, [x]: [f64; 1]) -> f64 {
        -9.81 * self.length * x.cos()
    }
}

/// A spring that stiffens with its extension (Duffing, Erzwungene Schwingungen, 1918).
pub(crate) struct Duffing {
    pub(crate) stiffening: f64,
}

#[hamiltonian]
impl Duffing {
    fn kinetic(&self, [p]: [f64; 1]) -> f64 {
        p * p / 2.0
    }
    fn potential(&self, [x]: [f64; 1]) -> f64 {
        x * x / 2.0 + self.stiffening * x.powi(4) / 4.0
    }
}

/// A pendulum on a spring (Vitt and Gorelik, Journal of Technical Physics of the USSR 3, 1933).
pub(crate) struct Swing {
    pub(crate) stiffness: f64,
}

#[hamiltonian]
impl Swing {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        (px * px + py * py) / 2.0
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        self.stiffness / 2.0 * (x.hypot(y) - 1.0).powi(2) + y
    }
}
