//! What carries a trajectory on: the motion, its copies for faults and looks, and the loops compiled for it.

use crate::{
    composition::Composition,
    coords::Coords,
    energies::Energies,
    error::{Divergence, Error, Unsolved},
    hamiltonian::{Flows, Hamiltonian, Motion, Single},
    leap::Leaps,
    panics::attempted,
    phase::Phase,
    real::{Kernel, Real},
    slot::Keep,
    tiled::Tiled,
};
use alloc::{boxed::Box, sync::Arc};
use core::marker::PhantomData;

/// How many steps lie between two looks at whether the state is finite. A divergence replays at most so many.
pub(crate) const BLOCK: u64 = 1024;

/// Time as an integer number of steps: `t0 + n·h`, never an accumulated sum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Clock {
    pub(crate) t0: f64,
    pub(crate) h: f64,
    pub(crate) steps: u64,
}

impl Clock {
    pub(crate) fn at(&self, steps: u64) -> f64 {
        self.t0 + steps as f64 * self.h
    }

    /// How many steps will be done after `asked` more.
    ///
    /// # Errors
    /// A clock that did not start at a time, more steps than can be counted, and steps that the clock does not notice.
    pub(crate) fn end(&self, asked: u64) -> Result<u64, Error> {
        self.check()?;
        let end = self.steps.checked_add(asked).ok_or(Error::Steps { done: self.steps, asked })?;
        // Time is coarsest where it is farthest from zero, which is at one end of the way. An infinite time is found too.
        let ends = if asked == 0 { None } else { Some([self.steps, end]) };
        match ends.into_iter().flatten().map(|steps| self.at(steps)).find(|time| time + self.h == *time) {
            Some(time) => Err(Error::Clock { h: self.h, time }),
            None => Ok(end),
        }
    }

    /// Whether the clock started at a time.
    pub(crate) fn check(&self) -> Result<(), Error> {
        match self.t0.is_finite() {
            true => Ok(()),
            false => Err(Error::Time { time: self.t0 }),
        }
    }

    /// What to say of a trajectory that has taken its last finite step, to `state`; `next` is where one more leads.
    pub(crate) fn divergence<C: Coords>(&self, state: &Phase<C>, next: &Phase<C>) -> Divergence {
        let flat = |coordinates: &C| coordinates.flat().iter().map(|leaf| leaf.to_f64()).collect();
        let step = self.steps.saturating_add(1);
        let leaves = state.q.flat().iter().chain(state.p.flat());
        let limit = leaves.map(|leaf| leaf.limit()).fold(f64::INFINITY, f64::min);
        // The limit of a grid is exclusive, as infinity is.
        let gone = |leaf: &C::Leaf| leaf.to_f64().is_nan() || leaf.to_f64().abs() >= limit;
        let first = |name, coordinates: &C| Some((name, coordinates.flat().iter().position(gone)?));
        let coordinate = first("q", &next.q).or_else(|| first("p", &next.p));
        Divergence { step, time: self.at(step), limit, coordinate, q: flat(&state.q), p: flat(&state.p) }
    }
}

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

/// What an engine does to its motion, compiled for one system, composition and scalar.
///
/// These are functions and not a type parameter: so the engine knows the motion's type alone, what is seldom called is
/// compiled once per motion, and a system that borrows its parameters can be run all the same.
pub struct Moves<M> {
    advance: fn(&mut M, Clock, u64, Option<usize>),
    /// Completes the step under way.
    complete: fn(&mut M, Clock),
    /// Makes of a completed step the state that is shown, where that differs.
    show: Option<fn(&mut M, Clock)>,
    /// Takes a motion a while into the step that begins at the other one and at the clock, where a method has dense output.
    /// It may stand anywhere in this step.
    dense: Option<fn(&mut M, &M, Clock, f64)>,
    /// How many threads may share a long lattice, if not all.
    threads: Option<usize>,
}

impl<M> Moves<M> {
    /// The moves of a method whose motion stands at the end of a step whenever it is looked at.
    pub(crate) fn closed(advance: fn(&mut M, Clock, u64, Option<usize>)) -> Self {
        Self { advance, complete: |_, _| {}, show: None, dense: None, threads: Some(1) }
    }
    /// The same with dense output.
    pub(crate) fn with_dense(self, dense: fn(&mut M, &M, Clock, f64)) -> Self {
        Self { dense: Some(dense), ..self }
    }
    pub(crate) fn advance(&self, motion: &mut M, clock: Clock, steps: u64) {
        (self.advance)(motion, clock, steps, self.threads);
    }
    /// Completes the step under way, up to the state that is shown: the end of the step of the kernel, where what undoes
    /// the processor leaves the finite numbers.
    pub(crate) fn shown<C: Coords, P>(&self, mut motion: M, clock: Clock) -> M
    where
        M: Motion<C, P>,
    {
        (self.complete)(&mut motion, clock);
        let Some(show) = self.show else { return motion };
        let mut shown = motion.clone();
        show(&mut shown, clock);
        if shown.finite() { shown } else { motion }
    }
}

