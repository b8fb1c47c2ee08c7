//! Any composition as one method, for checks that go through the whole catalogue.

use crate::{
    composition::{Processor, Scheme, Stages, corrected_durations::Between},
    error::Unsolved,
    scalar::real::Real,
    state::{coords::Coords, phase::Phase, precision::Precision},
    system::{
        QuadraticKinetic, System,
        counts::Counts,
        flows::Flows,
        motion::{Found, Motion},
    },
    trajectory::{
        by_table::{
            Kicks,
            letters::Table,
            walk::{Portion, walk},
        },
        method::{Described, Facts, Method},
        step_functions::{Executor, StepFunctions, all_finite},
    },
};
use alloc::{sync::Arc, vec::Vec};
use core::marker::PhantomData;

/// A composition as a method with its table as a value; `G` says whether it has kicks with force gradients.
pub(crate) struct ByTable<G> {
    facts: Facts,
    stages: Stages,
    processor: Processor,
    inner_steps: Option<u32>,
    gradients: PhantomData<G>,
}

/// Kicks with force gradients beside them.
pub(crate) struct WithGradients;

impl<G> ByTable<G> {
    /// Creates the method of this composition. It has to be one for the system that it is run with.
    pub(crate) fn of<X: Scheme>(composition: X) -> Self {
        Self::new(composition.facts(), X::STAGES, X::PROCESSOR, None)
    }

    /// Creates the method of these stages, with a number of inner steps or with that of the annotation.
    pub(crate) fn new(facts: Facts, stages: Stages, processor: Processor, inner_steps: Option<u32>) -> Self {
        Self { facts, stages, processor, inner_steps, gradients: PhantomData }
    }

    /// The same composition with other stages in the middle of a run.
    #[cfg(test)]
    pub(crate) fn with_cycle(self, cycle: &'static [crate::composition::Stage]) -> Self {
        Self { stages: Stages { cycle, ..self.stages }, ..self }
    }
}

impl<G> Clone for ByTable<G> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<G> Copy for ByTable<G> {}

impl<G: Send + Sync + 'static> Described for ByTable<G> {
    fn facts(self) -> Facts {
        self.facts
    }
}

impl<H: QuadraticKinetic> Kicks<H> for WithGradients {
    const GRADIENTS: bool = true;
    #[inline(always)]
    fn gradient_kick(flows: &mut impl Flows<H>, duration: f64, gradient: f64, time: f64) {
        flows.gradient_kick(duration, gradient, time);
    }
}

impl<H: System, G: Kicks<H>> Method<H> for ByTable<G> {
    type Constants = Constants<H::Parameters<f64>>;
    type Motion<R: Real, K: Precision> = Tabled<H::Motion<R, K>>;

    fn constants(self, mut parameters: Arc<H::Parameters<f64>>) -> Arc<Self::Constants> {
        if let Some(steps) = self.inner_steps {
            H::set_inner_steps(Arc::make_mut(&mut parameters), steps as usize);
        }
        let table = Table { stages: self.stages, processor: self.processor, between: Between::of::<H>() };
        Arc::new(Constants { parameters, table })
    }
    fn step_functions<R: Real, K: Precision, E: Executor>() -> StepFunctions<Self::Motion<R, K>> {
        StepFunctions {
            lanes: R::LANES,
            together: 1,
            advance: |motions, clock, steps, threads| {
                for motion in motions {
                    walk::<H, G, R, K, E>(&mut motion.motion, motion.table, clock, Portion::Steps(steps), threads);
                }
            },
            complete: |motion, clock, threads| {
                walk::<H, G, R, K, E>(&mut motion.motion, motion.table, clock, Portion::Closing, threads);
            },
            show: Some(|motion, clock| {
                walk::<H, G, R, K, E>(&mut motion.motion, motion.table, clock, Portion::Undoing, Some(1));
            }),
            finite: all_finite,
            dense: None,
            energy: None,
            #[cfg(feature = "check")]
            squares: None,
        }
    }
}

/// The constants of a system with the flows of a composition.
pub(crate) struct Constants<P> {
    parameters: Arc<P>,
    table: Table,
}

/// A motion of the system with the flows of a composition.
#[derive(Clone)]
pub(crate) struct Tabled<M> {
    motion: M,
    table: Table,
}

impl<M> Tabled<M> {
    fn new<P>(constants: &[&Constants<P>], load: impl FnOnce(&[&P]) -> M) -> Self {
        let parameters: Vec<&P> = constants.iter().map(|constants| &*constants.parameters).collect();
        Self { motion: load(&parameters), table: constants[0].table }
    }
}

impl<C: Coords, P: Send + Sync + 'static, M: Motion<C, P>> Motion<C, Constants<P>> for Tabled<M> {
    const MIXES: bool = M::MIXES;

    fn load(constants: &[&Constants<P>], states: &[&Phase<C>]) -> Self {
        Self::new(constants, |parameters| M::load(parameters, states))
    }
    fn load_own(constants: &[&Constants<P>], states: &[&Phase<C>]) -> Self {
        Self::new(constants, |parameters| M::load_own(parameters, states))
    }
    fn gathered<'a>(of_lane: &dyn Fn(usize) -> (&'a Constants<P>, &'a Self, usize)) -> Option<Self>
    where
        P: 'a,
    {
        let motion = M::gathered(&|lane| {
            let (constants, tabled, lane) = of_lane(lane);
            (&*constants.parameters, &tabled.motion, lane)
        })?;
        Some(Self { motion, table: of_lane(0).0.table })
    }
    fn store(&self, lane: usize, to: &mut Phase<C>) {
        self.motion.store(lane, to);
    }
    fn store_own(&self, lane: usize, to: &mut Phase<C>) {
        self.motion.store_own(lane, to);
    }
    fn copy_state(&mut self, from: &Self) {
        self.motion.copy_state(&from.motion);
    }
    fn copy_state_on(&mut self, from: &Self, threads: Option<usize>) {
        self.motion.copy_state_on(&from.motion, threads);
    }
    fn found(&self) -> Option<Found> {
        self.motion.found()
    }
    fn use_found(&mut self, found: &Found) {
        self.motion.use_found(found);
    }
    fn share_among(&mut self, threads: Option<usize>) {
        self.motion.share_among(threads);
    }
    fn unsolved(&self, lane: usize) -> Option<&Unsolved> {
        self.motion.unsolved(lane)
    }
    fn counts(&self) -> Option<Counts> {
        self.motion.counts()
    }
    fn finite(&self) -> bool {
        self.motion.finite()
    }
    fn finite_on(&self, threads: Option<usize>) -> bool {
        self.motion.finite_on(threads)
    }
}
