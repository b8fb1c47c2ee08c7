//! What stands on the user's functions stays there: documentation, attributes, visibility.

use integrator_core::prelude::*;

/// A documented system.
#[derive(Debug)]
pub struct Documented;

/// A documented impl.
#[hamiltonian]
#[allow(clippy::unused_self, reason = "an attribute of the user")]
impl Documented {
    /// How many dimensions.
    pub const DIMENSIONS: usize = 2;

    /// Documented and public.
    #[inline]
    #[must_use]
    pub fn kinetic(&self, p: [f64; Self::DIMENSIONS]) -> f64 {
        (p[0] * p[0] + p[1] * p[1]) / 2.0
    }

    /// Documented and of this crate.
    #[must_use]
    pub(crate) fn potential(
        &self,
        #[allow(unused_variables, reason = "an attribute")] [x, _]: [f64; Self::DIMENSIONS],
    ) -> f64 {
        Self::helper(x)
    }

    /// A helper without `self`.
    #[inline]
    const fn helper(x: f64) -> f64 {
        x * x / 2.0
    }
}

#[test]
fn the_functions_are_the_users() {
    assert_eq!(Documented.kinetic([1.0, 2.0]) + Documented.potential([3.0, 4.0]), 7.0);
    let mut run = Documented.run(Phase::new([1.0, 0.0], [0.0, 1.0]), 0.01).expect("an admissible start");
    run.advance(100).expect("finite");
    // Free in y: a sum of a hundred steps.
    let state: Phase<[f64; 2]> = run.state();
    assert!((state.q[1] - 1.0).abs() < 100.0 * f64::EPSILON);
}