impl<M> Clone for Moves<M> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<M> Copy for Moves<M> {}

/// The moves of a system under a composition.
pub(crate) fn moves<H: Hamiltonian, X: Composition<H>, R: Real, K: Keep>() -> Moves<H::Motion<R, K>> {
    Moves {
        advance: |motion, clock, steps, threads| {
            if Tiled::<H, R, K>::PAYS {
                let mut flows = Tiled::<H, R, K>::new(motion, threads);
                Advance::<_, H, X>::new(&mut flows, clock, steps).call();
                flows.finish();
            } else {
                R::enter(Advance::<_, H, X>::new(Single::<H, R, K>(motion), clock, steps));
            }
        },
        complete: end::<H, X, R, K, false>,
        show: if const { X::PROCESSOR.after.rows.is_empty() } { None } else { Some(end::<H, X, R, K, true>) },
        dense: None,
        threads: Some(1),
    }
}

/// The end of the step under way: its last stages, or what undoes the processor behind them.
fn end<H: Hamiltonian, X: Composition<H>, R: Real, K: Keep, const SHOWN: bool>(
    motion: &mut H::Motion<R, K>,
    clock: Clock,
) {
    if Tiled::<H, R, K>::PAYS {
        let mut flows = Tiled::<H, R, K>::new(motion, Some(1));
        End::<_, H, X, SHOWN>::new(&mut flows, clock).call();
        flows.finish();
    } else {
        R::enter(End::<_, H, X, SHOWN>::new(Single::<H, R, K>(motion), clock));
    }
}

/// A motion that is looked after: a step that leads out of the finite numbers is not taken.
#[derive(Clone)]
struct Watched<M> {
    motion: M,
    /// The motion at the last look that found it finite; kept here so that no block allocates.
    snapshot: M,
    /// Where a step is completed to see whether it is finite.
    closed: M,
    moves: Moves<M>,
    /// Why the last step that was not taken could not be solved, if that is why.
    unsolved: Option<Unsolved>,
}

impl<M: Clone> Watched<M> {
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
        let mut attempt = Attempt { watched: self, taken: false, marker: PhantomData };
        let watched = &mut *attempt.watched;
        watched.moves.advance(&mut watched.motion, clock, steps);
        // Completing the step only adds, so that no number becomes finite by it.
        watched.closed.copy_state(&watched.motion);
        (watched.moves.complete)(&mut watched.closed, Clock { steps: clock.steps + steps, ..clock });
        let finite = watched.closed.finite();
        if !finite {
            watched.unsolved = watched.motion.unsolved(0).cloned();
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
    watched: &'w mut Watched<M>,
    taken: bool,
    marker: PhantomData<fn(C, P)>,
}

impl<M: Motion<C, P>, C: Coords, P> Drop for Attempt<'_, M, C, P> {
    fn drop(&mut self) {
        if !self.taken {
            self.watched.motion.copy_state(&self.watched.snapshot);
        }
    }
}

/// The engine of one trajectory.
pub(crate) struct Solo<M, P, C> {
    watched: Watched<M>,
    constants: Arc<P>,
    energies: Arc<dyn Energies<C>>,
    shape: Phase<C>,
}

impl<M: Motion<C, P>, P, C: Coords> Solo<M, P, C> {
    pub(crate) fn new(constants: Arc<P>, start: Phase<C>, moves: Moves<M>, energies: Arc<dyn Energies<C>>) -> Self {
        let motion = M::load(|_| (&*constants, &start));
        Self { watched: Watched::new(motion, moves), constants, energies, shape: start }
    }

