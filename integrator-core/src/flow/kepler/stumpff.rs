//! The functions of universal variables, `Gₙ(s) = sⁿ cₙ(β s²)` with Stumpff's `cₙ`.
//!
//! `G₀' = -β G₁`, and the others are integrals of the one before. For `β > 0` they are made of sines and cosines, for
//! `β < 0` of hyperbolic ones, and for `β = 0` of powers; none of that is seen here.

use crate::scalar::real::{Mask, Real};

/// The largest `|β s²|` for which the series are summed: the first term left out is below 2⁻⁵⁴ of the sum.
const NEAR: f64 = 0.5;

/// The largest number of times that an argument is halved. Hyperbolic functions have overflowed before.
const HALVINGS: usize = 12;

/// `1/(2n+2)!` and `1/(2n+3)!`, with the signs of the series.
const SECOND: [f64; 8] = series(2);
const THIRD: [f64; 8] = series(3);

/// The rounding errors of the first two coefficients of each series. Without them every arc has the same error, and the
/// energy of an eccentric orbit drifts.
const SECOND_REST: [f64; 2] = [0.0, -2.312_964_634_635_742_7e-18];
const THIRD_REST: [f64; 2] = [9.251_858_538_542_97e-18, -1.156_482_317_317_871_4e-19];

const fn series(first: u64) -> [f64; 8] {
    let mut terms = [0.0; 8];
    let (mut n, mut factorial, mut sign) = (0, if first == 2 { 2_u64 } else { 6 }, 1.0);
    while n < 8 {
        // Factorials up to 17! are not beyond 2⁵³ by more than their powers of two.
        terms[n] = sign / factorial as f64;
        let next = 2 * n as u64 + first;
        factorial *= (next + 1) * (next + 2);
        sign = -sign;
        n += 1;
    }
    terms
}

/// `G₀` to `G₃` at `s`.
#[inline(always)]
pub(super) fn functions<R: Real>(beta: R, s: R) -> [R; 4] {
    let (mut s, mut x) = (s, beta * s * s);
    let far = R::of(NEAR).less(x.abs());
    let mut halvings = R::of(0.0);
    let mut deepest = 0;
    if far.any() {
        (s, x, halvings, deepest) = halved(s, x);
    }
    let square = s * s;
    let mut second = square * sum(x, SECOND, SECOND_REST);
    let mut third = square * s * sum(x, THIRD, THIRD_REST);
    let mut first = (-beta).fma(third, s);
    let mut zeroth = (-beta).fma(second, R::of(1.0));
    while deepest > 0 {
        deepest -= 1;
        let doubled = R::of(deepest as f64).less(halvings);
        let twice = R::of(2.0);
        third = R::select(doubled, twice * zeroth.fma(third, s * second), third);
        second = R::select(doubled, twice * first * first, second);
        first = R::select(doubled, twice * zeroth * first, first);
        s = R::select(doubled, twice * s, s);
        zeroth = (-beta).fma(second, R::of(1.0));
    }
    [zeroth, first, second, third]
}

/// The argument halved so often that the series are short, in each lane as often as that takes, and the largest number
/// of times.
#[inline(always)]
fn halved<R: Real>(mut s: R, mut x: R) -> (R, R, R, usize) {
    let (mut halvings, mut deepest) = (R::of(0.0), 0);
    while deepest < HALVINGS {
        let far = R::of(NEAR).less(x.abs());
        if !far.any() {
            break;
        }
        s = R::select(far, s * R::of(0.5), s);
        x = R::select(far, x * R::of(0.25), x);
        halvings = R::select(far, halvings + R::of(1.0), halvings);
        deepest += 1;
    }
    (s, x, halvings, deepest)
}

/// A series of eight terms, summed in pairs, and the rest of the first two.
#[inline(always)]
fn sum<R: Real>(x: R, terms: [f64; 8], rest: [f64; 2]) -> R {
    let [a, b, c, d, e, f, g, h] = terms;
    let square = x * x;
    let low = pair(x, a, b) + square.fma(pair(x, c, d), pair(x, rest[0], rest[1]));
    let high = square.fma(pair(x, g, h), pair(x, e, f));
    (square * square).fma(high, low)
}

#[inline(always)]
fn pair<R: Real>(x: R, a: f64, b: f64) -> R {
    x.fma(R::of(b), R::of(a))
}

/// `G₁`, `G₂` and `G₃` at a point `s + d` near one where they are known.
#[inline(always)]
pub(super) fn shifted<R: Real>([zeroth, first, second, third]: [R; 4], beta: R, d: R) -> [R; 3] {
    let [by_second, by_third] = near_zero(beta, d);
    [
        first + small(beta, d, [zeroth, -(beta * first)]),
        second + small(beta, d, [first, zeroth]),
        third + second.fma(d, first.fma(by_second, zeroth * by_third)),
    ]
}

/// `a G₁ + b G₂` at a point next to zero, `|β d²| < 2⁻²⁴`: the first terms left out are below 2⁻⁸⁴ of the first two, which
/// conserve the energy. What is left out is no rounding, and has the same sign in each stage.
#[inline(always)]
pub(super) fn small<R: Real>(beta: R, d: R, [a, b]: [R; 2]) -> R {
    let (square, x) = (d * d, (beta * d) * d);
    let linear = |a: f64, b: f64| x.fma(R::of(b), R::of(a));
    let (a, b) = (a * d, b * square);
    let tail = a.fma(linear(-1.0 / 6.0, 1.0 / 120.0), b * linear(-1.0 / 24.0, 1.0 / 720.0));
    x.fma(tail, R::of(0.5).fma(b, a))
}

/// `G₂` and `G₃` there.
#[inline(always)]
fn near_zero<R: Real>(beta: R, d: R) -> [R; 2] {
    let (square, x) = (d * d, beta * d * d);
    let linear = |a: f64, b: f64| x.fma(R::of(b), R::of(a));
    [square * x.fma(linear(-1.0 / 24.0, 1.0 / 720.0), R::of(0.5)), square * d * linear(1.0 / 6.0, -1.0 / 120.0)]
}
