//! Candidates for the lists of the bodies in a cell, and those of them that are near enough.
//!
//! Distances are computed in single precision, several at a time, from places seen from a body of the cell: who is a little farther away than
//! the radius may be listed too, and adds zero to every sum.

use super::cells::Cells;
use crate::scalar::{real::Real, simd::block::Block};
use alloc::vec::Vec;

/// The candidates of a cell: the bodies in it and in those beside it, in the order of their numbers. `T` is single precision.
pub(crate) struct Candidates<T: Real, const D: usize> {
    /// The number of each, the part of the surroundings that it is in, and its slot.
    keys: Vec<u64>,
    /// Room for the sort, and how many keys have each digit.
    sorted: Vec<u64>,
    tally: Vec<u32>,
    slots: Vec<u32>,
    /// Their places, seen from the first of the cell's own bodies; infinity behind the last one.
    places: [Vec<T>; D],
    /// The bodies of the cell itself among them, in the order of their slots.
    own: Vec<u32>,
    /// The square of the radius.
    square: T,
    /// The sides of periodic axes that are not divided.
    images: [Option<T>; D],
}

/// How many candidates are looked at before those that are near are written down: as many as a word has bits.
const GROUP: usize = u64::BITS as usize;

/// The bits of a slot in a key.
const SLOT: u32 = 27;

/// The most bodies whose slots fit into a key.
pub(crate) const MOST_BODIES: usize = 1 << SLOT;

impl<T: Real, const D: usize> Candidates<T, D> {
    pub(crate) fn new() -> Self {
        let places = core::array::from_fn(|_| Vec::new());
        Self {
            keys: Vec::new(),
            sorted: Vec::new(),
            tally: Vec::new(),
            slots: Vec::new(),
            places,
            own: Vec::new(),
            square: T::of(0.0),
            images: [None; D],
        }
    }

    /// Gathers those of a cell that has a body.
    #[inline(always)]
    pub(crate) fn gather(&mut self, cells: &Cells<D>, cell: usize) {
        let around = cells.around(cell);
        self.keys.clear();
        let mut home = 0;
        for (part, (beside, _)) in around.iter().enumerate() {
            if *beside == cell {
                home = part as u32;
            }
            for slot in cells.slots(*beside) {
                // Parts are less than 3^3, and take the five bits before the number.
                self.keys.push(u64::from(cells.body_of[slot]) << 32 | (part as u64) << SLOT | slot as u64);
            }
        }
        self.sort(cells.body_of.len());
        let count = self.keys.len();
        self.slots.clear();
        self.own.clear();
        for (place, key) in self.keys.iter().enumerate() {
            let key = *key as u32;
            self.slots.push(key & ((1 << SLOT) - 1));
            if key >> SLOT == home {
                self.own.push(place as u32);
            }
        }
        let first = cells.slots(cell).start;
        let mut farthest = T::Block::of(0.0);
        for axis in 0..D {
            let (places, from) = (&mut self.places[axis], &cells.places[axis]);
            let mut shifts = [0.0; 1 << (32 - SLOT)];
            for (shift, (_, by)) in shifts.iter_mut().zip(&around) {
                *shift = by[axis] - from[first];
            }
            places.clear();
            places.extend(self.keys.iter().map(|key| {
                let part = (*key as u32 >> SLOT) as usize;
                T::of(from[(*key as u32 & ((1 << SLOT) - 1)) as usize] + shifts[part])
            }));
            places.resize(count.next_multiple_of(GROUP), T::of(0.0));
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
        let own = self.own[own] as usize;
        let limit = T::Block::splat(self.square);
        let mut center = [limit; D];
        for (center, places) in center.iter_mut().zip(&self.places) {
            *center = T::Block::splat(places[own]);
        }
        let (mut count, mut before) = (0, 0);
        if near.len() < self.slots.len() {
            near.resize(self.slots.len(), 0);
        }
        for group in (0..self.slots.len()).step_by(GROUP) {
            let (mut bits, places) = (0, self.places.each_ref().map(|places| &places[group..group + GROUP]));
            for block in (0..GROUP).step_by(T::Block::WIDTH) {
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
            if let Some(place) = own.checked_sub(group).filter(|place| *place < GROUP) {
                bits &= !(1 << place);
                before = count + (bits & ((1_u64 << place) - 1)).count_ones() as usize;
            }
            while bits != 0 {
                near[count] = self.slots[group + bits.trailing_zeros() as usize];
                count += 1;
                bits &= bits - 1;
            }
        }
        [count, before].map(|number| number as u32)
    }
}
