//! Runs with a number of inner steps that is chosen at run time.

#[cfg(feature = "std")]
use crate::trajectory::in_lanes::{InLanes, ResumableInLanes};
use crate::{
    composition::{
        Composition,
        flow_counts::PartFlows,
        inner_steps::{Nested, WithInnerSteps},
    },
    error::Error,
    scalar::real::Real,
    state::precision::Precision,
    trajectory::{
        method::{Described, Differentiable, Facts, Method, Resumable, with_inner_steps},
        step_functions::{Executor, StepFunctions},
    },
};
use alloc::sync::Arc;

impl<X: Described> Described for WithInnerSteps<X> {
    fn facts(self) -> Facts {
        Facts { chosen_inner_steps: Some(self.steps), ..self.composition.facts() }
    }
    fn admissible(self) -> Result<(), Error> {
        if self.steps == 0 { Err(Error::InnerSteps) } else { Ok(()) }
    }
}

#[diagnostic::do_not_recommend]
impl<H: Nested<0>, X: Composition<H>> Method<H> for WithInnerSteps<X> {
    type Constants = H::Parameters<f64>;
    type Motion<R: Real, K: Precision> = H::Motion<R, K>;

    fn forces(self) -> Option<usize> {
        Method::<H>::flows(self).map(|flows| flows.of_last_part() as usize)
    }
    fn flows(self) -> Option<PartFlows> {
        Some(PartFlows::of::<H, X>(Some(self.steps)))
    }
    fn claims(self) -> Facts {
        with_inner_steps::<H, X>(self.facts(), Some(self.steps))
    }
    fn constants(self, mut parameters: Arc<H::Parameters<f64>>) -> Arc<H::Parameters<f64>> {
        H::set_inner_steps(Arc::make_mut(&mut parameters), self.steps as usize);
        parameters
    }
    fn step_functions<R: Real, K: Precision, E: Executor>() -> StepFunctions<H::Motion<R, K>> {
        X::step_functions::<R, K, E>()
    }
}

impl<H: Nested<0>, X: Composition<H>> Resumable<H> for WithInnerSteps<X> {}

impl<H: Nested<0>, X: Composition<H>> Differentiable<H> for WithInnerSteps<X> {
    const FROM_STATES: bool = true;
}

#[cfg(feature = "std")]
impl<H: Nested<0>, X: Composition<H>> InLanes<H> for WithInnerSteps<X> {}

#[cfg(feature = "std")]
impl<H: Nested<0>, X: Composition<H>> ResumableInLanes<H> for WithInnerSteps<X> {}
