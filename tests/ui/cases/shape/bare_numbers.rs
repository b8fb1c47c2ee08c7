//! Numbers where arrays of them are meant.

use integrator_core::prelude::*;

struct System;

#[hamiltonian]
impl System {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        q[0] * q[0]
    }
}

fn main() {
    let start = Phase::new(1.0, 0.0);
    let _ = System.run(start, 0.1);
}
