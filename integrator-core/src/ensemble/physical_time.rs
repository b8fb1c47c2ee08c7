//! Ensembles at a given time: whole steps with all members together, and from there each member alone, on a copy.
//!
//! Always true: the ensemble itself is at the end of a step of all members, and no member is beyond the time, so
//! reading it does not change it. In a fictitious time, some members need more steps than others. They take these on
//! their copies, from which a later reading continues.

use crate::{
    ensemble::{
        Ensemble,
        batch::Finish,
        between::{Between, Shown},
        energies::EnergiesOfMembers,
        members::{Members, of_member},
    },
    error::{Divergence, Error, Lost},
    state::{coords::Coords, phase::Phase, point::shaped},
    system::{
        energy::{Energies, Parts},
        motion::Found,
    },
    threads::on_threads,
    trajectory::{
        engine::BLOCK,
        panics::{Panics, attempt},
        physical_time::steps_at_once,
        run::Run,
    },
};
use std::{
    any::Any,
    sync::{
        Arc, Mutex, PoisonError,
        atomic::{AtomicUsize, Ordering},
    },
};

/// Reading a member takes about as long as this number of steps.
const STEPS_OF_A_LOOK: u64 = 8;

/// The outcome of a member that went alone to a time.
enum Outcome {
    There(Shown),
    /// Its last state, and its divergence, unless a function of the user panicked.
    Lost(Finish, Option<Divergence>),
    Failed(Error),
}

impl<C: Coords> Ensemble<C> {
    /// Advances every active member to the time `time`, up to rounding, like [`Run::advance_to`].
    ///
    /// All members take whole steps, as long as none of them passes `time`. From there, a copy of each member advances to
    /// `time`.
    ///
    /// [`Ensemble::time`], [`Ensemble::state`] and [`Ensemble::energy`] then refer to `time`, bitwise identical to those of
    /// single runs. [`Ensemble::steps`] counts the whole steps that all members have taken, and the ensemble continues from
    /// there. Failed and finished members are unchanged.
    ///
    /// ```
    /// use integrator_core::prelude::*;
    ///
    /// struct Comet;
    ///
    /// #[hamiltonian]
    /// impl Comet {
    ///     fn kinetic(&self, p: [f64; 2]) -> f64 { (p[0] * p[0] + p[1] * p[1]) / 2.0 }
    ///     fn potential(&self, q: [f64; 2]) -> f64 { -1.0 / q[0].hypot(q[1]) }
    /// }
    ///
    /// // Each in steps of its own, and all at the same time.
    /// let comets = (0..20).map(|i| (Comet, Phase::new([0.1 + 0.04 * f64::from(i), 0.0], [0.0, 1.0])));
    /// let mut comets = Ensemble::new(Logarithmic(SofroniouSpaletta8), comets, 0.1)?;
    /// comets.advance_to(10.0)?;
    /// assert!((0..20).all(|comet| comets.time_of(comet) == Some(10.0)));
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    /// - Those of [`Ensemble::advance`]. Members that fail are listed; all others are at `time`.
    /// - [`Error::Time`]: `time` is not finite.
    /// - [`Error::Passed`]: `time` is before the last whole step. For a method with a fictitious time, it is contained in
    ///   [`Error::Member`].
    ///
    /// # Panics
    /// Like [`Ensemble::advance`].
    pub fn advance_to(&mut self, time: f64) -> Result<(), Error> {
        let before = self.members.between.take();
        let mut lost = match self.members.whole_steps_to(time) {
            Ok(lost) => lost,
            Err(error) => {
                self.members.between = before;
                return Err(error);
            }
        };
        let panics = Panics::default();
        let found = self.alone_to(time, before.as_ref(), &panics);
        let mut between = Between { time, members: (0..self.len()).map(|_| None).collect() };
        let mut failed = None;
        for (member, outcome) in found {
            match outcome {
                Outcome::There(shown) => between.members[member] = Some(shown),
                Outcome::Lost(finish, divergence) => {
                    self.members.lose(member, finish);
                    lost.extend(divergence.map(|divergence| (member, divergence)));
                }
                Outcome::Failed(error) => failed = failed.or(Some(of_member(member)(error))),
            }
        }
        self.members.between = Some(between);
        panics.resume();
        lost.sort_unstable_by_key(|(member, _)| *member);
        match failed {
            Some(error) => Err(error),
            None if lost.is_empty() => Ok(()),
            None => Err(Lost { members: lost }.into()),
        }
    }

