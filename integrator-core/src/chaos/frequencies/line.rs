//! The terms of a function with the largest amplitudes.

use super::{
    fit::Fit,
    peak::Peaks,
    series::{ORDER, Series},
    term::{Term, unit},
};
use crate::check::CheckError;
use std::f64::consts::TAU;

/// A term `a exp(iνt)` of a quasi-periodic function, where `t` is the time since the first sample.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Line {
    /// The frequency `ν` in radians per unit of time, with its sign.
    pub frequency: f64,
    /// The complex amplitude `a` at the first sample, `[real, imaginary]`.
    pub amplitude: [f64; 2],
}

impl Line {
    /// Returns the modulus of the amplitude.
    pub fn modulus(&self) -> f64 {
        self.amplitude[0].hypot(self.amplitude[1])
    }

    /// Returns the phase of the amplitude in radians, from `-π` to `π`.
    pub fn phase(&self) -> f64 {
        self.amplitude[1].atan2(self.amplitude[0])
    }
}

/// Finds the terms with the largest amplitudes of a function, from samples `[real, imaginary]` at equal intervals of time.
///
/// Returns at most `count` terms in descending order of amplitude. There are fewer if the residual is rounding. The window has
/// order 3; the [module](mod@crate::chaos::frequencies) describes the method and its limits. The time is proportional to the number
/// of samples and to the square of `count`.
///
/// ```
/// use integrator_core::chaos::frequencies;
///
/// // 2 exp(it) + 0.1 exp(-i√2 t), ten samples per unit of time.
/// let samples: Vec<[f64; 2]> = (0..10_000)
///     .map(|n| 0.1 * f64::from(n))
///     .map(|t| (t, -2.0_f64.sqrt() * t))
///     .map(|(a, b)| [2.0 * a.cos() + 0.1 * b.cos(), 2.0 * a.sin() + 0.1 * b.sin()])
///     .collect();
/// let lines = frequencies(&samples, 0.1, 10)?;
/// assert_eq!(lines.len(), 2);
/// assert!((lines[0].frequency - 1.0).abs() < 1e-12);
/// assert!((lines[1].frequency + 2.0_f64.sqrt()).abs() < 1e-12);
/// assert!((lines[1].modulus() - 0.1).abs() < 1e-12);
/// # Ok::<(), integrator_core::check::CheckError>(())
/// ```
///
/// # Errors
/// - [`CheckError::SampleTime`]: the interval is not positive and finite.
/// - [`CheckError::TooFewSamples`]: there are fewer than 32 samples.
/// - [`CheckError::SampleNotFinite`]: a sample is not finite.
pub fn frequencies(samples: &[[f64; 2]], interval: f64, count: usize) -> Result<Vec<Line>, CheckError> {
    frequencies_with_window(samples, interval, count, ORDER)
}

/// Finds terms like [`frequencies()`] by a Hann window of another order.
///
/// Order 0 is a rectangular window, order 1 the usual Hann window. The [module](mod@crate::chaos::frequencies)
/// describes the effect of the order.
///
/// # Errors
/// Those of [`frequencies()`]; an order of `p` requires `8 (p + 1)` samples.
pub fn frequencies_with_window(
    samples: &[[f64; 2]],
    interval: f64,
    count: usize,
    order: u32,
) -> Result<Vec<Line>, CheckError> {
    let series = Series::new(samples, interval, order)?;
    let middle = (samples.len() - 1) as f64 / 2.0;
    let line = |term: Term| {
        // A frequency beyond the largest one is the same term with the opposite sign.
        let frequency = term.frequency - TAU * (term.frequency / TAU).round();
        let amplitude = term.amplitude * unit(-term.frequency * middle) * series.scale;
        Line { frequency: frequency / interval, amplitude: [amplitude.re, amplitude.im] }
    };
    let mut lines: Vec<Line> = terms(&series, count).into_iter().map(line).collect();
    lines.sort_by(|a, b| b.modulus().total_cmp(&a.modulus()));
    Ok(lines)
}

/// The fitted terms of a series, in the order in which they were found.
fn terms(series: &Series, count: usize) -> Vec<Term> {
    let (mut fit, mut peaks) = (Fit::new(series), Peaks::new(series.values.len()));
    while fit.terms.len() < count {
        let peak = peaks.largest(series, &fit.rest, &fit.terms);
        if !peak.is_some_and(|frequency| fit.add(frequency)) {
            break;
        }
    }
    fit.terms
}
