//! Stencil passes over lattices in gather form: a site gets all addends in one pass, and each of them is computed once.
//!
//! Each site computes contributions from its neighbourhood, those of the bond to the next site for instance: one to
//! itself and others to later sites. A pass carries them forward, so that it fills no buffer and computes no bond
//! twice; in a plane it runs along a row, and the contributions of the row to the next one are a row carry. A site adds
//! its contributions in the order of their offsets, whatever the width of a block is and wherever a pass begins, and so
//! are the bits.

use crate::{
    layout::lattice::window::{ADJACENT, Blocks, MAX_RADIUS, RowPosition, Window},
    scalar::{
        real::Real,
        simd::block::{Block, WIDEST},
    },
    state::precision::Slot,
    system::{
        System,
        sites::{Boundary, StencilRadii},
    },
};
use core::{marker::PhantomData, ops::Range};

/// The flow of `T`, as a parameter of [`Stencil`].
pub struct Drift;

/// The flow of `V`, as a parameter of [`Stencil`].
pub struct Kick;

/// Whether a stencil reads earlier and later sites along a direction that the lattice may not have.
const fn is_read(boundary: Option<Boundary>) -> [bool; 2] {
    match boundary {
        Some(boundary) => [boundary.behind > 0, boundary.ahead > 0],
        None => [false; 2],
    }
}

/// Whether no site depends on others along such a direction.
const fn is_pointwise(boundary: Option<Boundary>) -> bool {
    match boundary {
        Some(boundary) => boundary.is_pointwise(),
        None => true,
    }
}

/// The stencil of a flow: what every site of a lattice computes from its neighbourhood. Written by `#[hamiltonian]`;
/// `F` is [`Drift`] or [`Kick`].
pub trait Stencil<F>: System {
    /// The contributions of a site: element `k` is an addend of the site at the forward offset `k`. After the farthest
    /// of these come those for the next row: for the site below, and for the ones after that.
    type Contributions<W: Copy>: Array<W>;

    /// The boundary along a line or a row.
    const BOUNDARY: Boundary;

    /// The boundary across the rows of a plane.
    const ROW_BOUNDARY: Option<Boundary> = None;

    /// The boundary across planes; no contribution goes to another one.
    const PLANE_BOUNDARY: Option<Boundary> = None;

    /// The contributions of a block of sites.
    fn contributions<R: Real, W: Block<R>>(
        window: &Window<R, W>,
        parameters: &Self::Parameters<R>,
        time: f64,
    ) -> Self::Contributions<W>;
}

impl StencilRadii {
    /// The radii of the flows of `H`: across planes, across the rows of a plane, or else along a line.
    pub const fn of<H: Stencil<Drift> + Stencil<Kick>>() -> Self {
        let rows = Self::across(<H as Stencil<Drift>>::ROW_BOUNDARY, <H as Stencil<Kick>>::ROW_BOUNDARY);
        let planes = Self::across(<H as Stencil<Drift>>::PLANE_BOUNDARY, <H as Stencil<Kick>>::PLANE_BOUNDARY);
        match (planes, rows) {
            (Some(layers), _) | (None, Some(layers)) => layers,
            (None, None) => {
                let (drift, kick) = (<H as Stencil<Drift>>::BOUNDARY, <H as Stencil<Kick>>::BOUNDARY);
                Self { drift, kick, of_layers: false }
            }
        }
    }

    /// The radii across layers, if both flows have these.
    const fn across(drift: Option<Boundary>, kick: Option<Boundary>) -> Option<Self> {
        match (drift, kick) {
            (Some(drift), Some(kick)) => Some(Self { drift, kick, of_layers: true }),
            _ => None,
        }
    }
}

