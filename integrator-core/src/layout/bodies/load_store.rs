//! Rows of bodies, filled from states and written back to them.

use crate::{
    layout::bodies::many_body::PerBody,
    scalar::{real::Real, simd::row::Row},
    state::{
        coords::Coords,
        phase::Phase,
        precision::{Precision, Slot},
    },
};
use core::ops::Range;

/// Which body and which of its lanes a lane of a row belongs to, for a row of the bodies of a range.
#[inline(always)]
fn place<R: Real>(bodies: &Range<usize>, lane: usize) -> (usize, usize) {
    (bodies.start + lane / R::LANES % bodies.len(), lane % R::LANES)
}

/// The slots of a row of bodies, from the positions or the momenta of one state per lane.
pub(crate) fn pack<R: Real, C: Coords, const N: usize, const D: usize>(
    bodies: &Range<usize>,
    states: &[&Phase<C>],
    half: fn(&Phase<C>) -> &C,
) -> [<C::Leaf as Precision>::Slot<R::Row<N>>; D] {
    let slot = |d: usize| {
        C::Leaf::pack(&|lane| {
            let (body, lane) = place::<R>(bodies, lane);
            half(states[lane]).flat()[body * D + d]
        })
    };
    let mut slots = [slot(0); D];
    for (d, other) in slots.iter_mut().enumerate() {
        *other = slot(d);
    }
    slots
}

/// Writes one lane of the slots of a row of bodies to their coordinates.
#[inline(always)]
pub(crate) fn unpack<R: Real, K: Precision, const N: usize, const D: usize>(
    bodies: &Range<usize>,
    slots: &[K::Slot<R::Row<N>>; D],
    lane: usize,
    to: &mut [K],
) {
    let mut place = lane;
    for body in to[bodies.start * D..bodies.end * D].chunks_exact_mut(D) {
        for (leaf, slot) in body.iter_mut().zip(slots) {
            *leaf = K::unpack(*slot, place);
        }
        place += R::LANES;
    }
}

/// What is prepared of a row of bodies.
pub(crate) fn prepared<R: Real, P: PerBody<S>, const N: usize, const S: usize>(
    bodies: &Range<usize>,
    constants: &[&P],
) -> [R::Row<N>; S] {
    let mut of = [Real::of(0.0); S];
    for (s, row) in of.iter_mut().enumerate() {
        *row = Real::parameter(&|lane| {
            let (body, lane) = place::<R>(bodies, lane);
            constants[lane].per_body(body)[s]
        });
    }
    of
}

/// A row of numbers, one for each body.
#[inline(always)]
pub(crate) fn of_bodies<R: Real, const N: usize>(bodies: &Range<usize>, number: &dyn Fn(usize) -> R) -> R::Row<N> {
    Real::state(&|lane| {
        let (body, lane) = place::<R>(bodies, lane);
        number(body).lane(lane)
    })
}

/// What the slots of a row hold.
#[inline(always)]
pub(crate) fn values<W: Real, L: Slot<W>, const D: usize>(slots: &[L; D]) -> [W; D] {
    let mut values = [W::of(0.0); D];
    for d in 0..D {
        values[d] = slots[d].value();
    }
    values
}

/// The number in one place of a row.
#[inline(always)]
pub(crate) fn of_place<R: Real>(row: impl Row<R>, place: usize) -> R {
    R::state(&|lane| row.lane(place * R::LANES + lane))
}
