//! Sine and cosine within 4 ulp: half of the operations of the precise ones.
//!
//! The argument becomes `n·π + r` with `|r| <= π/2`, rounded, so that one polynomial is enough:
//! `sin r = r·(1 + z·S(z))` with `z = r²`. For the cosine `n` is a whole number and a half.
//!
//! `S` is minimax as in [`sine`](super::sine); its error makes up most of that of the result.

use super::{
    Bits,
    sine::{TrigReduction, reduced_or_fallback},
};
use core::f64::consts::FRAC_1_PI;

/// The polynomial of one format.
pub(crate) trait HalfCircle: TrigReduction {
    /// `S` at `z`.
    fn series<R: Bits<Scalar = Self>>(z: R) -> R;
}

/// `x - n·π/2`, or `x - n·π` for two quarters, and what the polynomial need not wait for.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn difference<R: Bits<Scalar: TrigReduction>>(x: R, n: R, quarters: f64) -> [R; 2] {
    if R::FUSED {
        let [first, second, third] = R::Scalar::QUARTER.map(|part| R::of(-quarters * part));
        let r = n.fma(second, n.fma(first, x));
        // The third part shows only in a tiny rest, which is all of the result then.
        [n.fma(third, r), r]
    } else {
        let [first, second, third, fourth] = R::Scalar::SPLIT_QUARTER.map(|part| n * R::of(quarters * part));
        let r = (((x - first) - second) - third) - fourth;
        [r, r]
    }
}

/// The sine of `x - n·π`.
#[cfg_attr(not(debug_assertions), inline(always))]
fn rest<R: Bits<Scalar: HalfCircle>>(x: R, n: R) -> R {
    let [r, near] = difference(x, n, 2.0);
    let z = near * near;
    r * z.fma(R::Scalar::series(z), R::of(1.0))
}

/// The sine, with an error of at most 4 ulp.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn fast_sin<R: Bits<Scalar: HalfCircle>>(x: R) -> R {
    let magic = R::of(R::Scalar::MAGIC);
    let half_turns = x.fma(R::of(FRAC_1_PI), magic);
    let value = rest(x, half_turns - magic);
    reduced_or_fallback(value.bits_xor(half_turns.bits_left(R::Scalar::SIGN)), x, 0)
}

/// The cosine, with an error of at most 4 ulp.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn fast_cos<R: Bits<Scalar: HalfCircle>>(x: R) -> R {
    let magic = R::of(R::Scalar::MAGIC);
    let half_turns = x.fma(R::of(FRAC_1_PI), R::of(-0.5)) + magic;
    let value = -rest(x, (half_turns - magic) + R::of(0.5));
    reduced_or_fallback(value.bits_xor(half_turns.bits_left(R::Scalar::SIGN)), x, 1)
}

/// The error of the series is 2^-52.3.
impl HalfCircle for f64 {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn series<R: Bits<Scalar = f64>>(z: R) -> R {
        let c = |coefficient| R::of(coefficient);
        let first = z.fma(c(8.333_333_333_285_543e-3), c(-1.666_666_666_666_618_6e-1));
        let second = z.fma(c(2.755_731_660_059_094_7e-6), c(-1.984_126_982_505_661_1e-4));
        let third = z.fma(c(1.604_809_547_050_190_6e-10), c(-2.505_188_027_608_390_4e-8));
        let zz = z * z;
        (zz * zz).fma(zz.fma(c(-7.373_345_299_943_309e-13), third), zz.fma(second, first))
    }
}

/// The error of the series is 2^-27.2.
impl HalfCircle for f32 {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn series<R: Bits<Scalar = f32>>(z: R) -> R {
        let c = |coefficient| R::of(coefficient);
        let first = z.fma(c(8.333_068_341_016_77e-3), c(-1.666_665_971_279_144_3e-1));
        let second = z.fma(c(2.605_776_671_771_309_3e-6), c(-1.980_966_480_914_503_3e-4));
        (z * z).fma(second, first)
    }
}
