//! The restricted problem of three bodies in the frame that turns with Sun and Jupiter.

use integrator_core::prelude::*;

/// Mass of Jupiter over that of Sun and Jupiter; the Sun is 1047.3486 times heavier (IAU 2009).
pub(crate) const JUPITER: f64 = 1.0 / 1048.3486;

/// Period of Jupiter in years.
pub(crate) const YEAR: f64 = 11.862;

/// A massless asteroid. Units: the distance of Jupiter, and its period divided by 2π.
pub(crate) struct Asteroid;

#[hamiltonian(split = quadratic + rest, compose = Aba864)]
impl Asteroid {
    fn hamiltonian(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 {
        let from_sun = ((x + JUPITER).powi(2) + y * y).sqrt();
        let from_jupiter = ((x - 1.0 + JUPITER).powi(2) + y * y).sqrt();
        0.5 * (px * px + py * py) + y * px - x * py - (1.0 - JUPITER) / from_sun - JUPITER / from_jupiter
    }
}

/// Returns a state at rest in the rotating frame, some degrees ahead of the triangular Lagrange point.
pub(crate) fn start(ahead: f64) -> Phase<[f64; 2]> {
    let (y, x) = (60.0 + ahead).to_radians().sin_cos();
    let x = x - JUPITER;
    Phase::new([x, y], [-y, x])
}

/// Returns the angle ahead of the triangular Lagrange point in degrees, as seen from the Sun.
pub(crate) fn ahead(q: [f64; 2]) -> f64 {
    q[1].atan2(q[0] + JUPITER).to_degrees() - 60.0
}

/// Returns the slow frequency of infinitesimal librations: w⁴ - w² + 27/4 m (1 - m) = 0.
pub(crate) fn slow_frequency() -> f64 {
    (0.5 - (0.25 - 6.75 * JUPITER * (1.0 - JUPITER)).sqrt()).sqrt()
}

/// Returns the dominant frequency of equidistant samples near a given one: the largest Fourier amplitude under a Hann
/// window.
pub(crate) fn strongest(samples: &[f64], apart: f64, near: f64) -> f64 {
    let amplitude = |frequency: f64| {
        let [mut re, mut im] = [0.0, 0.0];
        for (k, sample) in samples.iter().enumerate() {
            let window = (std::f64::consts::PI * k as f64 / samples.len() as f64).sin().powi(2);
            let (sine, cosine) = (frequency * apart * k as f64).sin_cos();
            re += window * sample * cosine;
            im += window * sample * sine;
        }
        re.hypot(im)
    };
    let tried = (-200..=200).map(|k| near * (1.0 + f64::from(k) * 1e-4));
    tried.max_by(|a, b| amplitude(*a).total_cmp(&amplitude(*b))).unwrap_or(near)
}
