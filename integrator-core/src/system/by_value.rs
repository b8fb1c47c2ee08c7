//! Numbers or references to numbers in the code of a system. Only the type of a pattern or call of the user decides
//! which.

/// A number, or a reference to one.
pub trait ByValue {
    /// The number.
    type Value;

    /// The number itself.
    fn by_value(self) -> Self::Value;
}

impl<T: ByValue + Copy> ByValue for &T {
    type Value = T::Value;

    #[inline(always)]
    fn by_value(self) -> T::Value {
        (*self).by_value()
    }
}

macro_rules! numbers {
    ($($number:ty)*) => {
        $(
            impl ByValue for $number {
                type Value = Self;

                #[inline(always)]
                fn by_value(self) -> Self {
                    self
                }
            }
        )*
    };
}

numbers! { f64 i8 i16 i32 i64 i128 isize u8 u16 u32 u64 u128 usize }

/// The number that a text of the user's gives, or refers to.
#[inline(always)]
pub fn by_value<T: ByValue>(number: T) -> T::Value {
    number.by_value()
}

#[cfg(test)]
mod tests {
    use super::by_value;

    #[test]
    fn references_are_read() {
        let (number, integer) = (-0.0_f64, 3_usize);
        assert_eq!(by_value(number).to_bits(), by_value(&&number).to_bits());
        assert_eq!(by_value(&integer) + by_value(integer), 6);
    }
}
