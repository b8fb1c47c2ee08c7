//! A start of another shape than the functions take.

use integrator_core::prelude::*;

struct System;

#[hamiltonian]
impl System {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        p[0] * p[0] + p[1] * p[1]
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        q[0] * q[1]
    }
}

fn main() {
    let _ = System.run(Phase::new([0.1], [0.0]), 0.1);
}
