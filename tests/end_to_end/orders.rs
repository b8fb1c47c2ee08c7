//! Every composition has the order that was proved, on nonlinear problems.
//!
//! The linear oscillator flatters methods: some have a higher order on it than they have.

use crate::{
    catalogue::for_each_composition,
    measured_order::{assert_order, observed_order},
    systems::{LOOKS, Problem, State, coupled, error, henon_heiles, kepler, pendulum, relativistic},
};
use integrator_core::{QuadraticKinetic, check::symplectic_defect, prelude::*};

/// The time between two looks: four of them are a period or more.
const SPAN: f64 = 2.0;

fn measure<H: Hamiltonian<Coords = [f64; N]>, X: Composition<H>, const N: usize>(
    problem: &Problem<H, N>,
    composition: X,
    exact: &[State<N>; LOOKS],
) {
    let (q, p) = problem.start;
    let error = |steps: u64| {
        let run = problem.system.run_with(composition, Phase::compensated(q, p), SPAN / steps as f64);
        error(run.expect("an admissible start"), steps, exact)
    };
    let name = format!("{} on {}", X::NAME, problem.name);
    assert_order(&name, X::ORDER, observed_order(X::ORDER, error));

    let defect = symplectic_defect(&problem.system, composition, Phase::new(q, p), 0.05).expect("a tangent map");
    // Every stage multiplies the tangent map by one of determinant 1, with a few roundings of entries of order one.
    let stages = 2.0 * X::FORCE_EVALUATIONS as f64;
    assert!(defect < 64.0 * stages * f64::EPSILON, "{name} is not symplectic: {defect:e}");
}

/// For every `T`.
fn measure_all<H: Hamiltonian<Coords = [f64; N]>, const N: usize>(problem: &Problem<H, N>) {
    let exact = problem.reference(SPAN);
    macro_rules! each {
        ($($composition:ident)*) => {
            $(measure(problem, $composition, &exact);)*
        };
    }
    for_each_composition!(general: each!);
}

/// For the compositions that need a quadratic `T`.
fn measure_quadratic<H: QuadraticKinetic + Hamiltonian<Coords = [f64; N]>, const N: usize>(problem: &Problem<H, N>) {
    let exact = problem.reference(SPAN);
    macro_rules! each {
        ($($composition:ident)*) => {
            $(measure(problem, $composition, &exact);)*
        };
    }
    for_each_composition!(quadratic: each!);
}

/// For some of each kind.
fn measure_kinds<H: QuadraticKinetic + Hamiltonian<Coords = [f64; N]>, const N: usize>(problem: &Problem<H, N>) {
    let exact = problem.reference(SPAN);
    macro_rules! each {
        ($($composition:ident)*) => {
            $(measure(problem, $composition, &exact);)*
        };
    }
    for_each_composition!(general_kinds: each!);
    for_each_composition!(quadratic_kinds: each!);
}

#[test]
fn on_an_eccentric_orbit() {
    measure_all(&kepler());
    measure_quadratic(&kepler());
}

#[test]
fn at_relativistic_speed() {
    measure_all(&relativistic());
}

#[test]
fn with_mass_and_length() {
    measure_kinds(&pendulum());
}

#[test]
fn in_a_galaxy() {
    measure_kinds(&henon_heiles());
}

#[test]
fn with_coupled_momenta() {
    measure_kinds(&coupled());
}
