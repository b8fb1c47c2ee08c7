//! The series of the modified Hamiltonian of a step, by its brackets.
//!
//! In: a table of stages. Out: the coefficients of nested Poisson brackets of `T` and `V`, up to the degree
//! [`HIGHEST`]. With the operator `D_A f = {f, A}`, which differentiates along the flow of `A`, the flow of `A` for a
//! time `a` is `exp(a D_A)`, and a step is the product of those of its stages in their order: a series over words in the
//! letters `T` and `V`. Its logarithm is `D_M` with the modified Hamiltonian `M`. Since `[D_A, D_B] = D_{D_A B}`, a sum of
//! words `c_w w` that is a Lie element is the function `Σ c_w/|w| · D_{w₁} … D_{w_{k−1}} w_k` (Dynkin, Specht and Wever).
//!
//! Always true: the table is the one that a run loops over, so that this is a second derivation beside the proof of
//! `composition!`; brackets that are equal for all `T` and `V` are one term.

use crate::composition::{Class, Lead, Rows, Scheme, Stage};
use std::fmt;

/// The highest degree of a bracket: that of `h⁴` in the modified Hamiltonian.
pub(crate) const HIGHEST: usize = 5;

/// The letters of a word after a leading one bit: `T` is a zero, `V` a one.
type Word = usize;

const WORDS: usize = 2 << HIGHEST;
const EMPTY: Word = 1;
const KINETIC: usize = 0;
const POTENTIAL: usize = 1;

fn degree(word: Word) -> usize {
    word.ilog2() as usize
}

/// A series over all words up to the highest degree.
type Coefficients = [f64; WORDS];

/// A bracket of the series with its coefficient: `D_{w₁} … D_{w_k} {V, T}`.
#[derive(Clone, Debug, PartialEq)]
pub struct Bracket {
    /// `w₁ … w_k`, as `false` for `T` and `true` for `V`; sorted but for the first, since the last two commute there.
    pub(crate) along: Vec<bool>,
    /// The factor in front of it.
    pub coefficient: f64,
}

impl Bracket {
    /// The power of the step in front of it.
    pub fn power(&self) -> i32 {
        self.along.len() as i32 + 1
    }
}

/// Displays nested Poisson brackets: `{{V, T}, V}`.
impl fmt::Display for Bracket {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let letter = |is_potential: &bool| if *is_potential { "V" } else { "T" };
        let bracket =
            self.along.iter().rev().fold("{V, T}".to_owned(), |inner, outer| format!("{{{inner}, {}}}", letter(outer)));
        f.write_str(&bracket)
    }
}

/// The modified Hamiltonian of a composition: `T + V` and brackets with powers of the step.
#[derive(Clone, Debug, PartialEq)]
pub struct BracketSeries {
    /// The name of the composition.
    pub composition: &'static str,
    /// The order that it claims.
    pub order: u32,
    /// Whether the composition claims to be symmetric, so that only even powers occur.
    pub symmetric: bool,
    /// All brackets up to the fourth power of the step whose factor is not zero, lower powers first.
    pub brackets: Vec<Bracket>,
}

/// Coefficients of an order that holds are zero but for the roundings of some dozens of products.
const ROUNDING: f64 = 1e-13;

impl BracketSeries {
    /// The series of a composition.
    pub fn of<X: Scheme>() -> Self {
        let mut step = [0.0; WORDS];
        step[EMPTY] = 1.0;
        append(&mut step, &X::PROCESSOR.before);
        let lead = X::STAGES.lead;
        for stage in [&X::STAGES.opening].into_iter().chain(&X::STAGES.cycle[1..]).chain([&X::STAGES.closing]) {
            append_stage(&mut step, lead, stage);
        }
        append(&mut step, &X::PROCESSOR.after);
        Self {
            composition: X::NAME,
            order: X::ORDER,
            symmetric: X::SYMMETRIC,
            brackets: brackets(&logarithm(&step), X::CLASS),
        }
    }

