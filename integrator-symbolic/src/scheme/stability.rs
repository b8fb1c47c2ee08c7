//! The stability limit of a step for the harmonic oscillator. In: stages. Out: the first unstable `x = h omega`.
//!
//! One step is a matrix of determinant 1, so its powers are bounded exactly while half its trace `t` is in `[-1, 1]`.
//! With momenta in units of `x`, a drift is `q += a p` and a kick `p -= (b y + 2 c y^2) q`, where `y = x^2`; hence `t`
//! is a polynomial in `y`. An accurate step has `t` close to `cos x`, which touches -1 at `x = pi`. Whether `t` exceeds
//! -1 there depends on its last digits, so extrema are computed in double-double arithmetic.

use super::{
    double::Double,
    stages::{Letter, Stages},
};

/// The scan goes in steps of this; many of them lie between neighbouring extrema of `cos x`.
const STRIDE: f64 = 1.0 / 32.0;

/// Half a trace beyond 1 by less than this is rounding.
const SLACK: f64 = 1e-25;

/// An extremum on the grid may be off the true one by less than this.
const COARSE: f64 = 0.01;

/// The smallest `h omega > 0` beyond which a step is unstable, to ten digits.
///
/// A polynomial that starts as `1 - y/2` leaves `[-1, 1]` before `y = 4 n^2`, where `n` is its degree, so the scan
/// ends.
pub(super) fn limit(stages: &Stages) -> f64 {
    let trace = HalfTrace::of(stages);
    let end = 2.0 * trace.coefficients.len() as f64;
    let mut window = [0.0, STRIDE, 2.0 * STRIDE];
    while window[1] < end {
        let [left, middle, right] = window.map(|x| trace.rough(x));
        let iterations = (middle - left) * (right - middle) <= 0.0 && middle.abs() > 1.0 - COARSE;
        if iterations && trace.is_beyond(trace.extremum(window[0], window[2])) {
            return trace.crossing(window[0], trace.extremum(window[0], window[2]));
        }
        if trace.is_beyond(window[2]) {
            return trace.crossing(window[0], window[2]);
        }
        window = window.map(|x| x + STRIDE);
    }
    end
}

/// Half the trace of a step, a polynomial in `y = x^2`, constant term first.
struct HalfTrace {
    coefficients: Vec<Double>,
}

impl HalfTrace {
    fn of(stages: &Stages) -> Self {
        // The two rows of the matrix: what becomes of q and of p, each by the initial q and p.
        let (mut q, mut p) = ([vec![Double::ONE], Vec::new()], [Vec::new(), vec![Double::ONE]]);
        for element in stages.elements() {
            let duration = element.coefficient.value;
            match element.letter {
                Letter::T => add(&mut q, &p, duration, 0),
                Letter::V => {
                    add(&mut p, &q, -duration, 1);
                    if !element.gradient.vanishes() {
                        add(&mut p, &q, Double::from(-2.0) * element.gradient.value, 2);
                    }
                }
                Letter::O => {}
            }
        }
        let ([mut trace, _], [_, other]) = (q, p);
        add_one(&mut trace, &other, Double::ONE, 0);
        let half = Double::from(0.5);
        Self { coefficients: trace.into_iter().map(|coefficient| half * coefficient).collect() }
    }

    /// In `f64`, for the scan.
    fn rough(&self, x: f64) -> f64 {
        self.coefficients.iter().rev().fold(0.0, |sum, coefficient| sum * (x * x) + coefficient.value())
    }

    /// By how much half the trace is beyond `[-1, 1]`.
    fn excess(&self, x: f64) -> f64 {
        let y = Double::from(x) * Double::from(x);
        let value = self.coefficients.iter().rev().fold(Double::ZERO, |sum, coefficient| sum * y + *coefficient);
        (value.abs() - Double::ONE).value()
    }

    fn is_beyond(&self, x: f64) -> bool {
        // Far out the sum may overflow to infinity minus infinity, a NaN.
        let excess = self.excess(x);
        excess > SLACK || excess.is_nan()
    }

    /// Where half the trace is largest in size between two places around an extremum, by golden section.
    fn extremum(&self, mut left: f64, mut right: f64) -> f64 {
        let golden = (5.0_f64.sqrt() - 1.0) / 2.0;
        // The window shrinks by half every 1.44 sections, so these leave nothing of it in `f64`.
        for _ in 0..72 {
            let (one, other) = (right - golden * (right - left), left + golden * (right - left));
            if self.excess(one) < self.excess(other) {
                left = one;
            } else {
                right = other;
            }
        }
        left
    }

    /// Where half the trace goes beyond, between a place where it is not and one where it is.
    fn crossing(&self, mut inside: f64, mut beyond: f64) -> f64 {
        for _ in 0..48 {
            let middle = inside + (beyond - inside) / 2.0;
            if self.is_beyond(middle) {
                beyond = middle;
            } else {
                inside = middle;
            }
        }
        (inside * 1e10).round() / 1e10
    }
}

/// Adds a multiple of one row, times `y` to a power, to another.
fn add(to: &mut [Vec<Double>; 2], row: &[Vec<Double>; 2], factor: Double, power: usize) {
    for (to, entry) in to.iter_mut().zip(row) {
        add_one(to, entry, factor, power);
    }
}

fn add_one(to: &mut Vec<Double>, entry: &[Double], factor: Double, power: usize) {
    if !entry.is_empty() {
        to.resize(to.len().max(entry.len() + power), Double::ZERO);
    }
    for (to, coefficient) in to[..].iter_mut().skip(power).zip(entry) {
        *to = *to + factor * *coefficient;
    }
}

#[cfg(test)]
mod tests {
    use super::limit;
    use crate::scheme::tests::scheme;

    /// Values found with 60 digits by a program of its own.
    #[test]
    fn known_limits() {
        for (sequence, expected) in [
            ("Euler", 2.0),
            ("Verlet", 2.0),
            ("triple_jump(Verlet)", 1.573_401_947_4),
            ("suzuki(VelocityVerlet)", 2.720_974_538_6),
            // A gradient in the kick.
            ("T(1/2) V(1, -1/24) T(1/2)", 3.464_101_615_1),
            ("symmetric(V(1/6) T(1/2) V(2/3, -1/72))", 3.464_101_621_5),
            // An accurate step: half its trace is beyond -1 by 2e-7 close to pi, and not before.
            (
                "symmetric(V(0.0839831526287669393052899860437070735202) T(0.253978510841059475836036519322644915223)
              V(0.682236533571909094997844150584287243559) T(-0.0323028676526996731898102783632055739961)
              V(_) T(_))",
                3.142_120_720_5,
            ),
        ] {
            let found = limit(&scheme(sequence).stages);
            assert!((found - expected).abs() < 1e-9, "{sequence}: {found}");
        }
    }

    #[test]
    fn half_the_step_is_stable_twice_as_long() {
        let found = limit(&scheme("compose(Verlet, Verlet)").stages);
        assert!((found - 4.0).abs() < 1e-5, "beyond -1 nowhere before 4, where it touches: {found}");
    }

    #[test]
    fn a_step_of_absurd_length_has_a_limit() {
        assert!(limit(&scheme("V(1e100) T(1/2) V(-1e100) T(1/2) V(1)").stages).is_finite());
    }
}
