//! The operations of generated recurrences, beside sums of products.

use crate::scalar::{
    real::{Mask, Real},
    simd::pair::Pair,
};
use alloc::vec::Vec;

/// The highest order of a polynomial.
pub const HIGHEST: usize = 28;

/// The number of stored coefficients: from order 0 to one above the highest order, which positions have before momenta
/// do.
pub const COEFFICIENTS: usize = HIGHEST + 2;

/// The orders as numbers, which are read sooner than they are converted.
const NUMBERS: [f64; COEFFICIENTS] = {
    let mut numbers = [0.0; COEFFICIENTS];
    let mut k = 0;
    while k < COEFFICIENTS {
        numbers[k] = k as f64;
        k += 1;
    }
    numbers
};

/// The weight of `aⱼ yₖ₋ⱼ` in the recurrence of `y = aᵉ`, `k a₀ yₖ = Σ (e j - (k - j)) aⱼ yₖ₋ⱼ`.
#[inline(always)]
pub fn power_weight<R: Real>(exponent: f64, j: usize, k: usize) -> R {
    R::of((exponent + 1.0) * NUMBERS[j] - NUMBERS[k])
}

/// The weight of [`power_weight`] for an exponent that is a parameter.
#[inline(always)]
pub fn power_weight_with<R: Real>(exponent: R, j: usize, k: usize) -> R {
    exponent * R::of(NUMBERS[j]) - R::of(NUMBERS[k - j])
}

/// The sum of the products of a power, from `Σ aⱼ yₖ₋ⱼ` and `Σ j aⱼ yₖ₋ⱼ`.
#[inline(always)]
pub fn power_sum<R: Real>(exponent: R, k: usize, sums: R::Pair) -> R {
    let [sum, by_order] = sums.parts();
    sum.fma(R::of(-NUMBERS[k]), (exponent + R::of(1.0)) * by_order)
}

/// The lowest orders, whose reciprocals come in two parts.
///
/// A rounded `1/n` is off by the same fraction at every step, which adds up to a drift. At the tolerances where roundings
/// matter, terms fall by a factor of four from one order to the next: what is left from the ninth order on is 4e-6 of a
/// rounding per step.
const IN_TWO_PARTS: usize = 8;

/// `x / n` for an order `n`; for the lowest ones as if in one division.
#[inline(always)]
pub fn div_by_order<R: Real>(x: R, n: usize) -> R {
    times(x, const { reciprocals(0) }[n])
}

/// `x u / n` with a power of two `u`, which changes no digit.
#[inline(always)]
pub(super) fn scaled_by_order<R: Real>(x: R, unit: R, n: usize) -> R {
    times_scaled(x, unit, const { reciprocals(0) }[n])
}

/// `x u / (n (n + 1))` with a power of two `u`; for the lowest orders as if in one division.
#[inline(always)]
pub(super) fn scaled_by_two_orders<R: Real>(x: R, unit: R, n: usize) -> R {
    times_scaled(x, unit, const { reciprocals(1) }[n])
}

#[inline(always)]
fn times<R: Real>(x: R, [high, low]: [f64; 2]) -> R {
    if low == 0.0 { x * R::of(high) } else { x.fma(R::of(high), x * R::of(low)) }
}

/// `x / n` times a power of two. This multiplies the reciprocals, which are known before `x` is.
#[inline(always)]
fn times_scaled<R: Real>(x: R, unit: R, [high, low]: [f64; 2]) -> R {
    let high = R::of(high) * unit;
    if low == 0.0 { x * high } else { x.fma(high, x * (R::of(low) * unit)) }
}

/// `1/n`, or `1/(n (n + 1))` for one more: for the lowest orders as a number with as many digits as a single has, and the
/// rest.
const fn reciprocals(more: usize) -> [[f64; 2]; COEFFICIENTS] {
    let mut parts = [[0.0; 2]; COEFFICIENTS];
    let mut n = 1;
    while n < COEFFICIENTS {
        let divisor = if more == 0 { n } else { n * (n + 1) } as f64;
        let high = if n <= IN_TWO_PARTS { (1.0 / divisor) as f32 as f64 } else { 1.0 / divisor };
        // The product with a small integer is exact, and so is the difference of neighbours.
        parts[n] = [high, if n <= IN_TWO_PARTS { (1.0 - divisor * high) / divisor } else { 0.0 }];
        n += 1;
    }
    parts
}

