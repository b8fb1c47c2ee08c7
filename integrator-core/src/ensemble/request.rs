//! A request to advance an ensemble: how many steps its members take, and which of them leave before.

use crate::{
    error::{Divergence, Error, Lost},
    state::{clock::Clock, point::Point},
    trajectory::{engine::BLOCK, panics::Panics},
};

/// The request of a call of [`Ensemble::advance_while`](crate::Ensemble::advance_while) to every batch.
pub(crate) struct AdvanceRequest<'a> {
    /// The clock that the steps begin at.
    pub(crate) clock: Clock,
    /// The number of steps to take.
    pub(crate) steps: u64,
    /// The number of steps after which each member is tested whether it continues.
    pub(crate) interval: u64,
    /// Whether the member with this index continues from this state.
    pub(crate) stays: &'a (dyn Fn(usize, &dyn Point) -> bool + Sync),
    /// The test of a watch, if there is one: returns the error of a member that may not continue from a state after
    /// a number of steps.
    pub(crate) strays: Option<&'a Strays<'a>>,
    /// Panics of the user's functions: a member in whose step one panics stays at the step before, and all others go
    /// on.
    pub(crate) panics: &'a Panics,
}

/// The error of a member in a state after a step at a time, if its energy has strayed.
pub(crate) type Strays<'a> = dyn Fn(usize, &dyn Point, u64, f64) -> Option<Error> + Sync + 'a;

/// The members that did not take all steps of a request, but for those that left.
#[derive(Default)]
pub(crate) struct Ended {
    pub(crate) lost: Vec<(usize, Divergence)>,
    pub(crate) strayed: Vec<(usize, Error)>,
}

impl Ended {
    pub(crate) fn extend(&mut self, other: Self) {
        self.lost.extend(other.lost);
        self.strayed.extend(other.strayed);
    }

    /// The error that lists these members in ascending order, if there are any.
    pub(crate) fn outcome(self) -> Result<(), Error> {
        let Self { mut lost, mut strayed } = self;
        if !strayed.is_empty() {
            strayed.extend(lost.into_iter().map(|(member, divergence)| (member, divergence.into())));
            strayed.sort_unstable_by_key(|(member, _)| *member);
            return Err(Error::Strayed { members: strayed });
        }
        lost.sort_unstable_by_key(|(member, _)| *member);
        if lost.is_empty() { Ok(()) } else { Err(Error::Lost(Lost { members: lost })) }
    }
}

impl AdvanceRequest<'_> {
    /// The length of the block of steps after the first `done` ones.
    pub(crate) fn block(&self, done: u64) -> u64 {
        if self.strays.is_some() {
            return 1;
        }
        let to_next_test = self.interval - done % self.interval;
        BLOCK.min(self.steps - done).min(to_next_test)
    }

    /// Whether members are tested after `done` steps.
    pub(crate) fn tests_after(&self, done: u64) -> bool {
        done.is_multiple_of(self.interval)
    }

    /// Whether a member continues from this state; not if the test panics.
    pub(crate) fn stays(&self, member: usize, state: &dyn Point) -> bool {
        self.panics.attempt(|| (self.stays)(member, state)).unwrap_or(false)
    }

    /// The clock after `done` steps.
    pub(crate) fn clock_after(&self, done: u64) -> Clock {
        Clock { steps: self.clock.steps + done, ..self.clock }
    }
}
