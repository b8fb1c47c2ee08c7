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

/// How far a member goes on its polynomial.
#[derive(Clone, Copy)]
pub(super) enum Way {
    /// So far that it is where it should be.
    Within(f64),
    /// To where the next polynomial begins.
    Over(f64),
    /// No way leads on.
    Ended,
}

impl Leg {
    /// Whether the polynomial is not there yet.
    #[inline(always)]
    pub(super) fn is_unknown(&self) -> bool {
        self.reach.is_none() && self.unsolved.is_none()
    }

    /// Goes on the way to `end`, on this polynomial or to where the next one begins, by a clock that started at `t0`.
    #[inline(always)]
    pub(super) fn proceed(&mut self, reach: f64, end: Moment, t0: f64) -> Way {
        if self.unsolved.is_some() {
            return Way::Ended;
        }
        let ahead = end.since(self.begin);
        if ahead.abs() <= reach.abs() || ahead == 0.0 {
            return Way::Within(ahead);
        }
        let (begin, time) = (self.begin.after(reach), t0 + self.begin.nearest());
        if t0 + begin.nearest() == time || !reach.is_finite() {
            // The clock does not notice.
            self.unsolved = Some(Unsolved::Singular { time, reach });
            return Way::Ended;
        }
        (self.begin, self.reach) = (begin, None);
        Way::Over(reach)
    }
}
