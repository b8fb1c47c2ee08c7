//! Flows of planes: stencil passes along rows of sites, one row after the other.
//!
//! A pass hands the contributions of its row to the next one as a row carry, so that it computes every bond between
//! rows once. Where the plane is periodic, the contributions of the last row to the first one come last. A pass over some
//! of the rows takes the carry of the pass that ended there, or computes the contributions of the row before once more,
//! from the same numbers.

use crate::{
    layout::lattice::{
        stencil::{AdjacentRows, Drift, Kick, Stencil, StencilPass},
        volume::Volume,
        window::{MAX_RADIUS, Window},
    },
    scalar::{
        real::{Kernel, Real},
        simd::block::Block,
    },
    state::{
        coords::Coords,
        precision::{Precision, Slot},
    },
    system::{
        System,
        motion::Plain,
        sites::{Boundary, Flow, MovedSites, RowCarries, Sites},
    },
};
use alloc::vec::Vec;
use core::{marker::PhantomData, ops::Range};

impl<R: Real, C: Coords, P> Plain<R, C, P> {
    /// The flow of `T` of a plane or a volume.
    #[inline(always)]
    pub fn drift_layers<H: Stencil<Drift, Parameters<R> = P>>(&mut self, duration: f64, time: f64) {
        let Some(layers) = self.layers::<H>() else { return };
        let layers = layers.moved_by(true);
        let range = 0..layers.length;
        layers.move_layers::<H, Drift>(R::of(duration), time, range);
    }

    /// The flow of `V` of a plane or a volume.
    #[inline(always)]
    pub fn kick_layers<H: Stencil<Kick, Parameters<R> = P>>(&mut self, duration: f64, time: f64) {
        let Some(layers) = self.layers::<H>() else { return };
        let layers = layers.moved_by(false);
        let range = 0..layers.length;
        layers.move_layers::<H, Kick>(R::of(-duration), time, range);
    }

    /// All layers: the rows of a plane, or the planes of a volume; `None` if flat coordinates are no rows.
    #[inline(always)]
    pub fn layers<H: System<Parameters<R> = P>>(&mut self) -> Option<Sites<'_, R, C::Leaf, P>> {
        let sites = self.sites();
        let columns = H::columns::<R>(sites.parameters, sites.length)?;
        Some(Sites { columns, length: sites.length.checked_div(columns).unwrap_or(0), ..sites })
    }
}

impl<R: Real, K: Precision, P> MovedSites<'_, R, K, P> {
    /// Applies a flow to some `layers`.
    #[inline(always)]
    pub fn apply_to_layers<H>(self, flow: &Flow, layers: Range<usize>)
    where
        H: Stencil<Drift, Parameters<R> = P> + Stencil<Kick, Parameters<R> = P>,
    {
        if flow.drifts {
            self.move_layers::<H, Drift>(R::of(flow.duration), flow.time, layers);
        } else {
            self.move_layers::<H, Kick>(R::of(-flow.duration), flow.time, layers);
        }
    }

    #[inline(always)]
    fn move_layers<H: Stencil<F, Parameters<R> = P>, F>(self, step: R, time: f64, range: Range<usize>) {
        let Self { read, moved, parameters, first, first_moved, length: rows, columns, carries } = self;
        let moved = &mut moved[(range.start - first_moved) * columns..][..range.len() * columns];
        let flow = PhantomData::<(H, F)>;
        let mut none = RowCarries::default();
        let carries = carries.unwrap_or(&mut none);
        let around = AdjacentPlanes::none();
        let layers = Plane { columns, rows, first, range, around, read, moved, carries, parameters, step, time, flow };
        // A constant, so that nothing is compiled of volumes for planes.
        if const { H::PLANE_BOUNDARY.is_some() } { R::enter(Volume(layers)) } else { R::enter(layers) }
    }
}

/// The planes adjacent to one of a volume.
#[derive(Clone, Copy)]
pub(super) struct AdjacentPlanes<'m, S> {
    /// The index of the plane, and the number of planes.
    pub(super) plane: [usize; 2],
    /// Whether the plane differs from those of the volume's interior.
    pub(super) at_boundary: bool,
    /// The coordinates that the flow depends on in the planes before and after; nothing beyond an end.
    pub(super) read: [&'m [S]; 2],
}

