//! Integers of the system, of whatever type, as bounds of loops, and indices of loops as integers of the system: types are
//! what rustc infers from the user's own expressions.

use super::by_value::ByValue;

/// A type of integers.
pub trait Integer: Copy {
    /// Converts to a type that contains all integers but the largest of `u128`.
    fn wide(self) -> i128;

    /// Converts from the wide type, wrapped as a cast does.
    fn of(wide: i128) -> Self;
}

macro_rules! integers {
    ($($integer:ty)*) => {
        $(
            impl Integer for $integer {
                #[inline(always)]
                fn wide(self) -> i128 {
                    self as i128
                }

                #[inline(always)]
                fn of(wide: i128) -> Self {
                    wide as Self
                }
            }
        )*
    };
}

integers! { i8 i16 i32 i64 i128 isize u8 u16 u32 u64 u128 usize }

/// An index of a loop in the type of another integer.
#[inline(always)]
pub fn like<T: Integer>(_other: &T, index: impl Integer) -> T {
    T::of(index.wide())
}

/// Returns the length of a loop from zero to an exclusive end.
pub fn bound(end: impl ByValue<Value: Integer>) -> usize {
    clamped(end.by_value().wide())
}

/// Returns the length of a loop from zero to its last index, inclusive.
pub fn bound_through(last: impl ByValue<Value: Integer>) -> usize {
    clamped(last.by_value().wide() + 1)
}

/// The number of integers in `first..end`.
pub fn span(first: impl ByValue<Value: Integer>, end: impl ByValue<Value: Integer>) -> usize {
    clamped(end.by_value().wide() - first.by_value().wide())
}

/// The number of integers in `first..=last`.
pub fn span_through(first: impl ByValue<Value: Integer>, last: impl ByValue<Value: Integer>) -> usize {
    clamped(last.by_value().wide() - first.by_value().wide() + 1)
}

/// An integer that may be below zero, with the bits that a cast back to `isize` reads.
pub fn wrapped(integer: impl ByValue<Value: Integer>) -> usize {
    isize::of(integer.by_value().wide()) as usize
}

fn clamped(count: i128) -> usize {
    usize::try_from(count.max(0)).unwrap_or(usize::MAX)
}

#[cfg(test)]
mod tests {
    use super::{bound, bound_through, like, span, span_through, wrapped};

    #[test]
    fn ranges_have_as_many_integers_as_those_of_rust() {
        for first in -3_i8..4 {
            for end in -3_i8..4 {
                assert_eq!(span(first, end), (first..end).count(), "{first}..{end}");
                assert_eq!(span_through(&first, &end), (first..=end).count(), "{first}..={end}");
                assert_eq!(bound(end), (0..end).count(), "0..{end}");
                assert_eq!(bound_through(end), (0..=end).count(), "0..={end}");
            }
        }
        assert_eq!(span(-2, 3_u8), 5);
    }

    #[test]
    fn integers_keep_their_value_in_another_type() {
        assert_eq!(like(&0_i16, 7_usize) - 9, -2);
        assert_eq!(like(&0_u8, -1_i64), 255);
        assert_eq!(wrapped(-3_i32) as isize, -3);
        assert_eq!([1.0, 2.0][like(&0, 1_usize)], 2.0);
    }
}
