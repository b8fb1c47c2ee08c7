//! The methods, one row each.

use crate::{
    errors::{Exact, Rung, tolerances},
    measured::{Measured, measure},
    plan::Plan,
    problem::Problem,
};
use integrator_core::{
    prelude::*,
    reference::{
        AdamsBashforthMoulton4, BackwardEuler, Bdf, DormandPrince5, DormandPrince8, ExplicitMidpoint, ForwardEuler,
        GraggBulirschStoer, ImplicitMidpoint, RungeKutta4, StaggeredLeapfrog,
    },
};
use std::error::Error;

/// A method that chooses its own steps, with its errors.
pub(crate) struct Adaptive {
    pub(crate) name: &'static str,
    pub(crate) errors: Vec<Rung>,
}

/// Measures the methods that choose their own steps: over the whole time in one go, for all they begin anew with each step
/// of a run.
pub(crate) fn adaptive<H: Hamiltonian>(
    problem: &Problem<H>,
    plan: &Plan,
    exact: &Exact,
) -> Result<Vec<Adaptive>, Box<dyn Error>> {
    macro_rules! rows {
        ($($name:literal: $method:ident,)*) => {
            vec![$(Adaptive {
                name: $name,
                errors: tolerances(problem, |tolerance| $method { tolerance }, plan, exact)?,
            }),*]
        };
    }
    Ok(rows! {
        "Dormand–Prince 5": DormandPrince5,
        "Dormand–Prince 8": DormandPrince8,
        "backward differences": Bdf,
    })
}

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
