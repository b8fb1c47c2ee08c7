//! The natural logarithm.
//!
//! The argument becomes `2ᵏ·m` with `√½ <= m < √2`. With `f = m - 1` and `s = f / (2 + f)`,
//! `ln m = f - (f²/2 - s·(f²/2 + s²·L(s²)))`: the leading term is exact, so that little of what follows is rounded at
//! its size. The first part of ln 2 is so short that its product with `k` is exact.
//!
//! Of `1 + x` the argument is the rounded sum, and its rounding error is added to `f`: where `k` is zero, `f` is `x`.
//!
//! `L` is minimax (Remez in 300 bits, weighted for the relative error of `ln m`, coefficients rounded one after the
//! other and the later ones fitted again).

use super::{Bits, cubic, exponential::Exponential, linear, with_fallback};
use crate::scalar::{
    elementary::Elementary,
    exact::{fast_two_sum, two_sum},
    real::Mask,
};

/// Constants and polynomials of the natural logarithm in one format.
pub(crate) trait Logarithm: Exponential {
    /// The patterns of √½ and of the exponent of one; a pattern whose exponent is that of 2^`EXPONENT`.
    const PATTERNS: [u64; 3];
    /// The least and the greatest normal number.
    const NORMAL: [f64; 2];

    /// `L` at `z`.
    fn series<R: Bits<Scalar = Self>>(z: R) -> R;
    /// `L` at `z`, with the digits that 4 ulp require.
    fn short_series<R: Bits<Scalar = Self>>(z: R) -> R;
    /// The function of the maths library, for arguments that are not normal or not positive.
    fn fallback(lanes: &mut [Self]);
    /// The same of `ln(1 + x)`.
    fn fallback_1p(lanes: &mut [Self]);
}

/// Splits a normal number into `k` and `f`.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn split<R: Bits<Scalar: Logarithm>>(x: R) -> (R, R) {
    let [root, one, integer] = R::Scalar::PATTERNS;
    // Moved so that the mantissa begins at √½, and the exponent is never negative.
    let moved = x.bits_add(R::pattern(one.wrapping_sub(root)));
    let exponent = moved.bits_right(R::Scalar::EXPONENT).bits_add(R::pattern(integer));
    let bias = (one >> R::Scalar::EXPONENT) as f64;
    let k = exponent - R::of((1_u64 << R::Scalar::EXPONENT) as f64 + bias);
    let mantissa = R::pattern((1 << R::Scalar::EXPONENT) - 1);
    (k, moved.bits_and(mantissa).bits_add(R::pattern(root)) - R::of(1.0))
}

/// The mask of the lanes that are normal and positive.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn normal<R: Bits<Scalar: Logarithm>>(x: R) -> R::Mask {
    let [least, greatest] = R::Scalar::NORMAL.map(R::of);
    least.less_or_equal(x).and(x.less_or_equal(greatest))
}

/// The logarithm of `2ᵏ·(1 + f)`, where `f` lost a rounding error.
#[cfg_attr(not(debug_assertions), inline(always))]
fn joined<R: Bits<Scalar: Logarithm>>(k: R, f: R, lost: R) -> R {
    let s = f / (f + R::of(2.0));
    let z = s * s;
    let half_square = R::of(0.5) * f * f;
    let [first, second] = R::Scalar::LN_2;
    let small = s.fma(z.fma(<R::Scalar as Logarithm>::series(z), half_square), k.fma(R::of(second), lost));
    k.fma(R::of(first), f - (half_square - small))
}

/// The same with the digits that 4 ulp require: `ln m = s·(2 + s²·L(s²))`.
#[cfg_attr(not(debug_assertions), inline(always))]
fn fast_joined<R: Bits<Scalar: Logarithm>>(k: R, f: R, lost: R) -> R {
    let s = f / (f + R::of(2.0));
    let z = s * s;
    let [first, second] = R::Scalar::LN_2;
    let slope = z.fma(<R::Scalar as Logarithm>::short_series(z), R::of(2.0));
    k.fma(R::of(first), s.fma(slope, k.fma(R::of(second), lost)))
}

/// The natural logarithm, with an error of at most 1 ulp.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn ln<R: Bits<Scalar: Logarithm>>(x: R) -> R {
    let (k, f) = split(x);
    with_fallback(joined(k, f, R::of(0.0)), normal(x), x, <R::Scalar as Logarithm>::fallback)
}

/// The natural logarithm, with an error of at most 4 ulp.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn fast_ln<R: Bits<Scalar: Logarithm>>(x: R) -> R {
    let (k, f) = split(x);
    with_fallback(fast_joined(k, f, R::of(0.0)), normal(x), x, <R::Scalar as Logarithm>::fallback)
}

