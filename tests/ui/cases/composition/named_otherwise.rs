//! Methods that have another name here, or are not compositions.

use integrator_core::prelude::*;

struct Pendulum;

#[hamiltonian(compose = Leapfrog)]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        q[0] * q[0] / 2.0
    }
}

struct Spring;

#[hamiltonian(compose = RungeKutta4)]
impl Spring {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        q[0] * q[0] / 2.0
    }
}

fn main() {
    let _ = (Pendulum, Spring);
}
