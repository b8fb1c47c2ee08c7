//! The sites that a rank integrates: its own, and a halo of its neighbours' sites beyond each border. Halos are used
//! until the error from the ends of the slab has crossed them.
//!
//! Always true: the slabs on the two sides of some border have different lengths and begin at different sites. A
//! formula that depends on the number of sites or on the index of a site hence gives different results for them.

use crate::{ensemble::share_of, error::Error};
use integrator_core::{
    __private::{Composition, Rows, Stage, StencilRadii},
    Hamiltonian,
};
use std::ops::Range;

/// By how much more the halos of every other rank are: shares differ by one site at most.
const WIDER: usize = 2;

/// Halos that are moved twice are to be at most such a part of a rank's own sites.
const SMALL: usize = 16;

/// The most steps between two exchanges: with more of them, a divergence is found late and taken back far.
const MOST_STEPS: usize = 1024;

/// Which part of these steps is taken while messages travel: borders are moved twice in them.
const AHEAD: usize = 8;

/// How far the steps of a composition carry what is wrong at the ends of a slab.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Reach {
    /// Whatever the number of steps: ends that differ, the first step, and the reading of a state.
    once: usize,
    /// In each step.
    step: usize,
    periodic: bool,
}

impl Reach {
    /// That of a system whose sites are moved alike; nothing for all others.
    pub(crate) fn of<H: Hamiltonian, X: Composition<H>>() -> Option<Self> {
        let radii = H::STENCIL_RADII.filter(|_| H::SEPARABLE && H::PARTS.len() == 2 && !H::FLAT_ROWS)?;
        let (stages, processor) = (X::STAGES, X::PROCESSOR);
        let of = |stages: &[Stage]| stages.iter().map(|stage| of_stage(&radii, stage)).sum::<usize>();
        let of_rows = |rows: &Rows| of(rows.rows);
        let (opening, cycle, closing) = (of(&[stages.opening]), of(stages.cycle), of(&[stages.closing]));
        let shown = closing + of_rows(&processor.after);
        // Where formulas change with time, steps are not merged.
        let step = if H::PIECEWISE_IN_TIME { opening + cycle + closing } else { cycle };
        let once = radii.ends() + of_rows(&processor.before) + opening + shown;
        Some(Self { once, step, periodic: radii.periodic() })
    }

    /// The fewest sites that stay right for this number of steps in each halo, and one more, which both sides of a
    /// border have.
    fn halo(&self, steps: usize) -> usize {
        self.once + steps * self.step + 1
    }
}

/// How far a stage carries what a coordinate is.
fn of_stage(radii: &StencilRadii, stage: &Stage) -> usize {
    let [drift, kick] = radii.reach();
    let drifts = if stage.drift == 0.0 { 0 } else { drift };
    let kicks = if stage.kick == 0.0 { 0 } else { kick };
    // The force, the velocity that it is, and the Hessian times that.
    let bends = if stage.gradient == 0.0 { 0 } else { kick + drift + kick };
    drifts + kicks + bends
}

/// A neighbour on one side of a slab.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Neighbour {
    pub(crate) rank: i32,
    /// The width of its halo on this side.
    pub(crate) halo: usize,
}

/// The sites of a rank.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Slab {
    /// How many sites all ranks have.
    pub(crate) sites: usize,
    /// The numbers of those that this rank shows.
    pub(crate) own: Range<usize>,
    /// How many sites of others are before these and after them.
    pub(crate) halos: [usize; 2],
    /// Where, among its sites, the halo before its own begins, its own, and the halo after them.
    places: [usize; 3],
    pub(crate) neighbours: [Option<Neighbour>; 2],
    /// How many steps may be taken between two exchanges.
    pub(crate) steps: u64,
    /// How many of these are taken while the messages of an exchange travel.
    pub(crate) ahead: u64,
    /// How many of its own sites on each side these leave wrong without the halo, and one more.
    pub(crate) late: usize,
}

