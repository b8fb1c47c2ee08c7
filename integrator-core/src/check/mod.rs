//! Proofs by measurement that a stepper is what it claims to be.
//!
//! In: a system, a composition, a start and a step of the user's own problem. Out: numbers, each with the bound that
//! follows from the rounding of the scalar, and from [`certify()`] a verdict over all of them. Always true: the flows
//! that are checked are the generated ones, entered through the same trait as by a run; every verdict is one comparison
//! in one function, in which a NaN fails; a check that can find nothing says so in an error and does not pass.
//!
//! | check | right | wrong |
//! |---|---|---|
//! | [`symplectic_defect`] | rounding, for any step | of the size of the step |
//! | [`observed_order`] | the claimed order | below it |
//! | [`reversibility()`] | rounding, if the composition is symmetric | of the size of the error |
//! | [`energy_drift`] | [`Course::Bounded`], up to rounding | [`Course::Drift`] |
//! | [`gradient_error`] | rounding | of the size of the gradient |
//! | [`FlowErrors`] | rounding, for parts that are no `T(p)` and `V(q)` | of the size of the flow |
//! | [`Agreement`] | the user's own functions and their differences | off by more than rounding |
//! | [`InvariantDrift`] | a bracket with H of rounding, of what `#[invariant]` says is conserved | of the size of its terms |
//! | [`shadow()`] | the powers of [`ModifiedHamiltonian`], two by two for a symmetric composition | a lower one |
//!
//! [`certify()`] also looks for the order piece by piece along the orbit, wherever the slope of [`observed_order`] was
//! measured, and at the energy in steps of half the length: a kink that is met later, or a potential that jumps, would
//! escape the others.
//!
//! Each of them takes a [`Phase`](crate::Phase) as its start, or a [`Start`], which has a time as well.
//!
//! [`stability()`] measures how far a step is below the one at which its composition becomes unstable; that is no fault
//! of a stepper, so a certificate mentions it and is not refused for it.
//!
//! [`global_error()`] measures how far a run is from the exact motion, and how well that is known: no fault either,
//! since every step has an error.
//!
//! [`branches()`] tells which branches of H an orbit crosses, where deviation vectors may lose their meaning.
//!
//! [`monodromy()`] tells whether a periodic orbit is stable; the module [`chaos`](crate::chaos) is about all others.
//!
//! [`choose()`] measures too, but not whether a stepper is right: which of the right ones is the cheapest. [`choose_among()`]
//! does so for several splittings of one Hamiltonian.
//!
//! What is a property of the flows (symplecticity, order, gradient) is measured in `f64` whatever the leaf of the
//! start; what rounding takes part in (reversibility, energy) is measured in the precision of the start.

mod certificate;
mod certify;
mod choose;
mod error;
mod measurable;
mod modified;
pub(crate) mod oracle;
pub(crate) mod property;
mod shortfall;
mod start;
pub(crate) mod statistics;

pub use certificate::{Certificate, SecondPart, Tolerances};
pub use certify::certify;
pub use choose::{
    Candidate, Choice, ChooseError, Goal, LogarithmicSteps, PacedSteps, Ranking, Split, Splitting, Unranked,
    candidates, candidates_with, choose, choose_among,
};
pub use error::CheckError;
pub use modified::{
    ModifiedHamiltonian,
    series::{Bracket, BracketSeries},
};
pub use property::agreement::Agreement;
pub use property::branches::{Branches, Crossing, branches};
pub use property::energy::{EnergyDrift, energy_drift};
pub use property::flow_laws::{FlowErrors, FlowLaw};
pub use property::global_error::{GlobalError, global_error};
pub use property::gradient::gradient_error;
pub use property::invariants::InvariantDrift;
pub use property::monodromy::{Monodromy, Multiplier, monodromy};
pub use property::order::{Order, observed_order};
pub use property::reversibility::reversibility;
pub use property::shadow::{Shadow, ShadowPower, shadow};
pub use property::stability::{Stability, stability};
pub use property::symplecticity::{
    TangentMap, poisson_bracket, symplectic_defect, symplectic_defect_after, tangent_maps,
};
pub use shortfall::{CertifyError, Shortfall};
pub use start::{IntoStart, Start};
pub use statistics::trend::Course;
