//! The orders of a step whose second part is itself integrated by a symmetric inner composition.
//!
//! If `B` has no exact flow, a number of inner steps of even order `r` replaces it: `exp(b B + bʳ⁺¹ E + bʳ⁺³ E′ + ...)`.
//! Such a product is symmetric, so its errors are of odd degrees. They are additional letters of the degrees `r + 1`,
//! `r + 3` and so on. A step keeps an order if the words with one of them vanish up to that degree; the first condition
//! is `Σ bᵢʳ⁺¹ = 0`. A number of steps that is the same for all `b` only scales the letters.
//!
//! A pair of parts is the case of one step of order 2: `J/2 I J/2` for `B = J + I`. For generalised orders, a word counts
//! all its letters `B`, and an error of degree `n` consists of `n` of them (Blanes, Casas, Farres, Laskar, Makazaga and
//! Murua 2013, Applied Numerical Mathematics 68, 58).

use super::{
    conditions::factorial_inverse,
    double::Double,
    prove::{Class, Scheme, tolerance, whole},
    stages::{Element, Letter, Stages},
};
use std::iter;

/// A letter of a word: `A` for 0, else `B` or an error of it, by its degree.
type Weight = u32;

const A: Weight = 0;

/// The orders of inner compositions that are examined.
pub(super) const INNER_ORDERS: [u32; 4] = [2, 4, 6, 8];

/// The orders of a step over a second part without an exact flow.
pub(super) struct OverInner {
    /// The orders over inner compositions of [`INNER_ORDERS`].
    pub(super) orders: [u32; 4],
    /// Whether all its orders, the generalised ones as well, hold if the second part is a symmetric pair.
    pub(super) keeps_pairs: bool,
}

impl OverInner {
    pub(super) fn of(scheme: &Scheme) -> Self {
        if scheme.class != Class::General {
            return Self { orders: lower_bounds(scheme.order), keeps_pairs: false };
        }
        let stages = whole(&scheme.stages, &scheme.processor);
        let mut proved = 0;
        let orders = INNER_ORDERS.map(|inner| {
            // The errors of a higher inner order are among those of a lower one, so its words vanish as far at least.
            let violated =
                (proved.max(inner) + 1..=scheme.order).find(|degree| !vanish(scheme, &stages, inner, *degree));
            proved = violated.map_or(scheme.order, |degree| degree - 1);
            proved
        });
        let mut beyond = scheme.order + 1..=order(scheme, 3);
        let keeps_pairs = orders[0] == scheme.order && beyond.all(|degree| vanish(scheme, &stages, 2, degree));
        Self { orders, keeps_pairs }
    }
}

/// The orders that hold for every step of an order, because each inner step has the inner order itself.
pub(super) fn lower_bounds(order: u32) -> [u32; 4] {
    INNER_ORDERS.map(|inner| inner.min(order))
}

/// The order of words with this number of letters `B`.
fn order(scheme: &Scheme, letters: u32) -> u32 {
    let generalised = scheme.generalised.get(letters as usize - 1).copied();
    generalised.map_or(scheme.order, |order| order.max(scheme.order))
}

/// Whether the words of a degree with errors of an inner composition vanish, where an order requests it.
fn vanish(scheme: &Scheme, stages: &Stages, inner: u32, degree: u32) -> bool {
    // The logarithm of a symmetric step has no terms of even degree.
    if scheme.proof.symmetric && degree.is_multiple_of(2) {
        return true;
    }
    let tolerance = tolerance(stages, degree as usize);
    let requested = words(inner, degree).into_iter().filter(|word| order(scheme, word.iter().sum()) >= degree);
    let factors = factors(stages.elements(), degree);
    requested.map(|word| coefficient(&factors, &word)).all(|coefficient| coefficient.abs().value() <= tolerance)
}

/// The Lyndon words of a degree with at least one error of an inner composition, the shortest first.
///
/// All other words are polynomials in Lyndon words of no higher degree and no more letters `B`.
fn words(inner: u32, degree: u32) -> Vec<Vec<Weight>> {
    let mut words = of_degree(inner, degree);
    words.retain(|word| word.iter().any(|weight| *weight > 1) && is_lyndon(word));
    words.sort_by_key(Vec::len);
    words
}

/// Whether a word comes before all its endings.
fn is_lyndon(word: &[Weight]) -> bool {
    (1..word.len()).all(|begin| *word < word[begin..])
}

