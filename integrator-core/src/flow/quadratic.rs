//! The exact flow of a quadratic form in positions and momenta, whose coefficients depend on parameters alone.
//!
//! `z -> z + (exp(h J S) - I) z + c`, block by block of what couples. Matrices are computed in double-double at the first
//! use of a duration, and kept in two parts each: a rounded rotation would grow or shrink orbits by about its rounding in
//! each step, always in the same direction; with two parts only the roundings of the state are left, which walk. The
//! first part is short, half of the digits: what the second one adds is then far above a rounding of what the first
//! one adds. A second part of the last digits alone would be lost in most additions to a number that is rounded already.

mod durations;
mod form;
#[cfg(test)]
mod tests;

use crate::{
    scalar::real::Real,
    state::{
        coords::Coords,
        precision::{Precision, Slot},
    },
    system::motion::{InRegisters, Solver},
};
use alloc::{boxed::Box, vec, vec::Vec};
use durations::{Durations, Known};
pub use form::Form;
use form::{Group, groups};

/// Prepared constants that a part of H which is a quadratic form has its coefficients from.
pub trait QuadraticPart<const PART: usize> {
    /// Returns the number of components of a point.
    fn components(_parameters: &Self) -> usize {
        1
    }
    /// Adds the derivatives of the part; positions are this number of numbers or points.
    fn derivatives(parameters: &Self, length: usize, form: &mut Form);
}

/// The matrices of a part that is a quadratic form, for every duration used so far. Where no degree of
/// freedom couples to another one, whatever the parameters are, and nothing is linear, it is `LONE`.
///
/// Behind a pointer, so that coordinates stay in registers in the loop over stages. By default there are no matrices, and
/// the flow does not move the state.
#[derive(Clone)]
pub struct Quadratic<R, const PART: usize, const LONE: bool>(Option<Box<Matrices<R>>>);

#[derive(Clone)]
struct Matrices<R> {
    groups: Vec<Group>,
    /// The number of degrees of freedom that move by one matrix, where that is the only one.
    alike: usize,
    durations: Durations,
    /// The matrices of one duration after the other: each in the order of the groups, or of single degrees of freedom.
    numbers: Vec<R>,
    /// The number of entries of the matrices of one duration.
    width: usize,
    /// The coordinates of a large block, and what is added to them.
    scratch: Vec<R>,
}

impl<R: Real, P: QuadraticPart<PART>, const PART: usize, const LONE: bool> Solver<P> for Quadratic<R, PART, LONE> {
    /// By measurement, two oscillators and a rest, ns per stage in memory and in registers: 16 and 6 where a stage begins with
    /// a kick, which stores two numbers of four that are then loaded together, and 7.6 and 10 where it begins with a
    /// drift, as the call for a new duration is prepared for at each stage. With a deviation vector these are 16 and 12, since
    /// its numbers are stored one by one, too.
    const IN_REGISTERS: InRegisters = if R::LANES == R::MEMBERS { InRegisters::Kicked } else { InRegisters::Always };

    fn of(constants: &[&P], length: usize) -> Self {
        let form = |parameters: &&P| {
            let mut form = Form::new(P::components(parameters));
            P::derivatives(parameters, length, &mut form);
            form
        };
        let (forms, components) =
            (constants.iter().map(form), constants.first().map_or(1, |first| P::components(first)));
        Self::of_forms(&forms.collect::<Vec<_>>(), length * components)
    }
}

impl<R: Real, const PART: usize, const LONE: bool> Default for Quadratic<R, PART, LONE> {
    fn default() -> Self {
        Self(None)
    }
}

impl<R: Real, const PART: usize, const LONE: bool> Quadratic<R, PART, LONE> {
    /// The flow of one form per lane of this number of degrees of freedom.
    fn of_forms(forms: &[Form], degrees: usize) -> Self {
        let groups = groups(forms);
        let alike = match &groups[..] {
            [only] if only.size == 1 && !only.is_affine => only.places.len(),
            _ => 0,
        };
        let width = match LONE {
            true if alike == degrees => LONE_WIDTH,
            true => LONE_WIDTH * degrees,
            false => groups.iter().map(Group::width).sum(),
        };
        let largest = groups.iter().map(|group| group.size).max().unwrap_or(0);
        let (durations, scratch) = (Durations::default(), vec![R::of(0.0); 6 * largest]);
        Self(Some(Box::new(Matrices { groups, alike, durations, numbers: Vec::new(), width, scratch })))
    }

