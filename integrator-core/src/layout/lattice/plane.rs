//! Flows of planes: stencil passes along rows of sites, one row after the other.
//!
//! A pass hands the contributions of its row to the next one as a row carry, so that it computes every bond between
//! rows once. Where the plane is periodic, the contributions of the last row to the first one come last.

use crate::{
    layout::lattice::{
        stencil::{AdjacentRows, Drift, Kick, Stencil, StencilPass},
        window::{MAX_RADIUS, Window},
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
    pub fn drift_rows<H: Stencil<Drift, Parameters<R> = P>>(&mut self, duration: f64, time: f64) {
        let (read, moved, flow) = (C::slots(&self.p), C::slots_mut(&mut self.q), PhantomData::<(H, Drift)>);
        let (columns, parameters, step) = (C::COMPONENTS, &self.parameters, R::of(duration));
        R::enter(Plane { columns, read, moved, parameters, step, time, flow });
    }

    /// The flow of `V` of a plane.
    #[inline(always)]
    pub fn kick_rows<H: Stencil<Kick, Parameters<R> = P>>(&mut self, duration: f64, time: f64) {
        let (read, moved, flow) = (C::slots(&self.q), C::slots_mut(&mut self.p), PhantomData::<(H, Kick)>);
        let (columns, parameters, step) = (C::COMPONENTS, &self.parameters, R::of(-duration));
        R::enter(Plane { columns, read, moved, parameters, step, time, flow });
    }
}

/// A flow of a plane, row by row.
struct Plane<'m, H: Stencil<F>, F, R: Real, S> {
    /// The number of sites in a row.
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

impl<H: Stencil<F>, F, R: Real, S: Slot<R>> Kernel for Plane<'_, H, F, R, S> {
    type Out = ();

    #[inline(always)]
    fn call(self) {
        let Self { columns, read, moved, parameters, step, time, .. } = self;
        let Some(boundary) = H::ROW_BOUNDARY else { return };
        let rows = read.len().checked_div(columns).unwrap_or(0);
        let mut carry = vec![R::of(0.0); columns];
        let beyond = |row: usize| if boundary.periodic { Some(row) } else { None };
        let at = |row: Option<usize>| row.map_or(&read[..0], |row| &read[row * columns..][..columns]);
        for (row, moved) in moved.chunks_exact_mut(columns.max(1)).enumerate().take(rows) {
            let above = row.checked_sub(1).or(beyond(rows - 1));
            let below = Some(row + 1).filter(|below| *below < rows).or(beyond(0));
            let differs = row < boundary.first || row + boundary.last >= rows;
            let reads_beyond = boundary.behind > 0 && above.is_none() || boundary.ahead > 0 && below.is_none();
            let (at_boundary, read) = (differs || reads_beyond, [at(above), at(below)]);
            let adjacent = AdjacentRows { row, rows, at_boundary, read, carry: &mut carry };
            let (read, first, length, flow) = (at(Some(row)), 0, columns, PhantomData::<F>);
            StencilPass::<H, F, R, S> { read, moved, first, length, adjacent, parameters, step, time, flow }
                .apply(0..columns);
        }
        if boundary.periodic {
            for (slot, contribution) in moved.iter_mut().zip(carry) {
                slot.fma(step, contribution);
            }
        }
    }
}

impl<H: Stencil<F>, F, R: Real, S: Slot<R>> StencilPass<'_, H, F, R, S> {
    /// Moves blocks of a row's interior, as those of a line; the window slides along the adjacent rows too.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn interior_of_row<W: Block<R>>(
        &mut self,
        mut site: usize,
        count: usize,
        mut carry: [H::Contributions<W>; MAX_RADIUS],
    ) -> [H::Contributions<W>; MAX_RADIUS] {
        let [nearest, farthest] = Self::reads::<W>();
        let ([reads_above, reads_below], [above, below]) = (Self::READS_ADJACENT, self.adjacent.read);
        let (length, row, rows) = (self.length, self.adjacent.row, self.adjacent.rows);
        let before = site as isize - W::WIDTH as isize;
        let mut blocks = self.blocks_around::<W>(self.read, before);
        let mut adjacent = self.adjacent_blocks(blocks, before);
        // Slices of one length, so that no bounds are checked at a block. A row that the stencil does not read is not
        // read.
        let (sites, begin) = (count * W::WIDTH, site - self.first);
        let ahead = begin + (farthest - MAX_RADIUS) * W::WIDTH;
        let above = if reads_above { above } else { self.read };
        let below = if reads_below { below } else { self.read };
        let [above, here, below] = [above, self.read, below].map(|row| row[ahead..][..sites].chunks_exact(W::WIDTH));
        let moved = self.moved[begin..][..sites].chunks_exact_mut(W::WIDTH);
        let row_carry = self.adjacent.carry[begin..][..sites].chunks_exact_mut(W::WIDTH);
        for ((((above, here), below), moved), row_carry) in above.zip(here).zip(below).zip(moved).zip(row_carry) {
            blocks.copy_within(nearest + 1..=farthest, nearest);
            blocks[farthest] = S::read(here);
            if reads_above {
                adjacent[0].copy_within(nearest + 1..=farthest, nearest);
                adjacent[0][farthest] = S::read(above);
            }
            if reads_below {
                adjacent[1].copy_within(nearest + 1..=farthest, nearest);
                adjacent[1][farthest] = S::read(below);
            }
            let window = Window { blocks, adjacent, site, length, row, rows, at_boundary: false, scalar: PhantomData };
            let own = H::contributions::<R, W>(&window, self.parameters, self.time);
            S::update(moved, self.step, Self::sum(own, carry, row_carry));
            carry = [own, carry[0]];
            site += W::WIDTH;
        }
        carry
    }
}
