//! Pairs of doubles in a register of 128 bits, with AVX2 as with AVX-512.

use crate::scalar::{
    fma::{Fused, Instructions},
    simd::pair::Pair,
};
use core::arch::x86_64::{__m128d, _mm_cvtsd_f64, _mm_fmadd_pd, _mm_mul_pd, _mm_set_pd, _mm_unpackhi_pd};

/// Two doubles.
#[derive(Clone, Copy, Debug)]
pub struct X2(__m128d);

impl<S: Instructions> Pair<Fused<f64, S>> for X2 {
    #[inline(always)]
    fn of([first, second]: [Fused<f64, S>; 2]) -> Self {
        Self(instruction!(_mm_set_pd(second.0, first.0)))
    }
    #[inline(always)]
    fn parts(self) -> [Fused<f64, S>; 2] {
        let Self(both) = self;
        [both, instruction!(_mm_unpackhi_pd(both, both))].map(|both| Fused::new(instruction!(_mm_cvtsd_f64(both))))
    }
    #[inline(always)]
    fn mul(self, b: Self) -> Self {
        Self(instruction!(_mm_mul_pd(self.0, b.0)))
    }
    #[inline(always)]
    fn fma(self, b: Self, c: Self) -> Self {
        Self(instruction!(_mm_fmadd_pd(self.0, b.0, c.0)))
    }
}

#[cfg(test)]
mod tests {
    use crate::scalar::{
        fma::{Avx512, Fma, Fused},
        instruction_set::InstructionSet,
        real::Real,
        simd::pair::{Pair, pair},
    };

    /// Operations on pairs have the bits of those on two numbers.
    fn both_lanes_are_the_scalar<R: Real>() {
        let [a, b, c] = [[1.25, -3.0], [0.1, 1e-310], [f64::EPSILON, -0.7]].map(|numbers| numbers.map(R::of));
        let [x, y, z] = [a, b, c].map(|[first, second]| pair(first, second));
        let bits = |numbers: [R; 2]| numbers.map(|number| number.lane(0).to_bits());
        assert_eq!(bits(x.parts()), bits(a));
        assert_eq!(bits(x.mul(y).parts()), bits(a.mul(b)), "products");
        assert_eq!(bits(x.fma(y, z).parts()), bits(a.fma(b, c)), "sums of products");
        assert_eq!(bits([x.total(), y.total()]), bits([a.total(), b.total()]), "totals");
    }

    #[test]
    fn both_lanes_are_the_fused_scalar() {
        if InstructionSet::available().contains(&InstructionSet::Fused) {
            both_lanes_are_the_scalar::<Fused<f64, Fma>>();
        }
        if InstructionSet::available().contains(&InstructionSet::Avx512) {
            both_lanes_are_the_scalar::<Fused<f64, Avx512>>();
        }
    }
}
