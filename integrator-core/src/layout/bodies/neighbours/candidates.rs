//! Candidates for the lists of the bodies in consecutive cells, and those of them that are near enough.
//!
//! Distances are computed in single precision, several at a time, from places seen from a body of these cells: who is a little farther away than
//! the radius may be listed too, and adds zero to every sum.

use super::cells::Cells;
use crate::scalar::{
    real::Real,
    simd::block::{Block, PICKED},
};
use alloc::vec::Vec;
use core::ops::Range;

/// The candidates of a group of cells: those of the bodies in them and in those beside them that may be near one of their own.
/// `T` is single precision.
pub(crate) struct Candidates<T: Real, const D: usize> {
    /// Cell by cell, the slots of all bodies and their places, seen from the first of the group's own bodies; infinity
    /// after the last one.
    found: Vec<u32>,
    found_at: [Vec<T>; D],
    /// The slots of the group's own bodies, and the index at which they begin among these.
    own: Range<usize>,
    home: usize,
    /// Numbers from zero on, and those of them that are candidates.
    numbers: Vec<u32>,
    kept: Vec<u32>,
    /// In the order of numbers of bodies: the number of each candidate, and which of all above it is.
    keys: Vec<u64>,
    /// Room for the sort, and how many keys have each digit.
    sorted: Vec<u64>,
    tally: Vec<u32>,
    /// In the order of numbers, the slots and places of candidates; zero and infinity after the last one.
    slots: Vec<u32>,
    places: [Vec<T>; D],
    /// Cell by cell, where candidates are in the order of numbers.
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
            own: 0..0,
            home: 0,
            numbers: Vec::new(),
            kept: Vec::new(),
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

    /// Gathers those of the group of the body in a slot, unless they are those that are here.
    #[inline(always)]
    pub(crate) fn gather(&mut self, cells: &Cells<D>, slot: usize) {
        if self.own.contains(&slot) {
            return;
        }
        self.find(cells, &cells.group(slot));
        self.keep();
        self.keys.clear();
        let bodies = self.kept.iter().map(|which| (cells.body_of[self.found[*which as usize] as usize], *which));
        self.keys.extend(bodies.map(|(body, which)| u64::from(body) << 32 | u64::from(which)));
        self.sort(cells.body_of.len());
        let whole = self.keys.len().next_multiple_of(PICKED);
        self.slots.clear();
        self.slots.resize(whole, 0);
        for places in &mut self.places {
            places.clear();
            places.resize(whole, T::of(f64::INFINITY));
        }
        let found = self.found.len();
        self.ranks.resize(self.ranks.len().max(found), 0);
        let (ranks, slots, from) = (&mut self.ranks[..found], &mut self.slots, &self.found[..]);
        for ((rank, key), slot) in self.keys.iter().enumerate().zip(slots) {
            let which = *key as u32 as usize;
            *slot = from[which];
            ranks[which] = rank as u32;
        }
        for (places, from) in self.places.iter_mut().zip(&self.found_at) {
            for (place, key) in places.iter_mut().zip(&self.keys) {
                *place = from[*key as u32 as usize];
            }
        }
    }

    /// Looks up who is in some cells and in those beside them, and how far the radius is at such places.
    #[inline(always)]
    fn find(&mut self, cells: &Cells<D>, group: &Range<usize>) {
        self.own = cells.slots(group);
        let own = self.own.start;
        self.found.clear();
        self.found_at.iter_mut().for_each(Vec::clear);
        for (slots, shift) in cells.around(group) {
            // Not an image of them.
            if slots.contains(&own) && shift == [0.0; D] {
                self.home = self.found.len() + own - slots.start;
            }
            self.found.extend(slots.start as u32..slots.end as u32);
            for axis in 0..D {
                let (from, to) = (&cells.places[axis], &mut self.found_at[axis]);
                let shift = shift[axis] - from[own];
                to.extend(from[slots.clone()].iter().map(|x| T::of(x + shift)));
            }
        }
        let whole = self.found.len().next_multiple_of(PICKED);
        let mut farthest = T::Block::of(0.0);
        for axis in 0..D {
            let places = &mut self.found_at[axis];
            let count = places.len();
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

    /// Keeps the group's own bodies, and those that are near the box around these. Differences
    /// and squares are rounded in the same way as those of two bodies, and are not greater: no body near another one is
    /// left out.
    #[inline(always)]
    fn keep(&mut self) {
        let (home, count) = (self.home..self.home + self.own.len(), self.found.len());
        let mut sides = [[T::Block::of(f64::NEG_INFINITY), T::Block::of(f64::INFINITY)]; D];
        for ((sides, image), places) in sides.iter_mut().zip(&self.images).zip(&self.found_at) {
            // Who is beyond the box may be near by way of its image.
            if image.is_none() {
                let (mut low, mut high) = (places[home.start], places[home.start]);
                for place in &places[home.clone()] {
                    low = T::select(place.less(low), *place, low);
                    high = T::select(high.less(*place), *place, high);
                }
                *sides = [low, high].map(T::Block::splat);
            }
        }
        let (limit, inside) = (T::Block::splat(self.square), T::Block::of(0.0));
        let known = self.numbers.len() as u32;
        self.numbers.extend(known..known.max(self.found_at[0].len() as u32));
        self.kept.resize(self.kept.len().max(self.numbers.len()), 0);
        let (groups, _) = self.numbers.as_chunks::<PICKED>();
        let mut kept = 0;
        for (group, numbers) in groups.iter().take(count.div_ceil(PICKED)).enumerate() {
            let first = group * PICKED;
            let (mut bits, places) = (0, self.found_at.each_ref().map(|places| &places[first..first + PICKED]));
            for block in (0..PICKED).step_by(T::Block::WIDTH) {
                let mut square = inside;
                for (places, [low, high]) in places.iter().zip(sides) {
                    let place = T::Block::read(&places[block..]);
                    let distance = (low - place).max(place - high).max(inside);
                    square = distance.fma(distance, square);
                }
                bits |= square.less_bits(limit) << block;
            }
            // Those up to a number, in this group.
            let up_to = |number: usize| match number.saturating_sub(first) {
                number @ 0..PICKED => (1 << number) - 1,
                _ => u64::MAX,
            };
            bits = (bits | up_to(home.end) & !up_to(home.start)) & up_to(count);
            if let Some(to) = self.kept[kept..].first_chunk_mut() {
                kept += T::Block::pick(numbers, bits, to);
            }
        }
        self.kept.truncate(kept);
    }

    /// Sorts keys by the numbers of this number of bodies, digit by digit.
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

    /// Writes the slots of those that are near the body in a slot, one of the group, in the order of their numbers and without
    /// itself, and returns how many they are, and how many of them have lower numbers.
    #[inline(always)]
    pub(crate) fn near(&self, slot: usize, near: &mut Vec<u32>) -> [u32; 2] {
        if self.images.iter().any(Option::is_some) {
            self.near_where::<true>(slot, near)
        } else {
            self.near_where::<false>(slot, near)
        }
    }

    /// [`Self::near`], where `IMAGES` says whether some periodic axis requires the nearest image.
    #[inline(always)]
    fn near_where<const IMAGES: bool>(&self, slot: usize, near: &mut Vec<u32>) -> [u32; 2] {
        let own = self.ranks[self.home + slot - self.own.start] as usize;
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
