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
    /// The list of splittings is empty.
    #[error("there is no splitting\nhelp: name at least one system")]
    NoSplitting,
    /// The span is zero or not finite.
    #[error(
        "the span has to be finite and not zero, but it is {span}\nnote: negative spans run backwards",
        span = Number(*span)
    )]
    Span {
        /// The requested span.
        span: f64,
    },
    /// The tolerance is not a positive number.
    #[error("the tolerance has to be positive and finite, but it is {tolerance}", tolerance = Number(*tolerance))]
    Tolerance {
        /// The requested tolerance.
        tolerance: f64,
    },
    /// The Hamiltonian has pieces in time, and no equal steps over the span end at all of their edges.
    #[error(
        "H changes its formula at t = {time}, where no equal steps over a span of {span} end\nhelp: choose a span that \
         is a multiple of the time between the changes\nnote: a step across a change reduces the order",
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
        "no reference solution is known to {tolerance:e} over this span: halving the step changes it by at least \
         {difference:e}\nhelp: choose a shorter span, a larger tolerance, or the energy as the goal"
    )]
    Unfollowed {
        /// The requested tolerance.
        tolerance: f64,
        /// The smallest change between two refinements.
        difference: f64,
    },
    /// No composition reaches the tolerance.
    #[error(
        "no composition reaches {tolerance:e}, and {composition} comes closest with {error:e}\nhelp: use a compensated \
         initial state, a shorter span or a larger tolerance\nnote: below this error, rounding or the length of the span \
         dominates"
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
