//! An argument that is not one.

use integrator_core::prelude::*;

struct System {
    mass: f64,
}

#[hamiltonian(composition = Yoshida4)]
impl System {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        q[0].cos() + q[1] * q[1]
    }
}

fn main() {
    let system = System { mass: 1.0 };
    let _ = (system.mass, system.run(Phase::new([0.1, 0.2], [0.0; 2]), 0.1));
}
