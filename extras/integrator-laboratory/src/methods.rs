//! The methods, each with its row.

use crate::{
    admitted::{by_taylor, of_second_order, with_gradients},
    errors::{Exact, Rung, tolerances},
    measured::{Measured, energies, measure},
    modified::{self, Modified},
    plan::Plan,
    problem::Problem,
    rows::{self, Row},
};
use integrator_core::prelude::*;
use integrator_reference::{
    AdamsBashforth4, AdamsBashforthMoulton4, AdamsBashforthMoulton4Pec, AnyReference, BackwardEuler, Bdf,
    DormandPrince5, DormandPrince8, ExplicitMidpoint, ForwardEuler, GaussLegendre4, GaussLegendre6, GraggBulirschStoer,
    ImplicitMidpoint, RungeKutta4, StaggeredLeapfrog,
};
use std::error::Error;

/// A method that chooses its own steps.
#[derive(Clone, Debug)]
pub(crate) struct Adaptive {
    pub(crate) row: Row,
    pub(crate) errors: Vec<Rung>,
    /// Periods, and the change of the energy in units of the largest kinetic energy, with the tolerance [`LOOSE`].
    pub(crate) energies: Vec<(f64, f64)>,
}

/// The tolerance with which energies of methods that choose their steps are followed.
pub(crate) const LOOSE: f64 = 1e-4;

/// Measures the methods that choose their own steps: over the whole time in one go, for all they begin again with each
/// step of a run.
pub(crate) fn adaptive<H: Hamiltonian>(
    problem: &Problem<'_, H>,
    plan: &Plan,
    exact: &Exact,
) -> Result<Vec<Adaptive>, Box<dyn Error>> {
    macro_rules! rows {
        ($($row:ident $method:ident;)*) => {
            vec![$({
                let of = |tolerance| problem.by(AnyReference::from($method { tolerance: exact.tolerance(tolerance) }));
                Adaptive {
                    row: rows::$row,
                    errors: tolerances(problem, &of, plan, exact)?,
                    energies: energies(problem, &*of(LOOSE), plan, exact)?,
                }
            }),*]
        };
    }
    let mut rows = rows! {
        DORMAND_PRINCE_5 DormandPrince5;
        DORMAND_PRINCE_8 DormandPrince8;
        BACKWARD_DIFFERENCES Bdf;
    };
    rows.extend(by_taylor(problem, plan, exact)?);
    Ok(rows)
}

/// Measures every method on a problem.
pub(crate) fn all<H: Hamiltonian>(
    problem: &Problem<'_, H>,
    plan: &Plan,
    exact: &Exact,
) -> Result<Vec<Measured>, Box<dyn Error>> {
    macro_rules! rows {
        ($($row:ident $method:expr;)*) => {
            vec![$(measure(rows::$row, &*problem.by($method), problem, plan, exact)?),*]
        };
    }
    let mut rows = rows! {
        FORWARD_EULER AnyReference::from(ForwardEuler);
        BACKWARD_EULER BackwardEuler;
        SYMPLECTIC_EULER Euler;
        LEAPFROG AnyReference::from(StaggeredLeapfrog);
        VERLET Verlet;
        EXPLICIT_MIDPOINT AnyReference::from(ExplicitMidpoint);
        IMPLICIT_MIDPOINT ImplicitMidpoint;
        GAUSS_LEGENDRE_4 GaussLegendre4;
        GAUSS_LEGENDRE_6 GaussLegendre6;
        RUNGE_KUTTA_4 AnyReference::from(RungeKutta4);
        ADAMS_BASHFORTH_4 AnyReference::from(AdamsBashforth4);
        ADAMS_BASHFORTH_MOULTON_4 AnyReference::from(AdamsBashforthMoulton4);
        ADAMS_PEC_4 AnyReference::from(AdamsBashforthMoulton4Pec);
    };
    rows.extend(of_second_order(problem, plan, exact)?);
    rows.extend(rows! {
        GRAGG_BULIRSCH_STOER AnyReference::from(GraggBulirschStoer);
        YOSHIDA_4 Yoshida4;
        BLANES_MOAN_6 BlanesMoan6;
        KAHAN_LI_8 KahanLi8;
    });
    rows.extend(with_gradients(problem, plan, exact)?);
    Ok(rows)
}

/// Measures what the compositions conserve whose modified Hamiltonian has terms up to the fourth power of the step.
pub(crate) fn modified<H: Hamiltonian>(
    problem: &Problem<'_, H>,
    plan: &Plan,
    exact: &Exact,
    methods: &[Measured],
) -> Vec<Modified> {
    macro_rules! rows {
        ($($name:literal $method:ident;)*) => {
            [$(methods
                .iter()
                .find(|measured| measured.name() == $name)
                .and_then(|measured| modified::modified(measured.row, $method, problem, plan, exact))),*]
        };
    }
    let rows = rows! {
        "symplectic Euler" Euler;
        "Verlet" Verlet;
        "Yoshida 4" Yoshida4;
    };
    rows.into_iter().flatten().collect()
}
