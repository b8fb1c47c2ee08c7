//! Cells: bodies sorted by position, so that those near one are found without a search through all others.
//!
//! Always true: a cell is at least as wide as the radius along every axis that has more than one, so that every body
//! within the radius of a body is in its cell or in one beside it. Computed in `f64`, whatever the bodies are computed
//! in: this decides who is looked at and never what is added. Lengths are in units of a power of two at or below the
//! radius, so that neither single precision nor a square overflows or underflows, whatever the units of the system.

use crate::scalar::{
    exact::{exponent, power_of_two},
    real::Real,
};
use alloc::{vec, vec::Vec};
use core::ops::Range;

/// The extent of the space of bodies: along each axis the side of a periodic box, or zero for an unbounded axis.
pub(crate) type Sides<const D: usize> = [f64; D];

/// The most axes that are divided: more would have more cells beside each one than bodies near it.
const DIVIDED: usize = 3;

/// Rows of cells along the first axis that are beside one, and itself, in up to three pieces each.
const AROUND: usize = 3_usize.pow(DIVIDED as u32);

/// The fewest bodies, on average, in cells whose neighbours are looked for together. Measured on liquids and polymers.
const TOGETHER: usize = 32;

/// The fewest cells along a periodic axis that is divided: with fewer, the cells on both sides are the same one.
const FEWEST: usize = 3;

/// Bodies in cells.
pub(crate) struct Cells<const D: usize> {
    pub(super) sides: Sides<D>,
    pub(super) radius: f64,
    /// The number of cells along each axis.
    counts: [usize; D],
    /// The number of cells along the first axis whose neighbours are looked for together.
    together: usize,
    /// The slots of each cell.
    begins: Vec<u32>,
    /// The body in each slot; ascending within a cell.
    pub(crate) body_of: Vec<u32>,
    /// The cell of each body.
    cell_of: Vec<u32>,
    /// The places of bodies in the box, by axis and slot, in units of the radius's power of two as the radius and sides are.
    pub(super) places: [Vec<f64>; D],
}

impl<const D: usize> Cells<D> {
    /// Sorts bodies that are at some points.
    pub(crate) fn new(mut points: Vec<[f64; D]>, sides: Sides<D>, radius: f64) -> Self {
        let scale = power_of_two(-exponent(radius));
        let (sides, radius) = (sides.map(|side| side * scale), radius * scale);
        points.iter_mut().for_each(|point| *point = wrapped(point.map(|x| x * scale), sides));
        let (counts, origin, width) = division(&points, sides, radius);
        let cell = |point: &[f64; D]| {
            let mut cell = 0;
            for axis in (0..D).rev() {
                // What is not a number is nowhere near anything, and may stay in any cell.
                let along = ((point[axis] - origin[axis]) / width[axis]) as usize;
                cell = cell * counts[axis] + along.min(counts[axis] - 1);
            }
            cell as u32
        };
        let cell_of: Vec<u32> = points.iter().map(cell).collect();
        let mut begins = vec![0_u32; counts.iter().product::<usize>() + 1];
        for cell in &cell_of {
            begins[*cell as usize + 1] += 1;
        }
        for cell in 1..begins.len() {
            begins[cell] += begins[cell - 1];
        }
        let (mut next, mut body_of) = (begins.clone(), vec![0; points.len()]);
        let mut places = core::array::from_fn(|_| vec![0.0; points.len()]);
        for (body, (cell, point)) in cell_of.iter().zip(&points).enumerate() {
            let slot = &mut next[*cell as usize];
            body_of[*slot as usize] = body as u32;
            for axis in 0..D {
                places[axis][*slot as usize] = point[axis];
            }
            *slot += 1;
        }
        let together = (TOGETHER * begins.len()).div_ceil(points.len().max(1)).clamp(1, counts[0]);
        Self { sides, radius, counts, together, begins, body_of, cell_of, places }
    }

    /// The cells whose neighbours are looked for together, among which is that of the body in a slot.
    pub(super) fn group(&self, slot: usize) -> Range<usize> {
        let cell = self.cell_of[self.body_of[slot] as usize] as usize;
        let along = cell % self.counts[0];
        let first = along - along % self.together;
        let row = cell - along;
        row + first..row + self.counts[0].min(first + self.together)
    }

    /// The slots of consecutive cells.
    pub(super) fn slots(&self, cells: &Range<usize>) -> Range<usize> {
        self.begins[cells.start] as usize..self.begins[cells.end] as usize
    }

    /// Adds the bodies that are near one, in no particular order, without itself.
    pub(crate) fn near(&self, body: u32, near: &mut Vec<u32>) {
        let cell = self.cell_of[body as usize] as usize;
        let cell = cell..cell + 1;
        let Some(own) = self.slots(&cell).find(|slot| self.body_of[*slot] == body) else { return };
        for (slots, shift) in self.around(&cell) {
            for slot in slots {
                let mut square = 0.0;
                for (axis, shift) in shift.iter().enumerate() {
                    let distance = self.places[axis][slot] + shift - self.places[axis][own];
                    let size = Real::abs(distance);
                    let size = size.min(Real::abs(size - self.image(axis)));
                    square += size * size;
                }
                if square < self.radius * self.radius && slot != own {
                    near.push(self.body_of[slot]);
                }
            }
        }
    }

