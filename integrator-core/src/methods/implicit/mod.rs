//! Implicit methods of Runge and Kutta: those of Gauss and Legendre, which are symplectic for every Hamiltonian.
//!
//! In: the vector field `q' = ∂H/∂p`, `p' = -∂H/∂q` that `#[hamiltonian]` derives, whatever H splits into. Out: steps
//! whose equation is solved to the rounding, or a typed error. Always true: a lane computes nothing of what stands in
//! another one, so that a member of an ensemble has the bits of its run alone.

mod backward;
pub(crate) mod field;
mod gauss_legendre;
mod gauss_legendre_table;
#[cfg(feature = "std")]
mod in_lanes;
mod iteration;
mod motion;
#[cfg(feature = "check")]
mod newton;
mod rated;
mod rows;
mod tableau;
#[cfg(feature = "check")]
mod without_contraction;

pub use backward::BackwardEuler;
pub use gauss_legendre::{GaussLegendre, GaussLegendre4, GaussLegendre6, ImplicitMidpoint};
pub use rated::RatedField;

use crate::{
    methods::pace::Paced,
    scalar::real::Real,
    state::precision::Precision,
    system::{Shaped, System},
    trajectory::{
        method::{Described, Differentiable, Memoryless, Method, Resumable},
        step_functions::{Executor, StepFunctions},
    },
};
use alloc::sync::Arc;
use field::OfTime;
use motion::Implicit;
use rated::OfRate;
use tableau::Stages;

/// A method that uses the whole vector field of `H` instead of the flows of parts.
#[diagnostic::on_unimplemented(
    message = "`{Self}` composes exact flows, and `split = none` leaves H in one piece",
    label = "not a method for H in one piece",
    note = "`ImplicitMidpoint` and `GaussLegendre<1>` to `GaussLegendre<8>` integrate H in one piece; compositions require \
            `split = a + b` or `split = symmetric(omega = 20.0)`"
)]
pub trait TakesWhole: Described + Default {}

/// The methods of Runge and Kutta with these stages, for all systems with a field.
macro_rules! implicit {
    ([$($generics:tt)*] $method:ty: $stages:tt stages of $tableau:ty, $system:ident by $field:ty) => {
        impl<H: $system, $($generics)*> Resumable<H> for $method where $tableau: Stages<$stages> {}

        #[diagnostic::do_not_recommend]
        impl<H: $system, $($generics)*> Method<H> for $method
        where
            $tableau: Stages<$stages>,
        {
            const WIDE: bool = H::WIDE || iteration::may_be_together::<$field, H>($stages);

            type Constants = H::Parameters<f64>;
            type Motion<R: Real, K: Precision> = Implicit<$field, R, Shaped<H, K>, H::Parameters<R>>;

            fn constants(self, parameters: Arc<H::Parameters<f64>>) -> Arc<H::Parameters<f64>> {
                parameters
            }
            fn step_functions<R: Real, K: Precision, E: Executor>() -> StepFunctions<Self::Motion<R, K>> {
                iteration::step_functions::<$field, H, R, K, E, $tableau, $stages>()
            }
        }
    };
}

implicit!([const S: usize] GaussLegendre<S>: S stages of Self, System by OfTime);
implicit!([] BackwardEuler: 1 stages of Self, System by OfTime);
implicit!([const S: usize] Paced<GaussLegendre<S>>: S stages of GaussLegendre<S>, RatedField by OfRate);

/// Methods whose steps are determined by the state.
macro_rules! memoryless {
    ([$($generics:tt)*] $method:ty: $stages:tt stages) => {
        impl<H: System, $($generics)*> Differentiable<H> for $method
        where
            Self: Stages<$stages>,
        {
            const FROM_STATES: bool = true;
        }

        #[diagnostic::do_not_recommend]
        impl<H: System, $($generics)*> Memoryless<H> for $method where Self: Stages<$stages> {}
    };
}

memoryless!([const S: usize] GaussLegendre<S>: S stages);
memoryless!([] BackwardEuler: 1 stages);

impl<H: RatedField, const S: usize> Differentiable<H> for Paced<GaussLegendre<S>> where GaussLegendre<S>: Stages<S> {}