    /// Every member in progress at a time, in their order.
    fn alone_to(&self, time: f64, before: Option<&Between>, panics: &Panics) -> Vec<(usize, Outcome)> {
        let found = Mutex::new(Vec::new());
        self.members.each(&|member| {
            let earlier = before.and_then(|before| before.ahead::<C>(member)).filter(|run| self.leads_to(run, time));
            let Some(run) = earlier.cloned().or_else(|| self.alone(member)) else { return };
            let outcome = self.outcome(run, time, panics);
            found.lock().unwrap_or_else(PoisonError::into_inner).push((member, outcome));
        });
        let mut found = found.into_inner().unwrap_or_else(PoisonError::into_inner);
        found.sort_unstable_by_key(|(member, _)| *member);
        found
    }

    /// Whether a member that was ahead of all is so still, and not beyond a time.
    fn leads_to(&self, run: &Run<C>, time: f64) -> bool {
        let clock = self.members.clock;
        run.steps() > clock.steps && !clock.is_beyond(run.time_at_step(), time)
    }

    fn outcome(&self, mut run: Run<C>, time: f64, panics: &Panics) -> Outcome {
        let outcome = panics.attempt(|| run.advance_to(time));
        let divergence = match outcome {
            Some(Ok(())) => {
                let (state, is_ahead) = (Box::new(run.state()), run.steps() > self.members.clock.steps);
                return Outcome::There(Shown {
                    state,
                    ahead: is_ahead.then(|| Box::new(run) as Box<dyn Any + Send + Sync>),
                });
            }
            None => None,
            Some(Err(Error::Diverged(divergence))) => Some(divergence),
            Some(Err(Error::NotSolved { .. })) => Some(run.divergence()),
            Some(Err(error)) => return Outcome::Failed(error),
        };
        let (steps, time, state) = (run.steps(), run.time_at_step(), Box::new(run.state_at_step()));
        Outcome::Lost(Finish { steps, time, state }, divergence)
    }

    /// The energies of a member.
    pub(super) fn energies_of(&self, member: usize) -> Arc<dyn Energies<C>> {
        Arc::new(EnergiesOfMember { member, energies: self.members.energies.clone() })
    }

    /// A member that is in progress as a run, which stands where the ensemble does.
    pub(super) fn alone(&self, member: usize) -> Option<Run<C>> {
        let members = &self.members;
        let alone = members.batch_of(member)?.alone(member);
        let shape = shaped::<C>(&*members.state(member)?).clone();
        let mut run = Run::of_engine(alone.engine, self.energies_of(member), shape, members.clock, alone.opened);
        run.opened_at = alone.opened_at;
        Some(run)
    }
}

/// The energies of a member of an ensemble.
struct EnergiesOfMember {
    member: usize,
    energies: Arc<dyn EnergiesOfMembers>,
}

impl<C: Coords> Energies<C> for EnergiesOfMember {
    fn parts(&self, state: &Phase<C>, time: f64, _: Option<&Found>) -> Parts {
        self.energies.parts(self.member, state, time)
    }

    fn invariants(&self) -> &'static [&'static str] {
        self.energies.invariants()
    }

    fn invariant(&self, number: usize, state: &Phase<C>) -> f64 {
        self.energies.invariant(self.member, number, state)
    }
}

