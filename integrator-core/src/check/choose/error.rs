//! Errors of the choice of a composition.

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
        /// The span that was asked for.
        span: f64,
    },
    /// The tolerance is not a positive number.
    #[error("the tolerance is {tolerance}: it has to be positive and finite", tolerance = Number(*tolerance))]
    Tolerance {
        /// The tolerance that was asked for.
        tolerance: f64,
    },
    /// The Hamiltonian is defined by pieces in time, and no equal steps over the span end where these do.
    #[error(
        "the Hamiltonian changes its formula at t = {time}, where no equal steps over a span of {span} end, and a step over the \
         edge costs the order: choose a span that is a multiple of the time between edges",
        time = Number(*time), span = Number(*span)
    )]
    Edge {
        /// The time of an edge that no step meets.
        time: f64,
        /// The span that was asked for.
        span: f64,
    },
    /// The true motion is not known to the tolerance.
    #[error(
        "the motion cannot be followed to {tolerance:e} over this span: halving the step of a run of high order changes it \
         by {difference:e} at the least. A shorter span, a looser tolerance, or the energy as the goal helps"
    )]
    Unfollowed {
        /// The tolerance that was asked for.
        tolerance: f64,
        /// The smallest change.
        difference: f64,
    },
    /// No composition reaches the tolerance.
    #[error(
        "no composition reaches {tolerance:e}; {composition} comes closest with {error:e}. Below that, rounding or the \
         length of the span prevails: a compensated start, a shorter span or a looser tolerance helps"
    )]
    Unreached {
        /// The tolerance that was asked for.
        tolerance: f64,
        /// The composition with the smallest error.
        composition: &'static str,
        /// That error.
        error: f64,
    },
}
