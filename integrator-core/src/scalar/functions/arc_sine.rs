//! Arc sine and arc cosine.
//!
//! Up to one half, `asin s = s·(1 + z·S(z))` with `z = s²`; beyond, `acos x = 2·asin √((1 - x)/2)` brings the argument
//! there. What the root lost is added with the other small terms.
//!
//! `S` is minimax as in [`arc`](super::arc).

use super::{
    Bits,
    arc::{Arc, add_quarters, sign},
    cubic, linear,
};
use crate::scalar::exact::{less_product, pattern_less};
use core::f64::consts::FRAC_PI_2;

/// Constants and polynomials of the arc sine in one format.
pub(crate) trait ArcSine: Arc {
    /// From this pattern half of that of a number is subtracted for `1/(2·√x)`, off by 4 % at most.
    const HALF_RECIPROCAL_ROOT: u64;

    /// `S` at `z`.
    fn series<R: Bits<Scalar = Self>>(z: R) -> R;
    /// `S` at `z`, with the digits that 4 ulp require.
    fn short_series<R: Bits<Scalar = Self>>(z: R) -> R;
}

/// Whether the argument is beyond one half, and the arc sine of what brings it there, in two parts.
#[cfg_attr(not(debug_assertions), inline(always))]
fn inner<R: Bits<Scalar: ArcSine>>(size: R) -> (R::Mask, [R; 2]) {
    let half = R::of(0.5);
    let outer = half.less(size);
    let z = R::select(outer, half * (R::of(1.0) - size), size * size);
    let root = z.sqrt();
    let lost = less_product(z, root, root) * pattern_less(R::Scalar::HALF_RECIPROCAL_ROOT, z.bits_right(1));
    let (s, lost) = (R::select(outer, root, size), R::select(outer, lost, R::of(0.0)));
    (outer, [s, (s * z).fma(<R::Scalar as ArcSine>::series(z), lost)])
}

/// Quarter turns, and the factor of an angle that is added for the arc sine of a size.
#[cfg_attr(not(debug_assertions), inline(always))]
fn of_sine<R: Bits>(outer: R::Mask) -> [R; 2] {
    [R::select(outer, R::of(1.0), R::of(0.0)), R::select(outer, R::of(-2.0), R::of(1.0))]
}

/// Quarter turns, and the factor of an angle that is added for the arc cosine of a number.
#[cfg_attr(not(debug_assertions), inline(always))]
fn of_cosine<R: Bits>(x: R, outer: R::Mask) -> [R; 2] {
    let quarters = R::select(x.less(R::of(0.0)), R::of(2.0), R::of(0.0));
    let factor = R::select(outer, R::of(2.0), R::of(-1.0)).bits_xor(sign(x));
    [R::select(outer, quarters, R::of(1.0)), factor]
}

/// The arc sine, with an error of at most 1 ulp.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn asin<R: Bits<Scalar: ArcSine>>(x: R) -> R {
    let (outer, [s, rest]) = inner(x.abs());
    let [quarters, factor] = of_sine::<R>(outer);
    add_quarters(quarters, [factor * s, factor * rest]).bits_xor(sign(x))
}

/// The arc cosine, with an error of at most 1 ulp.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn acos<R: Bits<Scalar: ArcSine>>(x: R) -> R {
    let (outer, [s, rest]) = inner(x.abs());
    let [quarters, factor] = of_cosine(x, outer);
    add_quarters(quarters, [factor * s, factor * rest])
}

/// The outcome of `inner`, with the root and the result rounded.
#[cfg_attr(not(debug_assertions), inline(always))]
fn short_inner<R: Bits<Scalar: ArcSine>>(size: R) -> (R::Mask, R) {
    let half = R::of(0.5);
    let outer = half.less(size);
    let z = R::select(outer, (-half).fma(size, half), size * size);
    let s = R::select(outer, z.sqrt(), size);
    (outer, (s * z).fma(<R::Scalar as ArcSine>::short_series(z), s))
}

/// The arc sine, with an error of at most 4 ulp.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn fast_asin<R: Bits<Scalar: ArcSine>>(x: R) -> R {
    let (outer, angle) = short_inner(x.abs());
    let [quarters, factor] = of_sine::<R>(outer);
    factor.fma(angle, quarters * R::of(FRAC_PI_2)).bits_xor(sign(x))
}

/// The arc cosine, with an error of at most 4 ulp.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn fast_acos<R: Bits<Scalar: ArcSine>>(x: R) -> R {
    let (outer, angle) = short_inner(x.abs());
    let [quarters, factor] = of_cosine(x, outer);
    factor.fma(angle, quarters * R::of(FRAC_PI_2))
}

/// The errors of the polynomials: 2^-55.9 and 2^-51.9.
impl ArcSine for f64 {
    const HALF_RECIPROCAL_ROOT: u64 = 0x5fd6_eb85_1eb8_51eb;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn series<R: Bits<Scalar = f64>>(z: R) -> R {
        let square = z * z;
        let low = cubic(
            z,
            square,
            [0.166_666_666_666_654_08, 0.075_000_000_003_371_51, 0.044_642_856_828_206_96, 0.030_381_959_142_235_81],
        );
        let middle = cubic(
            z,
            square,
            [0.022_371_757_919_274_385, 0.017_359_706_798_282_08, 0.013_885_214_910_178_937, 0.012_169_349_145_107_615],
        );
        let high = cubic(
            z,
            square,
            [0.006_527_370_699_893_542, 0.019_529_945_124_960_466, -0.016_226_927_412_931_49, 0.031_914_128_901_151_25],
        );
        let fourth = square * square;
        fourth.fma(fourth.fma(high, middle), low)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn short_series<R: Bits<Scalar = f64>>(z: R) -> R {
        let square = z * z;
        let fourth = square * square;
        let low = cubic(
            z,
            square,
            [0.166_666_666_666_834_83, 0.074_999_999_961_697, 0.044_642_860_171_094_284, 0.030_381_825_341_309_097],
        );
        let middle = cubic(
            z,
            square,
            [0.022_374_870_907_222_486, 0.017_314_147_712_606_62, 0.014_322_158_358_251_687, 0.009_381_757_505_445_329],
        );
        let high = square
            .fma(R::of(0.031_519_536_949_629_695), linear(z, [0.018_251_755_266_547_973, -0.011_701_102_053_666_698]));
        fourth.fma(fourth.fma(high, middle), low)
    }
}

/// The errors of the polynomials: 2^-27.6 and 2^-23.4.
impl ArcSine for f32 {
    const HALF_RECIPROCAL_ROOT: u64 = 0x5eb7_5c28;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn series<R: Bits<Scalar = f32>>(z: R) -> R {
        let first = linear(z, [0.166_667_520_999_908_45, 0.074_953_094_124_794]);
        let second = linear(z, [0.045_469_153_672_456_74, 0.024_184_737_354_516_983]);
        let square = z * z;
        square.fma(square.fma(R::of(0.042_158_413_678_407_67), second), first)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn short_series<R: Bits<Scalar = f32>>(z: R) -> R {
        cubic(
            z,
            z * z,
            [0.166_655_808_687_210_08, 0.075_405_150_651_931_76, 0.040_035_918_354_988_1, 0.049_951_419_234_275_82],
        )
    }
}
