//! The states of all ranks, gathered on one of them.

use crate::{Ensemble, ROOT, is_root};
use integrator_core::{
    __private::{Precision, coordinates, numbers},
    Coords, Phase,
};
use mpi::{
    point_to_point::{Destination, Source},
    traits::{Communicator, Equivalence},
};

/// How many numbers a message has at most: MPI counts them in 31 bits.
const IN_A_MESSAGE: usize = 1 << 27;

/// Sends numbers, of which the other side knows how many there are.
pub(crate) fn send_all<T: Equivalence>(to: &impl Destination, numbers: &[T]) {
    numbers.chunks(IN_A_MESSAGE).for_each(|chunk| to.send(chunk));
}

/// Receives this number of numbers from another rank.
pub(crate) fn receive_all<T: Equivalence + Default + Clone>(from: &impl Source, count: usize) -> Vec<T> {
    let mut numbers = vec![T::default(); count];
    numbers.chunks_mut(IN_A_MESSAGE).for_each(|chunk| {
        from.receive_into(chunk);
    });
    numbers
}

impl<W: Communicator, C: Coords> Ensemble<'_, W, C> {
    /// Returns the states of all members on rank 0, in their order, and `None` on all other ranks. Collective.
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
            send_all(&root, &lengths);
            send_all(&root, &all);
            return None;
        }
        let mut states: Vec<Phase<C>> = own().collect();
        for rank in 1..self.world().size() {
            let rank = self.world().process_at_rank(rank);
            let (counts, _) = rank.receive_vec::<u64>();
            let [members, count] = counts[..] else { continue };
            let lengths: Vec<u64> = receive_all(&rank, members as usize);
            let all: Vec<f64> = receive_all(&rank, count as usize);
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
