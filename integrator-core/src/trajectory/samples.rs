//! Samples: the states of a run at regular times, which do not change it.

use crate::{
    error::Error,
    state::{
        coords::Coords,
        phase::{Abridged, Phase},
    },
    system::energy::Energies,
    trajectory::{
        crossings::{Crossings, Direction},
        run::Run,
    },
};
use alloc::sync::Arc;
use core::{borrow::BorrowMut, fmt, marker::PhantomData};

/// An iterator over the current state of a run and its states after every `interval` steps.
///
/// Returned by [`Run::samples`] and by [`ByRef::samples`]. Sampling does not change the trajectory. The iterator ends
/// after an error.
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

    /// Returns the run, which is at the last sample.
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

/// An iterator over the states of a run at equal intervals of time.
///
/// Returned by [`Run::samples_at`] and by [`ByRef::samples_at`]. The times are `t + n·interval`, where `t` is the current
/// time; the states are those of [`Run::advance_to`]. Sampling does not change the trajectory. The iterator ends after an
/// error.
#[derive(Clone, Debug)]
pub struct SamplesAt<C: Coords, R = Run<C>> {
    run: R,
    begin: f64,
    interval: f64,
    /// The number of samples taken; `None` after an error.
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

    /// Returns the run, which is at the last sample.
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
    /// Returns an iterator over the current state and the states after every `interval` steps.
    ///
    /// # Errors
    /// An item is an error if [`Run::advance`] fails, or if `interval` is 0.
    pub fn samples(self, interval: u64) -> Samples<C> {
        Samples::new(self.at_step(), interval)
    }

    /// Returns an iterator over the current state and the states after every `interval` of time.
    ///
    /// The states are those of [`Run::advance_to`]. If the step is negative, `interval` is negative.
    ///
    /// # Errors
    /// An item is an error if [`Run::advance_to`] fails. The first item is [`Error::Interval`] if `interval` is not finite
    /// or has another sign than the step.
    pub fn samples_at(self, interval: f64) -> SamplesAt<C> {
        SamplesAt::new(self, interval)
    }

    /// Borrows this run for samples or crossings, so that it can be used after them.
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

/// A run that is borrowed for samples or crossings, returned by [`Run::by_ref`].
#[derive(Debug)]
pub struct ByRef<'r, C: Coords>(&'r mut Run<C>);

impl<'r, C: Coords> ByRef<'r, C> {
    /// Samples like [`Run::samples`]. Afterwards the run is at the last sample.
    pub fn samples(self, interval: u64) -> Samples<C, &'r mut Run<C>> {
        Samples::new(self.at_step(), interval)
    }

    /// Samples like [`Run::samples_at`]. Afterwards the run is at the last sample.
    pub fn samples_at(self, interval: f64) -> SamplesAt<C, &'r mut Run<C>> {
        SamplesAt::new(self.0, interval)
    }

    /// Finds crossings like [`Run::crossings`].
    ///
    /// Afterwards the run is at the end of the last step that was evaluated. This is the end of the step in which the last
    /// returned crossing was found, or the end of all steps if the iterator was exhausted.
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
    /// The time `t0 + n·h`; for a crossing, its time within the step.
    pub time: f64,
    /// The number `n` of whole steps up to this time.
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

    /// Computes the energy `T + V` of this state.
    pub fn energy(&self) -> f64 {
        self.energies.energy(&self.state, self.time)
    }

    /// Computes a conserved quantity of this state, by its name, like [`Run::invariant`].
    ///
    /// # Errors
    /// [`Error::NoInvariant`] if there is none of this name.
    pub fn invariant(&self, name: &str) -> Result<f64, Error> {
        self.energies.invariant_named(name, &self.state)
    }

    /// Computes all conserved quantities of this state; each item is a name and a value.
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
            .field("state", &Abridged(&self.state))
            .finish()
    }
}
