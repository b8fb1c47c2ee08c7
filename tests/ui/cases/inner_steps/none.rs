//! A number of inner steps for a system without any.

use integrator_core::prelude::*;

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
    let _ = Pendulum.run_with(Verlet.nested(4), Phase::new([1.0], [0.0]), 0.1);
}
