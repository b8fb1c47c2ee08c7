//! Pairs: two numbers, in one register if the instruction set has such.

use crate::scalar::{real::Real, simd::lanes::Lanes};
use core::ops::{Add, Mul};

/// Two numbers. Every operation is bitwise identical to the two operations on `R`.
pub trait Pair<R: Real>: Copy + Send + Sync + 'static + Add<Output = Self> + Mul<Output = Self> {
    /// The pair of these two.
    fn of(parts: [R; 2]) -> Self;
    /// The two numbers.
    fn parts(self) -> [R; 2];
    /// The two numbers in the other order.
    fn swap(self) -> Self;
    /// `self * b + c`, in one rounding where the scalar has it.
    fn fma(self, b: Self, c: Self) -> Self;
    /// The sum of the two numbers.
    #[inline(always)]
    fn total(self) -> R {
        let [first, second] = self.parts();
        first + second
    }
}

/// Two numbers, computed one after the other.
impl<R: Real> Pair<R> for Lanes<R, 2> {
    #[inline(always)]
    fn of(parts: [R; 2]) -> Self {
        Self::of_parts(parts)
    }
    #[inline(always)]
    fn parts(self) -> [R; 2] {
        [self.part(0), self.part(1)]
    }
    #[inline(always)]
    fn swap(self) -> Self {
        Self::of_parts([self.part(1), self.part(0)])
    }
    #[inline(always)]
    fn fma(self, b: Self, c: Self) -> Self {
        Real::fma(self, b, c)
    }
}

/// The pair of two numbers.
#[inline(always)]
pub fn pair<R: Real>(first: R, second: R) -> R::Pair {
    R::Pair::of([first, second])
}

/// The pair of a number and the same number.
#[inline(always)]
pub fn twice<R: Real>(number: R) -> R::Pair {
    R::Pair::of([number; 2])
}
