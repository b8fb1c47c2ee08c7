//! All Lyapunov exponents of an orbit.

use crate::{
    chaos::indicators::{LEAST, begin},
    check::{CheckError, IntoStart},
    hamiltonian::Hamiltonian,
    state::{coords::Coords, phase::Phase, precision::Precision},
    system::Shaped,
    trajectory::{
        method::Memoryless,
        tangent::{BETWEEN_SCALES, Tangent, Units, numbers, scaled, unit_vectors},
    },
};
use nalgebra::DMatrix;
use std::f64::consts::LN_2;

/// The number of spans of an orbit. Their exponents show how accurate those of the whole orbit are.
const SPANS: u64 = 16;

/// The largest difference of the logarithms of two vectors when they are made orthogonal: the shorter one has then lost
/// this number of digits.
const MOST_APART: f64 = 8.0;

/// The part of the length of the shortest vector that may be rounding after one step.
const LEFT: f64 = 1.0 / (1_u64 << 10) as f64;

/// The logarithm of the factor that a double can show between two lengths: whatever is farther apart looks like this.
const ALL_DIGITS: f64 = 52.0 * LN_2;

/// The Lyapunov exponents of an orbit, computed by the method of Benettin et al. (1980, Meccanica 15, 9 and 21).
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Spectrum {
    /// The exponents in descending order, as many as positions and momenta.
    pub exponents: Vec<f64>,
    /// The uncertainty of each exponent.
    ///
    /// It is the larger of the standard error of the means over sixteen spans of the orbit and the change by its second
    /// half. On regular orbits the exponents are zero; the estimates decrease like `ln t / t`.
    pub uncertainties: Vec<f64>,
    /// The integration time.
    pub time: f64,
}

impl Spectrum {
    /// Returns the sum of all exponents, which is zero up to rounding for a symplectic method.
    pub fn sum(&self) -> f64 {
        self.exponents.iter().sum()
    }

    /// Returns the largest absolute sum of a pair of opposite exponents.
    ///
    /// For a symplectic method it tends to zero with the integration time.
    pub fn pairing(&self) -> f64 {
        let pairs = self.exponents.iter().zip(self.exponents.iter().rev());
        pairs.map(|(large, small)| (large + small).abs()).fold(0.0, f64::max)
    }
}

/// Computes all Lyapunov exponents of the orbit from `start`, over `steps` steps of length `h`.
///
/// As many deviation vectors as phase space has dimensions are integrated with the orbit. They are orthogonalised by QR
/// decompositions, at least every 64 steps, and before their lengths differ by a factor of some thousands.
///
/// # Errors
/// - The start or the step is invalid, as for [`Hamiltonian::run`].
/// - The state or a vector diverges.
/// - [`CheckError::TooFewSteps`]: `steps` is too small.
/// - [`CheckError::LongForExponents`]: one step stretches some directions so much more than others that the smaller
///   exponents have no significant digits.
pub fn lyapunov_spectrum<H: Hamiltonian, X: Memoryless<H>, K: Precision>(
    system: &H,
    method: X,
    start: impl IntoStart<Shaped<H, K>, Leaf = K>,
    h: f64,
    steps: u64,
) -> Result<Spectrum, CheckError> {
    let directions = |phase: &Phase<Shaped<H, K>>, units: Units| {
        unit_vectors(phase).into_iter().map(|vector| units.stretched(vector)).collect()
    };
    let (tangent, units) =
        begin::<H, X, K>(system, method, start.into_start(), h, directions, |tangent, vector| tangent.vector(vector))?;
    of_tangent(tangent, steps, units)
}

