//! Simplification of integer expressions.

use super::{DEEPEST, Index, IndexId, Loops};

impl Loops {
    pub(super) fn fold(&mut self, index: Index) -> Index {
        // (x + s) + t == x + (s + t)
        if let Index::Add(a, t) = index
            && let Index::Add(x, s) = self.index(a)
            && let Some(both) = self.literal(s).zip(self.literal(t)).and_then(|(s, t)| s.checked_add(t))
        {
            return Index::Add(x, self.intern(Index::Literal(both)));
        }
        // a - (a - x) == x
        if let Index::Sub(a, b) = index
            && let Index::Sub(whole, x) = self.index(b)
            && whole == a
        {
            return self.index(x);
        }
        match index {
            Index::Monus(a, b) => return self.monus(a, b),
            Index::Min(a, b) => return self.min(a, b),
            _ => {}
        }
        let numbers = |a, b| Some((self.signed_literal(a)?, self.signed_literal(b)?));
        let folded = match index {
            Index::Add(a, b) if self.literal(b) == Some(0) => return self.index(a),
            Index::Add(a, b) if self.literal(a) == Some(0) => return self.index(b),
            Index::Sub(a, b) | Index::Minus(a, b) if self.literal(b) == Some(0) => return self.index(a),
            Index::Mul(a, b) if self.literal(b) == Some(1) => return self.index(a),
            Index::Mul(a, b) if self.literal(a) == Some(1) => return self.index(b),
            Index::Add(a, b) => numbers(a, b).and_then(|(a, b)| a.checked_add(b)),
            Index::Sub(a, b) => numbers(a, b).and_then(|(a, b)| a.checked_sub(b)).filter(|difference| *difference >= 0),
            Index::Minus(a, b) => numbers(a, b).and_then(|(a, b)| a.checked_sub(b)),
            Index::Mul(a, b) => numbers(a, b).and_then(|(a, b)| a.checked_mul(b)),
            Index::Div(a, b) => numbers(a, b).and_then(|(a, b)| a.checked_div(b)),
            Index::Rem(a, b) => numbers(a, b).and_then(|(a, b)| a.checked_rem(b)),
            Index::Wrapped(kind, a) => self.signed_literal(a).map(|value| kind.wrapped(value)),
            Index::Typed(_, a) => self.signed_literal(a),
            _ => None,
        };
        folded.map_or(index, |value| self.of_signed(value))
    }

    /// `max(a - b, 0)`, simplified.
    fn monus(&mut self, a: IndexId, b: IndexId) -> Index {
        if let (Index::Literal(a), Index::Literal(b)) = (self.index(a), self.index(b)) {
            return Index::Literal(a.saturating_sub(b));
        }
        if let Some((a, b)) = self.signed_literal(a).zip(self.signed_literal(b)) {
            return self.of_signed(a.saturating_sub(b).max(0));
        }
        match (self.index(a), self.index(b), self.literal(b)) {
            // (x + s) - (x - t) == s + t
            (Index::Add(x, s), Index::Minus(y, t), _) if x == y => {
                let both = self.intern(Index::Add(s, t));
                self.index(both)
            }
            (_, Index::Minus(x, t), _) if a == x => self.index(t),
            // a - (0 - t) == a + t
            (_, Index::Minus(zero, t), _)
                if self.literal(zero) == Some(0) && !self.is_signed(a) && !self.is_signed(t) =>
            {
                let both = self.intern(Index::Add(a, t));
                self.index(both)
            }
            _ if self.is_signed(a) || self.is_signed(b) => Index::Monus(a, b),
            (known, _, Some(0)) => known,
            (Index::Literal(0), ..) => Index::Literal(0),
            _ if a == b => Index::Literal(0),
            (Index::Add(rest, added), ..) if added == b => self.index(rest),
            (Index::Add(added, rest), ..) if added == b => self.index(rest),
            (Index::Add(rest, added), _, Some(taken)) => {
                let Some(added) = self.literal(added) else { return Index::Monus(a, b) };
                let (more, less) = (added.saturating_sub(taken), taken.saturating_sub(added));
                let (more, less) = (self.intern(Index::Literal(more)), self.intern(Index::Literal(less)));
                let rest = self.intern(Index::Add(rest, more));
                // One of both is zero.
                if self.literal(less) == Some(0) { self.index(rest) } else { self.monus(rest, less) }
            }
            (Index::Monus(rest, first), _, Some(second)) => {
                let Some(first) = self.literal(first) else { return Index::Monus(a, b) };
                let both = self.intern(Index::Literal(first.saturating_add(second)));
                Index::Monus(rest, both)
            }
            // The end of a zip is where the nearer end is.
            (Index::Min(first, second), ..) => {
                let first = self.intern(Index::Monus(first, b));
                let second = self.intern(Index::Monus(second, b));
                self.min(first, second)
            }
            _ => Index::Monus(a, b),
        }
    }

    /// The smaller one, simplified; a literal stands on the right.
    fn min(&mut self, a: IndexId, b: IndexId) -> Index {
        if self.is_at_most(a, b, DEEPEST) {
            return self.index(a);
        }
        if self.is_at_most(b, a, DEEPEST) {
            return self.index(b);
        }
        match (self.literal(a), self.literal(b)) {
            (Some(_), None) => Index::Min(b, a),
            (None, Some(_)) => Index::Min(a, b),
            _ => Index::Min(a.min(b), a.max(b)),
        }
    }
}
