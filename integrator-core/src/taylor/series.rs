//! Coefficients of order `k` from those of lower orders: what the recurrences of generated code are made of.
//!
//! With normalised coefficients `x(t) = Σ xₖ tᵏ`. Sums begin in the middle, at coefficients that have been known for
//! long, and end with the newest, so that they can begin before these are there; two of them run side by side. Their
//! order is that of the text, whatever the machine.

use crate::real::Real;
use alloc::vec::Vec;

/// How many coefficients a series has at most, that of order 0 included.
pub const COEFFICIENTS: usize = 29;

/// The coefficients of a series by order.
pub type Series<R> = [R; COEFFICIENTS];

/// `Σ aⱼ bₖ₋ⱼ`, the coefficient of `a b`.
#[inline(always)]
pub fn product<R: Real>(a: &Series<R>, b: &Series<R>, k: usize) -> R {
    let pairs = k.div_ceil(2);
    let mut first = if k.is_multiple_of(2) { a[k / 2] * b[k / 2] } else { R::of(0.0) };
    let mut second = R::of(0.0);
    for j in (0..pairs).rev() {
        first = a[j].fma(b[k - j], first);
        second = a[k - j].fma(b[j], second);
    }
    first + second
}

/// The coefficient of `a²`.
#[inline(always)]
pub fn square<R: Real>(a: &Series<R>, k: usize) -> R {
    let mut half = R::of(0.0);
    for j in (0..k.div_ceil(2)).rev() {
        half = a[j].fma(a[k - j], half);
    }
    let middle = if k.is_multiple_of(2) { a[k / 2] * a[k / 2] } else { R::of(0.0) };
    half + half + middle
}

/// The coefficient of `y = a / b` from that of `a`: `b₀ yₖ = aₖ - Σ bⱼ yₖ₋ⱼ`.
#[inline(always)]
pub fn quotient<R: Real>(a: R, y: &Series<R>, b: &Series<R>, k: usize) -> R {
    let mut rest = a;
    for j in (1..k + 1).rev() {
        rest = (-b[j]).fma(y[k - j], rest);
    }
    rest / b[0]
}

/// The coefficient of `y = aᵉ` for `k > 0`, with so many halves as exponent: `k a₀ yₖ = Σ (e j - (k - j)) aⱼ yₖ₋ⱼ`.
#[inline(always)]
pub fn power<R: Real>(y: &Series<R>, a: &Series<R>, halves: i32, k: usize) -> R {
    let weight = |j: usize| R::of(f64::from(halves) / 2.0 * j as f64 - (k - j) as f64);
    let (first, second) = from_the_middle(k, |j| (weight(j) * a[j], y[k - j]));
    (first + second) / (R::of(k as f64) * a[0])
}

/// The same with an exponent that is a parameter.
#[inline(always)]
pub fn real_power<R: Real>(y: &Series<R>, a: &Series<R>, exponent: R, k: usize) -> R {
    let weight = |j: usize| exponent * R::of(j as f64) - R::of((k - j) as f64);
    let (first, second) = from_the_middle(k, |j| (weight(j) * a[j], y[k - j]));
    (first + second) / (R::of(k as f64) * a[0])
}

/// The coefficient of `y` with `y' = g x'`, for `k > 0`: `k yₖ = Σ j xⱼ gₖ₋ⱼ`.
#[inline(always)]
pub fn chain<R: Real>(x: &Series<R>, slope: &Series<R>, k: usize) -> R {
    let (first, second) = from_the_middle(k, |j| (R::of(j as f64) * x[j], slope[k - j]));
    (first + second) / R::of(k as f64)
}

/// The sums of products with the numbers from 1 to `k`, from the middle outwards, of the lower and of the upper half.
#[inline(always)]
fn from_the_middle<R: Real>(k: usize, factors: impl Fn(usize) -> (R, R)) -> (R, R) {
    let (mut lower, mut upper) = (R::of(0.0), R::of(0.0));
    if !k.is_multiple_of(2) {
        let (a, b) = factors(k.div_ceil(2));
        lower = a * b;
    }
    for j in (1..k / 2 + 1).rev() {
        let (a, b) = factors(j);
        lower = a.fma(b, lower);
        let (a, b) = factors(k + 1 - j);
        upper = a.fma(b, upper);
    }
    (lower, upper)
}

/// `x` to the power of so many halves.
#[inline(always)]
pub fn half_power<R: Real>(x: R, halves: i32) -> R {
    let mut power = if halves % 2 == 0 { R::of(1.0) } else { x.sqrt() };
    for _ in 0..halves.unsigned_abs() / 2 {
        power = power * x;
    }
    if halves < 0 { R::of(1.0) / power } else { power }
}

/// The coefficients of one and of the time at an expansion.
#[inline(always)]
pub fn order_of_time<R: Real>(k: usize, time: f64) -> (R, R) {
    match k {
        0 => (R::of(1.0), R::of(time)),
        1 => (R::of(0.0), R::of(1.0)),
        _ => (R::of(0.0), R::of(0.0)),
    }
}

/// What the next turn of a loop keeps.
#[inline(always)]
pub fn turn<'t, T: Default>(turns: &'t mut Vec<T>, next: &mut usize) -> &'t mut T {
    let place = *next;
    *next += 1;
    if place == turns.len() {
        turns.push(T::default());
    }
    &mut turns[place]
}
