//! Bodies side by side: what lets one text of a force serve a body at a time on one machine and eight on another.

use crate::{
    coords::Coords,
    gather::Array,
    lanes::Lanes,
    many_body::{Bodies, ManyBody, PerBody},
    phase::Phase,
    real::Real,
    slot::{Keep, Slot},
};
use core::ops::Range;

/// Up to eight bodies side by side, each an `R`. Every operation has the bits of `R`'s own, so that no result depends on
/// how wide the hardware is. Places beyond the last body repeat the first ones: whatever is computed there is finite
/// where the bodies are, and never read.
pub trait Row<R: Real>: Real {
    /// Whether rows are few registers, so that loops over rotations are written out: rotations by a known number of places
    /// are instructions there. Where every body is a number of its own, this would be sixty-four copies of a force.
    const WRITTEN_OUT: bool = true;

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
    /// What the system says of each body and the one in the same place of another row.
    #[inline(always)]
    fn pairs<H: ManyBody<D, S>, const D: usize, const S: usize>(
        parameters: &H::Parameters<R>,
        [i, j]: [Bodies<Self, D, S>; 2],
        time: f64,
    ) -> H::Force<Self> {
        H::pair::<R, Self>(parameters, i.q, j.q, i.of, j.of, time)
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

/// Which body and which of its lanes a lane of a row belongs to, for a row of the bodies of a range.
#[inline(always)]
fn place<R: Real>(bodies: &Range<usize>, lane: usize) -> (usize, usize) {
    (bodies.start + lane / R::LANES % bodies.len(), lane % R::LANES)
}

/// The slots of a row of bodies, from the positions or the momenta of one state per lane.
pub(crate) fn inward<R: Real, C: Coords, const N: usize, const D: usize>(
    bodies: &Range<usize>,
    states: &[&Phase<C>],
    half: fn(&Phase<C>) -> &C,
) -> [<C::Leaf as Keep>::Slot<R::Row<N>>; D] {
    let slot = |d: usize| {
        C::Leaf::inward(&|lane| {
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
pub(crate) fn outward<R: Real, K: Keep, const N: usize, const D: usize>(
    bodies: &Range<usize>,
    slots: &[K::Slot<R::Row<N>>; D],
    lane: usize,
    to: &mut [K],
) {
    let mut place = lane;
    for body in to[bodies.start * D..bodies.end * D].chunks_exact_mut(D) {
        for (leaf, slot) in body.iter_mut().zip(slots) {
            *leaf = K::outward(*slot, place);
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

impl<R: Real, const BODIES: usize> Row<R> for Lanes<R, BODIES> {
    const WRITTEN_OUT: bool = BODIES <= 2;

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
    /// Body by body: each may fill registers of its own, and all at once would fill none.
    #[inline(always)]
    fn pairs<H: ManyBody<D, S>, const D: usize, const S: usize>(
        parameters: &H::Parameters<R>,
        [i, j]: [Bodies<Self, D, S>; 2],
        time: f64,
    ) -> H::Force<Self> {
        let mut forces = H::Force::<Self>::filled(Self::of(0.0));
        for body in 0..BODIES {
            let (i, j) = (i.body(body), j.body(body));
            let force = H::pair::<R, R>(parameters, i.q, j.q, i.of, j.of, time);
            let (forces, force) = (forces.as_mut(), force.as_ref());
            for number in 0..force.len() {
                forces[number].set_part(body, force[number]);
            }
        }
        forces
    }
}
