//! Methods that advance runs: compositions, and those that know the vector field alone.
//!
//! A method has a motion that a start is loaded into, and the step functions that advance it. Every composition is
//! a method, whose motion is that of the system.

use crate::{
    composition::{Composition, Processor, Scheme, Stages},
    error::Error,
    hamiltonian::{Hamiltonian, Shaped},
    scalar::real::Real,
    state::precision::Precision,
    system::motion::Motion,
    trajectory::step_functions::{Executor, StepFunctions, of_composition},
};
use alloc::sync::Arc;

/// The properties that a method claims, whatever it integrates.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Facts {
    /// Its name.
    pub name: &'static str,
    /// With which power of the step its errors fall.
    pub order: u32,
    /// The powers of the step with which the parts of an error fall that are of the first, second, ... power of the size of H's second
    /// part: [`Scheme::GENERALISED_ORDERS`]. Empty where none are claimed.
    pub generalised_orders: &'static [u32],
    /// Whether a step by `-h` undoes a step by `h`.
    pub symmetric: bool,
    /// Whether steps preserve the symplectic form, whatever their size. An accurate step that does not is hard to tell
    /// from one that does, so that a method has to say it.
    pub symplectic: bool,
    /// Whether it covers a step of the run by steps of its own, so that errors follow a tolerance and not the step.
    pub adaptive: bool,
    /// How often a step evaluates the force, where that is known beforehand.
    pub forces: Option<usize>,
    /// The `h·ω` from which a step is unstable on a harmonic oscillator, where that is known.
    pub stability_limit: Option<f64>,
    /// How often a step rounds the state, about.
    pub(crate) roundings: usize,
    /// The name of the composition that it is over, where it is none itself.
    pub(crate) over: Option<&'static str>,
    /// The stages of a composition.
    pub(crate) table: Option<(Stages, Processor)>,
}

impl Facts {
    /// Those of a method that claims nothing.
    pub(crate) const UNCLAIMED: Self = Self {
        name: "",
        order: 0,
        generalised_orders: &[],
        symmetric: false,
        symplectic: false,
        adaptive: false,
        forces: None,
        stability_limit: None,
        roundings: 0,
        over: None,
        table: None,
    };

    /// The number of roundings of the state in so many steps, as a double, which no number of steps exceeds.
    #[cfg(feature = "check")]
    pub(crate) fn roundings_in(&self, steps: u64) -> f64 {
        self.roundings as f64 * steps as f64
    }
}

/// A method with its properties, whatever it integrates.
pub trait Described: Copy + Send + Sync + 'static {
    /// The properties of this method.
    fn facts(self) -> Facts;

    /// Whether its own parameters, such as a tolerance, make sense.
    ///
    /// # Errors
    /// A tolerance that is not a positive number.
    fn admissible(self) -> Result<(), Error> {
        Ok(())
    }
}

impl<X: Scheme> Described for X {
    fn facts(self) -> Facts {
        let rows = X::PROCESSOR.before.rows.len() + X::STAGES.cycle.len() + X::PROCESSOR.after.rows.len();
        Facts {
            name: X::NAME,
            order: X::ORDER,
            generalised_orders: if X::GENERALISED_ORDERS.len() > 1 { X::GENERALISED_ORDERS } else { &[] },
            symmetric: X::SYMMETRIC,
            symplectic: true,
            forces: Some(X::FORCE_EVALUATIONS + X::GRADIENT_EVALUATIONS),
            stability_limit: Some(X::STABILITY_LIMIT),
            // Each row moves positions and momenta once, and the closing flow one of them.
            roundings: 2 * rows + 1,
            table: Some((X::STAGES, X::PROCESSOR)),
            ..Facts::UNCLAIMED
        }
    }
}

/// A method that may integrate `H`: any composition that may, those of `reference`, and
/// [`Taylor`](crate::taylor::Taylor) where the system has its recurrences.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a method that may integrate `{H}`",
    label = "neither a composition nor another method for this Hamiltonian",
    note = "`Verlet`, `Yoshida4` and all other compositions of general class integrate every separable Hamiltonian",
    note = "a new one is declared with `composition! {{ pub struct Mine: order 2 = T(1/2) V(1) T(1/2); }}`",
    note = "`Taylor` needs recurrences, which are only written where they are asked for: `#[hamiltonian(taylor)]`",
    note = "`Paced` and `Logarithmic` need H = T(p) + V(q) that does not read the time, and `Paced` a `fn rate(&self, q: ...) -> f64` beside it",
    note = "`Stoermer4` and `StoermerCowell4` need a T that is quadratic in p, with a constant mass"
)]
pub trait Method<H: Hamiltonian>: Described {
    /// Whether its steps are compiled for several instruction sets, of which a run takes the best.
    const CLONED: bool = true;
    /// Whether a single run takes instructions for vectors of 512 bits, where the machine has them.
    const WIDE: bool = H::WIDE;

