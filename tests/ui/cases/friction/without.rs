//! A composition with friction for a system without.

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
    let run = Pendulum.run_with(Baoab, Phase::new([1.0], [0.0]), 0.1);
}
