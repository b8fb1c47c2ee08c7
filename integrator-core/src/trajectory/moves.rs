//! What is done to the motion of one trajectory, compiled for a system, a composition and a scalar: the loop over steps, and
//! the end of the step under way.

use crate::{
    composition::{Composition, corrected_durations::Corrections},
    hamiltonian::{Flows, Hamiltonian, Single},
    layout::lattice::time_tiling::TimeTiling,
    scalar::real::{Kernel, Real},
    state::{clock::Clock, coords::Coords, precision::Precision},
    system::motion::Motion,
};
use core::marker::PhantomData;

/// What an engine does to its motion, compiled for one system, composition and scalar.
///
/// These are functions and not a type parameter: so the engine knows the motion's type alone, what is seldom called is
/// compiled once per motion, and a system that borrows its parameters can be run all the same.
pub struct Moves<M> {
    pub(crate) advance: fn(&mut M, Clock, u64, Option<usize>),
    /// Completes the step under way.
    pub(crate) complete: fn(&mut M, Clock),
    /// Makes of a completed step the state that is shown, where that differs.
    pub(crate) show: Option<fn(&mut M, Clock)>,
    /// Takes a motion a while into the step that begins at the other one and at the clock, where a method has dense output.
    /// It may stand anywhere in this step.
    pub(crate) dense: Option<fn(&mut M, &M, Clock, f64)>,
    /// How many threads may share a long lattice, if not all.
    pub(crate) threads: Option<usize>,
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
///
/// With `TILES`, lattices too long for the cache are swept in tiles; without, they are moved flow by flow, in less code.
pub(crate) fn moves<H: Hamiltonian, X: Composition<H>, R: Real, K: Precision, const TILES: bool>()
-> Moves<H::Motion<R, K>> {
    Moves {
        advance: |motion, clock, steps, threads| {
            if const { TILES && TimeTiling::<H, R, K>::ENABLED } {
                let mut flows = TimeTiling::<H, R, K>::new(motion, threads);
                Advance::<_, H, X>::new(&mut flows, clock, steps).call();
                flows.finish();
            } else {
                R::enter(Advance::<_, H, X>::new(Single::<H, R, K>(motion), clock, steps));
            }
        },
        complete: end::<H, X, R, K, TILES, false>,
        show: if const { X::PROCESSOR.after.rows.is_empty() } { None } else { Some(end::<H, X, R, K, TILES, true>) },
        dense: None,
        threads: Some(1),
    }
}

/// The end of the step under way: its last stages, or what undoes the processor behind them.
fn end<H: Hamiltonian, X: Composition<H>, R: Real, K: Precision, const TILES: bool, const SHOWN: bool>(
    motion: &mut H::Motion<R, K>,
    clock: Clock,
) {
    if const { TILES && TimeTiling::<H, R, K>::ENABLED } {
        let mut flows = TimeTiling::<H, R, K>::new(motion, Some(1));
        End::<_, H, X, SHOWN>::new(&mut flows, clock).call();
        flows.finish();
    } else {
        R::enter(End::<_, H, X, SHOWN>::new(Single::<H, R, K>(motion), clock));
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
            let corrections = Corrections::new(&X::STAGES, h);
            if !corrections.none() {
                while step < end {
                    X::cycle(&mut corrections.on(&mut self.flows, step), h, self.clock.at(step));
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
        let corrections = Corrections::of_whole_steps(&X::STAGES, &X::PROCESSOR, h);
        for step in steps..end {
            if let Some(under_way) = step.checked_sub(1) {
                let time = self.clock.at(under_way);
                self.flows.begin_step(time + h / 2.0);
                X::close(&mut self.flows, h, time);
            }
            let time = self.clock.at(step);
            self.flows.begin_step(time + h / 2.0);
            if F::COMPENSATED {
                X::open(&mut corrections.on(&mut self.flows, step), h, time);
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
