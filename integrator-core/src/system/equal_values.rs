//! Numbers for values that a system compares with `==`, equal for equal values.
//!
//! Always true: a number is an integer of at most 24 bits, so that it is exact in every scalar type.

use core::ops::Deref;

/// A value of a body.
#[derive(Debug)]
pub struct EqualValues<'a, T: ?Sized>(pub &'a T);

/// A value of which nothing is known but which other bodies have an equal one.
#[derive(Debug)]
pub struct Other;

impl Other {
    /// The number of the first body that has an equal value; `body` is the number of this one.
    ///
    /// It is negative, and hence apart from the values of integers.
    pub fn number(&self, body: usize, is_equal: impl Fn(&usize) -> bool) -> f64 {
        -1.0 - (0..=body).find(is_equal).unwrap_or(body) as f64
    }
}

// Rust prefers a method of the type itself to one of its `Deref` target.
impl<T: ?Sized> Deref for EqualValues<'_, T> {
    type Target = Other;

    fn deref(&self) -> &Other {
        &Other
    }
}

/// Two values of a type that may have no `==`.
#[derive(Debug)]
pub struct Both<'a, T: ?Sized>(pub &'a T, pub &'a T);

/// Values that cannot be compared.
#[derive(Debug)]
pub struct Incomparable;

impl Incomparable {
    /// Takes them for different ones.
    pub fn are_equal(&self) -> bool {
        false
    }
}

impl<T: PartialEq + ?Sized> Both<'_, T> {
    /// Whether the values are equal.
    pub fn are_equal(&self) -> bool {
        self.0 == self.1
    }
}

impl<T: ?Sized> Deref for Both<'_, T> {
    type Target = Incomparable;

    fn deref(&self) -> &Incomparable {
        &Incomparable
    }
}

macro_rules! integers {
    ($($integer:ty)*) => {
        $(
            impl EqualValues<'_, $integer> {
                /// The value itself if it is small, else as for other types: no search among many values.
                pub fn number(&self, body: usize, is_equal: impl Fn(&usize) -> bool) -> f64 {
                    match u32::try_from(*self.0) {
                        Ok(value) if value < 1 << 24 => f64::from(value),
                        _ => Other.number(body, is_equal),
                    }
                }
            }
        )*
    };
}

integers!(u8 u16 u32 u64 u128 usize i8 i16 i32 i64 i128 isize char);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_values_have_equal_numbers_and_others_have_not() {
        macro_rules! check {
            ($values:expr) => {
                let values = $values;
                let number =
                    |body: usize| EqualValues(&values[body]).number(body, |other| values[*other] == values[body]);
                for a in 0..values.len() {
                    assert!(number(a).abs() <= f64::from(1 << 24));
                    for b in 0..values.len() {
                        assert_eq!(values[a] == values[b], number(a) == number(b), "{a}, {b}");
                    }
                }
            };
        }
        check!([3_usize, 7, 3, usize::MAX, 0, usize::MAX - 1, usize::MAX]);
        check!([-1_i64, 1, 0, i64::MIN, -1, 1 << 24, 1 << 24, (1 << 24) - 1]);
        check!(["a", "b", "a"]);
        check!([true, false, true]);
        check!(['a', 'b', 'a', char::MAX]);
        check!([Some(0.5), None, Some(0.5)]);
    }

    #[test]
    fn values_without_equality_are_different() {
        struct Opaque;
        assert!(Both(&[1, 2], &[1, 2]).are_equal() && !Both(&1.5, &2.5).are_equal());
        assert!(!Both(&Opaque, &Opaque).are_equal());
    }

    #[test]
    fn small_integers_are_not_searched() {
        assert_eq!(EqualValues(&12_u8).number(5, |_| unreachable!()), 12.0);
    }
}
