//! The members of an ensemble, whatever they are: dealt out to batches that threads take in turns.

#[cfg(feature = "checkpoint")]
use crate::{ensemble::batch::Finished, trajectory::motions::Form};
use crate::{
    ensemble::{
        batch::{Batch, States},
        between::Between,
        energies::EnergiesOfMembers,
        request::{AdvanceRequest, Ended},
    },
    error::Error,
    state::{clock::Clock, point::Point},
    threads::{all_threads, on_threads},
    trajectory::{motions::Draws, panics::Panics, watch::Watch},
};
use std::sync::{Arc, Mutex, PoisonError};

/// From how many updates of a coordinate on, all members together, other threads are started: that takes some ten
/// microseconds each, in which one thread does about this number.
const WORTH_A_THREAD: u64 = 1 << 17;

/// All members of an ensemble.
pub(crate) struct Members {
    pub(super) batches: Vec<Batch>,
    pub(crate) energies: Arc<dyn EnergiesOfMembers>,
    count: usize,
    /// The number of coordinates of all members together.
    coordinates: u64,
    pub(crate) clock: Clock,
    /// Whether the energies of the starts are still to be checked, where they depend on the time that the clock starts
    /// at.
    starts_unchecked: bool,
    /// The states between steps, if the ensemble shows a time between the common steps.
    pub(super) between: Option<Between>,
    /// A bound on the energy of each member.
    pub(super) watches: Option<Vec<Watch>>,
    pub(crate) threads: usize,
}

impl Members {
    pub(crate) fn new(
        batches: Vec<Batch>,
        energies: Arc<dyn EnergiesOfMembers>,
        count: usize,
        coordinates: u64,
        h: f64,
    ) -> Self {
        let clock = Clock { t0: 0.0, h, steps: 0 };
        Self {
            batches,
            energies,
            count,
            coordinates,
            clock,
            starts_unchecked: true,
            between: None,
            watches: None,
            threads: all_threads(),
        }
    }

    /// Changes what random numbers depend on.
    pub(crate) fn change_draws(&mut self, change: &dyn Fn(&mut Draws)) {
        self.batches.iter_mut().for_each(|batch| batch.change_draws(change));
    }

    /// The seed of random numbers.
    #[cfg(feature = "checkpoint")]
    pub(crate) fn seed(&self) -> u64 {
        self.batches.first().map_or(0, Batch::seed)
    }

    /// Checks the energies of the starts, once.
    ///
    /// # Errors
    /// [`Error::Member`] naming the first member whose energy is not finite.
    pub(crate) fn check_starts(&mut self) -> Result<(), Error> {
        if self.starts_unchecked {
            let (time, mut outcome) = (self.time_at_step(), Ok(()));
            for batch in &self.batches {
                batch.states(self.clock, &mut |member, state| {
                    if outcome.is_ok() {
                        outcome = self.admissible(member, state, time);
                    }
                });
            }
            outcome?;
            self.starts_unchecked = false;
        }
        Ok(())
    }

    /// The energies of the starts were checked one by one.
    pub(crate) fn starts_are_checked(&mut self) {
        self.starts_unchecked = false;
    }

    /// Whether a member has an energy in a state.
    ///
    /// # Errors
    /// [`Error::Member`]
    fn admissible(&self, member: usize, state: &dyn Point, time: f64) -> Result<(), Error> {
        self.energies.parts(member, state, time).admissible(time).map_err(of_member(member))
    }

    /// Whether a member may continue from a state that was changed from outside.
    ///
    /// # Errors
    /// [`Error::Member`], if it has no energy.
    pub(crate) fn changed(&self, member: usize, state: &dyn Point) -> Result<(), Error> {
        // Where the starts are unchecked, their time is not settled.
        if self.starts_unchecked { Ok(()) } else { self.admissible(member, state, self.time_at_step()) }
    }

    /// Sets the states from which the active members continue.
    pub(crate) fn restart(&mut self, states: &States) {
        self.between = None;
        for batch in &mut self.batches {
            batch.restart(states, self.clock);
        }
    }

