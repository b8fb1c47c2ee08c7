//! Deviations step by step: their lengths, and the errors of brackets, volumes and symplectic maps.

use crate::{
    errors::Exact,
    problem::{Problem, Stepped},
};
use integrator_core::{
    check::{CheckError, TangentMap},
    prelude::*,
};

/// The tangent map after a number of steps.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Deviation {
    /// The time, in periods.
    pub(crate) periods: f64,
    /// The length of a deviation of the first position, in units of its start and of the orbit.
    pub(crate) length: f64,
    /// `{q₁, p₁}`.
    pub(crate) bracket: f64,
    pub(crate) determinant: f64,
    /// The largest element so far, in units of the orbit.
    pub(crate) largest: f64,
    /// The number of steps after which these values are measured.
    pub(crate) steps: usize,
}

/// The duration over which deviations are integrated, in periods.
pub(crate) const PERIODS: f64 = 4.0;

/// By how much a bracket that is one may be off by rounding after a step, in units of the square of the largest element:
/// less than two hundred flows a step, each rounds the entries of the map a few times, and a bracket has two products of
/// them for each coordinate.
const ROUNDING: f64 = 200.0 * 8.0 * f64::EPSILON;

/// What rounding alone explains of a bracket after some steps of maps with this largest element.
fn explained(steps: usize, largest: f64) -> f64 {
    ROUNDING * steps as f64 * largest.max(1.0).powi(2)
}

impl Deviation {
    /// Returns the error of the bracket, in units of the error that rounding alone may cause.
    pub(crate) fn excess(&self) -> f64 {
        (self.bracket - 1.0).abs() / explained(self.steps, self.largest)
    }
}

/// Follows deviations by a method, until they diverge.
pub(crate) fn deviations<H: Hamiltonian>(
    problem: &Problem<'_, H>,
    method: &dyn Stepped<H::Coords>,
    exact: &Exact,
) -> Result<Vec<Deviation>, CheckError> {
    let steps = (PERIODS * problem.period / problem.step).ceil() as usize;
    let maps = method.maps(&problem.start, problem.step, steps)?;
    let mut largest = 0.0_f64;
    let deviations = maps.iter().zip(1..).map(|(map, steps)| {
        let matrix = in_units(map, exact);
        largest = matrix.iter().flatten().fold(largest, |most, element| element.abs().max(most));
        Deviation {
            periods: steps as f64 * problem.step / problem.period,
            length: matrix.iter().map(|row| row[0] * row[0]).sum::<f64>().sqrt(),
            bracket: map.bracket(0).unwrap_or(f64::NAN),
            determinant: map.determinant(),
            largest,
            steps,
        }
    });
    Ok(deviations.take_while(|deviation| deviation.bracket.is_finite() && deviation.length.is_finite()).collect())
}

/// The largest element of `MᵀJM - J` for the map `M` of some steps, in units of what rounding alone explains.
pub(crate) fn defect<H: Hamiltonian>(
    problem: &Problem<'_, H>,
    method: &dyn Stepped<H::Coords>,
    exact: &Exact,
    h: f64,
    steps: usize,
) -> Result<f64, CheckError> {
    let maps: Vec<_> = method.maps(&problem.start, h, steps)?.iter().map(|map| in_units(map, exact)).collect();
    let largest = maps.iter().flatten().flatten().fold(0.0, |most: f64, element| most.max(element.abs()));
    let (mut defect, n) = (0.0_f64, problem.freedom());
    if let Some(map) = maps.last() {
        for (i, j) in (0..2 * n).flat_map(|i| (0..i).map(move |j| (i, j))) {
            let form: f64 = (0..n).map(|k| map[k][j] * map[n + k][i] - map[n + k][j] * map[k][i]).sum();
            let off = (form - if i == n + j { 1.0 } else { 0.0 }).abs();
            // A map that is not finite is not symplectic.
            defect = if off <= defect { defect } else { off };
        }
    }
    Ok(defect / explained(steps, largest))
}

/// The rows of a map, with positions and momenta in units of the orbit.
fn in_units(map: &TangentMap, exact: &Exact) -> Vec<Vec<f64>> {
    let mut matrix = map.matrix();
    let n = matrix.len() / 2;
    let unit = |index: usize| exact.size[usize::from(index >= n)];
    for (i, row) in matrix.iter_mut().enumerate() {
        row.iter_mut().enumerate().for_each(|(j, element)| *element *= unit(j) / unit(i));
    }
    matrix
}
