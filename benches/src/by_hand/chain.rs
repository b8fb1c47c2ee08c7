//! Long chains between walls, integrated with Verlet.
//!
//! A step is one pass. A block of sites is kicked and drifted immediately, because its left neighbours have been kicked
//! and the bond to them is still in a register. Several steps are taken on a tile before the next tile is loaded. Each
//! step works one block to the left of the previous step, and keeps the bond at its right end for the next tile.

use crate::{
    by_hand::law::{Forces, Fput, Law, Phi4, SineGordon, Toda},
    enter::{Kernel, enter, enter_scalar},
    plan::Plan,
    vector::{Row, Vector},
};

/// Sites per tile; together with the steps in progress, a tile fills half of an L1 cache.
const TILE: usize = 1024;
/// Steps per tile. Each shifts by a block, and all shifts together are smaller than a tile.
const DEPTH: usize = 32;

/// A chain and its state.
#[derive(Clone)]
pub struct Chain {
    /// The potentials of bonds and sites.
    pub law: Law,
    /// Positions; their number is a multiple of eight.
    pub q: Vec<f64>,
    /// Momenta.
    pub p: Vec<f64>,
}

impl Chain {
    /// Takes `steps` steps of Verlet, up to `DEPTH` of them per tile.
    ///
    /// # Panics
    /// If the plan is not that of `Verlet`, or the number of sites is not a multiple of eight.
    pub fn skewed(&mut self, plan: &Plan, steps: usize) {
        assert!(self.q.len() == self.p.len() && self.q.len().is_multiple_of(8), "whole blocks");
        enter(March { chain: self, flows: plan.verlet(), steps, skewed: true });
    }

    /// Takes `steps` steps of Verlet, each in two loops over all sites.
    ///
    /// # Panics
    /// If the plan is not that of `Verlet`.
    pub fn two_pass(&mut self, plan: &Plan, steps: usize) {
        enter_scalar(March { chain: self, flows: plan.verlet(), steps, skewed: false });
    }
}

struct March<'c> {
    chain: &'c mut Chain,
    /// Durations of the opening drift, the kick and the drift of the loop, and the closing drift.
    flows: [f64; 4],
    steps: usize,
    skewed: bool,
}

impl Kernel for March<'_> {
    type Out = ();
    #[inline(always)]
    fn run<V: Row, R: Row, S: Vector<Number = f32>>(self) {
        match self.chain.law {
            Law::Fput { alpha } => self.march::<V>(Fput(alpha)),
            Law::Toda => self.march::<V>(Toda),
            Law::SineGordon { stiffness } => self.march::<V>(SineGordon(stiffness)),
            Law::Phi4 { stiffness } => self.march::<V>(Phi4(stiffness)),
        }
    }
}

impl March<'_> {
    #[inline(always)]
    fn march<V: Row>(self, law: impl Forces) {
        let Chain { q, p, .. } = self.chain;
        let [opening, kick, drift, closing] = self.flows;
        all_drift(q, p, opening);
        if self.skewed {
            let mut left = self.steps - 1;
            while left > 0 {
                let depth = left.min(DEPTH);
                tiles::<V>(law, q, p, [kick, drift], depth);
                left -= depth;
            }
            tiles::<V>(law, q, p, [kick, closing], 1);
        } else {
            for step in 1..=self.steps {
                all_kick(law, q, p, kick);
                all_drift(q, p, if step < self.steps { drift } else { closing });
            }
        }
    }
}

#[inline(always)]
fn all_drift(q: &mut [f64], p: &[f64], t: f64) {
    for (q, p) in q.iter_mut().zip(p) {
        *q = t.mul_add(*p, *q);
    }
}

#[inline(always)]
fn all_kick(law: impl Forces, q: &[f64], p: &mut [f64], t: f64) {
    let force =
        |left: f64, here: f64, right: f64| law.plain(right - here) - law.plain(here - left) - law.plain_site(here);
    let last = q.len() - 1;
    p[0] = t.mul_add(force(0.0, q[0], q[1]), p[0]);
    for (p, sites) in p[1..last].iter_mut().zip(q.windows(3)) {
        *p = t.mul_add(force(sites[0], sites[1], sites[2]), *p);
    }
    p[last] = t.mul_add(force(q[last - 1], q[last], 0.0), p[last]);
}

/// Takes `depth` steps, tile by tile.
#[inline(always)]
fn tiles<V: Row>(law: impl Forces, q: &mut [f64], p: &mut [f64], flows: [f64; 2], depth: usize) {
    const { assert!(8 * DEPTH < TILE, "a tile outlasts the shifts") };
    let sites = q.len();
    let mut bonds = [V::splat(0.0); DEPTH];
    let mut first = 0;
    while first < sites {
        for (step, bond) in bonds.iter_mut().enumerate().take(depth) {
            let begin = first.saturating_sub(8 * step);
            let end = if first + TILE >= sites { sites } else { first + TILE - 8 * step };
            if first == 0 {
                *bond = law.bond(V::splat(0.0).after(V::load(q)));
            }
            *bond = pass(law, q, p, flows, begin..end, *bond);
        }
        first += TILE;
    }
}

/// Kicks and drifts a range of sites. The last lane of `left` is the bond to the left of the range; the last lane of
/// the returned vector is the bond at its right end.
#[inline(always)]
fn pass<V: Row>(
    law: impl Forces,
    q: &mut [f64],
    p: &mut [f64],
    [kick, drift]: [f64; 2],
    range: std::ops::Range<usize>,
    mut left: V,
) -> V {
    let (kick, drift) = (V::splat(kick), V::splat(drift));
    let mut here = V::load(&q[range.start..]);
    for i in range.step_by(V::LANES) {
        let next = if i + V::LANES < q.len() { V::load(&q[i + V::LANES..]) } else { V::splat(0.0) };
        let right = law.bond(here.after(next) - here);
        let bonds = right - right.before(left);
        let force = match law.site(here) {
            Some(site) => bonds - site,
            None => bonds,
        };
        let momentum = kick.fma(force, V::load(&p[i..]));
        momentum.store(&mut p[i..]);
        drift.fma(momentum, here).store(&mut q[i..]);
        (here, left) = (next, right);
    }
    left
}
