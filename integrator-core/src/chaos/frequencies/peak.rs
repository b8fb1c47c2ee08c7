//! The frequency at which the windowed transform of a series is largest.

use super::{
    series::{Series, places},
    term::{Term, unit},
};
use rustfft::{Fft, FftPlanner, num_complex::Complex};
use std::{f64::consts::TAU, sync::Arc};

/// The fast Fourier transform that finds peaks approximately.
pub(super) struct Peaks {
    transform: Arc<dyn Fft<f64>>,
    buffer: Vec<Complex<f64>>,
    scratch: Vec<Complex<f64>>,
}

/// The distance from known frequencies within which no peak is sought, in units of `2π` over the number of samples. Two
/// frequencies at this distance are still well conditioned in the joint fit.
const APART: f64 = 2.0;

/// The largest number of steps of the refinement: enough to halve the bracket down to its rounding.
const STEPS: usize = 60;

impl Peaks {
    /// Prepares transforms of series of a length, padded by zeros to at least twice the length: a peak is then at most a
    /// quarter of the resolution away from a point of the transform.
    pub(super) fn new(samples: usize) -> Self {
        let transform = FftPlanner::new().plan_fft_forward((2 * samples).next_power_of_two());
        let zero = Complex::default();
        Self {
            buffer: vec![zero; transform.len()],
            scratch: vec![zero; transform.get_inplace_scratch_len()],
            transform,
        }
    }

    /// Returns the frequency of the largest peak of `rest`, in radians per sample, away from known terms.
    pub(super) fn largest(&mut self, series: &Series, rest: &[Complex<f64>], known: &[Term]) -> Option<f64> {
        self.buffer.fill(Complex::default());
        for ((windowed, value), weight) in self.buffer.iter_mut().zip(rest).zip(&series.weights) {
            *windowed = value * weight;
        }
        self.transform.process_with_scratch(&mut self.buffer, &mut self.scratch);
        let (points, apart) = (self.buffer.len(), APART * TAU / rest.len() as f64);
        let spacing = TAU / points as f64;
        let is_free = |frequency: f64| known.iter().all(|term| distance(term.frequency, frequency) >= apart);
        let free = self.buffer.iter().enumerate().filter(|(point, _)| is_free(spacing * *point as f64));
        let (point, _) = free.max_by(|(_, a), (_, b)| a.norm_sqr().total_cmp(&b.norm_sqr()))?;
        let signed = if 2 * point > points { point as f64 - points as f64 } else { point as f64 };
        Some(refined(series, rest, spacing * signed, spacing))
    }
}

/// Returns the distance of two frequencies, in radians per sample, on the circle.
fn distance(a: f64, b: f64) -> f64 {
    let turned = (a - b).rem_euclid(TAU);
    turned.min(TAU - turned)
}

/// Refines a peak within `spacing` of a frequency by Newton's method for the zero of the derivative, and by bisection where
/// Newton's method leaves the bracket.
fn refined(series: &Series, rest: &[Complex<f64>], frequency: f64, spacing: f64) -> f64 {
    let (mut low, mut high, mut middle) = (frequency - spacing, frequency + spacing, frequency);
    for _ in 0..STEPS {
        let [slope, curvature] = slope_and_curvature(series, rest, middle);
        if slope > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
        let newton = middle - slope / curvature;
        let next = if curvature < 0.0 && low < newton && newton < high { newton } else { (low + high) / 2.0 };
        // Newton's method converges quadratically: the joint fit needs one step from here.
        let is_found = (next - middle).abs() < 1e-6 * spacing;
        middle = next;
        if is_found {
            break;
        }
    }
    middle
}

/// Returns the first two derivatives of half of the squared modulus of the transform.
fn slope_and_curvature(series: &Series, rest: &[Complex<f64>], frequency: f64) -> [f64; 2] {
    let mut moments = [Complex::<f64>::default(); 3];
    for ((place, value), weight) in places(rest.len()).zip(rest).zip(&series.weights) {
        let mut turned = value * unit(-frequency * place) * weight;
        for moment in &mut moments {
            *moment += turned;
            turned *= place;
        }
    }
    let i = Complex::<f64>::i();
    let [value, first, second] = [moments[0], -i * moments[1], -moments[2]];
    [(value.conj() * first).re, first.norm_sqr() + (value.conj() * second).re]
}