    /// Returns the number of steps after which the states were last changed from outside.
    #[cfg(feature = "checkpoint")]
    pub(crate) fn opened(&self) -> u64 {
        self.batches.first().map_or(0, Batch::opened)
    }

    /// Shows all members, in their order: those in progress in the middle of the step.
    #[cfg(feature = "checkpoint")]
    pub(crate) fn unfinished(&self, visit: &mut dyn FnMut(Option<Finished>, &dyn Point)) {
        let form = Form::after(self.clock.steps - self.opened());
        for batch in &self.batches {
            batch.unfinished(form, visit);
        }
    }

    /// Continues from what [`Members::unfinished`] has shown.
    #[cfg(feature = "checkpoint")]
    pub(crate) fn resume(
        &mut self,
        clock: Clock,
        opened: u64,
        states: &States,
        finished: &dyn Fn(usize) -> Option<Finished>,
    ) {
        self.clock = clock;
        self.starts_unchecked = false;
        for batch in &mut self.batches {
            batch.resume(Form::after(clock.steps - opened), opened, states, finished);
        }
    }

    /// Takes steps with every member that is in progress; after every `interval` of them, each is tested whether it
    /// stays.
    ///
    /// # Errors
    /// As [`Ensemble::advance`](crate::Ensemble::advance).
    pub(crate) fn advance(
        &mut self,
        steps: u64,
        interval: u64,
        stays: &(dyn Fn(usize, &dyn Point) -> bool + Sync),
    ) -> Result<(), Error> {
        if interval == 0 {
            return Err(Error::SampleInterval);
        }
        let end = self.clock.end(steps)?;
        self.check_starts()?;
        self.between = None;
        let panics = Panics::default();
        let (watches, energies) = (self.watches.take(), self.energies.clone());
        let strays = watches.as_ref().map(|watches| {
            move |member: usize, state: &dyn Point, step: u64, time: f64| {
                watches[member].strayed(energies.parts(member, state, time).total, step, time)
            }
        });
        let strays = strays.as_ref().map(|strays| strays as &_);
        let request = AdvanceRequest { clock: self.clock, steps, interval, stays, strays, panics: &panics };
        let ended = self.advance_batches(&request);
        self.watches = watches;
        self.clock.steps = end;
        panics.resume();
        ended.outcome()
    }

    /// Advances all batches, on as many threads as are worthwhile, and returns the members that do not continue.
    fn advance_batches(&mut self, request: &AdvanceRequest) -> Ended {
        let threads = self.threads_for(request.steps).min(self.batches.len());
        // Whoever is free takes the next batch; no result depends on who that is.
        let batches = Mutex::new(self.batches.iter_mut());
        let next = || batches.lock().unwrap_or_else(PoisonError::into_inner).next();
        let ended = Mutex::new(Ended::default());
        on_threads(threads, &|| {
            while let Some(batch) = next() {
                let of_batch = batch.advance(request);
                ended.lock().unwrap_or_else(PoisonError::into_inner).extend(of_batch);
            }
        });
        ended.into_inner().unwrap_or_else(PoisonError::into_inner)
    }

    /// Returns the number of threads that pay off for this number of steps of all members.
    pub(super) fn threads_for(&self, steps: u64) -> usize {
        if self.coordinates.saturating_mul(steps) < WORTH_A_THREAD { 1 } else { self.threads }
    }

    pub(crate) fn count(&self) -> usize {
        self.count
    }

    pub(crate) fn active(&self) -> usize {
        self.batches.iter().map(|batch| batch.active()).sum()
    }

    /// The time of the steps of all.
    pub(super) fn time_at_step(&self) -> f64 {
        self.clock.at(self.clock.steps)
    }

    /// The time that is shown.
    pub(crate) fn time(&self) -> f64 {
        self.between.as_ref().map_or(self.time_at_step(), |between| between.time)
    }

