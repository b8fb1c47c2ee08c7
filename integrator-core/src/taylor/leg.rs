//! The part of a member's way that one polynomial is for.

use super::moment::Moment;
use crate::error::Unsolved;

/// A polynomial's place in time.
#[derive(Clone, Debug, Default)]
pub(super) struct Leg {
    /// When the polynomial begins, from the start of the clock.
    pub(super) begin: Moment,
    /// How far it reaches, with the sign of the step; nothing before it is found.
    pub(super) reach: Option<f64>,
    /// Why there is none behind it.
    pub(super) unsolved: Option<Unsolved>,
}

impl Leg {
    /// Whether the polynomial is not there yet.
    #[inline(always)]
    pub(super) fn is_unknown(&self) -> bool {
        self.reach.is_none() && self.unsolved.is_none()
    }

    /// How far to go on the polynomial to be at `end`; nothing, if it does not reach so far.
    #[inline(always)]
    pub(super) fn ahead(&self, end: Moment) -> Option<f64> {
        let ahead = end.since(self.begin);
        (ahead.abs() <= self.reach.unwrap_or(0.0).abs() || ahead == 0.0).then_some(ahead)
    }

    /// Goes on to the next polynomial, and returns how long this one was; nothing, if the clock, which started at `t0`, does
    /// not notice.
    #[inline(always)]
    pub(super) fn leave(&mut self, t0: f64) -> Option<f64> {
        let reach = self.reach?;
        let (begin, time) = (self.begin.after(reach), t0 + self.begin.nearest());
        if t0 + begin.nearest() == time || !reach.is_finite() {
            self.unsolved = Some(Unsolved::Singular { time, reach });
            return None;
        }
        (self.begin, self.reach) = (begin, None);
        Some(reach)
    }
}
