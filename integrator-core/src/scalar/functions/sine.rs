//! Sine and cosine, in the precision of the scalar.
//!
//! The argument becomes `n·π/2 + r` with `|r| <= π/4`, where `r` carries the rounding error of its subtraction. With
//! `z = r²`, the two polynomials have one form,
//!
//! ```text
//! sin r = r - (r·z)·S(z)        cos r = 1 + r·(r·C(z))
//! ```
//!
//! so that a number chooses coefficients and computes one of them. Terms are summed in pairs (Estrin), since a lone
//! trajectory waits for every operation in a row.
//!
//! `S` and `C` are minimax (Remez in 300 bits, weighted for the relative error of the result, coefficients rounded one
//! after the other and the later ones fitted again). A zero keeps its sign because no operation on the way adds zeros
//! of different signs: all parts of π/2 are rounded down, hence positive.

use super::{Bits, quotient, with_fallback};
use crate::scalar::{elementary::Elementary, real::Mask};
use core::f64::consts::{FRAC_2_PI, FRAC_PI_2};

/// Argument reduction and polynomials of the trigonometric functions in one format.
pub(crate) trait TrigReduction: Sized {
    /// Added to a number, leaves its nearest integer in the last bits of the sum.
    const MAGIC: f64;
    /// π/2 in three parts, for machines that round `x - n·π/2` once: the difference from the first part is exact.
    const QUARTER: [f64; 3];
    /// π/2 in four parts, for others: the products of `n` with the first three are exact, and so are their differences
    /// where they cancel.
    const SPLIT_QUARTER: [f64; 4];
    /// The largest argument for which that is so, on machines of the first kind and of the second.
    const MAX_FAST_ARGUMENT: [f64; 2];
    /// The position of the sign in the pattern.
    const SIGN: u32;
    /// The first coefficients of `S` and of `C`.
    const LEADING: [f64; 2];

    /// The other terms, `excess` added: those of the sine, or of the cosine where `odd` holds; `inner` is what the
    /// second coefficient is multiplied by.
    fn tail<R: Bits<Scalar = Self>>(odd: R::Mask, z: R, inner: R, excess: R) -> R;
    /// Sine, cosine and tangent of the maths library, for arguments beyond `MAX_FAST_ARGUMENT`.
    const FALLBACKS: [fn(&mut [Self]); 3];
}

/// An argument as a number of quarter turns and a rest.
#[derive(Clone, Copy)]
pub(crate) struct Reduced<R> {
    /// The quarter turns, in the last bits of the pattern.
    quarters: R,
    /// The rest, rounded.
    r: R,
    /// The error of its rounding: the rest is too large by it.
    excess: R,
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn reduce<R: Bits<Scalar: TrigReduction>>(x: R) -> Reduced<R> {
    let quarters = x.fma(R::of(FRAC_2_PI), R::of(R::Scalar::MAGIC));
    let n = quarters - R::of(R::Scalar::MAGIC);
    if R::FUSED {
        let [first, second, third] = R::Scalar::QUARTER;
        let close = n.fma(R::of(-first), x);
        let second = n * R::of(second);
        let r = close - second;
        Reduced { quarters, r, excess: n.fma(R::of(third), (r - close) + second) }
    } else {
        let [first, second, third, fourth] = R::Scalar::SPLIT_QUARTER.map(|part| n * R::of(part));
        let close = x - first;
        let subtrahend = second + third;
        let r = close - subtrahend;
        let lost = (subtrahend - second) - third;
        Reduced { quarters, r, excess: (((r - close) + subtrahend) - lost) + fourth }
    }
}

/// A coefficient of the sine, or of the cosine where `odd` holds.
#[cfg_attr(not(debug_assertions), inline(always))]
fn coefficient<R: Bits>(odd: R::Mask, [sine, cosine]: [f64; 2]) -> R {
    R::select(odd, R::of(cosine), R::of(sine))
}

/// The sine and the cosine of the rest.
#[cfg_attr(not(debug_assertions), inline(always))]
fn both<R: Bits<Scalar: TrigReduction>>(reduced: Reduced<R>) -> [R; 2] {
    let [sine, _] = sin_or_cos_with_error(R::Mask::of(false), reduced);
    let [cosine, _] = sin_or_cos_with_error(R::Mask::of(true), reduced);
    [sine, cosine]
}

/// The sine of the rest, or its cosine where `odd` holds. Lanes compute both: the selections of all coefficients take longer.
#[cfg_attr(not(debug_assertions), inline(always))]
fn sin_or_cos<R: Bits<Scalar: TrigReduction>>(odd: R::Mask, reduced: Reduced<R>) -> R {
    if R::LANES == 1 {
        return sin_or_cos_with_error(odd, reduced)[0];
    }
    let [sine, cosine] = both(reduced);
    R::select(odd, cosine, sine)
}

/// The sine of the rest, or its cosine where `odd` holds, and the error of the last rounding.
///
/// The leading term is added last but one, so that only two roundings are of the size of half a unit of the result.
#[cfg_attr(not(debug_assertions), inline(always))]
fn sin_or_cos_with_error<R: Bits<Scalar: TrigReduction>>(
    odd: R::Mask,
    Reduced { r, excess, .. }: Reduced<R>,
) -> [R; 2] {
    let z = r * r;
    let (inner, outer) = (R::select(odd, r, r * z), R::select(odd, r, R::of(-1.0)));
    let tail = R::Scalar::tail(odd, z, inner * z, excess);
    let sum = inner.fma(coefficient(odd, R::Scalar::LEADING), tail);
    let base = R::select(odd, R::of(1.0), r);
    let value = outer.fma(sum, base);
    [value, outer.fma(sum, base - value)]
}

/// Flips the sign of `value` in every other pair of quarters.
#[cfg_attr(not(debug_assertions), inline(always))]
fn signed<R: Bits<Scalar: TrigReduction>>(value: R, quarters: R) -> R {
    value.bits_xor(quarters.bits_left(R::Scalar::SIGN - 1).bits_and(R::of(-0.0)))
}

/// `value` where the argument can be reduced, and the fallback of sine, cosine or tangent (0, 1 or 2) beyond.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn reduced_or_fallback<R: Bits<Scalar: TrigReduction>>(value: R, x: R, function: usize) -> R {
    let max = R::Scalar::MAX_FAST_ARGUMENT[usize::from(!R::FUSED)];
    with_fallback(value, x.abs().less_or_equal(R::of(max)), x, R::Scalar::FALLBACKS[function])
}

