//! The Taylor method, asked for in a run of a system that has no recurrences.

use integrator_core::{prelude::*, taylor::Taylor};

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
    let _ = Pendulum.run_with(Taylor::tolerance(1e-16), Phase::new([0.1], [0.0]), 0.1);
}
