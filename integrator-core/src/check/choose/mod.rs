//! The search for the cheapest composition for a problem, and for its step.
//!
//! In: a system, a start, a time span, what has to be how accurate. Out: a ranking of the compositions of the catalogue
//! that this Hamiltonian admits. Always true: every step in the ranking was run, on this very problem and in the
//! precision of its start, and met the tolerance; so did a slightly finer one, lest an error that happens to vanish at
//! one step size passes for accuracy. Work is counted in evaluations, which no other program on the machine disturbs.

mod candidate;
mod error;
mod problem;
mod ranking;
mod search;

pub use error::ChooseError;
pub use ranking::{Choice, Ranking};

use crate::{
    check::{CheckError, start::Start, statistics::points::begin},
    hamiltonian::{Hamiltonian, Shaped},
    scalar::tolerance::within,
    state::precision::Precision,
};
use problem::Problem;

/// The accuracy that is asked for over the span.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Goal {
    /// The largest deviation of the energy from its start, in units of the largest kinetic energy on the way, or of what
    /// [`EnergyDrift`](crate::check::EnergyDrift) takes for it.
    Energy(f64),
    /// The distance from the true motion, as the root of its mean square over four equally spaced times, the last one
    /// at the end; positions and momenta each in units of how far they go from the start. The true motion is a Taylor
    /// series where `#[hamiltonian(taylor)]` wrote its recurrences, and else a run of order 10, refined until it
    /// settles.
    Trajectory(f64),
}

impl Goal {
    /// The tolerance, whatever for.
    pub fn tolerance(self) -> f64 {
        match self {
            Self::Energy(tolerance) | Self::Trajectory(tolerance) => tolerance,
        }
    }
}

/// Ranks the compositions of the catalogue by the work with which each of them reaches `goal` from `start`
/// over `span`, cheapest first.
///
/// Work is the number of force evaluations, where a gradient of the squared force counts as one more, and a processor
/// is charged once. Compositions that need more than sixteen times the work of the best are left out.
///
/// Where the clock decides on pieces of the Hamiltonian, all steps in the ranking end where these do.
///
/// The span should be long enough to show what matters, some periods of the slowest motion, but no longer: all of it is
/// run some hundred times. A start with compensated leaves finds the best composition for compensated runs.
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
/// A span, a start or a tolerance that no run can have; an energy that is not conserved because the Hamiltonian reads
/// the time; edges between pieces in time that no equal steps over the span meet; a motion that cannot be followed to
/// the tolerance; a tolerance that no composition reaches.
pub fn choose<H: Hamiltonian, K: Precision>(
    system: &H,
    start: impl Into<Start<Shaped<H, K>>>,
    span: f64,
    goal: Goal,
) -> Result<Ranking, ChooseError> {
    if span == 0.0 || !span.is_finite() {
        return Err(ChooseError::Span { span });
    }
    let start = start.into();
    begin::<H, _, K>(system, H::Compose::default(), &start, span).map_err(CheckError::from)?;
    let tolerance = goal.tolerance();
    if !within(tolerance, f64::MAX) || tolerance <= 0.0 {
        return Err(ChooseError::Tolerance { tolerance });
    }
    let problem = Problem::<H, K>::new(system, start, span, goal)?;
    let mut candidates = candidate::Candidates(Vec::new());
    H::visit_compositions(&mut candidates);
    search::rank(&problem, candidates.0)
}
