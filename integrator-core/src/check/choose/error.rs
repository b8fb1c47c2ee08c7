//! Errors in the choice of a composition.

use crate::{
    check::CheckError,
    error::{Number, debug_as_display},
};

debug_as_display!(ChooseError);

/// The reason why no composition could be chosen.
#[derive(Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ChooseError {
    /// A run could not start, or its energy is not conserved.
    #[error(transparent)]
    Check(#[from] CheckError),
    /// There is no splitting to choose.
    #[error("no splitting is given: name at least one system")]
    NoSplitting,
    /// The span is zero or not finite.
    #[error("the span is {span}: it has to be finite and not zero (negative spans run backwards)", span = Number(*span))]
    Span {
        /// The requested span.
        span: f64,
    },
    /// The tolerance is not a positive number.
    #[error("the tolerance is {tolerance}: it has to be positive and finite", tolerance = Number(*tolerance))]
    Tolerance {
        /// The requested tolerance.
        tolerance: f64,
    },
    /// The Hamiltonian has pieces in time, and no equal steps over the span end at all of their edges.
    #[error(
        "the Hamiltonian changes its formula at t = {time}, where no equal steps over a span of {span} end, and a step over the \
         edge costs the order: choose a span that is a multiple of the time between edges",
        time = Number(*time), span = Number(*span)
    )]
    Edge {
        /// The time of an edge that is inside of a step.
        time: f64,
        /// The requested span.
        span: f64,
    },
    /// The reference solution is not known to the tolerance.
    #[error(
        "the motion cannot be followed to {tolerance:e} over this span: halving the step of a run of high order changes it \
         by {difference:e} at the least. A shorter span, a looser tolerance, or the energy as the goal helps"
    )]
    Unfollowed {
        /// The requested tolerance.
        tolerance: f64,
        /// The smallest change between two refinements.
        difference: f64,
    },
    /// No composition reaches the tolerance.
    #[error(
        "no composition reaches {tolerance:e}; {composition} comes closest with {error:e}. Below that, rounding or the \
         length of the span prevails: a compensated start, a shorter span or a looser tolerance helps"
    )]
    Unreached {
        /// The requested tolerance.
        tolerance: f64,
        /// The composition with the smallest error.
        composition: &'static str,
        /// The smallest error.
        error: f64,
    },
}
