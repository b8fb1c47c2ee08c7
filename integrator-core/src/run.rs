//! One trajectory: integer time, stages merged across steps, stopped where it leaves the finite numbers.

use crate::{
    composition::Composition,
    coords::Coords,
    error::{Divergence, Error},
    hamiltonian::{Hamiltonian, Motion, Shaped, Single},
    instruction_set::InstructionSet,
    phase::Phase,
    real::{Kernel, Real},
    samples::Samples,
    slot::Keep,
};
use std::{fmt, marker::PhantomData, sync::Arc};

/// How many steps lie between two looks at whether the state is finite. A divergence replays at most so many.
const BLOCK: u64 = 1024;

/// Time as an integer number of steps: `t0 + n·h`, never an accumulated sum.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Clock {
    t0: f64,
    h: f64,
    steps: u64,
}

impl Clock {
    fn at(&self, steps: u64) -> f64 {
        self.t0 + steps as f64 * self.h
    }
}

/// Whether a run may begin at `start` with step `h`.
///
/// # Errors
/// A step that is zero or not finite; a start that is not finite or whose `q` and `p` differ in length.
pub(crate) fn admissible<C: Coords>(start: &Phase<C>, h: f64) -> Result<(), Error> {
    if h == 0.0 || !h.is_finite() {
        return Err(Error::Step { h });
    }
    let (positions, momenta) = (start.q.flat().len(), start.p.flat().len());
    if positions != momenta {
        return Err(Error::Length { positions, momenta });
    }
    for (coordinate, values) in [("q", start.q.flat()), ("p", start.p.flat())] {
        let values = values.iter().map(|leaf| leaf.to_f64());
        if let Some((index, value)) = values.enumerate().find(|(_, value)| !value.is_finite()) {
            return Err(Error::Start { coordinate, index, value });
        }
    }
    Ok(())
}

/// A trajectory under way, made by [`Hamiltonian::run`]. Its type names the coordinates alone, so it can be stored.
pub struct Run<C: Coords> {
    engine: Box<dyn Engine<C>>,
    clock: Clock,
    composition: &'static str,
}

impl<C: Coords> Run<C> {
    pub(crate) fn start<H, X, K>(system: &H, start: Phase<C>, h: f64) -> Result<Self, Error>
    where
        H: Hamiltonian,
        X: Composition<H>,
        K: Keep,
        H::Coords: Coords<With<K> = C>,
    {
        admissible(&start, h)?;
        let engine: Box<dyn Engine<C>> = match InstructionSet::chosen() {
            InstructionSet::Baseline => Box::new(Solo::<H, X, K::Plain, K>::new(system, start)),
            InstructionSet::Fused => Box::new(Solo::<H, X, K::Fused, K>::new(system, start)),
        };
        Ok(Self { engine, clock: Clock { t0: 0.0, h, steps: 0 }, composition: X::NAME })
    }

    /// Starts the clock at `t0` instead of 0. A `t0` that is not finite is reported by the first `advance`.
    #[must_use]
    pub fn at_time(mut self, t0: f64) -> Self {
        self.clock.t0 = t0;
        self
    }

    /// Takes `steps` steps. In any portions, the result is the same bit for bit.
    ///
    /// # Errors
    /// [`Error::Diverged`] if the state leaves the finite numbers; the run then stays at the last finite state, and
    /// [`Run::time`] and [`Run::state`] tell it. [`Error::Time`] and [`Error::Steps`] leave the run as it was.
    pub fn advance(&mut self, steps: u64) -> Result<(), Error> {
        if !self.clock.t0.is_finite() {
            return Err(Error::Time { time: self.clock.t0 });
        }
        let done = self.clock.steps;
        let end = done.checked_add(steps).ok_or(Error::Steps { done, asked: steps })?;
        while self.clock.steps < end {
            let block = BLOCK.min(end - self.clock.steps);
            let taken = self.engine.advance(self.clock, block);
            self.clock.steps += taken;
            if taken < block {
                return Err(self.divergence().into());
            }
        }
        Ok(())
    }

