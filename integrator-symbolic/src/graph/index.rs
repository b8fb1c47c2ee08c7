//! Integer expressions (indices, bounds) and the loops that run over them.
//!
//! A loop is identified by where it stands and what it runs over, not by where it was typed: two loops over the same
//! range in the same place are one, so that their bodies share subexpressions and are generated together.

use super::{Element, ParameterId};
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
    /// The difference, or zero where it is below zero: how many items of a sequence are left.
    Monus(IndexId, IndexId),
    /// The smaller one: how many items two sequences share.
    Min(IndexId, IndexId),
    /// The difference of integers that have a sign, or may have one.
    Minus(IndexId, IndexId),
    /// The same integer in another type, which holds it.
    Typed(IntegerType, IndexId),
    /// What is left of an integer in a type that may be too small for it, or has no sign.
    Wrapped(IntegerType, IndexId),
}

/// A type of integers of Rust's.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct IntegerType {
    pub(crate) name: &'static str,
    /// How many bits it has; `usize` and `isize` have 64 here.
    bits: u32,
    pub(crate) signed: bool,
}

impl IntegerType {
    const I64: Self = Self { name: "i64", bits: 64, signed: true };
    const ALL: [Self; 10] = [
        Self { name: "usize", bits: 64, signed: false },
        Self { name: "u64", bits: 64, signed: false },
        Self { name: "u32", bits: 32, signed: false },
        Self { name: "u16", bits: 16, signed: false },
        Self { name: "u8", bits: 8, signed: false },
        Self { name: "isize", bits: 64, signed: true },
        Self::I64,
        Self { name: "i32", bits: 32, signed: true },
        Self { name: "i16", bits: 16, signed: true },
        Self { name: "i8", bits: 8, signed: true },
    ];

    pub(crate) fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|known| known.name == name)
    }

    pub(crate) fn is_usize(self) -> bool {
        self.name == "usize"
    }

    /// What a cast makes of an integer; 64 bits without a sign keep those of a negative one, which no index reaches.
    pub(crate) fn wrapped(self, value: i64) -> i64 {
        let unused = 64 - self.bits;
        let shifted = value << unused;
        if self.signed || self.bits == 64 { shifted >> unused } else { ((shifted as u64) >> unused) as i64 }
    }

    /// Whether it holds all integers up to `largest`; one that is not known is no larger than a list is long.
    fn holds(self, largest: Option<u64>) -> bool {
        let bits = if self.signed { self.bits - 1 } else { self.bits };
        match largest {
            Some(largest) => bits >= 64 || largest < 1 << bits,
            None => self.bits >= 32,
        }
    }
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
            | Index::Minus(a, b) => Some([a, b]),
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
        }
    }
}

