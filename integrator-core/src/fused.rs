//! The scalar of machines with a fused multiply-add, and the clone of the hot loops that is compiled for them.

use crate::real::{Kernel, Real, elementary_functions};
use std::ops::{Add, AddAssign, Div, Mul, Neg, Sub, SubAssign};

/// `f64` or `f32` whose `fma` is one instruction with one rounding.
///
/// Only worth using inside [`Real::enter`]: elsewhere the same bits come from a call into the maths library.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fused<F>(pub F);

macro_rules! operators {
    ($scalar:ty: $($trait:ident $method:ident $operator:tt),*) => {$(
        impl $trait for Fused<$scalar> {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self(self.0 $operator other.0)
            }
        }
    )*};
}

macro_rules! fused_real {
    ($scalar:ty; unary: $($unary:ident)*; binary: $($binary:ident)*;) => {
        operators!($scalar: Add add +, Sub sub -, Mul mul *, Div div /);

        impl Neg for Fused<$scalar> {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                Self(-self.0)
            }
        }
        impl AddAssign for Fused<$scalar> {
            #[inline(always)]
            fn add_assign(&mut self, other: Self) {
                self.0 += other.0;
            }
        }
        impl SubAssign for Fused<$scalar> {
            #[inline(always)]
            fn sub_assign(&mut self, other: Self) {
                self.0 -= other.0;
            }
        }

        impl Real for Fused<$scalar> {
            const LANES: usize = 1;
            type Mask = bool;

            #[inline(always)]
            fn of(x: f64) -> Self {
                Self(x as $scalar)
            }
            #[inline(always)]
            fn lane(self, _lane: usize) -> f64 {
                f64::from(self.0)
            }
            #[inline(always)]
            fn parameter(of_lane: impl Fn(usize) -> f64) -> Self {
                Self::of(of_lane(0))
            }
            #[inline(always)]
            fn state(of_lane: impl Fn(usize) -> f64) -> Self {
                Self::of(of_lane(0))
            }
            #[inline(always)]
            fn fma(self, b: Self, c: Self) -> Self {
                Self(self.0.mul_add(b.0, c.0))
            }
            #[inline(always)]
            fn sin_cos(self) -> (Self, Self) {
                let (sine, cosine) = self.0.sin_cos();
                (Self(sine), Self(cosine))
            }
            #[inline(always)]
            fn finite(self) -> bool {
                self.0.is_finite()
            }
            #[inline(always)]
            fn less(self, other: Self) -> bool {
                self.0 < other.0
            }
            #[inline(always)]
            fn less_or_equal(self, other: Self) -> bool {
                self.0 <= other.0
            }
            #[inline(always)]
            fn equal(self, other: Self) -> bool {
                self.0 == other.0
            }
            #[inline(always)]
            fn select(mask: bool, a: Self, b: Self) -> Self {
                if mask { a } else { b }
            }
            $(
                #[inline(always)]
                fn $unary(self) -> Self {
                    Self(<$scalar>::$unary(self.0))
                }
            )*
            $(
                #[inline(always)]
                fn $binary(self, other: Self) -> Self {
                    Self(<$scalar>::$binary(self.0, other.0))
                }
            )*
            #[inline(always)]
            fn enter<K: Kernel>(kernel: K) -> K::Out {
                crate::instruction_set::enter_fused(kernel)
            }
        }
    };
}
elementary_functions!(fused_real! { f64; });
elementary_functions!(fused_real! { f32; });
