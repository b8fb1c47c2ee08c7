//! Bounds of integers over all indices of loops.

use super::{Index, IndexId, Loop, LoopId, Loops};

/// The largest number of steps to decide which of two expressions is smaller.
pub(in crate::graph) const DEEPEST: u32 = 8;

impl Loops {
    /// An expression without running indices that is never below `id` (taking parts as unsigned), if one is known.
    pub(crate) fn upper(&mut self, id: IndexId) -> Option<IndexId> {
        if self.of_index(id).is_empty() {
            return Some(id);
        }
        if self.is_signed(id) {
            return None;
        }
        let bound = match self.index(id) {
            Index::Typed(_, a) => return self.upper(a),
            Index::Wrapped(kind, _) if kind.bits < 64 => Index::Literal((1 << kind.bits) - 1),
            Index::Running(by) => {
                let one = self.intern(Index::Literal(1));
                let to = self.get(by).to;
                Index::Monus(self.upper(to)?, one)
            }
            Index::Add(a, b) => Index::Add(self.upper(a)?, self.upper(b)?),
            Index::Sub(a, b) | Index::Monus(a, b) => Index::Monus(self.upper(a)?, self.lower(b)?),
            Index::Mul(a, b) => Index::Mul(self.upper(a)?, self.upper(b)?),
            Index::Div(a, b) => Index::Div(self.upper(a)?, self.lower(b)?),
            Index::Rem(_, b) => {
                let one = self.intern(Index::Literal(1));
                Index::Monus(self.upper(b)?, one)
            }
            // Either is a bound.
            Index::Min(a, b) => match (self.upper(a), self.upper(b)) {
                (Some(a), Some(b)) => Index::Min(a, b),
                (a, b) => return a.or(b),
            },
            Index::InPlane(row, site) => {
                let number = self.number_in_plane(row, site);
                return self.upper(number);
            }
            Index::Parameter(id) => return self.range_of(id).map(|(_, greatest)| greatest),
            Index::Literal(_) | Index::Length | Index::Minus(..) | Index::Wrapped(..) => return None,
        };
        Some(self.intern(bound))
    }

    /// An expression without running indices that is never above `id`, if one is known.
    pub(crate) fn lower(&mut self, id: IndexId) -> Option<IndexId> {
        if self.of_index(id).is_empty() {
            return Some(id);
        }
        if self.is_signed(id) {
            return None;
        }
        let bound = match self.index(id) {
            Index::Typed(_, a) => return self.lower(a),
            Index::Wrapped(..) => Index::Literal(0),
            Index::Running(by) => {
                let from = self.get(by).from;
                return self.lower(from);
            }
            Index::Add(a, b) => Index::Add(self.lower(a)?, self.lower(b)?),
            Index::Mul(a, b) => Index::Mul(self.lower(a)?, self.lower(b)?),
            Index::Sub(a, b) | Index::Monus(a, b) => Index::Monus(self.lower(a)?, self.upper(b)?),
            Index::Div(a, b) => Index::Div(self.lower(a)?, self.upper(b)?),
            Index::Rem(..) => Index::Literal(0),
            Index::Min(a, b) => Index::Min(self.lower(a)?, self.lower(b)?),
            Index::InPlane(row, site) => {
                let number = self.number_in_plane(row, site);
                return self.lower(number);
            }
            Index::Parameter(id) => return self.range_of(id).map(|(least, _)| least),
            Index::Literal(_) | Index::Length | Index::Minus(..) => return None,
        };
        Some(self.intern(bound))
    }

    /// Whether an integer is positive where a loop has an iteration: it is the end of the loop, or at most as far before the end
    /// as the loop begins after zero.
    pub(crate) fn ends_after(&self, by: LoopId, id: IndexId) -> bool {
        let Loop { from, to, .. } = self.get(by);
        match self.index(id) {
            _ if [id, from, to].into_iter().any(|bound| self.is_signed(bound)) => false,
            _ if id == to => true,
            Index::Sub(end, less) | Index::Monus(end, less) if end == to => {
                self.literal(less).is_some_and(|less| less <= self.least(from))
            }
            _ => false,
        }
    }

    /// A number that an integer is never below.
    fn least(&self, id: IndexId) -> u64 {
        match self.index(id) {
            Index::Literal(number) => number,
            Index::Add(a, b) => self.least(a).saturating_add(self.least(b)),
            Index::Running(by) => self.least(self.get(by).from),
            _ => 0,
        }
    }

    /// Whether `a <= b` whatever the values of what is not known; `false` where it takes more than `depth` steps to
    /// see.
    pub(in crate::graph) fn is_at_most(&self, a: IndexId, b: IndexId, depth: u32) -> bool {
        if a == b || self.literal(a).zip(self.literal(b)).is_some_and(|(a, b)| a <= b) {
            return true;
        }
        let Some(depth) = depth.checked_sub(1) else { return false };
        let is = |a, b| self.is_at_most(a, b, depth);
        let by_amount = match (self.index(a), self.index(b)) {
            // x - s <= x - t where t <= s
            (Index::Monus(x, s), Index::Monus(y, t)) => x == y && is(t, s),
            // x + s <= x + t where s <= t
            (Index::Add(x, s), Index::Add(y, t)) => x == y && is(s, t),
            _ => false,
        };
        let from_left = match self.index(a) {
            Index::Monus(x, _) => is(x, b),
            Index::Div(x, _) if !self.is_signed(x) => is(x, b),
            Index::Min(x, y) => is(x, b) || is(y, b),
            // It is read inside of its loop alone, and below its end there.
            Index::Running(by) => is(self.get(by).to, b),
            _ => false,
        };
        // a <= (x - s) + s where a <= x
        let refilled = |rest, s| matches!(self.index(rest), Index::Monus(x, taken) if taken == s && is(a, x));
        let from_right = || match self.index(b) {
            Index::Add(x, y) => is(a, x) || is(a, y) || refilled(x, y) || refilled(y, x),
            Index::Min(x, y) => is(a, x) && is(a, y),
            _ => false,
        };
        by_amount || from_left || from_right()
    }
}
