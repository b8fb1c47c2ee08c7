//! `n / x^(3/2)` from the estimate of a root that AVX-512 has: no square root and no division, several times as fast.

use super::X8;
use crate::{
    fused::{Avx512, Fused},
    real::{Mask, Real},
};
use core::arch::x86_64::{_mm_cvtsd_f64, _mm_rsqrt14_sd, _mm_set_sd, _mm512_rsqrt14_pd};

/// Numbers with an estimate of `1 / sqrt(x)`, off by less than one part in 2¹⁴. Vector and scalar have the same one.
pub(crate) trait Estimate: Real {
    fn reciprocal_root(self) -> Self;
}

impl Estimate for X8 {
    #[inline(always)]
    fn reciprocal_root(self) -> Self {
        Self(instruction!(_mm512_rsqrt14_pd(self.0)))
    }
}

impl Estimate for Fused<f64, Avx512> {
    #[inline(always)]
    fn reciprocal_root(self) -> Self {
        let x = instruction!(_mm_set_sd(self.0));
        Self::new(instruction!(_mm_cvtsd_f64(_mm_rsqrt14_sd(x, x))))
    }
}

/// Where neither the cube of the estimate nor its square leaves the normal numbers.
const MODERATE: [f64; 2] = [1e-200, 1e200];

/// With the estimate `y` of `1/√x` and `e = 1 - x y²`, `|e| < 2⁻¹³`, the value is `n y³ (1 - e)^(-3/2)`, of which the
/// series `1 + 3/2 e + 15/8 e² + 35/16 e³ + 315/128 e⁴` is all that a double sees: the next term is below 2⁻⁶³. Roundings
/// of `y²`, `y³`, their product with `n`, `e` and the last sum leave less than two ulp of a finite value.
#[inline(always)]
pub(crate) fn over_root_cubed<R: Estimate>(n: R, x: R) -> R {
    let y = x.reciprocal_root();
    let square = y * y;
    let e = (-x).fma(square, R::of(1.0));
    let value = n * (square * y);
    let (low, high) = (e.fma(R::of(15.0 / 8.0), R::of(3.0 / 2.0)), e.fma(R::of(315.0 / 128.0), R::of(35.0 / 16.0)));
    let value = (value * e).fma((e * e).fma(high, low), value);
    let moderate = R::of(MODERATE[0]).less(x).and(x.less(R::of(MODERATE[1])));
    if moderate.not().any() { R::select(moderate, value, n / (x * x.sqrt())) } else { value }
}
