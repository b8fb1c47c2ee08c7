//! Formulas in the spelling of other languages, which rustc rejects as well.

use integrator_core::prelude::*;

struct System {
    mass: f64,
}

#[hamiltonian]
impl System {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0]**2 + p[1]^2) / (2 * self.mass)
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        np::sin(q[0]) + Math::pow(q[1], 2)
    }
}

fn main() {
    let system = System { mass: 1.0 };
    let _ = (system.mass, system.run(Phase::new([0.1, 0.2], [0.0; 2]), 0.1));
}
