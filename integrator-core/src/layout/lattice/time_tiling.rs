//! A long lattice, several flows at a time: tiles that are moved on far in time while they are in the cache, and shares
//! of the lattice that threads move on side by side.
//!
//! A flow reads a site's neighbours as the flow before left them. So each flow of a tile stops short of the one before
//! it, by as much as keeps what the next tile is going to read: a tile leans back in time, and the next one leans on
//! it. At the borders between threads, and where the ends of a ring meet, the shares of both sides lean back; what is
//! left out between them is moved last. Every flow moves every site exactly once and from the same numbers as if it
//! swept the lattice alone, so neither tiles nor threads change a bit.

use crate::{
    hamiltonian::{Flows, Hamiltonian, QuadraticKinetic},
    layout::{
        lattice::{
            sites::{LONG, Sites},
            stencil::{Drift, Edges, Gather, Kick},
        },
        threads::{Job, all_threads, at_once},
    },
    scalar::{real::Real, simd::block::Block},
    state::{
        coords::Coords,
        precision::{Precision, Slot},
    },
};
use alloc::{boxed::Box, vec::Vec};
use core::ops::Range;

/// How many sites a tile moves at a time: two arrays of doubles of this length fill a third of a first-level cache.
const TILE: usize = 1024;

/// How many flows are collected before the lattice is swept.
const DEPTH: usize = 64;

/// A lattice shorter than this stays in the cache as it is.
const CACHED: usize = 4 * TILE;

/// How many sites make a thread worth its start.
const SHARE: usize = 32 * TILE;

/// One flow of a lattice.
#[derive(Clone, Copy, Debug)]
pub struct Flow {
    /// Whether it is that of `T`, which moves the positions.
    pub(crate) drifts: bool,
    pub(crate) duration: f64,
    pub(crate) time: f64,
}

/// How far the flows of a lattice look.
#[derive(Clone, Copy, Debug)]
pub struct Reach {
    drift: Edges,
    kick: Edges,
}

impl Reach {
    /// The reach of the flows of `H`.
    pub const fn of<H: Gather<Drift> + Gather<Kick>>() -> Self {
        Self { drift: <H as Gather<Drift>>::EDGES, kick: <H as Gather<Kick>>::EDGES }
    }

    fn periodic(&self) -> bool {
        self.drift.periodic || self.kick.periodic
    }

    /// How far behind a site and ahead of it a flow looks.
    fn around(&self, flow: &Flow) -> [usize; 2] {
        let edges = if flow.drifts { &self.drift } else { &self.kick };
        [edges.behind + edges.onward, edges.ahead]
    }
}

/// What a sweep reads at a time.
type Wide<R, K> = <<K as Precision>::Slot<R> as Slot<R>>::Wide;

/// Neighbouring sites that flows move, whatever they are computed in: how a lattice is shared out is compiled once.
trait Part: Send {
    /// How many sites the lattice has.
    fn length(&self) -> usize;
    /// A flow moves some of the sites.
    fn along(&mut self, flow: &Flow, sites: Range<usize>);
    /// The sites up to each of these borders, one part after the other.
    fn split(&mut self, borders: &[usize]) -> Vec<Box<dyn Part + '_>>;
}

/// The sites of a lattice, or a window of them.
struct Window<'m, H: Hamiltonian, R: Real, K: Precision>(Sites<'m, R, K, H::Parameters<R>>);

impl<H: Hamiltonian, R: Real, K: Precision> Part for Window<'_, H, R, K> {
    fn length(&self) -> usize {
        self.0.length
    }
    fn along(&mut self, flow: &Flow, sites: Range<usize>) {
        H::along::<R, K>(&mut self.0, flow, sites);
    }
    fn split(&mut self, borders: &[usize]) -> Vec<Box<dyn Part + '_>> {
        let mut parts: Vec<Box<dyn Part + '_>> = Vec::with_capacity(borders.len());
        let mut rest = self.0.whole();
        for border in borders {
            let (sites, after) = rest.split_at(*border);
            rest = after;
            parts.push(Box::new(Window::<H, R, K>(sites)));
        }
        parts
    }
}

/// The flows of a lattice, collected and carried out a few at a time.
pub(crate) struct Tiled<'m, H: Hamiltonian, R: Real, K: Precision> {
    motion: &'m mut H::Motion<R, K>,
    threads: Option<usize>,
    flows: Vec<Flow>,
}

