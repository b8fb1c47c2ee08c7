//! Verlet's inner half steps are the leapfrog, shifted by half a step.
//!
//! With drifts `T` and kicks `V`, Verlet repeats `T(½) V(1) T(½)`. Between two kicks, two half drifts follow each other
//! and make a whole one. From the first half drift on, the sequence is kick, drift, kick, drift. This is the leapfrog,
//! with positions at half steps and momenta at whole ones.

use crate::{
    errors::Exact,
    problem::{Problem, numbers},
};
use integrator_core::{Error, prelude::*};
use integrator_reference::StaggeredLeapfrog;

const STEPS: usize = 1_000;

/// Verlet and the leapfrog.
#[derive(Clone, Debug)]
pub(crate) struct Shifted {
    /// The largest difference between both, in units of the orbit.
    pub(crate) apart: f64,
    /// The step of the picture.
    pub(crate) step: f64,
    /// The times in these steps, and the first position and its momentum in units of the orbit: along the orbit, of Verlet, and of
    /// the leapfrog, whose positions belong to half a step later.
    pub(crate) exact: Vec<[f64; 3]>,
    pub(crate) whole: Vec<[f64; 3]>,
    pub(crate) half: Vec<[f64; 3]>,
}

/// Steps of a period of the picture, and points of the orbit in each.
const SHOWN: u32 = 12;
const POINTS: u32 = 8;

/// The positions half a step later, the momenta as they are.
fn half_a_step_later<H: Hamiltonian>(
    problem: &Problem<'_, H>,
    state: Phase<H::Coords>,
    step: f64,
) -> Result<Phase<H::Coords>, Error> {
    // Drift, then kick: of such a step the drift is kept.
    let mut run = problem.run(EulerAdjoint, &state, 0.5 * step)?;
    run.advance(1)?;
    Ok(Phase { q: run.state().q, p: state.p })
}

/// The largest difference between the half steps of Verlet and the leapfrog: positions at half steps, where Verlet drifts first,
/// and momenta at half steps, where it kicks first. The latter leapfrog is the textbook's own code and shows its momenta half a
/// kick later. Also both sequences in long steps.
pub(crate) fn verlet_against_leapfrog<H: Hamiltonian>(
    problem: &Problem<'_, H>,
    exact: &Exact,
) -> Result<Shifted, Error> {
    let apart = |one: &Phase<H::Coords>, other: &Phase<H::Coords>| exact.distance(&numbers(one), &numbers(other));
    let Problem { start, step, .. } = problem;
    let begin = half_a_step_later(problem, start.clone(), *step)?;
    let leapfrog = problem.run(Euler, &begin, *step)?.at_time(0.5 * step);
    let mut largest = 0.0_f64;
    for (whole, half) in problem.run(Verlet, start, *step)?.samples(1).zip(leapfrog.samples(1)).take(STEPS) {
        largest = largest.max(apart(&half_a_step_later(problem, whole?.state, *step)?, &half?.state));
    }
    let (verlet, leapfrog) =
        (problem.run(VelocityVerlet, start, *step)?, problem.run(StaggeredLeapfrog, start, *step)?);
    for (verlet, leapfrog) in verlet.samples(1).zip(leapfrog.samples(1)).take(STEPS) {
        largest = largest.max(apart(&verlet?.state, &leapfrog?.state));
    }
    let step = problem.step_of(SHOWN);
    let seen = |time: f64, state: &Phase<H::Coords>| {
        let numbers = numbers(state);
        [time / step, numbers[0] / exact.size[0], numbers[problem.freedom()] / exact.size[1]]
    };
    let mut shifted = Shifted { apart: largest, step, exact: Vec::new(), whole: Vec::new(), half: Vec::new() };
    for sample in problem.run(Verlet, start, step)?.samples(1).take(SHOWN as usize + 1) {
        // A step that is too long for the motion ends the picture.
        let Ok(sample) = sample else { break };
        shifted.half.push(seen(sample.time, &half_a_step_later(problem, sample.state.clone(), step)?));
        shifted.whole.push(seen(sample.time, &sample.state));
    }
    let orbit = problem.run(KahanLi8, start, step / f64::from(POINTS))?.samples(1);
    let points = orbit.take((SHOWN * POINTS + POINTS) as usize).map_while(Result::ok);
    shifted.exact = points.map(|sample| seen(sample.time, &sample.state)).collect();
    Ok(shifted)
}
