//! Runge–Kutta with steps by an error estimate: the steps along an orbit, and against the force.
//!
//! An orbit of Kepler's problem with eccentricity 0.8 is the same for all systems. The estimate of a pair of orders 5 and 4 grows
//! with the fifth power of the step, so that steps follow the time in which the force changes: at a distance `r` that is
//! `r^(3/2)`, the power −3/4 of the force `1/r²` (Hairer, Nørsett and Wanner 1993, section II.4).

use crate::{
    errors::Exact,
    models::{Kepler, apsis},
    plan::Plan,
    problem::Problem,
};
use integrator_core::prelude::*;
use integrator_reference::DormandPrince5;
use std::f64::consts::TAU;

/// The steps of Dormand and Prince's method of order 5 along an eccentric orbit.
#[derive(Clone, Debug)]
pub(crate) struct Ellipse {
    /// Where the steps end.
    pub(crate) places: Vec<(f64, f64)>,
    /// The force at the middle of a step, and its length.
    pub(crate) lengths: Vec<(f64, f64)>,
    /// The exponent of the length against the force.
    pub(crate) exponent: f64,
}

/// The orbit of a system at the ends of its steps.
#[derive(Clone, Debug)]
pub(crate) struct Steps {
    /// The tolerance, in units of the orbit.
    pub(crate) tolerance: f64,
    /// In the view of the problem.
    pub(crate) portrait: Vec<(f64, f64)>,
    /// The change of the energy in units of the largest kinetic energy.
    pub(crate) change: f64,
}

/// The tolerance along the ellipse.
pub(crate) const TOLERANCE: f64 = 1e-6;
/// The tolerances of the portrait: a change of the energy is seen with the first of them, unless the orbit falls into a centre.
const COARSE: [f64; 3] = [1e-2, 1e-3, 1e-4];

/// Follows the steps along an eccentric orbit of Kepler's problem.
pub(crate) fn ellipse() -> Option<Ellipse> {
    let method = DormandPrince5 { tolerance: TOLERANCE };
    let steps = method.steps(&Kepler, &apsis(1.0), 2.0 * TAU, &[1.0; 4]).ok()?;
    let lengths = steps.windows(2).map(|pair| {
        let ((from, a), (to, b)) = (&pair[0], &pair[1]);
        let square = (0.5 * (a[0] + b[0])).powi(2) + (0.5 * (a[1] + b[1])).powi(2);
        (1.0 / square, to - from)
    });
    // The first step is a guess, and the last one ends with the span.
    let lengths: Vec<(f64, f64)> = lengths.collect::<Vec<_>>().get(2..steps.len().saturating_sub(2))?.to_vec();
    let places = steps.iter().map(|(_, state)| (state[0], state[1])).collect();
    Some(Ellipse { places, exponent: slope(&lengths), lengths })
}

/// Follows the steps along the orbit of a system; none if the method comes to no end.
pub(crate) fn steps<H: Hamiltonian>(problem: &Problem<'_, H>, plan: &Plan, exact: &Exact) -> Option<Steps> {
    let units = exact.size.map(|size| vec![size; problem.freedom()]).concat();
    let (tolerance, orbit) = COARSE.into_iter().find_map(|tolerance| {
        let steps =
            DormandPrince5 { tolerance }.steps(problem.system, &problem.start, plan.periods * problem.period, &units);
        Some((tolerance, steps.ok()?))
    })?;
    let states: Vec<_> = orbit.iter().map(|(_, numbers)| problem.state(numbers)).collect();
    let energy = |state: &Phase<H::Coords>| Some(problem.run(Verlet, state, problem.step).ok()?.energy());
    let change = (energy(states.last()?)? - energy(&problem.start)?) / exact.motion;
    Some(Steps { tolerance, portrait: states.iter().map(|state| problem.seen(state)).collect(), change })
}

/// The slope of the logarithms of points by least squares.
fn slope(points: &[(f64, f64)]) -> f64 {
    let logarithms = || points.iter().map(|(x, y)| (x.ln(), y.ln()));
    let count = points.len() as f64;
    let (x, y) = logarithms().fold((0.0, 0.0), |(x, y), point| (x + point.0 / count, y + point.1 / count));
    let (above, below) = logarithms().fold((0.0, 0.0), |(above, below), point| {
        (above + (point.0 - x) * (point.1 - y), below + (point.0 - x).powi(2))
    });
    above / below
}
