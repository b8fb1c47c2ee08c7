//! What methods of the user read that generated code calls and never looks into, by its fingerprint: a checkpoint is resumed
//! with the same values of these fields too.
//!
//! Generated code names every field and not its type. Which of three traits has the method `read_into` for it, the compiler
//! decides: that of numbers and what is made of them ([`Compared`]), that of what has the standard library's `Hash`
//! ([`Hashed`]), or that of everything else ([`Unknown`]), whose values are rejected when a checkpoint is resumed. The
//! call is on `&&&Field`, and a method is looked for at a type before it is looked for behind its reference.

use crate::state::digest::{Digest, Digested};
use core::{any::type_name, hash::Hash};

/// The fingerprint of all that these methods read, or the first field of which there is none.
#[derive(Clone, Copy, Debug)]
pub struct ReadByMethods(Digest);

impl Default for ReadByMethods {
    fn default() -> Self {
        Self(Digest::EMPTY)
    }
}

impl ReadByMethods {
    /// Creates the fingerprint of a system that gives its own.
    pub fn of_fingerprint(fingerprint: u64) -> Self {
        let mut read = Self::default();
        read.0.add(&fingerprint);
        read
    }
}

impl Digested for ReadByMethods {
    fn add_to(&self, digest: &mut Digest) {
        digest.add(&self.0.value());
        if let Some(name) = self.0.unknown() {
            digest.cannot_add(name);
        }
    }
}

/// A field that is read.
#[derive(Debug)]
pub struct Field<'f, T: ?Sized>(pub &'f T);

/// A number, or what is made of numbers.
pub trait Compared {
    /// Adds the value of the field of this name.
    fn read_into(&self, name: &'static str, read: &mut ReadByMethods);
}

impl<T: Digested + ?Sized> Compared for &&Field<'_, T> {
    fn read_into(&self, _name: &'static str, read: &mut ReadByMethods) {
        read.0.add(self.0);
    }
}

/// A value of a type that has `Hash`.
pub trait Hashed {
    /// Adds the value of the field of this name.
    fn read_into(&self, name: &'static str, read: &mut ReadByMethods);
}

impl<T: Hash + ?Sized> Hashed for &Field<'_, T> {
    fn read_into(&self, name: &'static str, read: &mut ReadByMethods) {
        // The hash of a pointer is its address, which is another one in each process.
        let kind = type_name::<T>();
        match kind.contains("fn(") || kind.contains("*const ") || kind.contains("*mut ") {
            true => read.0.cannot_add(name),
            false => self.0.hash(&mut read.0),
        }
    }
}

/// A value of another type.
pub trait Unknown {
    /// Notes that the field of this name cannot be compared.
    fn read_into(&self, name: &'static str, read: &mut ReadByMethods);
}

impl<T: ?Sized> Unknown for Field<'_, T> {
    fn read_into(&self, name: &'static str, read: &mut ReadByMethods) {
        read.0.cannot_add(name);
    }
}

#[cfg(all(test, feature = "std"))]
mod tests {
    use super::*;
    use alloc::{borrow::ToOwned, boxed::Box, string::String, sync::Arc, vec};
    use std::collections::{BTreeMap, HashMap, VecDeque};

    /// The fingerprint of the value of a field, or its name where there is none.
    macro_rules! read {
        ($value:expr) => {{
            let (mut read, value) = (ReadByMethods::default(), $value);
            (&&&Field(&value)).read_into("self.field", &mut read);
            read.0.unknown().map_or(Ok(read.0.value()), Err)
        }};
    }

    #[derive(Hash)]
    enum Kind {
        Soft,
        Hard(u8),
    }

    struct Spline;

    /// Each row has two values of a type that differ.
    #[test]
    fn other_values_have_other_fingerprints() {
        macro_rules! differ {
            ($($one:expr, $other:expr;)*) => {$(
                let one: Result<u64, &str> = read!($one);
                assert!(one.is_ok(), "{}", stringify!($one));
                assert_eq!(one, read!($one));
                assert_ne!(one, read!($other), "{}", stringify!($one));
            )*};
        }
        differ! {
            1.0_f64, 1.0_f64.next_up();
            1.0_f32, 1.0_f32.next_up();
            7_i8, -7_i8;
            7_u64, 8_u64;
            1_u128, 1_u128 << 64;
            true, false;
            'a', 'b';
            "a", "b";
            String::from("ab"), String::from("ac");
            [1.0, 2.0], [2.0, 1.0];
            [[1.0], [2.0]], [[1.0], [3.0]];
            vec![(1_usize, 2.0)], vec![(1_usize, 3.0)];
            vec![Some(1.0)], vec![None::<f64>];
            vec![vec![1.0], vec![]], vec![vec![], vec![1.0]];
            Arc::<[f64]>::from([1.0]), Arc::<[f64]>::from([2.0]);
            Box::new((1.0, "a".to_owned())), Box::new((1.0, "b".to_owned()));
            VecDeque::from([1.0]), VecDeque::from([2.0]);
            Kind::Soft, Kind::Hard(1);
            vec![Kind::Hard(1)], vec![Kind::Hard(2)];
            BTreeMap::from([(1, 2)]), BTreeMap::from([(1, 3)]);
        }
    }

    #[test]
    fn fields_that_cannot_be_compared_are_named() {
        let function: fn(f64) -> f64 = f64::sin;
        let of_reference: fn(&[f64]) -> usize = <[f64]>::len;
        assert_eq!(read!(Spline), Err("self.field"));
        assert_eq!(read!(vec![Spline]), Err("self.field"));
        assert_eq!(read!(function), Err("self.field"));
        assert_eq!(read!(vec![of_reference]), Err("self.field"));
        assert_eq!(read!(HashMap::from([(1, 2.0)])), Err("self.field"));
        assert_eq!(read!(Box::new(|x: f64| x) as Box<dyn Fn(f64) -> f64>), Err("self.field"));
        assert_eq!(read!(core::ptr::null::<f64>()), Err("self.field"));
    }
}
