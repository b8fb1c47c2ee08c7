//! Loads of rows of bodies from states, and stores back to them.

use crate::{
    layout::bodies::pair_sums::{ActiveMask, BodyConstants},
    scalar::{
        real::Real,
        simd::{block::WIDEST, row::Row},
    },
    state::{
        coords::Coords,
        phase::Phase,
        precision::{Precision, Slot},
    },
};
use alloc::vec::Vec;
use core::ops::Range;

/// The number of bodies in a row, whatever the hardware: the order of sums depends on it.
pub(crate) const WIDTH: usize = 8;

/// Rows of zeros.
pub(crate) fn zeros<W: Real, const D: usize>(rows: usize) -> Vec<[W; D]> {
    let mut zeros = Vec::with_capacity(rows);
    for _ in 0..rows {
        zeros.push([W::of(0.0); D]);
    }
    zeros
}

/// The active lanes of the last row of these bodies, if it has fewer bodies than lanes.
#[inline(always)]
pub(crate) fn active_in_last<R: Real>(bodies: usize) -> ActiveMask<R::Row<WIDTH>> {
    let rest = bodies % WIDTH;
    (rest > 0).then(|| Real::parameter(&|lane| if lane / R::LANES < rest { 1.0 } else { 0.0 }))
}

/// The body that a lane of a row belongs to, and the lane of its state, for a row of the bodies of a range.
#[inline(always)]
pub(crate) fn body_and_lane<R: Real>(bodies: &Range<usize>, lane: usize) -> (usize, usize) {
    (bodies.start + lane / R::LANES % bodies.len(), lane % R::LANES)
}

/// The slots of a row of bodies, from the positions or the momenta of one state per lane.
pub(crate) fn pack<R: Real, C: Coords, const N: usize, const D: usize>(
    bodies: &Range<usize>,
    states: &[&Phase<C>],
    half: fn(&Phase<C>) -> &C,
) -> [<C::Leaf as Precision>::Slot<R::Row<N>>; D] {
    let mut slots = [Slot::zero(); D];
    for (d, slot) in slots.iter_mut().enumerate() {
        *slot = pack_one::<R, C::Leaf, N>(&|lane| {
            let (body, lane) = body_and_lane::<R>(bodies, lane);
            half(states[lane]).flat()[body * D + d]
        });
    }
    slots
}

/// The slot of a row, as a function of its own: inlined, it would be copied for each coordinate.
#[inline(never)]
fn pack_one<R: Real, K: Precision, const N: usize>(of_lane: &dyn Fn(usize) -> K) -> K::Slot<R::Row<N>> {
    K::pack(of_lane)
}

/// Writes one lane of the slots of a row of bodies to their coordinates.
#[inline(always)]
pub(crate) fn unpack<R: Real, K: Precision, const N: usize, const D: usize>(
    bodies: &Range<usize>,
    slots: &[K::Slot<R::Row<N>>; D],
    lane: usize,
    to: &mut [K],
) {
    // Rows are written as a whole, since a lane takes as long.
    if const { K::PLAIN } {
        let mut numbers = [[R::of(0.0); WIDEST]; D];
        for d in 0..D {
            slots[d].value().write(&mut numbers[d]);
        }
        for (number, body) in to[bodies.start * D..bodies.end * D].chunks_exact_mut(D).enumerate() {
            for (d, leaf) in body.iter_mut().enumerate() {
                *leaf = K::from_parts([numbers[d][number].lane(lane), 0.0]);
            }
        }
        return;
    }
    let mut from = lane;
    for body in to[bodies.start * D..bodies.end * D].chunks_exact_mut(D) {
        for (leaf, slot) in body.iter_mut().zip(slots) {
            *leaf = K::unpack(*slot, from);
        }
        from += R::LANES;
    }
}

/// Loads the prepared constants of a row of bodies.
pub(crate) fn load_constants<R: Real, P: BodyConstants<S>, const N: usize, const S: usize>(
    bodies: &Range<usize>,
    constants: &[&P],
) -> [R::Row<N>; S] {
    let mut rows = [Real::of(0.0); S];
    for (s, row) in rows.iter_mut().enumerate() {
        *row = prepared_row::<R, N>(&|lane| {
            let (body, lane) = body_and_lane::<R>(bodies, lane);
            constants[lane].body_constants(body)[s]
        });
    }
    rows
}

/// A row of prepared constants, likewise.
#[inline(never)]
fn prepared_row<R: Real, const N: usize>(of_lane: &dyn Fn(usize) -> f64) -> R::Row<N> {
    Real::prepared(of_lane)
}

/// The row of numbers of these bodies.
#[inline(always)]
pub(crate) fn row_of<R: Real, const N: usize>(bodies: &Range<usize>, number: &dyn Fn(usize) -> R) -> R::Row<N> {
    Real::state(&|lane| {
        let (body, lane) = body_and_lane::<R>(bodies, lane);
        number(body).lane(lane)
    })
}

/// The values of the slots of a row.
#[inline(always)]
pub(crate) fn values<W: Real, L: Slot<W>, const D: usize>(slots: &[L; D]) -> [W; D] {
    let mut values = [W::of(0.0); D];
    for d in 0..D {
        values[d] = slots[d].value();
    }
    values
}
