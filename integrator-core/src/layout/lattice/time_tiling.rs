//! Time skewing of long lattices: several flows move a tile of sites while it is in the cache, and threads move chunks
//! of the lattice in parallel. A plane is a line of rows, and a volume one of planes: tiles, chunks and offsets are counted in
//! these layers.
//!
//! A flow reads a site's neighbours as the flow before left them. So each flow of a tile ends short of the one before
//! it, by the skew offset that keeps what the next tile is going to read. At the borders between threads, and where the
//! ends of a periodic lattice meet, the chunks of both sides are skewed; the gap between them is filled last. Every
//! flow moves every site exactly once and from the same numbers as in a pass over the whole lattice, so neither tiles
//! nor threads change a bit.

use crate::{
    layout::lattice::{
        segment::{Segment, SiteSegment},
        sites::LONG,
    },
    scalar::{real::Real, simd::block::Block},
    state::{
        coords::Coords,
        precision::{Precision, Slot},
    },
    system::{
        QuadraticKinetic, System,
        flows::Flows,
        sites::{Flow, StencilRadii},
    },
    threads::{Job, all_threads, at_once},
};
use alloc::{boxed::Box, vec::Vec};
use core::{ops::Range, slice};

/// The number of sites of a tile: two arrays of doubles of this length fill a third of a first-level cache.
const TILE: usize = 1024;

/// The number of sites of a tile of rows: a flow finds in a first-level cache most of the rows that the one before it moved.
const TILE_OF_ROWS: usize = 2 * TILE;

/// The number of sites by which the flows of a tile of rows may lean, a row each: they fit into a second-level cache. Flows that
/// lean by more are tiled as many.
const SKEWED_SITES: usize = 24 * TILE;

/// The fewest flows of a tile of layers, however many sites these have: those go through a third-level cache together.
const SHALLOWEST: usize = 12;

/// The number of flows that are collected before they are applied to the lattice.
const DEPTH: usize = 64;

/// The fewest rows of a chunk for each flow of it: each flow leans by three rows at most to either side.
const ROWS_PER_FLOW: usize = 8;

/// The fewest flows of a tile that chunks of layers are worth.
const LEAST_DEPTH: usize = 4;

/// A lattice shorter than this stays in the cache as it is.
pub(crate) const CACHED: usize = 3 * TILE;

/// A plane of fewer sites gains nothing by tiles, which would have too few rows.
const CACHED_PLANE: usize = 8 * TILE;

/// The least number of sites in the chunk of a thread: the gaps between the chunks of a line are filled by one of them.
const MIN_CHUNK: usize = 4 * TILE;

/// The least number of sites to which a thread applies one flow alone, and then waits for the others.
const MIN_SHARE: usize = 16 * TILE;

/// The least number of sites, counted once for each flow, that a thread takes part for.
const MIN_WORK: usize = 128 * TILE;

/// The block that a pass reads at a time.
type Wide<R, K> = <<K as Precision>::Slot<R> as Slot<R>>::Wide;

/// The executor of long lattices: it collects flows, and applies several of them to a tile at a time.
pub(crate) struct TimeTiling<'m, H: System, R: Real, K: Precision> {
    motion: &'m mut H::Motion<R, K>,
    threads: Option<usize>,
    flows: Vec<Flow>,
}

impl<'m, H: System, R: Real, K: Precision> TimeTiling<'m, H, R, K> {
    /// Whether a system's flows are tiled in time: those of a lattice that does not fit into registers, or may not.
    pub(crate) const ENABLED: bool = H::STENCIL_RADII.is_some()
        && match <H::Coords as Coords>::LENGTH {
            Some(length) => length * <H::Coords as Coords>::COMPONENTS >= LONG,
            None => true,
        };

    pub(crate) fn new(motion: &'m mut H::Motion<R, K>, threads: Option<usize>) -> Self {
        Self { motion, threads, flows: Vec::with_capacity(DEPTH) }
    }

    fn collect(&mut self, flow: Flow) {
        self.flows.push(flow);
        if self.flows.len() == DEPTH {
            self.finish();
        }
    }

    /// Applies the collected flows.
    pub(crate) fn finish(&mut self) {
        Self::apply(self.motion, &self.flows, self.threads);
        self.flows.clear();
    }

    /// Applies flows to a motion, on this number of threads or on all.
    pub(crate) fn apply(motion: &mut H::Motion<R, K>, flows: &[Flow], threads: Option<usize>) {
        let Some(radii) = H::STENCIL_RADII else { return };
        if let Some(mut sites) = H::sites::<R, K>(motion) {
            if sites.length * sites.columns < CACHED {
                for flow in flows {
                    let all = 0..sites.length;
                    H::apply_to_sites::<R, K>(sites.reborrow().moved_by(flow.drifts), flow, all);
                }
            } else {
                let width = if radii.of_layers { 1 } else { Wide::<R, K>::WIDTH };
                advance_lattice(&mut SiteSegment::<H, R, K>::new(sites), flows, radii, width, threads);
            }
        } else {
            for Flow { drifts, duration, time } in flows.iter().copied() {
                if drifts {
                    H::drift::<R, K>(motion, duration, time);
                } else {
                    H::kick::<R, K>(motion, duration, time);
                }
            }
        }
    }
}