fn of_tangent<C: Coords>(mut tangent: Tangent<C>, steps: u64, units: Units) -> Result<Spectrum, CheckError> {
    if steps < LEAST {
        return Err(CheckError::TooFewSteps { steps, needed: LEAST });
    }
    let begin = tangent.time();
    let count = tangent.exponents().len();
    let most_digits = (LEFT / C::Leaf::EPSILON.max(f64::EPSILON)).ln();
    // The growth of each vector in each span.
    let mut of_spans = Vec::new();
    let mut every = 1;
    for span in 1..=SPANS {
        let (from, end) = (tangent.time(), (u128::from(steps) * u128::from(span) / u128::from(SPANS)) as u64);
        let mut sums = vec![0.0; count];
        while tangent.steps() < end {
            let (before, portion) = (tangent.clone(), every.min(end - tangent.steps()));
            tangent.advance(portion)?;
            let triangle = triangle(&tangent, units);
            let growths = growths(&triangle, tangent.exponents());
            let apart = largest(&growths) - smallest(&growths);
            if apart > MOST_APART && portion > 1 {
                // The vectors are nearly one: again, with half of the steps.
                (tangent, every) = (before, portion / 2);
                continue;
            }
            if portion == 1 && apart.is_nan() | (apart > most_digits) {
                let (step, known) = (tangent.step(), apart.min(ALL_DIGITS));
                return Err(CheckError::LongForExponents {
                    step,
                    factor: apart.exp(),
                    shorter: step * MOST_APART / known,
                });
            }
            if 4.0 * apart < MOST_APART {
                every = (2 * every).min(BETWEEN_SCALES);
            }
            orthogonalize(&mut tangent, &triangle);
            sums.iter_mut().zip(growths).for_each(|(sum, growth)| *sum += growth);
        }
        of_spans.push((tangent.time() - from, sums));
    }
    let time = tangent.time() - begin;
    let mut known: Vec<_> = (0..count).map(|vector| exponent(&of_spans, vector)).collect();
    known.sort_by(|a, b| b.0.total_cmp(&a.0));
    let (exponents, uncertainties) = known.into_iter().unzip();
    Ok(Spectrum { exponents, uncertainties, time })
}

fn largest(numbers: &[f64]) -> f64 {
    numbers.iter().fold(f64::NEG_INFINITY, |largest, number| largest.max(*number))
}

fn smallest(numbers: &[f64]) -> f64 {
    numbers.iter().fold(f64::INFINITY, |smallest, number| smallest.min(*number))
}

/// An exponent and how well it is known, from the growth of its vector in spans of these lengths.
fn exponent(of_spans: &[(f64, Vec<f64>)], vector: usize) -> (f64, f64) {
    let rate = |spans: &[(f64, Vec<f64>)]| {
        let time: f64 = spans.iter().map(|(time, _)| time.abs()).sum();
        spans.iter().map(|(_, sums)| sums[vector]).sum::<f64>() / time
    };
    let (mean, half) = (rate(of_spans), rate(&of_spans[..of_spans.len() / 2]));
    let squares = of_spans.iter().map(|(time, sums)| (sums[vector] / time.abs() - mean).powi(2)).sum::<f64>();
    let spans = of_spans.len() as f64;
    let error = (squares / (spans * (spans - 1.0))).sqrt();
    (mean, error.max((mean - half).abs()))
}

/// The triangular factor of the matrix whose columns are the vectors.
fn triangle<C: Coords>(tangent: &Tangent<C>, units: Units) -> DMatrix<f64> {
    let vectors: Vec<_> = tangent.vectors().into_iter().map(|vector| units.measured(vector)).collect();
    let rows = numbers(&vectors[0]).count();
    DMatrix::from_iterator(rows, vectors.len(), vectors.iter().flat_map(numbers)).qr().r()
}

/// The logarithms of the lengths of what is new in each vector: orthogonal to those before it.
fn growths(triangle: &DMatrix<f64>, exponents: &[i64]) -> Vec<f64> {
    let growth = |(j, exponent): (usize, &i64)| triangle[(j, j)].abs().ln() + *exponent as f64 * LN_2;
    exponents.iter().enumerate().map(growth).collect()
}

/// Makes the vectors orthogonal and of length one, in their order.
fn orthogonalize<C: Coords>(tangent: &mut Tangent<C>, triangle: &DMatrix<f64>) {
    // In the middle of a step vectors are a linear map of those at its end, so that the same combinations are taken.
    tangent.change_vectors(&mut |vectors| {
        for j in 0..vectors.len() {
            let (before, vector) = vectors.split_at_mut(j);
            let vector = &mut vector[0];
            for (i, other) in before.iter().enumerate() {
                add(vector, -triangle[(i, j)], other);
            }
            *vector = scaled(vector, 1.0 / triangle[(j, j)]);
        }
    });
    tangent.reset_exponents();
}

/// Adds a multiple of another vector.
fn add<C: Coords>(vector: &mut Phase<C>, factor: f64, other: &Phase<C>) {
    let leaves = vector.q.flat_mut().iter_mut().chain(vector.p.flat_mut());
    for (leaf, other) in leaves.zip(other.q.flat().iter().chain(other.p.flat())) {
        let ([value, carried], [of_other, carried_of_other]) = (leaf.parts(), other.parts());
        *leaf = C::Leaf::from_parts([value + factor * of_other, carried + factor * carried_of_other]);
    }
}
