//! The search for the longest step of each composition within the tolerance.
//!
//! All candidates of a splitting get the same work, then twice as much, and so on, until one reaches the goal and the
//! others have had sixteen times its work. None of them hence costs much more than the best one, however far it is from
//! the goal. Evaluations of different splittings are different work, so splittings are compared by time.

use super::{
    Choice, ChooseError, Split, Unranked,
    candidate::Candidate,
    problem::{MOST_EVALUATIONS, Problem, stalled},
};
use crate::{
    check::CheckError,
    scalar::tolerance::within,
    state::{coords::Coords, precision::Precision},
};

/// The first round's evaluations.
const FIRST_ROUND: u64 = 64;

/// The largest work of a ranked composition, in units of the best one's.
pub(super) const SPREAD: u64 = 16;

/// The evaluations whose time is taken for that of all evaluations of a splitting, where this only decides how many are
/// worth trying.
const PACE: u64 = 1 << 12;

/// Bisection ends where the step that meets the tolerance and the one that does not differ by less than this factor.
const RESOLUTION: f64 = 1.02;

/// A candidate in the search.
struct Attempt<'s, C: Coords> {
    candidate: Candidate<'s, C>,
    /// The largest number of steps that missed the goal, zero before the first.
    missed: u64,
    /// The errors of the last two rounds.
    errors: [f64; 2],
}

/// The result of a search for one splitting: compositions that reach the goal, those with the fewest evaluations first,
/// and the one that comes closest.
pub(super) struct Found {
    pub(super) choices: Vec<Choice>,
    pub(super) closest: Unranked,
}

impl Found {
    /// Creates an empty result, with a reason.
    pub(super) fn none(splitting: Split, reason: &'static str) -> Self {
        let closest = Unranked { splitting, composition: "none", error: f64::INFINITY, not_tried: Some(reason) };
        Self { choices: Vec::new(), closest }
    }

    /// Adds what is other work than evaluations before the first one that takes longer, unless it takes sixteen times the
    /// time of the best.
    pub(super) fn insert_by_time(&mut self, choice: Option<Choice>) {
        let Some(choice) = choice else { return };
        let best = self.choices.iter().map(|other| other.seconds).fold(f64::INFINITY, f64::min);
        if choice.seconds <= SPREAD as f64 * best {
            let place = self.choices.iter().position(|other| other.seconds > choice.seconds);
            self.choices.insert(place.unwrap_or(self.choices.len()), choice);
        }
    }
}

/// Searches among the candidates of a splitting, without those that take sixteen times as long as `best`.
pub(super) fn search<C: Coords>(
    problem: &Problem<'_, C>,
    splitting: Split,
    candidates: Vec<Candidate<'_, C>>,
    best: f64,
) -> Result<Found, ChooseError> {
    let mut limit = affordable(problem, &candidates, best);
    let attempt = |candidate| Attempt { candidate, missed: 0, errors: [f64::INFINITY; 2] };
    let mut attempts: Vec<_> = candidates.into_iter().map(attempt).collect();
    let mut choices: Vec<Choice> = Vec::new();
    let mut closest = Unranked { splitting, composition: "none", error: f64::INFINITY, not_tried: None };
    let mut evaluations = FIRST_ROUND;
    while evaluations <= limit && !attempts.is_empty() {
        let mut open = Vec::with_capacity(attempts.len());
        for mut attempt in attempts {
            let steps = problem.whole(evaluations as f64 / attempt.candidate.each as f64);
            if steps == attempt.missed {
                open.push(attempt);
                continue;
            }
            let error = problem.error(&attempt.candidate, steps);
            if error < closest.error {
                closest = Unranked { composition: attempt.candidate.facts.name, error, ..closest };
            }
            if meets(problem, &attempt.candidate, steps, error) {
                let choice = attempt.refined(problem, splitting, steps, error)?;
                limit = limit.min(SPREAD * choice.evaluations);
                choices.push(choice);
            } else if !stalled(error, attempt.errors[0], C::Leaf::EPSILON) {
                attempt.missed = steps;
                attempt.errors = [attempt.errors[1], error];
                open.push(attempt);
            }
        }
        attempts = open;
        evaluations *= 2;
    }
    choices.retain(|choice| choice.evaluations <= limit);
    choices.sort_by_key(|choice| (choice.evaluations, choice.composition));
    Ok(Found { choices, closest })
}

/// Returns the number of evaluations that sixteen times `best` seconds are enough for.
fn affordable<C: Coords>(problem: &Problem<'_, C>, candidates: &[Candidate<'_, C>], best: f64) -> u64 {
    if best == f64::INFINITY {
        return MOST_EVALUATIONS;
    }
    let pace = |candidate: &Candidate<'_, C>| {
        let steps = problem.whole((PACE / candidate.each) as f64);
        Some(problem.seconds(candidate, steps).ok()? / candidate.evaluations(steps) as f64)
    };
    let affordable = candidates.iter().find_map(pace).map(|pace| SPREAD as f64 * best / pace);
    affordable.map_or(MOST_EVALUATIONS, |evaluations| MOST_EVALUATIONS.min(evaluations as u64))
}

impl<C: Coords> Attempt<'_, C> {
    /// The fewest steps that meet the goal, between those that miss it and those that are known to meet it.
    fn refined(
        &self,
        problem: &Problem<'_, C>,
        splitting: Split,
        mut steps: u64,
        mut error: f64,
    ) -> Result<Choice, ChooseError> {
        let candidate = &self.candidate;
        let mut missed = self.missed;
        loop {
            let middle = problem.whole((missed.max(1) as f64 * steps as f64).sqrt());
            if middle <= missed || middle >= steps || steps as f64 <= missed as f64 * RESOLUTION {
                break;
            }
            let found = problem.error(candidate, middle);
            if meets(problem, candidate, middle, found) {
                (steps, error) = (middle, found);
            } else {
                missed = middle;
            }
        }
        Ok(Choice {
            splitting,
            composition: candidate.facts.name,
            order: candidate.facts.order,
            class: candidate.class,
            step: candidate.step(problem.span / steps as f64),
            steps,
            tolerance: None,
            error,
            evaluations: problem.evaluations(candidate, steps).map_err(CheckError::from)?,
            seconds: problem.seconds(candidate, steps).map_err(CheckError::from)?,
        })
    }
}

/// Whether `error` is within the tolerance, and not because it happens to vanish for this number of steps alone.
fn meets<C: Coords>(problem: &Problem<'_, C>, candidate: &Candidate<'_, C>, steps: u64, error: f64) -> bool {
    let tolerance = problem.goal.tolerance();
    within(error, tolerance) && within(problem.error(candidate, problem.finer(steps)), tolerance)
}
