//! The measurements of one method. This module, `blob`, `errors`, `portrait`, `reversal`, `limits`, `tangents` and
//! `shifted` are the code that is generic over systems; their results are plain numbers.

use crate::{
    blob::{Blob, follow},
    errors::{Exact, Rung, ladder},
    limits::limits,
    plan::Plan,
    portrait::{Portrait, portrait},
    problem::{Problem, Stepped, steps_per_period},
    reversal::{Reversal, reversal},
    rows::Row,
    tangents::{Deviation, defect, deviations},
};
use integrator_core::{Coords, prelude::*};
use std::error::Error;

/// Everything that the page shows of a method.
#[derive(Clone, Debug)]
pub(crate) struct Measured {
    pub(crate) row: Row,
    /// Whether the method claims to be symplectic, and to be its own inverse in steps back.
    pub(crate) symplectic: bool,
    pub(crate) symmetric: bool,
    /// The order that it claims.
    pub(crate) order: u32,
    /// The order that it shows on this problem, where that can be measured.
    pub(crate) slope: Option<f64>,
    /// Steps of other sizes, and by how much the map of [`STEPS`] of them is not symplectic, in units of rounding.
    pub(crate) defects: Vec<(f64, f64)>,
    /// The tangent map after each step.
    pub(crate) deviations: Vec<Deviation>,
    /// Periods, and the change of the energy in units of the largest kinetic energy.
    pub(crate) energies: Vec<(f64, f64)>,
    /// The change of the energy that rounding alone may cause.
    pub(crate) rounding: f64,
    pub(crate) portrait: Portrait,
    pub(crate) reversal: Reversal,
    /// The largest change of the energy for one step after the other, of those methods for which it is meaningful.
    pub(crate) limits: Vec<(f64, f64)>,
    /// The blob of starts.
    pub(crate) blob: Blob,
    /// Errors for one step size after the other.
    pub(crate) errors: Vec<Rung>,
}

/// The steps after which a map is compared with a symplectic one: a method with a memory has left its starter by then.
pub(crate) const STEPS: usize = 8;

/// By how much a Poisson bracket that is one may be off by rounding: a step has less than two hundred flows, each
/// rounds some products of the tangent map, a few ε each.
pub(crate) const BRACKET: f64 = 1e-12;

/// The numbers of steps to a period that maps are computed for, however fast a drive is: maps are symplectic for every
/// step. The coarsest distinguish symplectic methods from those of high order.
const DEFECT_STEPS: [u32; 7] = [1280, 640, 320, 160, 80, 40, 20];

/// A slope that is off by less belongs to the first term of the error.
const ASYMPTOTIC: f64 = 0.1;

/// Changes of the energy beyond this tell no more than that it has changed.
const BEYOND: f64 = 10.0;

impl Measured {
    pub(crate) fn name(&self) -> &'static str {
        self.row.name
    }

    /// `{q₁, p₁}` after one step of the problem.
    pub(crate) fn bracket(&self) -> f64 {
        self.deviations.first().map_or(f64::NAN, |deviation| deviation.bracket)
    }

    /// Whether the map is symplectic, up to rounding, for every step that was tried.
    pub(crate) fn keeps_areas(&self) -> bool {
        !self.defects.is_empty() && self.defects.iter().all(|(_, defect)| *defect <= 1.0)
    }

    /// The last change of the energy, or the one with which a motion that escapes has left for good.
    pub(crate) fn energy_change(&self) -> f64 {
        let changes = self.energies.iter().map(|(_, change)| *change);
        changes.take_while(|change| change.abs() < BEYOND).last().unwrap_or(f64::NAN)
    }

    /// The largest change of the energy.
    pub(crate) fn largest_energy_change(&self) -> f64 {
        self.energies.iter().map(|(_, change)| change.abs()).fold(0.0, f64::max)
    }
}

/// Measures a method on a problem.
pub(crate) fn measure<H: Hamiltonian>(
    row: Row,
    method: &dyn Stepped<H::Coords>,
    problem: &Problem<'_, H>,
    plan: &Plan,
    exact: &Exact,
) -> Result<Measured, Box<dyn Error>> {
    let Problem { start, step, .. } = problem;
    let facts = method.facts();
    let energies = energies(problem, method, plan, exact)?;
    let portrait = portrait(problem, method, plan, exact)?;
    let steps = DEFECT_STEPS.map(|count| problem.period / steps_per_period(count)).into_iter();
    Ok(Measured {
        symplectic: facts.symplectic,
        symmetric: facts.symmetric,
        order: facts.order,
        slope: slope(method, start, *step),
        // Where a step is too long for an implicit method, there is no map.
        defects: steps.filter_map(|h| Some((h, defect(problem, method, exact, h, STEPS).ok()?))).collect(),
        deviations: deviations(problem, method, exact)?,
        rounding: exact.rounding(energies.len()),
        energies,
        reversal: reversal(problem, method, exact, portrait.count)?,
        portrait,
        limits: if row.limit { limits(problem, method, plan, exact)? } else { Vec::new() },
        blob: follow(problem, method, plan, exact)?,
        errors: ladder(problem, method, plan, exact)?,
        row,
    })
}

/// The order that a method shows in steps of the problem, or in shorter ones, if the first term of its error prevails only there.
fn slope<C: Coords>(method: &dyn Stepped<C>, start: &Phase<C>, step: f64) -> Option<f64> {
    let order = f64::from(method.facts().order);
    let mut slopes = [1.0, 2.0, 4.0].into_iter().filter_map(|part| method.slope(start, step / part));
    let first = slopes.next()?;
    let shows = |slope: &f64| (slope - order).abs() < ASYMPTOTIC;
    if shows(&first) { Some(first) } else { slopes.find(shows).or(Some(first)) }
}

/// Periods, and the change of the energy in units of the largest kinetic energy, step by step.
pub(crate) fn energies<H: Hamiltonian>(
    problem: &Problem<'_, H>,
    method: &dyn Stepped<H::Coords>,
    plan: &Plan,
    exact: &Exact,
) -> Result<Vec<(f64, f64)>, Box<dyn Error>> {
    let run = method.run(&problem.start, problem.step)?;
    let energy = run.energy();
    let steps = (plan.periods * problem.period / problem.step) as usize;
    // A method may leave the finite numbers, or find no end of its step; up to there it is shown.
    let samples = run.samples(1).take(steps + 1).map_while(Result::ok);
    let changes = samples.map(|sample| (sample.time / problem.period, (sample.energy() - energy) / exact.motion));
    Ok(changes.take_while(|(_, change)| change.is_finite()).collect())
}