impl<'m, H: Hamiltonian, R: Real, K: Precision> Tiled<'m, H, R, K> {
    /// Whether the flows of a system are carried out like this: a lattice does not fit into the registers, or may not.
    pub(crate) const PAYS: bool = H::REACH.is_some()
        && match <H::Coords as Coords>::LENGTH {
            Some(length) => length >= LONG,
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

    /// Carries out what was collected.
    pub(crate) fn finish(&mut self) {
        if let (Some(reach), Some(sites)) = (H::REACH, H::sites::<R, K>(self.motion)) {
            let slopes = Slopes::new(&self.flows, reach, Wide::<R, K>::WIDTH);
            sweep(&mut Window::<H, R, K>(sites), &slopes, self.threads);
        }
        self.flows.clear();
    }
}

impl<H: Hamiltonian, R: Real, K: Precision> Flows<H> for &mut Tiled<'_, H, R, K> {
    const COMPENSATED: bool = K::COMPENSATED;

    fn begin_step(&mut self, middle: f64) {
        // What was collected belongs to another step.
        self.finish();
        H::begin_step::<R, K>(self.motion, middle);
    }
    fn drift(&mut self, duration: f64, time: f64) {
        self.collect(Flow { drifts: true, duration, time });
    }
    fn kick(&mut self, duration: f64, time: f64) {
        self.collect(Flow { drifts: false, duration, time });
    }
    fn gradient_kick(&mut self, duration: f64, gradient: f64, time: f64)
    where
        H: QuadraticKinetic,
    {
        self.finish();
        H::gradient_kick::<R, K>(self.motion, duration, gradient, time);
    }
}

/// Flows, each with how far it stays behind the right border of a tile, and ahead of the left border of a share.
struct Slopes {
    flows: Vec<(Flow, [usize; 2])>,
    periodic: bool,
}

impl Slopes {
    /// For a lattice that is read in blocks of `width` sites: whole ones, so that all flows cut the lattice at the same
    /// places.
    fn new(flows: &[Flow], reach: Reach, width: usize) -> Self {
        // A flow reads what the one before it moved, and leaves the next tile what that one read.
        let (mut left, mut right) = (0, 0);
        let mut before = [0, 0];
        let flows = flows.iter().map(|flow| {
            let [behind, ahead] = reach.around(flow);
            left += (behind + before[1]).next_multiple_of(width);
            right += (ahead + before[0]).next_multiple_of(width);
            before = [behind, ahead];
            (*flow, [left, right])
        });
        Self { flows: flows.collect(), periodic: reach.periodic() }
    }

    /// How far the last flow stays away from a border.
    fn widest(&self) -> usize {
        self.flows.last().map_or(0, |(_, [left, right])| *left.max(right))
    }
}

/// Carries flows out on all sites.
fn sweep(lattice: &mut dyn Part, slopes: &Slopes, threads: Option<usize>) {
    let length = lattice.length();
    if length < CACHED {
        for (flow, _) in &slopes.flows {
            lattice.along(flow, 0..length);
        }
        return;
    }
    let count = match length / SHARE {
        0 | 1 => 1,
        most => threads.unwrap_or_else(all_threads).clamp(1, most),
    };
    let borders: Vec<usize> = (0..=count).map(|number| number * length / count).collect();
    let parts = lattice.split(&borders[1..]).into_iter().enumerate();
    let jobs = parts.map(|(number, part)| -> Job<'_> {
        let (leans_left, leans_right) = (number > 0 || slopes.periodic, number + 1 < count || slopes.periodic);
        let share = Share { part, sites: borders[number]..borders[number + 1], slopes, leans_left, leans_right };
        Box::new(|| share.advance())
    });
    at_once(jobs.collect());
    for number in (0..count).filter(|number| *number > 0 || slopes.periodic) {
        fill(lattice, slopes, borders[number]);
    }
}

/// What one thread moves.
struct Share<'s> {
    part: Box<dyn Part + 's>,
    /// Which sites the part has.
    sites: Range<usize>,
    slopes: &'s Slopes,
    /// Whether there is a neighbour to the left.
    leans_left: bool,
    /// Whether there is one to the right.
    leans_right: bool,
}

impl Share<'_> {
    /// The flows on all sites, but for what leans on the neighbours.
    fn advance(mut self) {
        let Range { start, end } = self.sites;
        let last = if self.leans_right { end } else { end + self.slopes.widest() };
        let mut border = start;
        while border < last {
            let next = last.min(border + TILE);
            for (flow, [left, right]) in &self.slopes.flows {
                let begin = if self.leans_left { start + left } else { start };
                let sites = border.saturating_sub(*right).max(begin)..next.saturating_sub(*right).min(end);
                if !sites.is_empty() {
                    self.part.along(flow, sites);
                }
            }
            border = next;
        }
    }
}

/// The flows on what the neighbours left out at a border.
fn fill(lattice: &mut dyn Part, slopes: &Slopes, border: usize) {
    for (flow, [left, right]) in &slopes.flows {
        // Where the ends of a ring meet, what is left of the border is at the other end.
        let end = if border == 0 { lattice.length() } else { border };
        for sites in [end - right..end, border..border + left] {
            lattice.along(flow, sites);
        }
    }
}
