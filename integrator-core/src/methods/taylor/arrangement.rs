//! Which iterations lie side by side.
//!
//! Iterations are numbers here, whatever they compute in: so all of this is compiled once, and not with every system.

use super::table::EIGHT;
use alloc::{
    collections::{BTreeMap, VecDeque},
    vec,
    vec::Vec,
};

/// What iterations read and move, in the order of the loops: so many places each.
#[derive(Clone, Default)]
pub(super) struct List {
    reads: Vec<usize>,
    targets: Vec<usize>,
    count: usize,
}

impl List {
    /// Another iteration. All of them read and move as many places.
    pub(super) fn push(&mut self, reads: &[usize], targets: &[usize]) {
        self.reads.extend_from_slice(reads);
        self.targets.extend_from_slice(targets);
        self.count += 1;
    }
    /// What an iteration reads.
    pub(super) fn reads(&self, iteration: usize) -> &[usize] {
        of_iteration(&self.reads, iteration, self.count)
    }
    /// What an iteration moves.
    pub(super) fn targets(&self, iteration: usize) -> &[usize] {
        of_iteration(&self.targets, iteration, self.count)
    }
}

/// The places of one of so many iterations.
fn of_iteration(places: &[usize], iteration: usize, count: usize) -> &[usize] {
    let each = places.len() / count;
    &places[iteration * each..][..each]
}

/// The numbers of iterations side by side; there may be fewer than lanes.
pub(super) type EightIterations = [Option<usize>; EIGHT];

/// From how many iterations the next one of a row is taken.
const NEAR: usize = 8 * EIGHT;

/// The iterations in an order in which a row seldom moves the same coordinate by the same number: those have to be
/// added one after the other. `values` tells which targets count as moved by the same one.
pub(super) fn dealt(iterations: &List, values: &[usize]) -> Vec<EightIterations> {
    let mut dealt: Vec<usize> = Vec::with_capacity(iterations.count);
    // How often the present row moves each place by each number.
    let places = iterations.targets.iter().max().map_or(0, |last| last + 1);
    let mut moved = vec![0; places * values.len()];
    let mut waiting: VecDeque<usize> = (0..iterations.count).collect();
    let at = |(place, value): (&usize, &usize)| place * values.len() + value;
    while !waiting.is_empty() {
        if dealt.len().is_multiple_of(EIGHT) {
            moved.fill(0);
        }
        // How often what an iteration moves is moved already: at most, and in all.
        let moves = |iteration: usize| {
            let counts = iterations.targets(iteration).iter().zip(values).map(|moves| moved[at(moves)]);
            counts.fold([0, 0], |[most, sum]: [usize; 2], count| [count.max(most), sum + count])
        };
        let mut least: Option<(usize, [usize; 2])> = None;
        for (next, iteration) in waiting.iter().take(NEAR).enumerate() {
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
        dealt.push(next);
    }
    by_eights(&dealt)
}

/// One iteration, with none beside it.
pub(super) fn alone(iteration: usize) -> EightIterations {
    let mut alone = [None; EIGHT];
    alone[0] = Some(iteration);
    alone
}

/// Iterations side by side as they come.
fn by_eights(iterations: &[usize]) -> Vec<EightIterations> {
    iterations.chunks(EIGHT).map(|iterations| core::array::from_fn(|lane| iterations.get(lane).copied())).collect()
}

/// Iterations side by side, in the lanes of what they read first; without it, of what they move first.
pub(super) fn in_lanes(iterations: &List) -> Vec<EightIterations> {
    // By the register, and by how many have read the same place before.
    let mut rows: BTreeMap<[usize; 2], EightIterations> = BTreeMap::new();
    let mut before: BTreeMap<usize, usize> = BTreeMap::new();
    for iteration in 0..iterations.count {
        let place =
            iterations.reads(iteration).first().or(iterations.targets(iteration).first()).copied().unwrap_or_default();
        let before = before.entry(place).or_default();
        rows.entry([place / EIGHT, *before]).or_insert([None; EIGHT])[place % EIGHT] = Some(iteration);
        *before += 1;
    }
    rows.into_values().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// How many rounds it takes to add what rows of iterations have found, where both targets get the same number.
    fn rounds(iterations: &List, rows: &[EightIterations]) -> usize {
        let of_row = |row: &EightIterations| {
            let places = || row.iter().flatten().flat_map(|iteration| iterations.targets(*iteration));
            places().map(|place| places().filter(|other| *other == place).count()).max().unwrap_or_default()
        };
        rows.iter().map(of_row).sum()
    }

    fn iterations(list: impl IntoIterator<Item = [usize; 2]>) -> List {
        let mut iterations = List::default();
        for places in list {
            iterations.push(&places, &places);
        }
        iterations
    }

    #[test]
    fn iterations_of_a_row_seldom_move_the_same_coordinate() {
        let pairs = iterations((0..6).flat_map(|i| (0..i).map(move |j| [i, j])));
        let as_they_come = by_eights(&(0..pairs.count).collect::<Vec<_>>());
        let dealt = dealt(&pairs, &[0, 0]);
        assert_eq!((rounds(&pairs, &as_they_come), rounds(&pairs, &dealt)), (9, 6));
        let mut found: Vec<usize> = dealt.into_iter().flatten().flatten().collect();
        found.sort_unstable();
        assert!(found.into_iter().eq(0..pairs.count));
    }

    #[test]
    fn iterations_lie_in_the_lanes_of_what_they_read() {
        // The third iteration finds its lane taken, and the lane of the first one of the second register has none.
        let rows = in_lanes(&iterations([[3, 4], [9, 1], [3, 5]]));
        let lanes: Vec<Vec<usize>> = rows
            .iter()
            .map(|row| {
                row.iter().enumerate().filter(|(_, iteration)| iteration.is_some()).map(|(lane, _)| lane).collect()
            })
            .collect();
        assert_eq!(lanes, [vec![3], vec![3], vec![1]]);
        assert_eq!(rows[1][3], Some(2));
    }
}
