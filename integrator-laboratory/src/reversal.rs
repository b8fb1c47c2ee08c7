//! There and back: so many steps, the momenta turned around, and as many steps again.

use crate::problem::{Problem, distance, numbers};
use integrator_core::{Coords, Method, prelude::*};

/// An orbit there and back.
#[derive(Clone, Debug, Default)]
pub(crate) struct Reversal {
    pub(crate) there: Vec<(f64, f64)>,
    pub(crate) back: Vec<(f64, f64)>,
    /// How far from the start it ends, in units of the start; nothing where it did not come to an end.
    pub(crate) apart: Option<f64>,
}

/// How far it goes, in periods.
pub(crate) const PERIODS: f64 = 2.3;
/// Steps to a period.
pub(crate) const COUNT: u32 = 30;

/// Goes there and back by a method.
pub(crate) fn reversal<H: Hamiltonian, M: Method<H>>(problem: &Problem<'_, H>, method: M) -> Result<Reversal, Error> {
    let step = problem.period / f64::from(COUNT);
    let steps = (PERIODS * f64::from(COUNT)) as usize;
    let mut reversal = Reversal::default();
    let mut last = problem.start.clone();
    for sample in problem.run(method, &problem.start, step)?.samples(1).take(steps + 1) {
        let Ok(sample) = sample else { return Ok(reversal) };
        reversal.there.push(problem.seen(&sample.state));
        last = sample.state;
    }
    turn(&mut last);
    for sample in problem.run(method, &last, step)?.samples(1).take(steps + 1) {
        let Ok(mut sample) = sample else { return Ok(reversal) };
        turn(&mut sample.state);
        reversal.back.push(problem.seen(&sample.state));
        last = sample.state;
    }
    let apart = distance(&numbers(&last), &numbers(&problem.start));
    reversal.apart = apart.is_finite().then_some(apart);
    Ok(reversal)
}

fn turn<C: Coords<Leaf = f64>>(state: &mut Phase<C>) {
    state.p.flat_mut().iter_mut().for_each(|p| *p = -*p);
}
