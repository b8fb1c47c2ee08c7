//! A force-gradient kick in place, on a T that is not quadratic.

use integrator_core::prelude::*;

struct Relativistic;

#[hamiltonian(compose = V(1/6) T(1/2) V(2/3, -1/72) T(1/2) V(1/6))]
impl Relativistic {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        (1.0 + p[0] * p[0]).sqrt()
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        q[0] * q[0] / 2.0
    }
}

fn main() {
    let _ = Relativistic.run(Phase::new([0.1], [0.0]), 0.1);
}
