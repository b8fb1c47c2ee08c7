//! Bounds of a system's lists: whether they have an element, where a table is prepared for iterations that the
//! functions may skip.

use alloc::{boxed::Box, collections::VecDeque, rc::Rc, sync::Arc, vec::Vec};
use core::ops::Deref;

/// A list that the text of a system indexes.
#[derive(Debug)]
pub struct Elements<'a, L: ?Sized>(pub &'a L);

/// A type with its own `Index`: only the system knows which elements it has.
#[derive(Debug)]
pub struct Unknown;

impl Unknown {
    /// Assumes that the element is there.
    pub fn has<I>(&self, _index: I) -> bool {
        true
    }
}

// Rust prefers a method of the type itself to one of its `Deref` target.
impl<L: ?Sized> Deref for Elements<'_, L> {
    type Target = Unknown;

    fn deref(&self) -> &Unknown {
        &Unknown
    }
}

macro_rules! lists {
    ($([$($parameters:tt)*] $list:ty;)*) => {
        $(
            impl<$($parameters)*> Elements<'_, $list> {
                /// Whether there is an element at an index.
                pub fn has(&self, index: usize) -> bool {
                    index < self.0.len()
                }
            }
        )*
    };
}

lists! {
    [T] [T];
    [T] &[T];
    [T, const N: usize] [T; N];
    [T, const N: usize] &[T; N];
    [T, const N: usize] Box<[T; N]>;
    [T] Vec<T>;
    [T] &Vec<T>;
    [T] VecDeque<T>;
    [T] Box<[T]>;
    [T] Rc<[T]>;
    [T] Arc<[T]>;
    [T] Rc<Vec<T>>;
    [T] Arc<Vec<T>>;
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::ops::Index;

    /// A list without bounds.
    struct Ring(f64);

    impl Index<usize> for Ring {
        type Output = f64;

        fn index(&self, _: usize) -> &f64 {
            &self.0
        }
    }

    #[test]
    fn lists_and_other_containers_know_their_elements() {
        let list = alloc::vec![1.0, 2.0];
        assert!(Elements(&list).has(1) && !Elements(&list).has(2));
        assert!(Elements(&[1.0, 2.0]).has(1) && !Elements(&[1.0, 2.0]).has(2));
        assert!(Elements(&&list[..1]).has(0) && !Elements(&list[..1]).has(1));
        assert!(!Elements(&Arc::<[f64]>::from(list)).has(2));
        let ring = Ring(3.0);
        assert!(Elements(&ring).has(7) && ring[7] == 3.0);
    }
}
