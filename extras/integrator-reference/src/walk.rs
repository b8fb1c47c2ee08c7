//! A motion that advances by increments of the whole state.

use crate::field::{Field, Generated};
use integrator_core::{
    __private::{Clock, Counts, Motion, Precision, Real, Shaped, Slot, StepFunctions, System},
    Coords, Described, Phase, Unsolved,
};
use std::sync::Arc;

/// The recipe of a step: the increment of the whole state.
pub trait Recipe: Described {
    /// The memory of the method from step to step, beside the state.
    type Memory<R: Real>: Clone + Default + Send + Sync + 'static;

    /// Returns the increment of the state in a step.
    ///
    /// # Errors
    /// An end of the step that was not found.
    fn increment<R: Real>(self, memory: &mut Self::Memory<R>, from: &Place<'_, R>) -> Result<Vec<R>, Unsolved>;
}

/// The beginning of a step: the field, the state and the time.
pub struct Place<'f, R> {
    /// The field.
    pub(crate) field: &'f dyn Field<R>,
    /// Positions, then momenta.
    pub(crate) y: &'f [R],
    /// The time at the beginning of the step.
    pub(crate) time: f64,
    /// The length of the step.
    pub(crate) h: f64,
}

impl<R: Real> Place<'_, R> {
    /// The field at the beginning of the step.
    pub(crate) fn derivative(&self) -> Vec<R> {
        self.field.derivative(self.y, self.time)
    }

    /// The state, moved.
    pub(crate) fn moved(&self, increment: &[R]) -> Vec<R> {
        self.y.iter().zip(increment).map(|(y, d)| *y + *d).collect()
    }
}

/// A linear combination of lists, scaled.
pub(crate) fn combined<R: Real>(scale: f64, terms: &[(f64, &[R])]) -> Vec<R> {
    let length = terms.first().map_or(0, |(_, list)| list.len());
    let sum = |i: usize| terms.iter().fold(R::of(0.0), |sum, (factor, list)| sum + R::of(*factor) * list[i]);
    (0..length).map(|i| R::of(scale) * sum(i)).collect()
}

/// The constants of a run: the parameters of the system, and the method.
pub struct Constants<P, M> {
    /// The parameters of the system.
    pub(crate) parameters: Arc<P>,
    /// The method.
    pub(crate) recipe: M,
}

/// State and memory of a run.
#[derive(Clone)]
pub struct Walk<R: Real, C: Coords, P, M: Recipe> {
    parameters: Arc<P>,
    recipe: M,
    /// A point that has the shape of the coordinates.
    shape: Phase<C::With<f64>>,
    q: Vec<<C::Leaf as Precision>::Slot<R>>,
    p: Vec<<C::Leaf as Precision>::Slot<R>>,
    memory: M::Memory<R>,
    unsolved: Option<Unsolved>,
    /// The number of evaluations of the field.
    evaluations: u64,
}

impl<R: Real, C: Coords, P: Clone + Send + Sync + 'static, M: Recipe> Motion<C, Constants<P, M>> for Walk<R, C, P, M> {
    fn load(constants: &[&Constants<P, M>], states: &[&Phase<C>]) -> Self {
        let (constants, start) = (constants[0], states[0]);
        Self {
            parameters: constants.parameters.clone(),
            recipe: constants.recipe,
            shape: Phase { q: start.q.map(Precision::to_f64), p: start.p.map(Precision::to_f64) },
            q: C::listed(states, |state| &state.q),
            p: C::listed(states, |state| &state.p),
            memory: M::Memory::default(),
            unsolved: None,
            evaluations: 0,
        }
    }
    fn store(&self, lane: usize, to: &mut Phase<C>) {
        to.q.unlisted(&self.q, lane);
        to.p.unlisted(&self.p, lane);
    }
    fn copy_state(&mut self, from: &Self) {
        self.q.clone_from(&from.q);
        self.p.clone_from(&from.p);
        self.memory.clone_from(&from.memory);
        self.unsolved.clone_from(&from.unsolved);
        self.evaluations = from.evaluations;
    }
    fn unsolved(&self, _lane: usize) -> Option<&Unsolved> {
        self.unsolved.as_ref()
    }
    fn counts(&self) -> Option<Counts> {
        Some(Counts::of_evaluations(self.evaluations))
    }
    fn finite(&self) -> bool {
        self.unsolved.is_none() && self.q.iter().chain(&self.p).all(|slot| slot.value().finite())
    }
}

/// The motion of a method for a system.
pub(crate) type Walked<H, R, K, M> = Walk<R, Shaped<H, K>, <H as System>::Parameters<f64>, M>;

/// The step functions of a method.
pub(crate) fn step_functions<H: System, R: Real, K: Precision, M: Recipe>() -> StepFunctions<Walked<H, R, K, M>> {
    let advance = |walks: &mut [_], clock, steps, _| {
        for walk in walks {
            advance::<H, R, K, M>(walk, clock, steps);
        }
    };
    StepFunctions::of_whole_steps(R::LANES, advance, None)
}

/// Takes steps. An end that was not found is remembered, and no step is taken from there.
fn advance<H: System, R: Real, K: Precision, M: Recipe>(walk: &mut Walked<H, R, K, M>, clock: Clock, steps: u64) {
    for step in clock.steps..clock.steps + steps {
        if walk.unsolved.is_some() {
            return;
        }
        let Walk { parameters, recipe, shape, q, p, memory, unsolved, evaluations } = walk;
        if H::PIECEWISE_IN_TIME {
            // What a method remembers is of another formula where a piece ends.
            *memory = M::Memory::default();
        }
        let y: Vec<R> = q.iter().chain(p.iter()).map(|slot| slot.value()).collect();
        let (time, h) = (clock.at(step), clock.h);
        let field = Generated::<H> { parameters, shape, middle: time + h / 2.0, evaluations: (*evaluations).into() };
        let from = Place { field: &field, y: &y, time, h };
        match recipe.increment(memory, &from) {
            Ok(increment) => q.iter_mut().chain(p).zip(increment).for_each(|(slot, d)| slot.add(d)),
            Err(reason) => *unsolved = Some(reason),
        }
        *evaluations = field.evaluations.get();
    }
}
