//! What coordinates get from iterations that lie side by side.
//!
//! Always true: in which order a coordinate gets its addends follows from the iterations and their targets alone, so
//! that bits do not depend on how numbers get there.

use super::table::{Coefficients, EIGHT, Wide, is_narrow};
use crate::scalar::{real::Real, simd::row::Row};
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

/// Up to how many eights are in a group.
const MOST: usize = 3;

/// One, two or three times eight coordinates, such as the components of points, with the same patterns: each is looked
/// at once for all.
struct Group {
    /// Where the eights begin.
    begins: [usize; MOST],
    /// How many rounds they get.
    rounds: usize,
}

/// What the eights of a group get from as many rows of numbers beside each other, by the same pattern: the signs are
/// numbers of the kind `S`.
struct Round<S> {
    /// The first one of the rows.
    found: usize,
    /// The lanes of which each coordinate gets the numbers, if they are not all its own,
    lanes: Option<[u64; EIGHT]>,
    /// and with which signs: zero, where it gets none.
    signs: S,
}

/// Where an eight begins, and from which row it gets numbers in each round.
type Rounds = (usize, Vec<usize>);

/// How the coordinates of a part get their addends.
struct Plan<S> {
    /// By eights of coordinates, first the groups of three, then those of two and of one,
    groups: [Vec<Group>; MOST],
    /// with the rounds of one behind those of the one before it;
    rounds: Vec<Round<S>>,
    /// or one by one.
    single: Vec<Addend>,
}

impl<S> Default for Plan<S> {
    fn default() -> Self {
        Self { groups: [Vec::new(), Vec::new(), Vec::new()], rounds: Vec::new(), single: Vec::new() }
    }
}

/// Whatever numbers are computed in: compiled once, and not with every system.
impl Plan<[i8; EIGHT]> {
    /// That of the coordinates of a row of such a width.
    fn of(addends: Vec<Addend>, width: usize) -> Self {
        let mut plan = Self::default();
        if width < EIGHT {
            plan.single = addends;
            return plan;
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
        let mut groups = Vec::new();
        for (patterns, eights) in &alike {
            let mut rest = eights.as_slice();
            while !rest.is_empty() {
                // One is beside itself.
                let count = (1..=MOST.min(rest.len())).rev().find(|count| are_beside(&rest[..*count])).unwrap_or(1);
                let (group, others) = rest.split_at(count);
                groups.push((patterns, group));
                rest = others;
            }
        }
        groups.sort_by_key(|(_, eights)| MOST - eights.len());
        for (patterns, eights) in groups {
            let begins = core::array::from_fn(|eight| eights.get(eight).map_or(0, |(begin, _)| *begin));
            plan.groups[MOST - eights.len()].push(Group { begins, rounds: patterns.len() });
            plan.rounds.extend(patterns.iter().zip(&eights[0].1).map(|(pattern, found)| Round {
                found: *found,
                lanes: lanes(pattern),
                signs: pattern.map(|gets| gets.map_or(0, |(_, sign)| sign)),
            }));
        }
        plan
    }
}

/// Whether the rows of eights are beside each other.
fn are_beside(eights: &[Rounds]) -> bool {
    let is_beside = |(number, (_, rows)): (usize, &Rounds)| {
        rows.iter().zip(&eights[0].1).all(|(row, first)| *row == first + number)
    };
    eights.iter().enumerate().all(is_beside)
}

/// The lanes of which coordinates get numbers, if they are not all their own.
fn lanes(pattern: &Pattern) -> Option<[u64; EIGHT]> {
    // What a lane has computed without an iteration may be no number, which no factor makes zero.
    let some = pattern.iter().flatten().next().map_or(0, |(lane, _)| *lane);
    let lanes = pattern.map(|gets| gets.map_or(some, |(lane, _)| lane) as u64);
    let is_own = lanes == core::array::from_fn(|lane| lane as u64);
    (!is_own).then_some(lanes)
}

/// What the coordinates of a part get from all iterations.
pub(super) struct Addends<R: Real>(Plan<Wide<R>>);

impl<R: Real> Default for Addends<R> {
    fn default() -> Self {
        Self(Plan::default())
    }
}

impl<R: Real> Addends<R> {
    /// Those of the coordinates of a row of such a width.
    pub(super) fn of(addends: Vec<Addend>, width: usize) -> Self {
        let plan = Plan::of(addends, if is_narrow::<R>() { 0 } else { width });
        let mut rounds = Vec::with_capacity(plan.rounds.len());
        for Round { found, lanes, signs } in &plan.rounds {
            let mut numbers = [R::of(0.0); EIGHT];
            for lane in 0..EIGHT {
                numbers[lane] = R::of(f64::from(signs[lane]));
            }
            rounds.push(Round { found: *found, lanes: *lanes, signs: Wide::<R>::read(&numbers) });
        }
        Self(Plan { groups: plan.groups, rounds, single: plan.single })
    }

