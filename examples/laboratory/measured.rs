//! What is measured of one method. With `blob`, `errors` and `shifted` this is the code that is generic over systems
//! and methods; what comes out are plain numbers.

use crate::{
    blob::{Blob, follow},
    errors::{Exact, Rung, ladder},
    plan::Plan,
    problem::{Problem, numbers},
};
use integrator_core::{
    Method,
    check::{observed_order, poisson_bracket},
    prelude::*,
};
use std::error::Error;

/// Everything that the pictures show of a method.
pub(crate) struct Measured {
    pub(crate) name: &'static str,
    /// Whether it claims to be symplectic.
    pub(crate) symplectic: bool,
    /// The order that it claims.
    pub(crate) order: u32,
    /// The order that it shows on this problem, where that can be measured.
    pub(crate) slope: Option<f64>,
    /// `{q₁, p₁}` after one step of the problem.
    pub(crate) bracket: f64,
    /// Steps of other sizes, and `{q₁, p₁}` after one of them.
    pub(crate) brackets: Vec<(f64, f64)>,
    /// The view of the problem, step by step.
    pub(crate) portrait: Vec<(f64, f64)>,
    /// Periods, and the change of the energy in units of that of the start.
    pub(crate) energies: Vec<(f64, f64)>,
    /// The blob of starts.
    pub(crate) blob: Blob,
    /// Errors for one step size after the other.
    pub(crate) errors: Vec<Rung>,
}

/// By how much a Poisson bracket that is one may be off by rounding: a step has less than two hundred flows, each
/// rounds some products of the tangent map, a few ε each.
pub(crate) const BRACKET: f64 = 1e-12;

/// How many steps to a period brackets are computed for. The coarsest tell symplectic methods from those of high order.
const BRACKET_STEPS: [f64; 7] = [1280.0, 640.0, 320.0, 160.0, 80.0, 40.0, 20.0];

/// Changes of the energy beyond this tell no more than that it has changed.
const BEYOND: f64 = 10.0;

impl Measured {
    /// Whether `{q₁, p₁} = 1` for every step that was tried.
    pub(crate) fn keeps_bracket(&self) -> bool {
        !self.brackets.is_empty() && self.brackets.iter().all(|(_, bracket)| (bracket - 1.0).abs() <= BRACKET)
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
pub(crate) fn measure<H: Hamiltonian, M: Method<H>>(
    name: &'static str,
    method: M,
    problem: &Problem<H>,
    plan: &Plan,
    exact: &Exact,
) -> Result<Measured, Box<dyn Error>> {
    let Problem { system, start, step, period, view, .. } = problem;
    let run = problem.run(method, start, *step)?;
    let energy = run.energy();
    let unit = if energy == 0.0 { 1.0 } else { energy.abs() };
    let steps = (plan.periods * period / step) as usize;
    let (mut portrait, mut energies) = (Vec::new(), Vec::new());
    // A method may leave the finite numbers, or find no end of its step; up to there it is shown.
    for sample in run.samples(1).take(steps + 1).map_while(Result::ok) {
        let (state, now) = (numbers(&sample.state), sample.energy());
        if !now.is_finite() {
            break;
        }
        portrait.push((state[view[0]], state[view[1]]));
        energies.push((sample.time / period, (now - energy) / unit));
    }
    let bracket = |h: f64| poisson_bracket::<H, M, f64>(system, method, start, h, 0);
    let brackets = BRACKET_STEPS.iter().map(|count| period / count);
    Ok(Measured {
        name,
        symplectic: method.facts().symplectic,
        order: method.facts().order,
        slope: observed_order::<H, M, f64>(system, method, start.clone(), *step).ok().map(|order| order.slope),
        bracket: bracket(*step)?,
        // Where a step is too long for an implicit method, there is no bracket.
        brackets: brackets.filter_map(|h| Some((h, bracket(h).ok()?))).collect(),
        portrait,
        energies,
        blob: follow(problem, method, plan)?,
        errors: ladder(problem, method, plan, exact)?,
    })
}
