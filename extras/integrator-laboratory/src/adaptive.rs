//! Runge–Kutta with steps by an error estimate: the steps along an orbit, and against the force.
//!
//! An orbit of Kepler's problem with eccentricity 0.8 is the same for all systems. The estimate of a pair of orders 5 and 4 grows
//! with the fifth power of the step, so that steps follow the time in which the force changes: at a distance `r` that is
//! `r^(3/2)`, the power −3/4 of the force `1/r²` (Hairer, Nørsett and Wanner 1993, section II.4).

use crate::{errors::Exact, plan::Plan, problem::Problem};
use integrator_core::prelude::*;
use integrator_reference::DormandPrince5;

/// A planet with a mass of one.
struct Kepler;

#[hamiltonian]
impl Kepler {
    fn kinetic(&self, [px, py]: [f64; 2]) -> f64 {
        0.5 * (px * px + py * py)
    }
    fn potential(&self, [x, y]: [f64; 2]) -> f64 {
        -1.0 / (x * x + y * y).sqrt()
    }
}

/// The steps of Dormand and Prince's method of order 5.
#[derive(Clone, Debug)]
pub(crate) struct Steps {
    /// Where the steps end on the eccentric orbit.
    pub(crate) ellipse: Vec<(f64, f64)>,
    /// The force at the middle of a step, and its length.
    pub(crate) lengths: Vec<(f64, f64)>,
    /// The exponent of the length against the force.
    pub(crate) exponent: f64,
    /// The orbit of the system itself at the ends of the steps, in the view of the problem, and the change of its energy in units of
    /// the largest kinetic energy; empty if the method comes to no end.
    pub(crate) portrait: Vec<(f64, f64)>,
    pub(crate) change: f64,
}

/// The eccentricity, and the tolerance of its steps.
pub(crate) const ECCENTRICITY: f64 = 0.8;
pub(crate) const TOLERANCE: f64 = 1e-6;
/// The tolerance of the portrait, with which a change of the energy is seen.
pub(crate) const COARSE: f64 = 1e-2;

/// Follows the steps along the eccentric orbit and that of the system.
pub(crate) fn steps<H: Hamiltonian>(problem: &Problem<'_, H>, plan: &Plan, exact: &Exact) -> Option<Steps> {
    let aphelion = Phase::new([1.0 + ECCENTRICITY, 0.0], [0.0, ((1.0 - ECCENTRICITY) / (1.0 + ECCENTRICITY)).sqrt()]);
    let method = DormandPrince5 { tolerance: TOLERANCE };
    let ellipse = method.steps(&Kepler, &aphelion, 2.0 * std::f64::consts::TAU, &[1.0; 4]).ok()?;
    let lengths = ellipse.windows(2).map(|pair| {
        let ((from, a), (to, b)) = (&pair[0], &pair[1]);
        let square = (0.5 * (a[0] + b[0])).powi(2) + (0.5 * (a[1] + b[1])).powi(2);
        (1.0 / square, to - from)
    });
    // The first step is a guess, and the last one ends with the span.
    let lengths: Vec<(f64, f64)> = lengths.collect::<Vec<_>>().get(2..ellipse.len().saturating_sub(2))?.to_vec();
    let units = exact.size.map(|size| vec![size; problem.freedom()]).concat();
    let own = DormandPrince5 { tolerance: COARSE };
    let orbit = own.steps(problem.system, &problem.start, plan.periods * problem.period, &units).unwrap_or_default();
    let states: Vec<_> = orbit.iter().map(|(_, numbers)| problem.state(numbers)).collect();
    let energy = |state: &Phase<H::Coords>| Some(problem.run(Verlet, state, problem.step).ok()?.energy());
    let change = states.last().and_then(|end| Some((energy(end)? - energy(&problem.start)?) / exact.motion));
    Some(Steps {
        exponent: slope(&lengths),
        ellipse: ellipse.iter().map(|(_, state)| (state[0], state[1])).collect(),
        lengths,
        portrait: states.iter().map(|state| problem.seen(state)).collect(),
        change: change.unwrap_or(f64::NAN),
    })
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