impl<S> AdjacentPlanes<'_, S> {
    /// A plane that is no volume's has none.
    #[inline(always)]
    pub(super) fn none() -> Self {
        Self { plane: [0, 1], at_boundary: false, read: [&[]; 2] }
    }
}

/// A flow of some rows of a plane, or of some planes of a volume in place of rows.
pub(super) struct Plane<'m, H: Stencil<F>, F, R: Real, S> {
    /// The number of sites in a row.
    pub(super) columns: usize,
    /// The number of rows of the whole plane.
    pub(super) rows: usize,
    /// The index of the first row in the slice that is read.
    pub(super) first: usize,
    /// The rows that are moved.
    pub(super) range: Range<usize>,
    pub(super) around: AdjacentPlanes<'m, S>,
    /// The coordinates that the flow depends on, row by row.
    pub(super) read: &'m [S],
    /// The coordinates that the flow moves, in the rows that are moved.
    pub(super) moved: &'m mut [S],
    pub(super) carries: &'m mut RowCarries<R>,
    pub(super) parameters: &'m H::Parameters<R>,
    pub(super) step: R,
    pub(super) time: f64,
    pub(super) flow: PhantomData<(H, F)>,
}

impl<H: Stencil<F>, F, R: Real, S: Slot<R>> Plane<'_, H, F, R, S> {
    /// Whether a row contributes to the next one.
    const CARRIES: bool = StencilPass::<H, F, R, S>::CARRIES_BETWEEN_ROWS;

    /// Whether the last row contributes to the first one.
    const CLOSED: bool = Self::CARRIES && matches!(H::ROW_BOUNDARY, Some(Boundary { periodic: true, .. }));

    /// The rows above and below one of them that it depends on, if there are any, and whether it differs from those of the
    /// interior.
    #[inline(always)]
    pub(super) fn beside(&self, row: usize, boundary: Boundary) -> ([Option<usize>; 2], bool) {
        let beyond = |row: usize| if boundary.periodic { Some(row) } else { None };
        let above = if boundary.behind > 0 { row.checked_sub(1).or(beyond(self.rows - 1)) } else { None };
        let below =
            if boundary.ahead > 0 { Some(row + 1).filter(|below| *below < self.rows).or(beyond(0)) } else { None };
        let differs = row < boundary.first || row + boundary.last >= self.rows;
        let reads_beyond = boundary.behind > 0 && above.is_none() || boundary.ahead > 0 && below.is_none();
        ([above, below], differs || reads_beyond)
    }

    /// A row of the coordinates that the flow depends on; nothing beyond an end.
    #[inline(always)]
    pub(super) fn at(&self, row: Option<usize>) -> &[S] {
        row.map_or(&self.read[..0], |row| self.row_of(self.read, row))
    }

    /// A row of a plane; nothing where there is no plane.
    #[inline(always)]
    fn row_of<'s>(&self, plane: &'s [S], row: usize) -> &'s [S] {
        plane.get((row - self.first) * self.columns..).map_or(&[], |rows| &rows[..self.columns.min(rows.len())])
    }

    /// Moves a row, and leaves in `carry` its contributions to the next one.
    #[inline(always)]
    fn pass(&self, row: usize, moved: &mut [S], carry: &mut [R]) {
        if let Some(pass) = self.along(row, moved, carry) {
            pass.apply(0..self.columns);
        }
    }

    /// The pass along a row.
    #[inline(always)]
    pub(super) fn along<'p>(
        &'p self,
        row: usize,
        moved: &'p mut [S],
        carry: &'p mut [R],
    ) -> Option<StencilPass<'p, H, F, R, S>> {
        let ([above, below], differs) = self.beside(row, H::ROW_BOUNDARY?);
        let AdjacentPlanes { plane, at_boundary, read: [before, behind] } = self.around;
        let at_boundary = at_boundary || differs;
        let read = [self.at(above), self.at(below), self.row_of(before, row), self.row_of(behind, row)];
        let adjacent = AdjacentRows { row, rows: self.rows, plane, at_boundary, read, carry };
        let (read, first, length, flow) = (self.at(Some(row)), 0, self.columns, PhantomData::<F>);
        let Self { parameters, step, time, .. } = *self;
        Some(StencilPass { read, moved, first, length, adjacent, parameters, step, time, flow })
    }

    /// The row whose contributions arrive at the first one that is moved, where it is not moved itself: the one before, or the
    /// last row of a plane that is closed.
    #[inline(always)]
    fn row_before(&self) -> Option<usize> {
        let Range { start, end } = self.range;
        match start.checked_sub(1) {
            _ if !Self::CARRIES => None,
            None if Self::CLOSED && end < self.rows => Some(self.rows - 1),
            before => before,
        }
    }
}

