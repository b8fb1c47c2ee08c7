//! What is known of values whose types only the compiler knows: small integers, and whether two values are equal.

use core::ops::Deref;

/// A value that may be an integer.
#[derive(Debug)]
pub struct SmallInteger<'a, T: ?Sized>(pub &'a T);

/// A value of another type.
#[derive(Debug)]
pub struct Other;

impl Other {
    /// It is no integer.
    pub fn value(&self) -> Option<f64> {
        None
    }
}

// Rust prefers a method of the type itself to one of its `Deref` target.
impl<T: ?Sized> Deref for SmallInteger<'_, T> {
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
            impl SmallInteger<'_, $integer> {
                /// The value, if it is an integer of at most 24 bits, which every scalar type represents exactly.
                pub fn value(&self) -> Option<f64> {
                    u32::try_from(*self.0).ok().filter(|value| *value < 1 << 24).map(f64::from)
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
    fn small_integers_have_their_value() {
        assert_eq!(SmallInteger(&12_u8).value(), Some(12.0));
        assert_eq!(SmallInteger(&'a').value(), Some(97.0));
        assert_eq!(SmallInteger(&((1_i64 << 24) - 1)).value(), Some(16_777_215.0));
        assert_eq!(SmallInteger(&(1_i64 << 24)).value(), None);
        assert_eq!(SmallInteger(&-1_i64).value(), None);
        assert_eq!(SmallInteger(&usize::MAX).value(), None);
        assert_eq!(SmallInteger(&"a").value(), None);
    }

    #[test]
    fn values_without_equality_are_different() {
        struct Opaque;
        assert!(Both(&[1, 2], &[1, 2]).are_equal() && !Both(&1.5, &2.5).are_equal());
        assert!(!Both(&Opaque, &Opaque).are_equal());
    }
}
