//! The proof. In: the stages of a step. Out: a scheme with the orders that its conditions establish.
//!
//! A condition holds if its residual is below a tolerance. The exact size of the tolerance decides no result: the
//! catalogue has residuals below 1e-31, and the first violated condition of any known method is above 1e-8.
//!
//! - Rounding: a coefficient of degree `n` adds terms up to `S^n/n!`, where `S` is the sum of the absolute durations.
//!   It is known to 2^-104 of that; the tolerance is at least [`FINEST`].
//! - Digits: an uncertainty `u` of one duration changes the coefficient by at most `u S^(n-1)/(n-1)!`. Decimals with 15
//!   digits thus pass with residuals around 1e-14, while one with 36 digits is an error if its twentieth digit is
//!   wrong. A residual above [`COARSEST`] is a violation for any number of digits.

use super::{
    coefficient::Coefficient,
    conditions::{self, HIGHEST, Series, Word},
    friction,
    leading_error::{Term, general_terms, norm, quadratic_terms},
    stages::{Letter, Letters, Stages},
};

/// The smallest tolerance.
const FINEST: f64 = 1e-30;

/// The largest tolerance.
const COARSEST: f64 = 1e-9;

/// Below this, a violated condition is more likely a mistake in the digits than another method.
pub(super) const SUSPICIOUS: f64 = 1e-7;

/// The Hamiltonians that a composition is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Class {
    General,
    QuadraticKinetic,
}

/// A proved composition.
#[derive(Clone, Debug)]
pub(super) struct Scheme {
    /// One step; of the kernel, if there is a processor.
    pub(super) stages: Stages,
    /// What comes once before the first step, and its inverse before output; mostly nothing.
    pub(super) processor: Stages,
    pub(super) proof: Proof,
    pub(super) class: Class,
    /// The proved order for the class.
    pub(super) order: u32,
    /// The generalised orders that are claimed, for a second part that is small; mostly none.
    pub(super) generalised: Vec<u32>,
    /// What its sequence calls the two parts.
    pub(super) letters: Letters,
}

impl Scheme {
    /// The scheme of stages about which nothing is claimed: general, unless it has gradient kicks.
    pub(super) fn inferred(stages: Stages, processor: Stages) -> Self {
        let proof = match stages.has_friction() {
            true => friction::proof(&stages),
            false => prove(&whole(&stages, &processor)),
        };
        let (class, verdict) = match proof.general {
            Some(general) => (Class::General, general),
            None => (Class::QuadraticKinetic, proof.quadratic),
        };
        let (order, letters) = (verdict.order, Letters::default());
        Self { stages, processor, proof, class, order, generalised: Vec::new(), letters }
    }

    /// The same composition without its friction.
    pub(super) fn without_friction(&self) -> Self {
        match self.stages.has_friction() {
            true => Self { letters: self.letters, ..Self::inferred(self.stages.without_friction(), Stages::default()) },
            false => self.clone(),
        }
    }

    /// What the conditions say for the class.
    pub(super) fn verdict(&self) -> Verdict {
        match (self.class, self.proof.general) {
            (Class::General, Some(general)) => general,
            _ => self.proof.quadratic,
        }
    }

    /// The leading error for the class, where it is known and finite.
    pub(super) fn leading_error(&self) -> Option<f64> {
        self.verdict().leading_error.filter(|norm| norm.is_finite())
    }

    /// What the leading error is made of; nothing where it is not known.
    pub(super) fn error_terms(&self) -> Vec<Term> {
        if self.leading_error().is_none() {
            return Vec::new();
        }
        let degree = self.order as usize + 1;
        let series = Series::of(whole(&self.stages, &self.processor).elements(), degree);
        match self.class {
            Class::General => general_terms(&series, degree),
            Class::QuadraticKinetic => quadratic_terms(&series, degree),
        }
    }
}

/// The words that decide a degree for the Hamiltonians of a class.
pub(super) fn words(class: Class, degree: usize) -> Vec<Word> {
    match class {
        Class::General => conditions::general(degree),
        Class::QuadraticKinetic => conditions::quadratic(degree),
    }
}

/// One step, with its processor before it and the inverse of the processor after it.
pub(super) fn whole(stages: &Stages, processor: &Stages) -> Stages {
    let mut whole = processor.clone();
    whole.append(stages, Coefficient::ONE);
    whole.append(&processor.inverse(), Coefficient::ONE);
    whole
}