/// The sine, with an error of at most 0.81 ulp with a fused multiply-add, 1 without.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn sin<R: Bits<Scalar: TrigReduction>>(x: R) -> R {
    let reduced = reduce(x);
    let value = sin_or_cos(reduced.quarters.is_odd(), reduced);
    reduced_or_fallback(signed(value, reduced.quarters), x, 0)
}

/// The cosine, with an error of at most 0.81 ulp with a fused multiply-add, 1 without.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn cos<R: Bits<Scalar: TrigReduction>>(x: R) -> R {
    let reduced = reduce(x);
    let ahead = reduced.quarters + R::of(1.0);
    let value = sin_or_cos(ahead.is_odd(), reduced);
    reduced_or_fallback(signed(value, ahead), x, 1)
}

/// The sine and the cosine, bitwise identical to `sin` and `cos`.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn sin_cos<R: Bits<Scalar: TrigReduction>>(x: R) -> (R, R) {
    let reduced = reduce(x);
    let [sine, cosine] = both(reduced);
    let (odd, ahead) = (reduced.quarters.is_odd(), reduced.quarters + R::of(1.0));
    let sine_of_x = signed(R::select(odd, cosine, sine), reduced.quarters);
    let cosine_of_x = signed(R::select(odd, sine, cosine), ahead);
    (reduced_or_fallback(sine_of_x, x, 0), reduced_or_fallback(cosine_of_x, x, 1))
}

/// Both parts of `a` in the lanes of `mask`, of `b` in the others.
#[cfg_attr(not(debug_assertions), inline(always))]
fn select_both<R: Bits>(mask: R::Mask, a: [R; 2], b: [R; 2]) -> [R; 2] {
    [R::select(mask, a[0], b[0]), R::select(mask, a[1], b[1])]
}

/// The tangent, with an error of at most 2 ulp: the quotient of sine and cosine of the rest, or of cosine and sine,
/// negative, in odd quarters.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn tan<R: Bits<Scalar: TrigReduction>>(x: R) -> R {
    let reduced = reduce(x);
    let (sine, cosine) =
        (sin_or_cos_with_error(R::Mask::of(false), reduced), sin_or_cos_with_error(R::Mask::of(true), reduced));
    let odd = reduced.quarters.is_odd();
    let value = quotient(select_both(odd, cosine, sine), select_both(odd, [-sine[0], -sine[1]], cosine));
    // The sum of a zero and its correction has lost the sign.
    let value = R::select(x.equal(R::of(0.0)), x, value);
    reduced_or_fallback(value, x, 2)
}

