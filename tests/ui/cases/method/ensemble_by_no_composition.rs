//! What is no method with lanes, asked for in an ensemble.

use integrator_core::prelude::*;

struct ForwardEuler;

struct Oscillator;

#[hamiltonian]
impl Oscillator {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        0.5 * p[0] * p[0]
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        0.5 * q[0] * q[0]
    }
}

fn main() {
    let members = [(Oscillator, Phase::new([1.0], [0.0]))];
    let _ = Ensemble::new(ForwardEuler, members, 0.1);
}