/// A coefficient of a power with any exponent, `value` as its recurrence finds it, which divides by the base: where this
/// begins at zero, and the exponent is a whole number from zero on, it is that of a product. It is zero where the base is
/// zero at all orders and the exponent is positive. `base` has the coefficients up to the order.
#[inline(always)]
pub fn power_at_zero<R: Real>(value: R, exponent: R, order: usize, base: impl Fn(usize) -> R) -> R {
    let at_zero = base(0).equal(R::of(0.0));
    if at_zero.any() { whole_power_at_zero(at_zero, value, exponent, order, base) } else { value }
}

#[cold]
fn whole_power_at_zero<R: Real>(at_zero: R::Mask, value: R, exponent: R, order: usize, base: impl Fn(usize) -> R) -> R {
    let zero = R::of(0.0);
    let is_whole = exponent.floor().equal(exponent).and(exponent.less(zero).not());
    let (mut factor, mut power) = ([zero; COEFFICIENTS], [zero; COEFFICIENTS]);
    let mut stays_zero = zero.less(exponent);
    for (j, coefficient) in factor.iter_mut().enumerate().take(order + 1) {
        *coefficient = base(j);
        stays_zero = stays_zero.and(coefficient.equal(zero));
    }
    power[0] = R::of(1.0);
    let mut exponent = exponent;
    // The power begins with the order of its exponent: those with more digits than orders have none.
    for _ in 0..usize::BITS - HIGHEST.leading_zeros() {
        let half = (exponent * R::of(0.5)).floor();
        let is_odd = R::of(0.5).less(exponent - half - half);
        let with_factor = product(&power, &factor, order);
        for (power, with_factor) in power.iter_mut().zip(with_factor) {
            *power = R::select(is_odd, with_factor, *power);
        }
        factor = product(&factor, &factor, order);
        exponent = half;
    }
    let coefficient = R::select(zero.less(exponent), zero, power[order]);
    R::select(at_zero.and(is_whole), coefficient, R::select(stays_zero, zero, value))
}

/// The coefficients of a product up to an order.
fn product<R: Real>(a: &[R; COEFFICIENTS], b: &[R; COEFFICIENTS], order: usize) -> [R; COEFFICIENTS] {
    let mut product = [R::of(0.0); COEFFICIENTS];
    for (k, sum) in product.iter_mut().enumerate().take(order + 1) {
        for j in 0..k + 1 {
            *sum = a[j].fma(b[k - j], *sum);
        }
    }
    product
}

/// `x` to the power of this number of halves.
#[inline(always)]
pub fn half_power<R: Real>(x: R, halves: i32) -> R {
    let mut power = if halves % 2 == 0 { R::of(1.0) } else { x.sqrt() };
    for _ in 0..halves.unsigned_abs() / 2 {
        power = power * x;
    }
    if halves < 0 { R::of(1.0) / power } else { power }
}

/// An exponential, bounded so that its later coefficients are finite: they belong to the divisors of derivatives.
#[inline(always)]
pub fn bounded<R: Real>(exponential: R) -> R {
    R::select(R::huge().less(exponential), R::huge(), exponential)
}

/// The coefficients of one and of the time at an expansion, in a unit of time.
#[inline(always)]
pub fn time_coefficients<R: Real>(k: usize, time: R, unit: R) -> (R, R) {
    match k {
        0 => (R::of(1.0), time),
        1 => (R::of(0.0), unit),
        _ => (R::of(0.0), R::of(0.0)),
    }
}

/// The record of the next iteration of a loop.
#[inline(always)]
pub fn next_record<'t, T: Default>(iterations: &'t mut Vec<T>, next: &mut usize) -> &'t mut T {
    let index = *next;
    *next += 1;
    if index == iterations.len() {
        iterations.push(T::default());
    }
    &mut iterations[index]
}

#[cfg(test)]
mod tests {
    use super::{HIGHEST, div_by_order, scaled_by_order, scaled_by_two_orders};

    #[test]
    fn reciprocals_are_those_of_one_division() {
        for n in 1..=HIGHEST + 1 {
            assert_eq!(div_by_order(1.0, n), 1.0 / n as f64, "1/{n}");
            for unit in [2.0_f64.powi(-300), 1.0, 2.0_f64.powi(300)] {
                assert_eq!(scaled_by_order(1.0, unit, n), unit / n as f64, "1/{n}");
                assert_eq!(scaled_by_two_orders(1.0, unit, n), unit / (n * (n + 1)) as f64, "1/({n} ({n} + 1))");
            }
        }
    }
}
