//! Lists of a motion, with the positions of bodies when they were built. They are valid until a body has moved too far.

use super::{
    Cutoffs,
    lists::Lists,
    places::{Places, farthest, lists},
};
use crate::{
    layout::bodies::load_store::{WIDTH, values},
    scalar::{
        real::{Mask, Real},
        simd::row::Row,
    },
    state::precision::Slot,
};
use alloc::{sync::Arc, vec, vec::Vec};

/// Lists of neighbours, and where bodies were when these were made.
pub(super) struct Listed<W, const D: usize> {
    pub(super) lists: Arc<Lists>,
    pub(super) reference: Vec<[W; D]>,
    /// The square of half of the skin.
    pub(super) slack: f64,
    pub(super) skin: f64,
}

impl<W: Real, const D: usize> Listed<W, D> {
    /// Lists the pairs within the cutoff and a skin around it, in the memory of old lists.
    #[inline(always)]
    pub(super) fn new<R: Real, L: Slot<W>>(
        q: &[[L; D]],
        bodies: usize,
        cutoffs: &Cutoffs<D>,
        skin: f64,
        threads: usize,
        old: Option<Lists>,
    ) -> Self
    where
        W: Row<R>,
    {
        let mut members = Vec::with_capacity(cutoffs.of_members.len());
        for (member, cutoff) in cutoffs.of_members.iter().enumerate() {
            let mut coordinates = vec![0.0; D * bodies];
            for (row, coordinates) in q.iter().zip(coordinates.chunks_mut(D * WIDTH)) {
                for (axis, row) in values(row).iter().enumerate() {
                    for (body, point) in coordinates.chunks_exact_mut(D).enumerate() {
                        point[axis] = row.lane(body * R::LANES + member * (R::LANES / R::MEMBERS));
                    }
                }
            }
            let farthest = farthest(&coordinates);
            // Where lists are not used in this lane, none are made for it.
            let distance = if cutoff.is_short() { cutoff.distance } else { 0.0 };
            let radius = distance + skin + rounding::<R>(distance + skin, farthest);
            members.push(Places { coordinates, sides: cutoff.sides.to_vec(), radius });
        }
        let lists = Arc::new(lists::<D>(&members, bodies, threads, old));
        // Half of the skin less what the comparison itself rounds.
        let slack = 0.25 * skin * skin * (1.0 - 16.0 * epsilon::<R>());
        Self { lists, reference: q.iter().map(values).collect(), slack, skin }
    }

    /// Whether no body has moved by more than half of the skin. What is not a number has not moved: its run ends anyway.
    #[inline(always)]
    pub(super) fn holds<L: Slot<W>>(&self, q: &[[L; D]]) -> bool {
        let slack = W::of(self.slack);
        let mut moved = W::Mask::of(false);
        for (now, then) in q.iter().zip(&self.reference) {
            let mut square = W::of(0.0);
            for (now, then) in now.iter().zip(then) {
                let by = now.value() - *then;
                square = by.fma(by, square);
            }
            moved = moved.or(slack.less(square));
        }
        !moved.any()
    }
}

/// The spacing of numbers just above one in what is computed in.
pub(super) fn epsilon<R: Real>() -> f64 {
    let single = R::of(1.0 + f64::EPSILON).lane(0) == 1.0;
    if single { f64::from(f32::EPSILON) } else { f64::EPSILON }
}

/// The distance by which two bodies may be farther from each other than the system computes. A displacement is off by
/// the rounding of a difference, of its division by the side, and of the multiple of the side, each half a spacing at
/// `2 farthest`; three axes and the sum of their squares make this eight spacings at most.
pub(crate) fn rounding<R: Real>(distance: f64, farthest: f64) -> f64 {
    16.0 * epsilon::<R>() * (farthest + distance)
}
