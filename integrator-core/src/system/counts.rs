//! What a motion counts of its steps.

use crate::error::Number;
use core::fmt;

/// The steps that a method takes by itself, whatever the step of the run is. Displays how many are completed and how long they
/// are.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct OwnSteps {
    /// Number of completed steps.
    pub taken: u64,
    /// The length of the shortest completed step, infinite before the first one.
    pub shortest: f64,
    /// The length of the longest completed step, zero before the first one.
    pub longest: f64,
    /// The length of the current step, infinite where its polynomial is the motion at all times; `None` where no
    /// polynomial is expanded yet.
    pub under_way: Option<f64>,
}

impl Default for OwnSteps {
    fn default() -> Self {
        Self { taken: 0, shortest: f64::INFINITY, longest: 0.0, under_way: None }
    }
}

impl fmt::Display for OwnSteps {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { taken, shortest, longest, under_way } = *self;
        match taken {
            0 => write!(f, "no step completed")?,
            1 => write!(f, "1 step of {}", Number(longest))?,
            _ => write!(f, "{taken} steps of {} to {}", Number(shortest), Number(longest))?,
        }
        match under_way {
            None => Ok(()),
            Some(f64::INFINITY) => write!(f, ", the current polynomial is valid at all times"),
            Some(length) => write!(f, ", the current one is {}", Number(length)),
        }
    }
}

impl OwnSteps {
    /// Counts a step of this length, of any sign.
    #[inline(always)]
    pub(crate) fn take(&mut self, step: f64) {
        let length = step.abs();
        self.taken += 1;
        self.shortest = if length < self.shortest { length } else { self.shortest };
        self.longest = if length > self.longest { length } else { self.longest };
    }
}

/// The counters of a motion since it was loaded.
#[derive(Clone, Copy, Debug, Default)]
pub struct Counts {
    /// The evaluations of the force.
    pub(crate) evaluations: u64,
    /// The steps of its own, where it takes such.
    pub(crate) own_steps: Option<OwnSteps>,
}

impl Counts {
    /// Counters of a motion whose steps are the run's.
    pub fn of_evaluations(evaluations: u64) -> Self {
        Self { evaluations, own_steps: None }
    }

    /// Returns the sums of these counters and later ones.
    pub(crate) fn and(self, later: Self) -> Self {
        let both = |a: OwnSteps, b: OwnSteps| OwnSteps {
            taken: a.taken.saturating_add(b.taken),
            shortest: a.shortest.min(b.shortest),
            longest: a.longest.max(b.longest),
            under_way: b.under_way,
        };
        let own_steps = match (self.own_steps, later.own_steps) {
            (Some(a), Some(b)) => Some(both(a, b)),
            (a, b) => a.or(b),
        };
        Self { evaluations: self.evaluations.saturating_add(later.evaluations), own_steps }
    }
}
