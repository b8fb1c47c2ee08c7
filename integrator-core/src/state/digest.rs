//! Fingerprints of prepared constants, by which the parameters of two systems are distinguished.

use alloc::{boxed::Box, collections::VecDeque, rc::Rc, string::String, sync::Arc, vec::Vec};
use core::{hash::Hasher, marker::PhantomData};

/// FNV-1a over words of 64 bits, with the high bits mixed back into the low ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Digest {
    mixed: u64,
    /// The first value that could not be added, by its name.
    unknown: Option<&'static str>,
}

impl Digest {
    /// The fingerprint of no constants.
    pub(crate) const EMPTY: Self = Self { mixed: 0xcbf2_9ce4_8422_2325, unknown: None };

    /// The fingerprint of all constants that were added.
    pub(crate) fn value(self) -> u64 {
        self.mixed
    }

    /// The first value that could not be added, by its name.
    pub(crate) fn unknown(self) -> Option<&'static str> {
        self.unknown
    }

    /// Adds a prepared constant.
    pub fn add(&mut self, constant: &(impl Digested + ?Sized)) {
        constant.add_to(self);
    }

    /// Notes that a value is of a type that cannot be added.
    pub(crate) fn cannot_add(&mut self, name: &'static str) {
        self.unknown.get_or_insert(name);
    }

    fn word(&mut self, word: u64) {
        let mixed = (self.mixed ^ word).wrapping_mul(0x0000_0100_0000_01b3);
        self.mixed = mixed ^ (mixed >> 32);
    }
}

/// The input of the standard library's `Hash` is added like everything else.
impl Hasher for Digest {
    fn write(&mut self, bytes: &[u8]) {
        bytes.iter().for_each(|byte| self.word(u64::from(*byte)));
    }

    fn finish(&self) -> u64 {
        self.mixed
    }
}

/// A prepared number, a table of prepared numbers over the indices of loops, or another value that is made of numbers.
pub trait Digested {
    /// Adds the value to a digest.
    fn add_to(&self, digest: &mut Digest);
}

impl Digested for f64 {
    fn add_to(&self, digest: &mut Digest) {
        digest.word(self.to_bits());
    }
}

impl Digested for f32 {
    fn add_to(&self, digest: &mut Digest) {
        digest.word(u64::from(self.to_bits()));
    }
}

macro_rules! as_words {
    ($($number:ty),*) => {$(
        impl Digested for $number {
            fn add_to(&self, digest: &mut Digest) {
                digest.word(*self as u64);
            }
        }
    )*};
}

as_words!(usize, u8, u16, u32, u64, isize, i8, i16, i32, i64, bool, char);

macro_rules! as_two_words {
    ($($number:ty),*) => {$(
        impl Digested for $number {
            fn add_to(&self, digest: &mut Digest) {
                digest.word(*self as u64);
                digest.word((*self >> 64) as u64);
            }
        }
    )*};
}

as_two_words!(u128, i128);

impl Digested for str {
    fn add_to(&self, digest: &mut Digest) {
        self.as_bytes().add_to(digest);
    }
}

impl Digested for String {
    fn add_to(&self, digest: &mut Digest) {
        self.as_str().add_to(digest);
    }
}

impl<T: ?Sized> Digested for PhantomData<T> {
    fn add_to(&self, _digest: &mut Digest) {}
}

macro_rules! as_what_they_point_to {
    ($($pointer:ty),*) => {$(
        impl<T: Digested + ?Sized> Digested for $pointer {
            fn add_to(&self, digest: &mut Digest) {
                T::add_to(self, digest);
            }
        }
    )*};
}

as_what_they_point_to!(&T, Box<T>, Rc<T>, Arc<T>);

impl<T: Digested> Digested for Option<T> {
    fn add_to(&self, digest: &mut Digest) {
        self.as_slice().add_to(digest);
    }
}

impl<T: Digested> Digested for VecDeque<T> {
    fn add_to(&self, digest: &mut Digest) {
        self.len().add_to(digest);
        self.iter().for_each(|element| element.add_to(digest));
    }
}

macro_rules! of_tuples {
    ($($($element:ident)*;)*) => {$(
        impl<$($element: Digested),*> Digested for ($($element,)*) {
            #[allow(non_snake_case, reason = "elements have the names of their types")]
            fn add_to(&self, _digest: &mut Digest) {
                let ($($element,)*) = self;
                $($element.add_to(_digest);)*
            }
        }
    )*};
}

of_tuples! {
    ;
    A;
    A B;
    A B C;
    A B C D;
    A B C D E;
    A B C D E F;
}

impl<T: Digested> Digested for [T] {
    fn add_to(&self, digest: &mut Digest) {
        self.len().add_to(digest);
        self.iter().for_each(|element| element.add_to(digest));
    }
}

impl<T: Digested, const N: usize> Digested for [T; N] {
    fn add_to(&self, digest: &mut Digest) {
        self.as_slice().add_to(digest);
    }
}

impl<T: Digested> Digested for Vec<T> {
    fn add_to(&self, digest: &mut Digest) {
        self.as_slice().add_to(digest);
    }
}

#[cfg(all(test, feature = "checkpoint"))]
mod tests {
    use super::*;
    use std::collections::HashSet;

    #[test]
    fn other_constants_have_other_digests() {
        let of = |table: Vec<Vec<f64>>, count: usize| {
            let mut digest = Digest::EMPTY;
            digest.add(&table);
            digest.add(&count);
            digest.value()
        };
        let tables = [
            vec![],
            vec![vec![]],
            vec![vec![], vec![]],
            vec![vec![0.25]],
            vec![vec![0.3]],
            vec![vec![0.25, 0.3]],
            vec![vec![0.25], vec![0.3]],
            vec![vec![0.3], vec![0.25]],
            vec![vec![-0.25]],
            vec![vec![0.25 + f64::EPSILON / 4.0]],
        ];
        let found: HashSet<u64> =
            tables.iter().flat_map(|table| (0..5).map(|count| of(table.clone(), count))).collect();
        assert_eq!(found.len(), 5 * tables.len());
    }
}
