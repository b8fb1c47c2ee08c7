//! Exponentials of small matrices in double-double, by scaling and squaring.
//!
//! In: a square matrix, row by row. Out: `exp(A) - I`, right to about 2^-100 of its norm for each squaring less one bit.
//! Always true: no eigenvalue is computed, so Jordan blocks need no special case; what is not finite comes out as
//! not a number.

use crate::scalar::{
    double_double::DoubleDouble,
    real::{Kernel, Real},
};
use alloc::{vec, vec::Vec};

/// The number of terms of the series: with the norm below [`REACH`], the rest is below 0.25²⁴/24! < 2^-126.
const TERMS: usize = 24;

/// The norm that a matrix is scaled down to.
const REACH: f64 = 0.25;

/// `exp(A) - I` of a matrix of this number of rows.
pub(crate) fn exponential_less_one(size: usize, matrix: Vec<DoubleDouble>) -> Vec<DoubleDouble> {
    DoubleDouble::enter(Exponential(Square { size, entries: matrix })).entries
}

struct Exponential(Square);

impl Kernel for Exponential {
    type Out = Square;

    #[inline(always)]
    fn call(self) -> Square {
        let Self(mut matrix) = self;
        if !matrix.entries.iter().all(|entry| entry.finite()) {
            matrix.entries.fill(DoubleDouble::of(f64::NAN));
            return matrix;
        }
        let scales = matrix.balance();
        let squarings = matrix.scale_down();
        let mut power = matrix.series();
        for _ in 0..squarings {
            power.square();
        }
        power.unbalance(&scales);
        power
    }
}

struct Square {
    size: usize,
    entries: Vec<DoubleDouble>,
}

impl Square {
    /// `A + A²/2 + A³/6 + ...`, from the innermost bracket of `A (I + A/2 (I + A/3 (...)))`.
    #[inline(always)]
    fn series(&self) -> Self {
        let mut sum = Self { size: self.size, entries: vec![DoubleDouble::of(0.0); self.entries.len()] };
        for order in (1..=TERMS).rev() {
            let mut product = self.times(&sum);
            for (to, own) in product.entries.iter_mut().zip(&self.entries) {
                *to = (*to + *own) / DoubleDouble::of(order as f64);
            }
            sum = product;
        }
        sum
    }

    /// From `exp(A) - I` to `exp(2A) - I`, where nothing cancels that is near to the unit matrix.
    #[inline(always)]
    fn square(&mut self) {
        let product = self.times(self);
        for (to, square) in self.entries.iter_mut().zip(product.entries) {
            *to = (*to + *to) + square;
        }
    }

    #[inline(always)]
    fn times(&self, other: &Self) -> Self {
        let size = self.size;
        let mut entries = vec![DoubleDouble::of(0.0); size * size];
        for (row, to) in self.entries.chunks_exact(size).zip(entries.chunks_exact_mut(size)) {
            for (factor, from) in row.iter().zip(other.entries.chunks_exact(size)) {
                if factor.equal(DoubleDouble::of(0.0)) {
                    continue;
                }
                for (to, from) in to.iter_mut().zip(from) {
                    *to += *factor * *from;
                }
            }
        }
        Self { size, entries }
    }

    /// Halves it until its norm is small; returns how often.
    #[inline(always)]
    fn scale_down(&mut self) -> u32 {
        let of_row = |row: &[DoubleDouble]| row.iter().fold(0.0, |sum, entry| sum + Real::abs(*entry).lane(0));
        let mut norm = self.entries.chunks_exact(self.size).map(of_row).fold(0.0, f64::max);
        let (mut halvings, mut scale) = (0, 1.0);
        // The norm of a matrix of finite numbers may be infinite: half of the range is left for the sum.
        norm = norm.min(f64::MAX);
        while norm > REACH {
            norm *= 0.5;
            scale *= 0.5;
            halvings += 1;
        }
        for entry in &mut self.entries {
            *entry = *entry * DoubleDouble::of(scale);
        }
        halvings
    }

    /// Makes rows and columns of one index about as large as each other, by units for the coordinates that are powers
    /// of two and so exact (Parlett and Reinsch 1969). Returns these units.
    #[inline(always)]
    fn balance(&mut self) -> Vec<f64> {
        let size = self.size;
        let mut units = vec![1.0; size];
        // It ends by itself, after a few rounds.
        for _ in 0..64 {
            let mut is_balanced = true;
            for (index, unit) in units.iter_mut().enumerate() {
                let (mut column, mut row) = (0.0, 0.0);
                for other in (0..size).filter(|other| *other != index) {
                    column += Real::abs(self.entries[other * size + index]).lane(0);
                    row += Real::abs(self.entries[index * size + other]).lane(0);
                }
                let factor = factor_between(column, row);
                if factor == 1.0 {
                    continue;
                }
                is_balanced = false;
                *unit *= factor;
                let [by, back] = [factor, 1.0 / factor].map(DoubleDouble::of);
                for other in 0..size {
                    self.entries[other * size + index] = self.entries[other * size + index] * by;
                    self.entries[index * size + other] = self.entries[index * size + other] * back;
                }
            }
            if is_balanced {
                break;
            }
        }
        units
    }

    /// Converts the matrix back to its original units.
    #[inline(always)]
    fn unbalance(&mut self, units: &[f64]) {
        for (row, of_row) in self.entries.chunks_exact_mut(self.size).zip(units) {
            for (entry, of_column) in row.iter_mut().zip(units) {
                *entry = *entry * DoubleDouble::of(*of_row) * DoubleDouble::of(1.0 / of_column);
            }
        }
    }
}

/// The power of two that brings the norms of a column and a row together, or one where this gains little.
fn factor_between(column: f64, row: f64) -> f64 {
    let is_usual = |norm: f64| norm > 0.0 && norm.is_finite();
    if !is_usual(column) || !is_usual(row) {
        return 1.0;
    }
    let (mut factor, mut scaled) = (1.0, column);
    while scaled < row * 0.5 {
        factor *= 2.0;
        scaled *= 4.0;
    }
    while scaled > row * 2.0 {
        factor *= 0.5;
        scaled *= 0.25;
    }
    if column * factor + row / factor < 0.95 * (column + row) { factor } else { 1.0 }
}
