//! Where eight iterations side by side read.

use super::table::{Coefficients, EIGHT, Layout, Wide};
use crate::scalar::{real::Real, simd::row::Row};

/// Where the numbers of eight iterations are among the coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Places {
    /// Side by side from here on.
    Neighbours(usize),
    /// Among the eight from here on.
    Near(usize, [u64; EIGHT]),
    /// Anywhere.
    Far([usize; EIGHT]),
}

impl Places {
    /// Where the numbers of the iterations that there are lie. Those of further components lie as many strides further
    /// on.
    pub(super) fn of(places: [Option<usize>; EIGHT], layout: Layout) -> Self {
        let known = || places.iter().flatten();
        let (first, last) = known().fold((usize::MAX, 0), |(first, last), place| (first.min(*place), last.max(*place)));
        let stride = layout.stride();
        let (aligned, end) = (first / EIGHT * EIGHT, (first / stride + 1) * stride);
        // Lanes that no iteration has may read anything.
        let in_lane = |(lane, place): (usize, &Option<usize>)| place.is_none_or(|place| place == aligned + lane);
        if stride >= EIGHT && places.iter().enumerate().all(in_lane) {
            return Self::Neighbours(aligned);
        }
        let places = places.map(|place| place.unwrap_or(first));
        if last - first >= EIGHT || last >= end || stride < EIGHT {
            return Self::Far(places);
        }
        // A register that begins where one has been written is read sooner.
        let begin = if last < aligned + EIGHT { aligned } else { first.min(end - EIGHT) };
        let near = places.map(|place| (place - begin) as u64);
        if near == core::array::from_fn(|place| place as u64) {
            Self::Neighbours(begin)
        } else {
            Self::Near(begin, near)
        }
    }

    /// The numbers there of so many components, of some orders.
    #[inline(always)]
    pub(super) fn read<R: Real, const COMPONENTS: usize, const AT_ONCE: usize>(
        &self,
        from: &Coefficients<'_, R>,
        order: usize,
    ) -> [[Wide<R>; AT_ONCE]; COMPONENTS] {
        let mut found = [[Wide::<R>::of(0.0); AT_ONCE]; COMPONENTS];
        // What this begins is the same for all components, and looked at once.
        macro_rules! each {
            (|$numbers:ident| $read:expr) => {
                for component in 0..COMPONENTS {
                    for at in 0..AT_ONCE {
                        let $numbers = &from[order + at][component * from.stride()..];
                        found[component][at] = $read;
                    }
                }
            };
        }
        match self {
            Places::Neighbours(begin) => each!(|numbers| Row::read(&numbers[*begin..])),
            Places::Near(begin, places) => {
                each!(|numbers| <Wide<R> as Row<R>>::read(&numbers[*begin..]).permute(places));
            }
            Places::Far(places) => each!(|numbers| {
                let mut gathered = [R::of(0.0); EIGHT];
                for (number, place) in gathered.iter_mut().zip(places) {
                    *number = numbers[*place];
                }
                Row::read(&gathered)
            }),
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::vec::Vec;

    fn layout(length: usize) -> Layout {
        Layout::of::<Vec<f64>>(length, false)
    }

    /// Where eight iterations read.
    fn of_all(places: [usize; EIGHT], length: usize) -> Places {
        Places::of(places.map(Some), layout(length))
    }

    #[test]
    fn places_are_found_the_nearest_way() {
        let side_by_side: [usize; EIGHT] = core::array::from_fn(|iteration| iteration);
        assert_eq!(of_all(side_by_side.map(|iteration| iteration + 3), 16), Places::Neighbours(3));
        assert_eq!(of_all([1, 0, 2, 2, 5, 4, 0, 1], 8), Places::Near(0, [1, 0, 2, 2, 5, 4, 0, 1]));
        assert_eq!(of_all([0, 8, 0, 8, 0, 8, 0, 8], 16), Places::Far([0, 8, 0, 8, 0, 8, 0, 8]));
        assert_eq!(of_all([3; EIGHT], 4), Places::Far([3; EIGHT]), "a row that is shorter than a register");
    }

    #[test]
    fn places_of_two_components_are_far_from_each_other() {
        let points = Layout::of::<Vec<[f64; 2]>>(8, false);
        assert_eq!(Places::of([6, 7, 8, 9, 6, 7, 8, 9].map(Some), points), Places::Far([6, 7, 8, 9, 6, 7, 8, 9]));
        let points = Layout::of::<Vec<[f64; 2]>>(16, false);
        assert_eq!(Places::of([7, 8, 15, 9, 7, 8, 9, 9].map(Some), points), Places::Far([7, 8, 15, 9, 7, 8, 9, 9]));
        let near = Places::of([7, 8, 14, 9, 7, 8, 9, 9].map(Some), points);
        assert_eq!(near, Places::Near(7, [0, 1, 7, 2, 0, 1, 2, 2]));
        let near = Places::of([15, 14, 14, 9, 11, 12, 9, 9].map(Some), points);
        assert_eq!(near, Places::Near(8, [7, 6, 6, 1, 3, 4, 1, 1]), "not beyond the last point");
    }

    #[test]
    fn lanes_without_a_iteration_read_what_is_nearest() {
        let some = |iteration: usize| (iteration % 3 == 1).then_some(8 + iteration);
        assert_eq!(Places::of(core::array::from_fn(some), layout(16)), Places::Neighbours(8));
        let some = |iteration: usize| (iteration < 2).then_some(9 + iteration);
        assert_eq!(Places::of(core::array::from_fn(some), layout(16)), Places::Near(8, [1, 2, 1, 1, 1, 1, 1, 1]));
    }
}
