//! Sums over the partners of each body that come before the forces: energies `F(Σ_j g(i, j))` of a body, such as that of an atom in
//! the electron density of others.
//!
//! Comes in: bodies in rows. Goes out: their densities. Always true: those on a body are added in the order of rows and rotations, or
//! of the numbers of its neighbours, so that no bit depends on threads.

use crate::{
    layout::bodies::{
        load_store::{WIDTH, active_in_last, values, zeros},
        neighbours::{Cutoffs, Neighbours, Sum},
        pair_sums::{ActiveMask, Bodies, ManyBody, add, masked, pair_densities},
    },
    scalar::{
        real::{Kernel, Real},
        simd::row::Row,
    },
    state::precision::Slot,
    threads::{Job, at_once},
};
use alloc::{boxed::Box, vec::Vec};

/// The fewest rows that a thread takes: fewer are done before it has started.
const ROWS_OF_A_THREAD: usize = 64;

/// The densities of all bodies: by neighbours in the lanes of members that have lists, by all pairs in others.
pub(crate) fn densities<H: ManyBody<D, S>, R: Real, L: Slot<R::Row<WIDTH>>, const D: usize, const S: usize>(
    sum: Sum<'_, H, R, L, D, S>,
    neighbours: &mut Neighbours<R, D>,
    cutoffs: Option<&Cutoffs<D>>,
) -> Vec<[R::Row<WIDTH>; D]> {
    let mut densities = zeros(sum.q.len());
    if cutoffs.is_none_or(|cutoffs| !cutoffs.all()) {
        let rows = sum.q.len().div_ceil(sum.threads.max(1)).max(ROWS_OF_A_THREAD);
        let mut jobs = Vec::<Job<'_>>::with_capacity(sum.q.len().div_ceil(rows));
        for (number, densities) in densities.chunks_mut(rows).enumerate() {
            let (sum, first) = (&sum, number * rows);
            jobs.push(Box::new(move || R::enter(OfRows { sum, first, densities })));
        }
        at_once(jobs);
    }
    // A constant, so that nothing is compiled for lists where there is no cutoff.
    if const { H::LISTED_FROM < usize::MAX }
        && let Some(cutoffs) = cutoffs
    {
        neighbours.densities(sum, cutoffs, &mut densities);
    }
    densities
}

/// The densities of the bodies of some rows, by all pairs.
struct OfRows<'s, H: ManyBody<D, S>, R: Real, L, const D: usize, const S: usize> {
    sum: &'s Sum<'s, H, R, L, D, S>,
    first: usize,
    densities: &'s mut [[R::Row<WIDTH>; D]],
}

impl<H: ManyBody<D, S>, R: Real, L: Slot<R::Row<WIDTH>>, const D: usize, const S: usize> Kernel
    for OfRows<'_, H, R, L, D, S>
{
    type Out = ();

    #[inline(always)]
    fn call(self) {
        let Self { sum: &Sum { q, constants, bodies, parameters, time, .. }, first, densities } = self;
        let row = |row: usize| Bodies { q: values(&q[row]), constants: constants[row] };
        let last = active_in_last::<R>(bodies);
        let active = |row: usize| last.filter(|_| row + 1 == q.len());
        for (own, densities) in (first..).zip(densities) {
            let bodies = row(own);
            // Of its own row, a body meets itself in the rotation by zero.
            for other in 0..q.len() {
                let (mut others, mut active): (_, ActiveMask<R::Row<WIDTH>>) = (row(other), active(other));
                for by in 0..WIDTH {
                    if by > 0 || other != own {
                        let addends = pair_densities::<H, R, R::Row<WIDTH>, D, S>(parameters, [bodies, others], time);
                        *densities = add(*densities, masked(addends, active));
                    }
                    others = others.rotate::<R, WIDTH>(1);
                    active = active.map(|row| row.rotate::<WIDTH>(1));
                }
            }
        }
    }
}
