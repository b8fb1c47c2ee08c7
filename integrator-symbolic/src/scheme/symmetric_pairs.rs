//! Whether a step keeps its orders if its second part is itself a symmetric pair.
//!
//! If `B = J + I` has no exact flow, `J/2 I J/2` replaces it: `exp(b B + b³ E₃ + b⁵ E₅ + ...)`. It is symmetric, with
//! errors `E₃`, `E₅` of three and five letters `B`. These are additional letters, of degrees 3 and 5. A step keeps an
//! order if the words with one of them vanish up to that degree; the first condition is `Σ bᵢ³ = 0`. For generalised
//! orders, a word counts all its letters `B`, so those of an `E₃` are at least three (Blanes, Casas, Farres, Laskar,
//! Makazaga and Murua 2013, Applied Numerical Mathematics 68, 58).

use super::{
    conditions::factorial_inverse,
    double::Double,
    prove::{Class, Scheme, tolerance, whole},
    stages::{Element, Letter},
};
use std::iter;

/// A letter of a word: `A` for 0, else `B` or an error of it, by its degree.
type Weight = u32;

const A: Weight = 0;

/// Whether errors of a pair are no larger than those that the orders of a step leave.
pub(super) fn are_kept(scheme: &Scheme) -> bool {
    let highest = order(scheme, 3).max(scheme.order);
    scheme.class == Class::General && (3..=highest).all(|degree| vanish(scheme, degree))
}

/// The order of words with this number of letters `B`.
fn order(scheme: &Scheme, letters: u32) -> u32 {
    scheme.generalised.get(letters as usize - 1).copied().unwrap_or(scheme.order)
}

/// Whether the words of a degree with errors of a pair vanish, where an order requests it.
fn vanish(scheme: &Scheme, degree: u32) -> bool {
    // The logarithm of a symmetric step has no terms of even degree.
    if scheme.proof.symmetric && degree.is_multiple_of(2) {
        return true;
    }
    let stages = whole(&scheme.stages, &scheme.processor);
    let tolerance = tolerance(&stages, degree as usize);
    let asked = words(degree).into_iter().filter(|word| order(scheme, word.iter().sum()) >= degree);
    let factors = factors(stages.elements(), degree);
    asked.map(|word| coefficient(&factors, &word)).all(|coefficient| coefficient.abs().value() <= tolerance)
}

/// The words of a degree with at least one error of a pair, the shortest first.
fn words(degree: u32) -> Vec<Vec<Weight>> {
    let mut words = of_degree(degree);
    words.retain(|word| word.iter().any(|weight| *weight > 1));
    words.sort_by_key(Vec::len);
    words
}

/// All words of a degree.
fn of_degree(degree: u32) -> Vec<Vec<Weight>> {
    if degree == 0 {
        return vec![Vec::new()];
    }
    let last = [A].into_iter().chain((1..=degree).step_by(2));
    let longer = last.flat_map(|last| {
        let shorter = of_degree(degree - last.max(1));
        shorter.into_iter().map(move |mut word| {
            word.push(last);
            word
        })
    });
    longer.collect()
}

/// A stage as words read it: `b^k/k!` is that of `k` letters of degree 1.
struct Factors {
    letter: Letter,
    /// The powers of the coefficient, from the zeroth on.
    powers: Vec<Double>,
}

fn factors(stages: &[Element], degree: u32) -> Vec<Factors> {
    let powers = |b: Double| iter::successors(Some(Double::ONE), move |power| Some(*power * b));
    let highest = degree as usize + 1;
    let of = |stage: &Element| Factors {
        letter: stage.letter,
        powers: powers(stage.coefficient.value).take(highest).collect(),
    };
    stages.iter().map(of).collect()
}

/// The coefficient of a word in the product of all stages.
fn coefficient(stages: &[Factors], word: &[Weight]) -> Double {
    let mut beginnings = vec![Double::ZERO; word.len() + 1];
    beginnings[0] = Double::ONE;
    let orders: Vec<Double> = (0..=word.len()).map(factorial_inverse).collect();
    for Factors { letter, powers } in stages {
        // Longer beginnings first, so that those read are still without this stage.
        for end in (1..=word.len()).rev() {
            let (mut degree, mut sum) = (0, beginnings[end]);
            let of_stage = |weight: &Weight| (*letter == Letter::T) == (*weight == A);
            for (count, weight) in word[..end].iter().rev().take_while(|weight| of_stage(weight)).enumerate() {
                degree += (*weight).max(1) as usize;
                sum = sum + powers[degree] * orders[count + 1] * beginnings[end - count - 1];
            }
            beginnings[end] = sum;
        }
    }
    beginnings[word.len()]
}

#[cfg(test)]
mod tests {
    use super::{are_kept, coefficient, factors, words};
    use crate::{
        errors::Errors,
        scheme::{
            coefficient::Coefficient,
            lower::{Known, lower},
            prove::Scheme,
            stages::{Element, Letter},
            syntax,
        },
    };
    use proc_macro2::TokenStream;
    use syn::parse::{ParseStream, Parser};

    fn scheme(text: &str) -> Scheme {
        let parser = |input: ParseStream<'_>| {
            let mut errors = Errors::default();
            let sequence = syntax::sequence(input, &TokenStream::new(), &mut errors);
            let scheme = sequence.as_ref().and_then(|sequence| lower(sequence, &Known::bases(), &mut errors));
            Ok(scheme.unwrap_or_else(|| panic!("{text}: {:?}", errors.combined())))
        };
        parser.parse_str(text).expect("a sequence")
    }

    #[test]
    fn steps_of_second_order_and_compositions_of_symmetric_steps_keep_their_orders() {
        for (text, order, kept) in [
            ("T(1) V(1)", 1, true),
            ("T(1/2) V(1) T(1/2)", 2, true),
            // Σ bᵢ³ = 0, since the kicks are those of the steps that are composed.
            ("symmetric(1/(2 - cbrt(2)), _; Verlet)", 4, true),
            // Half kicks of two steps are one, whose error is not the sum of theirs.
            ("symmetric(1/(2 - cbrt(2)), _; VelocityVerlet)", 4, false),
        ] {
            let scheme = scheme(text);
            assert_eq!((scheme.order, are_kept(&scheme)), (order, kept), "{text}");
        }
    }

    #[test]
    fn errors_of_a_pair_are_letters_of_their_degree() {
        assert_eq!(words(3), [[3]]);
        assert_eq!(words(4), [[3, 0], [3, 1], [0, 3], [1, 3]]);
        assert_eq!(words(5).len(), 13, "one of a letter, twelve of a third degree and two letters");
    }

    #[test]
    fn coefficients_are_those_of_a_product_of_exponentials() {
        let element = |letter| Element { letter, coefficient: Coefficient::ONE, gradient: Coefficient::ZERO };
        let stages = [element(Letter::T), element(Letter::V), element(Letter::V)];
        let of = |word: &[u32]| coefficient(&factors(&stages, 4), word).value();
        // exp(A) exp(B + E) exp(B + E)
        assert_eq!([of(&[0, 3]), of(&[3, 0]), of(&[1, 3]), of(&[0, 0, 1])], [2.0, 0.0, 2.0, 1.0]);
    }
}
