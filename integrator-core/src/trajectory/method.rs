//! Methods that advance runs: compositions, and methods that use the vector field only.
//!
//! A method defines a motion, which holds the state, and the step functions that advance it. The motion of a composition
//! is that of the system.

use crate::{
    composition::{Composition, Processor, Scheme, Stages, flow_counts::PartFlows, inner_steps::Composed},
    error::Error,
    scalar::real::Real,
    state::precision::Precision,
    system::{Shaped, System, motion::Motion},
    trajectory::step_functions::{Executor, StepFunctions, of_composition},
};
use alloc::sync::Arc;

/// The properties that a method claims, whatever it integrates.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Facts {
    /// The name of the method.
    pub name: &'static str,
    /// The order: the global error is proportional to this power of the step.
    pub order: u32,
    /// The generalised orders, [`Scheme::GENERALISED_ORDERS`]; empty if the method claims none.
    pub generalised_orders: &'static [u32],
    /// Whether a step by `-h` undoes a step by `h`.
    pub symmetric: bool,
    /// Whether steps preserve the symplectic form for every step size.
    ///
    /// Measurements cannot distinguish a symplectic step from a very accurate one, so the method declares it.
    pub symplectic: bool,
    /// Whether the method divides a step of the run into internal steps, so that a tolerance determines the error.
    pub adaptive: bool,
    /// Force evaluations per step, if the number is constant.
    pub forces: Option<usize>,
    /// The smallest `h·ω` at which the step is unstable for a harmonic oscillator, if known.
    pub stability_limit: Option<f64>,
    /// The approximate number of times that a step rounds the state.
    pub roundings: usize,
    /// Whether it applies friction, and whether for a negative duration.
    pub(crate) friction: bool,
    pub(crate) negative_friction: bool,
    /// The name of the composition that it is over, where it is none itself.
    pub(crate) over: Option<&'static str>,
    /// The number of innermost steps of a step, and the stability limit of one, if a part of H takes inner steps.
    pub(crate) innermost: Option<(f64, f64)>,
    /// The stages of a composition.
    pub(crate) table: Option<(Stages, Processor)>,
    /// The number of inner steps that replaces that of the annotation.
    pub(crate) chosen_inner_steps: Option<u32>,
}

impl Facts {
    /// The facts of a method that claims nothing.
    pub const UNCLAIMED: Self = Self {
        name: "",
        order: 0,
        generalised_orders: &[],
        symmetric: false,
        symplectic: false,
        adaptive: false,
        forces: None,
        stability_limit: None,
        roundings: 0,
        friction: false,
        negative_friction: false,
        over: None,
        innermost: None,
        table: None,
        chosen_inner_steps: None,
    };

    /// The number of roundings of the state in this number of steps, as a double, which no number of steps exceeds.
    #[cfg(feature = "check")]
    pub(crate) fn roundings_in(&self, steps: u64) -> f64 {
        self.roundings as f64 * steps as f64
    }
}

/// A method with properties that do not depend on the Hamiltonian.
pub trait Described: Copy + Send + Sync + 'static {
    /// Returns the properties of this method.
    fn facts(self) -> Facts;

    /// Checks the parameters of the method, such as a tolerance.
    ///
    /// # Errors
    /// The tolerance is not a positive number.
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

/// A method that can integrate `H`.
///
/// These are the compositions that support `H`, implicit methods, methods with step-size control, the methods of the
/// crate `integrator-reference`, and [`Taylor`](crate::taylor::Taylor) for a system with `#[hamiltonian(taylor)]`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot integrate `{H}`",
    label = "neither a composition nor a method for this Hamiltonian",
    note = "`Verlet`, `Yoshida4` and all other compositions of general class integrate every separable Hamiltonian",
    note = "`composition! {{ pub struct Mine: order 2 = T(1/2) V(1) T(1/2); }}` declares a new composition",
    note = "compositions with friction, such as `Baoab`, require `#[friction] fn friction(&self, i: usize) -> f64`",
    note = "`Verlet.nested(8)` requires parts that take inner steps, `split = slow + 8 * (bonds + kinetic)`",
    note = "`GaussLegendre::<S>` requires `S` from 1 to 8",
    note = "`Taylor` requires `#[hamiltonian(taylor)]`, which generates its recurrences",
    note = "`Paced` and `Logarithmic` require H = T(p) + V(q) without explicit time; `Paced` also requires `fn \
            rate(&self, q: ...) -> f64`",
    note = "`Paced(GaussLegendre::<8>)` is for other H without explicit time, with `fn rate`",
    note = "`Stoermer4` and `StoermerCowell4` require a T that is quadratic in p with constant masses"
)]
pub trait Method<H: System>: Described {
    /// Whether steps are compiled for several instruction sets, of which a run uses the best available.
    const CLONED: bool = true;
    /// Whether a single run uses AVX-512 if the machine has it.
    const WIDE: bool = H::WIDE;