    /// The powers of the step that its modifications add, one after the other: from the order on, and even ones of a
    /// symmetric composition.
    pub fn powers(&self) -> Vec<i32> {
        let first = self.order.min(HIGHEST as u32) as i32;
        (first..HIGHEST as i32).filter(|power| !self.symmetric || power % 2 == 0).collect()
    }

    /// The power of the step by which energies are off that are modified with the first `count` of its
    /// [`powers`](Self::powers).
    pub fn off_by(&self, count: usize) -> i32 {
        match (count.checked_sub(1).and_then(|last| self.powers().get(last).copied()), self.symmetric) {
            (None, _) => self.order as i32,
            (Some(last), true) => last + 2,
            (Some(last), false) => last + 1,
        }
    }
}

/// The Hamiltonian as a sum, as in `T + V + h²·(1/12·{{V, T}, T})`.
impl fmt::Display for BracketSeries {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "T + V")?;
        for power in 1..HIGHEST as i32 {
            for bracket in self.brackets.iter().filter(|bracket| bracket.power() == power) {
                let sign = if bracket.coefficient < 0.0 { "−" } else { "+" };
                let step = ["", "h", "h²", "h³", "h⁴"][power as usize];
                write!(f, " {sign} {}·{step}·{bracket}", number(bracket.coefficient.abs()))?;
            }
        }
        let next = self.off_by(self.powers().len());
        write!(f, " + O(h^{next})")
    }
}

/// A fraction of small numbers, where the coefficient is one to its rounding; else its digits.
fn number(coefficient: f64) -> String {
    let fraction = (1..=6000_u32).find_map(|denominator| {
        let numerator = (coefficient * f64::from(denominator)).round();
        let is_close = (numerator / f64::from(denominator) - coefficient).abs() < ROUNDING;
        (numerator != 0.0 && is_close).then_some((numerator, denominator))
    });
    match fraction {
        Some((numerator, 1)) => format!("{numerator}"),
        Some((numerator, denominator)) => format!("{numerator}/{denominator}"),
        None if coefficient.abs() < 1e-3 => format!("{coefficient:.5e}"),
        None => format!("{coefficient:.6}"),
    }
}

fn append(series: &mut Coefficients, stages: &Rows) {
    for stage in stages.rows {
        append_stage(series, stages.lead, stage);
    }
}

fn append_stage(series: &mut Coefficients, lead: Lead, stage: &Stage) {
    if lead == Lead::Drift {
        append_flow(series, KINETIC, stage.drift);
    }
    append_flow(series, POTENTIAL, stage.kick);
    append_gradient(series, stage.gradient);
    if lead == Lead::Kick {
        append_flow(series, KINETIC, stage.drift);
    }
}

/// Multiplies by `exp(a X)` with a letter `X`. Longer words come first, so that those read are still the old ones.
fn append_flow(series: &mut Coefficients, letter: usize, a: f64) {
    for word in (2..WORDS).rev() {
        let (mut rest, mut factor, mut count) = (word, 1.0, 0.0);
        while rest > EMPTY && rest & 1 == letter {
            rest >>= 1;
            count += 1.0;
            factor *= a / count;
            series[word] += factor * series[rest];
        }
    }
}

/// Multiplies by `exp(c |∇V|²)`, which is `c [V, [V, T]] = c (VVT − 2 VTV + TVV)`. Its square has six letters, and it
/// commutes with `V` where `T` is quadratic, as it is wherever there are such kicks.
fn append_gradient(series: &mut Coefficients, c: f64) {
    for word in (8..WORDS).rev() {
        let weight = match word & 0b111 {
            0b110 | 0b011 => 1.0,
            0b101 => -2.0,
            _ => continue,
        };
        series[word] += c * weight * series[word >> 3];
    }
}

/// `log(1 + x) = x − x²/2 + x³/3 − …` of a series that begins with 1.
fn logarithm(series: &Coefficients) -> Coefficients {
    let mut x = *series;
    x[EMPTY] = 0.0;
    let (mut power, mut sum) = (x, x);
    for exponent in 2..=HIGHEST {
        power = product(&power, &x);
        let factor = if exponent % 2 == 0 { -1.0 } else { 1.0 } / exponent as f64;
        sum.iter_mut().zip(&power).for_each(|(sum, power)| *sum += factor * power);
    }
    sum
}

