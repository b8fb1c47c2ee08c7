//! The exponential function and what is made of it.
//!
//! The argument becomes `n·ln 2 + r` with `|r| <= ln 2 / 2`, where `r` carries the rounding error of its subtraction:
//! `eˣ = 2ⁿ·(1 + r + r²·P(r))`. The first part of ln 2 is so short that its product with `n` is exact.
//!
//! `P` is minimax (Remez in 300 bits, weighted for the relative error of `eˣ`, coefficients rounded).

use super::{Bits, cubic, quotient};
use crate::scalar::{exact::fast_two_sum, real::Mask};
use core::f64::consts::LOG2_E;

/// Constants and polynomials of the exponential function in one format.
pub(crate) trait Exponential: Sized {
    /// Added to a number, leaves its nearest integer in the last bits of the sum.
    const MAGIC: f64;
    /// ln 2 in two parts.
    const LN_2: [f64; 2];
    /// The position of the exponent in the pattern.
    const EXPONENT: u32;
    /// The argument up to which neither `eˣ` nor `e⁻ˣ` leaves the normal numbers.
    const MAX_FAST_ARGUMENT: f64;
    /// The arguments below and above which `eˣ` rounds to zero and to infinity.
    const LIMITS: [f64; 2];
    /// The argument from which on the hyperbolic tangent is one.
    const SATURATED: f64;

    /// `P` at `r`.
    fn series<R: Bits<Scalar = Self>>(r: R) -> R;
    /// `P` at `r`, with the digits that 4 ulp require.
    fn short_series<R: Bits<Scalar = Self>>(r: R) -> R;
}

/// Splits the sum of a number and a small one: `n` in the last bits of the pattern, and `eʳ - 1` with the error of its
/// rounding.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn parts<R: Bits<Scalar: Exponential>>(x: R, small: R) -> (R, [R; 2]) {
    let magic = R::of(R::Scalar::MAGIC);
    let pattern = x.fma(R::of(LOG2_E), magic);
    let n = pattern - magic;
    let [first, second] = R::Scalar::LN_2;
    let close = n.fma(R::of(-first), x);
    let second = n * R::of(second) - small;
    let r = close - second;
    let excess = (r - close) + second;
    let rest = (r * r).fma(R::Scalar::series(r), -excess);
    (pattern, fast_two_sum(r, rest))
}

/// `2ⁿ·(1 + less_one)`, where `2ⁿ` is a normal number.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn raised<R: Bits<Scalar: Exponential>>(n: R, less_one: R) -> R {
    (R::of(1.0) + less_one).bits_add(n.bits_left(R::Scalar::EXPONENT))
}

/// The exponential where its power of two need not be a normal number, in two steps. A tail of small numbers is no
/// reason to leave the registers.
#[cfg_attr(not(debug_assertions), inline(always))]
fn far<R: Bits<Scalar: Exponential>>(x: R) -> R {
    let [low, high] = R::Scalar::LIMITS.map(R::of);
    let x = R::select(x.less(low), low, x);
    let x = R::select(high.less(x), high, x);
    let (n, [less_one, _]) = parts(x, R::of(0.0));
    let (one, exponent) = (R::of(1.0), R::Scalar::EXPONENT);
    let first = one.bits_add(n.bits_right(1).bits_left(exponent));
    let second = one.bits_add((n + one).bits_right(1).bits_left(exponent));
    first.fma(less_one, first) * second
}

/// The exponential, with an error of at most 0.9 ulp.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn exp<R: Bits<Scalar: Exponential>>(x: R) -> R {
    let (n, [less_one, _]) = parts(x, R::of(0.0));
    let value = raised(n, less_one);
    let outside = x.abs().less_or_equal(R::of(R::Scalar::MAX_FAST_ARGUMENT)).not();
    if outside.any() { R::select(outside, far(x), value) } else { value }
}

/// `n` in the last bits of the pattern, and `r`, rounded.
#[cfg_attr(not(debug_assertions), inline(always))]
fn short_parts<R: Bits<Scalar: Exponential>>(x: R) -> (R, R) {
    let magic = R::of(R::Scalar::MAGIC);
    let pattern = x.fma(R::of(LOG2_E), magic);
    let n = pattern - magic;
    let [first, second] = R::Scalar::LN_2;
    (pattern, n.fma(R::of(-second), n.fma(R::of(-first), x)))
}

/// The exponential, with an error of at most 4 ulp.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn fast_exp<R: Bits<Scalar: Exponential>>(x: R) -> R {
    let (n, r) = short_parts(x);
    let value = raised(n, (r * r).fma(R::Scalar::short_series(r), r));
    let outside = x.abs().less_or_equal(R::of(R::Scalar::MAX_FAST_ARGUMENT)).not();
    if outside.any() { R::select(outside, far(x), value) } else { value }
}

