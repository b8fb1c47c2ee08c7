//! The orbit of a method with steps that show its properties: so long that a gain or a loss of energy is visible, or as
//! long as possible if there is none.

use crate::{
    errors::Exact,
    plan::Plan,
    problem::{Problem, Stepped},
};
use integrator_core::prelude::*;

/// An orbit in the view of the problem. Energies are in units of the largest kinetic energy of the motion.
#[derive(Clone, Debug)]
pub(crate) struct Portrait {
    /// Steps to a period, and a fraction.
    pub(crate) count: u32,
    /// The number of periods shown: fewer than planned where the orbit has left.
    pub(crate) periods: f64,
    pub(crate) points: Vec<(f64, f64)>,
    /// The change of the energy at the end, or with which the orbit left.
    pub(crate) change: f64,
    /// Whether the orbit has left before the time was over.
    pub(crate) left: bool,
    /// The largest one in the first and in the second half.
    pub(crate) largest: [f64; 2],
    /// The one that rounding alone may cause.
    pub(crate) rounding: f64,
}

/// The numbers of steps to a period that are tried, from short steps to long ones.
const COUNTS: [u32; 14] = [80, 57, 40, 28, 20, 14, 10, 8, 7, 6, 5, 4, 3, 2];
/// The largest number of steps to a period for which orbits without a visible change are integrated longer, by
/// `LONGER`.
const LONG: u32 = 10;
const LONGER: f64 = 8.0;
/// The steps to a period that show a method which keeps its energy, and those that are tried if it does not in steps as long.
const COARSE: [u32; 5] = [20, 28, 40, 57, 80];
/// A change of the energy that is seen.
pub(crate) const SEEN: f64 = 0.2;
/// The largest ratio of the energy errors of the second and the first half of a run without drift.
pub(crate) const STAYS: f64 = 1.5;
/// Within this, a symplectic method is not near its limit of stability.
const KEPT: f64 = 0.3;
/// With a change like the first one an orbit has gained or lost; with the second one it has left.
const CHANGED: f64 = 1.0;
const LEFT: f64 = 3.0;

impl Portrait {
    /// Returns the ratio of the largest changes of the second and the first half, where both are more than rounding.
    pub(crate) fn growth(&self) -> f64 {
        if self.left {
            return f64::INFINITY;
        }
        self.largest[1].max(self.rounding) / self.largest[0].max(self.rounding)
    }

    /// Returns whether the change of the energy grows, and its size.
    fn rank(&self) -> (bool, f64) {
        (self.growth() > STAYS, self.change.abs())
    }
}

/// The portrait of a method: of one that is symplectic in long steps, of another one in the shortest in which it is seen
/// that it is not. If `H` reads the time, its energy says nothing, and all methods have the same steps.
pub(crate) fn portrait<H: Hamiltonian>(
    problem: &Problem<'_, H>,
    method: &dyn Stepped<H::Coords>,
    plan: &Plan,
    exact: &Exact,
) -> Result<Portrait, Error> {
    let follow = |periods: f64, count: u32| follow(problem, method, exact, periods, count);
    if method.facts().symplectic || !H::AUTONOMOUS {
        let mut portrait = follow(plan.periods, COARSE[0])?;
        for count in &COARSE[1..] {
            if portrait.largest[0].max(portrait.largest[1]) < KEPT || !H::AUTONOMOUS {
                break;
            }
            portrait = follow(plan.periods, *count)?;
        }
        return Ok(portrait);
    }
    let long = COUNTS.into_iter().filter(|count| *count <= LONG).map(|count| (count, LONGER * plan.periods));
    let mut best: Option<Portrait> = None;
    for (count, periods) in COUNTS.into_iter().map(|count| (count, plan.periods)).chain(long) {
        let portrait = follow(periods, count)?;
        if portrait.change.abs() > SEEN {
            return Ok(portrait);
        }
        // Where nothing is seen, the largest change that grows is shown, or the largest of all.
        if best.as_ref().is_none_or(|best| portrait.rank() > best.rank()) {
            best = Some(portrait);
        }
    }
    best.ok_or(Error::SampleInterval)
}

fn follow<H: Hamiltonian>(
    problem: &Problem<'_, H>,
    method: &dyn Stepped<H::Coords>,
    exact: &Exact,
    periods: f64,
    count: u32,
) -> Result<Portrait, Error> {
    let run = method.run(&problem.start, problem.step_of(count))?;
    let energy = run.energy();
    let steps = (periods * problem.period / problem.step_of(count)) as usize;
    let rounding = exact.rounding(steps);
    let mut portrait =
        Portrait { count, periods: 0.0, points: Vec::new(), change: 0.0, left: true, largest: [0.0; 2], rounding };
    let mut taken = 0;
    // A method may leave the finite numbers, or find no end of its step; up to there it is shown.
    for (number, sample) in run.samples(1).take(steps + 1).map_while(Result::ok).enumerate() {
        let change = (sample.energy() - energy) / exact.motion;
        if !change.is_finite() {
            break;
        }
        // One point in each oscillation of a fast drive and step of its own.
        if number.is_multiple_of(problem.drive() as usize) {
            portrait.points.push(problem.seen(&sample.state));
        }
        taken = number;
        portrait.periods = sample.time / problem.period;
        // What happens to an orbit that has left is no gain or loss any more.
        if portrait.change.abs() < CHANGED {
            portrait.change = change;
        }
        let half = usize::from(2 * number > steps);
        portrait.largest[half] = portrait.largest[half].max(change.abs());
        if H::AUTONOMOUS && change.abs() > LEFT {
            return Ok(portrait);
        }
    }
    portrait.left = taken < steps;
    Ok(portrait)
}
