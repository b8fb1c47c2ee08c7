//! Integer expressions (indices, bounds) and the loops that run over them.
//!
//! A loop is identified by where it stands and what it runs over, not by where it was typed: two loops over the same
//! range in the same place are one, so that their bodies share subexpressions and are generated together.

use super::{Element, ParameterId};
use std::collections::HashMap;

/// An integer expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct IndexId(u32);

/// A loop over an integer range.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct LoopId(u32);

impl LoopId {
    pub(crate) fn position(self) -> usize {
        self.0 as usize
    }
}

/// What an integer expression is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Index {
    Literal(u64),
    /// The running index of a loop.
    Running(LoopId),
    /// How many numbers or points the coordinates have, where their type does not tell.
    Length,
    /// An expression of the user that depends on parameters (and indices of loops) alone.
    Parameter(ParameterId),
    Add(IndexId, IndexId),
    Sub(IndexId, IndexId),
    Mul(IndexId, IndexId),
    Div(IndexId, IndexId),
    Rem(IndexId, IndexId),
}

/// `for index in from..to`, inside another loop or not.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Loop {
    pub(crate) parent: Option<LoopId>,
    pub(crate) from: IndexId,
    pub(crate) to: IndexId,
}

/// A set of loops. The model refuses more than [`LoopSet::CAPACITY`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub(crate) struct LoopSet(u128);

impl LoopSet {
    pub(crate) const EMPTY: Self = Self(0);
    /// How many loops a Hamiltonian may have.
    pub(crate) const CAPACITY: usize = 128;

    pub(crate) fn of(by: LoopId) -> Self {
        Self(1 << by.0)
    }
    pub(crate) fn union(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
    pub(crate) fn without(self, by: LoopId) -> Self {
        Self(self.0 & !Self::of(by).0)
    }
    pub(crate) fn contains(self, by: LoopId) -> bool {
        self.0 & Self::of(by).0 != 0
    }
    pub(crate) fn is_subset(self, of: Self) -> bool {
        self.0 & !of.0 == 0
    }
    pub(crate) fn is_empty(self) -> bool {
        self.0 == 0
    }
    pub(crate) fn iter(self) -> impl Iterator<Item = LoopId> {
        (0..Self::CAPACITY as u32).map(LoopId).filter(move |by| self.contains(*by))
    }
}

/// The table of integer expressions and loops.
#[derive(Debug, Default)]
pub(crate) struct Loops {
    indices: Vec<Index>,
    index_sets: Vec<LoopSet>,
    index_ids: HashMap<Index, IndexId>,
    loops: Vec<Loop>,
    loop_ids: HashMap<Loop, LoopId>,
    parameter_sets: HashMap<ParameterId, LoopSet>,
    /// How many numbers or points the coordinates have, and how many components a point has.
    extents: Vec<IndexId>,
}

impl Loops {
    pub(crate) fn index(&self, id: IndexId) -> Index {
        self.indices[id.0 as usize]
    }

    pub(crate) fn get(&self, id: LoopId) -> Loop {
        self.loops[id.position()]
    }

    pub(crate) fn count(&self) -> usize {
        self.loops.len()
    }

    /// The value of an integer expression that is a number.
    pub(crate) fn literal(&self, id: IndexId) -> Option<u64> {
        match self.index(id) {
            Index::Literal(value) => Some(value),
            _ => None,
        }
    }

    /// The id of an integer expression. Numbers are folded where they stay in range.
    pub(crate) fn intern(&mut self, index: Index) -> IndexId {
        let index = self.fold(index);
        if let Some(id) = self.index_ids.get(&index) {
            return *id;
        }
        let id = IndexId(self.indices.len() as u32);
        self.index_sets.push(match index {
            Index::Literal(_) | Index::Length => LoopSet::EMPTY,
            Index::Running(by) => LoopSet::of(by),
            Index::Parameter(parameter) => self.of_parameter(parameter),
            Index::Add(a, b) | Index::Sub(a, b) | Index::Mul(a, b) | Index::Div(a, b) | Index::Rem(a, b) => {
                self.of_index(a).union(self.of_index(b))
            }
        });
        self.indices.push(index);
        self.index_ids.insert(index, id);
        id
    }

    fn fold(&self, index: Index) -> Index {
        let numbers = |a, b| Some((self.literal(a)?, self.literal(b)?));
        let folded = match index {
            Index::Add(a, b) if self.literal(b) == Some(0) => return self.index(a),
            Index::Add(a, b) if self.literal(a) == Some(0) => return self.index(b),
            Index::Sub(a, b) if self.literal(b) == Some(0) => return self.index(a),
            Index::Mul(a, b) if self.literal(b) == Some(1) => return self.index(a),
            Index::Mul(a, b) if self.literal(a) == Some(1) => return self.index(b),
            Index::Add(a, b) => numbers(a, b).and_then(|(a, b)| a.checked_add(b)),
            Index::Sub(a, b) => numbers(a, b).and_then(|(a, b)| a.checked_sub(b)),
            Index::Mul(a, b) => numbers(a, b).and_then(|(a, b)| a.checked_mul(b)),
            Index::Div(a, b) => numbers(a, b).and_then(|(a, b)| a.checked_div(b)),
            Index::Rem(a, b) => numbers(a, b).and_then(|(a, b)| a.checked_rem(b)),
            _ => None,
        };
        folded.map_or(index, Index::Literal)
    }

    /// The loop over a range, new or known.
    pub(crate) fn range(&mut self, range: Loop) -> LoopId {
        if let Some(id) = self.loop_ids.get(&range) {
            return *id;
        }
        let id = LoopId(self.loops.len() as u32);
        self.loops.push(range);
        self.loop_ids.insert(range, id);
        id
    }

