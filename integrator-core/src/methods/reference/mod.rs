//! Methods that are no compositions, to compare with: what a course in numerical integration goes through.
//!
//! In: the vector field `q' = ∂T/∂p`, `p' = -∂V/∂q` that `#[hamiltonian]` derives. Out: the same [`Run`](crate::Run) as
//! that of a composition, and the same checks. Always true: the field is taken from the generated flows, as what a flow
//! of unit duration adds, so that the methods share all of a system and nothing of the compositions.
//!
//! | method | order | symplectic | what it shows |
//! |---|---|---|---|
//! | [`ForwardEuler`] | 1 | no | energies grow, as if friction were negative |
//! | [`BackwardEuler`] | 1 | no | energies decay, as if there were friction |
//! | [`StaggeredLeapfrog`] | 2 | yes | momenta at half steps: Verlet in another dress |
//! | [`ExplicitMidpoint`] | 2 | no | of the order of the leapfrog, and yet energies drift |
//! | [`ImplicitMidpoint`] | 2 | yes | symplectic without a splitting, for the price of an equation per step |
//! | [`GaussLegendre4`], [`GaussLegendre6`] | 4, 6 | yes | the same of higher order, for two and three times the unknowns |
//! | [`RungeKutta4`] | 4 | no | the classical one |
//! | [`AdamsBashforth4`] | 4 | no | past forces in place of stages: one force a step |
//! | [`AdamsBashforthMoulton4`] | 4 | no | a predictor and a corrector over past forces, at two forces a step (PECE) |
//! | [`AdamsBashforthMoulton4Pec`] | 4 | no | the same, remembering the predicted force: one a step (PEC) |
//! | [`Stoermer4`] | 4 | no | past forces in `q'' = a(q)`: with one of them it would be the leapfrog |
//! | [`StoermerCowell4`] | 4 | no | a predictor and a corrector of the same kind (PECE) |
//! | [`GraggBulirschStoer`] | 8 | no | extrapolation of modified midpoint steps |
//! | [`DormandPrince5`], [`DormandPrince8`] | 5, 8 | no | steps chosen by a tolerance |
//! | [`Bdf`] | 1 to 5 | no | backward differences for stiff systems (Gear) |
//!
//! The last three come from the crate `differential-equations`, which has all of them on plain vectors; they cover each
//! step `h` of the run by steps of their own, and begin anew with the next.
//!
//! [`Stoermer4`] and [`StoermerCowell4`] ask for `H = T(p) + V(q)` with `T` quadratic in `p`, all others for no more than a Hamiltonian.
//!
//! [`AnyReference`] is any of these others but the implicit ones, as a value of one type.
//!
//! They are made to be compared with and not to be fast: each evaluation of the field loads a motion, and there is code
//! for the baseline of the target alone. Their work is counted in evaluations.
//!
//! ```
//! use integrator_core::{check::symplectic_defect, prelude::*, reference::RungeKutta4};
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
//! assert!(run.energy() < energy - 1e-4, "it loses energy, and goes on to lose it");
//! assert!(symplectic_defect(&Pendulum, RungeKutta4, start, 0.1)? > 1e-10); // rounding explains 1e-13
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod adaptive;
mod any;
mod extrapolation;
mod field;
mod leapfrog;
mod multistep;
mod runge_kutta;
mod stoermer;
mod walk;

pub use super::implicit::{BackwardEuler, GaussLegendre4, GaussLegendre6, ImplicitMidpoint};
pub use adaptive::{Bdf, DormandPrince5, DormandPrince8};
pub use any::AnyReference;
pub use extrapolation::GraggBulirschStoer;
pub use leapfrog::StaggeredLeapfrog;
pub use multistep::{AdamsBashforth4, AdamsBashforthMoulton4, AdamsBashforthMoulton4Pec};
pub use runge_kutta::{ExplicitMidpoint, ForwardEuler, RungeKutta4};
pub use stoermer::{Stoermer4, StoermerCowell4};

use crate::{
    hamiltonian::Hamiltonian,
    scalar::real::Real,
    state::precision::Precision,
    trajectory::{
        method::Method,
        step_functions::{Executor, StepFunctions},
    },
};
use std::sync::Arc;
use walk::{Constants, Walked, step_functions};

macro_rules! methods {
    ($($method:ident)*) => {$(
        impl<H: Hamiltonian> Method<H> for $method {
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
    )*};
}
methods! {
    ForwardEuler StaggeredLeapfrog ExplicitMidpoint RungeKutta4 AdamsBashforth4 AdamsBashforthMoulton4
    AdamsBashforthMoulton4Pec GraggBulirschStoer DormandPrince5 DormandPrince8 Bdf AnyReference
}
