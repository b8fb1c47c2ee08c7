//! The slope of an error against the step on logarithmic scales.

/// Returns the least-squares slope of `ln error` against `ln step`.
pub(crate) fn slope(points: &[(f64, f64)]) -> f64 {
    let points: Vec<(f64, f64)> = points.iter().map(|(step, error)| (step.ln(), error.ln())).collect();
    let count = points.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / count;
    let (x, y) = (mean(|point| point.0), mean(|point| point.1));
    let covariance: f64 = points.iter().map(|point| (point.0 - x) * (point.1 - y)).sum();
    let variance: f64 = points.iter().map(|point| (point.0 - x) * (point.0 - x)).sum();
    covariance / variance
}

#[test]
fn the_slope_of_a_power_is_its_exponent() {
    let points: Vec<_> = [0.1_f64, 0.05, 0.02, 0.01].map(|step| (step, 7.0 * step.powi(3))).to_vec();
    // Logarithms are of order 1 and differences of order 0.1, so a hundred rounding errors are a generous bound.
    assert!((slope(&points) - 3.0).abs() < 100.0 * f64::EPSILON);
}
