//! States of all ranks on one of them.

use crate::{Ensemble, ROOT, is_root};
use integrator_core::{
    __private::{Precision, coordinates, numbers},
    Coords, Phase,
};
use mpi::{
    point_to_point::{Destination, Source},
    traits::Communicator,
};

/// How many numbers a message has at most: MPI counts them in 31 bits.
pub(crate) const IN_A_MESSAGE: usize = 1 << 27;

impl<W: Communicator, C: Coords> Ensemble<'_, W, C> {
    /// The states of all members on rank 0, in their order, and `None` on all other ranks. Collective.
    pub fn states_on_root(&self) -> Option<Vec<Phase<C>>> {
        let own = || self.members_of_rank().map(|member| member.state);
        if !is_root(self.world()) {
            let root = self.world().process_at_rank(ROOT);
            let (mut lengths, mut all) = (Vec::new(), Vec::new());
            for Phase { q, p } in own() {
                lengths.push(q.flat().len() as u64);
                all.extend([q, p].iter().flat_map(numbers));
            }
            root.send(&[lengths.len() as u64, all.len() as u64]);
            lengths.chunks(IN_A_MESSAGE).for_each(|chunk| root.send(chunk));
            all.chunks(IN_A_MESSAGE).for_each(|chunk| root.send(chunk));
            return None;
        }
        let mut states: Vec<Phase<C>> = own().collect();
        for rank in 1..self.world().size() {
            let rank = self.world().process_at_rank(rank);
            let (counts, _) = rank.receive_vec::<u64>();
            let [members, count] = counts[..] else { continue };
            let (mut lengths, mut all) = (vec![0_u64; members as usize], vec![0.0_f64; count as usize]);
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
