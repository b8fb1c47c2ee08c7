//! Deviations step by step: their lengths, and the errors of brackets and volumes.

use crate::problem::{Problem, Stepped};
use integrator_core::{check::CheckError, prelude::*};

/// The tangent map after a number of steps.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Deviation {
    /// The time, in periods.
    pub(crate) periods: f64,
    /// The length of a deviation of the first position, in units of its start.
    pub(crate) length: f64,
    /// `{q₁, p₁}`.
    pub(crate) bracket: f64,
    pub(crate) determinant: f64,
    /// The largest element.
    pub(crate) largest: f64,
    /// The number of steps after which these values are measured.
    pub(crate) steps: usize,
}

/// The duration over which deviations are integrated, in periods.
pub(crate) const PERIODS: f64 = 4.0;

/// By how much a bracket that is one may be off by rounding after this number of steps, in units of the square of the
/// largest element: less than two hundred flows a step, each rounds the entries of the map a few times, and a bracket
/// has two products of them for each coordinate.
const ROUNDING: f64 = 200.0 * 8.0 * f64::EPSILON;

impl Deviation {
    /// Returns the error of the bracket, in units of the error that rounding alone may cause.
    pub(crate) fn excess(&self) -> f64 {
        let rounding = ROUNDING * self.steps as f64 * self.largest.max(1.0).powi(2);
        (self.bracket - 1.0).abs() / rounding
    }
}

/// Follows deviations by a method, until they diverge.
pub(crate) fn deviations<H: Hamiltonian>(
    problem: &Problem<'_, H>,
    method: &dyn Stepped<H::Coords>,
) -> Result<Vec<Deviation>, CheckError> {
    let steps = (PERIODS * problem.period / problem.step).ceil() as usize;
    let maps = method.maps(&problem.start, problem.step, steps)?;
    let deviations = maps.iter().zip(1..).map(|(map, steps)| {
        let matrix = map.matrix();
        Deviation {
            periods: steps as f64 * problem.step / problem.period,
            length: matrix.iter().map(|row| row[0] * row[0]).sum::<f64>().sqrt(),
            bracket: map.bracket(0).unwrap_or(f64::NAN),
            determinant: map.determinant(),
            largest: matrix.iter().flatten().fold(0.0, |most, element| element.abs().max(most)),
            steps,
        }
    });
    Ok(deviations.take_while(|deviation| deviation.bracket.is_finite() && deviation.length.is_finite()).collect())
}
