//! Why a check could not be carried out.

use crate::error::{Error, Number, debug_as_display};

debug_as_display!(CheckError);

/// The reason why a check has no result. A wrong stepper is not an error: the result of the check shows it.
#[derive(Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CheckError {
    /// The run of the check failed.
    #[error(transparent)]
    Run(#[from] Error),
    /// Too few step sizes have an error above the rounding, so that no slope can be fitted.
    #[error(
        "only {found} step sizes from {coarsest:.1e} down have an error above the rounding, but a fit requires \
         {needed}\nhelp: choose another initial state\nnote: the motion is too small, or so simple that every step is \
         exact"
    )]
    TooFewPoints {
        /// The number of usable step sizes.
        found: usize,
        /// The number that is needed.
        needed: usize,
        /// The coarsest step size that was tried.
        coarsest: f64,
    },
    /// Halving the step changes the result by more than a tenth of the motion, however short the time.
    #[error(
        "no step size down to {finest} resolves the motion from this initial state\nnote: the motion is singular, or the \
         flows do not belong to one Hamiltonian",
        finest = Number(*finest)
    )]
    NotSmooth {
        /// The finest step size that was tried.
        finest: f64,
    },
    /// A condition on the time changes inside of a step.
    #[error(
        "H changes its formula at t = {time}, within a step of {h}, which reduces the order\nhelp: choose a step that \
         ends at this time",
        time = Number(*time), h = Number(*h)
    )]
    EdgeInside {
        /// The time at which the formula changes.
        time: f64,
        /// The step.
        h: f64,
    },
    /// The method chooses its own steps, so that its errors have no order.
    #[error("{method} chooses its own steps, so its errors follow a tolerance and have no order")]
    NoOrder {
        /// The name of the method.
        method: &'static str,
    },
    /// Deviation vectors grow beyond the root of the largest number, so that eigenvalues cannot be computed.
    #[error("deviation vectors grow by more than 1e150 within {steps} steps\nhelp: choose a shorter period")]
    Growth {
        /// The number of steps of the period.
        steps: u64,
    },
    /// A measured quantity is NaN where the motion is finite.
    #[error("{what} is NaN, although the energies are finite\nnote: the energies have no finite derivatives there")]
    NotFinite {
        /// The name of the quantity.
        what: &'static str,
    },
    /// The Hamiltonian depends on time, so its energy is not conserved.
    #[error("H depends on time, so its energy is not conserved and does not test the stepper")]
    NotAutonomous,
    /// The measurement requires `T(p) + V(q)`, and the Hamiltonian is split into other parts.
    #[error("{what} is available for H = T(p) + V(q) only, and this H is split into other parts")]
    NotSeparable {
        /// The name of the measurement.
        what: &'static str,
    },
    /// The derivatives of an energy by dual numbers and by central differences differ: it has a kink or a jump here.
    #[error(
        "{energy} has a kink or a jump here: its derivative by coordinate {index} is {dual:.4e} by dual numbers, but \
         {difference:.4e} ± {uncertainty:.1e} by central differences"
    )]
    NotDifferentiable {
        /// `T` or `V`.
        energy: &'static str,
        /// The index of the coordinate, counted over the flattened `p` or `q`.
        index: usize,
        /// The derivative by dual numbers.
        dual: f64,
        /// The derivative by central differences.
        difference: f64,
        /// A bound on truncation and rounding of the latter.
        uncertainty: f64,
    },
    /// The gradient of an invariant is zero at a state of the orbit.
    #[error(
        "the gradient of the invariant `{name}` is zero at a state of the orbit, so its conservation cannot be tested"
    )]
    ConstantInvariant {
        /// The name of the function.
        name: &'static str,
    },
    /// The generated code could not be compared with the user's functions at any state.
    #[error(
        "none of {left_out} comparisons with your own functions was possible\nnote: they have kinks, jumps or no finite \
         value at all sampled states of the orbit"
    )]
    NothingToCompare {
        /// The number of states that were tried.
        left_out: usize,
    },
    /// The requested coordinate does not exist.
    #[error("there is no coordinate {index}: the system has {coordinates}, counted from 0")]
    NoCoordinate {
        /// The index of the coordinate.
        index: usize,
        /// The number of coordinates.
        coordinates: usize,
    },
    /// The run is too short for the measurement.
    #[error("{steps} steps are too few for a measurement, which requires at least {needed}")]
    TooFewSteps {
        /// The number of steps of the run.
        steps: u64,
        /// The number that is needed.
        needed: u64,
    },
    /// There are too few samples for a frequency analysis with a window of this order.
    #[error("{samples} samples are too few for a frequency analysis, which requires at least {needed}")]
    TooFewSamples {
        /// The number of samples.
        samples: usize,
        /// The number that is needed.
        needed: usize,
    },
    /// A sample of a frequency analysis is not finite.
    #[error("sample {index} of the frequency analysis is not finite")]
    SampleNotFinite {
        /// The index of the first such sample, counted from 0.
        index: usize,
    },
    /// The interval between samples is not positive, or so extreme that frequencies are not finite.
    #[error(
        "the interval between samples is {interval}, but a frequency analysis requires a positive and finite time\nhelp: \
         reverse the order of samples that go back in time",
        interval = Number(*interval)
    )]
    SampleTime {
        /// The interval.
        interval: f64,
    },
    /// The steps have unequal lengths in time, so that samples after equal numbers of steps have unequal intervals.
    #[error(
        "a sample is at t = {time}, but equal steps lead to t = {expected}\nhelp: take samples at equal times with \
         `samples_at`\nnote: the method advances a fictitious time, and a frequency analysis requires equal intervals",
        time = Number(*time), expected = Number(*expected)
    )]
    UnequalSteps {
        /// The time of the sample.
        time: f64,
        /// The time after as many equal steps.
        expected: f64,
    },
    /// The growths of deviation vectors within one step differ by more than the precision.
    #[error(
        "within one step of {step}, deviation vectors grow differently by a factor of {factor:.1e}, which exceeds the \
         precision\nhelp: use a step of at most {shorter:.2e}\nnote: the smaller exponents are lost to rounding",
        step = Number(*step)
    )]
    LongForExponents {
        /// The step.
        step: f64,
        /// The ratio of the growth of the most and the least stretched direction, as far as digits show it.
        factor: f64,
        /// A step that is short enough for the precision.
        shorter: f64,
    },
    /// The exact motion is not known well enough to compare a run with it.
    #[error(
        "over a time of {span}, the exact motion is known only to {uncertainty} of its size\nhelp: choose a shorter \
         time, or write `#[hamiltonian(taylor)]`, which gives a better reference\nnote: the motion leads into a \
         singularity, or the time is too long",
        span = Number(*span), uncertainty = Number(*uncertainty)
    )]
    NoReference {
        /// The time.
        span: f64,
        /// The distance of two references, in units of the excursion of the motion; NaN if one of them diverges.
        uncertainty: f64,
    },
}
