//! Means and effective sizes of series of draws.

/// Returns mean and variance.
pub(crate) fn moments(series: &[f64]) -> (f64, f64) {
    let mean = series.iter().sum::<f64>() / series.len() as f64;
    (mean, series.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / series.len() as f64)
}

/// Returns the effective sample size: the number of draws divided by the sum of autocorrelations, truncated where two
/// adjacent ones have a negative sum (Geyer 1992).
pub(crate) fn effective_size(series: &[f64]) -> f64 {
    let (mean, variance) = moments(series);
    let correlation = |lag: usize| {
        let pairs = series.iter().zip(&series[lag..]);
        pairs.map(|(a, b)| (a - mean) * (b - mean)).sum::<f64>() / (series.len() as f64 * variance)
    };
    let pairs = (0..series.len() / 2).map(|pair| correlation(2 * pair) + correlation(2 * pair + 1));
    let time = 2.0 * pairs.take_while(|sum| *sum > 0.0).sum::<f64>() - 1.0;
    series.len() as f64 / time
}
