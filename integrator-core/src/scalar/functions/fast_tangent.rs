//! The tangent within 4 ulp: half of the operations of the precise one.
//!
//! The argument becomes `n·π/2 + r` with `|r| <= π/4`, rounded. Of the continued fraction of Lambert, `tan r = r / (1 -
//! z / (3 - z / (5 - ...)))` with `z = r²`, a few terms make a quotient of polynomials, `r·P(z) / Q(z)`; in odd
//! quarters the tangent is its reciprocal, negative, for which the same division is enough.

use super::{
    Bits, cubic,
    fast_sine::difference,
    linear,
    sine::{TrigReduction, reduced_or_fallback},
};
use core::f64::consts::FRAC_2_PI;

/// The polynomials of one format.
pub(crate) trait Fraction: TrigReduction {
    /// `P` and `Q` at `z`.
    fn fraction<R: Bits<Scalar = Self>>(z: R) -> [R; 2];
}

/// The tangent, with an error of at most 4 ulp.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn fast_tan<R: Bits<Scalar: Fraction>>(x: R) -> R {
    let magic = R::of(R::Scalar::MAGIC);
    let quarters = x.fma(R::of(FRAC_2_PI), magic);
    let [r, _] = difference(x, quarters - magic, 1.0);
    let [above, below] = R::Scalar::fraction(r * r);
    let above = r * above;
    let odd = quarters.is_odd();
    let value = R::select(odd, -below, above) / R::select(odd, above, below);
    reduced_or_fallback(value, x, 2)
}

/// Nine terms of the fraction, whose error is 2^-60.
impl Fraction for f64 {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn fraction<R: Bits<Scalar = f64>>(z: R) -> [R; 2] {
        let (square, one) = (z * z, R::of(1.0));
        let above = cubic(
            z,
            square,
            [
                -0.137_254_901_960_784_33,
                0.003_921_568_627_450_98,
                -2.872_944_049_414_637_6e-5,
                2.901_963_686_277_412e-8,
            ],
        );
        let below = cubic(
            z,
            square,
            [
                -0.470_588_235_294_117_64,
                0.027_450_980_392_156_862,
                -0.000_402_212_166_918_049_25,
                1.305_883_658_824_835_3e-6,
            ],
        );
        [z.fma(above, one), z.fma(below, one)]
    }
}

/// Five terms of the fraction, whose error is 2^-26.
impl Fraction for f32 {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn fraction<R: Bits<Scalar = f32>>(z: R) -> [R; 2] {
        let (above, below) = (linear(z, [-1.0 / 9.0, 1.0 / 945.0]), linear(z, [-4.0 / 9.0, 1.0 / 63.0]));
        [z.fma(above, R::of(1.0)), z.fma(below, R::of(1.0))]
    }
}
