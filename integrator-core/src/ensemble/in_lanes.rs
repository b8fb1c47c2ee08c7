//! Methods that can integrate several trajectories in SIMD lanes, one member of an ensemble per lane.

use crate::{
    composition::{Composition, Scheme},
    hamiltonian::Hamiltonian,
    trajectory::method::{Memoryless, Method},
};

/// A method that can integrate an ensemble of `H`.
///
/// Every composition that supports a run also supports an ensemble; so does [`Taylor`](crate::taylor::Taylor) for a system
/// with `#[hamiltonian(taylor)]`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not carry on the members of an ensemble",
    label = "neither a composition for this Hamiltonian, nor another method that has lanes",
    note = "`Verlet`, `Yoshida4` and all other compositions of general class carry on every separable Hamiltonian",
    note = "`Taylor` needs recurrences, which are only written where they are asked for: `#[hamiltonian(taylor)]`",
    note = "methods of `reference` integrate one trajectory at a time, with `run_with`"
)]
pub trait InLanes<H: Hamiltonian>: Method<H> {}

impl<H: Hamiltonian, X: Scheme + Composition<H>> InLanes<H> for X {}

/// A method whose ensembles can be resumed from a checkpoint: compositions and implicit methods.
///
/// A checkpoint of an ensemble contains positions and momenta only. Other methods need more: the current polynomial of
/// each member for [`Taylor`](crate::taylor::Taylor), the time of each member for [`Logarithmic`](crate::Logarithmic),
/// [`Power`](crate::Power) and [`Paced`](crate::Paced).
#[diagnostic::on_unimplemented(
    message = "no ensemble by `{Self}` goes on from a checkpoint",
    label = "neither a composition for this Hamiltonian, nor `ImplicitMidpoint` or a method of Gauss",
    note = "members that take steps of their own, or have a time of their own, go on from more than such a checkpoint holds",
    note = "to begin anew: `advance_to(time)`, keep `states()`, and later `Ensemble::new(method, members, h)?.at_time(time)`",
    note = "a single run by `Logarithmic`, `Power` or `Paced` does go on, by `Run::resume_with`"
)]
pub trait ResumableInLanes<H: Hamiltonian>: InLanes<H> + Memoryless<H> {}

impl<H: Hamiltonian, X: Scheme + Composition<H>> ResumableInLanes<H> for X {}
