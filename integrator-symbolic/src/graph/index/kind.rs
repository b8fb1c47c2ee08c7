//! Integer types: their casts, and whether they can be negative.

use super::{Index, IndexId, Loop, Loops};

/// A type of integers of Rust's.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct IntegerType {
    pub(crate) name: &'static str,
    /// The number of bits; `usize` and `isize` have 64 here.
    pub(super) bits: u32,
    pub(crate) signed: bool,
    /// The number of an expression whose type it is, where nothing names it.
    pub(crate) like: Option<u32>,
}

impl IntegerType {
    const I64: Self = Self { name: "i64", bits: 64, signed: true, like: None };
    const ALL: [Self; 10] = [
        Self { name: "usize", bits: 64, signed: false, like: None },
        Self { name: "u64", bits: 64, signed: false, like: None },
        Self { name: "u32", bits: 32, signed: false, like: None },
        Self { name: "u16", bits: 16, signed: false, like: None },
        Self { name: "u8", bits: 8, signed: false, like: None },
        Self { name: "isize", bits: 64, signed: true, like: None },
        Self::I64,
        Self { name: "i32", bits: 32, signed: true, like: None },
        Self { name: "i16", bits: 16, signed: true, like: None },
        Self { name: "i8", bits: 8, signed: true, like: None },
    ];

    pub(crate) fn named(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|known| known.name == name)
    }

    /// The type of an expression of the system. It may have a sign.
    pub(crate) fn like(expression: u32) -> Self {
        Self { name: "", bits: 64, signed: true, like: Some(expression) }
    }

    pub(crate) fn is_usize(self) -> bool {
        self.name == "usize"
    }

    /// The result of a cast of an integer; 64 bits without a sign keep those of a negative one, which no index reaches.
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

impl Loops {
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
            // What may have a sign elsewhere has none here.
            (Index::Wrapped(kind, a), _) if kind.signed => self.unsigned(a),
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

    /// An integer of the system as one that may be below zero.
    pub(crate) fn signed(&mut self, id: IndexId) -> IndexId {
        self.intern(Index::Wrapped(IntegerType::I64, id))
    }

    /// Whether an integer is made of an index of a loop, other than by way of a list.
    pub(crate) fn runs(&self, id: IndexId) -> bool {
        let index = self.index(id);
        let operands = index.operands();
        matches!(index, Index::Running(_))
            || operands.is_some_and(|both| both.iter().any(|operand| self.runs(*operand)))
    }

    /// Whether an integer is one of [`Loops::signed`], which comes in the bits of `isize`.
    pub(crate) fn is_wrapped(&self, id: IndexId) -> bool {
        matches!(self.index(id), Index::Wrapped(IntegerType::I64, a) if matches!(self.index(a), Index::Parameter(_)))
    }

    /// An integer without the types that the system gives, which only text needs.
    pub(crate) fn plain(&mut self, id: IndexId) -> IndexId {
        let index = self.index(id);
        match (index, index.operands()) {
            (Index::Typed(kind, a), _) if kind.like.is_some() => self.plain(a),
            (_, Some(both)) => {
                let both = both.map(|operand| self.plain(operand));
                self.intern(index.with_operands(both))
            }
            (_, None) => id,
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
}
