//! Integer expressions (indices, bounds) and the loops that run over them.
//!
//! A loop is identified by its position and its range, not by its source: two loops over the same range in the same
//! position are one loop. Their bodies hence share subexpressions and are generated together.

mod bounds;
mod fold;
mod kind;
mod linear;
mod span;
mod values;

use super::{Element, ParameterId};
pub(super) use bounds::DEEPEST;
pub(crate) use kind::IntegerType;
pub(crate) use linear::Linear;
use std::collections::{HashMap, HashSet};

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

/// An integer expression, as a node of its table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Index {
    Literal(u64),
    /// The running index of a loop.
    Running(LoopId),
    /// The number of numbers or points of the coordinates, where their type does not have it.
    Length,
    /// An expression of the user that depends on parameters (and indices of loops) alone.
    Parameter(ParameterId),
    Add(IndexId, IndexId),
    Sub(IndexId, IndexId),
    Mul(IndexId, IndexId),
    Div(IndexId, IndexId),
    Rem(IndexId, IndexId),
    /// The difference, or zero where it is below zero: the number of items that are left of a sequence.
    Monus(IndexId, IndexId),
    /// The smaller one: the number of items that two sequences have in common.
    Min(IndexId, IndexId),
    /// The difference of integers that have a sign, or may have one.
    Minus(IndexId, IndexId),
    /// The same integer in another type, which holds it.
    Typed(IntegerType, IndexId),
    /// The wrapped value of an integer in a type that may be too small for it, or has no sign.
    Wrapped(IntegerType, IndexId),
    /// The number of a site in a plane, by its row and its place there: `row * sites + site`, where rows have
    /// [`Loops::sites_of_row`].
    InPlane(IndexId, IndexId),
}

impl Index {
    /// The two expressions that an operation combines; a cast has one, twice.
    pub(crate) fn operands(self) -> Option<[IndexId; 2]> {
        match self {
            Index::Literal(_) | Index::Running(_) | Index::Length | Index::Parameter(_) => None,
            Index::Add(a, b)
            | Index::Sub(a, b)
            | Index::Mul(a, b)
            | Index::Div(a, b)
            | Index::Rem(a, b)
            | Index::Monus(a, b)
            | Index::Min(a, b)
            | Index::Minus(a, b)
            | Index::InPlane(a, b) => Some([a, b]),
            Index::Typed(_, a) | Index::Wrapped(_, a) => Some([a, a]),
        }
    }

    /// The same operation of two other expressions.
    pub(crate) fn with_operands(self, [a, b]: [IndexId; 2]) -> Self {
        match self {
            Index::Literal(_) | Index::Running(_) | Index::Length | Index::Parameter(_) => self,
            Index::Add(..) => Index::Add(a, b),
            Index::Sub(..) => Index::Sub(a, b),
            Index::Mul(..) => Index::Mul(a, b),
            Index::Div(..) => Index::Div(a, b),
            Index::Rem(..) => Index::Rem(a, b),
            Index::Monus(..) => Index::Monus(a, b),
            Index::Min(..) => Index::Min(a, b),
            Index::Minus(..) => Index::Minus(a, b),
            Index::Typed(kind, _) => Index::Typed(kind, a),
            Index::Wrapped(kind, _) => Index::Wrapped(kind, a),
            Index::InPlane(..) => Index::InPlane(a, b),
        }
    }
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
    pub(crate) const ALL: Self = Self(u128::MAX);
    /// The largest number of loops of a Hamiltonian.
    pub(crate) const CAPACITY: usize = 128;

