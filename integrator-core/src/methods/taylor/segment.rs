//! Segments of a member's trajectory, one for each polynomial.

use super::time::Time;
use crate::{
    error::Unsolved,
    scalar::{
        exact::{exponent, power_of_two},
        real::Real,
    },
    system::counts::OwnSteps,
};
use core::mem::take;

/// The segment of a trajectory that one polynomial covers.
#[derive(Clone, Debug, Default)]
pub(super) struct Segment {
    /// The time of the polynomial's expansion, from the start of the clock.
    pub(super) origin: Time,
    /// The exponent of the unit of time of the polynomial's coefficients, a power of two near the step; `None` before the
    /// first polynomial.
    pub(super) exponent: Option<i32>,
    /// The step that the tolerance allows, with the sign of the run's; `None` before the polynomial is expanded.
    pub(super) step: Option<f64>,
    /// The duration up to which the polynomial crosses no edge.
    pub(super) free: f64,
    /// Whether the step ends at an edge of the state, and not of the time alone.
    pub(super) ends_at_edge: bool,
    /// Whether the polynomial is cut after its first order, because higher coefficients are not finite.
    pub(super) is_linear: bool,
    /// The number of consecutive polynomials, without the present one, that are cut in this way.
    pub(super) linear_steps: u8,
    /// The fault that keeps the motion from going on.
    pub(super) unsolved: Option<Unsolved>,
    /// The steps of the member so far.
    pub(super) steps: OwnSteps,
}

/// The most binary digits between a unit of time and the step, and between a unit and one: coefficients of order 28 are
/// normal numbers in units so near, and so are squares of units.
#[inline(always)]
pub(super) fn digits<R: Real>() -> [i32; 2] {
    if R::of(1e300).lane(0).is_finite() { [20, 500] } else { [3, 60] }
}

/// The progress of a member on its polynomial.
#[derive(Clone, Copy)]
pub(super) enum Progress {
    /// The member arrives after this duration.
    Arrives(f64),
    /// The member goes to the end of the segment, after this duration, and takes the next one from there.
    NextSegment(f64),
    /// The member has stopped at a fault.
    Stopped,
}

impl Segment {
    /// Whether the polynomial has to be expanded.
    #[inline(always)]
    pub(super) fn is_unexpanded(&self) -> bool {
        self.step.is_none() && self.unsolved.is_none()
    }

    /// The unit of time of the polynomial, in a run with steps of `h`.
    #[inline(always)]
    pub(super) fn unit<R: Real>(&self, h: f64) -> f64 {
        let [_, most] = digits::<R>();
        power_of_two(self.exponent.unwrap_or_else(|| exponent(h.abs())).clamp(-most, most))
    }

    /// Proceeds towards `end` on this polynomial, or to the next segment, by a clock that started at `t0`. At edges, steps may
    /// be too short for the nearest number of the clock, though not for its two numbers.
    #[inline(always)]
    pub(super) fn proceed(&mut self, step: f64, end: Time, t0: f64, has_edges: bool) -> Progress {
        if self.unsolved.is_some() {
            return Progress::Stopped;
        }
        let ahead = end.since(self.origin);
        if ahead.abs() <= step.abs() || ahead == 0.0 {
            return Progress::Arrives(ahead);
        }
        let (origin, time) = (self.origin.after(step), t0 + self.origin.nearest());
        let is_still = if has_edges { origin == self.origin } else { t0 + origin.nearest() == time };
        if is_still || !step.is_finite() {
            // The step is too short to change the time, or not finite.
            self.unsolved = Some(Unsolved::Singular { time, reach: step });
            return Progress::Stopped;
        }
        (self.origin, self.step, self.free) = (origin, None, 0.0);
        self.linear_steps = if take(&mut self.is_linear) { self.linear_steps + 1 } else { 0 };
        self.exponent = Some(exponent(step.abs()));
        self.steps.take(step);
        Progress::NextSegment(step)
    }
}
