//! Segments of a lattice, which threads advance concurrently.

use crate::{
    scalar::real::Real,
    state::precision::Precision,
    system::{
        System,
        sites::{Flow, MovedSites, RowCarries, Sites, StencilRadii},
    },
    threads::Job,
};
use alloc::{boxed::Box, vec::Vec};
use core::ops::Range;

/// A segment of a lattice behind a pointer, for every scalar type: the splitting of a lattice is compiled once.
pub(super) trait Segment: Send {
    /// The number of sites or rows of the whole lattice, and how many sites each of them has.
    fn size(&self) -> [usize; 2];
    /// Applies a flow to some of the sites or rows.
    fn apply(&mut self, flow: &Flow, sites: Range<usize>);
    /// Forgets what was kept of a flow for the sites after those that it moved last.
    fn forget(&mut self);
    /// The segments that end at these borders.
    fn split(&mut self, borders: &[usize]) -> Vec<Box<dyn Segment + '_>>;
    /// Returns the jobs that apply a flow to the rows of each range; the ranges begin with the first rows of the
    /// segment.
    fn jobs<'s>(&'s mut self, flow: &'s Flow, rows: Vec<Range<usize>>) -> Vec<Job<'s>>;
}

/// The sites of a lattice, or a segment of them.
pub(super) struct SiteSegment<'m, H: System, R: Real, K: Precision> {
    sites: Sites<'m, R, K, H::Parameters<R>>,
    carries: RowCarries<R>,
}

impl<'m, H: System, R: Real, K: Precision> SiteSegment<'m, H, R, K> {
    pub(super) fn new(sites: Sites<'m, R, K, H::Parameters<R>>) -> Self {
        Self { sites, carries: RowCarries::default() }
    }
}

impl<H: System, R: Real, K: Precision> Segment for SiteSegment<'_, H, R, K> {
    fn size(&self) -> [usize; 2] {
        [self.sites.length, self.sites.columns]
    }
    fn apply(&mut self, flow: &Flow, sites: Range<usize>) {
        let half = self.sites.reborrow().moved_by(flow.drifts);
        H::apply_to_sites::<R, K>(MovedSites { carries: Some(&mut self.carries), ..half }, flow, sites);
    }
    fn forget(&mut self) {
        if const { matches!(H::STENCIL_RADII, Some(StencilRadii { of_layers: true, .. })) } {
            self.carries.forget();
        }
    }
    fn split(&mut self, borders: &[usize]) -> Vec<Box<dyn Segment + '_>> {
        let mut segments: Vec<Box<dyn Segment + '_>> = Vec::with_capacity(borders.len());
        let mut rest = self.sites.reborrow();
        for border in borders {
            let (sites, after) = rest.split_at(*border);
            rest = after;
            segments.push(Box::new(SiteSegment::<H, R, K>::new(sites)));
        }
        segments
    }
    fn jobs<'s>(&'s mut self, flow: &'s Flow, rows: Vec<Range<usize>>) -> Vec<Job<'s>> {
        let half = self.sites.reborrow().moved_by(flow.drifts);
        let MovedSites { read, parameters, first, length, columns, .. } = half;
        let (mut rest, mut next) = (half.moved, first);
        let mut jobs = Vec::<Job<'s>>::with_capacity(rows.len());
        for rows in rows {
            let (_, from) = rest.split_at_mut((rows.start - next) * columns);
            let (moved, after) = from.split_at_mut(rows.len() * columns);
            (rest, next) = (after, rows.end);
            jobs.push(Box::new(move || {
                let (first_moved, mut carries) = (rows.start, RowCarries::default());
                let carries = Some(&mut carries);
                let half = MovedSites { read, moved, parameters, first, first_moved, length, columns, carries };
                H::apply_to_sites::<R, K>(half, flow, rows);
            }));
        }
        jobs
    }
}