/// Splits `1 + x` into `k` and `f`, and what `f` lost.
#[cfg_attr(not(debug_assertions), inline(always))]
fn split_1p<R: Bits<Scalar: Logarithm>>(x: R) -> (R, [R; 2]) {
    let [sum, lost] = two_sum(R::of(1.0), x);
    let (k, f) = split(sum);
    let scale = R::of(1.0).bits_add((R::of(R::Scalar::MAGIC) - k).bits_left(R::Scalar::EXPONENT));
    (k, fast_two_sum(f, lost * scale))
}

/// The value of `ln(1 + x)` where it is `x` or of the kernel, and the fallback elsewhere.
#[cfg_attr(not(debug_assertions), inline(always))]
fn checked_1p<R: Bits<Scalar: Logarithm>>(value: R, x: R) -> R {
    let [_, greatest] = R::Scalar::NORMAL;
    // Up to a quarter of the greatest number, `2⁻ᵏ` is a normal number.
    let fast = R::of(-1.0).less(x).and(x.less_or_equal(R::of(0.25 * greatest)));
    let value = with_fallback(value, fast, x, <R::Scalar as Logarithm>::fallback_1p);
    // The sign of zero is lost in the sum.
    R::select(x.equal(R::of(0.0)), x, value)
}

/// The natural logarithm of `1 + x`, with an error of at most 1 ulp.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn ln_1p<R: Bits<Scalar: Logarithm>>(x: R) -> R {
    let (k, [f, lost]) = split_1p(x);
    checked_1p(joined(k, f, lost), x)
}

/// The natural logarithm of `1 + x`, with an error of at most 4 ulp.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn fast_ln_1p<R: Bits<Scalar: Logarithm>>(x: R) -> R {
    let (k, [f, lost]) = split_1p(x);
    checked_1p(fast_joined(k, f, lost), x)
}

/// The errors of the polynomials: 2^-59.5 and 2^-52.2.
impl Logarithm for f64 {
    const PATTERNS: [u64; 3] = [0x3fe6_a09e_667f_3bcd, 0x3ff0_0000_0000_0000, 0x4330_0000_0000_0000];
    const NORMAL: [f64; 2] = [f64::MIN_POSITIVE, f64::MAX];

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn series<R: Bits<Scalar = f64>>(z: R) -> R {
        let c = |coefficient| R::of(coefficient);
        let first = z.fma(c(3.999_999_999_941_706e-1), c(6.666_666_666_666_734e-1));
        let second = z.fma(c(2.222_219_862_189_555_3e-1), c(2.857_142_874_188_975_4e-1));
        let third = z.fma(c(1.531_411_057_196_961e-1), c(1.818_356_189_470_896e-1));
        let square = z * z;
        square.fma(square.fma(square.fma(c(1.479_536_844_409_115e-1), third), second), first)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn short_series<R: Bits<Scalar = f64>>(z: R) -> R {
        let square = z * z;
        let low = cubic(
            z,
            square,
            [0.666_666_666_665_875, 0.400_000_000_521_325_3, 0.285_714_171_517_861_77, 0.222_233_701_872_076_3],
        );
        (square * square).fma(linear(z, [0.181_236_887_716_446_67, 0.168_192_909_214_938_04]), low)
    }

    #[cold]
    #[inline(never)]
    fn fallback(lanes: &mut [f64]) {
        lanes.iter_mut().for_each(|lane| *lane = Elementary::ln(*lane));
    }

    #[cold]
    #[inline(never)]
    fn fallback_1p(lanes: &mut [f64]) {
        lanes.iter_mut().for_each(|lane| *lane = Elementary::ln_1p(*lane));
    }
}

/// The error of the polynomial: 2^-30.2.
impl Logarithm for f32 {
    const PATTERNS: [u64; 3] = [0x3f35_04f3, 0x3f80_0000, 0x4b00_0000];
    const NORMAL: [f64; 2] = [f32::MIN_POSITIVE as f64, f32::MAX as f64];

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn series<R: Bits<Scalar = f32>>(z: R) -> R {
        let c = |coefficient| R::of(coefficient);
        z.fma(z.fma(c(2.987_070_083_618_164e-1), c(3.997_758_626_937_866e-1)), c(6.666_677_594_184_875e-1))
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn short_series<R: Bits<Scalar = f32>>(z: R) -> R {
        <f32 as Logarithm>::series(z)
    }

    #[cold]
    #[inline(never)]
    fn fallback(lanes: &mut [f32]) {
        lanes.iter_mut().for_each(|lane| *lane = Elementary::ln(*lane));
    }

    #[cold]
    #[inline(never)]
    fn fallback_1p(lanes: &mut [f32]) {
        lanes.iter_mut().for_each(|lane| *lane = Elementary::ln_1p(*lane));
    }
}
