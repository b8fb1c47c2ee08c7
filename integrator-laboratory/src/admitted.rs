//! Methods that not every Hamiltonian admits: force gradients where `T` is quadratic, Taylor's where recurrences were written.
//! Nothing of them is compiled for the others.

use crate::{
    errors::{Exact, tolerances},
    measured::{Measured, energies, measure},
    methods::{Adaptive, LOOSE, Row},
    plan::Plan,
    problem::Problem,
};
use integrator_core::{QuadraticKinetic, RecurrencesVisitor, Visitor, prelude::*, taylor::Recurrences};
use integrator_plot::Colour;
use std::error::Error;

/// A system, and what was found of it.
struct Asked<'a, 's, H: Hamiltonian, Found> {
    problem: &'a Problem<'s, H>,
    plan: &'a Plan,
    exact: &'a Exact,
    found: Option<Result<Found, Box<dyn Error>>>,
}

impl<H: Hamiltonian> Visitor<H> for Asked<'_, '_, H, Measured> {
    fn visit<X: Composition<H>>(&mut self, _: X) {}

    fn admit_gradients(&mut self)
    where
        H: QuadraticKinetic,
    {
        let row = Row {
            name: "Chin 4A",
            formula: "S_4(h) = e^{{h}/{6}V} e^{{h}/{2}T} e^{{2h}/{3}U} e^{{h}/{2}T} e^{{h}/{6}V} ; U = V − {h^2}/{48} (V')^2",
            says: "A force gradient in the middle kick: order 4 in steps forward alone, where Yoshida has to step back.",
            colour: Colour(230, 110, 90),
            limit: false,
        };
        self.found = Some(measure(row, Chin4A, self.problem, self.plan, self.exact));
    }
}

/// A composition with a force gradient, where `H` admits one.
pub(crate) fn with_gradients<H: Hamiltonian>(
    problem: &Problem<'_, H>,
    plan: &Plan,
    exact: &Exact,
) -> Result<Option<Measured>, Box<dyn Error>> {
    let mut asked = Asked { problem, plan, exact, found: None };
    H::visit_compositions(&mut asked);
    asked.found.transpose()
}

impl<H: Hamiltonian> RecurrencesVisitor<H> for Asked<'_, '_, H, Adaptive> {
    fn visit(&mut self)
    where
        H: Recurrences,
    {
        let Self { problem, plan, exact, .. } = self;
        let row = Row {
            name: "Taylor",
            formula: "",
            says: "many derivatives by recurrences, in steps by the last of them",
            colour: Colour(30, 140, 230),
            limit: false,
        };
        let measured = tolerances(problem, Taylor::tolerance, plan, exact).and_then(|errors| {
            Ok(Adaptive { row, errors, energies: energies(problem, Taylor::tolerance(LOOSE), plan)? })
        });
        self.found = Some(measured);
    }
}

/// Taylor's method, where the recurrences of `H` were written.
pub(crate) fn by_taylor<H: Hamiltonian>(
    problem: &Problem<'_, H>,
    plan: &Plan,
    exact: &Exact,
) -> Result<Option<Adaptive>, Box<dyn Error>> {
    let mut asked = Asked { problem, plan, exact, found: None };
    H::visit_recurrences(&mut asked);
    asked.found.transpose()
}
