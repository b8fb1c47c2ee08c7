//! Methods that can integrate several trajectories in SIMD lanes, one member of an ensemble per lane.

use crate::{
    composition::{Composition, Scheme},
    system::System,
    trajectory::method::{Method, Resumable},
};

/// A method that can integrate an ensemble of `H`.
///
/// Every composition that supports a run also supports an ensemble; so does [`Taylor`](crate::taylor::Taylor) for a system
/// with `#[hamiltonian(taylor)]`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot integrate an ensemble",
    label = "neither a composition for this Hamiltonian nor a method with SIMD lanes",
    note = "`Verlet`, `Yoshida4` and all other compositions of general class integrate every separable Hamiltonian",
    note = "`Taylor` requires `#[hamiltonian(taylor)]`, which generates its recurrences",
    note = "methods of `integrator-reference` integrate single trajectories, with `run_with`"
)]
pub trait InLanes<H: System>: Method<H> {}

impl<H: System, X: Scheme + Composition<H>> InLanes<H> for X {}

/// A method whose ensembles can be resumed from a checkpoint: compositions and implicit methods.
///
/// A checkpoint of an ensemble contains positions and momenta only. Other methods need more: the current polynomial of
/// each member for [`Taylor`](crate::taylor::Taylor), the time of each member for [`Logarithmic`](crate::Logarithmic),
/// [`Power`](crate::Power) and [`Paced`](crate::Paced).
#[diagnostic::on_unimplemented(
    message = "an ensemble with `{Self}` cannot be resumed from a checkpoint",
    label = "neither a composition for this Hamiltonian, nor `ImplicitMidpoint` or a Gauss method",
    note = "a checkpoint does not contain the step sizes and fictitious times of adaptive members",
    note = "to restart, call `advance_to(time)`, store `states()`, and later call `Ensemble::new(method, members, \
            h)?.at_time(time)`",
    note = "`Run::resume_with` resumes single runs with `Logarithmic`, `Power` or `Paced`"
)]
pub trait ResumableInLanes<H: System>: InLanes<H> + Resumable<H> {}

impl<H: System, X: Scheme + Composition<H>> ResumableInLanes<H> for X {}
