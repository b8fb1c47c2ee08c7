//! Arc sine and arc cosine.
//!
//! Up to one half, `asin s = s·(1 + z·S(z))` with `z = s²`; beyond, `acos x = 2·asin √((1 - x)/2)` brings the argument
//! there. What the root lost is added with the other small terms.
//!
//! `S` is minimax as in [`arc`](super::arc).

use super::{
    Bits,
    arc::{Arc, sign, turned},
    cubic,
    exact::{less_product, pattern_less},
    linear,
};

/// What the arc sine is made of in one format.
pub(crate) trait ArcSine: Arc {
    /// From this pattern half of that of a number is subtracted for `1/(2·√x)`, off by 4 % at most.
    const HALF_RECIPROCAL_ROOT: u64;

    /// `S` at `z`.
    fn series<R: Bits<Scalar = Self>>(z: R) -> R;
}

/// Whether the argument is beyond one half, and the arc sine of what brings it there, in two parts.
#[inline(always)]
fn inner<R: Bits<Scalar: ArcSine>>(size: R) -> (R::Mask, [R; 2]) {
    let half = R::of(0.5);
    let outer = half.less(size);
    let z = R::select(outer, half * (R::of(1.0) - size), size * size);
    let root = z.sqrt();
    let lost = less_product(z, root, root) * pattern_less(R::Scalar::HALF_RECIPROCAL_ROOT, z.bits_right(1));
    let (s, lost) = (R::select(outer, root, size), R::select(outer, lost, R::of(0.0)));
    (outer, [s, (s * z).fma(<R::Scalar as ArcSine>::series(z), lost)])
}

/// At most 1 ulp.
#[inline(always)]
pub(crate) fn asin<R: Bits<Scalar: ArcSine>>(x: R) -> R {
    let (outer, [s, rest]) = inner(x.abs());
    let factor = R::select(outer, R::of(-2.0), R::of(1.0));
    let quarters = R::select(outer, R::of(1.0), R::of(0.0));
    turned(quarters, [factor * s, factor * rest]).bits_xor(sign(x))
}

/// At most 1 ulp.
#[inline(always)]
pub(crate) fn acos<R: Bits<Scalar: ArcSine>>(x: R) -> R {
    let (outer, [s, rest]) = inner(x.abs());
    let factor = R::select(outer, R::of(2.0), R::of(-1.0)).bits_xor(sign(x));
    let turns = R::select(x.less(R::of(0.0)), R::of(2.0), R::of(0.0));
    turned(R::select(outer, turns, R::of(1.0)), [factor * s, factor * rest])
}

/// The error of the polynomial: 2^-55.9.
impl ArcSine for f64 {
    const HALF_RECIPROCAL_ROOT: u64 = 0x5fd6_eb85_1eb8_51eb;

    #[inline(always)]
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
}

/// The error of the polynomial: 2^-27.6.
impl ArcSine for f32 {
    const HALF_RECIPROCAL_ROOT: u64 = 0x5eb7_5c28;

    #[inline(always)]
    fn series<R: Bits<Scalar = f32>>(z: R) -> R {
        let first = linear(z, [0.166_667_520_999_908_45, 0.074_953_094_124_794]);
        let second = linear(z, [0.045_469_153_672_456_74, 0.024_184_737_354_516_983]);
        let square = z * z;
        square.fma(square.fma(R::of(0.042_158_413_678_407_67), second), first)
    }
}
