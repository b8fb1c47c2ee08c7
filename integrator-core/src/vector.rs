//! Four members of an ensemble in one register of AVX2 and FMA.
//!
//! Always true: every lane has the bits of [`Fused<f64>`](crate::fused::Fused): the operations are the same IEEE ones,
//! and elementary functions are called lane by lane. Only code that runs where `InstructionSet::Fused` was chosen names
//! the type; that is what makes its instructions sound.

use crate::{
    instruction_set::enter_fused,
    real::{Kernel, Mask, Real, elementary_functions},
};
use std::{
    arch::x86_64::{
        __m256d, _CMP_EQ_OQ, _CMP_LE_OQ, _CMP_LT_OQ, _mm256_add_pd, _mm256_and_pd, _mm256_andnot_pd, _mm256_blendv_pd,
        _mm256_cmp_pd, _mm256_div_pd, _mm256_fmadd_pd, _mm256_movemask_pd, _mm256_mul_pd, _mm256_or_pd, _mm256_set1_pd,
        _mm256_setr_pd, _mm256_sqrt_pd, _mm256_sub_pd, _mm256_xor_pd,
    },
    ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign},
};

/// Four numbers.
#[derive(Clone, Copy, Debug)]
pub struct X4(__m256d);

/// In which of four lanes a condition holds: all bits of a lane, or none.
#[derive(Clone, Copy, Debug)]
pub struct X4Mask(__m256d);

/// Runs instructions of AVX2 and FMA.
macro_rules! instruction {
    ($call:expr) => {
        // SAFETY: the type is named only where `InstructionSet::Fused` was chosen, which on x86-64 means that AVX2 and
        // FMA were detected.
        unsafe { $call }
    };
}

impl X4 {
    #[inline(always)]
    fn lanes(self) -> [f64; 4] {
        // SAFETY: both are 32 bytes without padding, and any bits are valid numbers.
        unsafe { std::mem::transmute::<__m256d, [f64; 4]>(self.0) }
    }
    #[inline(always)]
    fn of_lanes([a, b, c, d]: [f64; 4]) -> Self {
        Self(instruction!(_mm256_setr_pd(a, b, c, d)))
    }
    #[inline(always)]
    fn lane_by_lane(self, of: impl Fn(f64) -> f64) -> Self {
        Self::of_lanes(self.lanes().map(of))
    }
    #[inline(always)]
    fn pair_by_pair(self, other: Self, of: impl Fn(f64, f64) -> f64) -> Self {
        let (a, b) = (self.lanes(), other.lanes());
        Self::of_lanes(std::array::from_fn(|lane| of(a[lane], b[lane])))
    }
}

impl Mask for X4Mask {
    #[inline(always)]
    fn of(holds: bool) -> Self {
        let bits = if holds { f64::from_bits(u64::MAX) } else { 0.0 };
        Self(instruction!(_mm256_set1_pd(bits)))
    }
    #[inline(always)]
    fn any(self) -> bool {
        instruction!(_mm256_movemask_pd(self.0)) != 0
    }
    #[inline(always)]
    fn and(self, other: Self) -> Self {
        Self(instruction!(_mm256_and_pd(self.0, other.0)))
    }
    #[inline(always)]
    fn or(self, other: Self) -> Self {
        Self(instruction!(_mm256_or_pd(self.0, other.0)))
    }
    #[inline(always)]
    fn not(self) -> Self {
        Self(instruction!(_mm256_xor_pd(self.0, Self::of(true).0)))
    }
}

macro_rules! operators {
    ($($trait:ident $method:ident $instruction:ident),*) => {$(
        impl $trait for X4 {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(instruction!($instruction(self.0, other.0)))
            }
        }
    )*};
}
operators!(Add add _mm256_add_pd, Sub sub _mm256_sub_pd, Mul mul _mm256_mul_pd, Div div _mm256_div_pd);

