//! The flow of the terms of a potential that are neither of pairs nor of bodies alone.

use crate::{
    layout::bodies::{
        load_store::WIDTH,
        pair_sums::{ManyBody, Unpacked},
    },
    scalar::{
        real::{Kernel, Real},
        simd::row::Row,
    },
    state::{
        coords::Coords,
        precision::{Precision, Slot},
    },
};

/// The flow of the terms beside pairs, whose gradient is computed in the user's own shape.
pub(super) struct OtherTerms<'s, H: ManyBody<D, S>, R: Real, K: Precision, const D: usize, const S: usize> {
    pub(super) q: &'s [[K::Slot<R::Row<WIDTH>>; D]],
    pub(super) p: &'s mut [[K::Slot<R::Row<WIDTH>>; D]],
    pub(super) bodies: usize,
    pub(super) parameters: &'s H::Parameters<R>,
    pub(super) step: R::Row<WIDTH>,
    pub(super) time: f64,
}

impl<H: ManyBody<D, S>, R: Real, K: Precision, const D: usize, const S: usize> Kernel
    for OtherTerms<'_, H, R, K, D, S>
{
    type Out = ();

    #[inline(always)]
    fn call(self) {
        let Self { q, p, bodies, parameters, step, time } = self;
        let zeros = || H::Coords::slots_from::<R>(bodies * D, |_| R::of(0.0));
        let (mut unpacked, mut gradient) = (zeros(), zeros());
        let (points, _) = H::Coords::slots_mut(&mut unpacked).as_chunks_mut::<D>();
        for (row, points) in points.chunks_mut(WIDTH).enumerate() {
            let mut numbers = [[R::of(0.0); WIDTH]; D];
            for d in 0..D {
                q[row][d].value().write(&mut numbers[d]);
            }
            for (lane, point) in points.iter_mut().enumerate() {
                for d in 0..D {
                    point[d] = numbers[d][lane];
                }
            }
        }
        H::other_terms::<R>(Unpacked { q: &unpacked, p: &mut gradient, parameters }, time);
        let (points, _) = H::Coords::slots_mut(&mut gradient).as_chunks::<D>();
        for (row, points) in points.chunks(WIDTH).enumerate() {
            let mut numbers = [[R::of(0.0); WIDTH]; D];
            for (lane, point) in points.iter().enumerate() {
                for d in 0..D {
                    numbers[d][lane] = point[d];
                }
            }
            for d in 0..D {
                p[row][d].fma(step, <R::Row<WIDTH> as Row<R>>::read(&numbers[d]));
            }
        }
    }
}