impl<H: System, R: Real, K: Precision> Flows<H> for &mut TimeTiling<'_, H, R, K> {
    const COMPENSATED: bool = K::COMPENSATED;

    fn begin_step(&mut self, middle: f64) {
        // The collected flows belong to another step.
        self.finish();
        H::begin_step::<R, K>(self.motion, middle);
    }
    fn drift(&mut self, duration: f64, time: f64) {
        self.collect(Flow { drifts: true, duration, time });
    }
    fn kick(&mut self, duration: f64, time: f64) {
        self.collect(Flow { drifts: false, duration, time });
    }
    fn middle(&mut self, duration: f64, time: f64, backwards: bool) {
        self.finish();
        H::middle::<R, K>(self.motion, duration, time, backwards);
    }
    fn gradient_kick(&mut self, duration: f64, gradient: f64, time: f64)
    where
        H: QuadraticKinetic,
    {
        self.finish();
        H::gradient_kick::<R, K>(self.motion, duration, gradient, time);
    }
}

/// Flows with their skew offsets: how far each ends before the right border of a tile, and begins after the left border
/// of a chunk.
struct SkewedFlows {
    flows: Vec<(Flow, [usize; 2])>,
    periodic: bool,
    of_layers: bool,
}

impl SkewedFlows {
    /// For a lattice that is read in blocks of `width` sites: the offsets are whole blocks, so that all flows cut the
    /// lattice between the same blocks.
    fn new(flows: &[Flow], radii: StencilRadii, width: usize) -> Self {
        // A flow reads what the one before it moved, and keeps for the next tile what that one read.
        let (mut left, mut right) = (0, 0);
        let mut before = [0, 0];
        let flows = flows.iter().map(|flow| {
            let [behind, ahead] = radii.radius(flow);
            left += (behind + before[1]).next_multiple_of(width);
            right += (ahead + before[0]).next_multiple_of(width);
            before = [behind, ahead];
            (*flow, [left, right])
        });
        Self { flows: flows.collect(), periodic: radii.periodic(), of_layers: radii.of_layers }
    }

    /// The largest skew offset, that of the last flow.
    fn largest_offset(&self) -> usize {
        self.flows.last().map_or(0, |(_, [left, right])| *left.max(right))
    }
}

/// Applies flows to all sites of a lattice that is not short, which are read in blocks of `width`.
fn advance_lattice(
    lattice: &mut dyn Segment,
    flows: &[Flow],
    radii: StencilRadii,
    width: usize,
    threads: Option<usize>,
) {
    let [length, columns] = lattice.size();
    let sites = length * columns;
    let most = threads.unwrap_or_else(all_threads).min(sites * flows.len() / MIN_WORK);
    let mut count = most.min(sites / MIN_CHUNK).max(1);
    let (mut tile, mut depth) = (TILE, DEPTH);
    if radii.of_layers {
        count = count.min(length / (LEAST_DEPTH * ROWS_PER_FLOW)).max(1);
        tile = (TILE_OF_ROWS / columns.max(1)).max(1);
        depth = (SKEWED_SITES / columns.max(1)).clamp(SHALLOWEST, DEPTH).min(length / count / ROWS_PER_FLOW);
        let shares = most.min(sites / MIN_SHARE).max(1);
        // Many threads that go through the whole lattice with each flow are faster than few that move tiles.
        if sites < CACHED_PLANE || depth < 2 || shares >= 2 * count {
            let all = 0..length;
            flows.iter().for_each(|flow| apply_shared(lattice, flow, slice::from_ref(&all), shares));
            return;
        }
    }
    for flows in flows.chunks(depth) {
        advance_tiles(lattice, &SkewedFlows::new(flows, radii, width), tile, count);
    }
}

/// Applies flows to tiles of this number of sites or rows, in this number of chunks.
fn advance_tiles(lattice: &mut dyn Segment, skewed: &SkewedFlows, tile: usize, count: usize) {
    let [length, _] = lattice.size();
    let borders: Vec<usize> = (0..=count).map(|number| number * length / count).collect();
    let segments = lattice.split(&borders[1..]).into_iter().enumerate();
    let jobs = segments.map(|(number, segment)| -> Job<'_> {
        let (skewed_left, skewed_right) = (number > 0 || skewed.periodic, number + 1 < count || skewed.periodic);
        let sites = borders[number]..borders[number + 1];
        let chunk = Chunk { segment, sites, tile, skewed, skewed_left, skewed_right };
        Box::new(|| chunk.advance())
    });
    at_once(jobs.collect());
    let gaps = if skewed.periodic { 0..count } else { 1..count };
    let borders: Vec<_> = gaps.map(|number| borders[number]).collect();
    if !borders.is_empty() {
        fill_gaps(lattice, skewed, &borders, count);
    }
}

