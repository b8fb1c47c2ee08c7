//! Closed-form solutions: the pendulum by Jacobi's elliptic functions, and the Kepler ellipse by Kepler's equation.

use std::f64::consts::TAU;

/// Returns `sn`, `cn` and `dn` of `u` for the modulus `k`, by the descending arithmetic-geometric mean.
pub(crate) fn jacobi(u: f64, k: f64) -> [f64; 3] {
    let mut means = vec![(1.0_f64, k)];
    let mut geometric = (1.0 - k * k).sqrt();
    while let Some(&(arithmetic, half_difference)) = means.last()
        && half_difference.abs() > f64::EPSILON * arithmetic
    {
        means.push((0.5 * (arithmetic + geometric), 0.5 * (arithmetic - geometric)));
        geometric = (arithmetic * geometric).sqrt();
    }
    let last = means.len() - 1;
    let mut amplitude = 2.0_f64.powi(last as i32) * means[last].0 * u;
    for (arithmetic, half_difference) in means.iter().skip(1).rev() {
        amplitude = 0.5 * (amplitude + (half_difference / arithmetic * amplitude.sin()).asin());
    }
    let (sn, cn) = amplitude.sin_cos();
    [sn, cn, (1.0 - k * k * sn * sn).sqrt()]
}

/// Returns the complete elliptic integral `K(k)`.
pub(crate) fn complete(k: f64) -> f64 {
    let (mut arithmetic, mut geometric) = (1.0_f64, (1.0 - k * k).sqrt());
    while (arithmetic - geometric).abs() > 2.0 * f64::EPSILON * arithmetic {
        (arithmetic, geometric) = (0.5 * (arithmetic + geometric), (arithmetic * geometric).sqrt());
    }
    TAU / 4.0 / arithmetic
}

/// Returns angle and momentum of a pendulum released at rest: `sin(q/2) = k sn(t + K)` and `p = 2k cn(t + K)`.
pub(crate) fn pendulum(amplitude: f64, time: f64) -> [f64; 2] {
    let k = (0.5 * amplitude).sin();
    let [sn, cn, _] = jacobi(time + complete(k), k);
    [2.0 * (k * sn).asin(), 2.0 * k * cn]
}

/// Returns position and velocity on an ellipse of semi-major axis 1, at a time after the pericentre: `E - e sin E = t`.
pub(crate) fn ellipse(eccentricity: f64, time: f64) -> [f64; 4] {
    let mut anomaly = time;
    // Newton's method doubles the digits. From the mean anomaly, a few iterations suffice for moderate eccentricities.
    for _ in 0..20 {
        let (sine, cosine) = anomaly.sin_cos();
        anomaly -= (anomaly - eccentricity * sine - time) / (1.0 - eccentricity * cosine);
    }
    let ((sine, cosine), root) = (anomaly.sin_cos(), (1.0 - eccentricity * eccentricity).sqrt());
    let rate = 1.0 / (1.0 - eccentricity * cosine);
    [cosine - eccentricity, root * sine, -sine * rate, root * cosine * rate]
}

/// Returns the largest difference between two lists.
pub(crate) fn apart(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}
