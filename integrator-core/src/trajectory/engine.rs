//! What carries a trajectory on: the motion, and its copies for faults and looks.

use crate::{
    error::Unsolved,
    state::{clock::Clock, coords::Coords, phase::Phase},
    system::{energy::Energies, motion::Motion},
    trajectory::{moves::Moves, panics::attempted},
};
use alloc::{boxed::Box, sync::Arc};
use core::marker::PhantomData;

/// How many steps lie between two looks at whether the state is finite. A divergence replays at most so many.
pub(crate) const BLOCK: u64 = 1024;

/// A run without its clock, behind one type whatever system, composition and scalar it was made of.
pub(crate) trait Engine<C: Coords>: Send + Sync {
    /// Takes `steps` steps from `clock`, or as many as end in a finite state, and counts them in `taken`.
    ///
    /// # Panics
    /// Where the user's functions do. The count and the motion are then at the last step before that one, as they are where
    /// steps lead out of the finite numbers. Without `std` they are where the block of steps began.
    fn advance(&mut self, clock: Clock, steps: u64, taken: &mut u64);
    /// Goes back to where the last call of [`Engine::advance`] began, if that took one step.
    fn take_back(&mut self);
    /// Goes on from another state of the same size, at the beginning of a clock.
    fn restart(&mut self, state: &Phase<C>);
    fn state(&self, clock: Clock) -> Phase<C>;
    /// Where the last step led that was tried.
    fn tried(&self) -> Phase<C>;
    /// The state a while into the last step, which began at `from` and `clock`, if [`Engine::advance`] took no other with
    /// it; the run itself stays where it is.
    ///
    /// # Errors
    /// Why the method gave up; nothing, if the state is not finite.
    fn within(&mut self, from: &Phase<C>, clock: Clock, duration: f64) -> Result<Phase<C>, Option<Unsolved>>;
    /// The state in the middle of the step under way.
    #[cfg(feature = "checkpoint")]
    fn unfinished(&self) -> Phase<C>;
    fn energies(&self) -> Arc<dyn Energies<C>>;
    /// Why the method gave up the step that [`Engine::advance`] stopped before, if that is why it stopped.
    fn unsolved(&self) -> Option<&Unsolved>;
    /// How often steps have evaluated the force, where they count it.
    fn evaluations(&self) -> Option<u64>;
    /// Lets so many threads share a long lattice or the pairs of many bodies, or all that the machine has.
    fn share_among(&mut self, threads: Option<usize>);
    fn boxed_clone(&self) -> Box<dyn Engine<C>>;
}

/// Whether a force or a velocity is not finite: then nor is a step of no length at all.
pub(crate) fn is_spoilt<C: Coords>(engine: &dyn Engine<C>, clock: Clock) -> bool {
    let mut taken = 0;
    engine.boxed_clone().advance(Clock { h: 0.0, ..clock }, 1, &mut taken);
    taken == 0
}

/// A motion that is looked after: a step that leads out of the finite numbers is not taken.
#[derive(Clone)]
struct Checked<M> {
    motion: M,
    /// The motion at the last look that found it finite; kept here so that no block allocates.
    snapshot: M,
    /// Where a step is completed to see whether it is finite.
    closed: M,
    moves: Moves<M>,
    /// Why the last step that was not taken could not be solved, if that is why.
    unsolved: Option<Unsolved>,
}

impl<M: Clone> Checked<M> {
    fn new(motion: M, moves: Moves<M>) -> Self {
        Self { snapshot: motion.clone(), closed: motion.clone(), motion, moves, unsolved: None }
    }

    /// Takes `steps` steps; `false`, and back where they began, if their state is not finite: the motion, or what
    /// completing the last step makes of it. What undoes a processor has no say: it would cost as much as steps do, and acts
    /// only where the run is looked at.
    fn advance<C: Coords, P>(&mut self, clock: Clock, steps: u64) -> bool
    where
        M: Motion<C, P>,
    {
        self.snapshot.copy_state(&self.motion);
        let mut attempt = Attempt { checked: self, taken: false, marker: PhantomData };
        let checked = &mut *attempt.checked;
        checked.moves.advance(&mut checked.motion, clock, steps);
        // Completing the step only adds, so that no number becomes finite by it.
        checked.closed.copy_state(&checked.motion);
        (checked.moves.complete)(&mut checked.closed, Clock { steps: clock.steps + steps, ..clock });
        let finite = checked.closed.finite();
        if !finite {
            checked.unsolved = checked.motion.unsolved(0).cloned();
        }
        attempt.taken = finite;
        finite
    }

    /// The motion a while into the last step, if that was taken alone and the method has dense output.
    fn within(&mut self, clock: Clock, duration: f64) -> Option<&M> {
        let dense = self.moves.dense?;
        dense(&mut self.closed, &self.snapshot, clock, duration);
        Some(&self.closed)
    }

    /// The state with the step under way completed; `shape` knows the size where the type does not.
    fn state<C: Coords, P>(&self, clock: Clock, shape: &Phase<C>) -> Phase<C>
    where
        M: Motion<C, P>,
    {
        let motion = self.moves.shown(self.motion.clone(), clock);
        let mut state = shape.clone();
        motion.store(0, &mut state);
        state
    }