impl Neg for X4 {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(instruction!(_mm256_xor_pd(self.0, _mm256_set1_pd(-0.0))))
    }
}
impl AddAssign for X4 {
    #[inline(always)]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}
impl SubAssign for X4 {
    #[inline(always)]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

/// The functions that are one instruction, and the others.
macro_rules! unary {
    (sqrt $x:expr) => {
        X4(instruction!(_mm256_sqrt_pd($x.0)))
    };
    (abs $x:expr) => {
        X4(instruction!(_mm256_andnot_pd(_mm256_set1_pd(-0.0), $x.0)))
    };
    ($function:ident $x:expr) => {
        $x.lane_by_lane(f64::$function)
    };
}

macro_rules! vector_real {
    (unary: $($unary:ident)*; binary: $($binary:ident)*;) => {
        impl Real for X4 {
            const LANES: usize = 4;
            type Mask = X4Mask;

            #[inline(always)]
            fn of(x: f64) -> Self {
                Self(instruction!(_mm256_set1_pd(x)))
            }
            #[inline(always)]
            fn lane(self, lane: usize) -> f64 {
                self.lanes()[lane]
            }
            #[inline(always)]
            fn parameter(of_lane: impl Fn(usize) -> f64) -> Self {
                Self::of_lanes(std::array::from_fn(of_lane))
            }
            #[inline(always)]
            fn state(of_lane: impl Fn(usize) -> f64) -> Self {
                Self::of_lanes(std::array::from_fn(of_lane))
            }
            #[inline(always)]
            fn fma(self, b: Self, c: Self) -> Self {
                Self(instruction!(_mm256_fmadd_pd(self.0, b.0, c.0)))
            }
            #[inline(always)]
            fn sin_cos(self) -> (Self, Self) {
                let both = self.lanes().map(f64::sin_cos);
                (Self::of_lanes(both.map(|(sine, _)| sine)), Self::of_lanes(both.map(|(_, cosine)| cosine)))
            }
            #[inline(always)]
            fn finite(self) -> bool {
                // x - x is zero for a finite x and no number for others.
                let zeros = (self - self).equal(Self::of(0.0));
                instruction!(_mm256_movemask_pd(zeros.0)) == 0b1111
            }
            #[inline(always)]
            fn less(self, other: Self) -> X4Mask {
                X4Mask(instruction!(_mm256_cmp_pd::<_CMP_LT_OQ>(self.0, other.0)))
            }
            #[inline(always)]
            fn less_or_equal(self, other: Self) -> X4Mask {
                X4Mask(instruction!(_mm256_cmp_pd::<_CMP_LE_OQ>(self.0, other.0)))
            }
            #[inline(always)]
            fn equal(self, other: Self) -> X4Mask {
                X4Mask(instruction!(_mm256_cmp_pd::<_CMP_EQ_OQ>(self.0, other.0)))
            }
            #[inline(always)]
            fn select(mask: X4Mask, a: Self, b: Self) -> Self {
                Self(instruction!(_mm256_blendv_pd(b.0, a.0, mask.0)))
            }
            $(
                #[inline(always)]
                fn $unary(self) -> Self {
                    unary!($unary self)
                }
            )*
            $(
                #[inline(always)]
                fn $binary(self, other: Self) -> Self {
                    self.pair_by_pair(other, f64::$binary)
                }
            )*
            #[inline(always)]
            fn enter<K: Kernel>(kernel: K) -> K::Out {
                enter_fused(kernel)
            }
        }
    };
}
elementary_functions!(vector_real! {});

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{fused::Fused, instruction_set::InstructionSet};

    /// Points where the operations and comparisons have their edges.
    const POINTS: [f64; 8] = [0.0, -0.0, 1.5, -2.25, f64::INFINITY, f64::NEG_INFINITY, f64::NAN, 1e-310];

    /// Every operation on every pair of points, in all four lanes against the fused scalar.
    fn compare<R: Real>(x: f64, y: f64) -> Vec<u64> {
        let (a, b) = (R::state(|_| x), R::state(|lane| if lane == 0 { y } else { x }));
        let mut results =
            vec![a + b, a - b, a * b, a / b, -a, a.fma(b, b), a.sqrt(), a.abs(), a.sin(), a.min(b), a.powf(b)];
        let masks = [a.less(b), a.less_or_equal(b), a.equal(b), a.less(b).not(), a.less(b).or(b.less(a))];
        results.extend(masks.map(|mask| R::select(mask, a, b)));
        results.into_iter().map(|value| value.lane(0)).chain([f64::from(a.finite())]).map(bits).collect()
    }

    /// The bits of a number; all NaNs are one.
    fn bits(x: f64) -> u64 {
        if x.is_nan() { u64::MAX } else { x.to_bits() }
    }

    #[test]
    fn every_lane_is_the_fused_scalar() {
        if InstructionSet::chosen() != InstructionSet::Fused {
            return;
        }
        for x in POINTS {
            for y in POINTS {
                assert_eq!(compare::<X4>(x, y), compare::<Fused<f64>>(x, y), "{x} and {y}");
            }
        }
    }
}
