//! Methods for some Hamiltonians only: those for second-order equations and with force gradients for quadratic `T`, and
//! Taylor's method if there are recurrences. They are not compiled for other Hamiltonians.

use crate::{
    errors::{Exact, tolerances},
    measured::{Measured, energies, measure},
    methods::{Adaptive, LOOSE},
    plan::Plan,
    problem::Problem,
    rows,
};
use integrator_core::{QuadraticKinetic, RecurrencesVisitor, Visitor, prelude::*, taylor::Recurrences};
use integrator_reference::{Stoermer4, StoermerCowell4};
use std::error::Error;

/// A system, the requested methods, and their results.
struct Asked<'a, 's, H: Hamiltonian, Found> {
    problem: &'a Problem<'s, H>,
    plan: &'a Plan,
    exact: &'a Exact,
    second_order: bool,
    found: Result<Vec<Found>, Box<dyn Error>>,
}

impl<H: Hamiltonian> Visitor<H> for Asked<'_, '_, H, Measured> {
    fn visit<X: Composition<H>>(&mut self, _: X) {}

    fn admit_gradients(&mut self)
    where
        H: QuadraticKinetic,
    {
        let Self { problem, plan, exact, .. } = *self;
        let mut methods = Vec::new();
        if !self.second_order {
            methods.push((rows::CHIN_4A, problem.by(Chin4A)));
        } else if H::SEPARABLE {
            methods.push((rows::STOERMER_4, problem.by(Stoermer4)));
            methods.push((rows::STOERMER_COWELL_4, problem.by(StoermerCowell4)));
        }
        let measured = methods.into_iter().map(|(row, method)| measure(row, &*method, problem, plan, exact));
        self.found = measured.collect();
    }
}

fn admitted<H: Hamiltonian>(
    problem: &Problem<'_, H>,
    plan: &Plan,
    exact: &Exact,
    second_order: bool,
) -> Result<Vec<Measured>, Box<dyn Error>> {
    let mut asked = Asked { problem, plan, exact, second_order, found: Ok(Vec::new()) };
    H::visit_compositions(&mut asked);
    asked.found
}

/// Multistep methods of `q'' = a(q)`, where H is of that form.
pub(crate) fn of_second_order<H: Hamiltonian>(
    problem: &Problem<'_, H>,
    plan: &Plan,
    exact: &Exact,
) -> Result<Vec<Measured>, Box<dyn Error>> {
    admitted(problem, plan, exact, true)
}

/// A composition with a force gradient, where `H` admits one.
pub(crate) fn with_gradients<H: Hamiltonian>(
    problem: &Problem<'_, H>,
    plan: &Plan,
    exact: &Exact,
) -> Result<Vec<Measured>, Box<dyn Error>> {
    admitted(problem, plan, exact, false)
}

impl<H: Hamiltonian> RecurrencesVisitor<H> for Asked<'_, '_, H, Adaptive> {
    fn visit(&mut self)
    where
        H: Recurrences,
    {
        let Self { problem, plan, exact, .. } = *self;
        let of = |tolerance| problem.by(Taylor::tolerance(tolerance));
        self.found = tolerances(problem, &of, plan, exact).and_then(|errors| {
            Ok(vec![Adaptive { row: rows::TAYLOR, errors, energies: energies(problem, &*of(LOOSE), plan, exact)? }])
        });
    }
}

/// Taylor's method, where the recurrences of `H` were written.
pub(crate) fn by_taylor<H: Hamiltonian>(
    problem: &Problem<'_, H>,
    plan: &Plan,
    exact: &Exact,
) -> Result<Vec<Adaptive>, Box<dyn Error>> {
    let mut asked = Asked { problem, plan, exact, second_order: false, found: Ok(Vec::new()) };
    H::visit_recurrences(&mut asked);
    asked.found
}
