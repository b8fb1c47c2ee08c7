//! The interval of integers that an index can take over all iterations. Each end is a number, or an unknown integer
//! plus or minus a number.

use super::{Index, IndexId, Loops};

/// A number, or a distance from an integer that is not known.
type Bound = (Option<IndexId>, i64);

/// Which of two integers stands for the smaller one of both, if both are known.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Ends {
    First,
    Second,
}

impl Ends {
    const BOTH: [Self; 2] = [Self::First, Self::Second];
}

impl Loops {
    /// Whether two indices of coordinates differ in any iterations of the loops around them: all integers that one of them
    /// may be come before those that the other one may be.
    pub(crate) fn differ(&self, a: IndexId, b: IndexId) -> bool {
        self.is_before(a, b) || self.is_before(b, a)
    }

    /// Whether all integers that an index may be come before those that another one may be.
    pub(crate) fn is_before(&self, a: IndexId, b: IndexId) -> bool {
        let Some((to, first)) = self.first(b) else { return false };
        Ends::BOTH.into_iter().filter_map(|ends| self.last(a, ends)).any(|(from, last)| from == to && last < first)
    }

    /// The least integer that an index may be.
    fn first(&self, id: IndexId) -> Option<Bound> {
        if self.is_signed(id) {
            return None;
        }
        let index = self.index(id);
        Some(match index {
            Index::Typed(_, a) => return self.first(a),
            Index::Running(by) => return self.first(self.get(by).from),
            Index::Add(a, b) => sum(self.first(a)?, self.first(b)?)?,
            // Where that is below zero, so is what the index may not be.
            Index::Sub(a, b) | Index::Monus(a, b) => difference(self.first(a)?, self.last(b, Ends::First)?)?,
            _ => self.alone(id).unwrap_or((None, 0)),
        })
    }

    /// The greatest integer that an index may be, or one that it never exceeds.
    fn last(&self, id: IndexId, ends: Ends) -> Option<Bound> {
        if self.is_signed(id) {
            return None;
        }
        Some(match self.index(id) {
            Index::Typed(_, a) => return self.last(a, ends),
            Index::Running(by) => {
                let (from, end) = self.end(self.get(by).to, ends)?;
                (from, end.checked_sub(1)?)
            }
            Index::Add(a, b) => sum(self.last(a, ends)?, self.last(b, ends)?)?,
            Index::Sub(a, b) => difference(self.last(a, ends)?, self.first(b)?)?,
            Index::Monus(a, b) => match difference(self.last(a, ends)?, self.first(b)?)? {
                (None, number) => (None, number.max(0)),
                _ => return None,
            },
            Index::Rem(_, b) => difference(self.last(b, ends)?, (None, 1))?,
            Index::Min(a, b) => {
                let (one, other) = if ends == Ends::First { (a, b) } else { (b, a) };
                self.last(one, ends).or_else(|| self.last(other, ends))?
            }
            _ => return self.alone(id),
        })
    }

    /// The end of a loop, where it has an iteration: a difference that would be below zero ends it before it begins.
    fn end(&self, to: IndexId, ends: Ends) -> Option<Bound> {
        match self.index(to) {
            Index::Monus(a, b) if !self.is_signed(to) => difference(self.end(a, ends)?, self.first(b)?),
            _ => self.last(to, ends),
        }
    }

    /// An integer that is the same in all iterations.
    fn alone(&self, id: IndexId) -> Option<Bound> {
        match self.literal(id) {
            Some(number) => Some((None, i64::try_from(number).ok()?)),
            None => self.of_index(id).is_empty().then_some((Some(id), 0)),
        }
    }
}

fn sum(a: Bound, b: Bound) -> Option<Bound> {
    match (a, b) {
        ((from, by), (None, more)) | ((None, more), (from, by)) => Some((from, by.checked_add(more)?)),
        _ => None,
    }
}

fn difference((from, by): Bound, taken: Bound) -> Option<Bound> {
    match taken {
        (None, less) => Some((from, by.checked_sub(less)?)),
        (other, less) if from == other => Some((None, by.checked_sub(less)?)),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::graph::index::Loop;

    #[test]
    fn indices_differ_where_one_ends_before_the_other_begins() {
        let mut loops = Loops::default();
        let [zero, one, two, eight] = [0, 1, 2, 8].map(|number| loops.intern(Index::Literal(number)));
        let length = loops.intern(Index::Length);
        let last = loops.intern(Index::Sub(length, one));
        let before_last = loops.intern(Index::Monus(length, one));
        let mut index = |from, to| {
            let by = loops.range(Loop { parent: None, from, to });
            loops.intern(Index::Running(by))
        };
        let [head, tail, all, but_last, further] =
            [(zero, two), (two, eight), (zero, length), (zero, before_last), (one, length)].map(|(a, b)| index(a, b));
        let next = loops.intern(Index::Add(but_last, one));
        let below = loops.intern(Index::Monus(head, one));
        for (a, b, differ) in [
            (zero, one, true),
            (one, one, false),
            (head, tail, true),
            (head, one, false),
            (head, eight, true),
            (below, zero, false),
            (below, two, true),
            (further, zero, true),
            (further, one, false),
            (all, last, false),
            (but_last, last, true),
            (next, last, false),
            (next, zero, true),
            (but_last, eight, false),
            (length, last, true),
        ] {
            assert_eq!((loops.differ(a, b), loops.differ(b, a)), (differ, differ), "{a:?} {b:?}");
        }
    }
}
