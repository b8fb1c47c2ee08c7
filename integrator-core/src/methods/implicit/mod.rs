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
mod rows;
mod tableau;
#[cfg(feature = "check")]
mod without_contraction;

pub use backward::BackwardEuler;
pub use gauss_legendre::{GaussLegendre, GaussLegendre4, GaussLegendre6, ImplicitMidpoint};

use crate::{
    scalar::real::Real,
    state::precision::Precision,
    system::{Shaped, System},
    trajectory::{
        method::{Described, Differentiable, Memoryless, Method, Resumable},
        step_functions::{Executor, StepFunctions},
    },
};
use alloc::sync::Arc;
use motion::Implicit;
use tableau::Stages;

/// A method that uses the whole vector field of `H` instead of the flows of parts.
#[diagnostic::on_unimplemented(
    message = "`{Self}` composes exact flows, and `split = none` leaves H in one piece",
    label = "not a method for H in one piece",
    note = "`ImplicitMidpoint` and `GaussLegendre<1>` to `GaussLegendre<8>` integrate H in one piece; compositions require \
            `split = a + b` or `split = symmetric(omega = 20.0)`"
)]
pub trait TakesWhole: Described + Default {}

/// The methods of Runge and Kutta with these stages, for every system.
macro_rules! implicit {
    ([$($generics:tt)*] $method:ty, $stages:tt stages) => {
        impl<H: System, $($generics)*> Resumable<H> for $method where Self: Stages<$stages> {}

        impl<H: System, $($generics)*> Differentiable<H> for $method
        where
            Self: Stages<$stages>,
        {
            const FROM_STATES: bool = true;
        }

        #[diagnostic::do_not_recommend]
        impl<H: System, $($generics)*> Memoryless<H> for $method where Self: Stages<$stages> {}

        #[diagnostic::do_not_recommend]
        impl<H: System, $($generics)*> Method<H> for $method
        where
            Self: Stages<$stages>,
        {
            const WIDE: bool = H::WIDE || iteration::may_be_together::<H>($stages);

            type Constants = H::Parameters<f64>;
            type Motion<R: Real, K: Precision> = Implicit<R, Shaped<H, K>, H::Parameters<R>>;

            fn constants(self, parameters: Arc<H::Parameters<f64>>) -> Arc<H::Parameters<f64>> {
                parameters
            }
            fn step_functions<R: Real, K: Precision, E: Executor>() -> StepFunctions<Self::Motion<R, K>> {
                StepFunctions::of_whole_steps(R::LANES, iteration::advance::<H, R, K, Self, $stages>, None)
            }
        }
    };
}

implicit!([const S: usize] GaussLegendre<S>, S stages);
implicit!([] BackwardEuler, 1 stages);
