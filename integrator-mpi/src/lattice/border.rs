//! The sites around the border of two slabs, which are integrated again when the messages of an exchange have arrived.
//!
//! Always true: the result of a border is correct, since it begins with the halo of its neighbour on one side and with
//! twice as many of its rank's own sites as needed on the other side.

use crate::lattice::{
    RunOf,
    exchange::{numbers_of, put},
    slab::Slab,
};
use integrator_core::{
    __private::{go_on_from, unfinished},
    Coords, Error as CoreError, Phase, Run,
};
use std::ops::Range;

/// A border of a slab.
pub(crate) struct Border<C: Coords> {
    run: Run<C>,
    /// Where its sites are in the slab: halo and own, in the order of all sites.
    parts: [Range<usize>; 2],
    /// Where those of them are that it moves for the slab.
    moved: [Range<usize>; 2],
}

/// Some sites of a slab, and their numbers.
pub(crate) type Moved = (Range<usize>, Vec<f64>);

impl<C: Coords> Border<C> {
    /// The border of a slab in this state on a side.
    pub(crate) fn of(slab: &Slab, side: usize, run_of: &RunOf<'_, C>, state: &Phase<C>) -> Result<Self, CoreError> {
        let (parts, indices) = (slab.border(side, 2 * slab.late), slab.indices());
        let sites: Vec<_> = parts.iter().flat_map(|part| indices[part.clone()].iter().copied()).collect();
        let run = run_of(&sites, state_of(state, &parts))?;
        Ok(Self { run, parts, moved: [slab.halo(side), slab.edge(side, slab.late)] })
    }

    /// Starts the clock at `t0`.
    pub(crate) fn at_time(self, t0: f64) -> Self {
        Self { run: self.run.at_time(t0), ..self }
    }

    /// Uses at most this number of threads.
    pub(crate) fn with_threads(self, threads: usize) -> Self {
        Self { run: self.run.with_threads(threads), ..self }
    }

    /// Takes steps from a state of the slab in the middle of a step, after `steps` of them and since it was changed after `opened`.
    pub(crate) fn advance(
        &mut self,
        from: &Phase<C>,
        [steps, opened]: [u64; 2],
        ahead: u64,
    ) -> Result<[Moved; 2], CoreError> {
        go_on_from(&mut self.run, steps, opened, &state_of(from, &self.parts));
        self.run.advance(ahead)?;
        let state = unfinished(&self.run);
        Ok(self.moved.clone().map(|sites| (sites.clone(), numbers_of(&state, self.within(sites)))))
    }

    /// Where sites of the slab are in the border.
    fn within(&self, sites: Range<usize>) -> Range<usize> {
        let [first, second] = &self.parts;
        let start = match first.contains(&sites.start) {
            true => sites.start - first.start,
            false => first.len() + sites.start - second.start,
        };
        start..start + sites.len()
    }
}

/// Some sites of a slab as a state of their own.
fn state_of<C: Coords>(slab: &Phase<C>, parts: &[Range<usize>; 2]) -> Phase<C> {
    let half = |half: &C| {
        let leaves = parts.iter().flat_map(|part| &half.flat()[part.start * C::COMPONENTS..part.end * C::COMPONENTS]);
        // A list of sites has any length.
        C::from_flat(leaves.copied().collect()).unwrap_or_else(|| half.clone())
    };
    Phase { q: half(&slab.q), p: half(&slab.p) }
}

/// Gives a slab what its borders have moved.
pub(crate) fn put_all<C: Coords>(state: &mut Phase<C>, moved: Vec<Moved>) {
    moved.into_iter().for_each(|(sites, numbers)| put(state, sites, &numbers));
}