    /// Moves positions and momenta for a time `duration`.
    #[inline(always)]
    pub fn flow<C: Coords>(&mut self, duration: f64, q: &mut C::Slots<R>, p: &mut C::Slots<R>) {
        let Some(known) = self.0.as_deref_mut() else { return };
        let number = match known.durations.next(duration) {
            Some(number) => number,
            None => turn::<R, LONE>(known, duration),
        };
        let (q, p) = (C::slots_mut(q), C::slots_mut(p));
        let all_alike = known.alike == q.len();
        if LONE && all_alike {
            // Nothing here can panic: what could would have to find the coordinates in memory.
            if let Some(matrix) = known.numbers.as_chunks::<LONE_WIDTH>().0.get(number) {
                every::<R, C::Leaf>(matrix, q, p);
            }
        } else if LONE {
            let matrices = known.numbers.as_chunks::<LONE_WIDTH>().0.iter().skip(number * q.len());
            for ((q, p), matrix) in q.iter_mut().zip(p).zip(matrices) {
                Matrix::<R, 2>::of(matrix).apply::<C::Leaf>([q, p]);
            }
        } else {
            known.flow::<C::Leaf>(number, q, p);
        }
    }
}

/// Number of entries of the matrix of one degree of freedom.
const LONE_WIDTH: usize = 8;

/// All degrees of freedom by one matrix.
#[inline(always)]
fn every<R: Real, K: Precision>(matrix: &[R], q: &mut [K::Slot<R>], p: &mut [K::Slot<R>]) {
    let matrix = Matrix::<R, 2>::of(matrix);
    for (q, p) in q.iter_mut().zip(p) {
        matrix.apply::<K>([q, p]);
    }
}

/// The number of a duration that was not expected, whose matrices are computed if it is a new one.
///
/// By the calling convention of C because it does not unwind: coordinates could not stay in registers around it.
#[cold]
#[inline(never)]
#[allow(improper_ctypes_definitions, reason = "called from here alone")]
extern "C" fn turn<R: Real, const LONE: bool>(known: &mut Matrices<R>, duration: f64) -> usize {
    known.turn::<LONE>(duration)
}

impl<R: Real> Matrices<R> {
    /// Moves every block.
    #[inline(always)]
    fn flow<K: Precision>(&mut self, number: usize, q: &mut [K::Slot<R>], p: &mut [K::Slot<R>]) {
        let mut matrices = &self.numbers[number * self.width..][..self.width];
        if self.alike == q.len() {
            return every::<R, K>(matrices, q, p);
        }
        for group in &self.groups {
            let (own, others) = matrices.split_at(group.width());
            matrices = others;
            match group.size {
                1 => group.lone::<R, K>(own, q, p),
                2 => group.pairs::<R, K>(own, q, p),
                _ => group.large::<R, K>(own, q, p, &mut self.scratch),
            }
        }
    }

    fn turn<const LONE: bool>(&mut self, duration: f64) -> usize {
        let (number, known) = self.durations.turn(duration);
        if known == Known::Anew {
            self.numbers.clear();
        }
        if known == Known::Before {
            return number;
        }
        let start = self.numbers.len();
        for group in &self.groups {
            if LONE && self.width > LONE_WIDTH {
                let mut matrix = Vec::new();
                group.compute(duration, &mut matrix);
                self.numbers.resize(start + self.width, R::of(0.0));
                for place in &group.places {
                    self.numbers[start + LONE_WIDTH * place..][..LONE_WIDTH].copy_from_slice(&matrix);
                }
            } else {
                group.compute(duration, &mut self.numbers);
            }
        }
        number
    }
}

impl Group {
    /// Returns the number of columns of a matrix: one for each coordinate, and one for the constant increments.
    #[inline(always)]
    fn columns(&self) -> usize {
        2 * self.size + usize::from(self.is_affine)
    }

    /// Returns the number of stored numbers of a matrix: two for each entry.
    #[inline(always)]
    fn width(&self) -> usize {
        4 * self.size * self.columns()
    }

    /// Appends its matrix for a duration, column by column: first of each column the upper halves of the entries, then
    /// what is left of them.
    fn compute<R: Real>(&self, duration: f64, matrices: &mut Vec<R>) {
        let mut of_lanes: Vec<Vec<[f64; 2]>> = Vec::with_capacity(self.of_members.len());
        for (lane, form) in self.of_members.iter().enumerate() {
            let known = self.of_members[..lane].iter().position(|known| known == form);
            of_lanes.push(match known {
                Some(known) => of_lanes[known].clone(),
                None => form.increments(duration).into_iter().map(|entry| [entry.lane(0), entry.lane(1)]).collect(),
            });
        }
        let rows = 2 * self.size;
        for column in 0..self.columns() {
            let entry = |row: usize, lane: usize| of_lanes[lane][row * (rows + 1) + column];
            let upper = |row: usize, lane: usize| upper_half::<R>(entry(row, lane)[0]);
            matrices.extend((0..rows).map(|row| R::parameter(&|lane| upper(row, lane))));
            let left = |row: usize, lane: usize| (entry(row, lane)[0] - upper(row, lane)) + entry(row, lane)[1];
            matrices.extend((0..rows).map(|row| R::parameter(&|lane| left(row, lane))));
        }
    }

