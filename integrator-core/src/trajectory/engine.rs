//! The engine of runs and ensembles: it advances motions in blocks of steps, until one leads to a state that is not
//! finite.
//!
//! Compiled once for all systems: what it calls of one are the functions of its [`Motions`], a few times per block.

use crate::{
    error::Unsolved,
    state::{
        clock::{Clock, durations, time_after},
        point::Point,
    },
    system::energy::Parts,
    trajectory::{
        motions::{Draws, Form, Motions, elapsed, load, reload, set_draws, show, shown},
        panics::attempt,
    },
};
use alloc::{boxed::Box, vec::Vec};

/// The number of steps between two checks of whether the state is finite. A divergence replays at most this number.
pub(crate) const BLOCK: u64 = 1024;

/// An engine: the motions of one trajectory or of members in lanes, and the copies that steps need.
#[derive(Clone)]
pub(crate) struct Engine {
    pub(crate) motions: Box<dyn Motions>,
    /// The motions where the last block of steps began; kept here, like the next, so that no block allocates.
    pub(crate) snapshot: Box<dyn Motions>,
    /// The motions at the end of the block, with the last step completed.
    pub(crate) completed: Box<dyn Motions>,
    /// The clock of the motions that `completed` was made of, while they are still there.
    completed_at: Option<Clock>,
    /// The number of the member that a single trajectory is; nought for a run.
    member: usize,
    /// Whether the constants of the additional lanes of a trajectory come after its own, as many as it has lanes.
    carries_constants: bool,
    /// The number of threads that may share a long lattice or the pairs of many bodies, if not all.
    pub(crate) threads: Option<usize>,
}

impl Engine {
    pub(crate) fn new(motions: Box<dyn Motions>) -> Self {
        let (snapshot, completed) = (motions.clone(), motions.clone());
        Self { motions, snapshot, completed, completed_at: None, member: 0, carries_constants: false, threads: Some(1) }
    }

    /// The engine of a member of an ensemble alone, with its motion.
    #[cfg(feature = "std")]
    pub(crate) fn of_member(motions: Box<dyn Motions>, member: usize) -> Self {
        Self { member, ..Self::new(motions) }
    }

    /// The engine of one trajectory, with the step functions of some motions: its start, and what it carries beside.
    pub(crate) fn single(like: &dyn Motions, lanes: Vec<&dyn Point>) -> Self {
        Self::new(load(like, lanes.into_iter().map(|point| (0, point)).collect()))
    }

    /// The engine of one trajectory whose additional lanes have constants of their own.
    pub(crate) fn single_with_constants(like: &dyn Motions, lanes: Vec<&dyn Point>) -> Self {
        Self { carries_constants: true, ..Self::new(load(like, lanes.into_iter().enumerate().collect())) }
    }

    /// Takes `steps` steps from `clock`, or as many as end in a finite state, and counts them in `taken`.
    ///
    /// # Panics
    /// Where the user's functions do. The count and the motion are then at the last step before that one, as they are
    /// where steps diverge. Without `std` they are where the block of steps began.
    pub(crate) fn advance(&mut self, mut clock: Clock, steps: u64, taken: &mut u64) {
        let end = clock.steps + steps;
        while clock.steps < end {
            let block = BLOCK.min(end - clock.steps);
            if !self.advance_block(clock, block, taken) {
                break;
            }
            clock.steps += block;
        }
    }

    /// Takes a block of steps and counts them; `false` after as many of them as end in a finite state.
    fn advance_block(&mut self, clock: Clock, steps: u64, taken: &mut u64) -> bool {
        let whole = attempt(|| self.try_steps(clock, steps));
        match whole {
            Ok(true) => {
                *taken += steps;
                return true;
            }
            Ok(false) if steps == 1 => return false,
            Err(panic) if steps == 1 => panic.resume(),
            Ok(false) | Err(_) => {}
        }
        // What panicked does so again, after the steps before it were counted.
        let finite = self.replay(clock, steps, taken);
        match whole {
            Err(panic) if finite => panic.resume(),
            Ok(_) | Err(_) => finite,
        }
    }

