//! A Gauss-Legendre method with too many stages, and one with none.

use integrator_core::{GaussLegendre, prelude::*};

struct Mixed;

#[hamiltonian(split = none, compose = GaussLegendre<9>)]
impl Mixed {
    fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0] * (1.0 + q[0] * q[0]) + q[0] * q[0]
    }
}

struct Pendulum;

#[hamiltonian]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -q[0].cos()
    }
}

fn main() {
    let _ = Pendulum.run_with(GaussLegendre::<0>, Phase::new([1.0], [0.0]), 0.1);
}