    /// Blocks of one degree of freedom.
    #[inline(always)]
    fn lone<R: Real, K: Precision>(&self, matrix: &[R], q: &mut [K::Slot<R>], p: &mut [K::Slot<R>]) {
        let matrix = Matrix::<R, 2>::of(matrix);
        for place in &self.places {
            matrix.apply::<K>([&mut q[*place], &mut p[*place]]);
        }
    }

    /// Blocks of two degrees of freedom.
    #[inline(always)]
    fn pairs<R: Real, K: Precision>(&self, matrix: &[R], q: &mut [K::Slot<R>], p: &mut [K::Slot<R>]) {
        let matrix = Matrix::<R, 4>::of(matrix);
        for places in self.places.as_chunks::<2>().0 {
            let ([q0, q1], [p0, p1]) = (two(q, *places), two(p, *places));
            matrix.apply::<K>([q0, q1, p0, p1]);
        }
    }

    /// Blocks of any number of degrees of freedom.
    #[inline(always)]
    fn large<R: Real, K: Precision>(
        &self,
        matrix: &[R],
        q: &mut [K::Slot<R>],
        p: &mut [K::Slot<R>],
        scratch: &mut [R],
    ) {
        let (rows, size) = (2 * self.size, self.size);
        let (z, sums) = scratch[..3 * rows].split_at_mut(rows);
        let (high, low) = sums.split_at_mut(rows);
        for places in self.places.chunks_exact(size) {
            for (k, place) in places.iter().enumerate() {
                z[k] = q[*place].value();
                z[size + k] = p[*place].value();
            }
            high.fill(R::of(0.0));
            low.fill(R::of(0.0));
            for (column, z) in matrix.chunks_exact(2 * rows).zip(&*z) {
                let (of_high, of_low) = column.split_at(rows);
                for row in 0..rows {
                    high[row] = of_high[row].scale_add(*z, high[row]);
                    low[row] = of_low[row].scale_add(*z, low[row]);
                }
            }
            if let Some(everywhere) = matrix.get(2 * rows * rows..).filter(|column| !column.is_empty()) {
                let (of_high, of_low) = everywhere.split_at(rows);
                for row in 0..rows {
                    high[row] += of_high[row];
                    low[row] += of_low[row];
                }
            }
            for (k, place) in places.iter().enumerate() {
                q[*place].add(high[k] + low[k]);
                p[*place].add(high[size + k] + low[size + k]);
            }
        }
    }
}

/// A matrix of a known size, to be held in registers, with what it adds everywhere.
struct Matrix<R, const W: usize> {
    high: [[R; W]; W],
    low: [[R; W]; W],
    everywhere: Option<[[R; W]; 2]>,
}

impl<R: Real, const W: usize> Matrix<R, W> {
    #[inline(always)]
    fn of(numbers: &[R]) -> Self {
        let zero = [[R::of(0.0); W]; W];
        let (mut high, mut low) = (zero, zero);
        let columns = numbers.as_chunks::<W>().0;
        for column in 0..W {
            high[column] = columns[2 * column];
            low[column] = columns[2 * column + 1];
        }
        let everywhere = (columns.len() > 2 * W).then(|| [columns[2 * W], columns[2 * W + 1]]);
        Self { high, low, everywhere }
    }

    /// Moves the coordinates of a block: positions first, then momenta.
    #[inline(always)]
    fn apply<K: Precision>(&self, slots: [&mut K::Slot<R>; W]) {
        let (mut high, mut low) = ([R::of(0.0); W], [R::of(0.0); W]);
        for (column, slot) in slots.iter().enumerate() {
            let z = slot.value();
            for row in 0..W {
                if column == 0 {
                    high[row] = self.high[column][row].scale(z);
                    low[row] = self.low[column][row].scale(z);
                } else {
                    high[row] = self.high[column][row].scale_add(z, high[row]);
                    low[row] = self.low[column][row].scale_add(z, low[row]);
                }
            }
        }
        if let Some([of_high, of_low]) = self.everywhere {
            for row in 0..W {
                high[row] += of_high[row];
                low[row] += of_low[row];
            }
        }
        for (row, slot) in slots.into_iter().enumerate() {
            slot.add(high[row] + low[row]);
        }
    }
}

/// A number without the lower half of the digits that a scalar has.
fn upper_half<R: Real>(x: f64) -> f64 {
    let is_double = R::of(1.0 + f64::from(f32::EPSILON) / 4.0).lane(0) != 1.0;
    f64::from_bits(x.to_bits() & (!0 << if is_double { 27 } else { 41 }))
}

/// Two slots of different places, the first one before the other.
#[inline(always)]
fn two<S>(slots: &mut [S], [first, second]: [usize; 2]) -> [&mut S; 2] {
    let (before, from) = slots.split_at_mut(second);
    [&mut before[first], &mut from[0]]
}