    /// The motion as it stands, in the middle of a step.
    #[cfg(feature = "checkpoint")]
    fn motion(&self) -> &M {
        &self.motion
    }
}

/// Steps under way. Unless they are taken, the motion goes back to the snapshot, also where a function of the user panics.
struct Attempt<'w, M: Motion<C, P>, C: Coords, P> {
    checked: &'w mut Checked<M>,
    taken: bool,
    marker: PhantomData<fn(C, P)>,
}

impl<M: Motion<C, P>, C: Coords, P> Drop for Attempt<'_, M, C, P> {
    fn drop(&mut self) {
        if !self.taken {
            self.checked.motion.copy_state(&self.checked.snapshot);
        }
    }
}

/// The engine of one trajectory.
pub(crate) struct Solo<M, P, C> {
    checked: Checked<M>,
    constants: Arc<P>,
    energies: Arc<dyn Energies<C>>,
    shape: Phase<C>,
}

impl<M: Motion<C, P>, P, C: Coords> Solo<M, P, C> {
    pub(crate) fn new(constants: Arc<P>, start: Phase<C>, moves: Moves<M>, energies: Arc<dyn Energies<C>>) -> Self {
        let motion = M::load(&[&*constants], &[&start]);
        Self { checked: Checked::new(motion, moves), constants, energies, shape: start }
    }

    /// Takes a block of steps and counts them; `false` after as many of them as end in a finite state.
    fn block(&mut self, clock: Clock, steps: u64, taken: &mut u64) -> bool {
        let whole = attempted(|| self.checked.advance(clock, steps));
        match whole {
            Ok(true) => {
                *taken += steps;
                return true;
            }
            Ok(false) if steps == 1 => return false,
            Err(panic) if steps == 1 => panic.resume(),
            Ok(false) | Err(_) => {}
        }
        // What left the finite numbers never returns, since updates only add: replay the block step by step. What panicked
        // does so again, after the steps before it were counted.
        for step in 0..steps {
            if !self.checked.advance(Clock { steps: clock.steps + step, ..clock }, 1) {
                return false;
            }
            *taken += 1;
        }
        match whole {
            Ok(_) => true,
            Err(panic) => panic.resume(),
        }
    }
}

impl<M: Motion<C, P>, P: Send + Sync + 'static, C: Coords> Engine<C> for Solo<M, P, C> {
    fn advance(&mut self, mut clock: Clock, steps: u64, taken: &mut u64) {
        let end = clock.steps + steps;
        while clock.steps < end {
            let block = BLOCK.min(end - clock.steps);
            if !self.block(clock, block, taken) {
                break;
            }
            clock.steps += block;
        }
    }

    fn take_back(&mut self) {
        let Checked { motion, snapshot, .. } = &mut self.checked;
        motion.copy_state(snapshot);
    }

    fn restart(&mut self, state: &Phase<C>) {
        let moves = self.checked.moves;
        let mut motion = M::load(&[&*self.constants], &[state]);
        motion.share_among(moves.threads);
        self.checked = Checked::new(motion, moves);
    }

    fn state(&self, clock: Clock) -> Phase<C> {
        self.checked.state(clock, &self.shape)
    }

    fn tried(&self) -> Phase<C> {
        let mut state = self.shape.clone();
        self.checked.closed.store(0, &mut state);
        state
    }

    fn within(&mut self, from: &Phase<C>, clock: Clock, duration: f64) -> Result<Phase<C>, Option<Unsolved>> {
        let Self { checked, constants, .. } = self;
        let moves = checked.moves;
        let shorter;
        let motion = match checked.within(clock, duration) {
            Some(motion) => motion,
            None => {
                let clock = Clock { t0: clock.at(clock.steps), h: duration, steps: 0 };
                let mut motion = M::load(&[&**constants], &[from]);
                moves.advance(&mut motion, clock, 1);
                shorter = moves.shown(motion, Clock { steps: 1, ..clock });
                &shorter
            }
        };
        if !motion.finite() {
            return Err(motion.unsolved(0).cloned());
        }
        let mut state = from.clone();
        motion.store(0, &mut state);
        Ok(state)
    }

    #[cfg(feature = "checkpoint")]
    fn unfinished(&self) -> Phase<C> {
        let mut state = self.shape.clone();
        self.checked.motion().store(0, &mut state);
        state
    }

    fn energies(&self) -> Arc<dyn Energies<C>> {
        self.energies.clone()
    }

    fn unsolved(&self) -> Option<&Unsolved> {
        self.checked.unsolved.as_ref()
    }

    fn evaluations(&self) -> Option<u64> {
        self.checked.motion.evaluations()
    }

    fn share_among(&mut self, threads: Option<usize>) {
        self.checked.moves.threads = threads;
        self.checked.motion.share_among(threads);
    }

    fn boxed_clone(&self) -> Box<dyn Engine<C>> {
        Box::new(Self {
            checked: self.checked.clone(),
            energies: self.energies.clone(),
            constants: self.constants.clone(),
            shape: self.shape.clone(),
        })
    }
}
