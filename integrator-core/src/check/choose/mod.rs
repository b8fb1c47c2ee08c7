//! The search for the cheapest composition for a problem, and for its step.
//!
//! In: a system, a start, a time span, a target accuracy. Out: a ranking of the compositions of the catalogue that can
//! integrate this Hamiltonian, or of those of several splittings. Always true: every step in the ranking was run for
//! this problem, in the precision of its start, and reached the goal. So did a slightly finer one, since an error may
//! vanish by chance at one step size. Work is counted in evaluations, which are independent of other programs on the
//! machine.

mod adaptive;
mod candidate;
mod error;
mod nested;
mod pace;
mod problem;
mod ranking;
mod search;
mod splitting;

pub use candidate::{Candidate, candidates, candidates_with};
pub use error::ChooseError;
pub use nested::NestedSteps;
pub use pace::{LogarithmicSteps, PacedSteps};
pub use ranking::{Choice, Ranking, Split, Unranked};
pub use splitting::Splitting;

use crate::{
    check::{
        CheckError,
        start::{IntoStart, Start},
    },
    hamiltonian::Hamiltonian,
    scalar::tolerance::within,
    state::{coords::Coords, precision::Precision},
    system::Shaped,
};
use problem::Problem;
use search::{Found, SPREAD, search};
use splitting::Measured;

/// The target accuracy over the span.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Goal {
    /// The largest deviation of the energy from its initial value, in units of the largest kinetic energy of the run.
    ///
    /// [`EnergyDrift`](crate::check::EnergyDrift) defines the kinetic energy if the parts of `H` are not `T(p)` and
    /// `V(q)`.
    Energy(f64),
    /// The root mean square distance from the reference solution at four equally spaced times, the last one at the end.
    ///
    /// Positions and momenta are each in units of how far they go from the start. The reference solution is a Taylor
    /// series if `#[hamiltonian(taylor)]` generated recurrences. Otherwise it is a run of order 10, refined until it
    /// converges. If `H` is not split, it is a run by `GaussLegendre6`, of order 6.
    Trajectory(f64),
}

impl Goal {
    /// Returns the tolerance of either goal.
    pub fn tolerance(self) -> f64 {
        match self {
            Self::Energy(tolerance) | Self::Trajectory(tolerance) => tolerance,
        }
    }
}

/// Ranks the compositions of the catalogue by the work to reach `goal` from `start` over `span`, cheapest first.
///
/// - Work is the number of force evaluations. A gradient of the squared force counts as one more evaluation, and a
///   processor is counted once.
/// - Compositions that need more than sixteen times the work of the best one are left out.
/// - If `split = none` leaves `H` unsplit, the implicit methods are ranked instead, by the evaluations of the vector
///   field that their runs count.
/// - If parts take inner steps, their number is chosen as well, from 1 to 32, and processor time on this machine is compared.
/// - If `#[hamiltonian(taylor)]` generated recurrences, Taylor's method is included, with the loosest tolerance that
///   reaches the goal. Its evaluations are a different kind of work: it is placed before the first composition that
///   takes longer.
/// - If conditions on the time select pieces of the Hamiltonian, all steps in the ranking end at the edges of these
///   pieces.
///
/// The span should cover some periods of the slowest motion, but not more: it is integrated about a hundred times. A
/// start with compensated coordinates finds the best composition for compensated runs.
///
/// ```
/// use integrator_core::{check::{Goal, choose}, prelude::*};
///
/// struct Pendulum;
///
/// #[hamiltonian]
/// impl Pendulum {
///     fn kinetic(&self, p: [f64; 1]) -> f64 {
///         0.5 * p[0] * p[0]
///     }
///     fn potential(&self, q: [f64; 1]) -> f64 {
///         -q[0].cos()
///     }
/// }
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let ranking = choose(&Pendulum, Phase::new([2.0], [0.0]), 20.0, Goal::Trajectory(1e-3))?;
/// let best = ranking.best();
/// assert!(best.step > 0.1 && best.error <= 1e-3);
/// println!("{ranking}");
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// - The span, the start or the tolerance is invalid.
/// - The goal is an energy error, but the Hamiltonian depends on time.
/// - The Hamiltonian has pieces in time whose edges equal steps over the span cannot meet.
/// - The reference solution cannot be computed to the tolerance.
/// - No composition reaches the tolerance.
pub fn choose<H: Hamiltonian, K: Precision>(
    system: &H,
    start: impl IntoStart<Shaped<H, K>, Leaf = K>,
    span: f64,
    goal: Goal,
) -> Result<Ranking, ChooseError> {
    let start = start.into_start();
    if const { H::NESTED.is_empty() } {
        return rank(&[system], start, span, goal);
    }
    let splittings = nested::TRIED.map(|steps| NestedSteps { system, steps });
    by_time(&splittings.each_ref().map(|splitting| splitting as &dyn Measured<_>), start, span, goal)
}

