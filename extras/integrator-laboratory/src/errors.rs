//! Errors for a sequence of step sizes, compared with a reference.

use crate::{
    plan::Plan,
    problem::{Problem, Stepped, numbers},
};
use integrator_core::{Coords, prelude::*};
use std::error::Error;

/// The error with one step size or tolerance.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rung {
    /// The step, or the tolerance of a method that chooses its steps.
    pub(crate) step: f64,
    /// The number of force evaluations.
    pub(crate) evaluations: u64,
    /// The distance in phase space from the reference, in units of the orbit.
    pub(crate) error: f64,
}

/// The reference for the end of a motion.
pub(crate) struct Exact {
    end: Vec<f64>,
    /// The difference of two references.
    uncertainty: f64,
    /// The size of the orbit in positions and in momenta: halves of its ranges, the units of distances.
    pub(crate) size: [f64; 2],
    /// The unit of energies: the largest `½ p·dq/dt` on the way, which is the kinetic energy if `T` is quadratic. A
    /// constant in `V` or `T` does not change it.
    pub(crate) motion: f64,
    /// The rounding of an energy in this unit: ε of the largest `|T| + |V|`, whose zero decides how many digits are left.
    pub(crate) grain: f64,
}

impl Exact {
    /// The distance of two states, in units of the orbit.
    pub(crate) fn distance(&self, one: &[f64], other: &[f64]) -> f64 {
        let apart: Vec<f64> = one.iter().zip(other).map(|(one, other)| one - other).collect();
        let (q, p) = apart.split_at(apart.len() / 2);
        (length(q) / self.size[0]).hypot(length(p) / self.size[1])
    }

    /// Returns the tolerance of a method that takes it absolutely for coordinates below one: in units of an orbit that is smaller.
    pub(crate) fn tolerance(&self, tolerance: f64) -> f64 {
        tolerance * self.size[0].min(self.size[1]).min(1.0)
    }

    /// Returns the change of the energy that rounding alone may cause: some roundings in each step, at worst all in the
    /// same sense.
    pub(crate) fn rounding(&self, steps: usize) -> f64 {
        16.0 * self.grain * steps as f64
    }
}

/// Periods up to the errors: no whole number of half periods, where errors of symmetric orbits cancel.
pub(crate) const PERIODS: f64 = 2.25;
/// Steps up to there of the coarsest rung, of which no period has a whole number.
const COARSEST: u32 = 19;
/// The loosest tolerance.
const LOOSEST: f64 = 0.01;
/// Steps up to there of the reference, of order 10 and with its roundings carried along.
const REFERENCE: u32 = 1152;
/// Steps of the reference from one sample of the energies to the next: a sixty-fourth of a period or less.
const STRIDE: u32 = 4;

/// The reference: the better one of two, with their difference.
pub(crate) fn exact<H: Hamiltonian>(problem: &Problem<'_, H>) -> Result<Exact, Box<dyn Error>> {
    let (mut motion, mut terms) = (0.0_f64, 0.0_f64);
    let start = numbers(&problem.start);
    let (mut least, mut most) = (start.clone(), start);
    let mut end = |steps: u32| -> Result<Vec<f64>, integrator_core::Error> {
        let start = Phase::compensated(problem.start.q.clone(), problem.start.p.clone());
        let h = PERIODS * problem.period / f64::from(steps);
        let mut run = problem.system.run_with::<Compensated<f64>, _>(SofroniouSpaletta10, start, h)?;
        let mut before = of_compensated::<H>(&run.state());
        for _ in 0..steps / STRIDE {
            terms = terms.max(run.kinetic().abs() + run.potential().abs());
            run.advance(u64::from(STRIDE))?;
            let after = of_compensated::<H>(&run.state());
            motion = motion.max((action(&before, &after) / (2.0 * h * f64::from(STRIDE))).abs());
            for ((least, most), at) in least.iter_mut().zip(&mut most).zip(&after) {
                (*least, *most) = (least.min(*at), most.max(*at));
            }
            before = after;
        }
        Ok(before)
    };
    let (coarse, fine) = (end(problem.cycles() * REFERENCE / 2)?, end(problem.cycles() * REFERENCE)?);
    let motion = if motion > 0.0 { motion } else { 1.0 };
    let halves: Vec<f64> = most.iter().zip(&least).map(|(most, least)| 0.5 * (most - least)).collect();
    let (q, p) = halves.split_at(problem.freedom());
    let size = [q, p].map(length).map(|size| if size > 0.0 { size } else { 1.0 });
    let exact = Exact { end: fine, uncertainty: 0.0, size, motion, grain: f64::EPSILON * terms / motion };
    Ok(Exact { uncertainty: exact.distance(&coarse, &exact.end), ..exact })
}

