//! Steps with a compensated state, for measurements that rounding would drown.
//!
//! Always true: one scalar is all that they are compiled for, and none of the bookkeeping of a run.

use crate::{
    check::start::Start,
    error::Error,
    hamiltonian::Hamiltonian,
    state::{
        clock::Clock,
        compensated::Compensated,
        coords::Coords,
        flat::{Flat, flat},
        phase::Phase,
    },
    system::{Shaped, motion::Motion},
    trajectory::{admissible::admissible_with, method::Method, step_functions::FlowByFlow},
};
use std::sync::Arc;

/// The steps of a method from a start, whose state carries the rounding error of every update.
pub(crate) struct CompensatedSteps<H: Hamiltonian, X: Method<H>> {
    method: X,
    constants: Arc<X::Constants>,
    start: Phase<Shaped<H, Compensated<f64>>>,
    motion: X::Motion<f64, Compensated<f64>>,
    state: Phase<Shaped<H, Compensated<f64>>>,
    clock: Clock,
}

impl<H: Hamiltonian, X: Method<H>> CompensatedSteps<H, X> {
    /// # Errors
    /// A start or a step that no run would begin with.
    pub(crate) fn new(system: &H, method: X, Start { phase, time }: Start<H::Coords>, h: f64) -> Result<Self, Error> {
        admissible_with::<H, _>(method, &phase, h)?;
        let constants = method.constants(Arc::new(system.parameters(phase.q.length())));
        let start = Phase::compensated(phase.q, phase.p);
        Ok(Self::begin(method, constants, start, Clock { t0: time, h, steps: 0 }))
    }

    fn begin(method: X, constants: Arc<X::Constants>, start: Phase<Shaped<H, Compensated<f64>>>, clock: Clock) -> Self {
        let motion = X::Motion::<f64, Compensated<f64>>::load(&[&*constants], &[&start]);
        Self { method, constants, motion, state: start.clone(), start, clock }
    }

    /// Takes `steps` steps.
    ///
    /// # Errors
    /// The errors are those of a run: steps that the clock does not resolve, and states that are not finite.
    pub(crate) fn advance(&mut self, steps: u64) -> Result<Flat, Error> {
        self.clock.end(steps)?;
        if self.take(steps) { Ok(flat(&self.state)) } else { Err(self.divergence()) }
    }

    /// Takes `steps` steps and completes the last one on a copy; whether the state is finite.
    fn take(&mut self, steps: u64) -> bool {
        let functions = X::step_functions::<f64, Compensated<f64>, FlowByFlow>();
        functions.advance_one(&mut self.motion, self.clock, steps);
        self.clock.steps += steps;
        let shown = functions.shown(self.motion.clone(), self.clock);
        shown.store(0, &mut self.state);
        shown.finite()
    }

    /// The divergence of the first step whose state is not finite.
    fn divergence(&self) -> Error {
        let clock = Clock { steps: 0, ..self.clock };
        let mut again = Self::begin(self.method, self.constants.clone(), self.start.clone(), clock);
        let mut last = again.state.clone();
        while again.clock.steps < self.clock.steps && again.take(1) {
            last.clone_from(&again.state);
        }
        let step = again.clock.steps;
        let before = Clock { steps: step.saturating_sub(1), ..clock };
        match again.motion.unsolved(0) {
            Some(reason) => Error::NotSolved {
                method: self.method.facts().name,
                step,
                time: before.at(before.steps),
                reason: reason.clone(),
            },
            None => before.divergence(&last, &again.state).into(),
        }
    }
}
