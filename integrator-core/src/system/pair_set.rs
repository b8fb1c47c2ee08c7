//! Sets of pairs of bodies, such as pairs that are excluded from a sum.

use crate::{
    scalar::{
        real::{Mask, Real},
        simd::row::Row,
    },
    state::digest::{Digest, Digested},
    system::{not_finite::Constants, prepared::OfMembers},
};
use alloc::{vec, vec::Vec};
use core::ops::{Deref, Range};

/// A set of pairs of bodies.
#[derive(Clone, Debug, PartialEq)]
pub struct PairSet<R> {
    /// The largest difference of the numbers of two bodies of a pair.
    span: R,
    /// Where the partners of each body begin in `partners`, and where the last ones end.
    starts: Vec<usize>,
    /// The partners of all first bodies, those of each in ascending order.
    partners: Vec<usize>,
}

impl PairSet<f64> {
    /// Creates the set of these first bodies of `length`, each with the partners that `partners_of` returns.
    pub fn new(first_bodies: Range<usize>, length: usize, partners_of: &dyn Fn(usize) -> Vec<usize>) -> Self {
        let (mut starts, mut partners, mut span) = (Vec::with_capacity(length + 1), Vec::new(), 0);
        for body in 0..length {
            starts.push(partners.len());
            if first_bodies.contains(&body) {
                let mut own = partners_of(body);
                own.sort_unstable();
                own.dedup();
                span = own.iter().map(|partner| partner.abs_diff(body)).fold(span, usize::max);
                partners.append(&mut own);
            }
        }
        starts.push(partners.len());
        Self { span: span as f64, starts, partners }
    }

    /// Adds each pair with its bodies exchanged.
    pub fn either_way(self) -> Self {
        let bodies = 0..self.starts.len() - 1;
        let mut partners_of = vec![Vec::new(); bodies.len()];
        for first in bodies.clone() {
            for second in &self.partners[self.starts[first]..self.starts[first + 1]] {
                partners_of[first].push(*second);
                partners_of[*second].push(first);
            }
        }
        Self::new(bodies.clone(), bodies.len(), &|body| partners_of[body].clone())
    }
}

impl<R: Real> PairSet<R> {
    /// Returns one where the pair of these bodies is in the set, and zero elsewhere.
    #[inline(always)]
    pub fn entry<W: Row<R>>(&self, first: W, second: W) -> W {
        let (distance, none) = ((first - second).abs(), W::of(0.0));
        // Few pairs that are near each other in space are also near in number.
        if self.partners.is_empty() || !distance.less_or_equal(W::splat(self.span)).any() {
            return none;
        }
        let (mut firsts, mut seconds, mut found) = ([R::of(0.0); 8], [R::of(0.0); 8], [R::of(0.0); 8]);
        first.write(&mut firsts);
        second.write(&mut seconds);
        for body in 0..W::LANES / R::LANES {
            let entry = |lane| self.contains(firsts[body].lane(lane) as usize, seconds[body].lane(lane) as usize);
            found[body] = R::state(&|lane| if entry(lane) { 1.0 } else { 0.0 });
        }
        W::read(&found)
    }
    /// Whether a pair is in the set.
    fn contains(&self, first: usize, second: usize) -> bool {
        let [Some(start), Some(end)] = [first, first + 1].map(|at| self.starts.get(at)) else { return false };
        self.partners[*start..*end].binary_search(&second).is_ok()
    }
    /// Returns the derivative of its entries, as a set without pairs.
    pub fn zeros(mut self) -> Self {
        self.partners.clear();
        self.starts.fill(0);
        self
    }
    /// Whether another set has the same pairs, so that members of an ensemble can share it.
    pub fn is_like(&self, other: &Self) -> bool {
        (&self.starts, &self.partners) == (&other.starts, &other.partners)
    }
}

impl<R: Real> OfMembers<PairSet<f64>> for PairSet<R> {
    fn in_lanes<'c>(of_lane: &dyn Fn(usize) -> &'c PairSet<f64>) -> Self
    where
        PairSet<f64>: 'c,
    {
        let PairSet { span, starts, partners } = of_lane(0).clone();
        Self { span: R::of(span), starts, partners }
    }
}

impl Constants for PairSet<f64> {
    fn not_finite(&self) -> Option<(Vec<usize>, f64)> {
        None
    }
}

