//! Two doubles in a register of 128 bits, with AVX2 as with AVX-512.

use crate::scalar::{
    fma::{Fused, Instructions},
    simd::pair::Pair,
};
use core::{
    arch::x86_64::{
        __m128d, _mm_add_pd, _mm_cvtsd_f64, _mm_fmadd_pd, _mm_mul_pd, _mm_set_pd, _mm_shuffle_pd, _mm_unpackhi_pd,
    },
    ops::{Add, Mul},
};

/// Two doubles.
#[derive(Clone, Copy, Debug)]
pub struct X2(__m128d);

impl Add for X2 {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self(instruction!(_mm_add_pd(self.0, other.0)))
    }
}

impl Mul for X2 {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self(instruction!(_mm_mul_pd(self.0, other.0)))
    }
}

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
    fn swap(self) -> Self {
        Self(instruction!(_mm_shuffle_pd::<0b01>(self.0, self.0)))
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
        simd::{
            lanes::Lanes,
            pair::{Pair, pair, twice},
        },
    };

    /// Operations on pairs have the bits of those on two numbers.
    fn both_lanes_are_the_scalar<R: Real>() {
        let [a, b, c] = [[1.25, -3.0], [0.1, 1e-310], [f64::EPSILON, -0.7]].map(|numbers| numbers.map(R::of));
        let [x, y, z] = [a, b, c].map(|[first, second]| pair(first, second));
        let [one, other, third] = [a, b, c].map(<Lanes<R, 2> as Pair<R>>::of);
        let bits = |numbers: [R; 2]| numbers.map(|number| number.lane(0).to_bits());
        assert_eq!(bits(x.parts()), bits(a));
        assert_eq!(bits(x.swap().parts()), bits(one.swap().parts()), "the other order");
        assert_eq!(bits((x + y).parts()), bits((one + other).parts()), "sums");
        assert_eq!(bits((x * y).parts()), bits((one * other).parts()), "products");
        assert_eq!(bits(x.fma(y, z).parts()), bits(Pair::fma(one, other, third).parts()), "sums of products");
        assert_eq!(bits(twice(a[1]).parts()), bits([a[1]; 2]));
        assert_eq!(x.total().lane(0), 1.25 - 3.0);
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
