//! Values of integers for given indices of loops.

use super::{Index, IndexId, LoopId, Loops};
use std::collections::HashMap;

impl Loops {
    /// The value of an integer that is made of numbers and of indices of loops alone.
    pub(crate) fn value(&self, id: IndexId, indices: &HashMap<LoopId, i64>) -> Option<i64> {
        let index = self.index(id);
        let both = match index.operands() {
            Some([a, b]) => Some((self.value(a, indices)?, self.value(b, indices)?)),
            None => None,
        };
        match (index, both) {
            (Index::Literal(value), _) => i64::try_from(value).ok(),
            (Index::Running(by), _) => indices.get(&by).copied(),
            (Index::Add(..), Some((a, b))) => a.checked_add(b),
            (Index::Sub(..) | Index::Minus(..), Some((a, b))) => a.checked_sub(b),
            (Index::Mul(..), Some((a, b))) => a.checked_mul(b),
            (Index::Div(..), Some((a, b))) => a.checked_div(b),
            (Index::Rem(..), Some((a, b))) => a.checked_rem(b),
            (Index::Monus(..), Some((a, b))) => Some(a.checked_sub(b)?.max(0)),
            (Index::Min(..), Some((a, b))) => Some(a.min(b)),
            (Index::Typed(..), Some((a, _))) => Some(a),
            (Index::Wrapped(kind, _), Some((a, _))) => Some(kind.wrapped(a)),
            (Index::InPlane(..) | Index::Length | Index::Parameter(_), _) | (_, None) => None,
        }
    }
}
