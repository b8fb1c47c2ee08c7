//! States of all ranks on one of them.

use crate::{Ensemble, ROOT, is_root};
use integrator_core::__private::Precision;
use integrator_core::{Coords, Phase};
use mpi::{
    point_to_point::{Destination, Source},
    traits::Communicator,
};

/// How many numbers a message has at most: MPI counts them in 31 bits.
const IN_A_MESSAGE: usize = 1 << 27;

impl<W: Communicator, C: Coords> Ensemble<'_, W, C> {
    /// The states of all members on rank 0, in their order, and `None` on all other ranks. Collective.
    pub fn states_on_root(&self) -> Option<Vec<Phase<C>>> {
        let own = || self.members_of_rank().map(|member| member.state);
        if !is_root(self.world()) {
            let root = self.world().process_at_rank(ROOT);
            let (mut lengths, mut numbers) = (Vec::new(), Vec::new());
            for Phase { q, p } in own() {
                lengths.push(q.flat().len() as u64);
                numbers.extend([q, p].iter().flat_map(|half| numbers_of(half)));
            }
            root.send(&[lengths.len() as u64, numbers.len() as u64]);
            lengths.chunks(IN_A_MESSAGE).for_each(|chunk| root.send(chunk));
            numbers.chunks(IN_A_MESSAGE).for_each(|chunk| root.send(chunk));
            return None;
        }
        let mut states: Vec<Phase<C>> = own().collect();
        for rank in 1..self.world().size() {
            let rank = self.world().process_at_rank(rank);
            let (counts, _) = rank.receive_vec::<u64>();
            let [members, numbers] = counts[..] else { continue };
            let (mut lengths, mut all) = (vec![0_u64; members as usize], vec![0.0_f64; numbers as usize]);
            for chunk in lengths.chunks_mut(IN_A_MESSAGE) {
                rank.receive_into(chunk);
            }
            for chunk in all.chunks_mut(IN_A_MESSAGE) {
                rank.receive_into(chunk);
            }
            let mut rest = &all[..];
            let mut half = |length: u64| {
                let (own, after) = rest.split_at(length as usize * C::Leaf::PARTS);
                rest = after;
                coordinates(own)
            };
            for length in lengths {
                // What a rank sent has the shape that it has there.
                if let (Some(q), Some(p)) = (half(length), half(length)) {
                    states.push(Phase { q, p });
                }
            }
        }
        Some(states)
    }
}

/// The numbers that some coordinates are made of, one after the other.
pub(crate) fn numbers_of<C: Coords>(coordinates: &C) -> impl Iterator<Item = f64> {
    coordinates.flat().iter().flat_map(|leaf| leaf.parts().into_iter().take(C::Leaf::PARTS))
}

/// The coordinates that are made of these numbers, if there are so many.
fn coordinates<C: Coords>(numbers: &[f64]) -> Option<C> {
    let leaves = numbers.chunks(C::Leaf::PARTS).map(|chunk| {
        let mut parts = [0.0; 2];
        parts[..chunk.len()].copy_from_slice(chunk);
        C::Leaf::from_parts(parts)
    });
    C::from_flat(leaves.collect())
}