/// Ranks compositions of several splittings of one Hamiltonian by the time that they need to reach `goal`, fastest first.
///
/// Splittings are systems with the same coordinates. Examples are `kinetic` and `potential`, the same bodies with
/// `coordinates = jacobi(..)`, and `split = quadratic + rest`. Force evaluations of different splittings cost different
/// amounts of work, so that processor time on this machine is compared. Candidates that need more than sixteen times the
/// time of the best one are left out.
///
/// The reference solution, or the energy, is that of the first splitting.
///
/// [`LogarithmicSteps`] and [`PacedSteps`] are splittings as well: they control the step size of a system by a fictitious
/// time, and are compared at the same physical times. [`Ranking::unranked`] lists the splittings without a result, with
/// reasons; a system with another Hamiltonian is among them with its error.
///
/// ```
/// use integrator_core::{check::{Goal, choose_among}, prelude::*};
///
/// /// Two oscillators with a weak coupling.
/// struct Oscillators;
///
/// #[hamiltonian]
/// impl Oscillators {
///     fn kinetic(&self, p: [f64; 2]) -> f64 {
///         (p[0] * p[0] + p[1] * p[1]) / 2.0
///     }
///     fn potential(&self, q: [f64; 2]) -> f64 {
///         (q[0] * q[0] + q[1] * q[1]) / 2.0 + 1e-3 * q[0] * q[0] * q[1] * q[1]
///     }
/// }
///
/// /// The same, with what is quadratic solved exactly.
/// struct Solved;
///
/// #[hamiltonian(split = quadratic + rest, compose = Aba864)]
/// impl Solved {
///     fn hamiltonian(&self, q: [f64; 2], p: [f64; 2]) -> f64 {
///         (p[0] * p[0] + p[1] * p[1] + q[0] * q[0] + q[1] * q[1]) / 2.0 + 1e-3 * q[0] * q[0] * q[1] * q[1]
///     }
/// }
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// let start = Phase::new([1.0, 0.5], [0.0, 0.8]);
/// let ranking = choose_among(&[&Oscillators, &Solved], start, 60.0, Goal::Trajectory(1e-6))?;
/// assert!(ranking.best().error <= 1e-6);
/// // A table whose first column is `Oscillators (kinetic + potential)` or `Solved (quadratic + rest)`.
/// println!("{ranking}");
/// # Ok(())
/// # }
/// ```
///
/// # Errors
/// Those of [`choose`], for any of the splittings; there is no splitting.
pub fn choose_among<C: Coords>(
    splittings: &[&dyn Splitting<C>],
    start: impl Into<Start<C>>,
    span: f64,
    goal: Goal,
) -> Result<Ranking, ChooseError> {
    let splittings: Vec<&dyn Measured<C>> = splittings.iter().map(|splitting| splitting.measured().0).collect();
    let ranking = by_time(&splittings, start.into(), span, goal)?;
    Ok(Ranking { among: true, ..ranking })
}

/// The ranking by processor time.
fn by_time<C: Coords>(
    splittings: &[&dyn Measured<C>],
    start: Start<C>,
    span: f64,
    goal: Goal,
) -> Result<Ranking, ChooseError> {
    let mut ranking = rank(splittings, start, span, goal)?;
    ranking.choices.sort_by(|a, b| a.seconds.total_cmp(&b.seconds));
    Ok(ranking)
}

/// The ranking by evaluations, one splitting after the other.
fn rank<C: Coords>(
    splittings: &[&dyn Measured<C>],
    start: Start<C>,
    span: f64,
    goal: Goal,
) -> Result<Ranking, ChooseError> {
    if span == 0.0 || !span.is_finite() {
        return Err(ChooseError::Span { span });
    }
    for splitting in splittings {
        splitting.begin(&start, span).map_err(CheckError::from)?;
    }
    let tolerance = goal.tolerance();
    if !within(tolerance, f64::MAX) || tolerance <= 0.0 {
        return Err(ChooseError::Tolerance { tolerance });
    }
    let first = splittings.first().ok_or(ChooseError::NoSplitting)?;
    let problem = Problem::new(*first, start, span, goal)?;
    let (mut found, mut best) = (Vec::new(), f64::INFINITY);
    for splitting in splittings {
        let name = splitting.name();
        let mut of_one = match splitting.candidates(&problem.start, span) {
            Ok(candidates) => search(&problem, name, candidates, best)?,
            Err(reason) => Found::none(name, reason),
        };
        if let Some(by_taylor) = splitting.by_taylor() {
            of_one.insert_by_time(adaptive::search(&problem, name, &by_taylor)?);
        }
        best = of_one.choices.iter().fold(best, |best, choice| best.min(choice.seconds));
        found.push(of_one);
    }
    ranked(found, tolerance, best)
}

/// Ranks the choices within the spread of the best time, or of the fewest evaluations of a single splitting.
fn ranked(mut found: Vec<Found>, tolerance: f64, best: f64) -> Result<Ranking, ChooseError> {
    if found.len() > 1 {
        for Found { choices, .. } in &mut found {
            choices.retain(|choice| choice.seconds <= SPREAD as f64 * best);
        }
    }
    let (mut choices, mut unranked) = (Vec::new(), Vec::new());
    for Found { choices: of_one, closest } in found {
        if of_one.is_empty() {
            unranked.push(closest);
        }
        choices.extend(of_one);
    }
    if choices.is_empty() {
        unranked.sort_by(|a, b| a.error.total_cmp(&b.error));
        let Unranked { composition, error, .. } = unranked[0];
        return Err(ChooseError::Unreached { tolerance, composition, error });
    }
    Ok(Ranking { choices, unranked, among: false })
}