    /// Adds numbers of as many orders to the coefficients from this order on.
    #[inline(always)]
    pub(super) fn add<const AT_ONCE: usize>(
        &self,
        found: &[[Wide<R>; AT_ONCE]],
        to: &mut Coefficients<'_, R>,
        order: usize,
    ) {
        let Plan { groups: [threes, twos, ones], rounds, single } = &self.0;
        let mut rounds = rounds.as_slice();
        if const { !is_narrow::<R>() } {
            for group in threes {
                rounds = add_to::<R, AT_ONCE, 3>(group, rounds, found, to, order);
            }
            for group in twos {
                rounds = add_to::<R, AT_ONCE, 2>(group, rounds, found, to, order);
            }
            for group in ones {
                rounds = add_to::<R, AT_ONCE, 1>(group, rounds, found, to, order);
            }
        }
        for Addend { place, found: number, lane, sign } in single {
            for at in 0..AT_ONCE {
                let number = in_lane(found[*number][at], *lane);
                to[order + at][*place] += R::of(f64::from(*sign)) * number;
            }
        }
    }
}

/// The number in a lane.
#[inline(always)]
fn in_lane<R: Real>(numbers: Wide<R>, lane: usize) -> R {
    if const { is_narrow::<R>() } {
        let mut single = [R::of(0.0)];
        numbers.write(&mut single);
        return single[0];
    }
    let mut lanes = [R::of(0.0); EIGHT];
    numbers.write(&mut lanes);
    lanes[lane]
}

/// Adds what a group of so many eights gets, of the first rounds, and tells the others.
#[inline(always)]
fn add_to<'r, R: Real, const AT_ONCE: usize, const EIGHTS: usize>(
    group: &Group,
    rounds: &'r [Round<Wide<R>>],
    found: &[[Wide<R>; AT_ONCE]],
    to: &mut Coefficients<'_, R>,
    order: usize,
) -> &'r [Round<Wide<R>>] {
    let mut sums = [[Wide::<R>::of(0.0); AT_ONCE]; EIGHTS];
    for eight in 0..EIGHTS {
        for at in 0..AT_ONCE {
            sums[eight][at] = Row::read(&to[order + at][group.begins[eight]..]);
        }
    }
    let (rounds, others) = rounds.split_at(group.rounds);
    for Round { found: first, lanes, signs } in rounds {
        let rows = &found[*first..][..EIGHTS];
        match lanes {
            None => {
                for eight in 0..EIGHTS {
                    for at in 0..AT_ONCE {
                        sums[eight][at] = rows[eight][at].fma(*signs, sums[eight][at]);
                    }
                }
            }
            Some(lanes) => {
                for eight in 0..EIGHTS {
                    for at in 0..AT_ONCE {
                        sums[eight][at] = rows[eight][at].permute(lanes).fma(*signs, sums[eight][at]);
                    }
                }
            }
        }
    }
    for eight in 0..EIGHTS {
        for at in 0..AT_ONCE {
            sums[eight][at].write(&mut to[order + at][group.begins[eight]..]);
        }
    }
    others
}

/// How often eight coordinates get a row of numbers as it is, and how often in other lanes.
#[cfg(test)]
pub(super) fn rounds(addends: Vec<Addend>, width: usize) -> [usize; 2] {
    let plan = Plan::of(addends, width);
    let mut rounds = plan.rounds.iter();
    let mut counts = [0; 2];
    for (groups, eights) in plan.groups.iter().zip([3, 2, 1]) {
        for round in groups.iter().flat_map(|group| rounds.by_ref().take(group.rounds).collect::<Vec<_>>()) {
            counts[usize::from(round.lanes.is_some())] += eights;
        }
    }
    counts
}
