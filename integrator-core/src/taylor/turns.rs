//! The turns of loops, eight side by side.
//!
//! Comes in: which coordinates each turn reads and moves, and its constants, once per run. Goes out: the same as rows of
//! registers, where eight turns lie in one. Always true: in which order a coordinate gets its addends follows from the order
//! of turns and targets, so that bits depend on the text alone.

use super::{
    addends::{Addend, Addends},
    table::{Coefficients, EIGHT, Eight},
};
use crate::{real::Real, row::Row};
use alloc::{collections::VecDeque, vec::Vec};

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

/// Eight turns side by side, each of which reads so many coordinates and has so many constants; `T` is what they keep.
#[derive(Clone)]
pub struct Line<R: Real, T, const READS: usize, const CONSTANTS: usize> {
    /// What the turns keep.
    pub kept: T,
    /// Their constants.
    pub constants: [Abreast<R>; CONSTANTS],
    reads: [Places; READS],
}

impl<R: Real, T, const READS: usize, const CONSTANTS: usize> Line<R, T, READS, CONSTANTS> {
    /// What the turns read from the coefficients of some orders.
    #[inline(always)]
    pub fn read<const AT_ONCE: usize>(&self, read: usize, from: [&[R]; AT_ONCE]) -> [Abreast<R>; AT_ONCE] {
        let mut found = [Abreast::<R>::of(0.0); AT_ONCE];
        match &self.reads[read] {
            Places::Neighbours(begin) => {
                for at in 0..AT_ONCE {
                    found[at] = Row::read(&from[at][*begin..]);
                }
            }
            Places::Near(begin, places) => {
                for at in 0..AT_ONCE {
                    found[at] = <Abreast<R> as Row<R>>::read(&from[at][*begin..]).picked(places);
                }
            }
            Places::Far(places) => {
                for at in 0..AT_ONCE {
                    let mut numbers = [R::of(0.0); TURNS];
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

/// What turns have computed for so many targets, each of the orders that are found at once.
type Found<R, const TARGETS: usize, const AT_ONCE: usize> = [[Abreast<R>; AT_ONCE]; TARGETS];

/// A turn before it is in a row: what it reads, its constants, and what it moves.
type Turn<R, const READS: usize, const CONSTANTS: usize, const TARGETS: usize> =
    ([usize; READS], [R; CONSTANTS], [usize; TARGETS]);

/// From how many turns the next one of a row is taken.
const NEAR: usize = 8 * TURNS;

/// The turns in an order in which few of a row move the same coordinate: those have to be added one after the other.
fn dealt<R: Real, const READS: usize, const CONSTANTS: usize, const TARGETS: usize>(
    turns: Vec<Turn<R, READS, CONSTANTS, TARGETS>>,
) -> Vec<Turn<R, READS, CONSTANTS, TARGETS>> {
    let mut dealt: Vec<Turn<R, READS, CONSTANTS, TARGETS>> = Vec::with_capacity(turns.len());
    let mut waiting = VecDeque::from(turns);
    while !waiting.is_empty() {
        let (begin, mut most) = (dealt.len(), 1);
        while dealt.len() < begin + TURNS && !waiting.is_empty() {
            let moves =
                |target: usize, place: usize| dealt[begin..].iter().filter(|turn| turn.2[target] == place).count();
            let fits = |turn: &Turn<R, READS, CONSTANTS, TARGETS>| {
                turn.2.iter().enumerate().all(|(target, place)| moves(target, *place) < most)
            };
            match waiting.iter().take(NEAR).position(fits) {
                Some(next) => dealt.extend(waiting.remove(next)),
                None => most += 1,
            }
        }
    }
    dealt
}

/// The turns of a loop, or of loops inside each other: each reads so many coordinates, has so many constants, and moves
/// so many coordinates, by so many orders at once; `T` is what eight of them keep.
#[derive(Clone)]
pub struct Turns<R: Real, T, const READS: usize, const CONSTANTS: usize, const TARGETS: usize, const AT_ONCE: usize> {
    turns: Vec<Turn<R, READS, CONSTANTS, TARGETS>>,
    lines: Vec<Line<R, T, READS, CONSTANTS>>,
    found: Vec<Found<R, TARGETS, AT_ONCE>>,
    /// What positions and momenta get.
    addends: [Addends<R>; 2],
}

impl<R: Real, T, const READS: usize, const CONSTANTS: usize, const TARGETS: usize, const AT_ONCE: usize> Default
    for Turns<R, T, READS, CONSTANTS, TARGETS, AT_ONCE>
{
    fn default() -> Self {
        Self {
            turns: Vec::new(),
            lines: Vec::new(),
            found: Vec::new(),
            addends: [Addends::default(), Addends::default()],
        }
    }
}

impl<R: Real, T: Default, const READS: usize, const CONSTANTS: usize, const TARGETS: usize, const AT_ONCE: usize>
    Turns<R, T, READS, CONSTANTS, TARGETS, AT_ONCE>
{
    /// Whether the turns are not there yet.
    #[inline(always)]
    pub fn is_empty(&self) -> bool {
        self.lines.is_empty()
    }
    /// Another turn.
    pub fn take(&mut self, reads: [usize; READS], constants: [R; CONSTANTS], targets: [usize; TARGETS]) {
        self.turns.push((reads, constants, targets));
    }
    /// Lays the turns out in rows, for coordinates of such a width; targets are positions (0) or momenta (1).
    #[cold]
    #[inline(never)]
    pub fn lay_out(&mut self, width: usize, parts: [usize; TARGETS]) {
        let turns = dealt(core::mem::take(&mut self.turns));
        for turns in turns.chunks(TURNS) {
            // At the end, the last turn stands in for those that are not there.
            let turn = |place: usize| turns[place.min(turns.len() - 1)];
            self.lines.push(Line {
                kept: T::default(),
                constants: core::array::from_fn(|constant| {
                    let constants: [R; TURNS] = core::array::from_fn(|place| turn(place).1[constant]);
                    Abreast::<R>::read(&constants)
                }),
                reads: core::array::from_fn(|read| {
                    Places::of(core::array::from_fn(|place| turn(place).0[read]), width)
                }),
            });
            self.found.push([[Abreast::<R>::of(0.0); AT_ONCE]; TARGETS]);
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
    /// The rows of turns, and where each puts down what it has computed.
    #[inline(always)]
    pub fn rows(
        &mut self,
    ) -> impl Iterator<Item = (&mut Line<R, T, READS, CONSTANTS>, &mut Found<R, TARGETS, AT_ONCE>)> {
        self.lines.iter_mut().zip(&mut self.found)
    }
    /// Adds what all turns have computed to the coefficients of positions, of the orders from this one on.
    #[inline(always)]
    pub fn add_to_positions(&self, q: &mut Coefficients<'_, R>, order: usize) {
        self.addends[0].add(self.found.as_flattened(), q, order);
    }
    /// Adds what all turns have computed to the coefficients of momenta, of the orders from this one on.
    #[inline(always)]
    pub fn add_to_momenta(&self, p: &mut Coefficients<'_, R>, order: usize) {
        self.addends[1].add(self.found.as_flattened(), p, order);
    }
}

#[cfg(test)]
mod tests {
    use super::{
        super::table::{Layout, Table},
        *,
    };
    use crate::{
        fused::{Avx512, Fma, Fused},
        instruction_set::InstructionSet,
    };

    /// Numbers with so few digits that sums of products are exact, in whatever order.
    fn number(seed: usize) -> f64 {
        (seed * 7 % 31) as f64 / 8.0 - 2.0
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

    /// The sums are those of a loop.
    fn turns_are_those_of_a_loop<R: Real>() {
        for (name, width, list) in lists() {
            let mut turns: Turns<R, (), 2, 1, 3, 2> = Turns::default();
            assert!(turns.is_empty());
            for (seed, [i, j]) in list.iter().enumerate() {
                turns.take([*i, *j], [R::of(number(seed))], [*i, *j, *i]);
            }
            turns.lay_out(width, [1, 1, 0]);
            assert_eq!(turns.rows().count(), list.len().div_ceil(TURNS), "{name}");
            let layout = Layout::of::<Vec<f64>>(width);
            let (mut of_q, mut of_p) = (Table::new(layout), Table::new(layout));
            let (mut q, mut p) = (of_q.of(layout), of_p.of(layout));
            let from: Vec<R> = (0..width).map(|place| R::of(number(place + 100))).collect();
            for order in [3, 4] {
                q[order].copy_from_slice(&from);
                p[order].copy_from_slice(&from);
            }
            for (row, found) in turns.rows() {
                let [[a], [b]] = [row.read(0, [&from]), row.read(1, [&from])];
                let [constant] = row.constants;
                *found = [[a * b, b], [(a - b) * constant, a - b], [spread(R::of(2.0)) * a, a * a]];
            }
            turns.add_to_positions(&mut q, 3);
            turns.add_to_momenta(&mut p, 3);

            // What a turn that reads these places, with its constant, adds where.
            type Adds<'a, R> = &'a dyn Fn([usize; 2], R) -> (usize, R);
            let after = |addends: &[Adds<'_, R>]| {
                let mut to = from.clone();
                for addend in addends {
                    for (turn, places) in list.iter().enumerate() {
                        let (place, value) = addend(*places, R::of(number(turn)));
                        to[place] += value;
                    }
                }
                to
            };
            let x = |i: usize| from[i];
            let expected = [
                after(&[&|[i, _], _| (i, R::of(2.0) * x(i))]),
                after(&[&|[i, _], _| (i, x(i) * x(i))]),
                after(&[&|[i, j], _| (i, x(i) * x(j)), &|[i, j], constant| (j, (x(i) - x(j)) * constant)]),
                after(&[&|[i, j], _| (i, x(j)), &|[i, j], _| (j, x(i) - x(j))]),
            ];
            let bits = |numbers: &[R]| -> Vec<u64> { numbers.iter().map(|x| x.lane(0).to_bits()).collect() };
            for (found, expected) in [&q[3], &q[4], &p[3], &p[4]].into_iter().zip(&expected) {
                assert_eq!(bits(found), bits(expected), "{name}");
            }
        }
    }

    #[test]
    fn turns_side_by_side_have_the_sums_of_a_loop() {
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
    fn turns_of_a_row_seldom_move_the_same_coordinate() {
        let turns =
            |list: Vec<[usize; 2]>| list.into_iter().map(|places| (places, [0.0; 0], places)).collect::<Vec<_>>();
        for (name, _, list) in lists() {
            let all = turns(list.clone());
            let mut dealt = dealt::<f64, 2, 0, 2>(all.clone());
            let rounds = |turns: &[Turn<f64, 2, 0, 2>]| -> usize {
                let of_row = |row: &[Turn<f64, 2, 0, 2>], target: usize| {
                    let same = |place| row.iter().filter(|turn| turn.2[target] == place).count();
                    row.iter().map(|turn| same(turn.2[target])).max().unwrap_or_default()
                };
                turns.chunks(TURNS).map(|row| of_row(row, 0) + of_row(row, 1)).sum()
            };
            assert!(rounds(&dealt) <= rounds(&all), "{name}");
            if name == "pairs of six" {
                assert_eq!((rounds(&all), rounds(&dealt)), (14, 11));
            }
            dealt.sort_by_key(|turn| list.iter().position(|places| *places == turn.0));
            assert_eq!(dealt, all, "{name}");
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
