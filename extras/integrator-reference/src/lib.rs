//! Textbook methods that are not compositions, for comparison.
//!
//! In: the vector field `q' = ∂T/∂p`, `p' = -∂V/∂q` that `#[hamiltonian]` derives. Out: a [`Run`](integrator_core::Run) as for a
//! composition, with the same checks. Always true: the field is the increment of the generated flows for unit duration.
//! Methods hence share all code of a system, and none of the compositions.
//!
//! | method | order | symplectic | what it shows |
//! |---|---|---|---|
//! | [`ForwardEuler`] | 1 | no | energy grows, as with negative friction |
//! | [`BackwardEuler`] | 1 | no | energy decays, as with friction |
//! | [`StaggeredLeapfrog`] | 2 | yes | momenta at half steps; equivalent to Verlet |
//! | [`ExplicitMidpoint`] | 2 | no | same order as the leapfrog, but the energy drifts |
//! | [`ImplicitMidpoint`] | 2 | yes | symplectic without a splitting, at the cost of an implicit equation per step |
//! | [`GaussLegendre4`], [`GaussLegendre6`] | 4, 6 | yes | higher order, with two and three times the unknowns |
//! | [`RungeKutta4`] | 4 | no | the classical method |
//! | [`AdamsBashforth4`] | 4 | no | past forces instead of stages: one evaluation per step |
//! | [`AdamsBashforthMoulton4`] | 4 | no | predictor and corrector over past forces: two evaluations per step (PECE) |
//! | [`AdamsBashforthMoulton4Pec`] | 4 | no | the same with the predicted force: one evaluation per step (PEC) |
//! | [`Stoermer4`] | 4 | no | past accelerations in `q'' = a(q)`; with one of them it is the leapfrog |
//! | [`StoermerCowell4`] | 4 | no | predictor and corrector for `q'' = a(q)` (PECE) |
//! | [`GraggBulirschStoer`] | 8 | no | extrapolation of modified midpoint steps |
//! | [`DormandPrince5`], [`DormandPrince8`] | 5, 8 | no | step-size control by a tolerance |
//! | [`Bdf`] | 1 to 5 | no | backward differences for stiff systems (Gear) |
//!
//! `DormandPrince5`, `DormandPrince8` and `Bdf` call the crate `differential-equations`, which implements them for
//! plain vectors. They subdivide each step `h` of the run into steps of their own, and restart at the next step.
//!
//! [`Stoermer4`] and [`StoermerCowell4`] require `H = T(p) + V(q)` with `T` quadratic in `p`. All other methods accept
//! every Hamiltonian.
//!
//! [`AnyReference`] is a value of one type for the methods that accept every Hamiltonian. The Euler, midpoint and Gauss
//! methods with an implicit equation are not among them.
//!
//! The methods are made for comparison, not for speed: each evaluation of the field loads a state, and code exists for
//! the baseline instruction set only. Their work is counted in evaluations.
//!
//! ```
//! use integrator_core::{check::symplectic_defect, prelude::*};
//! use integrator_reference::RungeKutta4;
//!
//! struct Pendulum;
//!
//! #[hamiltonian]
//! impl Pendulum {
//!     fn kinetic(&self, p: [f64; 1]) -> f64 {
//!         0.5 * p[0] * p[0]
//!     }
//!     fn potential(&self, q: [f64; 1]) -> f64 {
//!         -q[0].cos()
//!     }
//! }
//!
//! let start = Phase::new([2.0_f64], [0.0]);
//! let mut run = Pendulum.run_with(RungeKutta4, start, 0.1)?;
//! let energy = run.energy();
//! run.advance(10_000)?;
//! assert!(run.energy() < energy - 1e-4, "it loses energy, and continues to lose it");
//! assert!(symplectic_defect(&Pendulum, RungeKutta4, start, 0.1)? > 1e-10); // rounding explains 1e-13
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

/// Facts of a method: those that are stated, and no others.
macro_rules! facts {
    ($($field:ident: $value:expr),* $(,)?) => {{
        let mut facts = integrator_core::Facts::UNCLAIMED;
        $(facts.$field = $value;)*
        facts
    }};
}

mod adaptive;
mod any;
mod extrapolation;
mod field;
mod leapfrog;
mod multistep;
mod runge_kutta;
mod stoermer;
mod walk;

pub use adaptive::{Bdf, DormandPrince5, DormandPrince8};
pub use any::AnyReference;
pub use extrapolation::GraggBulirschStoer;
pub use integrator_core::{__private::BackwardEuler, GaussLegendre4, GaussLegendre6, ImplicitMidpoint};
pub use leapfrog::StaggeredLeapfrog;
pub use multistep::{AdamsBashforth4, AdamsBashforthMoulton4, AdamsBashforthMoulton4Pec};
pub use runge_kutta::{ExplicitMidpoint, ForwardEuler, RungeKutta4};
pub use stoermer::{Stoermer4, StoermerCowell4};

use integrator_core::{
    __private::{Executor, Precision, QuadraticKinetic, Real, StepFunctions, System},
    Method,
};
use std::sync::Arc;
use walk::{Constants, Walked, step_functions};

/// Makes methods of recipes, for the Hamiltonians that have the trait in front.
macro_rules! methods {
    ($($bound:ident: $($method:ident)*;)*) => {$($(
        impl<H: $bound> Method<H> for $method {
            const CLONED: bool = false;

            type Constants = Constants<H::Parameters<f64>, Self>;
            type Motion<R: Real, K: Precision> = Walked<H, R, K, Self>;

            fn constants(self, parameters: Arc<H::Parameters<f64>>) -> Arc<Self::Constants> {
                Arc::new(Constants { parameters, recipe: self })
            }
            fn step_functions<R: Real, K: Precision, E: Executor>() -> StepFunctions<Self::Motion<R, K>> {
                step_functions::<H, R, K, Self>()
            }
        }
    )*)*};
}
methods! {
    System: ForwardEuler StaggeredLeapfrog ExplicitMidpoint RungeKutta4 AdamsBashforth4 AdamsBashforthMoulton4
        AdamsBashforthMoulton4Pec GraggBulirschStoer DormandPrince5 DormandPrince8 Bdf AnyReference;
    QuadraticKinetic: Stoermer4 StoermerCowell4;
}

/// The chapters of the guide that compare textbook methods, whose programs are tested here.
#[cfg(doctest)]
mod chapters {
    #[doc = include_str!("../../../docs/guide/src/for_teachers.md")]
    mod for_teachers {}
    #[doc = include_str!("../../../docs/guide/src/reference_methods.md")]
    mod reference_methods {}
}
