//! Implicit methods of Runge and Kutta: those of Gauss, which are symplectic for every Hamiltonian.
//!
//! In: the vector field `q' = ∂H/∂p`, `p' = -∂H/∂q` that `#[hamiltonian]` derives, whatever H splits into. Out: steps
//! whose equation is solved to the rounding, or a typed error. Always true: a lane computes nothing of what stands in
//! another one, so that a member of an ensemble has the bits of its run alone.

macro_rules! implicit {
    ($($(#[$doc:meta])* $name:ident: order $order:literal, symmetric $symmetric:literal, stages $tableau:expr;)*) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, Default, PartialEq)]
        pub struct $name;

        impl Described for $name {
            fn facts(self) -> Facts {
                Facts {
                    name: stringify!($name),
                    order: $order,
                    symmetric: $symmetric,
                    symplectic: $symmetric,
                    stability_limit: Some(f64::INFINITY),
                    roundings: 16,
                    ..Facts::UNCLAIMED
                }
            }
        }

        #[diagnostic::do_not_recommend]
        impl TakesWhole for $name {}

        impl<H: System> Resumable<H> for $name {}

        impl<H: System> Differentiable<H> for $name {
            const FROM_STATES: bool = true;
        }

        #[diagnostic::do_not_recommend]
        impl<H: System> Memoryless<H> for $name {}

        #[diagnostic::do_not_recommend]
        impl<H: System> Method<H> for $name {
            type Constants = H::Parameters<f64>;
            type Motion<R: Real, K: Precision> = Implicit<R, Shaped<H, K>, H::Parameters<R>>;

            fn constants(self, parameters: Arc<H::Parameters<f64>>) -> Arc<H::Parameters<f64>> {
                parameters
            }
            fn step_functions<R: Real, K: Precision, E: Executor>() -> StepFunctions<Self::Motion<R, K>> {
                StepFunctions::of_whole_steps(R::LANES, iteration::advance::<H, R, K, Self, _>, None)
            }
        }

        impl tableau::Stages<{ $tableau.b.len() }> for $name {
            const TABLEAU: Tableau<{ $tableau.b.len() }> = $tableau;
        }
    )*};
}

mod backward;
pub(crate) mod field;
#[cfg(feature = "std")]
mod in_lanes;
mod iteration;
mod motion;
#[cfg(feature = "check")]
mod newton;
mod tableau;

pub use backward::BackwardEuler;

use crate::{
    scalar::real::Real,
    state::precision::Precision,
    system::{Shaped, System},
    trajectory::{
        method::{Described, Differentiable, Facts, Memoryless, Method, Resumable},
        step_functions::{Executor, StepFunctions},
    },
};
use alloc::sync::Arc;
use motion::Implicit;
use tableau::{GAUSS_4, GAUSS_6, Tableau, one_stage};

/// A method that uses the whole vector field of `H` instead of the flows of parts.
#[diagnostic::on_unimplemented(
    message = "`{Self}` composes exact flows, and `split = none` leaves H in one piece",
    label = "not a method for H in one piece",
    note = "`ImplicitMidpoint`, `GaussLegendre4` and `GaussLegendre6` integrate H in one piece; compositions require \
            `split = a + b` or `split = symmetric(omega = 20.0)`"
)]
pub trait TakesWhole: Described + Default {}

implicit! {
    /// The implicit midpoint rule, `y' = y + h f((y + y')/2)`.
    ///
    /// It is symplectic for every Hamiltonian, separable or not, and conserves every quadratic first integral, such as the
    /// energy of a harmonic oscillator.
    ImplicitMidpoint: order 2, symmetric true, stages one_stage(0.5);
    /// The Gauss–Legendre method with two stages, symplectic for every Hamiltonian, separable or not.
    GaussLegendre4: order 4, symmetric true, stages GAUSS_4;
    /// The Gauss–Legendre method with three stages, symplectic for every Hamiltonian, separable or not.
    GaussLegendre6: order 6, symmetric true, stages GAUSS_6;
}
