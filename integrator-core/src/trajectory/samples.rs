//! Samples: the states of a run at regular times, which do not change it.

use crate::{
    error::Error,
    state::{coords::Coords, phase::Phase},
    system::energy::Energies,
    trajectory::{
        crossings::{Crossings, Direction},
        run::Run,
    },
};
use alloc::sync::Arc;
use core::{borrow::BorrowMut, fmt, marker::PhantomData};

/// An iterator over the states of a run at its start and then after every so many steps. Made by [`Run::samples`], or from a
/// run that is lent by [`Run::by_ref`].
///
/// Sampling completes the step under way on a copy, so the trajectory is the one that `advance` alone would take.
/// After an error the iterator ends.
#[derive(Clone, Debug)]
pub struct Samples<C: Coords, R = Run<C>> {
    run: R,
    interval: u64,
    next: Next,
    shape: PhantomData<C>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Next {
    Present,
    Later,
    Nothing,
}

impl<C: Coords, R: BorrowMut<Run<C>>> Samples<C, R> {
    fn new(run: R, interval: u64) -> Self {
        Self { run, interval, next: Next::Present, shape: PhantomData }
    }

    /// The run, where the last sample left it.
    pub fn into_run(self) -> R {
        self.run
    }
}

impl<C: Coords, R: BorrowMut<Run<C>>> Iterator for Samples<C, R> {
    type Item = Result<Sample<C>, Error>;

    fn next(&mut self) -> Option<Self::Item> {
        let run = self.run.borrow_mut();
        let outcome = match self.next {
            Next::Nothing => return None,
            _ if self.interval == 0 => Err(Error::SampleInterval),
            Next::Present => run.check_clock(),
            Next::Later => run.advance(self.interval),
        };
        self.next = if outcome.is_ok() { Next::Later } else { Next::Nothing };
        Some(outcome.map(|()| Sample::new(run, run.time(), run.steps(), run.state())))
    }
}

/// An iterator over the states of a run at equal intervals of time. Made by [`Run::samples_at`].
///
/// Times are `t + n·interval` from the present one on, and states those of [`Run::advance_to`], so that the trajectory is the
/// one that `advance` alone would take. After an error the iterator ends.
#[derive(Clone, Debug)]
pub struct SamplesAt<C: Coords, R = Run<C>> {
    run: R,
    begin: f64,
    interval: f64,
    /// How many samples were taken; nothing after an error.
    taken: Option<u64>,
    shape: PhantomData<C>,
}

impl<C: Coords, R: BorrowMut<Run<C>>> SamplesAt<C, R> {
    fn new(run: R, interval: f64) -> Self {
        Self { begin: run.borrow().time(), run, interval, taken: Some(0), shape: PhantomData }
    }

    /// Whether times at this interval are finite and lie where steps of `h` lead.
    fn leads_along(&self, h: f64) -> bool {
        self.interval.is_finite() && (self.interval < 0.0) == (h < 0.0)
    }

    /// The run, where the last sample left it.
    pub fn into_run(self) -> R {
        self.run
    }
}

impl<C: Coords, R: BorrowMut<Run<C>>> Iterator for SamplesAt<C, R> {
    type Item = Result<Sample<C>, Error>;

    fn next(&mut self) -> Option<Self::Item> {
        let taken = self.taken.take()?;
        let time = if taken == 0 { self.begin } else { self.begin + taken as f64 * self.interval };
        let leads_along = self.leads_along(self.run.borrow().step());
        let run = self.run.borrow_mut();
        let outcome = match taken {
            _ if self.interval == 0.0 => Err(Error::SampleInterval),
            0 if !leads_along => Err(Error::Interval { interval: self.interval, h: run.step() }),
            _ if !time.is_finite() => Err(Error::Time { time }),
            0 => run.check_clock(),
            _ => run.advance_to(time),
        };
        if outcome.is_ok() {
            self.taken = taken.checked_add(1);
        }
        Some(outcome.map(|()| Sample::new(run, time, run.steps(), run.state())))
    }
}

impl<C: Coords> Run<C> {
    /// An iterator over the present state and then the state after every `interval` steps.
    pub fn samples(self, interval: u64) -> Samples<C> {
        Samples::new(self.at_step(), interval)
    }

    /// An iterator over the states at the present time and then after every `interval` of time, each as
    /// [`Run::advance_to`] gives it. The interval of a run with negative steps is negative.
    ///
    /// # Errors
    /// Items are errors where [`Run::advance_to`] has one; the first one is [`Error::Interval`] for an interval that is not finite or
    /// leads against the steps.
    pub fn samples_at(self, interval: f64) -> SamplesAt<C> {
        SamplesAt::new(self, interval)
    }

    /// This run for samples or crossings that only borrow it, so that it goes on behind them.
    ///
    /// ```
    /// use integrator_core::prelude::*;
    ///
    /// struct Oscillator;
    ///
    /// #[hamiltonian]
    /// impl Oscillator {
    ///     fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] / 2.0 }
    ///     fn potential(&self, q: [f64; 1]) -> f64 { q[0] * q[0] / 2.0 }
    /// }
    ///
    /// let mut run = Oscillator.run(Phase::new([1.0], [0.0]), 0.01)?;
    /// for sample in run.by_ref().samples(100).take(11) {
    ///     println!("{:?}", sample?);
    /// }
    /// assert_eq!(run.steps(), 1_000);
    /// let turn = run.by_ref().crossings(1_000, Direction::Either, |state, _| state.p[0]).next();
    /// assert!(turn.is_some());
    /// run.advance(1_000)?;
    /// # Ok::<(), Error>(())
    /// ```
    pub fn by_ref(&mut self) -> ByRef<'_, C> {
        ByRef(self)
    }
}

/// A run that is lent to samples or crossings. Made by [`Run::by_ref`].
#[derive(Debug)]
pub struct ByRef<'r, C: Coords>(&'r mut Run<C>);

impl<'r, C: Coords> ByRef<'r, C> {
    /// As [`Run::samples`]. The run is where the last sample left it.
    pub fn samples(self, interval: u64) -> Samples<C, &'r mut Run<C>> {
        Samples::new(self.at_step(), interval)
    }

    /// As [`Run::samples_at`]. The run is where the last sample left it.
    pub fn samples_at(self, interval: f64) -> SamplesAt<C, &'r mut Run<C>> {
        SamplesAt::new(self.0, interval)
    }

    /// As [`Run::crossings`]. The run is after the last step that was evaluated: that behind the last crossing which was
    /// taken, and after all the steps where there was no other.
    pub fn crossings<G>(self, steps: u64, direction: Direction, function: G) -> Crossings<C, G, &'r mut Run<C>>
    where
        G: FnMut(&Phase<C>, f64) -> f64,
    {
        Crossings::new(self.at_step(), steps, direction, function)
    }

    /// The run, shown at the end of its last step.
    fn at_step(self) -> &'r mut Run<C> {
        self.0.show_step();
        self.0
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