    /// Takes a block step by step, and counts the steps up to the first whose state is not finite: what left
    /// them never returns, since updates only add.
    pub(crate) fn replay(&mut self, clock: Clock, steps: u64, taken: &mut u64) -> bool {
        for step in 0..steps {
            if !self.try_steps(Clock { steps: clock.steps + step, ..clock }, 1) {
                return false;
            }
            *taken += 1;
        }
        true
    }

    /// Takes `steps` steps; `false`, and back where they began, if their end is not finite.
    fn try_steps(&mut self, clock: Clock, steps: u64) -> bool {
        let mut attempt = Attempt { engine: self, finite: false };
        attempt.finite = attempt.engine.take_steps(clock, steps);
        attempt.finite
    }

    /// Takes `steps` steps, and returns whether they end in finite numbers once the last of them is completed. What
    /// undoes a processor has no say: it would cost as much as steps do, and acts only where the state is read.
    pub(crate) fn take_steps(&mut self, clock: Clock, steps: u64) -> bool {
        self.snapshot.copy_states(&*self.motions, self.threads);
        self.completed_at = None;
        self.motions.advance(clock, steps, self.threads);
        // Completing the step only adds, so that no number becomes finite by it.
        self.complete(Clock { steps: clock.steps + steps, ..clock });
        self.completed.finite(self.threads)
    }

    /// Completes the current step on a copy.
    pub(crate) fn complete(&mut self, clock: Clock) {
        self.completed.copy_states(&*self.motions, self.threads);
        self.completed.complete(clock, self.threads);
        self.completed_at = Some(clock);
    }

    /// Goes back to where the last block began.
    pub(crate) fn undo(&mut self) {
        self.completed_at = None;
        self.motions.copy_states(&*self.snapshot, self.threads);
    }

    /// Goes back to other motions.
    pub(crate) fn go_back(&mut self, motions: &dyn Motions) {
        self.completed_at = None;
        self.motions.copy_states(motions, self.threads);
    }

    /// The motions of the same members at other states of the same size, which take over what these have found.
    pub(crate) fn reloaded(&self, members: Vec<(usize, &dyn Point)>) -> Box<dyn Motions> {
        let mut motions = reload(&*self.motions, members);
        if let Some(found) = &self.motions.found() {
            motions.use_found(found);
        }
        motions.share_among(self.threads);
        motions
    }

    /// Continues with other motions, at the beginning of a clock.
    pub(crate) fn restart(&mut self, motions: Box<dyn Motions>) {
        self.motions = motions;
        self.completed_at = None;
    }

    /// The number of the constants of a lane.
    pub(crate) fn constants_of(&self, lane: usize) -> usize {
        if self.carries_constants { lane } else { self.member }
    }

    /// Continues with what [`Engine::unfinished`] has written of a state, and of what it carries beside.
    pub(crate) fn resume(&mut self, form: Form, lanes: &[&dyn Point]) {
        let mut motions = self.motions.none(self.motions.count());
        let lanes = lanes.iter().enumerate();
        let lanes: Vec<_> = lanes.map(|(lane, point)| (self.constants_of(lane), *point)).collect();
        for lanes in lanes.chunks(motions.lanes()) {
            motions.push(lanes, form);
        }
        motions.share_among(self.threads);
        self.motions = motions;
        self.completed_at = None;
    }

    /// Writes a lane in the middle of the current step, from which it resumes bitwise.
    pub(crate) fn unfinished(&self, form: Form, lane: usize, to: &mut dyn Point) {
        match form {
            Form::Given => self.motions.store(lane, to),
            Form::Own => self.motions.store_own(lane, to),
        }
    }

    /// Writes the state of a trajectory, in lane 0, or what it carries in another lane: with the current step completed, while
    /// the motions stay where they are.
    pub(crate) fn lane(&self, clock: Clock, lane: usize, to: &mut dyn Point) {
        self.read(clock, |completed, shown| show(completed, shown, lane, to));
    }

