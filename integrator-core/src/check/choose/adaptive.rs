//! The search for the loosest tolerance with which Taylor's method reaches the goal.
//!
//! The method chooses its own steps, and its evaluations are orders of series, which are a different kind of work than
//! forces. It is hence compared with compositions by time.

use super::{
    Choice, ChooseError, Split,
    candidate::{Candidate, by_method},
    problem::{Problem, stalled},
};
use crate::{
    check::CheckError,
    composition::Class,
    hamiltonian::Hamiltonian,
    methods::taylor::{Recurrences, RecurrencesVisitor, Taylor},
    scalar::tolerance::within,
    state::{coords::Coords, precision::Precision},
    system::Shaped,
};

/// Digits of the tightest tolerance, beyond which steps become shorter and nothing else.
const MOST_DIGITS: i32 = 20;

/// Tolerances are tried in quarters of a digit: the work changes by three per cent.
const QUARTERS: i32 = 4;

/// The number of samples of the energy.
const LOOKS: f64 = 256.0;

/// A system by Taylor's method with any tolerance.
pub(super) type ByTaylor<'s, C> = Box<dyn Fn(Taylor) -> Candidate<'s, C> + 's>;

/// The runs of a system by Taylor's method, where its recurrences were written.
pub(super) fn by_taylor<H: Hamiltonian, K: Precision>(system: &H) -> Option<ByTaylor<'_, Shaped<H, K>>> {
    struct Written<'s, H: Hamiltonian, K: Precision> {
        system: &'s H,
        found: Option<ByTaylor<'s, Shaped<H, K>>>,
    }
    impl<H: Hamiltonian, K: Precision> RecurrencesVisitor<H> for Written<'_, H, K> {
        fn visit(&mut self)
        where
            H: Recurrences,
        {
            let system = self.system;
            self.found = Some(Box::new(move |method| by_method::<H, K, Taylor>(system, method, Class::General)));
        }
    }
    let mut written = Written::<H, K> { system, found: None };
    H::visit_recurrences(&mut written);
    written.found
}

/// The loosest tolerance that meets the goal, if one does.
pub(super) fn search<C: Coords>(
    problem: &Problem<'_, C>,
    splitting: Split,
    by_taylor: &ByTaylor<'_, C>,
) -> Result<Option<Choice>, ChooseError> {
    let candidate = |quarters: i32| by_taylor(Taylor::tolerance(tolerance(quarters)));
    let error = |quarters| problem.error(&candidate(quarters), problem.whole(LOOKS));
    let goal = problem.goal.tolerance();
    let meets = |found: f64, quarters| within(found, goal) && within(error(quarters + 1), goal);
    let mut errors = [f64::INFINITY; 2];
    for digits in 1..=MOST_DIGITS {
        let coarse = error(QUARTERS * digits);
        if !meets(coarse, QUARTERS * digits) {
            if stalled(coarse, errors[0], C::Leaf::EPSILON) {
                break;
            }
            errors = [errors[1], coarse];
            continue;
        }
        let looser = QUARTERS * (digits - 1) + 1..QUARTERS * digits;
        let found = looser.map(|quarters| (quarters, error(quarters)));
        let mut found = found.filter(|(quarters, error)| meets(*error, *quarters));
        let (quarters, error) = found.next().unwrap_or((QUARTERS * digits, coarse));
        return choice(problem, splitting, &candidate(quarters), tolerance(quarters), error).map(Some);
    }
    Ok(None)
}

/// The tolerance of this number of quarters of a digit.
fn tolerance(quarters: i32) -> f64 {
    10.0_f64.powf(-f64::from(quarters) / f64::from(QUARTERS))
}

fn choice<C: Coords>(
    problem: &Problem<'_, C>,
    splitting: Split,
    candidate: &Candidate<'_, C>,
    tolerance: f64,
    error: f64,
) -> Result<Choice, ChooseError> {
    let (run, seconds) = problem.whole_run(candidate).map_err(CheckError::from)?;
    let steps = run.own_steps().map_or(0, |own| own.taken) + 1;
    Ok(Choice {
        splitting,
        composition: candidate.facts.name,
        order: candidate.facts.order,
        class: candidate.class,
        step: problem.span / steps as f64,
        steps,
        tolerance: Some(tolerance),
        error,
        evaluations: run.evaluations(),
        seconds,
    })
}
