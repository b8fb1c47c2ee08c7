//! Where eight turns side by side read.

use super::table::{EIGHT, Eight};
use crate::{real::Real, row::Row};

/// Where the numbers of eight turns are among the coordinates.
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
    /// Where the numbers of the turns that there are lie in a row of so many coordinates.
    pub(super) fn of(places: [Option<usize>; EIGHT], width: usize) -> Self {
        let known = || places.iter().flatten();
        let (first, last) = known().fold((usize::MAX, 0), |(first, last), place| (first.min(*place), last.max(*place)));
        let aligned = first / EIGHT * EIGHT;
        // Lanes that no turn has may read anything.
        let in_lane = |(lane, place): (usize, &Option<usize>)| place.is_none_or(|place| place == aligned + lane);
        if aligned + EIGHT <= width && places.iter().enumerate().all(in_lane) {
            return Self::Neighbours(aligned);
        }
        let places = places.map(|place| place.unwrap_or(first));
        if last - first >= EIGHT || width < EIGHT {
            return Self::Far(places);
        }
        // A register that begins where one has been written is read sooner.
        let begin = if last < aligned + EIGHT { aligned } else { first.min(width - EIGHT) };
        let near = places.map(|place| (place - begin) as u64);
        if near == core::array::from_fn(|place| place as u64) {
            Self::Neighbours(begin)
        } else {
            Self::Near(begin, near)
        }
    }

    /// The numbers there, of some orders.
    #[inline(always)]
    pub(super) fn read<R: Real, const AT_ONCE: usize>(&self, from: [&[R]; AT_ONCE]) -> [Eight<R>; AT_ONCE] {
        let mut found = [Eight::<R>::of(0.0); AT_ONCE];
        match self {
            Places::Neighbours(begin) => {
                for at in 0..AT_ONCE {
                    found[at] = Row::read(&from[at][*begin..]);
                }
            }
            Places::Near(begin, places) => {
                for at in 0..AT_ONCE {
                    found[at] = <Eight<R> as Row<R>>::read(&from[at][*begin..]).picked(places);
                }
            }
            Places::Far(places) => {
                for at in 0..AT_ONCE {
                    let mut numbers = [R::of(0.0); EIGHT];
                    for (number, place) in numbers.iter_mut().zip(places) {
                        *number = from[at][*place];
                    }
                    found[at] = Row::read(&numbers);
                }
            }
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Where eight turns read.
    fn of_all(places: [usize; EIGHT], width: usize) -> Places {
        Places::of(places.map(Some), width)
    }

    #[test]
    fn places_are_found_the_nearest_way() {
        let side_by_side: [usize; EIGHT] = core::array::from_fn(|turn| turn);
        assert_eq!(of_all(side_by_side.map(|turn| turn + 3), 16), Places::Neighbours(3));
        assert_eq!(of_all([1, 0, 2, 2, 5, 4, 0, 1], 8), Places::Near(0, [1, 0, 2, 2, 5, 4, 0, 1]));
        assert_eq!(of_all([0, 8, 0, 8, 0, 8, 0, 8], 16), Places::Far([0, 8, 0, 8, 0, 8, 0, 8]));
        assert_eq!(of_all([3; EIGHT], 4), Places::Far([3; EIGHT]), "a row that is shorter than a register");
    }

    #[test]
    fn lanes_without_a_turn_read_what_is_nearest() {
        let some = |turn: usize| (turn % 3 == 1).then_some(8 + turn);
        assert_eq!(Places::of(core::array::from_fn(some), 16), Places::Neighbours(8));
        let some = |turn: usize| (turn < 2).then_some(9 + turn);
        assert_eq!(Places::of(core::array::from_fn(some), 16), Places::Near(8, [1, 2, 1, 1, 1, 1, 1, 1]));
    }
}
