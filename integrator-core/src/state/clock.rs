//! The clock of a run: time as an integer number of steps.

use crate::{
    error::{Divergence, Error},
    scalar::exact::two_sum,
    state::{
        coords::Coords,
        flat::{Flat, flat},
        phase::Phase,
        precision::Precision,
    },
};

/// Time as an integer number of steps: `t0 + n·h`, never an accumulated sum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clock {
    /// The time of step zero.
    pub t0: f64,
    /// The step size.
    pub h: f64,
    /// The number of completed steps.
    pub steps: u64,
}

impl Clock {
    /// Returns the time after this number of steps.
    pub fn at(&self, steps: u64) -> f64 {
        self.t0 + steps as f64 * self.h
    }

    /// The clock that begins at this one's step `opened`.
    pub(crate) fn since(&self, opened: u64) -> Self {
        Self { t0: self.at(opened), h: self.h, steps: self.steps - opened }
    }

    /// Whether one time comes after another on the way of the steps.
    pub(crate) fn is_beyond(&self, time: f64, other: f64) -> bool {
        if self.h < 0.0 { time < other } else { time > other }
    }

    /// The number of steps whose end does not lie beyond a time.
    pub(crate) fn whole_steps_to(&self, time: f64) -> u64 {
        // Conversions saturate; the clock decides about the last steps.
        let mut end = ((time - self.t0) / self.h) as u64;
        while self.is_beyond(self.at(end), time) {
            end -= 1;
        }
        while !self.is_beyond(self.at(end + 1), time) {
            end += 1;
        }
        end
    }

    /// The number of steps after `asked` more.
    ///
    /// # Errors
    /// A clock that did not start at a time, more steps than can be counted, and steps that the clock does not notice.
    pub(crate) fn end(&self, asked: u64) -> Result<u64, Error> {
        self.check()?;
        let end = self.steps.checked_add(asked).ok_or(Error::Steps { done: self.steps, asked })?;
        // Time is coarsest where it is farthest from zero, which is at one end of the steps. An infinite time is found
        // too.
        let ends = if asked == 0 { None } else { Some([self.steps, end]) };
        match ends.into_iter().flatten().map(|steps| self.at(steps)).find(|time| time + self.h == *time) {
            Some(time) => Err(Error::Clock { h: self.h, time }),
            None => Ok(end),
        }
    }

    /// Checks that the clock started at a time.
    pub(crate) fn check(&self) -> Result<(), Error> {
        match self.t0.is_finite() {
            true => Ok(()),
            false => Err(Error::Time { time: self.t0 }),
        }
    }

    /// The report on a trajectory that has taken its last finite step, to `state`; one more leads to `next`.
    pub(crate) fn divergence<C: Coords>(&self, state: &Phase<C>, next: &Phase<C>) -> Divergence {
        let limit = f64::min(lowest_limit(state.q.flat()), lowest_limit(state.p.flat()));
        self.diverged(flat(state), flat(next), limit)
    }

    fn diverged(&self, state: Flat, next: Flat, limit: f64) -> Divergence {
        let step = self.steps.saturating_add(1);
        // The limit of a grid is exclusive, as infinity is.
        let gone = |value: &f64| value.is_nan() || value.abs() >= limit;
        let first = |name, values: &[f64]| Some((name, values.iter().position(gone)?));
        let coordinate = first("q", &next.q).or_else(|| first("p", &next.p));
        Divergence { step, time: self.at(step), limit, coordinate, q: state.q, p: state.p }
    }
}

/// The sum of two durations, each of which is a sum of two numbers.
pub(crate) fn durations([one, its_rest]: [f64; 2], [other, rest]: [f64; 2]) -> [f64; 2] {
    let [sum, lost] = two_sum(one, other);
    [sum, lost + (its_rest + rest)]
}

/// The time so long after `t0`.
pub(crate) fn time_after(t0: f64, duration: [f64; 2]) -> f64 {
    let [sum, rest] = durations([t0, 0.0], duration);
    sum + rest
}

/// The lowest bound that values stay below, in absolute value.
fn lowest_limit<K: Precision>(leaves: &[K]) -> f64 {
    let mut lowest = f64::INFINITY;
    for leaf in leaves {
        lowest = f64::min(lowest, leaf.limit());
    }
    lowest
}
