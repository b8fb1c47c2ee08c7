//! What coordinates get from turns that lie side by side.
//!
//! Always true: what a row of turns has found for a coordinate is added up on its own, turn by turn, and what rows have
//! found one after the other, in the order that is given. So no row waits for another, and bits do not depend on how
//! numbers get there.

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

/// What eight coordinates beside each other get from a row of turns.
#[derive(Clone)]
pub(super) struct Share<R: Real> {
    /// Which of the numbers that rows have found.
    found: usize,
    /// In each round, the turn that adds to each of the eight, and which of them one adds to; none, where each gets what
    /// lies in its own place.
    rounds: Vec<([u64; EIGHT], <Eight<R> as Real>::Mask)>,
}

impl<R: Real> Share<R> {
    /// The turns that add to places of an eight.
    fn of(found: usize, addends: &[[usize; 2]]) -> Self {
        if addends.len() == EIGHT && addends.iter().all(|[place, turn]| place == turn) {
            return Self { found, rounds: Vec::new() };
        }
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
        let masked = |round: [Option<usize>; EIGHT]| {
            let moved = round.map(|turn| R::of(if turn.is_some() { 1.0 } else { 0.0 }));
            let moved = Eight::<R>::of(0.0).less(Eight::<R>::read(&moved));
            (round.map(|turn| turn.unwrap_or_default() as u64), moved)
        };
        Self { found, rounds: rounds.into_iter().map(masked).collect() }
    }
}

/// What the coordinates of a part get from all turns.
#[derive(Clone)]
pub(super) enum Addends<R: Real> {
    /// By eights of coordinates.
    Shares(Vec<(usize, Vec<Share<R>>)>),
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
        let mut eights: BTreeMap<usize, BTreeMap<usize, Vec<[usize; 2]>>> = BTreeMap::new();
        let mut order = Vec::new();
        for Addend { place, found, turn } in addends {
            let of_found = eights.entry(place / EIGHT * EIGHT).or_default();
            of_found.entry(found).or_default().push([place % EIGHT, turn]);
            if order.last() != Some(&found) {
                order.push(found);
            }
        }
        let shares = |mut of_found: BTreeMap<usize, Vec<[usize; 2]>>| {
            order.iter().filter_map(|found| Some(Share::of(*found, &of_found.remove(found)?))).collect()
        };
        Self::Shares(eights.into_iter().map(|(begin, of_found)| (begin, shares(of_found))).collect())
    }

    #[inline(always)]
    pub(super) fn add(&self, found: &[Eight<R>], to: &mut [R]) {
        match self {
            Self::Shares(eights) => {
                for (begin, shares) in eights {
                    let to = &mut to[*begin..];
                    let mut sum = <Eight<R> as Row<R>>::read(to);
                    for Share { found: number, rounds } in shares {
                        let found = found[*number];
                        // Minus zero is what nothing has been added to.
                        let mut own = if rounds.is_empty() { found } else { Eight::<R>::of(-0.0) };
                        for (turns, moved) in rounds {
                            own = Eight::<R>::select(*moved, own + found.picked(turns), own);
                        }
                        sum += own;
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
