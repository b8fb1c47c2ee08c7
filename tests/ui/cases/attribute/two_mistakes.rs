//! Two mistakes are both reported, at once.

use integrator_core::prelude::*;

struct System {
    mass: f64,
}

#[hamiltonian]
impl System {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        p[0].next_up() + p[1] * p[1]
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        q[0].cos() + q[7]
    }
}

fn main() {
    let system = System { mass: 1.0 };
    let _ = (system.mass, system.run(Phase::new([0.1, 0.2], [0.0; 2]), 0.1));
}
