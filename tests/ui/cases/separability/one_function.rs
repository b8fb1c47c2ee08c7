//! All of H in one function, with a term that mixes both: nothing else is reported.

use integrator_core::prelude::*;

struct System {
    field: f64,
}

#[hamiltonian]
impl System {
    fn hamiltonian(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 {
        0.5 * (px * px + py * py) + self.field * (x * py - y * px)
    }
}

fn main() {
    let system = System { field: 1.0 };
    let _ = (system.field, system.run(Phase::new([0.1, 0.2], [0.0; 2]), 0.1));
}