fn length(numbers: &[f64]) -> f64 {
    numbers.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// The action `∫ p dq` between two neighbouring states, by the trapezoidal rule.
fn action(before: &[f64], after: &[f64]) -> f64 {
    let freedom = before.len() / 2;
    (0..freedom).map(|i| 0.5 * (before[freedom + i] + after[freedom + i]) * (after[i] - before[i])).sum()
}

/// All positions, then all momenta, without what they carry along.
fn of_compensated<H: Hamiltonian>(state: &Phase<<H::Coords as Coords>::With<Compensated<f64>>>) -> Vec<f64> {
    state.q.flat().iter().chain(state.p.flat()).map(|leaf| leaf.value).collect()
}

/// The errors of a method.
pub(crate) fn ladder<H: Hamiltonian>(
    problem: &Problem<'_, H>,
    method: &dyn Stepped<H::Coords>,
    plan: &Plan,
    exact: &Exact,
) -> Result<Vec<Rung>, Box<dyn Error>> {
    let mut rungs = Vec::new();
    for rung in 0..plan.rungs {
        let steps = u64::from(COARSEST) << rung;
        // Steps that do not follow a drive have no order.
        if steps < u64::from(COARSEST * problem.cycles()) {
            continue;
        }
        let step = PERIODS * problem.period / steps as f64;
        let Some(rung) = climb(problem, method, [step, step], steps, exact)? else { continue };
        rungs.push(rung);
        // What lies below the reference says nothing; nor does what lies below the rounding.
        if rung.error < 2.0 * exact.uncertainty.max(f64::EPSILON) {
            break;
        }
    }
    Ok(rungs)
}

/// The errors of a method that chooses its own steps, for one tolerance after the other, each a tenth of the one
/// before; but for those that may be the reference's.
pub(crate) fn tolerances<'s, H: Hamiltonian>(
    problem: &Problem<'s, H>,
    method: &dyn Fn(f64) -> Box<dyn Stepped<H::Coords> + 's>,
    plan: &Plan,
    exact: &Exact,
) -> Result<Vec<Rung>, Box<dyn Error>> {
    let span = PERIODS * problem.period;
    let tolerances = (0..plan.rungs).map(|rung| LOOSEST / 10.0_f64.powi(rung as i32));
    let rungs = tolerances.map(|tolerance| climb(problem, &*method(tolerance), [span, tolerance], 1, exact));
    let is_seen = |rung: &Result<Rung, _>| !matches!(rung, Ok(rung) if rung.error < 2.0 * exact.uncertainty);
    rungs.filter_map(Result::transpose).filter(is_seen).collect()
}

/// The error of this number of steps; none where these do not lead to an end. A step may be too coarse to stay finite.
fn climb<H: Hamiltonian>(
    problem: &Problem<'_, H>,
    method: &dyn Stepped<H::Coords>,
    [h, step]: [f64; 2],
    steps: u64,
    exact: &Exact,
) -> Result<Option<Rung>, Box<dyn Error>> {
    let mut run = method.run(&problem.start, h)?;
    let Ok(()) = run.advance(steps) else { return Ok(None) };
    let error = exact.distance(&numbers(&run.state()), &exact.end);
    Ok(Some(Rung { step, evaluations: run.evaluations(), error }))
}
