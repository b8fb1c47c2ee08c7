//! A pendulum, a double well, a Kepler orbit, and the Hénon–Heiles system.

use integrator_core::prelude::*;

pub(crate) struct Pendulum;

#[hamiltonian]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -q[0].cos()
    }
}

pub(crate) struct DoubleWell;

#[hamiltonian]
impl DoubleWell {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        (q[0].powi(2) - 1.0).powi(2)
    }
}

pub(crate) struct Kepler;

#[hamiltonian]
impl Kepler {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        0.5 * (px * px + py * py)
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        -1.0 / (x * x + y * y).sqrt()
    }
}

pub(crate) struct HenonHeiles;

#[hamiltonian]
impl HenonHeiles {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        0.5 * (px * px + py * py)
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        0.5 * (x * x + y * y) + x * x * y - y.powi(3) / 3.0
    }
}

impl HenonHeiles {
    /// Returns the state at x = 0 with `p_x > 0` for this energy, or `None` where the energy allows no orbit.
    pub(crate) fn start(&self, energy: f64, y: f64, py: f64) -> Option<Phase<[f64; 2]>> {
        let px_squared = 2.0 * (energy - self.potential([0.0, y])) - py * py;
        (px_squared > 0.0).then(|| Phase::new([0.0, y], [px_squared.sqrt(), py]))
    }
}