fn product(one: &Coefficients, other: &Coefficients) -> Coefficients {
    let mut product = [0.0; WORDS];
    for (word, coefficient) in product.iter_mut().enumerate().skip(EMPTY) {
        let splits = (0..=degree(word)).map(|rest| (word >> rest, 1 << rest | word & ((1 << rest) - 1)));
        *coefficient = splits.map(|(first, second)| one[first] * other[second]).sum();
    }
    product
}

/// The function that belongs to a Lie element, by its different brackets of two letters and more that need not vanish.
fn brackets(element: &Coefficients, class: Class) -> Vec<Bracket> {
    let mut brackets: Vec<Bracket> = Vec::new();
    for (word, coefficient) in element.iter().enumerate().skip(4) {
        // The innermost bracket is D_T V = {V, T} or D_V T = −{V, T}.
        let sign = match word & 0b11 {
            0b01 => 1.0,
            0b10 => -1.0,
            _ => continue,
        };
        let mut along: Vec<bool> = (2..degree(word)).rev().map(|letter| word >> letter & 1 == POTENTIAL).collect();
        // D_T D_V f and D_V D_T f differ by {f, {V, T}}, which is nothing for f = {V, T}.
        let pair = along.len().saturating_sub(2);
        along[pair..].sort_unstable();
        let coefficient = sign * coefficient / degree(word) as f64;
        match brackets.iter_mut().find(|bracket| bracket.along == along) {
            Some(bracket) => bracket.coefficient += coefficient,
            None => brackets.push(Bracket { along, coefficient }),
        }
    }
    // {V, T} is linear in p where T is quadratic, and V depends on q alone.
    let vanishes = |along: &[bool]| class == Class::QuadraticKinetic && along.ends_with(&[true, true]);
    brackets.retain(|bracket| bracket.coefficient.abs() > ROUNDING && !vanishes(&bracket.along));
    brackets
}

#[cfg(test)]
mod tests {
    use super::BracketSeries;
    use crate::{Chin4A, Euler, KahanLi8, VelocityVerlet, Verlet, Yoshida4};

    #[test]
    fn series_are_those_of_books() {
        // For T = p²/2, the brackets of fourth order are V⁗p⁴, −2(V″p)² − 2V‴V′p², 0, −3V‴V′p², 2V″V′² and 0: their sum has
        // the factors 7/5760, −1/80, −1/240 and 1/60 that are found by hand.
        let table = [
            (
                BracketSeries::of::<Verlet>(),
                "T + V − 1/24·h²·{{V, T}, T} − 1/12·h²·{{V, T}, V} + 7/5760·h⁴·{{{{V, T}, T}, T}, T} \
                 + 1/480·h⁴·{{{{V, T}, V}, T}, T} − 1/360·h⁴·{{{{V, T}, V}, V}, T} + 1/360·h⁴·{{{{V, T}, T}, T}, V} \
                 + 1/120·h⁴·{{{{V, T}, V}, T}, V} + 1/720·h⁴·{{{{V, T}, V}, V}, V} + O(h^6)",
            ),
            (BracketSeries::of::<KahanLi8>(), "T + V + O(h^8)"),
        ];
        for (series, text) in table {
            assert_eq!(series.to_string(), text);
        }
    }

    #[test]
    fn brackets_below_the_order_vanish() {
        for (series, first) in [
            (BracketSeries::of::<Euler>(), 1),
            (BracketSeries::of::<Verlet>(), 2),
            (BracketSeries::of::<VelocityVerlet>(), 2),
            (BracketSeries::of::<Yoshida4>(), 4),
            (BracketSeries::of::<Chin4A>(), 4),
        ] {
            let least = series.brackets.iter().map(super::Bracket::power).min();
            assert_eq!(least, Some(first), "{series}");
            assert!(!series.symmetric || series.brackets.iter().all(|bracket| bracket.power() % 2 == 0), "{series}");
        }
    }
}
