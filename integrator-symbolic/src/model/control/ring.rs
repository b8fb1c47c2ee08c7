//! Choices at the end of a ring.
//!
//! In: the condition, and two integers or two coordinates. Out: the integer with a remainder, as in `(i + 1) % n`, or the
//! coordinate there. So both spellings are one expression. Always true: the remainder equals the choice in every iteration.

use crate::{
    graph::{
        Comparison, Element, Node, NodeId,
        index::{Index, IndexId},
    },
    model::{Reader, values::value::Value},
};

impl Reader<'_> {
    /// The coordinate that a choice between two is at the end of a ring: `if i + 1 == n { q[0] } else { q[i + 1] }`, and in a row or
    /// a column of a plane `if x + 1 == w { q[y * w] } else { q[y * w + x + 1] }`.
    pub(super) fn coordinate_of_ring(&mut self, condition: NodeId, a: &Value, b: &Value) -> Option<NodeId> {
        let [Value::Real(a), Value::Real(b)] = [a, b] else { return None };
        let [Node::Coordinate(a), Node::Coordinate(b)] = [*a, *b].map(|id| self.graph.node(id)) else { return None };
        let element = match [(a.component, b.component), (Some(a.index), Some(b.index))] {
            _ if a.part != b.part => return None,
            [(one, other), _] if one == other => {
                Element { index: self.wrapped_sum(condition, [a.index, b.index])?, ..a }
            }
            [(Some(one), Some(other)), (index, same)] if index == same => {
                Element { component: Some(self.wrapped_sum(condition, [one, other])?), ..a }
            }
            _ => return None,
        };
        Some(self.graph.coordinate(element))
    }

    /// A choice between two sums whose other addends are the same, perhaps of multiples of a width.
    fn wrapped_sum(&mut self, condition: NodeId, both: [IndexId; 2]) -> Option<IndexId> {
        let [first, second] = both.map(|index| {
            let mut found = Vec::new();
            self.add_addends(index, &mut found);
            found
        });
        let loops = &mut self.graph.loops;
        let is_common = |addend: &(IndexId, bool)| {
            let (id, is_less) = *addend;
            !is_less && loops.literal(id).is_none() && first.contains(addend) && second.contains(addend)
        };
        let (common, one): (Vec<_>, Vec<_>) = first.iter().copied().partition(is_common);
        let other: Vec<_> = second.iter().copied().filter(|addend| !common.contains(addend)).collect();
        let rests = [self.sum_of_addends(&one)?, self.sum_of_addends(&other)?];
        let wrapped = self.wrapped_multiple(condition, rests)?;
        // Rows come before the sites in them.
        let of_row = matches!(self.graph.loops.index(wrapped), Index::Mul(..));
        let place = if of_row { 0 } else { common.len() };
        let mut addends = common;
        addends.insert(place, (wrapped, false));
        self.sum_of_addends(&addends)
    }

    /// The addends of a sum, and whether they are subtracted.
    fn add_addends(&self, index: IndexId, found: &mut Vec<(IndexId, bool)>) {
        match self.graph.loops.index(index) {
            Index::Add(a, b) => [a, b].into_iter().for_each(|part| self.add_addends(part, found)),
            Index::Sub(a, b) if self.graph.loops.literal(b).is_some() => {
                self.add_addends(a, found);
                found.push((b, true));
            }
            _ => found.push((index, false)),
        }
    }

    fn sum_of_addends(&mut self, addends: &[(IndexId, bool)]) -> Option<IndexId> {
        let loops = &mut self.graph.loops;
        let Some(((first, false), others)) = addends.split_first() else {
            return addends.is_empty().then(|| loops.intern(Index::Literal(0)));
        };
        let sum = |sum, (addend, is_less): &(IndexId, bool)| {
            loops.intern(if *is_less { Index::Sub(sum, *addend) } else { Index::Add(sum, *addend) })
        };
        Some(others.iter().fold(*first, sum))
    }

    /// A choice between two integers, or between such multiples of one factor.
    fn wrapped_multiple(&mut self, condition: NodeId, [a, b]: [IndexId; 2]) -> Option<IndexId> {
        if let Some(wrapped) = self.wrapped(condition, a, b) {
            return Some(wrapped);
        }
        let loops = &self.graph.loops;
        let varies = |id: IndexId| !loops.of_index(id).is_empty();
        let factor = [a, b].into_iter().find_map(|id| match loops.index(id) {
            Index::Mul(row, factor) | Index::Mul(factor, row) if varies(row) && !varies(factor) => Some(factor),
            _ => None,
        })?;
        let quotient = |id| match loops.index(id) {
            Index::Mul(other, known) | Index::Mul(known, other) if known == factor => Some(other),
            Index::Literal(0) => Some(id),
            _ => None,
        };
        let (a, b) = (quotient(a)?, quotient(b)?);
        let wrapped = self.wrapped(condition, a, b)?;
        Some(self.graph.loops.intern(Index::Mul(wrapped, factor)))
    }

    /// The remainder that a choice between two integers is at the end of a ring: `if i + 1 == n { 0 } else { i + 1 }` and
    /// `if i == 0 { n - 1 } else { i - 1 }` with `i` below `n`.
    pub(crate) fn wrapped(&mut self, condition: NodeId, a: IndexId, b: IndexId) -> Option<IndexId> {
        let one = self.literal_index(1);
        let (left, right, at_edge, inside) = match self.graph.node(condition) {
            Node::CompareIndex(Comparison::Equal, left, right) => (left, right, a, b),
            Node::CompareIndex(Comparison::Less, left, right) if a == left => (left, right, b, a),
            Node::Not(inner) => match self.graph.node(inner) {
                Node::CompareIndex(Comparison::Equal, left, right) => (left, right, b, a),
                _ => return None,
            },
            _ => return None,
        };
        let loops = &mut self.graph.loops;
        if let Index::Running(by) = loops.index(left)
            && loops.literal(right) == Some(0)
            && loops.index(inside) == Index::Sub(left, one)
        {
            let size = loops.get(by).to;
            if loops.intern(Index::Sub(size, one)) != at_edge {
                return None;
            }
            let before = loops.intern(Index::Add(left, at_edge));
            return Some(loops.intern(Index::Rem(before, size)));
        }
        // `if i == n - 1 { 0 } else { i + 1 }`
        if let Index::Running(by) = loops.index(left)
            && loops.literal(at_edge) == Some(0)
            && loops.index(inside) == Index::Add(left, one)
        {
            let size = loops.get(by).to;
            return (loops.intern(Index::Sub(size, one)) == right).then(|| loops.intern(Index::Rem(inside, size)));
        }
        let Index::Add(base, step) = loops.index(left) else { return None };
        let Index::Running(by) = loops.index(base) else { return None };
        let fits = step == one && inside == left && loops.literal(at_edge) == Some(0) && loops.get(by).to == right;
        fits.then(|| loops.intern(Index::Rem(left, right)))
    }
}
