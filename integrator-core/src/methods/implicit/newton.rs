//! The equation of an implicit step by Newton's iteration with the Hessian of the generated code: for steps that are long
//! compared with the fastest motion.
//!
//! In plain numbers, with the field as a function of these: it is seldom needed, and compiled with this crate instead of with each
//! system and method.

use crate::{
    error::Unsolved,
    scalar::tolerance::{largest, ratio},
};
use alloc::vec::Vec;
use core::ops::Range;
use nalgebra::{DMatrix, DVector};

/// The largest number of iterations. Newton's iteration doubles the digits with each, so that a handful reaches the
/// rounding from wherever it converges.
const ITERATIONS: u32 = 32;

/// The update at which the iteration has reached the rounding, in ε of the largest coordinate of its kind.
const SETTLED: f64 = 4.0;

/// An update that no longer shrinks is rounding too if it is as small as this, in ε: the equation is then worse
/// conditioned than the state is precise.
const STALLED: f64 = 1e6;

/// Positions and momenta, or the field there, of a member and of its deviation vectors: a list for each, the member first.
pub(super) type Lists = Vec<Vec<f64>>;

/// The equation of a step of one member.
pub(super) struct Equation<'m> {
    /// The beginning of the step.
    pub(super) y: Lists,
    pub(super) time: f64,
    pub(super) h: f64,
    /// The spacing of numbers just above one in the precision of the state.
    pub(super) epsilon: f64,
    /// The coefficients `a` of the method, row by row, and its nodes.
    pub(super) a: Vec<Vec<f64>>,
    pub(super) nodes: &'m [f64],
    /// The field at a place and a time.
    pub(super) field: &'m dyn Fn(&[Vec<f64>], f64) -> Lists,
    /// Its derivatives for the member alone.
    pub(super) jacobian: &'m dyn Fn(&[f64], f64) -> DMatrix<f64>,
}

impl Equation<'_> {
    /// Returns the field at the stages, or why there is none, and adds the number of evaluations.
    pub(super) fn solve(&self, evaluations: &mut u64) -> Result<Vec<Lists>, Unsolved> {
        self.iterate(evaluations).map_err(|update| {
            let contraction = self.contraction();
            Unsolved::Newton { h: self.h, contraction, iterations: ITERATIONS, update }
        })
    }

    /// Returns the field at the stages, or the size of the last update if the iteration does not converge.
    fn iterate(&self, evaluations: &mut u64) -> Result<Vec<Lists>, f64> {
        let Self { y, time, h, epsilon, .. } = self;
        let (stages, lists, size) = (self.nodes.len(), y.len(), y[0].len());
        let start = (self.field)(y, *time);
        let place = |node: f64| -> Lists {
            (0..lists).map(|list| (0..size).map(|k| y[list][k] + node * h * start[list][k]).collect()).collect()
        };
        let mut places: Vec<Lists> = self.nodes.iter().map(|node| place(*node)).collect();
        let fields = |places: &[Lists]| -> Vec<Lists> {
            places.iter().zip(self.nodes).map(|(place, node)| (self.field)(place, time + node * h)).collect()
        };
        let mut update = f64::INFINITY;
        for _ in 0..ITERATIONS {
            let slopes = fields(&places);
            let residual = |list: usize, row: usize| {
                let (i, k) = (row / size, row % size);
                let terms = slopes.iter().zip(&self.a[i]).map(|(slopes, a)| a * h * slopes[list][k]);
                terms.fold(places[i][list][k] - y[list][k], |residual, term| residual - term)
            };
            let residuals: Lists =
                (0..lists).map(|list| (0..stages * size).map(|row| residual(list, row)).collect()).collect();
            let jacobians =
                places.iter().zip(self.nodes).map(|(place, node)| (self.jacobian)(&place[0], time + node * h));
            let jacobians: Vec<_> = jacobians.collect();
            *evaluations += (stages * (1 + size)) as u64;
            // A matrix that is singular, or no number, leads nowhere: the last update says how far the iteration was.
            let updates = self.updates(&jacobians, &residuals).ok_or(update)?;
            let mut relative = 0.0;
            for (stage, place) in places.iter_mut().enumerate() {
                for (list, place) in place.iter_mut().enumerate() {
                    let moved = &updates[list].as_slice()[stage * size..][..size];
                    place.iter_mut().zip(moved).for_each(|(place, moved)| *place -= moved);
                    relative = largest([relative, moved_by(moved, place, &y[list])]);
                }
            }
            let stalled = relative >= update / 2.0 && relative <= STALLED * epsilon;
            if relative <= SETTLED * epsilon || stalled {
                return Ok(fields(&places));
            }
            update = relative;
        }
        Err(update)
    }

    /// The factor by which an iteration to the fixed point multiplies an error, with the derivatives at the beginning of the
    /// step: `|h|` times the spectral radii of the coefficients and of these derivatives.
    fn contraction(&self) -> f64 {
        let stages = self.nodes.len();
        let coefficients = DMatrix::from_fn(stages, stages, |i, j| self.a[i][j]);
        self.h.abs() * spectral_radius(&coefficients) * spectral_radius(&(self.jacobian)(&self.y[0], self.time))
    }

    /// Returns the update of Newton's iteration for each list of residuals, by the Jacobians at the stages; `None` where the matrix
    /// is singular.
    fn updates(&self, jacobians: &[DMatrix<f64>], residuals: &[Vec<f64>]) -> Option<Vec<DVector<f64>>> {
        let size = jacobians.first().map_or(0, DMatrix::nrows);
        let rows = jacobians.len() * size;
        let mut matrix = DMatrix::identity(rows, rows);
        for (j, jacobian) in jacobians.iter().enumerate() {
            for (i, row) in self.a.iter().enumerate() {
                let mut block = matrix.view_mut((i * size, j * size), (size, size));
                block -= jacobian * (row[j] * self.h);
            }
        }
        let factors = matrix.lu();
        residuals.iter().map(|residual| factors.solve(&DVector::from_column_slice(residual))).collect()
    }
}

