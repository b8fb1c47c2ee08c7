//! Eigenvalues of an operator that is known by what it does to vectors.
//!
//! In: such an operator. Out: approximations of its eigenvalues, the outermost ones first to be accurate. Always true:
//! in few dimensions all distinct eigenvalues, up to rounding.

use super::GOLDEN;
use nalgebra::{Complex, DMatrix, DVector, Schur};

/// The dimension of the largest subspace. The outermost eigenvalues of a chain, the most crowded ones of all systems
/// with springs between neighbours, come out within (π/24)²/2, a hundredth, of the widest spread.
const SUBSPACE: usize = 24;

/// The largest number of sweeps for the eigenvalues of a matrix; a few for each of them are the rule.
const SWEEPS: usize = 100 * SUBSPACE;

/// Approximate eigenvalues of `operator` on vectors of `length` numbers (Arnoldi 1951): those of its restriction to the
/// space of a vector and its first images. `None` where the operator is not finite.
pub(crate) fn eigenvalues(length: usize, operator: &dyn Fn(&[f64]) -> Vec<f64>) -> Option<Vec<Complex<f64>>> {
    if length == 0 {
        return Some(Vec::new());
    }
    let size = length.min(SUBSPACE);
    // Such a vector lies in no space that a symmetry leaves to itself.
    let mut basis = vec![DVector::from_fn(length, |i, _| (GOLDEN * (i + 1) as f64).fract() - 0.5).normalize()];
    let mut restricted = DMatrix::<f64>::zeros(size, size);
    let mut found = size;
    for column in 0..size {
        let mut image = DVector::from_vec(operator(basis[column].as_slice()));
        let length = image.norm();
        if !length.is_finite() {
            return None;
        }
        // Twice is enough (Kahan, in Parlett 1980).
        for _ in 0..2 {
            for (row, vector) in basis.iter().enumerate() {
                let part = vector.dot(&image);
                restricted[(row, column)] += part;
                image.axpy(-part, vector, 1.0);
            }
        }
        let rest = image.norm();
        if rest <= length * f64::EPSILON * size as f64 {
            found = column + 1;
            break;
        }
        if column + 1 < size {
            restricted[(column + 1, column)] = rest;
            basis.push(image / rest);
        }
    }
    // nalgebra cannot compute the eigenvalues of a matrix without rows.
    if found == 0 {
        return Some(Vec::new());
    }
    let restricted = restricted.resize(found, found, 0.0);
    Schur::try_new(restricted, f64::EPSILON, SWEEPS).map(|schur| schur.complex_eigenvalues().iter().copied().collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn nothing_has_no_eigenvalues() {
        assert_eq!(eigenvalues(0, &|_| Vec::new()), Some(Vec::new()));
    }

    fn largest(length: usize, operator: impl Fn(&[f64]) -> Vec<f64>) -> f64 {
        let eigenvalues = eigenvalues(length, &operator).expect("a finite operator");
        eigenvalues.iter().map(|value| value.re).fold(f64::NEG_INFINITY, f64::max)
    }

    /// Springs between neighbours and to the walls.
    fn chain(x: &[f64]) -> Vec<f64> {
        let at = |i: usize| x.get(i).copied().unwrap_or(0.0);
        (0..x.len()).map(|i| 2.0 * x[i] - at(i + 1) - if i > 0 { x[i - 1] } else { 0.0 }).collect()
    }

    #[test]
    fn few_dimensions_give_all_eigenvalues() {
        for length in [1, 2, 5, 24] {
            let mut found: Vec<f64> =
                eigenvalues(length, &chain).expect("finite").iter().map(|value| value.re).collect();
            found.sort_by(f64::total_cmp);
            for (mode, found) in (1..).zip(&found) {
                let exact = 2.0 - 2.0 * (PI * f64::from(mode) / (length + 1) as f64).cos();
                // A few roundings of numbers of up to 4 for each dimension of the largest space.
                assert!((found - exact).abs() < 4.0 * 4.0 * 24.0 * f64::EPSILON, "{found} for {exact}, {length} links");
            }
            assert_eq!(found.len(), length);
        }
    }

    #[test]
    fn many_dimensions_give_the_outermost_one() {
        let found = largest(10_000, chain);
        assert!(found < 4.0 && found > 3.96, "{found}");
    }

    #[test]
    fn a_rotation_has_complex_eigenvalues_and_nothing_has_zero() {
        let turned = eigenvalues(2, &|x| vec![-x[1], x[0]]).expect("finite");
        assert!(turned.iter().all(|value| (value.im.abs() - 1.0).abs() < 4.0 * f64::EPSILON), "{turned:?}");
        assert_eq!(largest(3, |x| vec![0.0; x.len()]), 0.0);
        assert_eq!(eigenvalues(2, &|_| vec![f64::NAN; 2]), None);
        assert_eq!(eigenvalues(0, &|_| Vec::new()), Some(Vec::new()));
    }
}
