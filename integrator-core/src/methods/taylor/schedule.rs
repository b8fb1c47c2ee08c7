//! The scheduling of iterations into blocks of eight, which share vectors.
//!
//! Iterations are numbers here, whatever they compute in: so all of this is compiled once, and not with every system.

use super::table::EIGHT;
use alloc::{
    collections::{BTreeMap, VecDeque},
    vec,
    vec::Vec,
};

/// The indices that each iteration reads and moves, in the order of the loops.
#[derive(Clone, Default)]
pub(super) struct IterationList {
    reads: Vec<usize>,
    targets: Vec<usize>,
    count: usize,
}

impl IterationList {
    /// Appends an iteration. All of them have as many indices.
    pub(super) fn push(&mut self, reads: &[usize], targets: &[usize]) {
        self.reads.extend_from_slice(reads);
        self.targets.extend_from_slice(targets);
        self.count += 1;
    }
    /// The indices that an iteration reads.
    pub(super) fn reads(&self, iteration: usize) -> &[usize] {
        of_iteration(&self.reads, iteration, self.count)
    }
    /// The indices that an iteration moves.
    pub(super) fn targets(&self, iteration: usize) -> &[usize] {
        of_iteration(&self.targets, iteration, self.count)
    }
}

/// The indices of one of this number of iterations.
fn of_iteration(indices: &[usize], iteration: usize, count: usize) -> &[usize] {
    let each = indices.len() / count;
    &indices[iteration * each..][..each]
}

/// The iteration in each lane of a block, if there is one.
pub(super) type BlockLanes = [Option<usize>; EIGHT];

/// The number of waiting iterations among which the next one of a block is chosen.
const WINDOW: usize = 8 * EIGHT;

/// A list schedule of the iterations, in which a block seldom moves a coordinate by the same value twice: such addends
/// are added one after the other. `values` is the value of each target.
pub(super) fn list_schedule(iterations: &IterationList, values: &[usize]) -> Vec<BlockLanes> {
    let mut order: Vec<usize> = Vec::with_capacity(iterations.count);
    // How often the present block moves each index by each value.
    let indices = iterations.targets.iter().max().map_or(0, |last| last + 1);
    let mut moved = vec![0; indices * values.len()];
    let mut waiting: VecDeque<usize> = (0..iterations.count).collect();
    let at = |(index, value): (&usize, &usize)| index * values.len() + value;
    while !waiting.is_empty() {
        if order.len().is_multiple_of(EIGHT) {
            moved.fill(0);
        }
        // How often the targets of an iteration are moved already: at most, and in all.
        let moves = |iteration: usize| {
            let counts = iterations.targets(iteration).iter().zip(values).map(|moves| moved[at(moves)]);
            counts.fold([0, 0], |[most, sum]: [usize; 2], count| [count.max(most), sum + count])
        };
        let mut least: Option<(usize, [usize; 2])> = None;
        for (next, iteration) in waiting.iter().take(WINDOW).enumerate() {
            let moves = moves(*iteration);
            if least.is_none_or(|(_, least)| moves < least) {
                least = Some((next, moves));
            }
            if moves == [0, 0] {
                break;
            }
        }
        let Some(next) = least.and_then(|(next, _)| waiting.remove(next)) else { break };
        for moves in iterations.targets(next).iter().zip(values) {
            moved[at(moves)] += 1;
        }
        order.push(next);
    }
    blocks(&order)
}

/// The block of a single iteration.
pub(super) fn single(iteration: usize) -> BlockLanes {
    let mut lanes = [None; EIGHT];
    lanes[0] = Some(iteration);
    lanes
}

/// Blocks of consecutive iterations.
fn blocks(iterations: &[usize]) -> Vec<BlockLanes> {
    iterations.chunks(EIGHT).map(|iterations| core::array::from_fn(|lane| iterations.get(lane).copied())).collect()
}

/// Blocks whose iterations are in the lanes of their first reads; without these, of their first targets.
pub(super) fn by_lane(iterations: &IterationList) -> Vec<BlockLanes> {
    // By vector, and by the number of earlier iterations that read the same index.
    let mut blocks: BTreeMap<[usize; 2], BlockLanes> = BTreeMap::new();
    let mut before: BTreeMap<usize, usize> = BTreeMap::new();
    for iteration in 0..iterations.count {
        let index =
            iterations.reads(iteration).first().or(iterations.targets(iteration).first()).copied().unwrap_or_default();
        let before = before.entry(index).or_default();
        blocks.entry([index / EIGHT, *before]).or_insert([None; EIGHT])[index % EIGHT] = Some(iteration);
        *before += 1;
    }
    blocks.into_values().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The number of passes that add the values of all blocks, where both targets get the same value.
    fn passes(iterations: &IterationList, blocks: &[BlockLanes]) -> usize {
        let of_block = |block: &BlockLanes| {
            let indices = || block.iter().flatten().flat_map(|iteration| iterations.targets(*iteration));
            indices().map(|index| indices().filter(|other| *other == index).count()).max().unwrap_or_default()
        };
        blocks.iter().map(of_block).sum()
    }

    fn iterations(list: impl IntoIterator<Item = [usize; 2]>) -> IterationList {
        let mut iterations = IterationList::default();
        for indices in list {
            iterations.push(&indices, &indices);
        }
        iterations
    }

    #[test]
    fn iterations_of_a_block_seldom_move_the_same_coordinate() {
        let pairs = iterations((0..6).flat_map(|i| (0..i).map(move |j| [i, j])));
        let in_order = blocks(&(0..pairs.count).collect::<Vec<_>>());
        let scheduled = list_schedule(&pairs, &[0, 0]);
        assert_eq!((passes(&pairs, &in_order), passes(&pairs, &scheduled)), (9, 6));
        let mut all: Vec<usize> = scheduled.into_iter().flatten().flatten().collect();
        all.sort_unstable();
        assert!(all.into_iter().eq(0..pairs.count));
    }

    #[test]
    fn iterations_are_in_the_lanes_of_their_reads() {
        // The lane of the third iteration is taken; the second vector has one iteration, in lane 1.
        let blocks = by_lane(&iterations([[3, 4], [9, 1], [3, 5]]));
        let lanes: Vec<Vec<usize>> = blocks
            .iter()
            .map(|block| {
                block.iter().enumerate().filter(|(_, iteration)| iteration.is_some()).map(|(lane, _)| lane).collect()
            })
            .collect();
        assert_eq!(lanes, [vec![3], vec![3], vec![1]]);
        assert_eq!(blocks[1][3], Some(2));
    }
}