/// How many steps are taken to see which of two expressions is smaller.
pub(super) const DEEPEST: u32 = 8;

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
    /// How many loops a Hamiltonian may have.
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
    /// How many numbers or points the coordinates have, and how many components a point has.
    extents: Vec<IndexId>,
    /// How long lists of the system are.
    list_lengths: HashSet<IndexId>,
    /// Indices of coordinates that are below their length where a condition holds alone.
    guarded: HashSet<IndexId>,
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

    /// Whether an integer may be below zero, or is computed from one that is.
    pub(crate) fn is_signed(&self, id: IndexId) -> bool {
        match self.index(id) {
            Index::Minus(..) => true,
            Index::Wrapped(kind, _) => kind.signed,
            index => index.operands().is_some_and(|both| both.iter().any(|operand| self.is_signed(*operand))),
        }
    }

    /// The type that a cast gave to an integer, or that it has to have to be below zero.
    pub(crate) fn type_of(&self, id: IndexId) -> Option<IntegerType> {
        self.cast_type(id).or(self.is_signed(id).then_some(IntegerType::I64))
    }

    /// The type that a cast gave to an integer.
    pub(crate) fn cast_type(&self, id: IndexId) -> Option<IntegerType> {
        match self.index(id) {
            Index::Typed(kind, _) | Index::Wrapped(kind, _) => Some(kind),
            index => index.operands().and_then(|both| both.into_iter().find_map(|operand| self.cast_type(operand))),
        }
    }

    /// The difference of two integers: without a sign where the type is `usize` or the first is plainly not smaller.
    pub(crate) fn minus(&mut self, a: IndexId, b: IndexId) -> IndexId {
        let lowest = self.lower(a).and_then(|lower| self.literal(lower));
        let highest = self.upper(b).and_then(|upper| self.literal(upper));
        let natural = lowest.zip(highest).is_some_and(|(lowest, highest)| lowest >= highest);
        let signed = self.is_signed(a) || self.is_signed(b);
        let unsigned = !signed && (natural || self.is_length(a) || self.is_length(b));
        self.intern(if unsigned { Index::Sub(a, b) } else { Index::Minus(a, b) })
    }

    /// Whether an integer is made of a length, so that its type is `usize`.
    fn is_length(&self, id: IndexId) -> bool {
        match self.index(id) {
            Index::Length => true,
            Index::Parameter(_) => self.extents.contains(&id) || self.list_lengths.contains(&id),
            Index::Running(by) => {
                let Loop { from, to, .. } = self.get(by);
                self.is_length(from) || self.is_length(to)
            }
            Index::Typed(kind, _) | Index::Wrapped(kind, _) => kind.is_usize(),
            index => index.operands().is_some_and(|both| both.iter().any(|operand| self.is_length(*operand))),
        }
    }

    /// An integer as one whose type is `usize`, as that of indices is: no difference is below zero.
    pub(crate) fn unsigned(&mut self, id: IndexId) -> IndexId {
        let index = self.index(id);
        match (index, index.operands()) {
            (Index::Wrapped(..), _) | (_, None) => id,
            (Index::Typed(_, a), _) => self.unsigned(a),
            (_, Some(both)) => {
                let both = both.map(|operand| self.unsigned(operand));
                match (index, both) {
                    (Index::Minus(..), [a, b]) => self.intern(Index::Sub(a, b)),
                    (_, both) => self.intern(index.with_operands(both)),
                }
            }
        }
    }

    /// An integer cast to another type.
    pub(crate) fn cast(&mut self, id: IndexId, kind: IntegerType) -> IndexId {
        let largest = self.upper(id).and_then(|upper| self.literal(upper));
        if !self.is_signed(id) && kind.holds(largest) {
            return if kind.is_usize() { self.unsigned(id) } else { self.intern(Index::Typed(kind, id)) };
        }
        self.intern(Index::Wrapped(kind, id))
    }

    /// How many integers are in `from..to`.
    pub(crate) fn span(&mut self, from: IndexId, to: IndexId) -> IndexId {
        self.intern(Index::Monus(to, from))
    }

    /// What is as far from `to` as `index` is from `from`, which is not beyond it.
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

    fn fold(&mut self, index: Index) -> Index {
        match index {
            // (x + s) + t == x + (s + t)
            Index::Add(a, t)
                if let Index::Add(x, s) = self.index(a)
                    && let Some(both) = self.literal(s).zip(self.literal(t)).and_then(|(s, t)| s.checked_add(t)) =>
            {
                return Index::Add(x, self.intern(Index::Literal(both)));
            }
            // a - (a - x) == x
            Index::Sub(a, b)
                if let Index::Sub(whole, x) = self.index(b)
                    && whole == a =>
            {
                return self.index(x);
            }
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

    /// `max(a - b, 0)`, as short as it can be told.
    fn monus(&mut self, a: IndexId, b: IndexId) -> Index {
        match (self.index(a), self.index(b), self.literal(b)) {
            (Index::Literal(a), Index::Literal(b), _) => Index::Literal(a.saturating_sub(b)),
            _ if let Some((a, b)) = self.signed_literal(a).zip(self.signed_literal(b)) => {
                self.of_signed(a.saturating_sub(b).max(0))
            }
            // (x + s) - (x - t) == s + t
            (Index::Add(x, s), Index::Minus(y, t), _) if x == y => {
                let both = self.intern(Index::Add(s, t));
                self.index(both)
            }
            (_, Index::Minus(x, t), _) if a == x => self.index(t),
            _ if self.is_signed(a) || self.is_signed(b) => Index::Monus(a, b),
            (known, _, Some(0)) => known,
            (Index::Literal(0), ..) => Index::Literal(0),
            _ if a == b => Index::Literal(0),
            (Index::Add(rest, added), ..) if added == b => self.index(rest),
            (Index::Add(added, rest), ..) if added == b => self.index(rest),
            (Index::Add(rest, added), _, Some(taken)) if let Some(added) = self.literal(added) => {
                let (more, less) = (added.saturating_sub(taken), taken.saturating_sub(added));
                let (more, less) = (self.intern(Index::Literal(more)), self.intern(Index::Literal(less)));
                let rest = self.intern(Index::Add(rest, more));
                // One of both is zero.
                if self.literal(less) == Some(0) { self.index(rest) } else { self.monus(rest, less) }
            }
            (Index::Monus(rest, first), _, Some(second)) if let Some(first) = self.literal(first) => {
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

    /// The smaller one, as short as it can be told; a literal stands on the right.
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

    /// Whether `a <= b` whatever the values of what is not known; `false` where it takes more than `depth` steps to see.
    pub(super) fn is_at_most(&self, a: IndexId, b: IndexId, depth: u32) -> bool {
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
            Index::Min(x, y) => is(x, b) || is(y, b),
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

    /// States that an integer is how long a list of the system is.
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

    /// Whether an integer is made of how long lists are.
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

    /// States that an integer is one of the lengths of the coordinates. Without coordinates there is nothing to compute,
    /// so it counts as positive.
    pub(crate) fn declare_extent(&mut self, id: IndexId) {
        self.extents.push(id);
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

    /// Whether a loop is known to have a turn where there are coordinates: [`Loops::always_has_turns`], or it runs over
    /// the coordinates.
    pub(crate) fn has_turns(&self, by: LoopId) -> bool {
        let Loop { from, to, .. } = self.get(by);
        let whole = self.literal(from) == Some(0) && self.is_extent(to);
        whole || self.always_has_turns(by)
    }

    /// Whether a loop is known to have a turn: its bounds are numbers, or those of a loop around it.
    pub(crate) fn always_has_turns(&self, by: LoopId) -> bool {
        let Loop { parent, from, to } = self.get(by);
        let numbers = self.literal(from).zip(self.literal(to)).is_some_and(|(from, to)| from < to);
        let mut around = std::iter::successors(parent, |by| self.get(*by).parent);
        numbers || around.any(|by| (self.get(by).from, self.get(by).to) == (from, to))
    }

    /// An expression without running indices that is never below `id` (taking parts as unsigned), if one can be told.
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
            Index::Parameter(id) => return self.range_of(id).map(|(_, greatest)| greatest),
            Index::Literal(_) | Index::Length | Index::Minus(..) | Index::Wrapped(..) => return None,
        };
        Some(self.intern(bound))
    }

    /// An expression without running indices that is never above `id`, if one can be told.
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
            Index::Parameter(id) => return self.range_of(id).map(|(least, _)| least),
            Index::Literal(_) | Index::Length | Index::Minus(..) => return None,
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
