//! What coordinates get from turns that lie side by side.
//!
//! Always true: a coordinate gets its addends in the order in which they are given, row of turns by row, so that bits do not
//! depend on how numbers get there.

use super::table::{Coefficients, EIGHT, Eight};
use crate::{real::Real, row::Row};
use alloc::{collections::BTreeMap, vec::Vec};

/// An addend of a coordinate.
#[derive(Clone, Copy)]
pub(super) struct Addend {
    /// Where the coordinate is.
    pub(super) place: usize,
    /// Which of the rows of numbers that have been found.
    pub(super) found: usize,
    /// Where it is in this row.
    pub(super) turn: usize,
}

/// What eight coordinates beside each other get from a row of numbers, one each at most.
#[derive(Clone)]
pub(super) struct Round<R: Real> {
    /// Which of the rows.
    found: usize,
    /// What each coordinate gets of it,
    turns: [u64; EIGHT],
    /// and which of them get something.
    moved: <Eight<R> as Real>::Mask,
}

impl<R: Real> Round<R> {
    /// The rounds in which places of an eight get numbers of a row.
    fn of(found: usize, addends: &[[usize; 2]]) -> impl Iterator<Item = Self> {
        let mut rounds: Vec<[Option<usize>; EIGHT]> = Vec::new();
        for [place, turn] in addends {
            match rounds.iter_mut().find(|round| round[*place].is_none()) {
                Some(round) => round[*place] = Some(*turn),
                None => {
                    let mut round = [None; EIGHT];
                    round[*place] = Some(*turn);
                    rounds.push(round);
                }
            }
        }
        rounds.into_iter().map(move |round| {
            let moved = round.map(|turn| R::of(if turn.is_some() { 1.0 } else { 0.0 }));
            let moved = Eight::<R>::of(0.0).less(Eight::<R>::read(&moved));
            Self { found, turns: round.map(|turn| turn.unwrap_or_default() as u64), moved }
        })
    }
}

/// What the coordinates of a part get from all turns.
#[derive(Clone)]
pub(super) enum Addends<R: Real> {
    /// By eights of coordinates, which begin here.
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
        // What places of an eight get from turns of a row, row by row.
        type OfRows = Vec<(usize, Vec<[usize; 2]>)>;
        let mut eights: BTreeMap<usize, OfRows> = BTreeMap::new();
        for Addend { place, found, turn } in addends {
            let rows = eights.entry(place / EIGHT * EIGHT).or_default();
            let added = [place % EIGHT, turn];
            match rows.last_mut().filter(|(row, _)| *row == found) {
                Some((_, row)) => row.push(added),
                None => rows.push((found, Vec::from([added]))),
            }
        }
        let rounds = |rows: OfRows| rows.iter().flat_map(|(found, addends)| Round::of(*found, addends)).collect();
        Self::Rounds(eights.into_iter().map(|(begin, rows)| (begin, rounds(rows))).collect())
    }

    /// Adds numbers of as many orders to the coefficients from this order on.
    #[inline(always)]
    pub(super) fn add<const AT_ONCE: usize>(
        &self,
        found: &[[Eight<R>; AT_ONCE]],
        to: &mut Coefficients<'_, R>,
        order: usize,
    ) {
        match self {
            Self::Rounds(eights) => {
                for (begin, rounds) in eights {
                    let mut sums = [Eight::<R>::of(0.0); AT_ONCE];
                    for at in 0..AT_ONCE {
                        sums[at] = Row::read(&to[order + at][*begin..]);
                    }
                    for Round { found: number, turns, moved } in rounds {
                        let found = &found[*number];
                        for at in 0..AT_ONCE {
                            sums[at] = Eight::<R>::select(*moved, sums[at] + found[at].picked(turns), sums[at]);
                        }
                    }
                    for at in 0..AT_ONCE {
                        sums[at].write(&mut to[order + at][*begin..]);
                    }
                }
            }
            Self::Single(addends) => {
                for Addend { place, found: number, turn } in addends {
                    for (at, found) in found[*number].iter().enumerate() {
                        let mut numbers = [R::of(0.0); EIGHT];
                        found.write(&mut numbers);
                        to[order + at][*place] += numbers[*turn];
                    }
                }
            }
        }
    }
}
