//! Methods whose trajectories go side by side, each member of an ensemble in a lane of its own.

use crate::{
    composition::{Composition, Scheme},
    ensemble::interleaved::{GroupMoves, group_moves},
    hamiltonian::Hamiltonian,
    scalar::real::Real,
    state::precision::Precision,
    trajectory::method::Method,
};

/// A method that may carry on an ensemble of `H`: any composition that may integrate it, and
/// [`Taylor`](crate::taylor::Taylor) where the system has its recurrences.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not carry on the members of an ensemble",
    label = "neither a composition for this Hamiltonian, nor another method that has lanes",
    note = "`Verlet`, `Yoshida4` and all other compositions of general class carry on every separable Hamiltonian",
    note = "`Taylor` needs recurrences, which are only written where they are asked for: `#[hamiltonian(taylor)]`",
    note = "methods of `reference` integrate one trajectory at a time, with `run_with`"
)]
pub trait InLanes<H: Hamiltonian>: Method<H> {
    /// The steps, compiled for members in the lanes of `L`, where so many registers hold a number of all lanes each.
    fn group_moves<L: Real, K: Precision, const REGISTERS: usize>() -> GroupMoves<Self::Motion<L, K>>;
}

impl<H: Hamiltonian, X: Scheme + Composition<H>> InLanes<H> for X {
    fn group_moves<L: Real, K: Precision, const REGISTERS: usize>() -> GroupMoves<H::Motion<L, K>> {
        group_moves::<H, X, L, K, REGISTERS>()
    }
}
