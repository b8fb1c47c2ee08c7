//! The turns of loops, eight side by side.
//!
//! Comes in: which coordinates each turn reads and moves, and its constants, once per run. Goes out: the same as rows of
//! registers, where eight turns lie in one. Always true: a coordinate gets its addends one target after the other, those of
//! one target eight turns after the other, those of eight turns added up in their order; so bits depend on the text alone.

use super::{
    addends::{Addend, Addends},
    table::{EIGHT, Eight},
};
use crate::{real::Real, row::Row};
use alloc::vec::Vec;

/// How many turns lie side by side.
const TURNS: usize = EIGHT;

/// Numbers side by side, one of each turn.
pub type Abreast<R> = Eight<R>;

/// The same number in all turns.
#[inline(always)]
pub fn spread<R: Real>(x: R) -> Abreast<R> {
    Abreast::<R>::splat(x)
}

/// Where the numbers of eight turns are among the coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Places {
    /// Side by side from here on.
    Neighbours(usize),
    /// Among the eight from here on.
    Near(usize, [u64; TURNS]),
    /// Anywhere.
    Far([usize; TURNS]),
}

impl Places {
    /// Where eight places are in a row of so many coordinates.
    fn of(places: [usize; TURNS], width: usize) -> Self {
        let (first, last) =
            places.iter().fold((usize::MAX, 0), |(first, last), place| (first.min(*place), last.max(*place)));
        if last - first >= TURNS || width < TURNS {
            return Self::Far(places);
        }
        // A register that begins where one has been written is read sooner.
        let aligned = first / TURNS * TURNS;
        let begin = if last < aligned + TURNS { aligned } else { first.min(width - TURNS) };
        let near = places.map(|place| (place - begin) as u64);
        if near == core::array::from_fn(|place| place as u64) {
            Self::Neighbours(begin)
        } else {
            Self::Near(begin, near)
        }
    }
}

/// The turns of a loop, or of loops inside each other: each reads so many coordinates, has so many constants, and moves
/// so many coordinates; `T` is what eight of them keep.
#[derive(Clone)]
pub struct Turns<R: Real, T, const READS: usize, const CONSTANTS: usize, const TARGETS: usize> {
    /// The turns before they are in rows.
    turns: Vec<([usize; READS], [R; CONSTANTS], [usize; TARGETS])>,
    rows: Vec<T>,
    reads: Vec<[Places; READS]>,
    constants: Vec<[Abreast<R>; CONSTANTS]>,
    /// What positions and momenta get.
    addends: [Addends<R>; 2],
    /// What the turns have computed for their targets, row by row.
    found: Vec<Abreast<R>>,
}

impl<R: Real, T, const READS: usize, const CONSTANTS: usize, const TARGETS: usize> Default
    for Turns<R, T, READS, CONSTANTS, TARGETS>
{
    fn default() -> Self {
        Self {
            turns: Vec::new(),
            rows: Vec::new(),
            reads: Vec::new(),
            constants: Vec::new(),
            addends: [Addends::default(), Addends::default()],
            found: Vec::new(),
        }
    }
}