/// A stencil pass over slices of sites: a whole line, a segment of one, or a row of a plane.
pub(crate) struct StencilPass<'m, H: System, F, R: Real, S> {
    /// The coordinates that the flow depends on.
    pub(crate) read: &'m [S],
    /// The coordinates that the flow moves.
    pub(crate) moved: &'m mut [S],
    /// The index of the first site in the slices.
    pub(crate) first: usize,
    /// The number of sites in the line or in a row.
    pub(crate) length: usize,
    pub(crate) adjacent: AdjacentRows<'m, R, S>,
    pub(crate) parameters: &'m H::Parameters<R>,
    pub(crate) step: R,
    pub(crate) time: f64,
    pub(crate) flow: PhantomData<F>,
}

/// The rows adjacent to the one that a pass runs along, and the carry between them.
pub(crate) struct AdjacentRows<'m, R, S> {
    /// The index of the row that the pass runs along.
    pub(crate) row: usize,
    /// The number of rows.
    pub(crate) rows: usize,
    /// The index of its plane, and the number of planes.
    pub(crate) plane: [usize; 2],
    /// Whether the row differs from those of the lattice's interior.
    pub(crate) at_boundary: bool,
    /// The coordinates that the flow depends on in the rows above and below, and in the same row of the planes before and
    /// after; nothing beyond an end.
    pub(crate) read: [&'m [S]; ADJACENT],
    /// The contributions of the row above to this one; after the pass those of this one to the row below.
    pub(crate) carry: &'m mut [R],
}

impl<R, S> AdjacentRows<'_, R, S> {
    /// A line has no adjacent rows.
    #[inline(always)]
    pub(crate) fn none() -> Self {
        Self { row: 0, rows: 1, plane: [0, 1], at_boundary: false, read: [&[]; ADJACENT], carry: &mut [] }
    }
}

