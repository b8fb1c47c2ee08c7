//! The members of an ensemble, dealt out to batches.

use crate::{
    ensemble::batch::{Batch, States},
    trajectory::motions::Motions,
};
use std::ops::Range;

/// The number of batches per thread, so that all threads end at about the same time, and the largest size of a batch,
/// so that a member that leaves early leaves a gap in few of the motions.
const BATCHES_PER_THREAD: usize = 4;
const GROUPS_PER_BATCH: usize = 16;

/// The starts of members, by their numbers.
pub(crate) struct Starts<'s> {
    pub(crate) states: &'s States<'s>,
    /// Whether two members may share lanes.
    pub(crate) alike: &'s dyn Fn(usize, usize) -> bool,
    /// An empty list of motions whose lanes members may share.
    pub(crate) lanes: &'s dyn Motions,
    /// An empty list of motions for a member that shares none: it is computed as a run would be.
    pub(crate) single: &'s dyn Motions,
}

impl Starts<'_> {
    /// The batches of all members: neighbours that may share lanes, as many as leave several batches to every thread. A
    /// member that can share lanes with no neighbour has a batch of its own.
    pub(crate) fn batches(&self, members: usize, threads: usize) -> Vec<Batch> {
        let group = self.lanes.lanes() * self.lanes.together();
        let size = group * (members / (group * BATCHES_PER_THREAD * threads)).clamp(1, GROUPS_PER_BATCH);
        let batch = |members: Range<usize>| {
            let motions = if members.len() == 1 { self.single } else { self.lanes };
            Batch::new(members, motions, self.states)
        };
        neighbours(members, size, self.alike).into_iter().map(batch).collect()
    }
}

/// Groups of neighbours that may share lanes, of this size at most.
pub(crate) fn neighbours(members: usize, size: usize, alike: &dyn Fn(usize, usize) -> bool) -> Vec<Range<usize>> {
    let (mut groups, mut first) = (Vec::new(), 0);
    while first < members {
        let most = members.min(first + size);
        let end = (first + 1..most).find(|next| !alike(first, *next)).unwrap_or(most);
        groups.push(first..end);
        first = end;
    }
    groups
}
