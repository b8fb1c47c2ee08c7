//! Progress reports: a long call is made in portions, with a report after each.
//!
//! A portion is a call of `advance`, so that results are bitwise independent of the lengths of portions.

use crate::error::Error;
use alloc::{format, string::String};
use core::{fmt, ops::ControlFlow, time::Duration};
use std::time::Instant;

/// The shortest and the longest duration of a portion: short for a user who waits after a key, long beside a report.
const LEAST: Duration = Duration::from_millis(50);
const MOST: Duration = Duration::from_millis(200);

/// The progress of a call of [`Run::advance_with`](crate::Run::advance_with).
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Progress {
    /// The number of steps done.
    pub done: u64,
    /// The number of steps in the whole call.
    pub steps: u64,
    /// The time since the beginning of the call.
    pub elapsed: Duration,
}

impl Progress {
    /// Returns the fraction of steps done, from 0 to 1.
    pub fn fraction(&self) -> f64 {
        if self.steps == 0 { 1.0 } else { self.done as f64 / self.steps as f64 }
    }

    /// Returns the estimated time for the remaining steps, from the mean time per step; `None` before the first step.
    pub fn remaining(&self) -> Option<Duration> {
        let seconds = self.elapsed.as_secs_f64() * (1.0 - self.fraction()) / self.fraction();
        Duration::try_from_secs_f64(seconds).ok()
    }
}

/// Displays as `37 %, 12 s left`.
impl fmt::Display for Progress {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:.0} %", (100.0 * self.fraction()).floor())?;
        match self.remaining() {
            Some(left) => write!(f, ", {} left", readable(left)),
            None => Ok(()),
        }
    }
}

/// A time in its two largest units.
fn readable(time: Duration) -> String {
    let seconds = time.as_secs_f64().ceil() as u64;
    match seconds {
        0..60 => format!("{seconds} s"),
        60..3600 => format!("{} min {} s", seconds / 60, seconds % 60),
        3600..86_400 => format!("{} h {} min", seconds / 3600, seconds / 60 % 60),
        _ => format!("{} d {} h", seconds / 86_400, seconds / 3600 % 24),
    }
}

/// Takes `steps` steps in portions that begin with `first` of them, until `progress` breaks it off; returns how many were
/// taken.
///
/// # Errors
/// Those of `advance`, which end it.
pub(crate) fn in_portions(
    steps: u64,
    first: u64,
    advance: &mut dyn FnMut(u64) -> Result<(), Error>,
    progress: &mut dyn FnMut(&Progress) -> ControlFlow<()>,
) -> Result<u64, Error> {
    let begin = Instant::now();
    let (mut done, mut portion) = (0, first);
    loop {
        let taken = portion.min(steps - done);
        let before = begin.elapsed();
        advance(taken)?;
        done += taken;
        let elapsed = begin.elapsed();
        if progress(&Progress { done, steps, elapsed }).is_break() || done == steps {
            return Ok(done);
        }
        match elapsed - before {
            quick if quick < LEAST => portion = portion.saturating_mul(2),
            slow if slow > MOST => portion = first.max(portion / 2),
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::{string::ToString, vec::Vec};

    #[test]
    fn the_remaining_time_follows_from_the_progress() {
        let progress = |done, seconds| Progress { done, steps: 1000, elapsed: Duration::from_secs(seconds) };
        assert_eq!(progress(0, 1).to_string(), "0 %");
        assert_eq!(progress(250, 10).to_string(), "25 %, 30 s left");
        assert_eq!(progress(10, 10).to_string(), "1 %, 16 min 30 s left");
        assert_eq!(progress(1, 86_400).to_string(), "0 %, 999 d 0 h left");
        assert_eq!(progress(1000, 10).to_string(), "100 %, 0 s left");
        assert_eq!(Progress { steps: 0, ..progress(0, 1) }.to_string(), "100 %, 0 s left");
    }

    #[test]
    fn portions_grow_and_add_up() {
        let (mut taken, mut told) = (Vec::new(), 0);
        let advance = &mut |steps| {
            taken.push(steps);
            Ok(())
        };
        let all = in_portions(1000, 1, advance, &mut |progress| {
            told = progress.done;
            ControlFlow::Continue(())
        });
        assert_eq!((all, told), (Ok(1000), 1000));
        assert!(taken.iter().sum::<u64>() == 1000 && taken.len() < 100, "{taken:?}");
        let stopped = in_portions(1000, 1, &mut |_| Ok(()), &mut |progress| match progress.done {
            0..100 => ControlFlow::Continue(()),
            _ => ControlFlow::Break(()),
        });
        assert!(stopped.is_ok_and(|done| (100..1000).contains(&done)));
        assert_eq!(in_portions(0, 1, &mut |_| Ok(()), &mut |_| ControlFlow::Continue(())), Ok(0));
        let failed = in_portions(9, 1, &mut |_| Err(Error::SampleInterval), &mut |_| ControlFlow::Continue(()));
        assert_eq!(failed, Err(Error::SampleInterval));
    }
}
