//! Sums over lists: bonds, angles, dihedrals, and all else whose terms name the coordinates that they are about.
//!
//! Comes in: what a term computes, the lists of indices, and the numbers that each term has. Goes out: the sums. A vector of
//! terms is gathered and computed in lanes, and its values are scattered lane by lane. Always true: a coordinate gets its
//! addends in the order of the terms, and those of one term in the order of its targets, whatever the width of a vector is;
//! and so are the bits, where one coordinate is named several times in a vector as well.

use crate::{
    scalar::{
        real::{Kernel, Real},
        simd::block::{Block, WIDEST},
    },
    state::precision::Slot,
};
use core::{marker::PhantomData, ops::Range};

/// A point that a term reads.
#[derive(Clone, Copy, Debug)]
pub struct Read {
    /// The part of the coordinates that the point belongs to, by its number among those that are read.
    pub part: usize,
    /// The number of the list with the index of the point.
    pub list: usize,
}

/// A coordinate that a term adds to.
#[derive(Clone, Copy, Debug)]
pub struct Addend {
    /// The number of the list with the index of the point.
    pub list: usize,
    /// The component of the point.
    pub component: usize,
    /// The number of the value that is added or subtracted.
    pub value: usize,
    /// Whether the value is subtracted.
    pub negative: bool,
}

/// A term, of points with `D` components each: what it computes from those that it reads, from constants of its own, and from
/// numbers that all terms have in common. Written by `#[hamiltonian]`.
pub trait Term<const READS: usize, const CONSTANTS: usize, const COMMON: usize, const VALUES: usize, const D: usize> {
    /// The points that it reads.
    const READS: [Read; READS];
    /// The coordinates that the values are added to.
    const ADDENDS: &'static [Addend];

    /// The values of a vector of terms.
    fn values<R: Real, W: Block<R>>(
        reads: [[W; D]; READS],
        constants: [W; CONSTANTS],
        common: [W; COMMON],
    ) -> [W; VALUES];
}

/// The terms of a sum: which points they read, and their constants.
pub struct Terms<
    'm,
    R,
    S,
    const LISTS: usize,
    const PARTS: usize,
    const CONSTANTS: usize,
    const COMMON: usize,
    const D: usize,
