//! Charges in waves and traps.

use integrator_core::prelude::*;

/// A particle in two waves (Escande and Doveil, Journal of Statistical Physics 26, 1981).
pub(crate) struct TwoWaves {
    pub(crate) first: f64,
    pub(crate) second: f64,
}

#[hamiltonian]
impl TwoWaves {
    fn kinetic(&self, [p]: [f64; 1]) -> f64 {
        p * p / 2.0
    }
    fn potential(&self, [x]: [f64; 1], t: f64) -> f64 {
        -self.first * x.cos() - self.second * (x - t).cos()
    }
}

/// An ion in a Paul trap; time is half the phase of the drive (Paul, Reviews of Modern Physics 62, 1990).
pub(crate) struct PaulTrap {
    pub(crate) a: f64,
    pub(crate) q: f64,
}

#[hamiltonian]
impl PaulTrap {
    fn kinetic(&self, [p]: [f64; 1]) -> f64 {
        p * p / 2.0
    }
    fn potential(&self, [x]: [f64; 1], t: f64) -> f64 {
        (self.a - 2.0 * self.q * (2.0 * t).cos()) * x * x / 2.0
    }
}

/// Three ions on the axis of a trap (James, Applied Physics B 66, 1998).
pub(crate) struct IonChain;

#[hamiltonian]
impl IonChain {
    fn kinetic(&self, p: [f64; 3]) -> f64 {
        (0..3).map(|i| p[i] * p[i] / 2.0).sum()
    }
    fn potential(&self, q: [f64; 3]) -> f64 {
        let trap: f64 = (0..3).map(|i| q[i] * q[i] / 2.0).sum();
        trap + 1.0 / (q[1] - q[0]) + 1.0 / (q[2] - q[1]) + 1.0 / (q[2] - q[0])
    }
}
