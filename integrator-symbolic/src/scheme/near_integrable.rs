//! Generalised orders, for Hamiltonians with a small second part.
//!
//! For `H = A + ε B`, the errors of a step of generalised order `(n₁, n₂, …)` are `ε h^n₁`, `ε² h^n₂` and so on
//! (McLachlan 1995, BIT 35, 258). The words with `k` letters `B` have the coefficients of the exact flow up to the
//! length `n_k`. The letters are those of the stages: `A` is the part of drifts, `T`, and `B` that of kicks, `V`.
//!
//! Words with one `B` are decided by moments: that of `A…AB` is the sum of the kicks times powers of the time after the
//! preceding drifts. It is hence known for any length. Words with more `B` are read from the series, up to [`HIGHEST`].

use super::{
    conditions::{HIGHEST, Series, Word},
    double::Double,
    prove::{Scheme, Violation, tolerance, whole, words},
    stages::{Letter, Stages},
};

/// The longest word with one `B` that is examined. Beyond, powers of times leave too few of the digits.
pub(super) const LONGEST: usize = 30;

/// What holds of the words with this number of letters `B`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Found {
    /// All of them up to this length are right.
    pub(super) order: u32,
    /// One of the next length that is not; absent where longer ones are not examined.
    pub(super) violation: Option<Violation>,
}

/// The generalised orders of a scheme, for words with one `B`, two, and so on, up to the first that is the plain order:
/// words with more are right up to that one at least.
pub(super) fn orders(scheme: &Scheme) -> Vec<Found> {
    let whole = whole(&scheme.stages, &scheme.processor);
    let mut found = vec![with_one(&whole)];
    if found[0].order <= scheme.order {
        return found;
    }
    let series = Series::of(whole.elements(), HIGHEST);
    while found.last().is_some_and(|last| last.order > scheme.order) && found.len() < HIGHEST {
        found.push(with(found.len() + 1, &series, &whole, scheme));
    }
    found
}

/// The order of the words with one `B`: `n Σ bᵢ cᵢⁿ⁻¹ = 1` for all `n` up to it, where the kick `bᵢ` comes when the drifts
/// have reached `cᵢ`.
fn with_one(stages: &Stages) -> Found {
    let mut drifted = Double::ZERO;
    let (mut nodes, mut doubt) = (Vec::new(), 0.0);
    for element in stages.elements() {
        doubt += element.coefficient.doubt;
        match element.letter {
            Letter::T => drifted = drifted + element.coefficient.value,
            Letter::V => nodes.push((drifted, element.coefficient.value, Double::ONE)),
            Letter::O => {}
        }
    }
    for length in 1..=LONGEST {
        let n = length as f64;
        let (mut sum, mut size) = (Double::ZERO, 1.0);
        for (node, weight, power) in &mut nodes {
            let term = *weight * *power * Double::from(n);
            *power = *power * *node;
            sum = sum + term;
            size += term.value().abs();
        }
        let residual = (sum - Double::ONE).value();
        // Each product and each sum rounds to 2^-104; a doubt about a node moves its power by `n` times as much.
        let rounding = f64::EPSILON * f64::EPSILON * size * (n + nodes.len() as f64);
        if residual.is_nan() || residual.abs() > rounding + doubt * size * n {
            let violation = Violation { word: Word::with_one_kick(length), residual };
            return Found { order: length as u32 - 1, violation: Some(violation) };
        }
    }
    Found { order: LONGEST as u32, violation: None }
}

/// The order of the words with this number of `B`.
fn with(letters: usize, series: &Series, stages: &Stages, scheme: &Scheme) -> Found {
    for degree in 1..=HIGHEST {
        let tolerance = tolerance(stages, degree);
        let of_these = words(scheme.class, degree).into_iter().filter(|word| word.kicks() == letters);
        let violation = of_these
            .map(|word| Violation { word, residual: series.residual(word) })
            .find(|condition| condition.residual.is_nan() || condition.residual.abs() > tolerance);
        if violation.is_some() {
            return Found { order: degree as u32 - 1, violation };
        }
    }
    Found { order: HIGHEST as u32, violation: None }
}
