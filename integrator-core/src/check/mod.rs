//! Certificates: measurements that verify the properties of a stepper on your own problem.
//!
//! [`certify()`] runs all checks for a system, a method, a start and a step, and returns a verdict. Each check is also
//! available as a function. Measured values come with a bound that follows from the rounding errors of the scalar type. The
//! checked flows are the generated ones that runs use. NaN fails every check, and a check that cannot measure anything
//! returns an error.
//!
//! | check | if correct | if incorrect |
//! |---|---|---|
//! | [`symplectic_defect`] | rounding, for any step | of the size of the step |
//! | [`observed_order`] | the claimed order | below it |
//! | [`reversibility()`] | rounding, if the composition is symmetric | of the size of the error |
//! | [`energy_drift`] | [`Course::Bounded`], up to rounding | [`Course::Drift`] |
//! | [`gradient_error`] | rounding | of the size of the gradient |
//! | [`FlowErrors`], for parts other than `T(p)` and `V(q)` | rounding | of the size of the flow |
//! | [`Agreement`] with the user's own functions | rounding | larger than rounding |
//! | [`InvariantDrift`], of functions with `#[invariant]` | Poisson bracket with `H` of rounding | of the size of its terms |
//! | [`shadow()`] | the powers of [`ModifiedHamiltonian`], even only for a symmetric composition | a lower power |
//!
//! [`certify()`] also measures the order along the orbit, and the energy with half the step. This detects a kink of the
//! potential later on the orbit, and a potential that jumps.
//!
//! Each check accepts a [`Phase`](crate::Phase) as its start, or a [`Start`], which contains a time as well.
//!
//! Further measurements, which do not affect a certificate:
//!
//! - [`stability()`]: the ratio of the step to the stability limit of the composition. A certificate reports it.
//! - [`global_error()`]: the error of a run with respect to the exact solution, with its uncertainty.
//! - [`branches()`]: the branches of `H` that an orbit crosses. Deviation vectors may be wrong there.
//! - [`turns_in_time`]: how often `H` turns by its explicit time. A certificate requires at most one turn to a step.
//! - [`monodromy()`]: the stability of a periodic orbit. The module [`chaos`](crate::chaos) is for other orbits.
//! - [`oscillator_equilibrium`]: the bias of a composition with friction and noise, for a harmonic oscillator.
//! - [`configurational()`]: the forces and the Laplacian of the potential, for the configurational temperature.
//! - [`choose()`]: the cheapest composition and step for a required error. [`choose_among()`] compares several splittings of
//!   one Hamiltonian.
//!
//! Properties of the flows (symplecticity, order, gradient) are measured in `f64`. Properties that involve rounding
//! (reversibility, energy) are measured in the precision of the start.

mod certificate;
mod certify;
mod choose;
mod configurational;
mod equilibrium;
mod error;
mod flow;
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
    Candidate, Choice, ChooseError, Goal, LogarithmicSteps, NestedSteps, PacedSteps, Ranking, Split, Splitting,
    Unranked, candidates, candidates_with, choose, choose_among,
};
pub use configurational::{Configurational, configurational};
pub use equilibrium::{Equilibrium, oscillator_equilibrium};
pub use error::CheckError;
pub use modified::{
    ModifiedHamiltonian,
    series::{Bracket, BracketSeries},
};
pub use property::agreement::Agreement;
pub use property::branches::{Branches, Crossing, branches};
pub use property::drive::turns_in_time;
pub use property::energy::{EnergyDrift, energy_drift};
pub use property::flow_laws::{FlowErrors, FlowLaw};
pub use property::global_error::{GlobalError, global_error};
pub use property::gradient::gradient_error;
pub use property::invariants::InvariantDrift;
pub use property::monodromy::{Monodromy, Multiplier, monodromy};
pub use property::order::{Order, observed_order};
pub use property::reversibility::reversibility;
pub use property::shadow::{Shadow, ShadowPower, shadow};
pub use property::stability::{InnerStep, Stability, stability};
pub use property::symplecticity::{
    TangentMap, poisson_bracket, symplectic_defect, symplectic_defect_after, tangent_maps,
};
pub use shortfall::{CertifyError, Shortfall};
pub use start::{IntoStart, Start};
pub use statistics::trend::Course;