/// The largest update of positions, and of momenta, in units of these at the stage and at the beginning: where the end is zero,
/// the beginning shows the size of the rounding, since they differ by what rounds.
fn moved_by(moved: &[f64], stage: &[f64], beginning: &[f64]) -> f64 {
    let half = moved.len() / 2;
    let of = |range: Range<usize>| {
        let size = largest(stage[range.clone()].iter().chain(&beginning[range.clone()]).copied());
        ratio(largest(moved[range].iter().copied()), size)
    };
    largest([of(0..half), of(half..moved.len())])
}

/// The largest absolute value of an eigenvalue, approximately: the mean growth of a vector in repeated products with a matrix. An even
/// number of products has the growth of a pair of conjugate eigenvalues, whatever the units of the coordinates are.
fn spectral_radius(matrix: &DMatrix<f64>) -> f64 {
    const PRODUCTS: i32 = 32;
    let mut vector = DVector::from_fn(matrix.nrows(), |row, _| 1.0 / (1.0 + row as f64));
    let mut growth = 0.0;
    for product in -PRODUCTS..PRODUCTS {
        let next = matrix * &vector;
        let factor = next.norm() / vector.norm();
        if factor == 0.0 {
            return 0.0;
        }
        vector = next / factor;
        growth += if product < 0 { 0.0 } else { factor.ln() };
    }
    (growth / f64::from(PRODUCTS)).exp()
}

/// A matrix whose columns are the derivatives along each coordinate.
pub(super) fn by_columns(size: usize, column: &dyn Fn(usize) -> Vec<f64>) -> DMatrix<f64> {
    DMatrix::from_vec(size, size, (0..size).flat_map(column).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_spectral_radius_does_not_depend_on_units() {
        for (rows, radius) in [
            // An oscillator with a mass of 1e6 and a frequency of 3e-3, a free body, and a saddle.
            ([0.0, 1e-6, -9.0, 0.0], 3e-3),
            ([0.0, 1.0, 0.0, 0.0], 0.0),
            ([-3.0, 0.0, 0.0, 1.0], 3.0),
        ] {
            let found = spectral_radius(&DMatrix::from_row_slice(2, 2, &rows));
            // Before growth is measured, what else is in the vector has shrunk by 3^32 = 2e15 compared with the largest.
            assert!((found - radius).abs() <= 1e-14 * radius, "{found} and not {radius}");
        }
        assert!(spectral_radius(&DMatrix::from_element(2, 2, f64::NAN)).is_nan());
    }
}
