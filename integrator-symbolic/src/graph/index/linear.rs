//! Integers that are linear in the index of a loop.

use super::{Index, IndexId, LoopId, Loops};

/// `base + stride * index + offset`, where the base is the same in all iterations of the loop; no base is zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Linear {
    pub(crate) base: Option<IndexId>,
    pub(crate) stride: i64,
    pub(crate) offset: i64,
}

impl Loops {
    /// An integer as a linear function of the index of a loop; `None` if it is none, or has several bases.
    pub(crate) fn linear_in(&self, by: LoopId, id: IndexId) -> Option<Linear> {
        if self.is_signed(id) {
            return None;
        }
        let number = |offset| Linear { base: None, stride: 0, offset };
        Some(match self.index(id) {
            Index::Literal(value) => number(i64::try_from(value).ok()?),
            Index::Running(own) if own == by => Linear { stride: 1, ..number(0) },
            _ if !self.of_index(id).contains(by) => Linear { base: Some(id), ..number(0) },
            Index::Typed(_, a) => self.linear_in(by, a)?,
            Index::Add(a, b) => {
                let (a, b) = (self.linear_in(by, a)?, self.linear_in(by, b)?);
                let base = match (a.base, b.base) {
                    (base, None) | (None, base) => base,
                    _ => return None,
                };
                Linear { base, stride: a.stride.checked_add(b.stride)?, offset: a.offset.checked_add(b.offset)? }
            }
            Index::Sub(a, b) => {
                let a = self.linear_in(by, a)?;
                let less = self.literal(b).and_then(|less| i64::try_from(less).ok())?;
                Linear { offset: a.offset.checked_sub(less)?, ..a }
            }
            Index::Mul(a, b) => {
                let (index, times) = if self.literal(b).is_some() { (a, b) } else { (b, a) };
                let times = self.literal(times).and_then(|times| i64::try_from(times).ok())?;
                let index = self.linear_in(by, index).filter(|index| index.base.is_none())?;
                Linear { stride: index.stride.checked_mul(times)?, offset: index.offset.checked_mul(times)?, ..index }
            }
            _ => return None,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::graph::index::Loop;

    #[test]
    fn sums_and_multiples_of_an_index_are_linear() {
        let mut loops = Loops::default();
        let [zero, one, two, nine] = [0, 1, 2, 9].map(|number| loops.intern(Index::Literal(number)));
        let length = loops.intern(Index::Length);
        let by = loops.range(Loop { parent: None, from: zero, to: nine });
        let i = loops.intern(Index::Running(by));
        let mut of = |index| loops.intern(index);
        let [next, before, double] = [of(Index::Add(i, one)), of(Index::Sub(i, two)), of(Index::Mul(i, two))];
        let [odd, behind, shifted] =
            [of(Index::Add(double, one)), of(Index::Add(length, next)), of(Index::Mul(next, two))];
        let (square, twice) = (of(Index::Mul(i, i)), of(Index::Add(behind, length)));
        let linear = |base, stride, offset| Some(Linear { base, stride, offset });
        for (id, expected) in [
            (i, linear(None, 1, 0)),
            (nine, linear(None, 0, 9)),
            (length, linear(Some(length), 0, 0)),
            (before, linear(None, 1, -2)),
            (odd, linear(None, 2, 1)),
            (behind, linear(Some(length), 1, 1)),
            (shifted, linear(None, 2, 2)),
            (square, None),
            (twice, None),
        ] {
            assert_eq!(loops.linear_in(by, id), expected, "{id:?}");
        }
    }
}