    /// How often a step evaluates the force, where that is known beforehand: [`Facts`] tell it of steps that go on
    /// where the last one ended, which those of systems with pieces in time do not.
    fn forces(self) -> Option<usize> {
        if H::PIECEWISE_IN_TIME { None } else { self.facts().forces }
    }
    /// What it claims of this Hamiltonian.
    fn claims(self) -> Facts {
        self.facts()
    }
    /// The constants of a run.
    type Constants: Send + Sync + 'static;
    /// The state of a run with its constants, in a layout.
    type Motion<R: Real, K: Precision>: Motion<Shaped<H, K>, Self::Constants>;

    /// The constants of a run, from those of the system.
    fn constants(self, parameters: Arc<H::Parameters<f64>>) -> Arc<Self::Constants>;
    /// The steps, compiled for one scalar, leaf and executor.
    fn step_functions<R: Real, K: Precision, E: Executor>() -> StepFunctions<Self::Motion<R, K>>;
}

impl<H: Hamiltonian, X: Scheme + Composition<H>> Method<H> for X {
    fn forces(self) -> Option<usize> {
        if H::PIECEWISE_IN_TIME { Some(X::STAGES.forces(&X::PROCESSOR)) } else { self.facts().forces }
    }
    fn claims(self) -> Facts {
        let mut facts = self.facts();
        if const { H::COPIES } {
            (facts.symmetric, facts.symplectic, facts.stability_limit) = (false, false, None);
        }
        facts
    }
    type Constants = H::Parameters<f64>;
    type Motion<R: Real, K: Precision> = H::Motion<R, K>;

    fn constants(self, parameters: Arc<H::Parameters<f64>>) -> Arc<H::Parameters<f64>> {
        parameters
    }
    fn step_functions<R: Real, K: Precision, E: Executor>() -> StepFunctions<H::Motion<R, K>> {
        of_composition::<H, X, R, K, E>()
    }
}

/// A method whose checkpoints hold all that its runs go on from: any composition, implicit methods, and those with a time of
/// their own.
#[diagnostic::on_unimplemented(
    message = "no run by `{Self}` goes on from a checkpoint",
    label = "neither a composition for this Hamiltonian, nor another method whose checkpoints hold all of a run",
    note = "compositions, `ImplicitMidpoint` and the methods of Gauss, `Logarithmic`, `Power` and `Paced` do",
    note = "steps with a memory, such as those of `Taylor`, begin anew from `state()`"
)]
pub trait Resumable<H: Hamiltonian>: Method<H> {}

impl<H: Hamiltonian, X: Scheme + Composition<H>> Resumable<H> for X {}

/// A method whose steps have derivatives along deviation vectors: any composition, implicit methods, those with a time of
/// their own, and [`Taylor`](crate::taylor::Taylor) at the steps that it takes.
#[diagnostic::on_unimplemented(
    message = "steps of `{H}` by `{Self}` have no derivatives here",
    label = "neither a composition for this Hamiltonian, nor another method that carries deviation vectors",
    note = "compositions, `ImplicitMidpoint` and the methods of Gauss, `Logarithmic`, `Power`, `Paced` and `Taylor` do"
)]
pub trait Differentiable<H: Hamiltonian>: Method<H> {
    /// Whether a run goes on from its state and its vectors alone, so that these may be divided by powers of two.
    const FROM_STATES: bool = false;
}

impl<H: Hamiltonian, X: Scheme + Composition<H>> Differentiable<H> for X {
    const FROM_STATES: bool = true;
}

/// A method that goes on from positions and momenta alone: any composition, and implicit methods. An annotation may name it.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a composition that may integrate `{H}`",
    label = "not a composition for this Hamiltonian",
    note = "`Verlet`, `Yoshida4` and all other compositions of general class integrate every separable Hamiltonian",
    note = "a new one is declared with `composition! {{ pub struct Mine: order 2 = T(1/2) V(1) T(1/2); }}`"
)]
pub trait Memoryless<H: Hamiltonian>: Resumable<H> + Differentiable<H> + Default {}

impl<H: Hamiltonian, X: Scheme + Composition<H>> Memoryless<H> for X {}
