//! Errors for one step size after the other, against a reference.

use crate::{
    plan::Plan,
    problem::{Problem, numbers},
};
use integrator_core::{Coords, Method, prelude::*};
use std::error::Error;

/// The error with one step size.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rung {
    pub(crate) step: f64,
    /// How often the force was evaluated; no number where the method does not tell.
    pub(crate) evaluations: f64,
    /// The distance in phase space from the reference, in units of the reference.
    pub(crate) error: f64,
}

/// Where a motion arrives.
pub(crate) struct Exact {
    end: Vec<f64>,
    /// The orbit on the way, step by step.
    pub(crate) orbit: Vec<Vec<f64>>,
    /// By how much two references differ.
    uncertainty: f64,
}

/// Turns up to the errors: no whole number of half turns, where errors of symmetric orbits cancel.
pub(crate) const TURNS: f64 = 2.25;
/// Steps up to there of the coarsest rung.
const COARSEST: u32 = 18;
/// Steps up to there of the reference, of order 10 and with its roundings carried along.
const REFERENCE: u32 = 1152;

/// The reference: the better one of two, with their difference.
pub(crate) fn exact<H: Hamiltonian>(problem: &Problem<H>) -> Result<Exact, Box<dyn Error>> {
    let orbit = |steps: u32| -> Result<Vec<Vec<f64>>, integrator_core::Error> {
        let start = Phase::compensated(problem.start.q.clone(), problem.start.p.clone());
        let h = TURNS * problem.turn / f64::from(steps);
        let samples = problem.system.run_with::<Compensated<f64>, _>(SofroniouSpaletta10, start, h)?.samples(1);
        let state = |sample: Result<Sample<_>, _>| sample.map(|sample| of_compensated::<H>(&sample.state));
        samples.take(steps as usize + 1).map(state).collect()
    };
    let (coarse, fine) = (orbit(REFERENCE / 2)?, orbit(REFERENCE)?);
    let ends = coarse.last().zip(fine.last()).ok_or("a reference without an end")?;
    Ok(Exact { uncertainty: distance(ends.0, ends.1), end: ends.1.clone(), orbit: fine })
}

/// All positions, then all momenta, without what they carry along.
fn of_compensated<H: Hamiltonian>(state: &Phase<<H::Coords as Coords>::With<Compensated<f64>>>) -> Vec<f64> {
    state.q.flat().iter().chain(state.p.flat()).map(|leaf| leaf.value).collect()
}

/// The distance from a reference in units of the reference.
fn distance(state: &[f64], reference: &[f64]) -> f64 {
    let apart: f64 = state.iter().zip(reference).map(|(a, b)| (a - b).powi(2)).sum();
    let size: f64 = reference.iter().map(|x| x * x).sum();
    (apart / size).sqrt()
}

/// The errors of a method.
pub(crate) fn ladder<H: Hamiltonian, M: Method<H>>(
    problem: &Problem<H>,
    method: M,
    plan: &Plan,
    exact: &Exact,
) -> Result<Vec<Rung>, Box<dyn Error>> {
    // Not every method knows beforehand how often it will evaluate the force.
    let forces = method.facts().forces.map_or(f64::NAN, |forces| forces as f64);
    let mut rungs = Vec::new();
    for rung in 0..plan.rungs {
        let steps = u64::from(COARSEST << rung);
        let step = TURNS * problem.turn / steps as f64;
        let mut run = problem.run(method, &problem.start, step)?;
        // A step may be too coarse to stay finite.
        let Ok(()) = run.advance(steps) else { continue };
        let error = distance(&numbers(&run.state()), &exact.end);
        rungs.push(Rung { step, evaluations: steps as f64 * forces, error });
        // What lies below the reference says nothing; nor does what lies below the rounding.
        if error < 2.0 * exact.uncertainty.max(f64::EPSILON) {
            break;
        }
    }
    Ok(rungs)
}
