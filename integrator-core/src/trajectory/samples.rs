//! Samples: the states of a run at regular times, which do not change it.

use crate::{
    error::Error,
    state::{coords::Coords, phase::Phase},
    system::energy::Energies,
    trajectory::run::Run,
};
use alloc::sync::Arc;
use core::fmt;

/// An iterator over the states of a run at its start and then after every so many steps. Made by [`Run::samples`].
///
/// Sampling completes the step under way on a copy, so the trajectory is the one that `advance` alone would take.
/// After an error the iterator ends.
#[derive(Clone, Debug)]
pub struct Samples<C: Coords> {
    run: Run<C>,
    interval: u64,
    next: Next,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Next {
    Present,
    Later,
    Nothing,
}

impl<C: Coords> Samples<C> {
    pub(crate) fn new(run: Run<C>, interval: u64) -> Self {
        Self { run, interval, next: Next::Present }
    }

    /// The run, where the last sample left it.
    pub fn into_run(self) -> Run<C> {
        self.run
    }
}

impl<C: Coords> Iterator for Samples<C> {
    type Item = Result<Sample<C>, Error>;

    fn next(&mut self) -> Option<Self::Item> {
        let outcome = match self.next {
            Next::Nothing => return None,
            _ if self.interval == 0 => Err(Error::SampleInterval),
            Next::Present => self.run.check_clock(),
            Next::Later => self.run.advance(self.interval),
        };
        self.next = if outcome.is_ok() { Next::Later } else { Next::Nothing };
        Some(outcome.map(|()| Sample::new(&self.run, self.run.time(), self.run.steps(), self.run.state())))
    }
}

/// An iterator over the states of a run at equal intervals of time. Made by [`Run::samples_at`].
///
/// Times are `t + n·interval` from the present one on, and states those of [`Run::advance_to`], so that the trajectory is the
/// one that `advance` alone would take. After an error the iterator ends.
#[derive(Clone, Debug)]
pub struct SamplesAt<C: Coords> {
    run: Run<C>,
    begin: f64,
    interval: f64,
    /// How many samples were taken; nothing after an error.
    taken: Option<u64>,
}

impl<C: Coords> SamplesAt<C> {
    pub(crate) fn new(run: Run<C>, interval: f64) -> Self {
        Self { begin: run.time(), run, interval, taken: Some(0) }
    }

    /// The run, where the last sample left it.
    pub fn into_run(self) -> Run<C> {
        self.run
    }
}

impl<C: Coords> Iterator for SamplesAt<C> {
    type Item = Result<Sample<C>, Error>;

    fn next(&mut self) -> Option<Self::Item> {
        let taken = self.taken.take()?;
        let time = self.begin + taken as f64 * self.interval;
        let outcome = match taken {
            _ if self.interval == 0.0 => Err(Error::SampleInterval),
            0 => self.run.check_clock(),
            _ => self.run.advance_to(time),
        };
        if outcome.is_ok() {
            self.taken = taken.checked_add(1);
        }
        Some(outcome.map(|()| Sample::new(&self.run, time, self.run.steps(), self.run.state())))
    }
}

/// The state of a run at one time.
#[derive(Clone)]
pub struct Sample<C: Coords> {
    /// The time, `t0 + n·h`; of a crossing, the time within the step that led through it.
    pub time: f64,
    /// The number of whole steps up to there, `n`.
    pub step: u64,
    /// Positions and momenta.
    pub state: Phase<C>,
    energies: Arc<dyn Energies<C>>,
}

impl<C: Coords> Sample<C> {
    pub(crate) fn new(run: &Run<C>, time: f64, step: u64, state: Phase<C>) -> Self {
        Self { time, step, state, energies: run.energies() }
    }

    /// A sample of a member of an ensemble.
    #[cfg(feature = "std")]
    pub(crate) fn of_member(state: Phase<C>, time: f64, step: u64, energies: Arc<dyn Energies<C>>) -> Self {
        Self { time, step, state, energies }
    }

    /// The energy `T + V` of this state, computed when asked for.
    pub fn energy(&self) -> f64 {
        self.energies.energy(&self.state, self.time)
    }

    /// A function of this state that the system says is conserved, by its name, computed when asked for:
    /// [`Run::invariant`].
    ///
    /// # Errors
    /// [`Error::NoInvariant`]
    pub fn invariant(&self, name: &str) -> Result<f64, Error> {
        self.energies.invariant_named(name, &self.state)
    }

    /// The names of all of these, with their values in this state.
    pub fn invariants(&self) -> impl Iterator<Item = (&'static str, f64)> {
        (0..)
            .zip(self.energies.invariants())
            .map(|(number, name)| (*name, self.energies.invariant(number, &self.state)))
    }
}

impl<C: Coords> fmt::Debug for Sample<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Sample")
            .field("time", &self.time)
            .field("step", &self.step)
            .field("state", &self.state)
            .finish()
    }
}