impl<H: Stencil<F>, F, R: Real, S: Slot<R>> Kernel for Plane<'_, H, F, R, S> {
    type Out = ();

    #[inline(always)]
    fn call(mut self) {
        let (columns, Range { start, end }) = (self.columns, self.range.clone());
        if start >= end || columns == 0 {
            return;
        }
        let before = self.row_before();
        let known = before.and_then(|row| self.carries.take(row + 1));
        // A row that is not moved, and is passed for its contributions alone.
        let mut passed = before.filter(|_| known.is_none());
        let mut unmoved = passed.map_or(Vec::new(), |row| self.at(Some(row)).to_vec());
        let mut carry = match known {
            Some(carry) => carry,
            None if Self::CARRIES => self.carries.zeros(columns),
            None => self.carries.unread(columns),
        };
        let moving = core::mem::take(&mut self.moved);
        let mut around = None;
        let mut row = start;
        while row < end {
            if row == 0 && before.is_some() && passed.is_none() {
                around = Some(core::mem::replace(&mut carry, self.carries.zeros(columns)));
            }
            // One place where rows are passed: the text of a stencil is long.
            let here = (row - start) * columns..(row - start + 1) * columns;
            let slots = if passed.is_some() { &mut unmoved[..] } else { &mut moving[here] };
            self.pass(passed.unwrap_or(row), slots, &mut carry);
            row += usize::from(passed.take().is_none());
        }
        if Self::CLOSED && start == 0 {
            let around = around.as_ref().unwrap_or(&carry);
            for (slot, contribution) in moving.iter_mut().zip(around) {
                slot.fma(self.step, *contribution);
            }
        }
        let RowCarries { waiting, spare } = self.carries;
        spare.extend(around);
        if Self::CARRIES && (end < self.rows || Self::CLOSED && start > 0) {
            waiting.push((end, carry));
        } else {
            spare.push(carry);
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
        let before = site as isize - W::WIDTH as isize;
        let mut blocks = self.blocks_around::<W>(self.read, before);
        let mut adjacent = self.adjacent_blocks(blocks, before);
        // Slices of one length, so that no bounds are checked at a block. A row that the stencil does not read is not
        // read.
        let (sites, begin) = (count * W::WIDTH, site - self.first);
        let ahead = begin + (farthest - MAX_RADIUS) * W::WIDTH;
        let of_row = |row: usize| {
            let read = if Self::READS_ADJACENT[row] { self.adjacent.read[row] } else { self.read };
            read[ahead..][..sites].chunks_exact(W::WIDTH)
        };
        let here = self.read[ahead..][..sites].chunks_exact(W::WIDTH);
        let here = here.zip(of_row(0).zip(of_row(1))).zip(of_row(2).zip(of_row(3)));
        let row = self.row();
        let moved = self.moved[begin..][..sites].chunks_exact_mut(W::WIDTH);
        let row_carry = self.adjacent.carry[begin..][..sites].chunks_exact_mut(W::WIDTH);
        for ((((here, (above, below)), (previous, next)), moved), row_carry) in here.zip(moved).zip(row_carry) {
            blocks.copy_within(nearest + 1..=farthest, nearest);
            blocks[farthest] = S::read(here);
            let mut slide = |row: usize, read| {
                if Self::READS_ADJACENT[row] {
                    adjacent[row].copy_within(nearest + 1..=farthest, nearest);
                    adjacent[row][farthest] = S::read(read);
                }
            };
            slide(0, above);
            slide(1, below);
            slide(2, previous);
            slide(3, next);
            let window = Window { blocks, adjacent, site, row, at_boundary: false, scalar: PhantomData };
            let own = H::contributions::<R, W>(&window, self.parameters, self.time);
            S::update(moved, self.step, Self::sum(own, carry, row_carry));
            carry = [own, carry[0]];
            site += W::WIDTH;
        }
        carry
    }
}
