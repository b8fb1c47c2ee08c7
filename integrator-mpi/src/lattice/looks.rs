//! Read access to a lattice over ranks.

use crate::{
    ROOT,
    error::{Error, agree},
    exact_sum::ExactSum,
    is_root,
    lattice::{
        Lattice,
        exchange::{count, numbers_of, put},
        failure,
    },
    share_of,
    states::{receive_all, send_all},
};
use integrator_core::{__private::Precision, Coords, Phase};
use mpi::traits::{Communicator, Root};
use std::ops::Range;

impl<W: Communicator, C: Coords> Lattice<'_, W, C> {
    /// Returns the number of sites, or rows, of all ranks.
    pub fn len(&self) -> usize {
        self.slab.sites
    }

    /// Whether there are no sites.
    pub fn is_empty(&self) -> bool {
        self.slab.sites == 0
    }

    /// Returns the indices of the sites of this rank.
    pub fn of_rank(&self) -> Range<usize> {
        self.slab.own.clone()
    }

    /// Returns the number of steps taken.
    pub fn steps(&self) -> u64 {
        self.run.steps()
    }

    /// Returns the time, `t0 + n·h`.
    pub fn time(&self) -> f64 {
        self.run.time()
    }

    /// Returns the number of steps between two exchanges with neighbouring ranks, and the halo widths before and after
    /// the slab.
    ///
    /// A rank integrates the sites of the halos as well. A single rank has no neighbours, and the result is `None`.
    pub fn exchanges(&self) -> Option<(u64, [usize; 2])> {
        (self.world.size() > 1).then_some((self.slab.steps, self.slab.halos))
    }

    /// Returns the number of steps during which messages were in transit.
    ///
    /// In these steps, the interior of a slab was integrated first and its borders afterwards.
    pub fn overlapped(&self) -> u64 {
        self.overlapped
    }

    /// Returns the state of the sites of this rank.
    pub fn state_of_rank(&self) -> Phase<C> {
        let (state, inner) = (self.run.state(), self.slab.inner());
        let leaves = inner.start * C::COMPONENTS..inner.end * C::COMPONENTS;
        let [q, p] = [&state.q, &state.p].map(|half| C::from_flat(half.flat()[leaves.clone()].to_vec()));
        match (q, p) {
            (Some(q), Some(p)) => Phase { q, p },
            // A list of sites has any length.
            _ => state,
        }
    }

    /// Returns the state of all sites on rank 0, and `None` on all other ranks. Collective.
    pub fn state_on_root(&self) -> Option<Phase<C>> {
        self.on_root(&self.run.state())
    }

    /// What all ranks have of their own sites in states of their slabs, on rank 0.
    pub(super) fn on_root(&self, slab: &Phase<C>) -> Option<Phase<C>> {
        let numbers = numbers_of(slab, self.slab.inner());
        if !is_root(self.world) {
            send_all(&self.world.process_at_rank(ROOT), &numbers);
            return None;
        }
        let leaves = vec![C::Leaf::from_parts([0.0; 2]); self.slab.sites * C::COMPONENTS];
        let mut all = Phase { q: C::from_flat(leaves.clone())?, p: C::from_flat(leaves)? };
        put(&mut all, self.slab.own.clone(), &numbers);
        let ranks = self.world.size();
        for rank in 1..ranks {
            let sites = share_of(rank as usize, ranks as usize, self.slab.sites);
            let numbers: Vec<f64> = receive_all(&self.world.process_at_rank(rank), count::<C>(sites.len()));
            put(&mut all, sites, &numbers);
        }
        Some(all)
    }

    /// Returns the energy of all sites, which rank 0 computes from their state. Collective.
    ///
    /// # Errors
    /// [`Error::Rank`], if the state has no energy.
    pub fn energy(&self) -> Result<f64, Error> {
        let energy =
            self.state_on_root().map(|state| Ok((self.run_of)(&self.all(), state)?.at_time(self.time()).energy()));
        let mut energy = agree(self.world, energy.transpose().map_err(failure))?.unwrap_or(f64::NAN);
        self.world.process_at_rank(ROOT).broadcast_into(&mut energy);
        Ok(energy)
    }

    /// The numbers of all sites.
    pub(super) fn all(&self) -> Vec<usize> {
        (0..self.slab.sites).collect()
    }

    /// Returns the sum of a quantity over all sites that have it, from the index, the positions and the momenta of a
    /// site. Collective.
    ///
    /// The sum is exact before it is rounded to the nearest `f64`. It is hence bitwise identical for every number of
    /// ranks.
    pub fn sum(&self, number: impl Fn(usize, &[f64], &[f64]) -> Option<f64>) -> f64 {
        let (state, mut sum) = (self.state_of_rank(), ExactSum::EMPTY);
        let numbers = |half: &C| half.flat().iter().map(|leaf| leaf.to_f64()).collect::<Vec<_>>();
        let (q, p) = (numbers(&state.q), numbers(&state.p));
        let sites = q.chunks(C::COMPONENTS).zip(p.chunks(C::COMPONENTS)).zip(self.of_rank());
        sites.for_each(|((q, p), site)| number(site, q, p).into_iter().for_each(|x| sum.add(x)));
        sum.over_ranks(self.world).value()
    }
}
