//! The largest change of the energy for short to long steps. It diverges at the limit of stability, and has a peak if
//! the step resonates with the motion.

use crate::{
    errors::Exact,
    plan::Plan,
    problem::{Problem, Stepped},
};
use integrator_core::prelude::*;

/// Steps to a period of the shortest and of the longest step.
const COUNTS: [f64; 2] = [64.6, 2.2];
/// The duration over which an orbit is integrated, in periods.
pub(crate) const PERIODS: f64 = 30.0;
/// An energy that has changed by this has left.
pub(crate) const LEFT: f64 = 1e3;

/// Steps, and the largest change of the energy in this number of periods, in units of the largest kinetic energy. Of one
/// that has left, as much as an energy that has.
pub(crate) fn limits<H: Hamiltonian>(
    problem: &Problem<'_, H>,
    method: &dyn Stepped<H::Coords>,
    plan: &Plan,
    exact: &Exact,
) -> Result<Vec<(f64, f64)>, Error> {
    let count = |i: u32| COUNTS[0] * (COUNTS[1] / COUNTS[0]).powf(f64::from(i) / f64::from(plan.limits - 1));
    (0..plan.limits)
        .map(|i| Ok((problem.period / count(i), largest(problem, method, problem.period / count(i), exact.motion)?)))
        .collect()
}

fn largest<H: Hamiltonian>(
    problem: &Problem<'_, H>,
    method: &dyn Stepped<H::Coords>,
    step: f64,
    unit: f64,
) -> Result<f64, Error> {
    let run = method.run(&problem.start, step)?;
    let energy = run.energy();
    let mut largest = 0.0_f64;
    for sample in run.samples(1).take((PERIODS * problem.period / step) as usize) {
        let change = sample.map_or(f64::INFINITY, |sample| ((sample.energy() - energy) / unit).abs());
        if change.is_nan() || change > LEFT {
            return Ok(LEFT);
        }
        largest = largest.max(change);
    }
    Ok(largest.max(f64::EPSILON))
}
