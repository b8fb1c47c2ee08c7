//! The systems of the tests, in the program that ranks run and in the process that compares.

use integrator_core::hamiltonian;

pub(crate) const MEMBERS: usize = 101;
pub(crate) const STEPS: u64 = 300;

pub(crate) struct Pendulum {
    length: f64,
}

pub(crate) fn pendulum(i: usize) -> Pendulum {
    Pendulum { length: 0.5 + i as f64 / 100.0 }
}

#[cfg_attr(feature = "gpu", hamiltonian(gpu))]
#[cfg_attr(not(feature = "gpu"), hamiltonian)]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0].powi(2) / (2.0 * self.length.powi(2))
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -9.81 * self.length * q[0].cos()
    }
}

/// A chain of as many links as its state has.
pub(crate) struct Chain;

#[hamiltonian]
impl Chain {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        q.iter().map(|q| q.powi(2) / 2.0 + q.powi(4) / 4.0).sum()
    }
}

/// Whatever is not at rest falls to infinity, each as strongly as it says.
pub(crate) struct Fall {
    pub(crate) pull: f64,
}

pub(crate) fn fall(i: usize) -> Fall {
    Fall { pull: 1.0 + i as f64 / 1000.0 }
}

#[cfg_attr(feature = "gpu", hamiltonian(gpu))]
#[cfg_attr(not(feature = "gpu"), hamiltonian)]
impl Fall {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0].powi(2) / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -self.pull * q[0].powi(6)
    }
}

/// Chaotic where its energy is large.
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

/// An oscillator in a bath.
pub(crate) struct Bath;

#[hamiltonian(split = kinetic + potential + friction)]
impl Bath {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        q[0] * q[0] / 2.0
    }
    #[friction]
    fn friction(&self, _i: usize) -> f64 {
        1.0
    }
    #[temperature]
    fn temperature(&self, _i: usize) -> f64 {
        0.5
    }
}
