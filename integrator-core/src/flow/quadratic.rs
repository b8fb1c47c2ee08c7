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
    system::motion::Solver,
};
use alloc::{vec, vec::Vec};
use durations::{Durations, Known};
pub use form::Form;
use form::{Group, groups};

/// Prepared constants that a part of H which is a quadratic form has its coefficients from.
pub trait QuadraticPart<const PART: usize> {
    /// How many components a point has.
    fn components(_parameters: &Self) -> usize {
        1
    }
    /// Adds the derivatives of the part; positions are so many numbers or points.
    fn derivatives(parameters: &Self, length: usize, form: &mut Form);
}

/// The matrices of a part that is a quadratic form, for every duration that it was asked for so far.
#[derive(Clone)]
pub struct Quadratic<R, const PART: usize> {
    groups: Vec<Group>,
    /// How many degrees of freedom move by one matrix, where that is the only one.
    alike: usize,
    durations: Durations,
    /// The matrices of one duration after the other, each in the order of the groups.
    matrices: Vec<R>,
    /// How many numbers the matrices of one duration are.
    width: usize,
    /// The coordinates of a large block, and what is added to them.
    scratch: Vec<R>,
}

impl<R: Real, P: QuadraticPart<PART>, const PART: usize> Solver<P> for Quadratic<R, PART> {
    fn of(constants: &[&P], length: usize) -> Self {
        let form = |parameters: &&P| {
            let mut form = Form::new(P::components(parameters));
            P::derivatives(parameters, length, &mut form);
            form
        };
        Self::of_forms(&constants.iter().map(form).collect::<Vec<_>>())
    }
}

impl<R: Real, const PART: usize> Default for Quadratic<R, PART> {
    fn default() -> Self {
        Self::of_forms(&[])
    }
}

impl<R: Real, const PART: usize> Quadratic<R, PART> {
    /// The flow of one form per lane.
    fn of_forms(forms: &[Form]) -> Self {
        let groups = groups(forms);
        let width = groups.iter().map(Group::width).sum();
        let largest = groups.iter().map(|group| group.size).max().unwrap_or(0);
        let alike = match &groups[..] {
            [only] if only.size == 1 && !only.is_affine => only.places.len(),
            _ => 0,
        };
        let (durations, scratch) = (Durations::default(), vec![R::of(0.0); 6 * largest]);
        Self { groups, alike, durations, matrices: Vec::new(), width, scratch }
    }

    /// Moves positions and momenta for a time `duration`.
    #[inline(always)]
    pub fn flow<C: Coords>(&mut self, duration: f64, q: &mut C::Slots<R>, p: &mut C::Slots<R>) {
        let number = match self.durations.next(duration) {
            Some(number) => number,
            None => self.turn(duration),
        };
        let mut matrices = &self.matrices[number * self.width..][..self.width];
        let (q, p) = (C::slots_mut(q), C::slots_mut(p));
        if self.alike == q.len() {
            let matrix = Matrix::<R, 2>::of(matrices);
            for (q, p) in q.iter_mut().zip(p) {
                matrix.apply::<C::Leaf>([q, p]);
            }
            return;
        }
        for group in &self.groups {
            let (own, others) = matrices.split_at(group.width());
            matrices = others;
            match group.size {
                1 => group.lone::<R, C::Leaf>(own, q, p),
                2 => group.pairs::<R, C::Leaf>(own, q, p),
                _ => group.large::<R, C::Leaf>(own, q, p, &mut self.scratch),
            }
        }
    }

    /// The number of a duration that was not expected, whose matrices are computed if it is a new one.
    #[cold]
    #[inline(never)]
    fn turn(&mut self, duration: f64) -> usize {
        let (number, known) = self.durations.turn(duration);
        if known == Known::Anew {
            self.matrices.clear();
        }
        if known != Known::Before {
            for group in &self.groups {
                group.compute(duration, &mut self.matrices);
            }
        }
        number
    }
}

impl Group {
    /// How many columns a matrix has: one for each coordinate, and one for what is added everywhere.
    #[inline(always)]
    fn columns(&self) -> usize {
        2 * self.size + usize::from(self.is_affine)
    }

    /// How many numbers its matrix is: two for each entry.
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
                    high[row] = of_high[row].fma(*z, high[row]);
                    low[row] = of_low[row].fma(*z, low[row]);
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
                    high[row] = self.high[column][row] * z;
                    low[row] = self.low[column][row] * z;
                } else {
                    high[row] = self.high[column][row].fma(z, high[row]);
                    low[row] = self.low[column][row].fma(z, low[row]);
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