impl<H: Stencil<F>, F, R: Real, S: Slot<R>> StencilPass<'_, H, F, R, S> {
    /// Whether the stencil reads each of the adjacent rows.
    pub(crate) const READS_ADJACENT: [bool; ADJACENT] = {
        let [above, below] = is_read(H::ROW_BOUNDARY);
        let [before, behind] = is_read(H::PLANE_BOUNDARY);
        [above, below, before, behind]
    };

    /// Whether a row contributes to the next one.
    pub(crate) const CARRIES_BETWEEN_ROWS: bool = matches!(H::ROW_BOUNDARY, Some(Boundary { forward: 1.., .. }));

    /// Whether every site depends on itself alone, as for a kinetic energy that is a sum of squares.
    const POINTWISE: bool =
        H::BOUNDARY.is_pointwise() && is_pointwise(H::ROW_BOUNDARY) && is_pointwise(H::PLANE_BOUNDARY);

    /// Moves the coordinates of `sites`: whole blocks, then one by one the sites that fill none.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn apply(mut self, sites: Range<usize>) {
        let rest = self.apply_blocks::<S::Wide>(sites.clone());
        if const { S::Wide::WIDTH > 1 } && rest < sites.end {
            self.apply_rest(rest..sites.end);
        }
    }

    /// Moves whole blocks of `sites`, and returns where they end.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn apply_blocks<W: Block<R>>(&mut self, sites: Range<usize>) -> usize {
        let (mut site, end) = (sites.start, sites.end);
        if site + W::WIDTH > end {
            return site;
        }
        if const { Self::POINTWISE } {
            let blocks = (end - site) / W::WIDTH;
            self.interior::<W>(site, blocks, Self::zero_carry());
            return site + blocks * W::WIDTH;
        }
        // What the last block of a ring hands on to the first one is its own in the end.
        let last = self.last_of_ring::<W>(&sites);
        let mut carry = match last {
            Some(own) => [own; MAX_RADIUS],
            None => self.carry_into::<W>(site),
        };
        while site < H::BOUNDARY.first && site + W::WIDTH <= end {
            carry = self.boundary_block(site, carry, None);
            site += W::WIDTH;
        }
        let blocks = self.interior_blocks::<W>(site..end);
        if blocks > 0 {
            carry = self.interior(site, blocks, carry);
            site += blocks * W::WIDTH;
        }
        while site + W::WIDTH <= end {
            carry = self.boundary_block(site, carry, if site + W::WIDTH == end { last } else { None });
            site += W::WIDTH;
        }
        site
    }

    /// The contributions of the last block, where `sites` are a ring of blocks whose last one is followed by the first.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn last_of_ring<W: Block<R>>(&self, sites: &Range<usize>) -> Option<H::Contributions<W>> {
        let is_ring = const { W::WIDTH > 1 && H::BOUNDARY.periodic && H::BOUNDARY.forward > 0 };
        let is_whole = *sites == (0..self.length) && self.length.is_multiple_of(W::WIDTH);
        if is_ring && is_whole { Some(self.boundary_contributions(self.length - W::WIDTH)) } else { None }
    }

    /// Moves sites that fill no block. One by one, which is less code; those of a row, of which there may be as many as of others,
    /// along a window.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn apply_rest(&mut self, sites: Range<usize>) {
        if const { Self::POINTWISE || H::ROW_BOUNDARY.is_some() } {
            self.apply_blocks::<R>(sites);
        } else {
            let mut carry = self.carry_into::<R>(sites.start);
            for site in sites {
                carry = self.boundary_block(site, carry, None);
            }
        }
    }

    /// The number of interior blocks from the beginning of `sites` on: those without a site of the boundary at the end,
    /// whose windows lie within the slices.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn interior_blocks<W: Block<R>>(&self, sites: Range<usize>) -> usize {
        if self.adjacent.at_boundary {
            return 0;
        }
        let [_, farthest] = Self::reads::<W>();
        let readable = (self.first + self.read.len()).saturating_sub((farthest - MAX_RADIUS) * W::WIDTH);
        let end = self.length.saturating_sub(H::BOUNDARY.last).min(readable).min(sites.end);
        end.saturating_sub(sites.start) / W::WIDTH
    }

    /// Moves a block that may have sites of the boundary, whose own contributions may be known; `carry` as in
    /// [`Self::interior`].
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn boundary_block<W: Block<R>>(
        &mut self,
        site: usize,
        carry: [H::Contributions<W>; MAX_RADIUS],
        own: Option<H::Contributions<W>>,
    ) -> [H::Contributions<W>; MAX_RADIUS] {
        let own = match own {
            Some(own) => own,
            None => self.boundary_contributions(site),
        };
        let begin = site - self.first;
        let row_carry = if const { H::ROW_BOUNDARY.is_some() } { &mut self.adjacent.carry[begin..] } else { &mut [] };
        S::update(&mut self.moved[begin..], self.step, Self::sum(own, carry, row_carry));
        [own, carry[0]]
    }

    /// Moves blocks of the interior; `carry` has the contributions of the sites before them, nearest first. A window
    /// slides along, so that the pass reads every coordinate once.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn interior<W: Block<R>>(
        &mut self,
        mut site: usize,
        count: usize,
        mut carry: [H::Contributions<W>; MAX_RADIUS],
    ) -> [H::Contributions<W>; MAX_RADIUS] {
        if const { H::ROW_BOUNDARY.is_some() && !Self::POINTWISE } {
            return self.interior_of_row(site, count, carry);
        }
        let [nearest, farthest] = Self::reads::<W>();
        let (begin, row) = (site - self.first, self.row());
        let mut blocks = [W::of(0.0); 2 * MAX_RADIUS + 1];
        if const { !Self::POINTWISE } {
            blocks = self.blocks_around(self.read, site as isize - W::WIDTH as isize);
        }
        // Slices of one length, so that no bounds are checked at a block.
        let sites = count * W::WIDTH;
        let mut read = &self.read[begin + (farthest - MAX_RADIUS) * W::WIDTH..][..sites];
        let mut moved = &mut self.moved[begin..][..sites];
        while read.len() >= W::WIDTH && moved.len() >= W::WIDTH {
            for index in nearest..farthest {
                blocks[index] = blocks[index + 1];
            }
            blocks[farthest] = S::read(read);
            let adjacent = [blocks; ADJACENT];
            let window = Window { blocks, adjacent, site, row, at_boundary: false, scalar: PhantomData };
            let own = H::contributions::<R, W>(&window, self.parameters, self.time);
            S::update(moved, self.step, Self::sum(own, carry, &mut []));
            carry = [own, carry[0]];
            site += W::WIDTH;
            read = &read[W::WIDTH..];
            moved = &mut moved[W::WIDTH..];
        }
        carry
    }

    /// The sum of all contributions to a block of sites: its own, the `carry` from the sites before it, and the row
    /// carry, in whose place the contributions to the row below are written.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn sum<W: Block<R>>(
        own: H::Contributions<W>,
        carry: [H::Contributions<W>; MAX_RADIUS],
        row_carry: &mut [R],
    ) -> W {
        let below = H::BOUNDARY.forward + 1;
        let mut sum = Self::sum_of(0..below, own, carry);
        if const { Self::CARRIES_BETWEEN_ROWS } {
            sum += W::read(row_carry);
            Self::sum_of(below..own.as_ref().len(), own, carry).write(row_carry);
        }
        sum
    }

    /// The sum of those contributions, in this order, that arrive at a block of sites.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn sum_of<W: Block<R>>(
        indices: Range<usize>,
        own: H::Contributions<W>,
        carry: [H::Contributions<W>; MAX_RADIUS],
    ) -> W {
        let mut sum = own.as_ref()[indices.start];
        for index in indices.start + 1..indices.end {
            let [nearest, farther] = carry;
            let carry = [nearest.as_ref()[index], farther.as_ref()[index]];
            sum += shifted::<R, W>(index - indices.start, own.as_ref()[index], carry);
        }
        sum
    }

    /// The contributions of the sites before `site`, as if the pass came from there.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn carry_into<W: Block<R>>(&self, site: usize) -> [H::Contributions<W>; MAX_RADIUS] {
        let mut carry = Self::zero_carry::<W>();
        for nearer in 0..H::BOUNDARY.forward {
            let behind = H::BOUNDARY.forward - nearer;
            let before = match site.checked_sub(behind) {
                None if H::BOUNDARY.periodic => (site + MAX_RADIUS * self.length - behind) % self.length,
                None => continue,
                Some(before) => before,
            };
            let own = self.boundary_contributions::<R>(before);
            let [nearest, farther] = &mut carry;
            *farther = *nearest;
            for index in 1..own.as_ref().len() {
                let own = W::splat(own.as_ref()[index]);
                // In blocks of one site the farther contribution is a block of its own.
                let nearest = &mut nearest.as_mut()[index];
                *nearest = nearest.after(own);
            }
        }
        carry
    }

    /// The carry where no site contributes.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn zero_carry<W: Block<R>>() -> [H::Contributions<W>; MAX_RADIUS] {
        [H::Contributions::<W>::filled(W::of(0.0)); MAX_RADIUS]
    }

    /// The contributions of a block, at the boundary or not.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn contributions<W: Block<R>>(&self, site: usize) -> H::Contributions<W> {
        let boundary = H::BOUNDARY;
        let is_inside = site >= boundary.first.max(boundary.behind)
            && site + W::WIDTH + boundary.last.max(boundary.ahead) <= self.length;
        self.contributions_at(site, self.adjacent.at_boundary || !is_inside)
    }

    /// The contributions of a block that may have sites of the boundary.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn boundary_contributions<W: Block<R>>(&self, site: usize) -> H::Contributions<W> {
        self.contributions_at(site, true)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn contributions_at<W: Block<R>>(&self, site: usize, at_boundary: bool) -> H::Contributions<W> {
        let blocks = self.blocks_around(self.read, site as isize);
        let is_plane = const { H::ROW_BOUNDARY.is_some() };
        let adjacent = if is_plane { self.adjacent_blocks(blocks, site as isize) } else { [blocks; ADJACENT] };
        let row = self.row();
        let window = Window { blocks, adjacent, site, row, at_boundary, scalar: PhantomData };
        H::contributions::<R, W>(&window, self.parameters, self.time)
    }

    /// Returns the position of the row.
    #[inline(always)]
    pub(crate) fn row(&self) -> RowPosition {
        let (length, AdjacentRows { row, rows, plane, .. }) = (self.length, &self.adjacent);
        RowPosition { length, row: *row, rows: *rows, plane: *plane }
    }

    /// The indices in [`Window::blocks`] of the first and the last block that the stencil reads.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn reads<W: Block<R>>() -> [usize; 2] {
        [MAX_RADIUS - H::BOUNDARY.behind.div_ceil(W::WIDTH), MAX_RADIUS + H::BOUNDARY.ahead.div_ceil(W::WIDTH)]
    }

    /// The window's blocks of a row around the block that begins at `site`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn blocks_around<W: Block<R>>(&self, row: &[S], site: isize) -> Blocks<W> {
        let [nearest, farthest] = Self::reads::<W>();
        let mut blocks = [self.block_at::<W>(row, site); 2 * MAX_RADIUS + 1];
        for distance in 1..MAX_RADIUS + 1 {
            let offset = (distance * W::WIDTH) as isize;
            if MAX_RADIUS >= nearest + distance {
                blocks[MAX_RADIUS - distance] = self.block_at(row, site - offset);
            }
            if MAX_RADIUS + distance <= farthest {
                blocks[MAX_RADIUS + distance] = self.block_at(row, site + offset);
            }
        }
        blocks
    }

    /// The window's blocks of the adjacent rows, where the stencil reads them.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn adjacent_blocks<W: Block<R>>(&self, blocks: Blocks<W>, site: isize) -> [Blocks<W>; ADJACENT] {
        // Written out, so that all windows stay in registers.
        let of_row = |row: usize| {
            if Self::READS_ADJACENT[row] { self.blocks_around(self.adjacent.read[row], site) } else { blocks }
        };
        [of_row(0), of_row(1), of_row(2), of_row(3)]
    }

    /// The block of coordinates that begins at a site, which may lie beyond an end.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn block_at<W: Block<R>>(&self, row: &[S], site: isize) -> W {
        let length = self.length as isize;
        let site = match site {
            _ if !H::BOUNDARY.periodic => site,
            behind if behind < 0 => behind + length,
            ahead if ahead >= length => ahead - length,
            inside => inside,
        };
        let begin = site - self.first as isize;
        if begin >= 0 && begin as usize + W::WIDTH <= row.len() {
            return S::read(&row[begin as usize..]);
        }
        let mut numbers = [R::of(0.0); WIDEST];
        for (offset, number) in numbers[..W::WIDTH].iter_mut().enumerate() {
            // No division, where it would be one for each site of a block: a ring is as long as one at least.
            let site = match site + offset as isize {
                site if !H::BOUNDARY.periodic => site,
                site if W::WIDTH == 1 => site.rem_euclid(length),
                behind if behind < 0 => behind + length,
                ahead if ahead >= length => ahead - length,
                inside => inside,
            };
            let at = site - self.first as isize;
            if at >= 0 && (at as usize) < row.len() {
                *number = row[at as usize].value();
            }
        }
        W::read(&numbers)
    }
}

/// The contributions of one forward offset, shifted onto the sites that they go to: the block's own, and those carried
/// to it.
#[cfg_attr(not(debug_assertions), inline(always))]
fn shifted<R: Real, W: Block<R>>(forward: usize, own: W, carry: [W; MAX_RADIUS]) -> W {
    let [nearest, _] = carry;
    match (forward, W::WIDTH) {
        (_, 1) => carry[forward - 1],
        (1, _) => own.before(nearest),
        _ => own.before(nearest).before(nearest.before(nearest)),
    }
}

/// An array whose length the generator chose.
pub trait Array<T>: AsRef<[T]> + AsMut<[T]> + Copy {
    /// The array with every element equal to `with`.
    fn filled(with: T) -> Self;
}

impl<T: Copy, const N: usize> Array<T> for [T; N] {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn filled(with: T) -> Self {
        [with; N]
    }
}
