//! The choice among the multiversioned variants of single trajectories: the instruction set of this machine.

use crate::{
    hamiltonian::{Hamiltonian, Shaped},
    scalar::{instruction_set::InstructionSet, real::Real},
    state::{phase::Phase, precision::Precision},
    trajectory::{
        engine::Engine,
        method::Method,
        motions::{Constants, Group, Motions},
        step_functions::{Executor, InTiles},
    },
};
use alloc::{boxed::Box, sync::Arc, vec};

/// An empty list of motions of single trajectories, for the instruction set of this machine.
pub(crate) fn single<H: Hamiltonian, X: Method<H>, K: Precision>(
    constants: Constants<X::Constants>,
) -> Box<dyn Motions> {
    // A constant, so that nothing is compiled for the other instruction sets.
    if const { X::CLONED } {
        match InstructionSet::chosen() {
            InstructionSet::Baseline => motions::<H, X, K::Plain, K, InTiles>(constants),
            InstructionSet::Avx512 if X::WIDE => motions::<H, X, K::Avx512, K, InTiles>(constants),
            InstructionSet::Fused | InstructionSet::Avx512 => motions::<H, X, K::Fused, K, InTiles>(constants),
        }
    } else {
        motions::<H, X, K::Plain, K, InTiles>(constants)
    }
}

/// The engine of a trajectory, for the instruction set of this machine.
pub(crate) fn engine<H: Hamiltonian, X: Method<H>, K: Precision>(
    method: X,
    parameters: Arc<H::Parameters<f64>>,
    start: &Phase<Shaped<H, K>>,
) -> Engine {
    Engine::single(&*single::<H, X, K>(list(method.constants(parameters))), start)
}

/// The constants of one member: compiled once for all compositions.
fn list<Q>(constants: Arc<Q>) -> Constants<Q> {
    Arc::new(vec![constants])
}

/// An empty list of motions whose steps are computed in `R`.
pub(crate) fn motions<H: Hamiltonian, X: Method<H>, R: Real, K: Precision, E: Executor>(
    constants: Constants<X::Constants>,
) -> Box<dyn Motions> {
    Group::<X::Motion<R, K>, _, Shaped<H, K>>::empty(X::step_functions::<R, K, E>(), constants, 0)
}
