//! Two invariants of the same name.

use integrator_core::prelude::*;

struct System {
    strength: f64,
}

#[hamiltonian]
impl System {
    fn kinetic(&self, p: [f64; 2]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        -self.strength / q[0].hypot(q[1])
    }
    #[invariant]
    fn angular_momentum(&self, q: [f64; 2], p: [f64; 2]) -> f64 {
        q[0] * p[1] - q[1] * p[0]
    }
    #[invariant]
    fn angular_momentum(&self, q: [f64; 2], p: [f64; 2]) -> f64 {
        q[1] * p[0] - q[0] * p[1]
    }
}

fn main() {
    let run = System { strength: 1.0 }.run(Phase::new([1.0, 0.0], [0.0, 1.0]), 0.1);
    let _ = run.map(|run| run.invariant("angular_momentum"));
}