    /// Returns the time and the state of a member that is shown between its steps.
    fn shown(&self, member: usize) -> Option<(f64, &dyn Point)> {
        let between = self.between.as_ref()?;
        Some((between.time, between.state(member)?))
    }

    /// The members that are neither failed nor finished.
    pub(crate) fn under_way(&self) -> Vec<usize> {
        let mut members = Vec::with_capacity(self.count);
        for (number, batch) in self.batches.iter().enumerate() {
            let end = self.batches.get(number + 1).map_or(self.count, |next| next.first());
            members.extend((batch.first()..end).filter(|member| batch.is_under_way(*member)));
        }
        members
    }

    pub(crate) fn steps_of(&self, member: usize) -> Option<u64> {
        Some(self.batch_of(member)?.steps(member, self.clock))
    }

    pub(crate) fn state(&self, member: usize) -> Option<Box<dyn Point>> {
        match self.shown(member) {
            Some((_, state)) => Some(state.boxed_clone()),
            None => Some(self.batch_of(member)?.state(member, self.clock)),
        }
    }

    pub(crate) fn time_of(&self, member: usize) -> Option<f64> {
        match self.shown(member) {
            Some((time, _)) => Some(time),
            None => Some(self.batch_of(member)?.time_of(member, self.clock)),
        }
    }

    pub(crate) fn energy(&self, member: usize) -> Option<f64> {
        Some(self.energies.parts(member, &*self.state(member)?, self.time_of(member)?).total)
    }

    /// The energies of all members, in their order.
    pub(crate) fn energies(&self) -> Vec<f64> {
        let (mut energies, times) = (Vec::with_capacity(self.count), self.times());
        for batch in 0..self.batches.len() {
            self.states(batch, &mut |member, state| {
                let time = self.shown(member).map_or(times[member], |(time, _)| time);
                energies.push(self.energies.parts(member, state, time).total);
            });
        }
        energies
    }

    pub(crate) fn invariant(&self, member: usize, name: &str) -> Result<Option<f64>, Error> {
        let known = self.energies.invariants();
        let Some(number) = known.iter().position(|known| *known == name) else {
            return Err(Error::NoInvariant { name: name.into(), known });
        };
        Ok(self.state(member).map(|state| self.energies.invariant(member, number, &*state)))
    }

    pub(crate) fn batches(&self) -> usize {
        self.batches.len()
    }

    /// Shows the states of the members of a batch, in their order.
    pub(crate) fn states(&self, batch: usize, visit: &mut dyn FnMut(usize, &dyn Point)) {
        self.states_at_step(batch, &mut |member, state| {
            visit(member, self.shown(member).map_or(state, |(_, shown)| shown));
        });
    }

    /// Shows the states of the members of a batch at the end of the last common step.
    pub(crate) fn states_at_step(&self, batch: usize, visit: &mut dyn FnMut(usize, &dyn Point)) {
        self.batches[batch].states(self.clock, visit);
    }

    /// The member's batch.
    pub(super) fn batch_of(&self, member: usize) -> Option<&Batch> {
        self.batches.get(self.number_of_batch(member)?)
    }

    /// The number of the member's batch: batches hold members in their order.
    pub(super) fn number_of_batch(&self, member: usize) -> Option<usize> {
        let after = self.batches.partition_point(|batch| batch.first() <= member);
        after.checked_sub(1).filter(|_| member < self.count)
    }
}

/// The error of an ensemble for an error of a member.
pub(crate) fn of_member(member: usize) -> impl Fn(Error) -> Error + Copy {
    move |error| Error::Member { member, error: Box::new(error) }
}

/// The error for some invalid members of this number: the first one, if it is the only one or all are invalid.
pub(crate) fn refusal(mut members: Vec<(usize, Error)>, count: usize) -> Error {
    if members.len() > 1 && members.len() < count {
        return Error::Members { members, count };
    }
    let (member, error) = members.swap_remove(0);
    of_member(member)(error)
}
