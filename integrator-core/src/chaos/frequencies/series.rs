//! The samples of a function, scaled and with the weights of a Hann window.

use crate::check::CheckError;
use rustfft::num_complex::Complex;
use std::f64::consts::PI;

/// Valid samples with the weights of a window.
pub(super) struct Series {
    /// The samples, divided by `scale`.
    pub(super) values: Vec<Complex<f64>>,
    /// The weights, with a sum of one.
    pub(super) weights: Vec<f64>,
    /// A power of two near the largest component.
    pub(super) scale: f64,
}

/// The order of the window unless another one is chosen. Its side lobes decrease like the seventh power of the distance.
pub(super) const ORDER: u32 = 3;

/// The number of samples for each order of the window and one more: its main lobe spans `2(p + 1)` of the `N` resolvable
/// frequencies. It may fill a quarter of them.
const SAMPLES_OF_ORDER: usize = 8;

/// Returns the number of samples that a window of an order requires.
pub(super) fn needed(order: u32) -> usize {
    (order as usize).saturating_add(1).saturating_mul(SAMPLES_OF_ORDER)
}

impl Series {
    /// Verifies samples and computes the window.
    ///
    /// # Errors
    /// Those of [`super::frequencies()`].
    pub(super) fn new(samples: &[[f64; 2]], interval: f64, order: u32) -> Result<Self, CheckError> {
        // The largest frequency has to be finite as well.
        if !(interval > 0.0 && interval.is_finite() && (PI / interval).is_finite()) {
            return Err(CheckError::SampleTime { interval });
        }
        let needed = needed(order);
        if samples.len() < needed {
            return Err(CheckError::TooFewSamples { samples: samples.len(), needed });
        }
        if let Some(index) = samples.iter().position(|[re, im]| !(re.is_finite() && im.is_finite())) {
            return Err(CheckError::SampleNotFinite { index });
        }
        let scale = scale(samples);
        let values = samples.iter().map(|[re, im]| Complex::new(re / scale, im / scale)).collect();
        Ok(Self { values, weights: hann(samples.len(), order), scale })
    }

    /// Returns half of the length: the largest distance from the middle, up to half a sample.
    pub(super) fn half(&self) -> f64 {
        self.values.len() as f64 / 2.0
    }

    /// Returns the places of the samples relative to the middle.
    pub(super) fn places(&self) -> impl Iterator<Item = f64> + use<> {
        places(self.values.len())
    }
}

/// Returns the places of `samples` samples relative to the middle.
pub(super) fn places(samples: usize) -> impl Iterator<Item = f64> {
    let middle = (samples - 1) as f64 / 2.0;
    (0..samples).map(move |index| index as f64 - middle)
}

/// Returns a power of two near the largest component, so that squares neither overflow nor underflow; 1 if all are zero.
fn scale(samples: &[[f64; 2]]) -> f64 {
    let largest = samples.as_flattened().iter().fold(0.0_f64, |largest, part| largest.max(part.abs()));
    // Reciprocals of powers between these bounds are finite.
    if largest == 0.0 { 1.0 } else { largest.log2().floor().clamp(-1000.0, 1000.0).exp2() }
}

/// Returns the Hann window of an order, `sin²ᵖ(πn/(N+1))` for `n` from 1 to `N`, divided by its sum.
fn hann(samples: usize, order: u32) -> Vec<f64> {
    let sine = |index| (PI * index as f64 / (samples + 1) as f64).sin();
    let weights: Vec<f64> = (1..=samples).map(|index| sine(index).powf(2.0 * f64::from(order))).collect();
    let sum: f64 = weights.iter().sum();
    weights.into_iter().map(|weight| weight / sum).collect()
}