/// All words of a degree.
fn of_degree(inner: u32, degree: u32) -> Vec<Vec<Weight>> {
    if degree == 0 {
        return vec![Vec::new()];
    }
    let last = [A, 1].into_iter().chain((inner + 1..=degree).step_by(2));
    let longer = last.flat_map(|last| {
        let shorter = of_degree(inner, degree - last.max(1));
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
    use std::collections::BTreeMap;

    use super::{INNER_ORDERS, OverInner, Weight, coefficient, factors, words};
    use crate::scheme::{
        coefficient::Coefficient,
        prove::Scheme,
        stages::{Element, Letter},
        tests::scheme,
    };

    const YOSHIDA_4: &str = "symmetric(1/(2 - cbrt(2)), _; Verlet)";

    const PEFRL: &str = "symmetric(
        T(0.178617895844809068060904246197590706) V(0.712341831062605425480342912785941851)
        T(-0.0662645826698184883166709400757029859) V(_) T(_)
    )";

    const BLANES_MOAN_4: &str = "symmetric(
        V(0.0792036964311956741976496237630977485) T(0.209515106613362052972449986093565479)
        V(0.353172906049774036818665557303204203) T(-0.143851773179818037964096299232667872)
        V(-0.0420650803577195292151715808766370620) T(_) V(_)
    )";

    /// `BlanesMoan6` with the letters exchanged, so that it begins with a drift.
    const BLANES_MOAN_6: &str = "symmetric(
        T(0.0502627644003927227646350170890431145) V(0.148816447901043280457338250393514676)
        T(0.413514300428343477454136714832912846) V(-0.132385865767783756149346965946034103)
        T(0.0450798897943981114898610845310218159) V(0.0673076046921843992407714858521469515)
        T(-0.188054853819568618490425283066760972) V(0.432666402578173711633583314086173416)
        T(0.541960678450780012366892191783226417) V(_) T(_)
    )";

    const KAHAN_LI_6: &str = "symmetric(
        0.392161444007314139279250557422671404, 0.332599136789359438599748637500049647,
        -0.706246172557639359809964819549256459, 0.0822135962935508002314904481020563311, _; Verlet
    )";

    /// Sequences with their orders over inner orders 2, 4, 6 and 8.
    fn rows() -> Vec<(String, [u32; 4])> {
        let rows = [
            ("T(1) V(1)", [1; 4]),
            ("Verlet", [2; 4]),
            ("T(7/24) V(2/3) T(3/4) V(-2/3) T(-1/24) V(1)", [2, 3, 3, 3]),
            // The kicks are those of the steps that are composed, so Σ bᵢ³ = 0.
            (YOSHIDA_4, [4; 4]),
            // Half kicks of two steps are one, whose error is not the sum of theirs.
            ("symmetric(1/(2 - cbrt(2)), _; VelocityVerlet)", [2, 4, 4, 4]),
            (BLANES_MOAN_4, [2, 4, 4, 4]),
            (KAHAN_LI_6, [6; 4]),
        ];
        let mut rows = rows.map(|(text, orders)| (text.to_owned(), orders)).to_vec();
        // Three steps of a method of order 4 have order 6. Over an inner order of 2 that method has order 2 alone, and the
        // coefficients of the three do not cancel its errors of third order.
        rows.push((format!("triple_jump({PEFRL})"), [2, 6, 6, 6]));
        // Three steps with γ₁³ + γ₂³ + γ₃³ = 0 raise the order 2 to 4, and no higher order.
        rows.push((format!("symmetric(1/(2 - cbrt(2)), _; {BLANES_MOAN_6})"), [4, 4, 6, 6]));
        rows
    }

    #[test]
    fn orders_over_inner_compositions() {
        for (text, orders) in rows() {
            let scheme = scheme(&text);
            let found = OverInner::of(&scheme);
            assert_eq!(found.orders, orders, "{text}");
            assert_eq!(found.keeps_pairs, orders[0] == scheme.order, "{text}");
        }
    }

    #[test]
    fn quadratic_kinetic_energy_has_lower_bounds() {
        let found = OverInner::of(&scheme("symmetric(V(1/6) T(1/2) V(2/3, -1/72))"));
        assert_eq!((found.orders, found.keeps_pairs), ([2, 4, 4, 4], false));
    }

    /// A polynomial in letters that do not commute, up to a degree.
    type Polynomial = BTreeMap<Vec<Weight>, f64>;

    fn degree_of(word: &[Weight]) -> u32 {
        word.iter().map(|weight| (*weight).max(1)).sum()
    }

    fn product(left: &Polynomial, right: &Polynomial, degree: u32) -> Polynomial {
        let mut product = Polynomial::new();
        for (begin, one) in left {
            let rest = degree - degree_of(begin);
            for (end, other) in right.iter().filter(|(end, _)| degree_of(end) <= rest) {
                *product.entry([begin.as_slice(), end].concat()).or_default() += one * other;
            }
        }
        product
    }

    /// `exp(a A)`, or `exp(b B + bʳ⁺¹ E + ...)` for an inner order `r`.
    fn exponential(stage: &Element, inner: u32, degree: u32) -> Polynomial {
        let duration = stage.coefficient.value.value();
        let logarithm = match stage.letter {
            Letter::T | Letter::O => Polynomial::from([(vec![0], duration)]),
            Letter::V => {
                let errors = (inner + 1..=degree).step_by(2);
                [1].into_iter().chain(errors).map(|weight| (vec![weight], duration.powi(weight as i32))).collect()
            }
        };
        let mut power = Polynomial::from([(Vec::new(), 1.0)]);
        let mut sum = power.clone();
        for k in 1..=degree {
            power = product(&power, &logarithm, degree);
            power.values_mut().for_each(|coefficient| *coefficient /= f64::from(k));
            for (word, coefficient) in &power {
                *sum.entry(word.clone()).or_default() += coefficient;
            }
        }
        sum
    }

    /// The order by all words of the product of exponentials, compared with those of `exp(A + B)`.
    fn order_by_multiplication(scheme: &Scheme, inner: u32) -> u32 {
        let identity = Polynomial::from([(Vec::new(), 1.0)]);
        let stages = scheme.stages.elements().iter();
        let step =
            stages.fold(identity, |step, stage| product(&step, &exponential(stage, inner, scheme.order), scheme.order));
        let wrong = step.iter().filter(|(word, coefficient)| {
            let exact = match word.iter().all(|weight| *weight < 2) {
                true => (1..=word.len()).fold(1.0, |inverse, k| inverse / k as f64),
                false => 0.0,
            };
            // A few hundred products of numbers below ten, and the violations of these sequences are above 1e-5.
            (*coefficient - exact).abs() > 1e-9
        });
        wrong.map(|(word, _)| degree_of(word) - 1).min().unwrap_or(scheme.order)
    }

    #[test]
    fn the_product_of_exponentials_has_the_same_orders() {
        for (text, orders) in rows() {
            let scheme = scheme(&text);
            for (inner, order) in INNER_ORDERS.into_iter().zip(orders) {
                assert_eq!(order_by_multiplication(&scheme, inner), order, "{text} over {inner}");
            }
        }
    }

    #[test]
    fn words_are_those_that_generate_all_others() {
        assert_eq!(words(2, 3), [[3]]);
        assert_eq!(words(2, 4), [[0, 3], [1, 3]]);
        assert_eq!(words(2, 5), [vec![5], vec![0, 3, 1], vec![0, 0, 3], vec![0, 1, 3], vec![1, 1, 3]]);
        assert_eq!(words(4, 7).len(), 5, "one of a letter, four of a fifth degree and two letters");
        assert!(words(4, 4).is_empty() && words(8, 8).is_empty());
    }

    #[test]
    fn coefficients_are_those_of_a_product_of_exponentials() {
        let element = |letter| Element { letter, coefficient: Coefficient::ONE, gradient: Coefficient::ZERO };
        let stages = [element(Letter::T), element(Letter::V), element(Letter::V)];
        let of = |word: &[u32]| coefficient(&factors(&stages, 4), word).value();
        // exp(A) exp(B + E) exp(B + E)
        assert_eq!([of(&[0, 3]), of(&[3, 0]), of(&[1, 3]), of(&[0, 0, 1])], [2.0, 0.0, 2.0, 1.0]);
    }

    #[test]
    fn words_that_end_in_an_error_are_moments() {
        let scheme = scheme(BLANES_MOAN_4);
        let stages = scheme.stages.elements();
        for (error, drifts) in [(3, 0), (3, 2), (5, 1), (7, 2)] {
            // The kick b after drifts of the sum c adds bʳ⁺¹ cᵏ/k! to the word of k letters A and an error.
            let (mut time, mut moment) = (0.0_f64, 0.0);
            for stage in stages {
                let duration = stage.coefficient.value.value();
                match stage.letter {
                    Letter::T | Letter::O => time += duration,
                    Letter::V => moment += duration.powi(error as i32) * time.powi(drifts) / f64::from(drifts.max(1)),
                }
            }
            let mut word = vec![0; drifts as usize];
            word.push(error);
            let found = coefficient(&factors(stages, error + drifts as u32), &word).value();
            // A dozen terms below one, each with a few roundings.
            assert!((found - moment).abs() < 100.0 * f64::EPSILON, "{word:?}: {found} for {moment}");
        }
    }
}
