//! Why a check could not be carried out.

use crate::error::{Error, Number, debug_as_display};

debug_as_display!(CheckError);

/// Why a check has no result. That a stepper is wrong is not among the reasons: then the result says so.
#[derive(Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CheckError {
    /// The run that the check needs could not start or go on.
    #[error(transparent)]
    Run(#[from] Error),
    /// Too few step sizes have an error that stands out of the rounding, so that no slope can be fitted.
    #[error(
        "only {found} step sizes from {coarsest:.1e} down have an error above the rounding, and a slope needs {needed}: \
         this start moves too little, or in so simple a way that every step is exact; start elsewhere"
    )]
    TooFewPoints {
        /// The number of usable step sizes.
        found: usize,
        /// The number that is needed.
        needed: usize,
        /// The coarsest step size that was tried.
        coarsest: f64,
    },
    /// However short the time, halving the step changes the result by more than a tenth of the motion.
    #[error(
        "no step size down to {finest} follows the motion from this start: it is singular, or the flows do not \
         belong to one Hamiltonian", finest = Number(*finest))]
    NotSmooth {
        /// The finest step size that was tried.
        finest: f64,
    },
    /// A condition on the time changes inside of a step.
    #[error(
        "the Hamiltonian changes its formula at t = {time}, inside of a step of {h}, which costs the order: choose a step that \
         ends there", time = Number(*time), h = Number(*h))]
    EdgeInside {
        /// When.
        time: f64,
        /// The step.
        h: f64,
    },
    /// The method takes steps of its own.
    #[error("{method} covers a step by steps of its own, so that its errors follow a tolerance and show no order")]
    NoOrder {
        /// The name of the method.
        method: &'static str,
    },
    /// Deviations grow beyond the root of the largest number, where no eigenvalues are computed.
    #[error("deviations grow by more than 1e150 within {steps} steps: take a shorter period")]
    Growth {
        /// The steps of the period.
        steps: u64,
    },
    /// A measured quantity is NaN where the motion is finite.
    #[error("{what} is NaN where the energies are finite: they have no finite derivatives there")]
    NotFinite {
        /// The name of the quantity.
        what: &'static str,
    },
    /// The Hamiltonian depends on time, so its energy is not conserved.
    #[error("the Hamiltonian reads the time, so that its energy is not conserved and says nothing about the stepper")]
    NotAutonomous,
    /// What is measured belongs to `T(p) + V(q)`, and the Hamiltonian is split into other parts.
    #[error("{what} is known for T(p) + V(q) alone, and this Hamiltonian is split into other parts")]
    NotSeparable {
        /// What is measured.
        what: &'static str,
    },
    /// The derivative of an energy by duals is not the one by central differences: it has a kink or a jump here.
    #[error(
        "{energy} changes by {dual:.4e} per unit of coordinate {index} according to duals, but by {difference:.4e} +- \
         {uncertainty:.1e} according to central differences: it has a kink or a jump here, where no gradient exists"
    )]
    NotDifferentiable {
        /// `T` or `V`.
        energy: &'static str,
        /// Which coordinate, counted over the flattened `p` or `q`.
        index: usize,
        /// The derivative by duals.
        dual: f64,
        /// The derivative by central differences.
        difference: f64,
        /// A bound on truncation and rounding of the latter.
        uncertainty: f64,
    },
    /// An invariant does not change with any coordinate.
    #[error(
        "the invariant `{name}` changes with no coordinate at a state of the orbit, so that nothing can be said of it"
    )]
    ConstantInvariant {
        /// The name of the function.
        name: &'static str,
    },
    /// At no state could the generated code be held against the user's functions.
    #[error(
        "none of {left_out} comparisons with your own functions could be made: they have kinks or jumps wherever the orbit \
         was looked at, or no value"
    )]
    NothingToCompare {
        /// The number of states that were tried.
        left_out: usize,
    },
    /// There is no such coordinate.
    #[error("there is no coordinate {index}: the system has {coordinates}, counted from 0")]
    NoCoordinate {
        /// The index of the coordinate.
        index: usize,
        /// The number of coordinates.
        coordinates: usize,
    },
    /// The run is too short for what is measured.
    #[error("{steps} steps are too few to measure anything: at least {needed} are needed")]
    TooFewSteps {
        /// The number of steps of the run.
        steps: u64,
        /// The number that is needed.
        needed: u64,
    },
    /// One step parts deviation vectors by more than numbers have digits.
    #[error(
        "neighbours part by a factor of {factor:.1e} within one step of {step}, more than numbers have digits, so that the smaller \
         exponents are lost: take a step of {shorter:.2e} or less", step = Number(*step))]
    LongForExponents {
        /// The step.
        step: f64,
        /// How much more the most stretched direction grows than the least stretched one, as far as digits show it.
        factor: f64,
        /// A step that shows them.
        shorter: f64,
    },
    /// The exact motion is not known well enough to hold a run against it.
    #[error(
        "over a time of {span} the exact motion is known to {uncertainty} of the way it goes, at best: it leads into a \
         singularity, or for too long; shorten the time, or let `#[hamiltonian(taylor)]` write recurrences for a better \
         reference", span = Number(*span), uncertainty = Number(*uncertainty))]
    NoReference {
        /// The time.
        span: f64,
        /// The distance of two references, in units of the excursion of the motion; NaN if one of them diverges.
        uncertainty: f64,
    },
}
