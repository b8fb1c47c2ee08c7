//! The access patterns of eight iterations that share a vector.

use super::table::{Coefficients, EIGHT, Layout, Wide};
use crate::scalar::{real::Real, simd::row::Row};

/// The indices of coordinates that eight iterations read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum AccessPattern {
    /// Eight consecutive ones from this index on.
    Contiguous(usize),
    /// A permutation of the eight from this index on.
    Permuted(usize, [u64; EIGHT]),
    /// Any eight.
    Gathered([usize; EIGHT]),
}

impl AccessPattern {
    /// The pattern of these indices, those of the first component. Lanes may have no iteration.
    pub(super) fn of(indices: [Option<usize>; EIGHT], layout: Layout) -> Self {
        let known = || indices.iter().flatten();
        let (first, last) = known().fold((usize::MAX, 0), |(first, last), index| (first.min(*index), last.max(*index)));
        let stride = layout.stride();
        let (aligned, end) = (first / EIGHT * EIGHT, (first / stride + 1) * stride);
        // Lanes without an iteration may read anything.
        let in_lane = |(lane, index): (usize, &Option<usize>)| index.is_none_or(|index| index == aligned + lane);
        if stride >= EIGHT && indices.iter().enumerate().all(in_lane) {
            return Self::Contiguous(aligned);
        }
        let indices = indices.map(|index| index.unwrap_or(first));
        if last - first >= EIGHT || last >= end || stride < EIGHT {
            return Self::Gathered(indices);
        }
        // A load that begins where a store began is forwarded sooner.
        let begin = if last < aligned + EIGHT { aligned } else { first.min(end - EIGHT) };
        let near = indices.map(|index| (index - begin) as u64);
        if near == core::array::from_fn(|index| index as u64) {
            Self::Contiguous(begin)
        } else {
            Self::Permuted(begin, near)
        }
    }

    /// Reads the numbers of all components, of consecutive orders.
    #[inline(always)]
    pub(super) fn read<R: Real, const COMPONENTS: usize, const ORDERS: usize>(
        &self,
        from: &Coefficients<'_, R>,
        order: usize,
    ) -> [[Wide<R>; ORDERS]; COMPONENTS] {
        let mut values = [[Wide::<R>::of(0.0); ORDERS]; COMPONENTS];
        // The pattern is the same for all components, so that it is matched once.
        macro_rules! each {
            (|$numbers:ident| $read:expr) => {
                for component in 0..COMPONENTS {
                    for at in 0..ORDERS {
                        let $numbers = &from[order + at][component * from.stride()..];
                        values[component][at] = $read;
                    }
                }
            };
        }
        match self {
            AccessPattern::Contiguous(begin) => each!(|numbers| Row::read(&numbers[*begin..])),
            AccessPattern::Permuted(begin, indices) => {
                each!(|numbers| <Wide<R> as Row<R>>::read(&numbers[*begin..]).permute(indices));
            }
            AccessPattern::Gathered(indices) => each!(|numbers| {
                let mut gathered = [R::of(0.0); EIGHT];
                for (number, index) in gathered.iter_mut().zip(indices) {
                    *number = numbers[*index];
                }
                Row::read(&gathered)
            }),
        }
        values
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::vec::Vec;

    fn layout(length: usize) -> Layout {
        Layout::of::<Vec<f64>>(length, false)
    }

    /// The pattern of eight iterations.
    fn of_all(indices: [usize; EIGHT], length: usize) -> AccessPattern {
        AccessPattern::of(indices.map(Some), layout(length))
    }

    #[test]
    fn indices_have_the_narrowest_pattern() {
        let side_by_side: [usize; EIGHT] = core::array::from_fn(|iteration| iteration);
        assert_eq!(of_all(side_by_side.map(|iteration| iteration + 3), 16), AccessPattern::Contiguous(3));
        assert_eq!(of_all([1, 0, 2, 2, 5, 4, 0, 1], 8), AccessPattern::Permuted(0, [1, 0, 2, 2, 5, 4, 0, 1]));
        assert_eq!(of_all([0, 8, 0, 8, 0, 8, 0, 8], 16), AccessPattern::Gathered([0, 8, 0, 8, 0, 8, 0, 8]));
        assert_eq!(
            of_all([3; EIGHT], 4),
            AccessPattern::Gathered([3; EIGHT]),
            "an order slice that is shorter than a vector"
        );
    }

    #[test]
    fn components_are_not_read_across() {
        let points = Layout::of::<Vec<[f64; 2]>>(8, false);
        assert_eq!(
            AccessPattern::of([6, 7, 8, 9, 6, 7, 8, 9].map(Some), points),
            AccessPattern::Gathered([6, 7, 8, 9, 6, 7, 8, 9])
        );
        let points = Layout::of::<Vec<[f64; 2]>>(16, false);
        assert_eq!(
            AccessPattern::of([7, 8, 15, 9, 7, 8, 9, 9].map(Some), points),
            AccessPattern::Gathered([7, 8, 15, 9, 7, 8, 9, 9])
        );
        let near = AccessPattern::of([7, 8, 14, 9, 7, 8, 9, 9].map(Some), points);
        assert_eq!(near, AccessPattern::Permuted(7, [0, 1, 7, 2, 0, 1, 2, 2]));
        let near = AccessPattern::of([15, 14, 14, 9, 11, 12, 9, 9].map(Some), points);
        assert_eq!(near, AccessPattern::Permuted(8, [7, 6, 6, 1, 3, 4, 1, 1]), "not beyond the last point");
    }

    #[test]
    fn lanes_without_an_iteration_read_the_nearest_element() {
        let some = |iteration: usize| (iteration % 3 == 1).then_some(8 + iteration);
        assert_eq!(AccessPattern::of(core::array::from_fn(some), layout(16)), AccessPattern::Contiguous(8));
        let some = |iteration: usize| (iteration < 2).then_some(9 + iteration);
        assert_eq!(
            AccessPattern::of(core::array::from_fn(some), layout(16)),
            AccessPattern::Permuted(8, [1, 2, 1, 1, 1, 1, 1, 1])
        );
    }
}