/// What the conditions say about a step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Proof {
    pub(crate) symmetric: bool,
    /// For every `T(p)`; absent if the step has gradient kicks, which exist for quadratic `T` alone.
    pub(crate) general: Option<Verdict>,
    /// For `T` quadratic in `p`.
    pub(crate) quadratic: Verdict,
}

/// The order of a step for one class of Hamiltonians.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Verdict {
    /// All conditions up to this degree hold.
    pub(crate) order: u32,
    /// A condition of the next degree that does not hold, the worst one; absent at the highest order that is proved.
    pub(crate) violation: Option<Violation>,
    /// The norm of all residuals of the next degree, as [`super::leading_error`] has it.
    pub(super) leading_error: Option<f64>,
}

/// A condition that does not hold.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Violation {
    pub(super) word: Word,
    pub(super) residual: f64,
}

impl Violation {
    /// What is violated, in the letters of its sequence.
    pub(super) fn text(&self, letters: Letters) -> String {
        let (word, residual) = (self.word.spelled(letters), self.residual.abs());
        let suspicion = match residual < SUSPICIOUS {
            true => "\nnote: so small a residual suggests wrong or missing digits",
            false => "",
        };
        format!("the order condition of the word {word} has a residual of {residual:.1e}{suspicion}")
    }
}

/// The orders of a step.
///
/// The logarithm of a symmetric step has no terms of even degree, so their conditions hold once the odd ones below do.
/// The series is grown in strides, because most steps are rejected or decided by its first few degrees.
fn prove(stages: &Stages) -> Proof {
    let symmetric = stages.is_symmetric();
    let mut general = Verdict::OPEN;
    let mut quadratic = Verdict::OPEN;
    for stride in [1..=3, 4..=5, 6..=7, 8..=HIGHEST] {
        let last = if symmetric { *stride.end() - 1 + stride.end() % 2 } else { *stride.end() };
        let series = Series::of(stages.elements(), last);
        for degree in stride.filter(|degree| !symmetric || degree % 2 == 1) {
            let tolerance = tolerance(stages, degree);
            if general.violation.is_none() && general.examine(&series, conditions::general(degree), tolerance) {
                general.leading_error = Some(norm(&general_terms(&series, degree)));
            }
            if quadratic.violation.is_none() && quadratic.examine(&series, conditions::quadratic(degree), tolerance) {
                quadratic.leading_error = Some(norm(&quadratic_terms(&series, degree)));
            }
        }
        if quadratic.violation.is_some() {
            break;
        }
    }
    if general.violation.is_none() {
        let series = Series::of(stages.elements(), HIGHEST + 1);
        general.leading_error = Some(norm(&general_terms(&series, HIGHEST + 1)));
    }
    Proof { symmetric, general: (!stages.has_gradients()).then_some(general), quadratic }
}

impl Verdict {
    /// Before any condition was found violated.
    const OPEN: Self = Self { order: HIGHEST as u32, violation: None, leading_error: None };

    /// Whether one of the conditions of the next degree is violated; if so, the order is settled.
    fn examine(&mut self, series: &Series, words: Vec<Word>, tolerance: f64) -> bool {
        let residuals = words.into_iter().map(|word| Violation { word, residual: series.residual(word) });
        // A residual that is not a number is a violation too.
        let worst = residuals
            .filter(|condition| condition.residual.is_nan() || condition.residual.abs() > tolerance)
            .reduce(|worst, next| if next.residual.abs() > worst.residual.abs() { next } else { worst });
        if let Some(violation) = worst {
            self.order = violation.word.degree() as u32 - 1;
            self.violation = worst;
        }
        worst.is_some()
    }
}

/// How large a residual of this degree may be.
pub(super) fn tolerance(stages: &Stages, degree: usize) -> f64 {
    let mut durations = [0.0_f64; 2];
    let mut doubt = 0.0;
    for element in stages.elements() {
        durations[usize::from(element.letter == Letter::V)] += element.coefficient.value.abs().value();
        doubt += element.coefficient.doubt + element.gradient.doubt;
    }
    let [length, other] = durations;
    let length = length.max(other).max(1.0);
    let derivative = (1..degree).fold(1.0, |product, k| product * length / k as f64).max(1.0);
    let rounding = f64::EPSILON * f64::EPSILON * derivative * length / degree as f64;
    (rounding.max(FINEST) + doubt * derivative).min(COARSEST)
}