    /// Takes a block of steps and counts them; `false` after as many of them as end in a finite state.
    fn block(&mut self, clock: Clock, steps: u64, taken: &mut u64) -> bool {
        let whole = attempted(|| self.watched.advance(clock, steps));
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
            if !self.watched.advance(Clock { steps: clock.steps + step, ..clock }, 1) {
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
        let Watched { motion, snapshot, .. } = &mut self.watched;
        motion.copy_state(snapshot);
    }

    fn restart(&mut self, state: &Phase<C>) {
        let moves = self.watched.moves;
        let mut motion = M::load(|_| (&*self.constants, state));
        motion.share_among(moves.threads);
        self.watched = Watched::new(motion, moves);
    }

    fn state(&self, clock: Clock) -> Phase<C> {
        self.watched.state(clock, &self.shape)
    }

    fn tried(&self) -> Phase<C> {
        let mut state = self.shape.clone();
        self.watched.closed.store(0, &mut state);
        state
    }

    fn within(&mut self, from: &Phase<C>, clock: Clock, duration: f64) -> Result<Phase<C>, Option<Unsolved>> {
        let Self { watched, constants, .. } = self;
        let moves = watched.moves;
        let shorter;
        let motion = match watched.within(clock, duration) {
            Some(motion) => motion,
            None => {
                let clock = Clock { t0: clock.at(clock.steps), h: duration, steps: 0 };
                let mut motion = M::load(|_| (&**constants, from));
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
        self.watched.motion().store(0, &mut state);
        state
    }

    fn energies(&self) -> Arc<dyn Energies<C>> {
        self.energies.clone()
    }

    fn unsolved(&self) -> Option<&Unsolved> {
        self.watched.unsolved.as_ref()
    }

    fn evaluations(&self) -> Option<u64> {
        self.watched.motion.evaluations()
    }

    fn share_among(&mut self, threads: Option<usize>) {
        self.watched.moves.threads = threads;
        self.watched.motion.share_among(threads);
    }

    fn boxed_clone(&self) -> Box<dyn Engine<C>> {
        Box::new(Self {
            watched: self.watched.clone(),
            energies: self.energies.clone(),
            constants: self.constants.clone(),
            shape: self.shape.clone(),
        })
    }
}

/// The n-step loop.
pub(crate) struct Advance<F, H, X> {
    flows: F,
    clock: Clock,
    steps: u64,
    marker: PhantomData<(fn(H), X)>,
}

impl<F, H, X> Advance<F, H, X> {
    pub(crate) fn new(flows: F, clock: Clock, steps: u64) -> Self {
        Self { flows, clock, steps, marker: PhantomData }
    }
}

impl<F: Flows<H>, H: Hamiltonian, X: Composition<H>> Kernel for Advance<F, H, X> {
    type Out = ();

    #[inline(always)]
    fn call(mut self) {
        let Clock { h, steps: mut step, .. } = self.clock;
        let end = step + self.steps;
        if const { H::PIECEWISE_IN_TIME } {
            return self.whole_steps(end);
        }
        if step == 0 && end > 0 {
            X::open(&mut self.flows, h, self.clock.at(0));
            step = 1;
        }
        if F::COMPENSATED {
            let leaps = Leaps::new(&X::STAGES, h);
            if !leaps.none() {
                while step < end {
                    X::cycle(&mut leaps.on(&mut self.flows, step), h, self.clock.at(step));
                    step += 1;
                }
            }
        }
        while step < end {
            X::cycle(&mut self.flows, h, self.clock.at(step));
            step += 1;
        }
    }
}

impl<F: Flows<H>, H: Hamiltonian, X: Composition<H>> Advance<F, H, X> {
    /// The same where a stage that is merged across steps would belong to two pieces: each step ends before the next one begins,
    /// with its own middle.
    #[inline(always)]
    fn whole_steps(mut self, end: u64) {
        let Clock { h, steps, .. } = self.clock;
        let leaps = Leaps::of_whole_steps(&X::STAGES, &X::PROCESSOR, h);
        for step in steps..end {
            if let Some(under_way) = step.checked_sub(1) {
                let time = self.clock.at(under_way);
                self.flows.begin_step(time + h / 2.0);
                X::close(&mut self.flows, h, time);
            }
            let time = self.clock.at(step);
            self.flows.begin_step(time + h / 2.0);
            if F::COMPENSATED {
                X::open(&mut leaps.on(&mut self.flows, step), h, time);
            } else {
                X::open(&mut self.flows, h, time);
            }
        }
    }
}

/// The end of the step under way: its last stages, or what undoes the processor behind them.
pub(crate) struct End<F, H, X, const SHOWN: bool> {
    flows: F,
    clock: Clock,
    marker: PhantomData<(fn(H), X)>,
}

impl<F, H, X, const SHOWN: bool> End<F, H, X, SHOWN> {
    pub(crate) fn new(flows: F, clock: Clock) -> Self {
        Self { flows, clock, marker: PhantomData }
    }
}

impl<F: Flows<H>, H: Hamiltonian, X: Composition<H>, const SHOWN: bool> Kernel for End<F, H, X, SHOWN> {
    type Out = ();

    #[inline(always)]
    fn call(mut self) {
        if let Some(under_way) = self.clock.steps.checked_sub(1) {
            let (h, time) = (self.clock.h, self.clock.at(under_way));
            if const { H::PIECEWISE_IN_TIME } {
                self.flows.begin_step(time + h / 2.0);
            }
            if SHOWN {
                X::show(&mut self.flows, h, time);
            } else {
                X::complete(&mut self.flows, h, time);
            }
        }
    }
}
