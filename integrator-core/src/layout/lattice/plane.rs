//! Flows of planes: rows of sites, swept one after the other.
//!
//! A sweep along a row passes on to the next one what the two share, so that every bond between rows is computed once.
//! What the last row shares with the first one, where it is followed by that, comes last.

use crate::{
    layout::lattice::{
        stencil::{Beside, Drift, Gather, Kick, Sweep},
        window::{FARTHEST, Neighbours},
    },
    scalar::{
        real::{Kernel, Real},
        simd::block::Block,
    },
    state::{coords::Coords, precision::Slot},
    system::motion::Plain,
};
use alloc::vec;
use core::marker::PhantomData;

impl<R: Real, C: Coords, P> Plain<R, C, P> {
    /// The flow of `T` of a plane.
    #[inline(always)]
    pub fn drift_rows<H: Gather<Drift, Parameters<R> = P>>(&mut self, duration: f64, time: f64) {
        let (read, moved, flow) = (C::slots(&self.p), C::slots_mut(&mut self.q), PhantomData::<(H, Drift)>);
        let (columns, parameters, step) = (C::COMPONENTS, &self.parameters, R::of(duration));
        R::enter(Plane { columns, read, moved, parameters, step, time, flow });
    }

    /// The flow of `V` of a plane.
    #[inline(always)]
    pub fn kick_rows<H: Gather<Kick, Parameters<R> = P>>(&mut self, duration: f64, time: f64) {
        let (read, moved, flow) = (C::slots(&self.q), C::slots_mut(&mut self.p), PhantomData::<(H, Kick)>);
        let (columns, parameters, step) = (C::COMPONENTS, &self.parameters, R::of(-duration));
        R::enter(Plane { columns, read, moved, parameters, step, time, flow });
    }
}

/// A flow on its way over all rows of a plane.
struct Plane<'m, H: Gather<F>, F, R: Real, S> {
    /// How many sites a row has.
    columns: usize,
    /// The coordinates that the flow depends on, row by row.
    read: &'m [S],
    /// Those that it moves.
    moved: &'m mut [S],
    parameters: &'m H::Parameters<R>,
    step: R,
    time: f64,
    flow: PhantomData<(H, F)>,
}

impl<H: Gather<F>, F, R: Real, S: Slot<R>> Kernel for Plane<'_, H, F, R, S> {
    type Out = ();

    #[inline(always)]
    fn call(self) {
        let Self { columns, read, moved, parameters, step, time, .. } = self;
        let Some(edges) = H::ROWS else { return };
        let rows = read.len().checked_div(columns).unwrap_or(0);
        let mut passed = vec![R::of(0.0); columns];
        let beyond = |row: usize| if edges.periodic { Some(row) } else { None };
        let at = |row: Option<usize>| row.map_or(&read[..0], |row| &read[row * columns..][..columns]);
        for (row, moved) in moved.chunks_exact_mut(columns.max(1)).enumerate().take(rows) {
            let above = row.checked_sub(1).or(beyond(rows - 1));
            let below = Some(row + 1).filter(|below| *below < rows).or(beyond(0));
            let own = row < edges.first || row + edges.last >= rows;
            let beyond_an_end = edges.behind > 0 && above.is_none() || edges.ahead > 0 && below.is_none();
            let beside =
                Beside { row, rows, edge: own || beyond_an_end, read: [at(above), at(below)], passed: &mut passed };
            let (read, first, length, flow) = (at(Some(row)), 0, columns, PhantomData::<F>);
            Sweep::<H, F, R, S> { read, moved, first, length, beside, parameters, step, time, flow }.over(0..columns);
        }
        if edges.periodic {
            for (slot, share) in moved.iter_mut().zip(passed) {
                slot.fma(step, share);
            }
        }
    }
}

impl<H: Gather<F>, F, R: Real, S: Slot<R>> Sweep<'_, H, F, R, S> {
    /// Moves blocks of a row that are alike, as those of a line; windows go along in the rows beside it too.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn middle_of_row<W: Block<R>>(
        &mut self,
        mut site: usize,
        blocks: usize,
        mut carried: [H::Shares<W>; FARTHEST],
    ) -> [H::Shares<W>; FARTHEST] {
        let [nearest, farthest] = Self::window::<W>();
        let ([looks_above, looks_below], [above, below]) = (Self::LOOKED_AT, self.beside.read);
        let (length, row, rows) = (self.length, self.beside.row, self.beside.rows);
        let before = site as isize - W::WIDTH as isize;
        let mut around = self.around::<W>(self.read, before);
        let mut beside = self.beside(around, before);
        // Slices of one length, so that nothing is asked at a block. What is not looked at is never read.
        let (sites, begin) = (blocks * W::WIDTH, site - self.first);
        let ahead = begin + (farthest - FARTHEST) * W::WIDTH;
        let above = if looks_above { above } else { self.read };
        let below = if looks_below { below } else { self.read };
        let [above, here, below] = [above, self.read, below].map(|row| row[ahead..][..sites].chunks_exact(W::WIDTH));
        let moved = self.moved[begin..][..sites].chunks_exact_mut(W::WIDTH);
        let passed = self.beside.passed[begin..][..sites].chunks_exact_mut(W::WIDTH);
        for ((((above, here), below), moved), passed) in above.zip(here).zip(below).zip(moved).zip(passed) {
            around.copy_within(nearest + 1..=farthest, nearest);
            around[farthest] = S::read(here);
            if looks_above {
                beside[0].copy_within(nearest + 1..=farthest, nearest);
                beside[0][farthest] = S::read(above);
            }
            if looks_below {
                beside[1].copy_within(nearest + 1..=farthest, nearest);
                beside[1][farthest] = S::read(below);
            }
            let near = Neighbours { around, beside, site, length, row, rows, edge: false, scalar: PhantomData };
            let found = H::shares::<R, W>(&near, self.parameters, self.time);
            S::update(moved, self.step, Self::sum(found, carried, passed));
            carried = [found, carried[0]];
            site += W::WIDTH;
        }
        carried
    }
}
