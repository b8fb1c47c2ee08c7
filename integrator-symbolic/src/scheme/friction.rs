//! The proof of compositions with friction, the letter `O`.
//!
//! `O` is exact linear damping, or the Ornstein–Uhlenbeck process, whose generator is a differential operator like those of
//! `T` and `V`. A step is a product of exponentials of three operators that do not commute, and has order `n` if its
//! coefficient of every word of up to `n` letters is that of `exp(T + V + O)`, which is one over the factorial of the length. For
//! noise this is the weak order (Talay and Tubaro 1990, Stoch. Anal. Appl. 8, 483).

use super::{
    coefficient::Coefficient,
    conditions::factorial_inverse,
    double::Double,
    prove::{Proof, Verdict, tolerance},
    stages::{Element, Letter, Stages},
};

/// The highest order that is proved. A word of this length is one of 729.
const HIGHEST: usize = 6;

/// The largest number of stages of friction: the runtime numbers the random numbers of a step by one byte.
const MOST_STAGES: usize = 255;

/// The number of letters.
const LETTERS: usize = 3;

/// What a step with friction does not support: the message for it.
pub(super) fn refusal(kernel: &Stages, processor: &Stages) -> Option<String> {
    if processor.has_friction() {
        return Some("a processor cannot contain friction `O`, which has no inverse if there is noise".to_owned());
    }
    if !kernel.has_friction() {
        return None;
    }
    if !processor.elements().is_empty() {
        return Some("`processed(..)` does not support friction `O`".to_owned());
    }
    if kernel.has_gradients() {
        return Some(
            "a composition with friction `O` does not support force gradients\nhelp: use kicks `V(b)`".to_owned(),
        );
    }
    let count = kernel.elements().iter().filter(|element| element.letter == Letter::O).count();
    if count > MOST_STAGES {
        return Some(format!("the sequence has {count} stages `O`, and at most {MOST_STAGES} are supported"));
    }
    let tolerance = tolerance(kernel, 1);
    [('T', Letter::T), ('V', Letter::V), ('O', Letter::O)].into_iter().find_map(|(name, letter)| {
        let sum = (kernel.sum(letter) - Coefficient::ONE).value.value();
        (sum.is_nan() || sum.abs() > tolerance).then(|| not_one(&name.to_string(), 1.0 + sum))
    })
}

/// The message about coefficients that sum to something else than 1.
pub(super) fn not_one(word: &str, sum: f64) -> String {
    let sum = format!("{sum:.12}");
    format!("the coefficients of `{word}` sum to {}, not to 1", sum.trim_end_matches('0').trim_end_matches('.'))
}

/// The order of a step with friction.
pub(super) fn proof(stages: &Stages) -> Proof {
    let series = Series::of(stages.elements());
    let holds = |degree: &usize| series.residual(*degree) <= tolerance(stages, *degree);
    let order = (1..=HIGHEST).take_while(holds).count() as u32;
    let verdict = Verdict { order, violation: None, leading_error: None };
    Proof { symmetric: stages.is_symmetric(), general: Some(verdict), quadratic: verdict }
}

/// The coefficients of a step at all words in three letters, for each length up to [`HIGHEST`].
struct Series(Vec<Vec<Double>>);

impl Series {
    fn of(elements: &[Element]) -> Self {
        let words = (0..=HIGHEST as u32).map(|length| vec![Double::ZERO; LETTERS.pow(length)]);
        let mut series = Self(words.collect());
        series.0[0][0] = Double::ONE;
        elements.iter().for_each(|element| series.append(element.letter, element.coefficient.value));
        series
    }

    /// Multiplies by `exp(a X)`. The last letter of a word is its number modulo three. Longer words come first, so that those
    /// read are still the old ones.
    fn append(&mut self, letter: Letter, a: Double) {
        let letter = letter as usize;
        for length in (1..=HIGHEST).rev() {
            for word in (letter..self.0[length].len()).step_by(LETTERS) {
                let (mut rest, mut power, mut sum) = (word, Double::ONE, self.0[length][word]);
                for count in 1..=length {
                    if rest % LETTERS != letter {
                        break;
                    }
                    rest /= LETTERS;
                    power = power * a / Double::from(count as f64);
                    sum = sum + power * self.0[length - count][rest];
                }
                self.0[length][word] = sum;
            }
        }
    }

    /// The largest difference from the coefficients of the exact flow, among the words of a length.
    fn residual(&self, length: usize) -> f64 {
        let exact = factorial_inverse(length);
        self.0[length].iter().map(|coefficient| (*coefficient - exact).abs().value()).fold(0.0, f64::max)
    }
}

#[cfg(test)]
mod tests {
    use crate::scheme::tests::scheme;

    #[test]
    fn orders_of_known_splittings() {
        for (sequence, order, symmetric) in [
            ("V(1) T(1) O(1)", 1, false),
            ("V(1) T(1/2) O(1) T(1/2)", 1, false),
            ("V(1/2) T(1/2) O(1) T(1/2) V(1/2)", 2, true),
            ("O(1/2) V(1/2) T(1) V(1/2) O(1/2)", 2, true),
            ("triple_jump(V(1/2) T(1/2) O(1) T(1/2) V(1/2))", 4, true),
            ("triple_jump(triple_jump(T(1/2) V(1/2) O(1) V(1/2) T(1/2)))", 6, true),
            // Of order two in T and V alone.
            ("O(1) V(1/2) T(1) V(1/2)", 1, false),
            // Of order four in T and V alone, with friction in the wrong places.
            ("O(1/2) triple_jump(Verlet) O(1/2)", 2, true),
        ] {
            let scheme = scheme(sequence);
            assert_eq!((scheme.order, scheme.proof.symmetric), (order, symmetric), "{sequence}");
        }
    }

    #[test]
    fn friction_does_not_change_the_order_of_the_rest() {
        let scheme = scheme("O(1/2) V(1/2) T(1) V(1/2) O(1/2)");
        assert_eq!(scheme.without_friction().stages.elements().len(), 3);
    }
}