    /// States which loops' indices a parameter's text mentions.
    pub(crate) fn declare_parameter(&mut self, id: ParameterId, loops: LoopSet) {
        self.parameter_sets.insert(id, loops);
    }

    pub(crate) fn of_parameter(&self, id: ParameterId) -> LoopSet {
        self.parameter_sets.get(&id).copied().unwrap_or_default()
    }

    pub(crate) fn of_index(&self, id: IndexId) -> LoopSet {
        self.index_sets[id.0 as usize]
    }

    /// Whether running indices come in as they are, not by way of a list.
    pub(crate) fn is_without_lists(&self, id: IndexId) -> bool {
        match self.index(id) {
            Index::Literal(_) | Index::Length | Index::Running(_) => true,
            Index::Parameter(parameter) => self.of_parameter(parameter).is_empty(),
            Index::Add(a, b) | Index::Sub(a, b) | Index::Mul(a, b) | Index::Div(a, b) | Index::Rem(a, b) => {
                self.is_without_lists(a) && self.is_without_lists(b)
            }
        }
    }

    pub(crate) fn of_element(&self, element: Element) -> LoopSet {
        let component = element.component.map_or(LoopSet::EMPTY, |index| self.of_index(index));
        self.of_index(element.index).union(component)
    }

    /// The loops that the bounds of a loop depend on.
    pub(crate) fn of_range(&self, by: LoopId) -> LoopSet {
        let Loop { from, to, .. } = self.get(by);
        self.of_index(from).union(self.of_index(to))
    }

    /// States that an integer is one of the lengths of the coordinates. Without coordinates there is nothing to compute,
    /// so it counts as positive.
    pub(crate) fn declare_extent(&mut self, id: IndexId) {
        self.extents.push(id);
    }

    /// Whether a loop is known to have a turn: its bounds are numbers, those of the coordinates, or those of a loop around
    /// it.
    pub(crate) fn has_turns(&self, by: LoopId) -> bool {
        let Loop { parent, from, to } = self.get(by);
        let numbers = self.literal(from).zip(self.literal(to)).is_some_and(|(from, to)| from < to);
        let around = std::iter::successors(parent, |by| self.get(*by).parent);
        let whole = self.literal(from) == Some(0) && self.extents.contains(&to);
        numbers || whole || around.into_iter().any(|by| (self.get(by).from, self.get(by).to) == (from, to))
    }

    /// An expression without running indices that is never below `id` (taking parts as unsigned), if one can be told.
    pub(crate) fn upper(&mut self, id: IndexId) -> Option<IndexId> {
        if self.of_index(id).is_empty() {
            return Some(id);
        }
        let bound = match self.index(id) {
            Index::Running(by) => {
                let one = self.intern(Index::Literal(1));
                let to = self.get(by).to;
                Index::Sub(self.upper(to)?, one)
            }
            Index::Add(a, b) => Index::Add(self.upper(a)?, self.upper(b)?),
            Index::Sub(a, b) => Index::Sub(self.upper(a)?, self.lower(b)?),
            Index::Mul(a, b) => Index::Mul(self.upper(a)?, self.upper(b)?),
            Index::Div(a, b) => Index::Div(self.upper(a)?, self.lower(b)?),
            Index::Rem(_, b) => {
                let one = self.intern(Index::Literal(1));
                Index::Sub(self.upper(b)?, one)
            }
            Index::Literal(_) | Index::Length | Index::Parameter(_) => return None,
        };
        Some(self.intern(bound))
    }

    /// An expression without running indices that is never above `id`, if one can be told.
    pub(crate) fn lower(&mut self, id: IndexId) -> Option<IndexId> {
        if self.of_index(id).is_empty() {
            return Some(id);
        }
        let bound = match self.index(id) {
            Index::Running(by) => {
                let from = self.get(by).from;
                return self.lower(from);
            }
            Index::Add(a, b) => Index::Add(self.lower(a)?, self.lower(b)?),
            Index::Mul(a, b) => Index::Mul(self.lower(a)?, self.lower(b)?),
            Index::Sub(a, b) => Index::Sub(self.lower(a)?, self.upper(b)?),
            Index::Div(a, b) => Index::Div(self.lower(a)?, self.upper(b)?),
            Index::Rem(..) => Index::Literal(0),
            Index::Literal(_) | Index::Length | Index::Parameter(_) => return None,
        };
        Some(self.intern(bound))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_same_range_in_the_same_place_is_one_loop() {
        let mut loops = Loops::default();
        let (zero, six) = (loops.intern(Index::Literal(0)), loops.intern(Index::Literal(6)));
        let outer = loops.range(Loop { parent: None, from: zero, to: six });
        let inner = loops.range(Loop { parent: Some(outer), from: zero, to: six });
        assert_eq!(outer, loops.range(Loop { parent: None, from: zero, to: six }));
        assert_ne!(outer, inner);
    }

    #[test]
    fn a_triangular_loop_is_bounded_by_its_outer_one() {
        let mut loops = Loops::default();
        let (zero, six) = (loops.intern(Index::Literal(0)), loops.intern(Index::Literal(6)));
        let outer = loops.range(Loop { parent: None, from: zero, to: six });
        let i = loops.intern(Index::Running(outer));
        let inner = loops.range(Loop { parent: Some(outer), from: zero, to: i });
        let j = loops.intern(Index::Running(inner));
        let bound = loops.upper(j).expect("a bound");
        assert_eq!(loops.literal(bound), Some(4), "j < i and i < 6");
        assert!(loops.of_range(inner).contains(outer));
    }
}