/// The hyperbolic tangent, with an error of at most 4 ulp, as `tanh`.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn fast_tanh<R: Bits<Scalar: Exponential>>(x: R) -> R {
    let (size, farthest) = (x.abs(), R::of(R::Scalar::SATURATED));
    let size = R::select(farthest.less(size), farthest, size);
    let (n, r) = short_parts(size + size);
    let less_one = (r * r).fma(R::Scalar::series(r), r);
    let power = R::of(1.0).bits_add(n.bits_left(R::Scalar::EXPONENT));
    let risen = power.fma(less_one, power - R::of(1.0));
    (risen / (risen + R::of(2.0))).bits_xor(x.bits_and(R::of(-0.0)))
}

/// The hyperbolic tangent, with an error of at most 2 ulp: `tanh x = E / (E + 2)` with `E = e²ˣ - 1`, of the absolute
/// value.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn tanh<R: Bits<Scalar: Exponential>>(x: R) -> R {
    let (size, farthest) = (x.abs(), R::of(R::Scalar::SATURATED));
    let size = R::select(farthest.less(size), farthest, size);
    let (n, [less_one, error]) = parts(size + size, R::of(0.0));
    let power = R::of(1.0).bits_add(n.bits_left(R::Scalar::EXPONENT));
    let whole = power - R::of(1.0);
    let risen = power.fma(less_one, whole);
    let error = power.fma(error, power.fma(less_one, whole - risen));
    let [divisor, lost] = fast_two_sum(R::of(2.0), risen);
    quotient([risen, error], [divisor, lost + error]).bits_xor(x.bits_and(R::of(-0.0)))
}

/// The errors of the polynomials: 2^-60.3 and 2^-51.6.
impl Exponential for f64 {
    const MAGIC: f64 = 6_755_399_441_055_744.0;
    const LN_2: [f64; 2] = [0.693_147_180_559_890_3, 5.497_923_018_708_371e-14];
    const EXPONENT: u32 = 52;
    const MAX_FAST_ARGUMENT: f64 = 708.0;
    const LIMITS: [f64; 2] = [-746.0, 710.0];
    const SATURATED: f64 = 20.0;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn series<R: Bits<Scalar = f64>>(r: R) -> R {
        let c = |coefficient| R::of(coefficient);
        let first = r.fma(c(1.666_666_666_666_668_2e-1), c(0.5));
        let second = r.fma(c(8.333_333_333_317_048e-3), c(4.166_666_666_666_609_5e-2));
        let third = r.fma(c(1.984_126_989_635_514_7e-4), c(1.388_888_888_911_545e-3));
        let fourth = r.fma(c(2.755_723_489_509_416_7e-6), c(2.480_158_692_686_222_6e-5));
        let fifth = r.fma(c(2.511_202_508_659_449e-8), c(2.755_758_173_349_850_7e-7));
        let square = r * r;
        let fourth_power = square * square;
        let low = square.fma(second, first);
        let middle = square.fma(fourth, third);
        let high = square.fma(c(2.082_664_140_595_380_8e-9), fifth);
        fourth_power.fma(fourth_power.fma(high, middle), low)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn short_series<R: Bits<Scalar = f64>>(r: R) -> R {
        let square = r * r;
        let low = cubic(
            r,
            square,
            [0.499_999_999_999_983_24, 0.166_666_666_666_115_6, 0.041_666_666_668_135_99, 0.008_333_333_370_868_718],
        );
        let high = cubic(
            r,
            square,
            [
                0.001_388_888_851_632_062_4,
                0.000_198_411_852_379_135,
                2.480_193_165_419_296_3e-5,
                2.763_499_011_386_59e-6,
            ],
        );
        let fourth = square * square;
        fourth.fma(fourth.fma(R::of(2.747_681_050_877_795e-7), high), low)
    }
}

/// The errors of the polynomials: 2^-27.7 and 2^-23.2.
impl Exponential for f32 {
    const MAGIC: f64 = 12_582_912.0;
    const LN_2: [f64; 2] = [0.693_145_751_953_125, 1.428_606_765_330_187e-6];
    const EXPONENT: u32 = 23;
    const MAX_FAST_ARGUMENT: f64 = 87.0;
    const LIMITS: [f64; 2] = [-104.0, 89.0];
    const SATURATED: f64 = 10.0;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn series<R: Bits<Scalar = f32>>(r: R) -> R {
        let c = |coefficient| R::of(coefficient);
        let first = r.fma(c(1.666_651_815_176_01e-1), c(4.999_999_403_953_552e-1));
        let second = r.fma(c(8.368_999_697_268_01e-3), c(4.166_842_997_074_127e-2));
        let square = r * r;
        square.fma(square.fma(c(1.381_292_589_940_130_7e-3), second), first)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn short_series<R: Bits<Scalar = f32>>(r: R) -> R {
        cubic(
            r,
            r * r,
            [0.499_992_311_000_824, 0.166_671_141_982_078_55, 0.041_890_114_545_822_144, 0.008_312_563_411_891_46],
        )
    }
}
