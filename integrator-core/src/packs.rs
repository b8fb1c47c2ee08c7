//! The members of an ensemble, dealt out to packs.

use crate::{
    coords::Coords,
    energies::{EnergyOf, energy},
    group::GroupMoves,
    hamiltonian::{Hamiltonian, Prepared, Shaped},
    in_lanes::InLanes,
    method::Method,
    moves::Moves,
    pack::{Alone, Pack, Start},
    real::Real,
    side_by_side::SideBySide,
    slot::Keep,
};

/// How many packs a thread gets, so that all threads end at about the same time, and how large a pack may grow, so that
/// those who leave early leave a gap in few of the motions.
const PACKS_PER_THREAD: usize = 4;
const GROUPS_PER_PACK: usize = 16;

/// A member of a system as it starts with a method.
pub(crate) type StartOf<H, X, K> =
    Start<<H as Hamiltonian>::Parameters<f64>, <X as Method<H>>::Constants, Shaped<H, K>>;

/// Neighbours that are alike in what lanes have to share go side by side, in packs of such a size that threads can share
/// them; whoever is like no neighbour goes alone.
pub(crate) fn packs<H: Hamiltonian, X: InLanes<H>, L: Real, R: Real, K: Keep, const REGISTERS: usize>(
    members: Vec<StartOf<H, X, K>>,
    threads: usize,
) -> Vec<Box<dyn Pack<Shaped<H, K>>>> {
    let together: GroupMoves<X::Motion<L, K>> = X::group_moves::<L, K, REGISTERS>();
    let alone: Moves<X::Motion<R, K>> = X::moves::<R, K>();
    let energy: EnergyOf<H::Parameters<f64>, Shaped<H, K>> = energy::<H, R, K>;
    let group = together.lanes * together.together;
    let size = group * (members.len() / (group * PACKS_PER_THREAD * threads)).clamp(1, GROUPS_PER_PACK);
    let mut packs: Vec<Box<dyn Pack<Shaped<H, K>>>> = Vec::new();
    let mut members = members.into_iter().peekable();
    let mut first = 0;
    while let Some(member) = members.next() {
        let mut alike = vec![member];
        while alike.len() < size
            && let Some(next) = members.next_if(|next| {
                let same = <H::Parameters<f64> as Prepared<f64>>::alike(&alike[0].parameters, &next.parameters);
                same && alike[0].state.q.length() == next.state.q.length()
            })
        {
            alike.push(next);
        }
        let count = alike.len();
        packs.push(match <[_; 1]>::try_from(alike) {
            Ok([member]) => Box::new(Alone::new(first, member, alone, energy)),
            Err(alike) => Box::new(SideBySide::new(first, alike, together, energy)),
        });
        first += count;
    }
    packs
}
