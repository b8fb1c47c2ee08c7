//! Methods whose trajectories go side by side, each member of an ensemble in a lane of its own.

use crate::{
    composition::{Composition, Scheme},
    hamiltonian::Hamiltonian,
    trajectory::method::{Memoryless, Method},
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

/// A method whose ensembles go on from a checkpoint: any composition that may integrate `H`, and implicit methods. Members by
/// other methods go on from more than the positions and momenta that a checkpoint of an ensemble holds: those of
/// [`Taylor`](crate::taylor::Taylor) are within a step of their own, of which each has an expansion, and those of
/// [`Logarithmic`](crate::Logarithmic), `Power` and `Paced` are at times of their own.
#[diagnostic::on_unimplemented(
    message = "no ensemble by `{Self}` goes on from a checkpoint",
    label = "neither a composition for this Hamiltonian, nor `ImplicitMidpoint` or a method of Gauss",
    note = "members that take steps of their own, or have a time of their own, go on from more than such a checkpoint holds",
    note = "to begin anew: `advance_to(time)`, keep `states()`, and later `Ensemble::new(method, members, h)?.at_time(time)`",
    note = "a single run by `Logarithmic`, `Power` or `Paced` does go on, by `Run::resume_with`"
)]
pub trait ResumableInLanes<H: Hamiltonian>: InLanes<H> + Memoryless<H> {}

impl<H: Hamiltonian, X: Scheme + Composition<H>> ResumableInLanes<H> for X {}
