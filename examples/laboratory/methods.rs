//! The methods, one row each.

use crate::{
    errors::Exact,
    measured::{Measured, measure},
    plan::Plan,
    problem::Problem,
};
use integrator_core::{
    prelude::*,
    reference::{
        AdamsBashforthMoulton4, BackwardEuler, ExplicitMidpoint, ForwardEuler, GraggBulirschStoer, ImplicitMidpoint,
        RungeKutta4, StaggeredLeapfrog,
    },
};
use std::error::Error;

/// Measures every method on a problem.
pub(crate) fn all<H: Hamiltonian>(
    problem: &Problem<H>,
    plan: &Plan,
    exact: &Exact,
) -> Result<Vec<Measured>, Box<dyn Error>> {
    macro_rules! rows {
        ($($name:literal: $method:expr,)*) => { vec![$(measure($name, $method, problem, plan, exact)?),*] };
    }
    Ok(rows! {
        "forward Euler": ForwardEuler,
        "backward Euler": BackwardEuler,
        "symplectic Euler": Euler,
        "leapfrog": StaggeredLeapfrog,
        "Verlet": Verlet,
        "explicit midpoint": ExplicitMidpoint,
        "implicit midpoint": ImplicitMidpoint,
        "Runge–Kutta 4": RungeKutta4,
        "Adams–Bashforth–Moulton 4": AdamsBashforthMoulton4,
        "Gragg–Bulirsch–Stoer": GraggBulirschStoer,
        "Yoshida 4": Yoshida4,
        "Blanes–Moan 6": BlanesMoan6,
        "Kahan–Li 8": KahanLi8,
    })
}