    fn divergence(&self) -> Divergence {
        let Phase { q, p } = self.state();
        let flat = |coordinates: C| coordinates.flat().iter().map(|leaf| leaf.to_f64()).collect();
        let step = self.clock.steps.saturating_add(1);
        Divergence { step, time: self.clock.at(step), q: flat(q), p: flat(p) }
    }

    /// The time, `t0 + n·h`.
    pub fn time(&self) -> f64 {
        self.clock.at(self.clock.steps)
    }

    /// The step `h`.
    pub fn step(&self) -> f64 {
        self.clock.h
    }

    /// How many steps were taken.
    pub fn steps(&self) -> u64 {
        self.clock.steps
    }

    /// The state at [`Run::time`]: the step under way is completed on a copy, the run itself does not change.
    pub fn state(&self) -> Phase<C> {
        self.engine.state(self.clock)
    }

    /// The energy `T + V` at [`Run::time`].
    pub fn energy(&self) -> f64 {
        self.engine.energies().energy(&self.state(), self.time())
    }

    /// An iterator over the present state and then the state after every `interval` steps.
    pub fn samples(self, interval: u64) -> Samples<C> {
        Samples::new(self, interval)
    }

    pub(crate) fn energies(&self) -> Arc<dyn Energies<C>> {
        self.engine.energies()
    }
}

impl<C: Coords> Clone for Run<C> {
    fn clone(&self) -> Self {
        Self { engine: self.engine.boxed_clone(), ..*self }
    }
}

impl<C: Coords> fmt::Debug for Run<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Run")
            .field("composition", &self.composition)
            .field("step", &self.clock.h)
            .field("steps", &self.clock.steps)
            .field("time", &self.time())
            .field("state", &self.state())
            .finish()
    }
}

/// A run without its clock, behind one type whatever system, composition and scalar it was made of.
trait Engine<C: Coords>: Send + Sync {
    /// Takes `steps` steps from `clock`, or as many as end in a finite state, and returns how many.
    fn advance(&mut self, clock: Clock, steps: u64) -> u64;
    fn state(&self, clock: Clock) -> Phase<C>;
    fn energies(&self) -> Arc<dyn Energies<C>>;
    fn boxed_clone(&self) -> Box<dyn Engine<C>>;
}

/// What tells the energy of a state without holding the run.
pub(crate) trait Energies<C: Coords>: Send + Sync {
    fn energy(&self, state: &Phase<C>, time: f64) -> f64;
}

/// The engine of one trajectory.
struct Solo<H: Hamiltonian, X, R: Real, K: Keep> {
    motion: H::Motion<R, K>,
    /// The motion at the last look that found it finite; kept here so that no block allocates.
    snapshot: H::Motion<R, K>,
    /// Where a step is completed to see whether its state is finite.
    closed: H::Motion<R, K>,
    energies: Arc<Constants<H, R, K>>,
    /// A state to write into: it knows the size where the type does not.
    shape: Phase<Shaped<H, K>>,
    marker: PhantomData<X>,
}

impl<H: Hamiltonian, X: Composition<H>, R: Real, K: Keep> Solo<H, X, R, K> {
    fn new(system: &H, start: Phase<Shaped<H, K>>) -> Self {
        let parameters = system.parameters(start.q.length());
        let motion = H::Motion::<R, K>::load(|_| (&parameters, &start));
        Self {
            snapshot: motion.clone(),
            closed: motion.clone(),
            motion,
            energies: Arc::new(Constants { parameters, marker: PhantomData }),
            shape: start,
            marker: PhantomData,
        }
    }

    /// Whether the state after `steps` steps is finite: the motion, and what completing the step makes of it.
    fn finite_after(&mut self, clock: Clock, steps: u64) -> bool {
        if !self.motion.finite() {
            return false;
        }
        let clock = Clock { steps: clock.steps + steps, ..clock };
        self.closed.clone_from(&self.motion);
        R::enter(Close::<H, X, R, K> { motion: &mut self.closed, clock, marker: PhantomData });
        self.closed.finite()
    }
}