/// The chunk of the lattice that one thread moves.
struct Chunk<'s> {
    segment: Box<dyn Segment + 's>,
    /// The indices of the segment's sites.
    sites: Range<usize>,
    /// The number of sites of a tile.
    tile: usize,
    skewed: &'s SkewedFlows,
    /// Whether another chunk lies to the left.
    skewed_left: bool,
    /// Whether another chunk lies to the right.
    skewed_right: bool,
}

impl Chunk<'_> {
    /// Applies the flows to all sites but those of the gaps to the chunks on both sides.
    fn advance(mut self) {
        let Range { start, end } = self.sites;
        let last = if self.skewed_right { end } else { end + self.skewed.largest_offset() };
        let mut border = start;
        while border < last {
            let next = last.min(border + self.tile);
            for (flow, [left, right]) in &self.skewed.flows {
                let begin = if self.skewed_left { start + left } else { start };
                let sites = border.saturating_sub(*right).max(begin)..next.saturating_sub(*right).min(end);
                if !sites.is_empty() {
                    self.segment.apply(flow, sites);
                }
            }
            border = next;
        }
    }
}

/// Applies the flows to the gaps that chunks left at these borders: one flow after the other, each of them in this
/// number of threads where that is worth it.
fn fill_gaps(lattice: &mut dyn Segment, skewed: &SkewedFlows, borders: &[usize], threads: usize) {
    let [length, columns] = lattice.size();
    for (flow, [left, right]) in &skewed.flows {
        let mut gaps = Vec::with_capacity(borders.len() + 1);
        for border in borders {
            gaps.push(border.saturating_sub(*right)..border + left);
        }
        // Where the ends of a periodic lattice meet, the left side of the border is at the other end.
        if borders[0] == 0 {
            gaps.push(length - right..length);
        }
        let sites = borders.len() * (left + right) * columns;
        let shares = if skewed.of_layers { threads.min(sites / MIN_SHARE) } else { 1 };
        apply_shared(lattice, flow, &gaps, shares);
    }
}

/// Applies a flow to some of the sites; of layers, in this number of threads.
fn apply_shared(lattice: &mut dyn Segment, flow: &Flow, sites: &[Range<usize>], threads: usize) {
    if threads > 1 {
        let parts = dealt(sites, threads);
        let mut pieces = lattice.jobs(flow, parts.iter().flatten().cloned().collect()).into_iter();
        let of_part = |part: &Vec<_>| pieces.by_ref().take(part.len()).collect::<Vec<_>>();
        let parts = parts
            .iter()
            .map(of_part)
            .map(|pieces| -> Job<'_> { Box::new(|| pieces.into_iter().for_each(|job| job())) });
        return at_once(parts.collect());
    }
    sites.iter().for_each(|sites| lattice.apply(flow, sites.clone()));
    lattice.forget();
}

/// Ranges in this number of parts of about the same length.
fn dealt(ranges: &[Range<usize>], parts: usize) -> Vec<Vec<Range<usize>>> {
    let all: usize = ranges.iter().map(Range::len).sum();
    let each = all.div_ceil(parts);
    let (mut dealt, mut room) = (Vec::with_capacity(parts), 0);
    for range in ranges {
        let mut from = range.start;
        while from < range.end {
            if room == 0 {
                dealt.push(Vec::new());
                room = each;
            }
            let to = range.end.min(from + room);
            room -= to - from;
            if let Some(part) = dealt.last_mut() {
                part.push(from..to);
            }
            from = to;
        }
    }
    dealt
}

#[cfg(test)]
mod tests {
    use super::dealt;
    use alloc::vec::Vec;

    #[test]
    fn every_iteration_is_assigned_once_and_evenly() {
        let ranges = [0..3, 10..21, 30..31];
        let all: Vec<_> = ranges.iter().cloned().flatten().collect();
        for parts in 1..20 {
            let dealt = dealt(&ranges, parts);
            let lengths: Vec<usize> = dealt.iter().map(|part| part.iter().map(ExactSizeIterator::len).sum()).collect();
            assert!(
                lengths.len() <= parts && lengths.iter().all(|length| (1..=15_usize.div_ceil(parts)).contains(length))
            );
            assert_eq!(dealt.into_iter().flatten().flatten().collect::<Vec<_>>(), all);
        }
    }
}
