//! A term of a model: an exponential with its amplitude.

use rustfft::num_complex::Complex;

/// The term `amplitude · exp(i · frequency · s)`, where `s` is the number of samples since the middle of the series.
#[derive(Clone, Copy, Debug)]
pub(super) struct Term {
    /// In radians per sample.
    pub(super) frequency: f64,
    /// The amplitude in the middle of the series.
    pub(super) amplitude: Complex<f64>,
}

impl Term {
    /// Returns the value at a number of samples after the middle.
    pub(super) fn at(self, since_middle: f64) -> Complex<f64> {
        self.amplitude * unit(self.frequency * since_middle)
    }

    /// Returns a bound on the rounding of a value: that of the phase, which grows towards both ends, and of the product.
    pub(super) fn rounding(self, half: f64) -> f64 {
        f64::EPSILON * self.amplitude.norm() * (1.0 + (self.frequency * half).abs())
    }
}

/// Returns `exp(i · phase)`.
pub(super) fn unit(phase: f64) -> Complex<f64> {
    let (sin, cos) = phase.sin_cos();
    Complex::new(cos, sin)
}