impl<H: Hamiltonian, X: Composition<H>, R: Real, K: Keep> Engine<Shaped<H, K>> for Solo<H, X, R, K> {
    fn advance(&mut self, clock: Clock, steps: u64) -> u64 {
        self.snapshot.clone_from(&self.motion);
        R::enter(Advance::<H, X, R, K> { motion: &mut self.motion, clock, steps, marker: PhantomData });
        if self.finite_after(clock, steps) {
            return steps;
        }
        // What left the finite numbers never returns, since updates only add: replay the block step by step.
        self.motion.clone_from(&self.snapshot);
        for taken in 0..steps {
            let clock = Clock { steps: clock.steps + taken, ..clock };
            R::enter(Advance::<H, X, R, K> { motion: &mut self.motion, clock, steps: 1, marker: PhantomData });
            if !self.finite_after(clock, 1) {
                self.motion.clone_from(&self.snapshot);
                return taken;
            }
            self.snapshot.clone_from(&self.motion);
        }
        steps
    }

    fn state(&self, clock: Clock) -> Phase<Shaped<H, K>> {
        let mut motion = self.motion.clone();
        R::enter(Close::<H, X, R, K> { motion: &mut motion, clock, marker: PhantomData });
        let mut state = self.shape.clone();
        motion.store(0, &mut state);
        state
    }

    fn energies(&self) -> Arc<dyn Energies<Shaped<H, K>>> {
        self.energies.clone()
    }

    fn boxed_clone(&self) -> Box<dyn Engine<Shaped<H, K>>> {
        Box::new(Self {
            motion: self.motion.clone(),
            snapshot: self.snapshot.clone(),
            closed: self.closed.clone(),
            energies: self.energies.clone(),
            shape: self.shape.clone(),
            marker: PhantomData,
        })
    }
}

/// The n-step loop.
struct Advance<'m, H: Hamiltonian, X, R: Real, K: Keep> {
    motion: &'m mut H::Motion<R, K>,
    clock: Clock,
    steps: u64,
    marker: PhantomData<X>,
}

impl<H: Hamiltonian, X: Composition<H>, R: Real, K: Keep> Kernel for Advance<'_, H, X, R, K> {
    type Out = ();

    #[inline(always)]
    fn call(self) {
        let mut flows = Single::<H, R, K>(self.motion);
        let Clock { h, steps: mut step, .. } = self.clock;
        let end = step + self.steps;
        if step == 0 && end > 0 {
            X::open(&mut flows, h, self.clock.at(0));
            step = 1;
        }
        while step < end {
            X::cycle(&mut flows, h, self.clock.at(step));
            step += 1;
        }
    }
}

/// The end of the step under way.
struct Close<'m, H: Hamiltonian, X, R: Real, K: Keep> {
    motion: &'m mut H::Motion<R, K>,
    clock: Clock,
    marker: PhantomData<X>,
}

impl<H: Hamiltonian, X: Composition<H>, R: Real, K: Keep> Kernel for Close<'_, H, X, R, K> {
    type Out = ();

    #[inline(always)]
    fn call(self) {
        if let Some(under_way) = self.clock.steps.checked_sub(1) {
            X::close(&mut Single::<H, R, K>(self.motion), self.clock.h, self.clock.at(under_way));
        }
    }
}

/// Prepared constants, from which the energy of any state can be told.
struct Constants<H: Hamiltonian, R, K> {
    parameters: H::Parameters<f64>,
    marker: PhantomData<(R, K)>,
}

impl<H: Hamiltonian, R: Real, K: Keep> Energies<Shaped<H, K>> for Constants<H, R, K> {
    fn energy(&self, state: &Phase<Shaped<H, K>>, time: f64) -> f64 {
        let motion = H::Motion::<R, K>::load(|_| (&self.parameters, state));
        R::enter(Energy::<H, R, K> { motion: &motion, time })
    }
}

struct Energy<'m, H: Hamiltonian, R: Real, K: Keep> {
    motion: &'m H::Motion<R, K>,
    time: f64,
}

impl<H: Hamiltonian, R: Real, K: Keep> Kernel for Energy<'_, H, R, K> {
    type Out = f64;

    #[inline(always)]
    fn call(self) -> f64 {
        (H::kinetic::<R, K>(self.motion, self.time) + H::potential::<R, K>(self.motion, self.time)).lane(0)
    }
}
