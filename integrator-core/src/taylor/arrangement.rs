//! Which turns lie side by side.

use super::table::EIGHT;
use crate::real::Real;
use alloc::{
    collections::{BTreeMap, VecDeque},
    vec,
    vec::Vec,
};

/// A turn before it is in a row: what it reads, its constants, and what it moves.
pub(super) type Turn<R, const READS: usize, const CONSTANTS: usize, const TARGETS: usize> =
    ([usize; READS], [R; CONSTANTS], [usize; TARGETS]);

/// Turns side by side; there may be fewer than lanes.
pub(super) type EightTurns<R, const READS: usize, const CONSTANTS: usize, const TARGETS: usize> =
    [Option<Turn<R, READS, CONSTANTS, TARGETS>>; EIGHT];

/// From how many turns the next one of a row is taken.
const NEAR: usize = 8 * EIGHT;

/// The turns in an order in which a row seldom moves the same coordinate by the same number: those have to be added one
/// after the other. `values` tells which targets count as moved by the same one.
pub(super) fn dealt<R: Real, const READS: usize, const CONSTANTS: usize, const TARGETS: usize>(
    turns: Vec<Turn<R, READS, CONSTANTS, TARGETS>>,
    values: [usize; TARGETS],
) -> Vec<EightTurns<R, READS, CONSTANTS, TARGETS>> {
    let mut dealt: Vec<Turn<R, READS, CONSTANTS, TARGETS>> = Vec::with_capacity(turns.len());
    // How often the present row moves each place by each number.
    let places = turns.iter().flat_map(|(.., places)| places).max().map_or(0, |last| last + 1);
    let mut moved = vec![0; places * TARGETS];
    let mut waiting = VecDeque::from(turns);
    let at = |(place, value): (&usize, usize)| place * TARGETS + value;
    while !waiting.is_empty() {
        if dealt.len().is_multiple_of(EIGHT) {
            moved.fill(0);
        }
        // How often what a turn moves is moved already: at most, and in all.
        let moves = |(.., places): &Turn<R, READS, CONSTANTS, TARGETS>| {
            let counts = places.iter().zip(values).map(|moves| moved[at(moves)]);
            counts.fold([0, 0], |[most, sum]: [usize; 2], count| [count.max(most), sum + count])
        };
        let mut least: Option<(usize, [usize; 2])> = None;
        for (next, turn) in waiting.iter().take(NEAR).enumerate() {
            let moves = moves(turn);
            if least.is_none_or(|(_, least)| moves < least) {
                least = Some((next, moves));
            }
            if moves == [0, 0] {
                break;
            }
        }
        let Some(next) = least.and_then(|(next, _)| waiting.remove(next)) else { break };
        for moves in next.2.iter().zip(values) {
            moved[at(moves)] += 1;
        }
        dealt.push(next);
    }
    by_eights(&dealt)
}

/// Turns side by side as they come.
fn by_eights<R: Real, const READS: usize, const CONSTANTS: usize, const TARGETS: usize>(
    turns: &[Turn<R, READS, CONSTANTS, TARGETS>],
) -> Vec<EightTurns<R, READS, CONSTANTS, TARGETS>> {
    turns.chunks(EIGHT).map(|turns| core::array::from_fn(|lane| turns.get(lane).copied())).collect()
}

/// Turns side by side, in the lanes of what they read first; without it, of what they move first.
pub(super) fn in_lanes<R: Real, const READS: usize, const CONSTANTS: usize, const TARGETS: usize>(
    turns: Vec<Turn<R, READS, CONSTANTS, TARGETS>>,
) -> Vec<EightTurns<R, READS, CONSTANTS, TARGETS>> {
    // By the register, and by how many have read the same place before.
    let mut rows: BTreeMap<[usize; 2], EightTurns<R, READS, CONSTANTS, TARGETS>> = BTreeMap::new();
    let mut before: BTreeMap<usize, usize> = BTreeMap::new();
    for turn in turns {
        let place = turn.0.first().or(turn.2.first()).copied().unwrap_or_default();
        let before = before.entry(place).or_default();
        rows.entry([place / EIGHT, *before]).or_insert([None; EIGHT])[place % EIGHT] = Some(turn);
        *before += 1;
    }
    rows.into_values().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// How many rounds it takes to add what rows of turns have found, where both targets get the same number.
    fn rounds(rows: &[EightTurns<f64, 2, 0, 2>]) -> usize {
        let of_row = |row: &EightTurns<f64, 2, 0, 2>| {
            let places = || row.iter().flatten().flat_map(|turn| turn.2);
            places().map(|place| places().filter(|other| *other == place).count()).max().unwrap_or_default()
        };
        rows.iter().map(of_row).sum()
    }

    fn turns(list: impl IntoIterator<Item = [usize; 2]>) -> Vec<Turn<f64, 2, 0, 2>> {
        list.into_iter().map(|places| (places, [], places)).collect()
    }

    #[test]
    fn turns_of_a_row_seldom_move_the_same_coordinate() {
        let pairs = turns((0..6).flat_map(|i| (0..i).map(move |j| [i, j])));
        let as_they_come = by_eights(&pairs);
        let dealt = dealt(pairs.clone(), [0, 0]);
        assert_eq!((rounds(&as_they_come), rounds(&dealt)), (9, 6));
        let mut found: Vec<_> = dealt.into_iter().flatten().flatten().collect();
        found.sort_by_key(|turn| turn.0);
        assert_eq!(found, pairs);
    }

    #[test]
    fn turns_lie_in_the_lanes_of_what_they_read() {
        // The third turn finds its lane taken, and the lane of the first one of the second register has none.
        let rows = in_lanes(turns([[3, 4], [9, 1], [3, 5]]));
        let lanes: Vec<Vec<usize>> = rows
            .iter()
            .map(|row| row.iter().enumerate().filter(|(_, turn)| turn.is_some()).map(|(lane, _)| lane).collect())
            .collect();
        assert_eq!(lanes, [vec![3], vec![3], vec![1]]);
        assert_eq!(rows[1][3].map(|turn| turn.0), Some([3, 5]));
    }
}
