//! Blocks: vectors of consecutive numbers of an array. A loop over sites is one text, for whole vectors and for the
//! rest that fills none.

use crate::scalar::real::{Mask, Real};

/// A block: a vector of `WIDTH` consecutive numbers of an array of `R`. Every operation has the bits of `R`'s own, so
/// that no result depends on where blocks begin.
pub trait Block<R: Real>: Real {
    /// The number of lanes.
    const WIDTH: usize;

    /// The first `WIDTH` numbers of a slice that is not shorter.
    fn read(from: &[R]) -> Self;
    /// Writes them to the beginning of a slice that is not shorter than `WIDTH`.
    fn write(self, to: &mut [R]);
    /// The block with `x` in every lane.
    fn splat(x: R) -> Self;

    /// One bit for each lane, the first lane lowest: whether it is less than that of `other`.
    fn less_bits(self, other: Self) -> u64;
    /// Writes those of the words whose bits are set, the first one's lowest, to the beginning of others, and returns how many
    /// they are. Elements after them may be written too.
    fn pick(words: &[u32; PICKED], bits: u64, to: &mut [u32; PICKED]) -> usize;
    /// The block that begins one element later, where `next` follows this one.
    fn after(self, next: Self) -> Self;
    /// The block that begins one element earlier, where this one follows `previous`.
    fn before(self, previous: Self) -> Self;
    /// The elements with even indices, and those with odd ones, of this block and the next one.
    fn deinterleave(self, next: Self) -> [Self; 2];
    /// Two blocks of elements from this one and `odd` in turn.
    fn interleave(self, odd: Self) -> [Self; 2];
    /// Adds a multiple of the block to the first numbers of a slice; the factor is constant along all directions.
    #[inline(always)]
    fn add_multiple(self, factor: R, to: &mut [R]) {
        Self::splat(factor).scale_add(self, Self::read(to)).write(to);
    }
}

/// The number of words that are picked from at a time: one for each of 64 bits.
pub(crate) const PICKED: usize = u64::BITS as usize;

/// The width of the widest block.
pub(crate) const WIDEST: usize = 16;

/// Picks words as a block does, one by one.
#[inline(always)]
pub(crate) fn pick(words: &[u32; PICKED], mut bits: u64, to: &mut [u32; PICKED]) -> usize {
    let mut count = 0;
    while bits != 0 {
        to[count % PICKED] = words[bits.trailing_zeros() as usize % PICKED];
        count += 1;
        bits &= bits - 1;
    }
    count
}

/// A number is a block of one: for rests of loops, and for all that has lanes or parts of its own already.
impl<R: Real> Block<R> for R {
    const WIDTH: usize = 1;

    #[inline(always)]
    fn read(from: &[R]) -> Self {
        from[0]
    }
    #[inline(always)]
    fn write(self, to: &mut [R]) {
        to[0] = self;
    }
    #[inline(always)]
    fn splat(x: R) -> Self {
        x
    }
    #[inline(always)]
    fn less_bits(self, other: Self) -> u64 {
        u64::from(self.less(other).any())
    }
    #[inline(always)]
    fn pick(words: &[u32; PICKED], bits: u64, to: &mut [u32; PICKED]) -> usize {
        pick(words, bits, to)
    }
    #[inline(always)]
    fn after(self, next: Self) -> Self {
        next
    }
    #[inline(always)]
    fn before(self, previous: Self) -> Self {
        previous
    }
    #[inline(always)]
    fn deinterleave(self, next: Self) -> [Self; 2] {
        [self, next]
    }
    #[inline(always)]
    fn interleave(self, odd: Self) -> [Self; 2] {
        [self, odd]
    }
}