impl<R: Digested> Digested for PairSet<R> {
    fn add_to(&self, digest: &mut Digest) {
        digest.add(&self.starts);
        digest.add(&self.partners);
    }
}

/// The items of a collection that contains bodies.
#[derive(Debug)]
pub struct Items<'a, T: ?Sized>(pub &'a T);

/// A collection whose items are not integers, or are not known.
#[derive(Debug)]
pub struct Unlisted;

/// An integer that is the number of a body.
pub trait Number {
    /// The number, if there may be such a body.
    fn number(&self) -> Option<usize>;
}

impl<'a, T: ?Sized> Items<'a, T>
where
    &'a T: IntoIterator<Item: Number>,
{
    /// Returns those of some bodies that are among its items.
    pub fn bodies(&self, bodies: Range<usize>, contains: &dyn Fn(usize) -> bool) -> Vec<usize> {
        let numbers = self.0.into_iter().filter_map(|item| item.number());
        numbers.filter(|body| bodies.contains(body) && contains(*body)).collect()
    }
}

impl Unlisted {
    /// Returns those of some bodies that it contains.
    pub fn bodies(&self, bodies: Range<usize>, contains: &dyn Fn(usize) -> bool) -> Vec<usize> {
        bodies.filter(|body| contains(*body)).collect()
    }
}

impl<T: ?Sized> Deref for Items<'_, T> {
    type Target = Unlisted;

    fn deref(&self) -> &Unlisted {
        &Unlisted
    }
}

macro_rules! numbers {
    ($($integer:ty)*) => {
        $(
            impl Number for &$integer {
                fn number(&self) -> Option<usize> {
                    usize::try_from(**self).ok()
                }
            }
        )*
    };
}

numbers!(u8 u16 u32 u64 u128 usize i8 i16 i32 i64 i128 isize);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::simd::lanes::Lanes;
    use alloc::{boxed::Box, collections::BTreeSet};

    #[test]
    fn bodies_are_items_or_are_tested_one_by_one() {
        let contains = |of: &[usize]| {
            let of = of.to_vec();
            move |body: usize| of.contains(&body)
        };
        assert_eq!(Items(&vec![4_usize, 1, 9, 0]).bodies(1..5, &contains(&[4, 1, 9, 0])), [4, 1]);
        assert_eq!(Items(&[3_u32, 2]).bodies(0..5, &contains(&[2, 3])), [3, 2]);
        assert_eq!(Items(&BTreeSet::from([3_i64, -1])).bodies(0..5, &contains(&[3])), [3]);
        let boxed: Box<[usize]> = Box::new([2]);
        assert_eq!(Items(&boxed).bodies(0..5, &contains(&[2])), [2]);
        // The items of the first are not known, and those of the second are not integers.
        assert_eq!(Items(&(1_usize..3)).bodies(0..5, &contains(&[1, 2])), [1, 2]);
        assert_eq!(Items(&vec![1.0]).bodies(2..5, &contains(&[1, 4])), [4]);
    }

    #[test]
    fn vectors_find_the_pairs_of_each_lane() {
        type Both = Lanes<f64, 8>;
        let partners_of = |body: usize| vec![body * body % 7, (body + 1) % 20];
        let set = PairSet::new(1..20, 20, &partners_of);
        for step in [1, 3, 7] {
            let numbers = [0, step].map(|shift| Both::state(&|lane| ((lane * step + shift) % 20) as f64));
            let entries = set.entry(numbers[0], numbers[1]);
            for lane in 0..8 {
                let [first, second] = numbers.map(|number| number.lane(lane) as usize);
                let expected = first > 0 && partners_of(first).contains(&second);
                assert_eq!(entries.lane(lane) == 1.0, expected, "{first}, {second}");
            }
        }
        assert_eq!(set.entry(0.0, 1.0), 0.0);
        let either_way = set.clone().either_way();
        for (first, second) in (0..20).flat_map(|first| (0..20).map(move |second| (first, second))) {
            let expected = set.contains(first, second) || set.contains(second, first);
            assert_eq!(either_way.contains(first, second), expected, "{first}, {second}");
        }
        assert_eq!(set.zeros().entry(1.0, 2.0), 0.0);
    }
}
