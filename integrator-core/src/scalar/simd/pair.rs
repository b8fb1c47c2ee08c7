//! Two numbers that are computed on together, where a register holds both.

use crate::scalar::real::Real;

/// Two numbers side by side. Every operation has the bits of the two operations on `R`.
pub trait Pair<R: Real>: Copy + Send + Sync + 'static {
    /// These two.
    fn of(parts: [R; 2]) -> Self;
    /// The two.
    fn parts(self) -> [R; 2];
    /// `self * b`, each of the two with its own.
    fn mul(self, b: Self) -> Self;
    /// `self * b + c`, each of the two with its own.
    fn fma(self, b: Self, c: Self) -> Self;
    /// The sum of the two.
    #[inline(always)]
    fn total(self) -> R {
        let [first, second] = self.parts();
        first + second
    }
}

/// Where no register holds both, one after the other.
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

/// These two numbers side by side.
#[inline(always)]
pub fn pair<R: Real>(first: R, second: R) -> R::Pair {
    R::Pair::of([first, second])
}
