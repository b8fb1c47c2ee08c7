//! The runtime under another name, and behind a path of the user.

use renamed::{Composition, Hamiltonian, Phase, composition, hamiltonian};

/// The user's own module that passes the runtime on.
pub mod facade {
    pub use renamed as steppers;
}

/// A system of the renamed crate.
pub struct Oscillator;

#[hamiltonian(crate = renamed, compose = Mine)]
impl Oscillator {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        q[0] * q[0] / 2.0
    }
}

/// The same through a path.
pub struct Behind;

#[hamiltonian(compose = V(1/2) T(1) V(1/2), crate = facade::steppers)]
impl Behind {
    fn kinetic(&self, p: [f64; 1]) -> f64 {
        p[0] * p[0] / 2.0
    }
    fn potential(&self, q: [f64; 1]) -> f64 {
        q[0] * q[0] / 2.0
    }
}

composition! {
    crate = renamed;
    /// Of the renamed crate.
    pub struct Mine: order 1 = V(1) T(1);
}

composition! {
    crate = crate::renamed_dependency::facade::steppers;
    /// Through a path.
    pub struct Other: order 2 = T(1/2) V(1) T(1/2);
}

#[test]
fn both_run() {
    fn end<H: Hamiltonian<Coords = [f64; 1]>, X: Composition<H>>(system: &H, composition: X) -> f64 {
        let run = system.run_with::<f64, X>(composition, Phase::new([1.0], [0.0]), 1e-3);
        let mut run = run.expect("an admissible start");
        run.advance(1000).expect("finite");
        run.state().q[0]
    }
    // Euler's method errs by half a step of 1e-3 over a time of one.
    for q in [end(&Oscillator, Mine), end(&Oscillator, Other), end(&Behind, Mine), end(&Behind, Other)] {
        assert!((q - 1.0_f64.cos()).abs() < 1e-3, "{q}");
    }
}