    /// Returns the force evaluations per step, if the number is constant.
    ///
    /// [`Facts::forces`] assumes stages that are merged across steps, which [`System::PIECEWISE_IN_TIME`] prevents.
    fn forces(self) -> Option<usize> {
        if H::PIECEWISE_IN_TIME { None } else { self.facts().forces }
    }
    /// Returns what determines how often a step applies the flow of each part of `H`, if the method composes flows.
    fn flows(self) -> Option<PartFlows> {
        None
    }
    /// Returns the properties that the method claims for this Hamiltonian.
    fn claims(self) -> Facts {
        self.facts()
    }
    /// The constants of a run.
    type Constants: Send + Sync + 'static;
    /// The state of a run and its constants.
    type Motion<R: Real, K: Precision>: Motion<Shaped<H, K>, Self::Constants>;

    /// Returns the constants of a run, computed from those of the system.
    fn constants(self, parameters: Arc<H::Parameters<f64>>) -> Arc<Self::Constants>;
    /// Returns the step functions for a scalar type, a precision and an executor.
    fn step_functions<R: Real, K: Precision, E: Executor>() -> StepFunctions<Self::Motion<R, K>>;
}

impl<H: System, X: Scheme + Composition<H>> Method<H> for X {
    fn forces(self) -> Option<usize> {
        if const { !H::NESTED.is_empty() } {
            return Some(PartFlows::of::<H, X>(None).of_last_part() as usize);
        }
        if H::PIECEWISE_IN_TIME { Some(X::STAGES.forces(&X::PROCESSOR) as usize) } else { self.facts().forces }
    }
    fn flows(self) -> Option<PartFlows> {
        const { Some(PartFlows::of::<H, X>(None)) }
    }
    fn claims(self) -> Facts {
        let mut facts = self.facts();
        if const { !H::NESTED.is_empty() } {
            return with_inner_steps::<H, X>(facts, None);
        }
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

/// The facts of a composition of a system whose last part takes inner steps, as many as these or those of the annotation.
pub(crate) fn with_inner_steps<H: System, X: Scheme>(facts: Facts, steps: Option<u32>) -> Facts {
    let Composed { order, symmetric, roundings, innermost, stability_limit } = Composed::of::<H, X>(steps);
    Facts {
        order,
        symmetric,
        roundings,
        generalised_orders: &[],
        forces: None,
        stability_limit: Some(core::f64::consts::PI),
        innermost: Some((innermost, stability_limit)),
        ..facts
    }
}

/// A method whose runs can be resumed from a checkpoint: compositions, implicit methods, and those with a fictitious time.
#[diagnostic::on_unimplemented(
    message = "a run with `{Self}` cannot be resumed from a checkpoint",
    label = "neither a composition for this Hamiltonian nor a method with checkpoints",
    note = "compositions, `ImplicitMidpoint`, Gauss methods, `Logarithmic`, `Power` and `Paced` support checkpoints",
    note = "a method with memory, such as `Taylor`, restarts from `state()`"
)]
pub trait Resumable<H: System>: Method<H> {}

impl<H: System, X: Scheme + Composition<H>> Resumable<H> for X {}

/// A method that integrates deviation vectors together with the state.
///
/// These are compositions, implicit methods, methods with a fictitious time, and [`Taylor`](crate::taylor::Taylor).
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no tangent map for `{H}`",
    label = "neither a composition for this Hamiltonian nor a method with deviation vectors",
    note = "compositions, `ImplicitMidpoint`, Gauss methods, `Logarithmic`, `Power`, `Paced` and `Taylor` integrate \
            deviation vectors"
)]
pub trait Differentiable<H: System>: Method<H> {
    /// Whether a run depends on its state and vectors only, so that vectors can be rescaled by powers of two.
    const FROM_STATES: bool = false;
    /// Whether steps are those of the table in [`Facts`], without force gradients.
    const IS_PLAIN_TABLE: bool = false;
}

impl<H: System, X: Scheme + Composition<H>> Differentiable<H> for X {
    const FROM_STATES: bool = true;
    const IS_PLAIN_TABLE: bool = X::GRADIENT_EVALUATIONS == 0;
}

/// A method whose runs depend on positions and momenta only: compositions and implicit methods.
///
/// `compose = ...` of `#[hamiltonian]` accepts these methods.
#[diagnostic::on_unimplemented(
    message = "the composition `{Self}` cannot integrate `{H}`",
    label = "not a composition for this Hamiltonian",
    note = "`Verlet`, `Yoshida4` and all other compositions of general class integrate every separable Hamiltonian",
    note = "`composition! {{ pub struct Mine: order 2 = T(1/2) V(1) T(1/2); }}` declares a new composition",
    note = "compositions with friction, such as `Baoab`, require `#[friction] fn friction(&self, i: usize) -> f64`"
)]
pub trait Memoryless<H: System>: Resumable<H> + Differentiable<H> + Default {}

impl<H: System, X: Scheme + Composition<H>> Memoryless<H> for X {}
