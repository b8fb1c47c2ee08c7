//! Forward and back: a number of steps, a reversal of the momenta, and the same number of steps again.

use crate::{
    errors::Exact,
    problem::{Problem, Stepped, numbers, steps_per_period},
};
use integrator_core::{Coords, prelude::*};

/// An orbit there and back.
#[derive(Clone, Debug, Default)]
pub(crate) struct Reversal {
    /// Steps to a period, and a fraction.
    pub(crate) count: u32,
    pub(crate) there: Vec<(f64, f64)>,
    pub(crate) back: Vec<(f64, f64)>,
    /// The distance of the end from the start, in units of the orbit; `None` where the method did not come to an end.
    pub(crate) apart: Option<f64>,
}

/// The duration of one way, in periods.
pub(crate) const PERIODS: f64 = 2.3;
/// Steps to a period, at most.
const COUNT: u32 = 30;

/// Goes there and back by a method: by one that is neither symmetric nor symplectic in steps as long as those which show
/// what it does to energies.
pub(crate) fn reversal<H: Hamiltonian>(
    problem: &Problem<'_, H>,
    method: &dyn Stepped<H::Coords>,
    exact: &Exact,
    shown: u32,
) -> Result<Reversal, Error> {
    let facts = method.facts();
    let count = if facts.symmetric || facts.symplectic { COUNT } else { shown.min(COUNT) };
    let step = problem.step_of(count);
    let steps = (PERIODS * f64::from(problem.cycles()) * steps_per_period(count)) as usize;
    let mut reversal = Reversal { count, ..Reversal::default() };
    let mut last = problem.start.clone();
    for sample in method.run(&problem.start, step)?.samples(1).take(steps + 1) {
        let Ok(sample) = sample else { return Ok(reversal) };
        reversal.there.push(problem.seen(&sample.state));
        last = sample.state;
    }
    turn(&mut last);
    for sample in method.run(&last, step)?.samples(1).take(steps + 1) {
        let Ok(mut sample) = sample else { return Ok(reversal) };
        turn(&mut sample.state);
        reversal.back.push(problem.seen(&sample.state));
        last = sample.state;
    }
    let apart = exact.distance(&numbers(&last), &numbers(&problem.start));
    reversal.apart = apart.is_finite().then_some(apart);
    Ok(reversal)
}

fn turn<C: Coords<Leaf = f64>>(state: &mut Phase<C>) {
    state.p.flat_mut().iter_mut().for_each(|p| *p = -*p);
}