/// The error of the polynomials: 2^-57.9 for the sine, 2^-63.9 for the cosine.
impl TrigReduction for f64 {
    const MAGIC: f64 = 6_755_399_441_055_744.0;
    const QUARTER: [f64; 3] = [FRAC_PI_2, 6.123_233_995_384_61e-17, 3.521_559_865_183_2e-27];
    const SPLIT_QUARTER: [f64; 4] =
        [1.570_796_326_734_125_6, 6.077_100_506_303_966e-11, 2.022_266_248_711_166_5e-21, 8.478_427_660_368_9e-32];
    /// 2^20 quarter turns.
    const MAX_FAST_ARGUMENT: [f64; 2] = [1_647_099.0; 2];
    const SIGN: u32 = 63;
    const LEADING: [f64; 2] = [0.166_666_666_666_666_3, -0.5];

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn tail<R: Bits<Scalar = f64>>(odd: R::Mask, z: R, inner: R, excess: R) -> R {
        let first = z.fma(
            coefficient(odd, [1.984_126_982_935_850_6e-4, -1.388_888_888_887_334_2e-3]),
            coefficient(odd, [-8.333_333_333_321_84e-3, 4.166_666_666_666_659_5e-2]),
        );
        let second = z.fma(
            coefficient(odd, [2.505_073_438_933_484_8e-8, -2.755_731_421_703_767e-7]),
            coefficient(odd, [-2.755_731_353_850_646e-6, 2.480_158_728_900_208e-5]),
        );
        let of_cosine = z.fma(R::of(-1.135_874_918_630_080_7e-11), R::of(2.087_570_539_550_263e-9));
        let third = R::select(odd, of_cosine, R::of(-1.589_543_341_933_909_4e-10));
        let zz = z * z;
        (inner * zz).fma(zz.fma(third, second), inner.fma(first, excess))
    }

    const FALLBACKS: [fn(&mut [f64]); 3] = [sine_fallback, cosine_fallback, tangent_fallback];
}

#[cold]
#[inline(never)]
fn sine_fallback(lanes: &mut [f64]) {
    lanes.iter_mut().for_each(|lane| *lane = Elementary::sin(*lane));
}

#[cold]
#[inline(never)]
fn cosine_fallback(lanes: &mut [f64]) {
    lanes.iter_mut().for_each(|lane| *lane = Elementary::cos(*lane));
}

#[cold]
#[inline(never)]
fn tangent_fallback(lanes: &mut [f64]) {
    lanes.iter_mut().for_each(|lane| *lane = Elementary::tan(*lane));
}

/// The error of the polynomials: 2^-27.8 for the sine, 2^-32.9 for the cosine.
impl TrigReduction for f32 {
    const MAGIC: f64 = 12_582_912.0;
    const QUARTER: [f64; 3] = [1.570_796_251_296_997, 7.549_533_620_476_723e-8, 2.563_344_068_257_089_6e-12];
    const SPLIT_QUARTER: [f64; 4] =
        [1.570_678_710_937_5, 1.176_148_653_030_395_5e-4, 9.920_313_459_588_215e-10, 6.223_371_969_669_989e-14];
    /// 2^11 and 2^10 quarter turns.
    const MAX_FAST_ARGUMENT: [f64; 2] = [3_216.0, 1_608.0];
    const SIGN: u32 = 31;
    const LEADING: [f64; 2] = [0.166_666_537_523_269_65, -0.5];

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn tail<R: Bits<Scalar = f32>>(odd: R::Mask, z: R, inner: R, excess: R) -> R {
        let first = z.fma(
            coefficient(odd, [1.950_789_010_152_220_7e-4, -1.388_730_597_682_297_2e-3]),
            coefficient(odd, [-8.332_106_284_797_192e-3, 4.166_664_555_668_831e-2]),
        );
        let low = inner.fma(first, excess);
        R::select(odd, (inner * (z * z)).fma(R::of(2.443_165_067_236_707_4e-5), low), low)
    }

    const FALLBACKS: [fn(&mut [f32]); 3] = [far_sine_single, far_cosine_single, far_tangent_single];
}

#[cold]
#[inline(never)]
fn far_sine_single(lanes: &mut [f32]) {
    lanes.iter_mut().for_each(|lane| *lane = Elementary::sin(*lane));
}

#[cold]
#[inline(never)]
fn far_cosine_single(lanes: &mut [f32]) {
    lanes.iter_mut().for_each(|lane| *lane = Elementary::cos(*lane));
}

#[cold]
#[inline(never)]
fn far_tangent_single(lanes: &mut [f32]) {
    lanes.iter_mut().for_each(|lane| *lane = Elementary::tan(*lane));
}