impl Members {
    /// Takes the whole steps that lead no member beyond a time, and returns the members that fail.
    ///
    /// # Errors
    /// The errors of [`Ensemble::advance_to`], except for failed members.
    fn whole_steps_to(&mut self, time: f64) -> Result<Vec<(usize, Divergence)>, Error> {
        if !time.is_finite() {
            return Err(Error::Time { time });
        }
        if self.active() == 0 {
            return Ok(Vec::new());
        }
        if self.batches.iter().any(|batch| batch.is_timed()) {
            return self.steps_in_own_times_to(time);
        }
        let (clock, present) = (self.clock, self.time_at_step());
        if clock.is_beyond(present, time) {
            return Err(Error::Passed { time, present });
        }
        // Where the clock did not start at a time, this says so.
        clock.check()?;
        lost(self.advance(clock.whole_steps_to(time).saturating_sub(clock.steps), u64::MAX, &|_, _| true))
    }

    /// Takes the whole steps of members whose time is part of their state: blocks with more and more steps, but fewer
    /// than lead a member to the time at its recent mean rate. Blocks that lead one beyond the time are taken back.
    fn steps_in_own_times_to(&mut self, time: f64) -> Result<Vec<(usize, Divergence)>, Error> {
        self.clock.check()?;
        let (mut lost_members, mut block) = (Vec::new(), 1);
        let mut before = self.times();
        for member in self.under_way() {
            if self.clock.is_beyond(before[member], time) {
                return Err(of_member(member)(Error::Passed { time, present: before[member] }));
            }
        }
        loop {
            let members = self.under_way();
            if members.is_empty() || members.iter().any(|member| before[*member] == time) {
                break;
            }
            let earlier = (self.batches.clone(), self.clock);
            let outcome = attempt(|| self.advance(block, u64::MAX, &|_, _| true));
            let after = self.times();
            let is_beyond = members.iter().any(|member| self.clock.is_beyond(after[*member], time));
            if is_beyond || (outcome.is_err() && block > 1) {
                (self.batches, self.clock) = earlier;
                if block == 1 {
                    break;
                }
                block /= 2;
                continue;
            }
            lost_members.extend(lost(outcome.unwrap_or_else(|panic| panic.resume()))?);
            if members.iter().all(|member| after[*member] == before[*member]) {
                // Each of them says so alone.
                break;
            }
            let steps = |member: &usize| {
                let step = (after[*member] - before[*member]) / block as f64;
                steps_at_once(time - after[*member], step)
            };
            block = members.iter().map(steps).min().unwrap_or(1).clamp(1, BLOCK.min(2 * block));
            before = after;
        }
        Ok(lost_members)
    }

    /// The times of all members.
    pub(super) fn times(&self) -> Vec<f64> {
        let mut times = Vec::with_capacity(self.count());
        for batch in &self.batches {
            batch.times(self.clock, &mut |time| times.push(time));
        }
        times
    }

    /// Calls a function with each member in progress, on as many threads as are worth it.
    fn each(&self, function: &(dyn Fn(usize) + Sync)) {
        let (members, next) = (self.under_way(), AtomicUsize::new(0));
        let threads = self.threads_for(STEPS_OF_A_LOOK).min(members.len());
        on_threads(threads, &|| {
            while let Some(member) = members.get(next.fetch_add(1, Ordering::Relaxed)) {
                function(*member);
            }
        });
    }

    fn lose(&mut self, member: usize, finish: Finish) {
        if let Some(batch) = self.number_of_batch(member) {
            self.batches[batch].lose(member, finish);
        }
    }
}

/// The failed members of an outcome.
///
/// # Errors
/// Any other.
fn lost(outcome: Result<(), Error>) -> Result<Vec<(usize, Divergence)>, Error> {
    match outcome {
        Ok(()) => Ok(Vec::new()),
        Err(Error::Lost(lost)) => Ok(lost.members),
        Err(error) => Err(error),
    }
}
