//! Pairs: vectors of two numbers, where a register holds both.

use crate::scalar::real::Real;

/// A vector of two numbers. Every operation has the bits of the two operations on `R`.
pub trait Pair<R: Real>: Copy + Send + Sync + 'static {
    /// The pair of these two.
    fn of(parts: [R; 2]) -> Self;
    /// The two numbers.
    fn parts(self) -> [R; 2];
    /// `self * b`, lane by lane.
    fn mul(self, b: Self) -> Self;
    /// `self * b + c`, lane by lane.
    fn fma(self, b: Self, c: Self) -> Self;
    /// The sum of the two.
    #[inline(always)]
    fn total(self) -> R {
        let [first, second] = self.parts();
        first + second
    }
}

/// The pair where no register holds both: two numbers, computed one after the other.
impl<R: Real> Pair<R> for [R; 2] {
    #[inline(always)]
    fn of(parts: [R; 2]) -> Self {
        parts
    }
    #[inline(always)]
    fn parts(self) -> [R; 2] {
        self
    }
    #[inline(always)]
    fn mul(self, b: Self) -> Self {
        [self[0] * b[0], self[1] * b[1]]
    }
    #[inline(always)]
    fn fma(self, b: Self, c: Self) -> Self {
        [self[0].fma(b[0], c[0]), self[1].fma(b[1], c[1])]
    }
}

/// The pair of two numbers.
#[inline(always)]
pub fn pair<R: Real>(first: R, second: R) -> R::Pair {
    R::Pair::of([first, second])
}
