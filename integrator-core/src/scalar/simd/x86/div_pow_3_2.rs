//! `n / x^(3/2)` from the estimate of a root that AVX-512 has: no square root and no division, several times as fast.

use super::X8;
use crate::scalar::{
    fma::{Avx512, Fused},
    real::Real,
};
use core::arch::x86_64::{
    _mm_cvtsd_f64, _mm_min_sd, _mm_rsqrt14_sd, _mm_set_sd, _mm512_min_pd, _mm512_rsqrt14_pd, _mm512_set1_pd,
};

/// Numbers with an estimate of `1 / sqrt(x)`, off by less than one part in 2¹⁴. Vector and scalar have the same one.
pub(crate) trait Estimate: Real {
    fn reciprocal_root(self) -> Self;
    /// The number, or the largest one in place of infinity. NaN stays NaN.
    fn at_most_max(self) -> Self;
}

impl Estimate for X8 {
    #[inline(always)]
    fn reciprocal_root(self) -> Self {
        Self(instruction!(_mm512_rsqrt14_pd(self.0)))
    }

    #[inline(always)]
    fn at_most_max(self) -> Self {
        // The instruction returns its second operand if one is NaN.
        Self(instruction!(_mm512_min_pd(_mm512_set1_pd(f64::MAX), self.0)))
    }
}

impl Estimate for Fused<f64, Avx512> {
    #[inline(always)]
    fn reciprocal_root(self) -> Self {
        let x = instruction!(_mm_set_sd(self.0));
        Self::new(instruction!(_mm_cvtsd_f64(_mm_rsqrt14_sd(x, x))))
    }

    #[inline(always)]
    fn at_most_max(self) -> Self {
        Self::new(instruction!(_mm_cvtsd_f64(_mm_min_sd(_mm_set_sd(f64::MAX), _mm_set_sd(self.0)))))
    }
}

/// 15/8, and what makes up for the term of fourth order that is left out: with `a = 2⁻¹³` the largest difference
/// between `315/128 e⁴` and `c e²` for `|e| < a` is least, `0.42 a⁴`, for `c = (√2 - 1) 315/64 a²`.
const SECOND: f64 = 15.0 / 8.0 + (std::f64::consts::SQRT_2 - 1.0) * 315.0 / 64.0 / 67_108_864.0;

/// With the estimate `y` of `1/√x` and `e = 1 - x y²`, `|e| < 2⁻¹³`, the value is `n y³ (1 - e)^(-3/2)`, whose series
/// is `1 + 3/2 e + 15/8 e² + 35/16 e³ + …`. Roundings of `y²`, `y³`, their product with `n`, `e` and the last sum, and
/// what the series lacks leave less than two ulp of a value that neither overflows nor loses bits to underflow.
///
/// Zero where `x` is infinite, as the quotient is. NaN where `x` is not positive: a branch for these is not worth its time in
/// every step, since a kick by an infinite force ends in NaN as well.
#[inline(always)]
pub(crate) fn div_pow_3_2<R: Estimate>(n: R, x: R) -> R {
    let y = x.reciprocal_root();
    let square = y * y;
    let e = (-x.at_most_max()).fma(square, R::of(1.0));
    // In this order the product is as large or small on the way as it is in the end.
    let value = (n * y) * square;
    let series = (e * e).fma(R::of(35.0 / 16.0), e.fma(R::of(SECOND), R::of(3.0 / 2.0)));
    (value * e).fma(series, value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::{instruction_set::InstructionSet, real::Kernel};
    use core::marker::PhantomData;
    use dashu_float::{FBig, round::mode::HalfEven};

    /// Arguments without a value, or with one that overflows.
    const WITHOUT: [f64; 7] = [0.0, -0.0, 5e-324, 1e-310, 1e-300, f64::NAN, -1.0];

    /// Arguments so large that the value is zero.
    const HUGE: [f64; 3] = [1e300, f64::MAX, f64::INFINITY];

    /// Some thousand pairs of `n` and `x`, whose logarithms are spread (steps that no period fits), and special ones.
    fn pairs() -> Vec<[f64; 2]> {
        let fraction = |i: u32, step: f64| (f64::from(i) * step).fract();
        let moderate = |i| {
            let size = (2.0 * fraction(i, 0.754_877_666) - 1.0).exp2();
            [if i % 2 == 0 { size } else { -size }, (1360.0 * fraction(i, 0.569_840_291) - 680.0).exp2()]
        };
        let special = WITHOUT.into_iter().chain(HUGE).flat_map(|x| [1.5, -3.0].map(|n| [n, x]));
        (0..8_000).map(moderate).chain(special).collect()
    }

    /// The values at these pairs, in the variant of `R`.
    fn values<R: Real>(pairs: &[[f64; 2]]) -> Vec<f64> {
        struct Values<'a, R>(&'a [[f64; 2]], PhantomData<R>);
        impl<R: Real> Kernel for Values<'_, R> {
            type Out = Vec<f64>;
            #[inline(always)]
            fn call(self) -> Vec<f64> {
                let mut values = Vec::with_capacity(self.0.len());
                for pairs in self.0.chunks(R::LANES) {
                    let pair = |lane: usize| pairs[lane.min(pairs.len() - 1)];
                    let value = R::state(&|lane| pair(lane)[0]).div_pow_3_2(R::state(&|lane| pair(lane)[1]));
                    values.extend((0..pairs.len()).map(|lane| value.lane(lane)));
                }
                values
            }
        }
        R::enter(Values(pairs, PhantomData::<R>))
    }

    /// The error in units of the last place of a number next to a power of two, where they are narrow.
    fn error([n, x]: [f64; 2], value: f64) -> f64 {
        let big = |x: f64| FBig::<HalfEven, 2>::try_from(x).expect("a finite number").with_precision(140).value();
        let exact = big(n) / (big(x) * big(x).sqrt());
        ((big(value) - &exact) / exact).to_f64().value().abs() / f64::EPSILON
    }

    #[test]
    fn values_are_within_two_units_and_finite_where_there_are_any() {
        if !InstructionSet::available().contains(&InstructionSet::Avx512) {
            return;
        }
        let pairs = pairs();
        let (alone, together) = (values::<Fused<f64, Avx512>>(&pairs), values::<X8>(&pairs));
        for ((&[n, x], alone), together) in pairs.iter().zip(alone).zip(together) {
            let same = alone.to_bits() == together.to_bits() || alone.is_nan() && together.is_nan();
            assert!(same, "{n} over {x}^(3/2): {alone} alone, {together} in lanes");
            if HUGE.contains(&x) {
                assert_eq!(alone.abs(), 0.0, "{n} over {x}^(3/2)");
            } else if WITHOUT.contains(&x) || x.is_nan() {
                assert!(!alone.is_finite(), "{n} over {x}^(3/2): {alone}");
            } else {
                assert!(error([n, x], alone) <= 2.0, "{n} over {x}^(3/2): {alone}");
            }
        }
    }
}
