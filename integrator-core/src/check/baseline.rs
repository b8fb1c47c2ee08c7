//! A method compiled for one instruction set: for the many runs of a check, which would otherwise be compiled for all.

use crate::{
    error::Error,
    hamiltonian::Hamiltonian,
    method::{Described, Facts, Method},
    moves::Moves,
    real::Real,
    slot::Keep,
};
use std::sync::Arc;

/// A method whose steps are compiled for what every machine of the target has. They are those of the method, from the same
/// generated text.
#[derive(Clone, Copy)]
pub(crate) struct Baseline<X>(pub(crate) X);

impl<X: Described> Described for Baseline<X> {
    fn facts(self) -> Facts {
        self.0.facts()
    }
    fn admissible(self) -> Result<(), Error> {
        self.0.admissible()
    }
}

impl<H: Hamiltonian, X: Method<H>> Method<H> for Baseline<X> {
    const CLONED: bool = false;
    const WIDE: bool = false;

    type Constants = X::Constants;
    type Motion<R: Real, K: Keep> = X::Motion<R, K>;

    fn forces(self) -> Option<usize> {
        self.0.forces()
    }
    fn constants(self, parameters: Arc<H::Parameters<f64>>) -> Arc<X::Constants> {
        self.0.constants(parameters)
    }
    fn moves<R: Real, K: Keep>() -> Moves<X::Motion<R, K>> {
        X::moves::<R, K>()
    }
}
