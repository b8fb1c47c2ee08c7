//! Prepared constants in lanes: a number of each member in the lanes of a vector, and tables of such vectors.

use crate::scalar::real::Real;

/// A number, or a table of numbers over the indices of loops, for all members; each of them has a `T`.
pub trait OfMembers<T> {
    /// One member per lane.
    fn in_lanes<'c>(of_lane: &dyn Fn(usize) -> &'c T) -> Self
    where
        T: 'c;
}

impl<R: Real> OfMembers<f64> for R {
    fn in_lanes<'c>(of_lane: &dyn Fn(usize) -> &'c f64) -> Self
    where
        f64: 'c,
    {
        R::prepared(&|lane| *of_lane(lane))
    }
}

impl<L: OfMembers<T>, T, const N: usize> OfMembers<[T; N]> for [L; N] {
    fn in_lanes<'c>(of_lane: &dyn Fn(usize) -> &'c [T; N]) -> Self
    where
        T: 'c,
    {
        core::array::from_fn(|index| L::in_lanes(&|lane| &of_lane(lane)[index]))
    }
}

/// A constant of all members, each in its lane.
///
/// A function of its own for each type and not for each constant: what is seldom called is compiled as seldom as
/// possible.
pub fn in_lanes<M, T, L: OfMembers<T>>(members: &[&M], constant: fn(&M) -> &T) -> L {
    L::in_lanes(&|lane| constant(members[lane]))
}
