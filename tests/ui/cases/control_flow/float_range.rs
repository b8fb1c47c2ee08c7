//! A loop that counts in steps of a number, which Rust refuses as well.

use integrator_core::prelude::*;

struct System {
    mass: f64,
}

#[hamiltonian]
impl System {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        let mut v = 0.0;
        for x in 0.0..2.0 {
            v += x * q[0];
        }
        v + q[1]
    }
}

fn main() {
    let system = System { mass: 1.0 };
    let _ = (system.mass, system.run(Phase::new([0.1, 0.2], [0.0; 2]), 0.1));
}
