//! A loop whose iterations depend on the coordinates.

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
        let mut r = q[0];
        while r > 1.0 {
            r -= 1.0;
        }
        r * r + q[1]
    }
}

fn main() {
    let system = System { mass: 1.0 };
    let _ = (system.mass, system.run(Phase::new([0.1, 0.2], [0.0; 2]), 0.1));
}
