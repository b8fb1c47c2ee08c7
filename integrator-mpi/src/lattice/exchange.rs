//! Exchange between the slabs of two ranks: the coordinates next to their border.

use crate::lattice::slab::{Neighbour, Slab};
use integrator_core::{__private::Precision, Coords, Phase};
use mpi::{
    request::{WaitGuard, scope},
    traits::{Communicator, Destination, Source},
};
use std::ops::Range;

/// The numbers of some sites: those of their positions, and after them those of their momenta.
pub(crate) fn numbers_of<C: Coords>(state: &Phase<C>, sites: Range<usize>) -> Vec<f64> {
    let leaves = sites.start * C::COMPONENTS..sites.end * C::COMPONENTS;
    let halves = [&state.q, &state.p].into_iter().flat_map(|half| &half.flat()[leaves.clone()]);
    halves.flat_map(|leaf| leaf.parts().into_iter().take(C::Leaf::PARTS)).collect()
}

/// Gives some sites these numbers.
pub(crate) fn put<C: Coords>(state: &mut Phase<C>, sites: Range<usize>, numbers: &[f64]) {
    let leaves = sites.start * C::COMPONENTS..sites.end * C::COMPONENTS;
    let mut numbers = numbers.chunks(C::Leaf::PARTS);
    for half in [&mut state.q, &mut state.p] {
        for (leaf, numbers) in half.flat_mut()[leaves.clone()].iter_mut().zip(numbers.by_ref()) {
            *leaf = C::Leaf::from_parts(std::array::from_fn(|part| numbers.get(part).copied().unwrap_or_default()));
        }
    }
}

/// How many numbers this number of sites are.
pub(crate) fn count<C: Coords>(sites: usize) -> usize {
    2 * sites * C::COMPONENTS * C::Leaf::PARTS
}

/// What the neighbours have at the sites of the halos on both sides, and what came of the work done while the messages travelled.
pub(crate) fn halos<C: Coords, T>(
    world: &impl Communicator,
    slab: &Slab,
    state: &Phase<C>,
    meanwhile: impl FnOnce() -> T,
) -> ([Vec<f64>; 2], T) {
    let sent = [0, 1].map(|side| match slab.neighbours[side] {
        Some(Neighbour { halo, .. }) => numbers_of(state, slab.edge(side, halo)),
        None => Vec::new(),
    });
    let mut received = [0, 1].map(|side| vec![0.0; count::<C>(slab.halos[side])]);
    // Two ranks that are each other's neighbours on both sides tell messages apart by the side that they left on.
    let done = scope(|scope| {
        let (mut receives, mut sends) = (Vec::with_capacity(2), Vec::with_capacity(2));
        for ((side, numbers), neighbour) in received.iter_mut().enumerate().zip(&slab.neighbours) {
            if let Some(Neighbour { rank, .. }) = neighbour {
                let from = world.process_at_rank(*rank);
                let receive = from.immediate_receive_into_with_tag(scope, &mut numbers[..], 1 - side as i32);
                receives.push(WaitGuard::from(receive));
            }
        }
        for ((side, numbers), neighbour) in sent.iter().enumerate().zip(&slab.neighbours) {
            if let Some(Neighbour { rank, .. }) = neighbour {
                let send = world.process_at_rank(*rank).immediate_send_with_tag(scope, &numbers[..], side as i32);
                sends.push(WaitGuard::from(send));
            }
        }
        meanwhile()
    });
    (received, done)
}

/// The number of the first site that both sides of a border know and that is not the same on them.
pub(crate) fn differing<C: Coords>(slab: &Slab, state: &Phase<C>, received: &[Vec<f64>; 2]) -> Option<usize> {
    (0..2).filter(|side| slab.neighbours[*side].is_some()).find_map(|side| {
        let (site, halo) = (slab.known_to_both(side), slab.halo(side));
        let (own, width) = (numbers_of(state, site..site + 1), count::<C>(1) / 2);
        // After the positions of all sites of the halo are their momenta.
        let theirs = [0, halo.len()].map(|first| &received[side][(first + site - halo.start) * width..][..width]);
        let same = own
            .iter()
            .zip(theirs.concat())
            .all(|(own, other)| own.to_bits() == other.to_bits() || own.is_nan() && other.is_nan());
        (!same).then(|| slab.indices()[site])
    })
}
