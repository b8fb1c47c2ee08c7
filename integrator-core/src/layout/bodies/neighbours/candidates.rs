//! Candidates for the lists of the bodies in a cell, and those of them that are near enough.
//!
//! Distances are computed in single precision, several at a time, from places seen from a body of the cell: who is a little farther away than
//! the radius may be listed too, and adds zero to every sum.

use super::cells::Cells;
use crate::scalar::{
    real::Real,
    simd::block::{Block, PICKED},
};
use alloc::vec::Vec;

/// The candidates of a cell: the bodies in it and in those beside it. `T` is single precision.
pub(crate) struct Candidates<T: Real, const D: usize> {
    /// Cell by cell, their slots and their places, seen from the first of the cell's own bodies.
    found: Vec<u32>,
    found_at: [Vec<T>; D],
    /// Where the cell's own bodies begin among these.
    home: usize,
    /// In the order of numbers: the number of each, and which of those above it is.
    keys: Vec<u64>,
    /// Room for the sort, and how many keys have each digit.
    sorted: Vec<u64>,
    tally: Vec<u32>,
    /// In the order of numbers, their slots and places; zero and infinity behind the last one.
    slots: Vec<u32>,
    places: [Vec<T>; D],
    /// Cell by cell, where they are in the order of numbers.
    ranks: Vec<u32>,
    /// The square of the radius.
    square: T,
    /// The sides of periodic axes that are not divided.
    images: [Option<T>; D],
}

impl<T: Real, const D: usize> Candidates<T, D> {
    pub(crate) fn new() -> Self {
        let none = || core::array::from_fn(|_| Vec::new());
        Self {
            found: Vec::new(),
            found_at: none(),
            home: 0,
            keys: Vec::new(),
            sorted: Vec::new(),
            tally: Vec::new(),
            slots: Vec::new(),
            places: none(),
            ranks: Vec::new(),
            square: T::of(0.0),
            images: [None; D],
        }
    }

    /// Gathers those of a cell that has a body.
    #[inline(always)]
    pub(crate) fn gather(&mut self, cells: &Cells<D>, cell: usize) {
        let origin = cells.slots(cell).start;
        self.keys.clear();
        self.found.clear();
        self.found_at.iter_mut().for_each(Vec::clear);
        for (beside, shift) in cells.around(cell) {
            let slots = cells.slots(beside);
            if beside == cell {
                self.home = self.found.len();
            }
            let bodies = cells.body_of[slots.clone()].iter().zip(self.found.len() as u64..);
            self.keys.extend(bodies.map(|(body, which)| u64::from(*body) << 32 | which));
            self.found.extend(slots.start as u32..slots.end as u32);
            for axis in 0..D {
                let (from, to) = (&cells.places[axis], &mut self.found_at[axis]);
                let shift = shift[axis] - from[origin];
                to.extend(from[slots.clone()].iter().map(|x| T::of(x + shift)));
            }
        }
        self.sort(cells.body_of.len());
        let (count, whole) = (self.keys.len(), self.keys.len().next_multiple_of(PICKED));
        self.slots.clear();
        self.slots.extend(self.keys.iter().map(|key| self.found[*key as u32 as usize]));
        self.slots.resize(whole, 0);
        self.ranks.resize(count, 0);
        for (rank, key) in self.keys.iter().enumerate() {
            self.ranks[*key as u32 as usize] = rank as u32;
        }
        let mut farthest = T::Block::of(0.0);
        for axis in 0..D {
            let (places, from) = (&mut self.places[axis], &self.found_at[axis]);
            places.clear();
            places.extend(self.keys.iter().map(|key| from[*key as u32 as usize]));
            places.resize(whole, T::of(0.0));
            for block in places.chunks_exact(T::Block::WIDTH) {
                let size = T::Block::read(block).abs();
                farthest = T::Block::select(farthest.less(size), size, farthest);
            }
            places[count..].fill(T::of(f64::INFINITY));
            let image = cells.image(axis);
            self.images[axis] = (image > 0.0).then(|| T::of(image));
            farthest += T::Block::of(image);
        }
        let farthest = (0..T::Block::WIDTH).map(|lane| farthest.lane(lane)).fold(0.0, f64::max);
        // Two places and their difference are rounded, the side too, and the sum of squares: a spacing each at most.
        let spacing = f64::from(f32::EPSILON);
        let radius = cells.radius * (1.0 + 8.0 * spacing) + 8.0 * D as f64 * spacing * farthest.min(f64::MAX / 1e9);
        self.square = T::of(radius * radius);
    }

