//! The search for each composition's longest step within the tolerance.
//!
//! All candidates are given the same work, then twice as much, and so on, until the first one reaches the goal and the
//! others had sixteen times its work. So none of them costs much more than the best, however far from the goal it is.

use super::{
    Choice, ChooseError, Ranking,
    candidate::Candidate,
    problem::{MOST_EVALUATIONS, Problem, stalled},
};
use crate::{check::CheckError, hamiltonian::Hamiltonian, scalar::tolerance::within, state::precision::Precision};

/// The first round's evaluations.
const FIRST_ROUND: u64 = 64;

/// The largest work of a ranked composition, in units of the best one's.
const SPREAD: u64 = 16;

/// Bisection ends where the step that meets the tolerance and the one that does not differ by less than this factor.
const RESOLUTION: f64 = 1.02;

/// A candidate in the search.
struct Attempt<H: Hamiltonian, K: Precision> {
    candidate: Candidate<H, K>,
    /// The largest number of steps that missed the goal, zero before the first.
    missed: u64,
    /// The errors of the last two rounds.
    errors: [f64; 2],
}

/// Ranks the candidates.
pub(super) fn rank<H: Hamiltonian, K: Precision>(
    problem: &Problem<'_, H, K>,
    candidates: Vec<Candidate<H, K>>,
) -> Result<Ranking, ChooseError> {
    let attempt = |candidate| Attempt { candidate, missed: 0, errors: [f64::INFINITY; 2] };
    let mut attempts: Vec<_> = candidates.into_iter().map(attempt).collect();
    let mut choices: Vec<Choice> = Vec::new();
    let (mut closest, mut smallest) = ("none", f64::INFINITY);
    let mut evaluations = FIRST_ROUND;
    let mut limit = MOST_EVALUATIONS;
    while evaluations <= limit && !attempts.is_empty() {
        let mut open = Vec::with_capacity(attempts.len());
        for mut attempt in attempts {
            let steps = problem.whole(evaluations as f64 / attempt.candidate.each as f64);
            if steps == attempt.missed {
                open.push(attempt);
                continue;
            }
            let error = problem.error(&attempt.candidate, steps);
            if error < smallest {
                (closest, smallest) = (attempt.candidate.name, error);
            }
            if meets(problem, &attempt.candidate, steps, error) {
                let choice = attempt.refined(problem, steps, error)?;
                limit = limit.min(SPREAD * choice.evaluations);
                choices.push(choice);
            } else if !stalled(error, attempt.errors[0], K::EPSILON) {
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
    if choices.is_empty() {
        let tolerance = problem.goal.tolerance();
        return Err(ChooseError::Unreached { tolerance, composition: closest, error: smallest });
    }
    Ok(Ranking(choices))
}

impl<H: Hamiltonian, K: Precision> Attempt<H, K> {
    /// The fewest steps that meet the goal, between those that miss it and those that are known to meet it.
    fn refined(&self, problem: &Problem<'_, H, K>, mut steps: u64, mut error: f64) -> Result<Choice, ChooseError> {
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
            composition: candidate.name,
            order: candidate.order,
            class: candidate.class,
            step: problem.span / steps as f64,
            steps,
            error,
            evaluations: candidate.evaluations(steps),
            seconds: problem.seconds(candidate, steps).map_err(CheckError::from)?,
        })
    }
}

/// Whether `error` is within the tolerance, and not because it happens to vanish for this number of steps alone.
fn meets<H: Hamiltonian, K: Precision>(
    problem: &Problem<'_, H, K>,
    candidate: &Candidate<H, K>,
    steps: u64,
    error: f64,
) -> bool {
    let tolerance = problem.goal.tolerance();
    within(error, tolerance) && within(problem.error(candidate, problem.finer(steps)), tolerance)
}
