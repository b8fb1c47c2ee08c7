//! The monodromy matrix of a periodic orbit: the derivative of the state after one period by the initial state.
//!
//! In: a system, a method, a start, a step, the number of steps of a period. Out: the derivative of these steps, its
//! eigenvalues, and the linear stability. Always true: the matrix is the derivative of the steps of a run.

use crate::{
    check::{
        CheckError,
        start::{IntoStart, Start},
    },
    error::Number,
    hamiltonian::Hamiltonian,
    scalar::tolerance::largest,
    state::{coords::Coords, phase::Phase, precision::Precision},
    system::Shaped,
    trajectory::{
        method::Memoryless,
        tangent::{Tangent, Units, numbers, unit_vectors},
    },
};
use core::fmt;
use nalgebra::DMatrix;

/// An eigenvalue of a monodromy matrix, a complex number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Multiplier {
    /// The real part.
    pub re: f64,
    /// The imaginary part.
    pub im: f64,
}

impl Multiplier {
    /// Returns the absolute value.
    pub fn norm(&self) -> f64 {
        self.re.hypot(self.im)
    }
}

/// The monodromy matrix of a periodic orbit. `Display` prints the multipliers, the largest first, and the stability.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Monodromy {
    /// The rows of the derivative of the final state by the initial state: rows and columns are all of `q`, then all of
    /// `p`.
    pub matrix: Vec<Vec<f64>>,
    /// The eigenvalues of the matrix, the Floquet multipliers, sorted by decreasing absolute value.
    ///
    /// The inverse of each multiplier is a multiplier as well. If `H` does not depend on time and the orbit is not an
    /// equilibrium, one pair of multipliers is 1.
    pub multipliers: Vec<Multiplier>,
    /// The accuracy of a double multiplier: the square root of the rounding error of the matrix.
    pub uncertainty: f64,
    /// The largest difference of a coordinate between the start and the end of the period. If it is not small, the
    /// orbit is not periodic and the multipliers have no meaning.
    pub gap: f64,
}

impl Monodromy {
    /// Whether the orbit is linearly stable: no multiplier is outside of the unit circle, up to the
    /// [uncertainty](Self::uncertainty).
    pub fn is_stable(&self) -> bool {
        self.multipliers.iter().all(|multiplier| multiplier.norm() <= 1.0 + self.uncertainty)
    }
}

impl fmt::Display for Monodromy {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if self.is_stable() { "stable, multipliers" } else { "unstable, multipliers" })?;
        for Multiplier { re, im } in &self.multipliers {
            write!(f, " {:.6}{:+.6}i", Number(*re), Number(*im))?;
        }
        write!(f, " (known to {:.1e}), the orbit closes to {:.1e}", self.uncertainty, self.gap)
    }
}

/// Computes the monodromy matrix and the stability of the orbit from `start` with a period of `steps` steps of `h`.
///
/// ```
/// use integrator_core::{check::monodromy, prelude::*};
/// use std::f64::consts::PI;
///
/// struct Pendulum;
///
/// #[hamiltonian]
/// impl Pendulum {
///     fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] / 2.0 }
///     fn potential(&self, q: [f64; 1]) -> f64 { -q[0].cos() }
/// }
///
/// // Its equilibria have any period.
/// let below = monodromy(&Pendulum, Yoshida4, Phase::new([0.0], [0.0]), 0.01, 100)?;
/// let above = monodromy(&Pendulum, Yoshida4, Phase::new([PI], [0.0]), 0.01, 100)?;
/// assert!(below.is_stable() && !above.is_stable());
/// assert!((above.multipliers[0].re - 1.0_f64.exp()).abs() < 1e-8);
/// # Ok::<(), integrator_core::check::CheckError>(())
/// ```
///
/// # Errors
/// - The start or the step is invalid for a run.
/// - The run or one of its deviation vectors diverges.
/// - [`CheckError::TooFewSteps`]; [`CheckError::Growth`].
pub fn monodromy<H: Hamiltonian, X: Memoryless<H>, K: Precision>(
    system: &H,
    method: X,
    start: impl IntoStart<Shaped<H, K>, Leaf = K>,
    h: f64,
    steps: u64,
) -> Result<Monodromy, CheckError> {
    if steps == 0 {
        return Err(CheckError::TooFewSteps { steps, needed: 1 });
    }
    let Start { phase, time } = start.into_start();
    let vectors = unit_vectors(&phase);
    let mut tangent = Tangent::start::<H, X, K>(system, method, phase.clone(), vectors, h)?.at_time(time);
    tangent.advance(steps)?;
    // Beyond all numbers infinity, and not NaN for a component of zero.
    let power = |exponent: &i64| (*exponent as f64).exp2().min(f64::MAX);
    let columns = tangent.vectors();
    let scaled = columns.iter().zip(tangent.exponents()).flat_map(|(column, exponent)| {
        let power = power(exponent);
        numbers(column).map(move |number| number * power)
    });
    let matrix = DMatrix::from_iterator(columns.len(), columns.len(), scaled);
    let measured = measured(&matrix);
    let largest = largest(measured.iter().copied());
    // Products of entries have to be finite.
    if largest.is_nan() || largest > f64::MAX.sqrt() / matrix.len() as f64 {
        return Err(CheckError::Growth { steps });
    }
    let roundings = method.facts().roundings_in(steps) * K::EPSILON.max(f64::EPSILON);
    Ok(of_matrices(&matrix, &measured, roundings, gap(&phase, &tangent.state())))
}

fn gap<C: Coords>(start: &Phase<C>, end: &Phase<C>) -> f64 {
    largest(numbers(start).zip(numbers(end)).map(|(start, end)| end - start))
}

/// The matrix in units that balance it, so that its size does not depend on the units of the system.
fn measured(matrix: &DMatrix<f64>) -> DMatrix<f64> {
    let half = matrix.nrows() / 2;
    let size = |row, column| largest(matrix.view((row, column), (half, half)).iter().copied());
    let units = Units::balancing([size(0, half), size(half, 0)]);
    DMatrix::from_fn(2 * half, 2 * half, |row, column| match (row < half, column < half) {
        (true, false) => units.measured_position(matrix[(row, column)]),
        (false, true) => units.stretched_position(matrix[(row, column)]),
        _ => matrix[(row, column)],
    })
}

/// From the matrix in the units of the system, and in those that balance it.
fn of_matrices(matrix: &DMatrix<f64>, measured: &DMatrix<f64>, roundings: f64, gap: f64) -> Monodromy {
    let mut multipliers: Vec<_> =
        measured.complex_eigenvalues().iter().map(|number| Multiplier { re: number.re, im: number.im }).collect();
    multipliers.sort_by(|a, b| b.norm().total_cmp(&a.norm()));
    // The double multiplier of a matrix that is off by δ is off by the root of δ; every flow of the steps rounds the
    // matrix once.
    let uncertainty = (roundings * measured.norm()).sqrt();
    let matrix = matrix.row_iter().map(|row| row.iter().copied().collect()).collect();
    Monodromy { matrix, multipliers, uncertainty, gap }
}