    pub(crate) fn of(by: LoopId) -> Self {
        Self(1 << by.0)
    }
    pub(crate) fn union(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
    pub(crate) fn intersection(self, other: Self) -> Self {
        Self(self.0 & other.0)
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
    /// The least and the greatest value of a parameter over the loops that it depends on.
    parameter_ranges: HashMap<ParameterId, (IndexId, IndexId)>,
    /// The number of numbers or points of the coordinates, and of components of a point.
    extents: Vec<IndexId>,
    /// The lengths of lists of the system.
    list_lengths: HashSet<IndexId>,
    /// Indices of coordinates that are below their length where a condition holds alone.
    guarded: HashSet<IndexId>,
    /// The number of sites in a row, where coordinates are planes of rows.
    sites_of_row: Option<IndexId>,
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

    /// Whether an integer expression is made of numbers and of indices of loops between numbers.
    pub(crate) fn is_untyped(&self, id: IndexId) -> bool {
        let of = |id| self.is_untyped(id);
        match (self.index(id), self.index(id).operands()) {
            (Index::Literal(_), _) => true,
            (Index::Running(by), _) => of(self.get(by).from) && of(self.get(by).to),
            (Index::Typed(..) | Index::Wrapped(..), _) => false,
            (_, Some([a, b])) => of(a) && of(b),
            (_, None) => false,
        }
    }

    /// The value of an integer expression that is a number, or one below zero.
    pub(crate) fn signed_literal(&self, id: IndexId) -> Option<i64> {
        match self.index(id) {
            Index::Literal(value) => i64::try_from(value).ok(),
            Index::Minus(zero, below) if self.literal(zero) == Some(0) => {
                self.literal(below).and_then(|below| i64::try_from(below).ok()).map(|below| -below)
            }
            _ => None,
        }
    }

    fn of_signed(&mut self, value: i64) -> Index {
        if value >= 0 {
            return Index::Literal(value.unsigned_abs());
        }
        let (zero, below) = (self.intern(Index::Literal(0)), self.intern(Index::Literal(value.unsigned_abs())));
        Index::Minus(zero, below)
    }

    /// The number of integers in `from..to`.
    pub(crate) fn span(&mut self, from: IndexId, to: IndexId) -> IndexId {
        self.intern(Index::Monus(to, from))
    }

    /// The index with the distance from `to` that `index` has from `from`, which is not beyond it.
    pub(crate) fn shifted(&mut self, index: IndexId, from: IndexId, to: IndexId) -> IndexId {
        match (self.literal(from), self.literal(to)) {
            _ if from == to => index,
            (Some(from), Some(to)) if from < to => {
                let further = self.intern(Index::Literal(to - from));
                self.intern(Index::Add(index, further))
            }
            (Some(from), Some(to)) => {
                let back = self.intern(Index::Literal(from - to));
                self.intern(Index::Sub(index, back))
            }
            _ => {
                let position = self.intern(Index::Sub(index, from));
                self.intern(Index::Add(position, to))
            }
        }
    }

    /// A bound of a loop: a difference that is below zero ends the loop before it begins.
    pub(crate) fn ending(&mut self, bound: IndexId) -> IndexId {
        let bound = self.plain(bound);
        match self.index(bound) {
            Index::Sub(a, b) | Index::Minus(a, b) if !self.is_signed(a) && !self.is_signed(b) => {
                let [a, b] = [a, b].map(|operand| self.unsigned(operand));
                self.intern(Index::Monus(a, b))
            }
            _ if self.is_signed(bound) => {
                let zero = self.intern(Index::Literal(0));
                self.intern(Index::Monus(bound, zero))
            }
            _ => self.unsigned(bound),
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
            Index::Running(by) => LoopSet::of(by),
            Index::Parameter(parameter) => self.of_parameter(parameter),
            _ => index.operands().map_or(LoopSet::EMPTY, |[a, b]| self.of_index(a).union(self.of_index(b))),
        });
        self.indices.push(index);
        self.index_ids.insert(index, id);
        id
    }

    /// The id of an integer expression that is in the table.
    pub(crate) fn known(&self, index: Index) -> Option<IndexId> {
        self.index_ids.get(&index).copied()
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

    /// A new loop over the same range as another one; `None` where there are as many loops as there may be.
    pub(crate) fn beside(&mut self, by: LoopId) -> Option<LoopId> {
        let mut range = Loop { parent: Some(by), ..self.get(by) };
        while let Some(known) = self.loop_ids.get(&range) {
            range.parent = Some(*known);
        }
        (self.count() < LoopSet::CAPACITY).then(|| self.range(range))
    }

    /// States that an integer is the length of a list of the system.
    pub(crate) fn declare_list_length(&mut self, id: IndexId) {
        self.list_lengths.insert(id);
    }

    /// States that an index is that of a coordinate only where a condition holds.
    pub(crate) fn declare_guarded(&mut self, id: IndexId) {
        self.guarded.insert(id);
    }

    pub(super) fn is_guarded(&self, id: IndexId) -> bool {
        self.guarded.contains(&id)
    }

    /// Whether an integer is computed from lengths of lists.
    pub(crate) fn mentions_lists(&self, id: IndexId) -> bool {
        let operands = self.index(id).operands();
        self.list_lengths.contains(&id)
            || operands.is_some_and(|both| both.iter().any(|operand| self.mentions_lists(*operand)))
    }

    /// Where a sequence would end without lists of the system, and where these end it, if both are known.
    pub(crate) fn end_without_lists(&mut self, end: IndexId) -> Option<(IndexId, IndexId)> {
        let Index::Min(a, b) = self.index(end) else { return None };
        match [a, b].map(|end| self.mentions_lists(end)) {
            [true, false] => Some((b, a)),
            [false, true] => Some((a, b)),
            [true, true] => {
                let ((whole, inner), outer) = match (self.end_without_lists(a), self.end_without_lists(b)) {
                    (Some(found), None) => (found, b),
                    (None, Some(found)) => (found, a),
                    _ => return None,
                };
                Some((whole, self.intern(Index::Min(inner, outer))))
            }
            [false, false] => None,
        }
    }

    /// States which loops' indices a parameter's text mentions.
    pub(crate) fn declare_parameter(&mut self, id: ParameterId, loops: LoopSet) {
        self.parameter_sets.insert(id, loops);
    }

    /// States between which values a parameter stays, whatever the loops' indices are.
    pub(crate) fn declare_range(&mut self, id: ParameterId, least: IndexId, greatest: IndexId) {
        self.parameter_ranges.insert(id, (least, greatest));
    }

    pub(crate) fn range_of(&self, id: ParameterId) -> Option<(IndexId, IndexId)> {
        self.parameter_ranges.get(&id).copied()
    }

    /// Some loops, and those that their bounds depend on.
    pub(crate) fn with_outer(&self, loops: LoopSet) -> LoopSet {
        let more = loops.iter().fold(loops, |all, by| all.union(self.of_range(by)));
        if more == loops { loops } else { self.with_outer(more) }
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
            Index::Parameter(parameter) => self.of_parameter(parameter).is_empty(),
            operation => operation.operands().is_none_or(|both| both.iter().all(|id| self.is_without_lists(*id))),
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

    /// States that an integer is one of the lengths of the coordinates. Without coordinates there is nothing to
    /// compute, so it counts as positive.
    pub(crate) fn declare_extent(&mut self, id: IndexId) {
        self.extents.push(id);
    }

    /// States how many sites a row has, where coordinates are planes.
    pub(crate) fn declare_rows(&mut self, sites: IndexId) {
        self.sites_of_row = Some(sites);
    }

    /// The number of sites in a row, where coordinates are planes; one where there are no rows.
    pub(crate) fn sites_of_row(&self) -> Option<IndexId> {
        self.sites_of_row
    }

    /// The number of a site in a plane as a sum.
    fn number_in_plane(&mut self, row: IndexId, site: IndexId) -> IndexId {
        let Some(sites) = self.sites_of_row else { return site };
        let before = self.intern(Index::Mul(row, sites));
        self.intern(Index::Add(before, site))
    }

    /// The indices of a coordinate, the outermost first.
    pub(crate) fn of_coordinate(&self, element: Element) -> impl Iterator<Item = IndexId> {
        let inner = element.component.map(|component| match self.index(component) {
            Index::InPlane(row, site) => [Some(row), Some(site)],
            _ => [Some(component), None],
        });
        std::iter::once(element.index).chain(inner.into_iter().flatten().flatten())
    }

    /// Whether all lengths of the coordinates are numbers.
    pub(crate) fn has_known_extents(&self) -> bool {
        self.extents.iter().all(|id| self.literal(*id).is_some())
    }

    /// The lengths of the coordinates.
    pub(super) fn extents(&self) -> impl Iterator<Item = IndexId> {
        self.extents.iter().copied()
    }

    /// Whether an integer is one of the lengths of the coordinates.
    pub(crate) fn is_extent(&self, id: IndexId) -> bool {
        self.extents.contains(&id)
    }

    /// Whether a loop is known to have an iteration where there are coordinates: [`Loops::always_has_iterations`], or
    /// it runs over the coordinates.
    pub(crate) fn has_iterations(&self, by: LoopId) -> bool {
        let Loop { from, to, .. } = self.get(by);
        let whole = self.literal(from) == Some(0) && self.is_extent(to);
        whole || self.always_has_iterations(by)
    }

    /// Whether a loop is known to have an iteration: its bounds are numbers, or those of a loop around it.
    pub(crate) fn always_has_iterations(&self, by: LoopId) -> bool {
        let Loop { parent, from, to } = self.get(by);
        let numbers = self.literal(from).zip(self.literal(to)).is_some_and(|(from, to)| from < to);
        let mut around = std::iter::successors(parent, |by| self.get(*by).parent);
        numbers || around.any(|by| (self.get(by).from, self.get(by).to) == (from, to))
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
