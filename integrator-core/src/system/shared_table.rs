//! Tables of prepared constants: lists of a length known at run time, which clones share.

use crate::{
    scalar::real::Real,
    state::digest::{Digest, Digested},
    system::{not_finite::Constants, prepared::OfMembers},
};
use alloc::{sync::Arc, vec::Vec};
use core::ops::Deref;

/// A list that does not change. A clone refers to the same list.
#[derive(Debug)]
pub struct SharedTable<T>(Arc<[T]>);

impl<T> Clone for SharedTable<T> {
    #[inline]
    fn clone(&self) -> Self {
        Self(Arc::clone(&self.0))
    }
}

impl<T> Deref for SharedTable<T> {
    type Target = [T];

    #[inline(always)]
    fn deref(&self) -> &[T] {
        &self.0
    }
}

impl<T> AsRef<[T]> for SharedTable<T> {
    #[inline(always)]
    fn as_ref(&self) -> &[T] {
        &self.0
    }
}

impl<T: PartialEq> PartialEq for SharedTable<T> {
    fn eq(&self, other: &Self) -> bool {
        self.0 == other.0
    }
}

impl<T> From<Vec<T>> for SharedTable<T> {
    fn from(elements: Vec<T>) -> Self {
        Self(elements.into())
    }
}

impl<T, const N: usize> From<[T; N]> for SharedTable<T> {
    fn from(elements: [T; N]) -> Self {
        Self(elements.into())
    }
}

/// Returns a table of this length.
///
/// The closure is behind a reference, so that this compiles once for each `T` and not once for each table.
pub fn table<T>(length: usize, element: &dyn Fn(usize) -> T) -> SharedTable<T> {
    SharedTable((0..length).map(element).collect())
}

/// An element of a table of all members.
///
/// # Safety
/// Where [`Element::IS_SAME`] is true, `Self` has the memory layout of `T`, a `T` is a valid `Self`, and neither has interior
/// mutability, since a list is read as both.
#[allow(unsafe_code, reason = "states which types have equal layouts")]
pub unsafe trait Element<T>: OfMembers<T> {
    /// Whether an element is that of the one member.
    const IS_SAME: bool = false;
}

#[allow(unsafe_code, reason = "states which types have equal layouts")]
// SAFETY: `IsF64` exists for `f64` and `Fused<f64, _>`, which is transparent.
unsafe impl<R: Real> Element<f64> for R {
    const IS_SAME: bool =
        R::IS_F64.is_some() && size_of::<R>() == size_of::<f64>() && align_of::<R>() == align_of::<f64>();
}

#[allow(unsafe_code, reason = "states which types have equal layouts")]
// SAFETY: an array has the layout of its elements, one after the other.
unsafe impl<L: Element<T>, T, const N: usize> Element<[T; N]> for [L; N] {
    const IS_SAME: bool = L::IS_SAME;
}

#[allow(unsafe_code, reason = "states which types have equal layouts")]
// SAFETY: `IS_SAME` is false.
unsafe impl<L: Element<T>, T> Element<SharedTable<T>> for SharedTable<L> {}

/// The length of a table is that of the first lane's. A single member keeps its table.
#[allow(unsafe_code, reason = "there is no safe view of a list as one of a transparent type")]
impl<L: Element<T>, T> OfMembers<SharedTable<T>> for SharedTable<L> {
    fn in_lanes<'c>(of_lane: &dyn Fn(usize) -> &'c SharedTable<T>) -> Self
    where
        T: 'c,
    {
        let first = of_lane(0);
        if const { L::IS_SAME } {
            let elements: *const [T] = Arc::into_raw(Arc::clone(&first.0));
            // SAFETY: the pointer is from `into_raw`, and by `Element` the types have the same layout.
            return Self(unsafe { Arc::from_raw(elements as *const [L]) });
        }
        let mut elements = Vec::with_capacity(first.len());
        for index in 0..first.len() {
            elements.push(L::in_lanes(&|lane| &of_lane(lane)[index]));
        }
        elements.into()
    }
}

impl<T: Digested> Digested for SharedTable<T> {
    fn add_to(&self, digest: &mut Digest) {
        self.0.add_to(digest);
    }
}

impl<T: Constants> Constants for SharedTable<T> {
    fn not_finite(&self) -> Option<(Vec<usize>, f64)> {
        self.0.not_finite()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        scalar::{
            fma::{Avx512, Fma, Fused},
            simd::lanes::Lanes,
        },
        system::prepared::in_lanes,
    };

    type Rows<R> = SharedTable<SharedTable<[R; 2]>>;

    /// Rows of different lengths, as a table of one member.
    fn rows() -> Rows<f64> {
        table(3, &|row| table(row, &|column| [row as f64, -(column as f64)]))
    }

    /// The values of the table in lanes, and whether its last row is that of the member.
    fn gathered<R: Real>() -> (Vec<f64>, bool) {
        let rows = rows();
        let found: Rows<R> = in_lanes(&[&rows], |rows| rows);
        let values = found.iter().flat_map(|row| row.iter().flatten()).map(|value| value.lane(0)).collect();
        (values, found[2].as_ptr().cast() == rows[2].as_ptr())
    }

    #[test]
    fn a_table_of_one_member_is_shared() {
        let expected = vec![1.0, 0.0, 2.0, 0.0, 2.0, -1.0];
        assert_eq!(gathered::<f64>(), (expected.clone(), true));
        assert_eq!(gathered::<Fused<f64, Fma>>(), (expected.clone(), true));
        assert_eq!(gathered::<Fused<f64, Avx512>>(), (expected.clone(), true));
        assert_eq!(gathered::<f32>(), (expected.clone(), false));
        assert_eq!(gathered::<Lanes<f64, 1>>(), (expected, false));
    }

    /// The list is freed once, by whichever of its owners is the last.
    #[test]
    fn a_shared_table_outlives_its_member() {
        let rows = rows();
        let found: Rows<Fused<f64, Fma>> = in_lanes(&[&rows], |rows| rows);
        let list = found[1].clone();
        drop(rows);
        drop(found);
        assert_eq!(list[0].map(|value| value.0), [1.0, 0.0]);
    }
}