    /// The energy of a trajectory at the end of the current step, if it is computed from the motion.
    pub(crate) fn energy(&self, clock: Clock, time: f64) -> Option<Parts> {
        let is_known = self.motions.has_energy() && !self.motions.shows();
        if is_known { self.read(clock, |completed, _| completed.energy(time)) } else { None }
    }

    /// The time of a trajectory, where it is part of the state: with `t0` and what had passed when its motion was loaded.
    pub(crate) fn own_time(&self, clock: Clock, t0: f64, before: [f64; 2]) -> Option<f64> {
        Some(time_after(t0, durations(before, self.elapsed(clock, 0)?)))
    }

    /// The time of a trajectory since its motion was loaded, or what it carries in a lane beside it, and its rounding error,
    /// where it is part of the state.
    pub(crate) fn elapsed(&self, clock: Clock, lane: usize) -> Option<[f64; 2]> {
        // Most have no such time, and reading it would complete a step.
        self.motions.elapsed(lane)?;
        self.read(clock, |completed, shown| elapsed(completed, shown, lane))
    }

    /// Reads a trajectory with the current step completed.
    pub(crate) fn read<T>(&self, clock: Clock, read: impl FnOnce(&dyn Motions, Option<&dyn Motions>) -> T) -> T {
        let again;
        let completed = if self.completed_at == Some(clock) {
            &self.completed
        } else {
            let mut copy = self.motions.clone();
            copy.complete(clock, self.threads);
            again = copy;
            &again
        };
        read(&**completed, shown(&**completed, clock).as_deref())
    }

    /// Reads a trajectory a while into the last step, which began at `from`, its lanes, and at `clock`, if that was taken
    /// alone. Returns its time since the motion was loaded, where that is part of the state.
    ///
    /// # Errors
    /// Why the method gave up; nothing, if the state is not finite.
    pub(crate) fn within(
        &mut self,
        from: Vec<&dyn Point>,
        clock: Clock,
        duration: f64,
        read: impl FnOnce(&dyn Motions, Option<&dyn Motions>),
    ) -> Result<Option<[f64; 2]>, Option<Unsolved>> {
        let begin = Clock { t0: clock.at(clock.steps), h: duration, steps: 0 };
        let end = Clock { steps: 1, ..begin };
        let mut shorter;
        let motions = if self.completed.dense(&*self.snapshot, clock, duration) {
            self.completed_at = None;
            &self.completed
        } else {
            let lanes = from.into_iter().enumerate();
            shorter = load(&*self.motions, lanes.map(|(lane, point)| (self.constants_of(lane), point)).collect());
            shorter.advance(begin, 1, self.threads);
            shorter.complete(end, self.threads);
            &shorter
        };
        if !motions.finite(self.threads) {
            return Err(motions.unsolved(0).cloned());
        }
        let shown = shown(&**motions, end);
        read(&**motions, shown.as_deref());
        Ok(elapsed(&**motions, shown.as_deref(), 0))
    }

    /// Whether a force or a velocity is not finite: then nor is a step of no length at all.
    pub(crate) fn is_not_finite(&self, clock: Clock) -> bool {
        !self.clone().take_steps(Clock { h: 0.0, ..clock }, 1)
    }

    /// Changes what random numbers depend on.
    pub(crate) fn change_draws(&mut self, change: &dyn Fn(&mut Draws)) {
        let mut draws = self.motions.draws();
        change(&mut draws);
        self.completed_at = None;
        for motions in [&mut self.motions, &mut self.snapshot, &mut self.completed] {
            set_draws(&mut **motions, draws);
        }
    }

    /// Lets this number of threads share the work, or all that the machine has.
    pub(crate) fn share_among(&mut self, threads: Option<usize>) {
        self.threads = threads;
        self.motions.share_among(threads);
    }
}

/// Steps in progress. Unless they end in finite numbers, the motions go back, also where a function of the user panics.
struct Attempt<'e> {
    engine: &'e mut Engine,
    finite: bool,
}

impl Drop for Attempt<'_> {
    fn drop(&mut self) {
        if !self.finite {
            self.engine.undo();
        }
    }
}
