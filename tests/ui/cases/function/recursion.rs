//! A helper method that calls itself.

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
        self.chain(q[0], 3) + q[1]
    }
    fn chain(&self, x: f64, n: i32) -> f64 {
        if n == 0 { x } else { self.chain(x * x, n - 1) }
    }
}

fn main() {
    let system = System { mass: 1.0 };
    let _ = (system.mass, system.run(Phase::new([0.1, 0.2], [0.0; 2]), 0.1));
}
