//! A pace of one's own without a `rate` that tells it.

use integrator_core::prelude::*;

struct Fast;

#[hamiltonian]
impl Fast {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        (1.0 + p[0] * p[0]).sqrt()
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        -q[0].cos()
    }
}

fn main() {
    let run = Fast.run_with(Paced(KahanLi8), Phase::new([1.0], [0.0]), 0.1);
}
