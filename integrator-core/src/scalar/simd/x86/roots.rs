//! `n / x^(1/2)` and `n / x^(3/2)` from the estimate of a root that AVX-512 has: no square root and no division, several times as
//! fast.

use super::{S16, V8, X8};
use crate::scalar::{
    fma::{Avx512, Fused},
    real::Real,
};
use core::arch::x86_64::{
    _mm_cvtsd_f64, _mm_cvtss_f32, _mm_min_sd, _mm_min_ss, _mm_rsqrt14_sd, _mm_rsqrt14_ss, _mm_set_sd, _mm_set_ss,
    _mm256_min_ps, _mm256_rsqrt14_ps, _mm256_set1_ps, _mm512_min_pd, _mm512_min_ps, _mm512_rsqrt14_pd,
    _mm512_rsqrt14_ps, _mm512_set1_pd, _mm512_set1_ps,
};

/// Numbers with an estimate of `1 / sqrt(x)`, off by less than one part in 2¹⁴. Vector and scalar have the same one.
pub trait Estimate: Real {
    /// Whether the numbers have 24 bits, so that the first term of a series is enough.
    const IS_SINGLE: bool;
    /// The estimate.
    fn reciprocal_root(self) -> Self;
    /// The number, or the largest one in place of infinity. NaN stays NaN.
    fn at_most_max(self) -> Self;
}

macro_rules! estimate {
    ($number:ident, $is_single:literal, alone $set:ident $root:ident $min:ident $get:ident; $($vector:ident: $splat:ident $root_of_vector:ident $min_of_vector:ident),*) => {
        impl Estimate for $number {
            const IS_SINGLE: bool = $is_single;

            #[inline(always)]
            fn reciprocal_root(self) -> Self {
                let x = instruction!($set(self));
                instruction!($get($root(x, x)))
            }
            #[inline(always)]
            fn at_most_max(self) -> Self {
                instruction!($get($min($set($number::MAX), $set(self))))
            }
        }
        $(impl Estimate for $vector {
            const IS_SINGLE: bool = $is_single;

            #[inline(always)]
            fn reciprocal_root(self) -> Self {
                Self(instruction!($root_of_vector(self.0)))
            }
            #[inline(always)]
            fn at_most_max(self) -> Self {
                // The instruction returns its second operand if one is NaN.
                Self(instruction!($min_of_vector($splat($number::MAX), self.0)))
            }
        })*
    };
}
estimate!(f64, false, alone _mm_set_sd _mm_rsqrt14_sd _mm_min_sd _mm_cvtsd_f64; X8: _mm512_set1_pd _mm512_rsqrt14_pd _mm512_min_pd);
estimate!(
    f32, true, alone _mm_set_ss _mm_rsqrt14_ss _mm_min_ss _mm_cvtss_f32;
    V8: _mm256_set1_ps _mm256_rsqrt14_ps _mm256_min_ps, S16: _mm512_set1_ps _mm512_rsqrt14_ps _mm512_min_ps
);

impl<F: Estimate> Estimate for Fused<F, Avx512>
where
    Self: Real,
{
    const IS_SINGLE: bool = F::IS_SINGLE;

    #[inline(always)]
    fn reciprocal_root(self) -> Self {
        Self::new(self.0.reciprocal_root())
    }
    #[inline(always)]
    fn at_most_max(self) -> Self {
        Self::new(self.0.at_most_max())
    }
}

/// With `a = 2⁻¹³`, the largest difference between `e⁴` and `c e²` for `|e| < a` is least, `(3 - 2√2) a⁴`, for
/// `c = 2 (√2 - 1) a²`: it makes up for a term of fourth order that is left out.
const FOURTH: f64 = 2.0 * (std::f64::consts::SQRT_2 - 1.0) / 67_108_864.0;

/// A series in `e` over `e`, without its first term, from the coefficients of four powers. In 24 bits, the second power and higher
/// ones are less than half a unit of the last place.
#[inline(always)]
fn series<R: Estimate>(e: R, [first, second, third, fourth]: [f64; 4]) -> R {
    if R::IS_SINGLE {
        return R::of(first);
    }
    (e * e).fma(R::of(third), e.fma(R::of(second + fourth * FOURTH), R::of(first)))
}

