//! The methods of Gauss and Legendre.

use super::{
    TakesWhole, gauss_legendre_table as table,
    tableau::{Stages, Tableau, gauss_legendre},
};
use crate::trajectory::method::{Described, Facts};

/// The Gauss–Legendre method with `S` stages, of order `2 S`, for `S` from 1 to 8.
///
/// It is symplectic for every Hamiltonian, separable or not, and conserves every quadratic first integral. Its coefficients are
/// symplectic in floating-point arithmetic, not only up to rounding. For H in one piece (`split = none`), which does not depend
/// on the time, the stages are computed together in vector lanes.
///
/// A step of high order may be long: for this double pendulum, a step of 0.17 has a global error of 1e-10 after 200 time units.
///
/// ```
/// use integrator_core::{GaussLegendre, prelude::*};
///
/// struct DoublePendulum;
///
/// #[hamiltonian(split = none, compose = GaussLegendre<8>)]
/// impl DoublePendulum {
///     fn hamiltonian(&self, [a, b]: [f64; 2], [pa, pb]: [f64; 2]) -> f64 {
///         let (sine, cosine) = (a - b).sin_cos();
///         (pa * pa + 2.0 * pb * pb - 2.0 * pa * pb * cosine) / (2.0 * (1.0 + sine * sine)) - 2.0 * a.cos() - b.cos()
///     }
/// }
///
/// let mut run = DoublePendulum.run(Phase::new([1.0, -0.5], [0.2, 0.3]), 0.1)?;
/// let energy = run.energy();
/// run.advance(2_000)?;
/// assert!((run.energy() - energy).abs() < 1e-12);
/// # Ok::<(), Error>(())
/// ```
///
/// Source: Hairer, Lubich and Wanner, Geometric Numerical Integration (2006), II.1.3; for the coefficients Antoñana, Makazaga and
/// Murua 2017, Numerical Algorithms 76, 861.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct GaussLegendre<const S: usize>;

/// The implicit midpoint rule, `y' = y + h f((y + y')/2)`: the Gauss–Legendre method with one stage.
pub type ImplicitMidpoint = GaussLegendre<1>;

/// The Gauss–Legendre method with two stages.
pub type GaussLegendre4 = GaussLegendre<2>;

/// The Gauss–Legendre method with three stages.
pub type GaussLegendre6 = GaussLegendre<3>;

/// The value of each name, since an alias of a type has none.
macro_rules! values {
    ($($name:ident)*) => {$(
        #[allow(non_upper_case_globals, reason = "a method is written as its type")]
        #[doc(hidden)]
        pub const $name: $name = GaussLegendre;
    )*};
}
values!(ImplicitMidpoint GaussLegendre4 GaussLegendre6);

/// The names by the number of stages.
const NAMES: [&str; 9] = [
    "GaussLegendre<0>",
    "ImplicitMidpoint",
    "GaussLegendre4",
    "GaussLegendre6",
    "GaussLegendre<4>",
    "GaussLegendre<5>",
    "GaussLegendre<6>",
    "GaussLegendre<7>",
    "GaussLegendre<8>",
];

impl<const S: usize> Described for GaussLegendre<S> {
    fn facts(self) -> Facts {
        Facts {
            name: NAMES.get(S).copied().unwrap_or("GaussLegendre"),
            order: 2 * S as u32,
            symmetric: true,
            symplectic: true,
            stability_limit: Some(f64::INFINITY),
            roundings: 16,
            ..Facts::UNCLAIMED
        }
    }
}

#[diagnostic::do_not_recommend]
impl<const S: usize> TakesWhole for GaussLegendre<S> where Self: Stages<S> {}

macro_rules! tables {
    ($($stages:literal $table:ident;)*) => {$(
        impl Stages<$stages> for GaussLegendre<$stages> {
            const TABLEAU: Tableau<$stages> = gauss_legendre(&table::$table);
        }
    )*};
}
tables! {
    1 STAGES_1;
    2 STAGES_2;
    3 STAGES_3;
    4 STAGES_4;
    5 STAGES_5;
    6 STAGES_6;
    7 STAGES_7;
    8 STAGES_8;
}