impl<R: Real, T: Default, const READS: usize, const CONSTANTS: usize, const TARGETS: usize>
    Turns<R, T, READS, CONSTANTS, TARGETS>
{
    /// Whether the turns are not there yet.
    #[inline(always)]
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }
    /// Another turn.
    pub fn take(&mut self, reads: [usize; READS], constants: [R; CONSTANTS], targets: [usize; TARGETS]) {
        self.turns.push((reads, constants, targets));
    }
    /// Lays the turns out in rows, for coordinates of such a width; targets are positions (0) or momenta (1).
    pub fn lay_out(&mut self, width: usize, parts: [usize; TARGETS]) {
        let turns = core::mem::take(&mut self.turns);
        for turns in turns.chunks(TURNS) {
            // At the end, the last turn stands in for those that are not there.
            let turn = |place: usize| turns[place.min(turns.len() - 1)];
            self.rows.push(T::default());
            self.reads.push(core::array::from_fn(|read| {
                Places::of(core::array::from_fn(|place| turn(place).0[read]), width)
            }));
            self.constants.push(core::array::from_fn(|constant| {
                let constants: [R; TURNS] = core::array::from_fn(|place| turn(place).1[constant]);
                Abreast::<R>::read(&constants)
            }));
            self.found.extend([Abreast::<R>::of(0.0); TARGETS]);
        }
        self.addends = [0, 1].map(|part| {
            let targets = (0..TARGETS).filter(|target| parts[*target] == part);
            let addends = targets.flat_map(|target| {
                turns.iter().enumerate().map(move |(number, turn)| Addend {
                    place: turn.2[target],
                    found: number / TURNS * TARGETS + target,
                    turn: number % TURNS,
                })
            });
            Addends::of(addends.collect(), width)
        });
    }
    /// How many rows there are.
    #[inline(always)]
    pub fn rows(&self) -> usize {
        self.rows.len()
    }
    /// What the turns of a row read from the coefficients of an order.
    #[inline(always)]
    pub fn read(&self, row: usize, read: usize, from: &[R]) -> Abreast<R> {
        match &self.reads[row][read] {
            Places::Neighbours(begin) => Row::read(&from[*begin..]),
            Places::Near(begin, places) => <Abreast<R> as Row<R>>::read(&from[*begin..]).picked(places),
            Places::Far(places) => {
                let mut numbers = [from[places[0]]; TURNS];
                for (number, place) in numbers.iter_mut().zip(places) {
                    *number = from[*place];
                }
                Row::read(&numbers)
            }
        }
    }
    /// What the turns of a row keep, and their constants.
    #[inline(always)]
    pub fn row(&mut self, row: usize) -> (&mut T, [Abreast<R>; CONSTANTS]) {
        (&mut self.rows[row], self.constants[row])
    }
    /// Puts down what the turns of a row have computed for their targets.
    #[inline(always)]
    pub fn put(&mut self, row: usize, found: [Abreast<R>; TARGETS]) {
        self.found[row * TARGETS..][..TARGETS].copy_from_slice(&found);
    }
    /// Adds what all turns have computed to the coefficients of an order.
    #[inline(always)]
    pub fn add(&self, [q, p]: [&mut [R]; 2]) {
        self.addends[0].add(&self.found, q);
        self.addends[1].add(&self.found, p);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        fused::{Avx512, Fma, Fused},
        instruction_set::InstructionSet,
    };

    /// Numbers that are spread evenly.
    fn number(seed: usize) -> f64 {
        (seed as f64 * 0.618_033_988_749_895).fract() - 0.4
    }

    /// The turns of two loops: what each reads and the two coordinates that it moves.
    fn lists() -> Vec<(&'static str, usize, Vec<[usize; 2]>)> {
        let pairs = |n: usize| (0..n).flat_map(move |i| (0..i).map(move |j| [i, j])).collect();
        vec![
            ("neighbours", 32, (0..31).map(|i| [i, i + 1]).collect()),
            ("a ring", 24, (0..19).map(|i| [i, (i + 1) % 19]).collect()),
            ("pairs of six", 8, pairs(6)),
            ("pairs of eleven", 16, pairs(11)),
            ("one coordinate", 8, vec![[3, 3]; 11]),
            ("anywhere", 64, (0..21).map(|i| [i * 37 % 61, i * 53 % 64]).collect()),
            ("few coordinates", 4, pairs(4)),
        ]
    }

    /// The bits are those of a loop, one target after the other.
    fn turns_are_those_of_a_loop<R: Real>() {
        for (name, width, list) in lists() {
            let mut turns: Turns<R, (), 2, 1, 3> = Turns::default();
            assert!(turns.is_empty());
            for (seed, [i, j]) in list.iter().enumerate() {
                turns.take([*i, *j], [R::of(number(seed))], [*i, *j, *i]);
            }
            turns.lay_out(width, [1, 1, 0]);
            assert_eq!(turns.rows(), list.len().div_ceil(TURNS), "{name}");
            let from: Vec<R> = (0..width).map(|place| R::of(number(place + 100))).collect();
            let (mut q, mut p) = (from.clone(), from.clone());
            for row in 0..turns.rows() {
                let (a, b) = (turns.read(row, 0, &from), turns.read(row, 1, &from));
                let ((), [constant]) = turns.row(row);
                turns.put(row, [a * b, (a - b) * constant, spread(R::of(2.0)) * a]);
            }
            turns.add([&mut q, &mut p]);

            // Eight turns are added up on their own where coordinates fill a register.
            let (mut by_loop_q, mut by_loop_p) = (from.clone(), from.clone());
            let add = |to: &mut [R], value: &dyn Fn(usize) -> (usize, R)| {
                for row in (0..list.len()).collect::<Vec<_>>().chunks(if width < EIGHT { 1 } else { TURNS }) {
                    let mut own = vec![R::of(-0.0); width];
                    for (place, value) in row.iter().map(|turn| value(*turn)) {
                        own[place] += value;
                    }
                    to.iter_mut().zip(own).for_each(|(to, own)| *to += own);
                }
            };
            add(&mut by_loop_p, &|turn| (list[turn][0], from[list[turn][0]] * from[list[turn][1]]));
            add(&mut by_loop_p, &|turn| {
                let [i, j] = list[turn];
                (j, (from[i] - from[j]) * R::of(number(turn)))
            });
            add(&mut by_loop_q, &|turn| (list[turn][0], R::of(2.0) * from[list[turn][0]]));
            let bits = |numbers: &[R]| -> Vec<u64> { numbers.iter().map(|x| x.lane(0).to_bits()).collect() };
            assert_eq!(bits(&q), bits(&by_loop_q), "{name}");
            assert_eq!(bits(&p), bits(&by_loop_p), "{name}");
        }
    }

    #[test]
    fn turns_side_by_side_have_the_bits_of_a_loop() {
        turns_are_those_of_a_loop::<f64>();
        turns_are_those_of_a_loop::<f32>();
        let available = InstructionSet::available();
        if available.contains(&InstructionSet::Fused) {
            turns_are_those_of_a_loop::<Fused<f64, Fma>>();
            turns_are_those_of_a_loop::<Fused<f32, Fma>>();
        }
        if available.contains(&InstructionSet::Avx512) {
            turns_are_those_of_a_loop::<Fused<f64, Avx512>>();
            turns_are_those_of_a_loop::<Fused<f32, Avx512>>();
        }
    }

    #[test]
    fn places_are_found_the_nearest_way() {
        let side_by_side: [usize; TURNS] = core::array::from_fn(|turn| turn);
        assert_eq!(Places::of(side_by_side.map(|turn| turn + 3), 16), Places::Neighbours(3));
        assert_eq!(Places::of([1, 0, 2, 2, 5, 4, 0, 1], 8), Places::Near(0, [1, 0, 2, 2, 5, 4, 0, 1]));
        assert_eq!(Places::of([0, 8, 0, 8, 0, 8, 0, 8], 16), Places::Far([0, 8, 0, 8, 0, 8, 0, 8]));
        assert_eq!(Places::of([3; TURNS], 4), Places::Far([3; TURNS]), "a row that is shorter than a register");
    }
}