    /// The side of a periodic axis that is not divided, along which no shift makes a distance that of the nearest image; else
    /// zero.
    pub(super) fn image(&self, axis: usize) -> f64 {
        if self.counts[axis] == 1 { self.sides[axis] } else { 0.0 }
    }

    /// The slots in consecutive cells along the first axis and in those beside them, each with what is added to the places in
    /// it; cells that follow each other are taken together. Where the row of cells is periodic and short, a cell may be there
    /// more than once, each time with another image.
    pub(super) fn around(&self, cells: &Range<usize>) -> Vec<(Range<usize>, [f64; D])> {
        let (mut at, mut rest) = ([0; D], cells.start);
        for (at, count) in at.iter_mut().zip(self.counts) {
            (*at, rest) = (rest % count, rest / count);
        }
        let (count, side, end) = (self.counts[0], self.sides[0], at[0] + cells.len());
        let is_periodic = count > 1 && side > 0.0;
        let before = (is_periodic && at[0] == 0).then_some((count - 1..count, -side));
        let inside = (at[0].saturating_sub(1)..count.min(end + 1), 0.0);
        let behind = (is_periodic && end == count).then_some((0..1, side));
        let mut around = Vec::<(Range<usize>, [f64; D])>::with_capacity(AROUND);
        for number in 0..3_usize.pow(D.min(DIVIDED) as u32 - 1) {
            let Some((row, mut shift)) = self.row_beside(at, number) else { continue };
            for (along, by) in before.iter().chain([&inside]).chain(&behind) {
                let slots = self.slots(&(row + along.start..row + along.end));
                shift[0] = *by;
                match around.last_mut() {
                    Some((last, same)) if last.end == slots.start && *same == shift => last.end = slots.end,
                    _ => around.push((slots, shift)),
                }
            }
        }
        around
    }

    /// The first cell of one of the rows of cells around that which is so far along the other axes, and what is added to the
    /// places in it. Each digit of the number to the base of three says on which side it is.
    fn row_beside(&self, at: [usize; D], mut number: usize) -> Option<(usize, [f64; D])> {
        let (mut beside, mut stride, mut shift) = (0, self.counts[0], [0.0; D]);
        for axis in 1..D {
            let (count, side) = (self.counts[axis], self.sides[axis]);
            let by = if axis < DIVIDED { number % 3 } else { 1 };
            number /= 3;
            // One more than where it is, or beyond one end, which is where the other end is.
            let mut along = at[axis] + by;
            if along == 0 || along > count {
                if count == 1 || side <= 0.0 {
                    return None;
                }
                (along, shift[axis]) = if along == 0 { (count, -side) } else { (1, side) };
            }
            beside += (along - 1) * stride;
            stride *= count;
        }
        Some((beside, shift))
    }
}

/// A point in the box.
fn wrapped<const D: usize>(mut point: [f64; D], sides: Sides<D>) -> [f64; D] {
    for (x, side) in point.iter_mut().zip(sides) {
        if side > 0.0 {
            *x -= side * Real::floor(*x / side);
        }
    }
    point
}

/// The number of cells along each axis, where the first one begins, and how wide they are.
fn division<const D: usize>(points: &[[f64; D]], sides: Sides<D>, radius: f64) -> ([usize; D], [f64; D], [f64; D]) {
    let (mut counts, mut origin, mut extent) = ([1; D], [0.0; D], sides);
    for axis in 0..D {
        if sides[axis] <= 0.0 {
            (origin[axis], extent[axis]) = crowded(points.iter().map(|point| point[axis]).collect());
        }
        if axis < DIVIDED {
            counts[axis] = fitting((extent[axis] / radius).min(1e6) as usize, sides[axis]);
        }
    }
    // No more cells than bodies: empty ones take time too.
    while counts.iter().fold(1_usize, |all, count| all.saturating_mul(*count)) > points.len().max(1) {
        let Some(axis) = (0..D).max_by_key(|axis| counts[*axis]) else { break };
        counts[axis] = fitting(counts[axis] / 2, sides[axis]);
    }
    let mut width = [1.0; D];
    for axis in 0..D {
        if counts[axis] > 1 {
            width[axis] = extent[axis] / counts[axis] as f64;
        }
    }
    (counts, origin, width)
}

/// Returns the range of most bodies along an axis without an end: its beginning and its length. A body outside belongs
/// to the first cell or the last one, so that a few that flew away do not make all others share a cell.
fn crowded(mut all: Vec<f64>) -> (f64, f64) {
    all.retain(|x| x.is_finite());
    if all.is_empty() {
        return (0.0, 0.0);
    }
    let few = all.len() / 64;
    let last = all.len() - 1 - few;
    let (_, low, _) = all.select_nth_unstable_by(few, f64::total_cmp);
    let low = *low;
    let (_, high, _) = all.select_nth_unstable_by(last, f64::total_cmp);
    let span = *high - low;
    (low - span / 32.0, span * (1.0 + 1.0 / 16.0))
}

/// The number of cells along an axis with room for this number.
fn fitting(count: usize, side: f64) -> usize {
    if count < FEWEST && side > 0.0 { 1 } else { count.max(1) }
}
