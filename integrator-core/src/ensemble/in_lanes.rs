//! Methods whose trajectories go side by side, each member of an ensemble in a lane of its own.

use crate::{
    composition::{Composition, Scheme},
    hamiltonian::Hamiltonian,
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
pub trait InLanes<H: Hamiltonian>: Method<H> {}

impl<H: Hamiltonian, X: Scheme + Composition<H>> InLanes<H> for X {}
