//! A system without parameters, called as the generated struct of its prepared constants would be.

use integrator_core::prelude::*;

/// A free particle.
pub struct Parameters;

#[hamiltonian]
impl Parameters {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0]
    }
    fn potential(&self, _q: [f64; 1]) -> f64 {
        0.0
    }
}

#[test]
fn the_stepper_is_the_users_types_own() {
    let mut run = Parameters.run(Phase::new([0.0], [1.0]), 0.5).expect("a start");
    run.advance(4).expect("finite states");
    assert_eq!(run.state(), Phase::new([4.0], [1.0]), "q' = 2 p for a time of 2, exact in binary");
}