/// With the estimate `y` of `1/√x` and `e = 1 - x y²`, `|e| < 2⁻¹³`, the root is `y (1 - e)^(-1/2)`, whose series is
/// `1 + 1/2 e + 3/8 e² + 5/16 e³ + 35/128 e⁴ + …`. Roundings of `x y`, which `e` carries, of the last sum and of the product with
/// `n`, and what the series lacks leave less than two ulp.
///
/// Wherever the quotient is zero, infinite or NaN, so is this.
#[inline(always)]
pub(crate) fn div_sqrt<R: Estimate>(n: R, x: R) -> R {
    let y = x.reciprocal_root();
    // Not `x y²`: the square of the root of the least numbers overflows.
    let e = (-(x.at_most_max() * y)).fma(y, R::of(1.0));
    let series = series(e, [1.0 / 2.0, 3.0 / 8.0, 5.0 / 16.0, 35.0 / 128.0]);
    n * R::select(x.equal(R::of(0.0)), y, (y * e).fma(series, y))
}

/// The value is `n y³ (1 - e)^(-3/2)`, whose series is `1 + 3/2 e + 15/8 e² + 35/16 e³ + 315/128 e⁴ + …`. Roundings of `y²`, `y³`,
/// their product with `n`, `e` and the last sum, and what the series lacks leave less than two ulp of a value that neither overflows
/// nor loses bits to underflow.
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
    let series = series(e, [3.0 / 2.0, 15.0 / 8.0, 35.0 / 16.0, 315.0 / 128.0]);
    (value * e).fma(series, value)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::{instruction_set::InstructionSet, real::Kernel};
    use core::marker::PhantomData;
    use dashu_float::{FBig, round::mode::HalfEven};

    /// A quotient, and the power of `x` that divides.
    trait Quotient {
        const POWER: &str;
        fn of<R: Real>(n: R, x: R) -> R;
        fn exact(n: Big, x: Big) -> Big;
    }

    struct ByRoot;
    impl Quotient for ByRoot {
        const POWER: &str = "(1/2)";
        #[inline(always)]
        fn of<R: Real>(n: R, x: R) -> R {
            n.div_sqrt(x)
        }
        fn exact(n: Big, x: Big) -> Big {
            n / x.sqrt()
        }
    }

    struct ByRootCubed;
    impl Quotient for ByRootCubed {
        const POWER: &str = "(3/2)";
        #[inline(always)]
        fn of<R: Real>(n: R, x: R) -> R {
            n.div_pow_3_2(x)
        }
        fn exact(n: Big, x: Big) -> Big {
            n / (&x * x.sqrt())
        }
    }

    type Big = FBig<HalfEven, 2>;

    /// Arguments without a root, or with one whose cube or its reciprocal is no normal number.
    const SPECIAL: [f64; 11] =
        [0.0, -0.0, 5e-324, 1e-310, 1e-300, 1e300, f64::MAX, f64::INFINITY, f64::NAN, -1.0, f64::NEG_INFINITY];

    /// Some thousand pairs of `n` and `x`, whose logarithms are spread (steps that no period fits) up to `widest`.
    fn pairs(widest: f64) -> Vec<[f64; 2]> {
        let fraction = |i: u32, step: f64| (f64::from(i) * step).fract();
        let pair = |i| {
            let size = (2.0 * fraction(i, 0.754_877_666) - 1.0).exp2();
            let x = (widest * (2.0 * fraction(i, 0.569_840_291) - 1.0)).exp2();
            [if i % 2 == 0 { size } else { -size }, x]
        };
        (0..8_000).map(pair).collect()
    }

    /// The values at these pairs, in the variant of `R`.
    fn values<Q: Quotient, R: Real>(pairs: &[[f64; 2]]) -> Vec<f64> {
        struct Values<'a, Q, R>(&'a [[f64; 2]], PhantomData<(Q, R)>);
        impl<Q: Quotient, R: Real> Kernel for Values<'_, Q, R> {
            type Out = Vec<f64>;
            #[inline(always)]
            fn call(self) -> Vec<f64> {
                let mut values = Vec::with_capacity(self.0.len());
                for pairs in self.0.chunks(R::LANES) {
                    let pair = |lane: usize| pairs[lane.min(pairs.len() - 1)];
                    let value = Q::of(R::state(&|lane| pair(lane)[0]), R::state(&|lane| pair(lane)[1]));
                    values.extend((0..pairs.len()).map(|lane| value.lane(lane)));
                }
                values
            }
        }
        R::enter(Values(pairs, PhantomData::<(Q, R)>))
    }

    /// The values at these pairs, which scalars and vectors share.
    fn values_of_both<Q: Quotient, A: Real, V: Real>(pairs: &[[f64; 2]]) -> Vec<f64> {
        let (alone, together) = (values::<Q, A>(pairs), values::<Q, V>(pairs));
        for ([n, x], (alone, together)) in pairs.iter().zip(alone.iter().zip(together)) {
            let same = alone.to_bits() == together.to_bits() || alone.is_nan() && together.is_nan();
            assert!(same, "{n} over {x}^{}: {alone} alone, {together} in lanes", Q::POWER);
        }
        alone
    }

    /// Tests that values are within two units of the last place of a number next to a power of two, where they are narrow.
    fn are_within_two_units<Q: Quotient, A: Real, V: Real>(widest: f64, epsilon: f64) {
        let pairs: Vec<_> = pairs(widest).into_iter().map(|pair| pair.map(|number| A::of(number).lane(0))).collect();
        let big = |x: f64| Big::try_from(x).expect("a finite number").with_precision(140).value();
        for ([n, x], value) in pairs.iter().zip(values_of_both::<Q, A, V>(&pairs)) {
            let exact = Q::exact(big(*n), big(*x));
            let error = ((big(value) - &exact) / exact).to_f64().value().abs() / epsilon;
            assert!(error <= 2.0, "{n} over {x}^{}: {value}", Q::POWER);
        }
    }

    /// The same for a scalar and the vectors that share its bits.
    fn both_are_within_two_units<A: Real, V: Real>(widest: f64, epsilon: f64) {
        are_within_two_units::<ByRoot, A, V>(widest, epsilon);
        are_within_two_units::<ByRootCubed, A, V>(widest, epsilon);
    }

    #[test]
    fn values_are_within_two_units() {
        if InstructionSet::available().contains(&InstructionSet::Avx512) {
            both_are_within_two_units::<Fused<f64, Avx512>, X8>(680.0, f64::EPSILON);
            both_are_within_two_units::<Fused<f32, Avx512>, V8>(80.0, f32::EPSILON.into());
            both_are_within_two_units::<Fused<f32, Avx512>, S16>(80.0, f32::EPSILON.into());
        }
    }

    #[test]
    fn values_without_a_number_are_those_of_quotients() {
        if !InstructionSet::available().contains(&InstructionSet::Avx512) {
            return;
        }
        let pairs = SPECIAL.map(|x| [1.5, -3.0, 0.0, f64::INFINITY].map(|n| [n, x]));
        let pairs = pairs.as_flattened();
        for ([n, x], value) in pairs.iter().zip(values_of_both::<ByRoot, Fused<f64, Avx512>, X8>(pairs)) {
            let quotient = n / x.sqrt();
            let same = value.to_bits() == quotient.to_bits() || value.is_nan() && quotient.is_nan();
            let near = (value / quotient - 1.0).abs() <= 3.0 * f64::EPSILON;
            assert!(same || near, "{n} over the root of {x}: {value}, and {quotient} by a division");
        }
        let finite: Vec<_> = pairs.iter().copied().filter(|[n, _]| n.is_finite() && *n != 0.0).collect();
        for ([n, x], value) in finite.iter().zip(values_of_both::<ByRootCubed, Fused<f64, Avx512>, X8>(&finite)) {
            let quotient = n / (x * x.sqrt());
            let agrees = if quotient.is_finite() { value.abs() == 0.0 } else { !value.is_finite() };
            assert!(agrees, "{n} over {x}^(3/2): {value}, and {quotient} by a division");
        }
    }
}
