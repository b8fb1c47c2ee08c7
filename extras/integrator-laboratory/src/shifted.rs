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

/// The positions half a step later, the momenta as they are.
fn half_a_step_later<H: Hamiltonian>(
    problem: &Problem<'_, H>,
    state: Phase<H::Coords>,
) -> Result<Phase<H::Coords>, Error> {
    // Drift, then kick: of such a step the drift is kept.
    let mut run = problem.run(EulerAdjoint, &state, 0.5 * problem.step)?;
    run.advance(1)?;
    Ok(Phase { q: run.state().q, p: state.p })
}

/// The largest difference between the half steps of Verlet and the leapfrog, in units of the orbit: positions at half
/// steps, where Verlet drifts first, and momenta at half steps, where it kicks first. The latter leapfrog is the textbook's
/// own code and shows its momenta half a kick later.
pub(crate) fn verlet_against_leapfrog<H: Hamiltonian>(problem: &Problem<'_, H>, exact: &Exact) -> Result<f64, Error> {
    let apart = |one: &Phase<H::Coords>, other: &Phase<H::Coords>| exact.distance(&numbers(one), &numbers(other));
    let Problem { start, step, .. } = problem;
    let begin = half_a_step_later(problem, start.clone())?;
    let leapfrog = problem.run(Euler, &begin, *step)?.at_time(0.5 * step);
    let mut largest = 0.0_f64;
    for (whole, half) in problem.run(Verlet, start, *step)?.samples(1).zip(leapfrog.samples(1)).take(STEPS) {
        largest = largest.max(apart(&half_a_step_later(problem, whole?.state)?, &half?.state));
    }
    let (verlet, leapfrog) =
        (problem.run(VelocityVerlet, start, *step)?, problem.run(StaggeredLeapfrog, start, *step)?);
    for (verlet, leapfrog) in verlet.samples(1).zip(leapfrog.samples(1)).take(STEPS) {
        largest = largest.max(apart(&verlet?.state, &leapfrog?.state));
    }
    Ok(largest)
}
