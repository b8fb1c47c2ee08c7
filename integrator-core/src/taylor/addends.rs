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

/// What each of eight coordinates beside each other gets from a row of numbers.
type Pattern = [Option<usize>; EIGHT];

/// The patterns in which places get numbers of a row, each one at most at a time.
fn patterns(addends: &[[usize; 2]]) -> Vec<Pattern> {
    let mut patterns: Vec<Pattern> = Vec::new();
    for [place, turn] in addends {
        match patterns.iter_mut().find(|pattern| pattern[*place].is_none()) {
            Some(pattern) => pattern[*place] = Some(*turn),
            None => {
                let mut pattern = [None; EIGHT];
                pattern[*place] = Some(*turn);
                patterns.push(pattern);
            }
        }
    }
    patterns
}

/// What `N` times eight coordinates get from as many rows of numbers, by the same pattern.
#[derive(Clone)]
struct Round<R: Real, const N: usize> {
    /// Which of the rows.
    found: [usize; N],
    /// What each coordinate gets of it,
    turns: [u64; EIGHT],
    /// and which of them get something.
    moved: <Eight<R> as Real>::Mask,
}

/// `N` times eight coordinates, such as the components of points, with the same patterns: each is looked at once for all.
#[derive(Clone)]
pub(super) struct Group<R: Real, const N: usize> {
    /// Where the eights begin.
    begins: [usize; N],
    rounds: Vec<Round<R, N>>,
}

impl<R: Real, const N: usize> Group<R, N> {
    /// The eights, each with its beginning and its rows.
    fn of(patterns: &[Pattern], eights: &[(usize, Vec<usize>); N]) -> Self {
        let round = |(number, pattern): (usize, &Pattern)| {
            let moved = pattern.map(|turn| R::of(if turn.is_some() { 1.0 } else { 0.0 }));
            Round {
                found: core::array::from_fn(|eight| eights[eight].1[number]),
                turns: pattern.map(|turn| turn.unwrap_or_default() as u64),
                moved: Eight::<R>::of(0.0).less(Eight::<R>::read(&moved)),
            }
        };
        Self {
            begins: core::array::from_fn(|eight| eights[eight].0),
            rounds: patterns.iter().enumerate().map(round).collect(),
        }
    }

    #[inline(always)]
    fn add<const AT_ONCE: usize>(&self, found: &[[Eight<R>; AT_ONCE]], to: &mut Coefficients<'_, R>, order: usize) {
        let mut sums = [[Eight::<R>::of(0.0); AT_ONCE]; N];
        for eight in 0..N {
            for at in 0..AT_ONCE {
                sums[eight][at] = Row::read(&to[order + at][self.begins[eight]..]);
            }
        }
        for Round { found: rows, turns, moved } in &self.rounds {
            for eight in 0..N {
                let found = &found[rows[eight]];
                for at in 0..AT_ONCE {
                    let sum = sums[eight][at];
                    sums[eight][at] = Eight::<R>::select(*moved, sum + found[at].picked(turns), sum);
                }
            }
        }
        for eight in 0..N {
            for at in 0..AT_ONCE {
                sums[eight][at].write(&mut to[order + at][self.begins[eight]..]);
            }
        }
    }
}

/// What the coordinates of a part get from all turns.
#[derive(Clone)]
pub(super) enum Addends<R: Real> {
    /// By eights of coordinates, three, two or one at a time.
    Groups(Vec<Group<R, 3>>, Vec<Group<R, 2>>, Vec<Group<R, 1>>),
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
        let mut alike: BTreeMap<Vec<Pattern>, Vec<(usize, Vec<usize>)>> = BTreeMap::new();
        for (begin, rows) in eights {
            let rounds = rows.iter().flat_map(|(found, addends)| patterns(addends).into_iter().map(|of| (of, *found)));
            let (patterns, found) = rounds.unzip();
            alike.entry(patterns).or_default().push((begin, found));
        }
        let (mut threes, mut twos, mut ones) = (Vec::new(), Vec::new(), Vec::new());
        for (patterns, eights) in &alike {
            let (by_three, rest) = eights.as_chunks();
            let (by_two, rest) = rest.as_chunks();
            let (by_one, _) = rest.as_chunks();
            threes.extend(by_three.iter().map(|eights| Group::of(patterns, eights)));
            twos.extend(by_two.iter().map(|eights| Group::of(patterns, eights)));
            ones.extend(by_one.iter().map(|eights| Group::of(patterns, eights)));
        }
        Self::Groups(threes, twos, ones)
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
            Self::Groups(threes, twos, ones) => {
                for group in threes {
                    group.add(found, to, order);
                }
                for group in twos {
                    group.add(found, to, order);
                }
                for group in ones {
                    group.add(found, to, order);
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
