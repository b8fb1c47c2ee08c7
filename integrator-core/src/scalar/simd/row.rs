//! Rows of bodies: a force is one text, for vectors of eight bodies and for one body at a time.

use crate::scalar::{real::Real, simd::lanes::Lanes};

/// A row: a vector of up to eight bodies, each an `R`. Every operation has the bits of `R`'s own, so that no result
/// depends on the width of the hardware. Lanes after the last body repeat the first ones: whatever is computed there
/// is finite where the bodies are, and never read.
pub trait Row<R: Real>: Real {
    /// Whether loops over rotations are unrolled, because rows are few registers: rotations by a known number of lanes
    /// are instructions there. Where every body is a number of its own, this would be sixty-four copies of a force.
    const UNROLLED: bool = true;
    /// The number of parts that a row is computed in one by one, each of them a body; zero where it is computed in as a whole.
    const PARTS: usize = 0;

    /// The row with `x` in every lane.
    fn splat(x: R) -> Self;
    /// Rotates a row of `N` bodies: each lane gets the body that is this number of lanes ahead. The first
    /// bodies follow the last one.
    fn rotate<const N: usize>(self, by: usize) -> Self;
    /// The row of the first numbers of a slice that has as many at least.
    fn read(from: &[R]) -> Self;
    /// Writes them to the beginning of a slice that has room for them.
    fn write(self, to: &mut [R]);
    /// Permutes the eight lanes: each gets the lane with its index.
    fn permute(self, indices: &[u64; 8]) -> Self;
    /// Four rows of the numbers of eight points: those at `stride` times each of the indices, plus `offset`.
    fn transposed(points: &[[R; 4]], indices: &[u32; 8], stride: usize, offset: usize) -> [Self; 4];
    /// Prefetches an address that will be read soon and once, by this thread only. Nothing is read here.
    #[inline(always)]
    fn fetch_once<T>(_address: *const T) {}
    /// The number of one body.
    #[inline(always)]
    fn part(&self, body: usize) -> R {
        R::state(&|lane| self.lane(body * R::LANES + lane))
    }
    /// Sets the number of one body, of a row that is made of such parts.
    #[inline(always)]
    fn set_part(&mut self, _body: usize, _number: R) {}
}

/// A body is a row of one.
impl<R: Real> Row<R> for R {
    #[inline(always)]
    fn splat(x: R) -> Self {
        x
    }
    #[inline(always)]
    fn rotate<const N: usize>(self, _by: usize) -> Self {
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
    fn permute(self, _indices: &[u64; 8]) -> Self {
        self
    }
    #[inline(always)]
    fn transposed(points: &[[R; 4]], indices: &[u32; 8], stride: usize, offset: usize) -> [Self; 4] {
        points[indices[0] as usize * stride + offset]
    }
}

impl<R: Real, const BODIES: usize> Row<R> for Lanes<R, BODIES> {
    const UNROLLED: bool = BODIES <= 2;
    const PARTS: usize = BODIES;

    #[inline(always)]
    fn splat(x: R) -> Self {
        Self::of_parts([x; BODIES])
    }
    #[inline(always)]
    fn rotate<const N: usize>(self, by: usize) -> Self {
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
    fn permute(self, indices: &[u64; 8]) -> Self {
        let mut parts = [self.part(0); BODIES];
        for (part, index) in parts.iter_mut().zip(indices) {
            *part = self.part(*index as usize % BODIES);
        }
        Self::of_parts(parts)
    }
    #[inline(always)]
    fn transposed(points: &[[R; 4]], indices: &[u32; 8], stride: usize, offset: usize) -> [Self; 4] {
        let mut rows = [Self::of(0.0); 4];
        for body in 0..BODIES {
            let point = points[indices[body] as usize * stride + offset];
            for (row, number) in rows.iter_mut().zip(point) {
                row.set_part(body, number);
            }
        }
        rows
    }
    #[inline(always)]
    fn part(&self, body: usize) -> R {
        Self::part(*self, body)
    }
    #[inline(always)]
    fn set_part(&mut self, body: usize, number: R) {
        Self::set_part(self, body, number);
    }
}
