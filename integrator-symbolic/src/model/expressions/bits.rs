//! Bitwise operators on non-negative integers, as arithmetic with the same values.

use crate::graph::index::{Index, IndexId};
use crate::model::{Reader, expressions::cure::bits_by_arithmetic, values::value::Value};
use quote::ToTokens;
use syn::{BinOp, Expr};

impl Reader<'_> {
    /// `left op right` for an operator on bits; nothing for another operator.
    pub(crate) fn of_bits(&mut self, op: &BinOp, left: &Value, right: &Value) -> Option<IndexId> {
        let (Value::Integer(a), Value::Integer(b)) = (left, right) else { return None };
        let (a, number) = (*a, self.graph.loops.literal(*b)?);
        if self.graph.loops.is_signed(a) || self.own_integers.contains_key(&a) {
            return None;
        }
        let power = || 1_u64.checked_shl(u32::try_from(number).ok()?).filter(|power| *power <= 1 << 31);
        match op {
            BinOp::Shl(_) => self.with_number(Index::Mul, a, power()?),
            BinOp::Shr(_) => self.with_number(Index::Div, a, power()?),
            // All lower bits.
            BinOp::BitAnd(_) if number.checked_add(1)?.is_power_of_two() => self.with_number(Index::Rem, a, number + 1),
            // The other one in a pair: 2 (a / 2) + (1 - a % 2), whose bounds are known.
            BinOp::BitXor(_) if number == 1 => {
                let (pair, odd) = (self.with_number(Index::Div, a, 2)?, self.with_number(Index::Rem, a, 2)?);
                let (first, one) = (self.with_number(Index::Mul, pair, 2)?, self.literal_index(1));
                let other = self.graph.loops.intern(Index::Sub(one, odd));
                Some(self.graph.loops.intern(Index::Add(first, other)))
            }
            _ => None,
        }
    }

    fn with_number(&mut self, index: fn(IndexId, IndexId) -> Index, a: IndexId, number: u64) -> Option<IndexId> {
        let number = self.literal_index(number);
        Some(self.graph.loops.intern(index(a, number)))
    }

    /// Refuses an operator on the bits of integers; `false` for anything else.
    pub(crate) fn refuses_bits(&mut self, op: &BinOp, sides: [&Value; 2], whole: &Expr) -> bool {
        let is_integer = |value: &Value| matches!(value, Value::Integer(_) | Value::Opaque(_));
        let is_of_bits =
            matches!(op, BinOp::BitXor(_) | BinOp::BitAnd(_) | BinOp::BitOr(_) | BinOp::Shl(_) | BinOp::Shr(_));
        if !is_of_bits || !sides.into_iter().all(is_integer) {
            return false;
        }
        self.errors.at(whole, bits_by_arithmetic(&op.to_token_stream().to_string()));
        true
    }
}
