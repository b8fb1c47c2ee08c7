//! The sites of a lattice as its executors see them: segments of the state, the flows that are applied to them, and how far
//! these reach. In a plane they are counted in rows.

use crate::{scalar::real::Real, state::precision::Precision};
use alloc::{vec, vec::Vec};

/// The state of a segment of sites or of rows, with the prepared constants of the lattice.
pub struct Sites<'m, R: Real, K: Precision, P> {
    pub(crate) q: &'m mut [K::Slot<R>],
    pub(crate) p: &'m mut [K::Slot<R>],
    pub(crate) parameters: &'m P,
    /// The index of the first site or row in the slices.
    pub(crate) first: usize,
    /// The number of sites or rows of the whole lattice.
    pub(crate) length: usize,
    /// The number of sites in a row: one on a line.
    pub(crate) columns: usize,
}

/// Returns the number of sites in a row of flat coordinates; `None` if the rows are not all of these.
///
/// `width` and `rows` are what the parameters say; without a width there is no number of rows.
#[inline(always)]
pub fn columns(width: usize, length: usize, rows: impl FnOnce() -> usize) -> Option<usize> {
    (width > 0 && rows().checked_mul(width) == Some(length)).then_some(width)
}

/// The half of the sites that a flow moves, and the half that it reads.
pub struct MovedSites<'m, R: Real, K: Precision, P> {
    pub(crate) read: &'m [K::Slot<R>],
    pub(crate) moved: &'m mut [K::Slot<R>],
    pub(crate) parameters: &'m P,
    /// The index of the first site or row in the slice that is read.
    pub(crate) first: usize,
    /// The index of the first row in the slice that is moved; on a line both begin at one site.
    pub(crate) first_moved: usize,
    /// The number of sites or rows of the whole lattice.
    pub(crate) length: usize,
    /// The number of sites in a row: one on a line.
    pub(crate) columns: usize,
    /// The contributions of rows to others, between passes over some of them.
    pub(crate) carries: Option<&'m mut RowCarries<R>>,
}

impl<'m, R: Real, K: Precision, P> Sites<'m, R, K, P> {
    /// Borrows the sites again.
    #[inline(always)]
    pub(crate) fn reborrow(&mut self) -> Sites<'_, R, K, P> {
        Sites { q: self.q, p: self.p, ..*self }
    }

    /// The sites or rows up to `border`, and those from there on.
    pub(crate) fn split_at(self, border: usize) -> (Self, Self) {
        let before = (border - self.first) * self.columns;
        let (q, q_after) = self.q.split_at_mut(before);
        let (p, p_after) = self.p.split_at_mut(before);
        (Self { q, p, ..self }, Self { q: q_after, p: p_after, first: border, ..self })
    }

    /// Returns the coordinates that a flow moves, with those that it reads: positions in a drift, momenta in a kick.
    #[inline(always)]
    pub(crate) fn moved_by(self, drifts: bool) -> MovedSites<'m, R, K, P> {
        let Self { q, p, parameters, first, length, columns } = self;
        let (read, moved): (&[_], _) = if drifts { (p, q) } else { (q, p) };
        MovedSites { read, moved, parameters, first, first_moved: first, length, columns, carries: None }
    }
}

/// The contributions of rows at which passes ended to the rows after them, where the next passes begin.
///
/// Each flow begins where it ended in the tile before, and the row determines to which flow its carry
/// belongs: the flow after one whose rows contribute to the next ones ends at least a row before it, so no two of these
/// end at one row.
pub(crate) struct RowCarries<R> {
    pub(crate) waiting: Vec<(usize, Vec<R>)>,
    /// Rows for others to write to.
    pub(crate) spare: Vec<Vec<R>>,
}

impl<R> Default for RowCarries<R> {
    fn default() -> Self {
        Self { waiting: Vec::new(), spare: Vec::new() }
    }
}

impl<R: Real> RowCarries<R> {
    /// The carry into a row, if a pass ended before it.
    pub(crate) fn take(&mut self, row: usize) -> Option<Vec<R>> {
        let place = self.waiting.iter().position(|(waiting, _)| *waiting == row)?;
        Some(self.waiting.swap_remove(place).1)
    }

    /// Forgets what no pass will take.
    pub(crate) fn forget(&mut self) {
        self.spare.extend(self.waiting.drain(..).map(|(_, carry)| carry));
    }

    /// A carry of nothing.
    pub(crate) fn zeros(&mut self, columns: usize) -> Vec<R> {
        match self.spare.pop() {
            Some(mut spare) => {
                spare.fill(R::of(0.0));
                spare
            }
            None => vec![R::of(0.0); columns],
        }
    }

    /// A carry that nothing reads.
    pub(crate) fn unread(&mut self, columns: usize) -> Vec<R> {
        self.spare.pop().unwrap_or_else(|| vec![R::of(0.0); columns])
    }
}

/// The boundary of a lattice in one direction, and the radius of its stencil.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Boundary {
    /// The number of sites at the beginning that differ from those of the interior.
    pub first: usize,
    /// The number of such sites at the end.
    pub last: usize,
    /// The largest forward offset of a contribution.
    pub forward: usize,
    /// The stencil's radius backwards: how far before a site its contributions depend on coordinates.
    pub behind: usize,
    /// The stencil's radius forwards.
    pub ahead: usize,
    /// Whether the last site is followed by the first.
    pub periodic: bool,
}

impl Boundary {
    /// Whether every site is like all others, and depends on itself alone.
    pub(crate) const fn is_pointwise(&self) -> bool {
        self.first == 0 && self.last == 0 && self.forward == 0 && self.behind == 0 && self.ahead == 0
    }

    /// Returns the distance, in sites to either side, over which the flow transports a coordinate.
    pub(crate) const fn reach(&self) -> usize {
        let behind = self.behind + self.forward;
        if behind > self.ahead { behind } else { self.ahead }
    }

    /// Returns the number of sites at an end that may differ from those of the interior.
    pub(crate) const fn ends(&self) -> usize {
        if self.first > self.last { self.first } else { self.last }
    }
}

/// One flow of a lattice.
#[derive(Clone, Copy, Debug)]
pub struct Flow {
    /// Whether it is the flow of `T`, which moves the positions.
    pub(crate) drifts: bool,
    pub(crate) duration: f64,
    pub(crate) time: f64,
}

/// The radii of the stencils of both flows.
#[derive(Clone, Copy, Debug)]
pub struct StencilRadii {
    pub(crate) drift: Boundary,
    pub(crate) kick: Boundary,
    /// Whether the radii are counted in layers: rows of a plane, or planes of a volume.
    pub(crate) of_layers: bool,
}

impl StencilRadii {
    /// Whether the last site or row is followed by the first.
    pub const fn periodic(&self) -> bool {
        self.drift.periodic || self.kick.periodic
    }

    /// Returns the distance, in sites or rows to either side, over which a drift and a kick transport a coordinate.
    pub const fn reach(&self) -> [usize; 2] {
        [self.drift.reach(), self.kick.reach()]
    }

    /// Returns the number of sites or rows at an end that may differ from those of the interior.
    pub const fn ends(&self) -> usize {
        let (drift, kick) = (self.drift.ends(), self.kick.ends());
        if drift > kick { drift } else { kick }
    }

    /// Returns the distances before and after a site within which a flow depends on coordinates.
    pub(crate) fn radius(&self, flow: &Flow) -> [usize; 2] {
        let boundary = if flow.drifts { &self.drift } else { &self.kick };
        [boundary.behind + boundary.forward, boundary.ahead]
    }
}