> {
    /// The numbers of the terms, which are places in lists and constants.
    pub range: Range<usize>,
    /// The lists of the indices of points.
    pub lists: [&'m [usize]; LISTS],
    /// The parts of the coordinates that are read.
    pub parts: [&'m [[S; D]]; PARTS],
    /// The constants of each term.
    pub constants: [&'m [R]; CONSTANTS],
    /// The constants that all terms share.
    pub common: [R; COMMON],
}

impl<
    'm,
    R: Real,
    S: Slot<R>,
    const LISTS: usize,
    const PARTS: usize,
    const CONSTANTS: usize,
    const COMMON: usize,
    const D: usize,
> Terms<'m, R, S, LISTS, PARTS, CONSTANTS, COMMON, D>
{
    /// Adds all values of the terms to sums, in the multiversioned variant for this machine.
    #[inline(always)]
    pub fn add_to<T: Term<READS, CONSTANTS, COMMON, VALUES, D>, const READS: usize, const VALUES: usize>(
        self,
        sums: &mut [[R; D]],
    ) {
        R::enter(Addition::<T, R, S, LISTS, PARTS, READS, CONSTANTS, COMMON, VALUES, D> {
            terms: self,
            sums,
            term: PhantomData,
        });
    }

    /// Adds the terms that fill whole vectors, and leaves the rest. The points of a vector are gathered before the
    /// values of the one before it are scattered, so that its values can be computed while sums wait for each other.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn add_vectors<
        W: Block<R>,
        T: Term<READS, CONSTANTS, COMMON, VALUES, D>,
        const READS: usize,
        const VALUES: usize,
    >(
        &mut self,
        sums: &mut [[R; D]],
    ) {
        let mut common = [W::of(0.0); COMMON];
        for (vector, number) in common.iter_mut().zip(self.common) {
            *vector = W::splat(number);
        }
        let mut reads = [[W::of(0.0); D]; READS];
        let mut constants = [W::of(0.0); CONSTANTS];
        let mut numbers = [[R::of(0.0); WIDEST]; VALUES];
        let mut next = self.gather::<W, T, READS, VALUES>(&mut reads);
        while let Some(lists) = next {
            let first = self.range.start;
            for (constant, table) in constants.iter_mut().zip(self.constants) {
                *constant = W::read(&table[first..]);
            }
            let values = T::values::<R, W>(reads, constants, common);
            for (value, numbers) in values.into_iter().zip(&mut numbers) {
                value.write(numbers);
            }
            self.range.start += W::WIDTH;
            next = self.gather::<W, T, READS, VALUES>(&mut reads);
            for lane in 0..W::WIDTH {
                // Once for each lane: to the compiler, any sum that is written might be where an index is.
                let mut points = [0; LISTS];
                for (point, list) in points.iter_mut().zip(lists) {
                    *point = list[lane];
                }
                let mut addend = 0;
                while addend < T::ADDENDS.len() {
                    let Addend { list, component, value, negative } = T::ADDENDS[addend];
                    let sum = &mut sums[points[list]][component];
                    if negative {
                        *sum -= numbers[value][lane];
                    } else {
                        *sum += numbers[value][lane];
                    }
                    addend += 1;
                }
            }
        }
    }

    /// The lists of the indices of the next vector of terms, whose points are gathered; nothing if fewer terms are left.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn gather<W: Block<R>, T: Term<READS, CONSTANTS, COMMON, VALUES, D>, const READS: usize, const VALUES: usize>(
        &self,
        reads: &mut [[W; D]; READS],
    ) -> Option<[&'m [usize]; LISTS]> {
        if self.range.len() < W::WIDTH {
            return None;
        }
        let mut lists: [&[usize]; LISTS] = [&[]; LISTS];
        for (near, whole) in lists.iter_mut().zip(self.lists) {
            *near = &whole[self.range.start..self.range.start + W::WIDTH];
        }
        for (read, Read { part, list }) in reads.iter_mut().zip(&T::READS) {
            *read = gathered(self.parts[*part], lists[*list]);
        }
        Some(lists)
    }
}

/// A vector of points, one for each index.
#[cfg_attr(not(debug_assertions), inline(always))]
fn gathered<R: Real, S: Slot<R>, W: Block<R>, const D: usize>(points: &[[S; D]], indices: &[usize]) -> [W; D] {
    let mut numbers = [[R::of(0.0); WIDEST]; D];
    for (lane, index) in indices[..W::WIDTH].iter().enumerate() {
        let point = &points[*index];
        for (numbers, slot) in numbers.iter_mut().zip(point) {
            numbers[lane] = slot.value();
        }
    }
    let mut vectors = [W::of(0.0); D];
    for (vector, numbers) in vectors.iter_mut().zip(&numbers) {
        *vector = W::read(numbers);
    }
    vectors
}

/// The addition of all terms: whole vectors, and then one by one those that fill none.
struct Addition<
    'm,
    T,
    R,
    S,
    const LISTS: usize,
    const PARTS: usize,
    const READS: usize,
    const CONSTANTS: usize,
    const COMMON: usize,
    const VALUES: usize,
    const D: usize,
> {
    terms: Terms<'m, R, S, LISTS, PARTS, CONSTANTS, COMMON, D>,
    sums: &'m mut [[R; D]],
    term: PhantomData<T>,
}

impl<
    T: Term<READS, CONSTANTS, COMMON, VALUES, D>,
    R: Real,
    S: Slot<R>,
    const LISTS: usize,
    const PARTS: usize,
    const READS: usize,
    const CONSTANTS: usize,
    const COMMON: usize,
    const VALUES: usize,
    const D: usize,
> Kernel for Addition<'_, T, R, S, LISTS, PARTS, READS, CONSTANTS, COMMON, VALUES, D>
{
    type Out = ();

    #[inline(always)]
    fn call(mut self) {
        self.terms.add_vectors::<R::Block, T, READS, VALUES>(self.sums);
        if const { R::Block::WIDTH > 1 } {
            self.terms.add_vectors::<R, T, READS, VALUES>(self.sums);
        }
    }
}
