//! What coordinates get from turns that lie side by side.
//!
//! Always true: each gets its addends in the order in which they are given, whichever way they get there.

use super::table::{EIGHT, Eight};
use crate::{real::Real, row::Row};
use alloc::{collections::BTreeMap, vec::Vec};

/// An addend of a coordinate.
#[derive(Clone, Copy)]
pub(super) struct Addend {
    /// Where the coordinate is.
    pub(super) place: usize,
    /// Which of the numbers that rows of turns have found.
    pub(super) found: usize,
    /// The turn of the row.
    pub(super) turn: usize,
}

/// A round that is not laid out yet: which of the numbers, and for each of the eight the turn that adds to it.
type Sketch = (usize, [Option<u64>; EIGHT]);

/// What eight coordinates beside each other get from a row of turns, each from another one.
#[derive(Clone)]
pub(super) struct Round<R: Real> {
    /// Which of the numbers that rows have found.
    found: usize,
    /// The turn that adds to each of the eight, and which of them one adds to; nothing, where each gets what lies in its
    /// own place.
    picked: Option<([u64; EIGHT], <Eight<R> as Real>::Mask)>,
}

/// What the coordinates of a part get from all turns.
#[derive(Clone)]
pub(super) enum Addends<R: Real> {
    /// By eights of coordinates.
    Rounds(Vec<(usize, Vec<Round<R>>)>),
    /// One by one.
    Single(Vec<Addend>),
}

impl<R: Real> Default for Addends<R> {
    fn default() -> Self {
        Self::Single(Vec::new())
    }
}

impl<R: Real> Addends<R> {
    /// Those of the coordinates of a row of such a width, in the order in which they are added.
    pub(super) fn of(addends: Vec<Addend>, width: usize) -> Self {
        if width < EIGHT {
            return Self::Single(addends);
        }
        let mut eights: BTreeMap<usize, Vec<Sketch>> = BTreeMap::new();
        for Addend { place, found, turn } in addends {
            let (begin, place) = (place / EIGHT * EIGHT, place % EIGHT);
            let rounds = eights.entry(begin).or_default();
            // The next round after the last one of its coordinate, among those of the same numbers.
            let last = rounds.iter().rposition(|(_, turns)| turns[place].is_some()).map_or(0, |last| last + 1);
            match rounds[last..].iter_mut().find(|(own, _)| *own == found) {
                Some((_, turns)) => turns[place] = Some(turn as u64),
                None => {
                    let mut turns = [None; EIGHT];
                    turns[place] = Some(turn as u64);
                    rounds.push((found, turns));
                }
            }
        }
        let round = |(found, turns): Sketch| {
            if turns == core::array::from_fn(|turn| Some(turn as u64)) {
                return Round { found, picked: None };
            }
            let moved = turns.map(|turn| R::of(if turn.is_some() { 1.0 } else { 0.0 }));
            let moved = Eight::<R>::of(0.0).less(Eight::<R>::read(&moved));
            Round { found, picked: Some((turns.map(Option::unwrap_or_default), moved)) }
        };
        let eights = eights.into_iter().map(|(begin, rounds)| (begin, rounds.into_iter().map(round).collect()));
        Self::Rounds(eights.collect())
    }

    #[inline(always)]
    pub(super) fn add(&self, found: &[Eight<R>], to: &mut [R]) {
        match self {
            Self::Rounds(eights) => {
                for (begin, rounds) in eights {
                    let to = &mut to[*begin..];
                    let mut sum = <Eight<R> as Row<R>>::read(to);
                    for round in rounds {
                        let found = found[round.found];
                        sum = match &round.picked {
                            None => sum + found,
                            Some((turns, moved)) => Eight::<R>::select(*moved, sum + found.picked(turns), sum),
                        };
                    }
                    sum.write(to);
                }
            }
            Self::Single(addends) => {
                for addend in addends {
                    let mut numbers = [R::of(0.0); EIGHT];
                    found[addend.found].write(&mut numbers);
                    to[addend.place] += numbers[addend.turn];
                }
            }
        }
    }
}
