//! Bodies side by side: what lets one text of a force serve a body at a time on one machine and eight on another.

use crate::scalar::{real::Real, simd::lanes::Lanes};

/// Up to eight bodies side by side, each an `R`. Every operation has the bits of `R`'s own, so that no result depends on
/// how wide the hardware is. Places beyond the last body repeat the first ones: whatever is computed there is finite
/// where the bodies are, and never read.
pub trait Row<R: Real>: Real {
    /// Whether rows are few registers, so that loops over rotations are written out: rotations by a known number of places
    /// are instructions there. Where every body is a number of its own, this would be sixty-four copies of a force.
    const WRITTEN_OUT: bool = true;
    /// Of how many numbers a row is made that are computed with one by one; none where a row is computed with as a whole.
    const PARTS: usize = 0;

    /// The same number for every body.
    fn splat(x: R) -> Self;
    /// The row of `N` bodies in which each body's place is taken by the one so many places further on, the first bodies
    /// coming after the last one.
    fn rotated<const N: usize>(self, by: usize) -> Self;
    /// The row of the first numbers of a slice that has as many at least.
    fn read(from: &[R]) -> Self;
    /// Writes them to the beginning of a slice that has room for them.
    fn write(self, to: &mut [R]);
    /// The row in which each place is taken by another one of the eight.
    fn picked(self, places: &[u64; 8]) -> Self;
    /// The numbers that are computed with one by one, if a row is made of such: each may fill registers of its own, and all at
    /// once would fill none.
    #[inline(always)]
    fn parts(&self) -> &[R] {
        &[]
    }
    /// These numbers, to be written.
    #[inline(always)]
    fn parts_mut(&mut self) -> &mut [R] {
        &mut []
    }
}

/// A body is a row of one.
impl<R: Real> Row<R> for R {
    #[inline(always)]
    fn splat(x: R) -> Self {
        x
    }
    #[inline(always)]
    fn rotated<const N: usize>(self, _by: usize) -> Self {
        self
    }
    #[inline(always)]
    fn read(from: &[R]) -> Self {
        from[0]
    }
    #[inline(always)]
    fn write(self, to: &mut [R]) {
        to[0] = self;
    }
    #[inline(always)]
    fn picked(self, _places: &[u64; 8]) -> Self {
        self
    }
}

impl<R: Real, const BODIES: usize> Row<R> for Lanes<R, BODIES> {
    const WRITTEN_OUT: bool = BODIES <= 2;
    const PARTS: usize = BODIES;

    #[inline(always)]
    fn splat(x: R) -> Self {
        Self::of_parts([x; BODIES])
    }
    #[inline(always)]
    fn rotated<const N: usize>(self, by: usize) -> Self {
        let mut parts = [self.part(0); BODIES];
        for (body, part) in parts.iter_mut().enumerate() {
            *part = self.part((body + by) % N);
        }
        Self::of_parts(parts)
    }
    #[inline(always)]
    fn read(from: &[R]) -> Self {
        let mut parts = [from[0]; BODIES];
        parts.copy_from_slice(&from[..BODIES]);
        Self::of_parts(parts)
    }
    #[inline(always)]
    fn write(self, to: &mut [R]) {
        for (body, number) in to[..BODIES].iter_mut().enumerate() {
            *number = self.part(body);
        }
    }
    #[inline(always)]
    fn picked(self, places: &[u64; 8]) -> Self {
        let mut parts = [self.part(0); BODIES];
        for (part, place) in parts.iter_mut().zip(places) {
            *part = self.part(*place as usize % BODIES);
        }
        Self::of_parts(parts)
    }
    #[inline(always)]
    fn parts(&self) -> &[R] {
        self.parts()
    }
    #[inline(always)]
    fn parts_mut(&mut self) -> &mut [R] {
        self.parts_mut()
    }
}
