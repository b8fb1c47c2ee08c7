//! A name that no layout has.

use integrator_core::prelude::*;

struct Chain;

#[hamiltonian(layout = lines)]
impl Chain {
    fn kinetic(&self, p: &[f64]) -> f64 {
        p.iter().map(|p| p * p / 2.0).sum()
    }
    fn potential(&self, q: &[f64]) -> f64 {
        (1..q.len()).map(|i| (q[i] - q[i - 1]).powi(4)).sum()
    }
}

fn main() {
    // The stepper is still there, so that nothing else is reported.
    let _ = Chain.run(Phase::new(vec![0.0; 64], vec![0.0; 64]), 0.1);
}
