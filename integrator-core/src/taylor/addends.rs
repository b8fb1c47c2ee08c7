//! What coordinates get from turns that lie side by side.
//!
//! Always true: in which order a coordinate gets its addends follows from the turns and their targets alone, so that bits
//! do not depend on how numbers get there.

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
    pub(super) lane: usize,
    /// One, or minus one where it is taken away.
    pub(super) sign: i8,
}

/// What each of eight coordinates beside each other gets from a row of numbers: that of a lane, and with which sign.
type Pattern = [Option<(usize, i8)>; EIGHT];

/// The patterns in which places get numbers of a row, each one at most at a time.
fn patterns(addends: &[Addend]) -> Vec<Pattern> {
    let mut patterns: Vec<Pattern> = Vec::new();
    for Addend { place, lane, sign, .. } in addends {
        let (place, gets) = (place % EIGHT, Some((*lane, *sign)));
        match patterns.iter_mut().find(|pattern| pattern[place].is_none()) {
            Some(pattern) => pattern[place] = gets,
            None => {
                let mut pattern = [None; EIGHT];
                pattern[place] = gets;
                patterns.push(pattern);
            }
        }
    }
    patterns
}

/// What the eights of a group get from as many rows of numbers beside each other, by the same pattern.
#[derive(Clone)]
struct Round<R: Real> {
    /// The first one of the rows.
    found: usize,
    /// The lanes of which each coordinate gets the numbers, if they are not all its own,
    lanes: Option<[u64; EIGHT]>,
    /// and with which signs: zero, where it gets none.
    signs: Eight<R>,
}

/// `N` times eight coordinates, such as the components of points, with the same patterns: each is looked at once for all.
#[derive(Clone)]
pub(super) struct Group<R: Real, const N: usize> {
    /// Where the eights begin.
    begins: [usize; N],
    rounds: Vec<Round<R>>,
}

/// Where an eight begins, and from which row it gets numbers in each round.
type Rounds = (usize, Vec<usize>);

impl<R: Real, const N: usize> Group<R, N> {
    /// As many eights as there are in such a group, where their rows are beside each other.
    fn of(patterns: &[Pattern], eights: &[Rounds; N]) -> Option<Self> {
        let found = &eights[0].1;
        let beside =
            |(number, (_, rows)): (usize, &Rounds)| rows.iter().zip(found).all(|(row, first)| *row == first + number);
        if !eights.iter().enumerate().all(beside) {
            return None;
        }
        let rounds = patterns.iter().zip(found).map(|(pattern, found)| {
            let signs = pattern.map(|gets| R::of(gets.map_or(0.0, |(_, sign)| f64::from(sign))));
            // What a lane has computed without a turn may be no number, which no factor makes zero.
            let some = pattern.iter().flatten().next().map_or(0, |(lane, _)| *lane);
            let lanes = pattern.map(|gets| gets.map_or(some, |(lane, _)| lane) as u64);
            let is_own = lanes == core::array::from_fn(|lane| lane as u64);
            Round { found: *found, lanes: (!is_own).then_some(lanes), signs: Eight::<R>::read(&signs) }
        });
        Some(Self { begins: core::array::from_fn(|eight| eights[eight].0), rounds: rounds.collect() })
    }

    #[inline(always)]
    fn add<const AT_ONCE: usize>(&self, found: &[[Eight<R>; AT_ONCE]], to: &mut Coefficients<'_, R>, order: usize) {
        let mut sums = [[Eight::<R>::of(0.0); AT_ONCE]; N];
        for eight in 0..N {
            for at in 0..AT_ONCE {
                sums[eight][at] = Row::read(&to[order + at][self.begins[eight]..]);
            }
        }
        for Round { found: first, lanes, signs } in &self.rounds {
            let rows = &found[*first..][..N];
            match lanes {
                None => {
                    for eight in 0..N {
                        for at in 0..AT_ONCE {
                            sums[eight][at] = rows[eight][at].fma(*signs, sums[eight][at]);
                        }
                    }
                }
                Some(lanes) => {
                    for eight in 0..N {
                        for at in 0..AT_ONCE {
                            sums[eight][at] = rows[eight][at].picked(lanes).fma(*signs, sums[eight][at]);
                        }
                    }
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
    /// Those of the coordinates of a row of such a width.
    pub(super) fn of(addends: Vec<Addend>, width: usize) -> Self {
        if width < EIGHT {
            return Self::Single(addends);
        }
        // By eights, and what each gets by rows.
        let mut eights: BTreeMap<usize, BTreeMap<usize, Vec<Addend>>> = BTreeMap::new();
        for addend in addends {
            let rows = eights.entry(addend.place / EIGHT * EIGHT).or_default();
            rows.entry(addend.found).or_default().push(addend);
        }
        let mut alike: BTreeMap<Vec<Pattern>, Vec<Rounds>> = BTreeMap::new();
        for (begin, rows) in eights {
            let rounds = rows.iter().flat_map(|(found, addends)| patterns(addends).into_iter().map(|of| (of, *found)));
            let (patterns, found) = rounds.unzip();
            alike.entry(patterns).or_default().push((begin, found));
        }
        let (mut threes, mut twos, mut ones) = (Vec::new(), Vec::new(), Vec::new());
        for (patterns, eights) in &alike {
            let mut rest = eights.as_slice();
            while group(patterns, &mut rest, &mut threes)
                || group(patterns, &mut rest, &mut twos)
                || group(patterns, &mut rest, &mut ones)
            {}
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
                for Addend { place, found: number, lane, sign } in addends {
                    for (at, found) in found[*number].iter().enumerate() {
                        let mut numbers = [R::of(0.0); EIGHT];
                        found.write(&mut numbers);
                        to[order + at][*place] += R::of(f64::from(*sign)) * numbers[*lane];
                    }
                }
            }
        }
    }
}

/// Takes the first eights away as a group, if they are one.
fn group<R: Real, const N: usize>(patterns: &[Pattern], eights: &mut &[Rounds], groups: &mut Vec<Group<R, N>>) -> bool {
    let Some((first, others)) = eights.split_first_chunk() else { return false };
    let Some(group) = Group::of(patterns, first) else { return false };
    groups.push(group);
    *eights = others;
    true
}

#[cfg(test)]
impl<R: Real> Addends<R> {
    /// How often eight coordinates get a row of numbers as it is, and how often in other lanes.
    pub(super) fn rounds(&self) -> [usize; 2] {
        let Self::Groups(threes, twos, ones) = self else { return [0; 2] };
        let groups = threes.iter().map(|group| (3, &group.rounds));
        let groups = groups.chain(twos.iter().map(|group| (2, &group.rounds)));
        let groups = groups.chain(ones.iter().map(|group| (1, &group.rounds)));
        groups.fold([0; 2], |[own, other], (eights, rounds)| {
            let of_own = rounds.iter().filter(|round| round.lanes.is_none()).count();
            [own + eights * of_own, other + eights * (rounds.len() - of_own)]
        })
    }
}
