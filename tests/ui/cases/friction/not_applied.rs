//! A sequence that does not apply the friction of the system.

use integrator_core::prelude::*;

struct Pendulum;

#[hamiltonian(compose = V(1/2) T(1) V(1/2), split = kinetic + potential + friction)]
impl Pendulum {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -q[0].cos()
    }
    #[friction]
    fn friction(&self, _i: usize) -> f64 {
        0.1
    }
}

fn main() {
    let run = Pendulum.run(Phase::new([1.0], [0.0]), 0.1);
}