    /// Sorts keys by the numbers of so many bodies, digit by digit.
    fn sort(&mut self, bodies: usize) {
        let bits = usize::BITS - bodies.leading_zeros();
        let passes = bits.div_ceil(11).max(1);
        let digit = bits.div_ceil(passes);
        let Self { keys, sorted, tally, .. } = self;
        sorted.resize(keys.len(), 0);
        for pass in 0..passes {
            let of = |key: u64| (key >> (32 + pass * digit)) as usize & ((1 << digit) - 1);
            tally.clear();
            tally.resize(1 << digit, 0);
            for key in keys.iter() {
                tally[of(*key)] += 1;
            }
            let mut next = 0;
            for count in tally.iter_mut() {
                next += core::mem::replace(count, next);
            }
            for key in keys.iter() {
                let to = &mut tally[of(*key)];
                sorted[*to as usize] = *key;
                *to += 1;
            }
            core::mem::swap(keys, sorted);
            sorted.resize(keys.len(), 0);
        }
    }

    /// Writes the slots of those that are near one of the cell's own bodies, in the order of their numbers and without itself,
    /// and returns how many they are, and how many of them have lower numbers.
    #[inline(always)]
    pub(crate) fn near(&self, own: usize, near: &mut Vec<u32>) -> [u32; 2] {
        if self.images.iter().any(Option::is_some) {
            self.near_where::<true>(own, near)
        } else {
            self.near_where::<false>(own, near)
        }
    }

    /// The same where periodic axes may be undivided, or are none.
    #[inline(always)]
    fn near_where<const IMAGES: bool>(&self, own: usize, near: &mut Vec<u32>) -> [u32; 2] {
        let own = self.ranks[self.home + own] as usize;
        let limit = T::Block::splat(self.square);
        let mut center = [limit; D];
        for (center, places) in center.iter_mut().zip(&self.places) {
            *center = T::Block::splat(places[own]);
        }
        let (mut count, mut before) = (0, 0);
        let (groups, _) = self.slots.as_chunks::<PICKED>();
        if near.len() < self.slots.len() {
            near.resize(self.slots.len(), 0);
        }
        for (group, slots) in groups.iter().enumerate() {
            let first = group * PICKED;
            let (mut bits, places) = (0, self.places.each_ref().map(|places| &places[first..first + PICKED]));
            for block in (0..PICKED).step_by(T::Block::WIDTH) {
                let mut square = T::Block::of(0.0);
                for (axis, center) in center.iter().enumerate() {
                    let mut distance = T::Block::read(&places[axis][block..]) - *center;
                    if IMAGES && let Some(side) = self.images[axis] {
                        distance = distance.abs();
                        distance = distance.min((distance - T::Block::splat(side)).abs());
                    }
                    square = distance.fma(distance, square);
                }
                bits |= square.less_bits(limit) << block;
            }
            // Without branches, which would be guessed wrongly once for each body.
            let (place, here) = (own % PICKED, own / PICKED == group);
            bits &= !(u64::from(here) << place);
            let lower = count + (bits & ((1 << place) - 1)).count_ones() as usize;
            before = if here { lower } else { before };
            // No more were picked than there are slots in the groups before.
            if let Some(to) = near[count..].first_chunk_mut() {
                count += T::Block::pick(slots, bits, to);
            }
        }
        [count, before].map(|number| number as u32)
    }
}