impl Slab {
    /// The slab of a rank of this number.
    ///
    /// # Errors
    /// [`Error::FewSites`], if a rank has fewer of its own than the halo of another one requires.
    pub(crate) fn of(reach: Reach, sites: usize, rank: usize, ranks: usize) -> Result<Self, Error> {
        let (own, least) = (share_of(rank, ranks, sites), sites / ranks);
        let alone = ranks == 1;
        if !alone && least < reach.halo(1) + WIDER {
            return Err(Error::FewSites { sites, ranks, least: reach.halo(1) + WIDER });
        }
        let rest = (least / SMALL).saturating_sub(reach.halo(0) + WIDER);
        let steps = rest.checked_div(reach.step).map_or(MOST_STEPS, |steps| steps.clamp(1, MOST_STEPS));
        let halo = |rank: usize| reach.halo(steps) + WIDER * (rank % 2);
        let neighbour =
            |there: bool, rank: usize| (there && !alone).then(|| Neighbour { rank: rank as i32, halo: halo(rank) });
        let before = neighbour(rank > 0 || reach.periodic, (rank + ranks - 1) % ranks);
        let behind = neighbour(rank + 1 < ranks || reach.periodic, (rank + 1) % ranks);
        let neighbours = [before, behind];
        let halos = neighbours.map(|neighbour| neighbour.map_or(0, |_| halo(rank)));
        let [width, inner] = [halos[0], own.len()];
        // The first row of a periodic plane adds what the last one gives it in an order of its own. So where a slab has it, it comes
        // first, and the last one last: what is wrong begins between the two halos instead of at the ends.
        let places = match reach.periodic && !alone {
            true if rank == 0 => [inner + width, 0, inner],
            true if rank + 1 == ranks => [width, 2 * width, 0],
            _ => [0, width, width + inner],
        };
        let ahead = steps.div_ceil(AHEAD);
        // A border has twice as many, up to which what is wrong at its other end does not come.
        let late = reach.halo(ahead);
        let ahead = if alone || 2 * late > least { 0 } else { ahead as u64 };
        let steps = if alone { u64::MAX } else { steps as u64 };
        Ok(Self { sites, own, halos, places, neighbours, steps, ahead, late })
    }

    /// The numbers of all its sites, in their order.
    pub(crate) fn indices(&self) -> Vec<usize> {
        let ([before, behind], Range { start, end }) = (self.halos, self.own.clone());
        let parts = [start + self.sites - before..start + self.sites, start..end, end..end + behind];
        let mut parts: Vec<_> = self.places.into_iter().zip(parts).collect();
        parts.sort_unstable_by_key(|(place, _)| *place);
        parts.into_iter().flat_map(|(_, part)| part.map(|site| site % self.sites)).collect()
    }

    /// Where its own sites are among its sites.
    pub(crate) fn inner(&self) -> Range<usize> {
        let [_, start, _] = self.places;
        start..start + self.own.len()
    }

    /// Where the sites are that a neighbour requests: those next to the border on this side.
    pub(crate) fn edge(&self, side: usize, width: usize) -> Range<usize> {
        let Range { start, end } = self.inner();
        if side == 0 { start..start + width } else { end - width..end }
    }

    /// Where the halo on one side is.
    pub(crate) fn halo(&self, side: usize) -> Range<usize> {
        let start = self.places[2 * side];
        start..start + self.halos[side]
    }

    /// Where the sites of a border are: the halo on this side and `own` of the sites of this rank, in index order.
    pub(crate) fn border(&self, side: usize, own: usize) -> [Range<usize>; 2] {
        let mut parts = [self.halo(side), self.edge(side, own)];
        parts.sort_unstable_by_key(|part| part.start);
        parts
    }

    /// Where the site of a halo is that both sides of the border know.
    pub(crate) fn known_to_both(&self, side: usize) -> usize {
        let Range { start, end } = self.halo(side);
        if side == 0 { end - 1 } else { start }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slabs_fit_each_other() {
        for (periodic, ranks) in (1..6).flat_map(|ranks| [(false, ranks), (true, ranks)]) {
            let reach = Reach { once: 3, step: 2, periodic };
            for sites in [50, 51, 52, 53, 54, 1_000] {
                let slabs: Vec<_> = (0..ranks).map(|rank| Slab::of(reach, sites, rank, ranks).unwrap()).collect();
                for (rank, slab) in slabs.iter().enumerate() {
                    let indices = slab.indices();
                    assert_eq!(indices[slab.inner()], slab.own.clone().collect::<Vec<_>>());
                    assert!(indices.is_sorted(), "the last one comes before the first: {indices:?}");
                    let ends = [rank == 0, rank + 1 == ranks].map(|end| ranks > 1 && (!end || periodic));
                    for (side, neighbour) in slab.neighbours.iter().enumerate() {
                        assert_eq!(neighbour.is_some(), ends[side]);
                        let Some(Neighbour { rank, halo }) = neighbour else { continue };
                        let other = &slabs[*rank as usize];
                        let theirs = &other.indices()[other.halo(1 - side)];
                        assert_eq!(&indices[slab.edge(side, *halo)], theirs, "{rank} of {ranks}, {sites}");
                        let border = slab.border(side, slab.late).map(|part| indices[part].to_vec()).concat();
                        assert!(border.is_sorted(), "the last one comes before the first: {border:?}");
                        assert!(slab.ahead <= slab.steps && (slab.ahead == 0 || 2 * slab.late <= slab.own.len()));
                    }
                }
                let differ = slabs.windows(2).any(|pair| pair[0].indices().len() != pair[1].indices().len());
                assert!(ranks == 1 || differ);
            }
        }
        let reach = Reach { once: 3, step: 2, periodic: false };
        let refused = Slab::of(reach, 15, 0, 2);
        assert_eq!(refused, Err(Error::FewSites { sites: 15, ranks: 2, least: 8 }));
    }
}
