//! The trait of a system in the corpus.

use integrator_core::{Coords, prelude::*};
use num_dual::DualNum;

/// A system of the corpus.
pub(crate) trait Member: Hamiltonian<Coords: Filled> {
    /// A step that resolves the motion from the first point of the reference.
    const STEP: f64;
    /// Why every certification fails, if the potential is not smooth enough for any order.
    const ROUGH: Option<&'static str> = None;

    /// Returns the system with the parameters of the reference.
    fn example() -> Self;
    /// Returns `T` and `V` from the user's own functions.
    fn energies(&self, at: &Phase<Self::Coords>, time: f64) -> [f64; 2];
    /// Computes `T` by a second formula, for dual numbers and flat coordinates.
    fn kinetic_formula<D: Number>(&self, p: &[D], time: f64) -> D;
    /// Computes `V` by a second formula, for dual numbers and flat coordinates.
    fn potential_formula<D: Number>(&self, q: &[D], time: f64) -> D;
}

/// Number type of the formulas.
pub(crate) trait Number: DualNum<Primitive = f64> + Copy {}

impl<D: DualNum<Primitive = f64> + Copy> Number for D {}

/// Coordinates that can be created from flat numbers.
pub(crate) trait Filled: Coords<Leaf = f64> {
    fn filled(numbers: &[f64]) -> Self;
}

impl<const N: usize> Filled for [f64; N] {
    fn filled(numbers: &[f64]) -> Self {
        numbers.try_into().expect("as many numbers as coordinates")
    }
}

impl<const D: usize, const N: usize> Filled for [[f64; D]; N] {
    fn filled(numbers: &[f64]) -> Self {
        points(numbers).try_into().expect("as many points as coordinates")
    }
}

impl Filled for Vec<f64> {
    fn filled(numbers: &[f64]) -> Self {
        numbers.to_vec()
    }
}

impl<const D: usize> Filled for Vec<[f64; D]> {
    fn filled(numbers: &[f64]) -> Self {
        points(numbers)
    }
}

/// Groups flat coordinates into points.
pub(crate) fn points<T: Copy, const D: usize>(numbers: &[T]) -> Vec<[T; D]> {
    let (points, rest) = numbers.as_chunks();
    assert!(rest.is_empty(), "whole points");
    points.to_vec()
}

/// Returns the squared distances of all pairs of points.
pub(crate) fn pairs<T: Number, const D: usize>(numbers: &[T]) -> Vec<T> {
    let q = points::<T, D>(numbers);
    let indices = (0..q.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
    indices.map(|(i, j)| (0..D).map(|d| (q[i][d] - q[j][d]).powi(2)).sum()).collect()
}
