//! Least squares: the straight line through points.

use std::ops::RangeInclusive;

/// The slope of a fit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Slope {
    /// The slope.
    pub(crate) value: f64,
    /// The standard error of the slope, from the residuals of the points; NaN with fewer than three points.
    pub(crate) uncertainty: f64,
}

/// The slope of the line `y = a + b·x` with the least sum of squared residuals in `y`:
/// `b = Σ (x - x̄)(y - ȳ) / Σ (x - x̄)²`, with the variance `Σ r² / (n - 2) / Σ (x - x̄)²`.
pub(crate) fn fit(points: &[(f64, f64)]) -> Slope {
    let count = points.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / count;
    let (x_mean, y_mean) = (mean(|point| point.0), mean(|point| point.1));
    let spread: f64 = points.iter().map(|(x, _)| (x - x_mean).powi(2)).sum();
    let value = points.iter().map(|(x, y)| (x - x_mean) * (y - y_mean)).sum::<f64>() / spread;
    let residual: f64 = points.iter().map(|(x, y)| (y - y_mean - value * (x - x_mean)).powi(2)).sum();
    Slope { value, uncertainty: (residual / (count - 2.0) / spread).sqrt() }
}

/// The slope through the finest of some points, which come in the order of refinement: through as many of the last
/// `counts` of them as lie best on a line, since a leading term prevails at the fine end only. The points are returned
/// with it; `None` where there are fewer than the least count.
pub(crate) fn fit_finest(points: &[(f64, f64)], counts: RangeInclusive<usize>) -> Option<(&[(f64, f64)], Slope)> {
    let most = points.len().min(*counts.end());
    let fits = (*counts.start()..=most).map(|count| {
        let finest = &points[points.len() - count..];
        (finest, fit(finest))
    });
    fits.min_by(|one, other| one.1.uncertainty.total_cmp(&other.1.uncertainty))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::tolerance::within;

    #[test]
    fn a_fit_has_slope_and_scatter() {
        let straight = fit(&[(0.0, 1.0), (1.0, 3.0), (4.0, 9.0)]);
        assert!(within(straight.value - 2.0, 4.0 * f64::EPSILON), "{straight:?}");
        assert!(within(straight.uncertainty, 4.0 * f64::EPSILON), "{straight:?}");
        // Residuals of +1, -2, +1 about a level line: b = 0, variance 6 / 1 / 2.
        let scattered = fit(&[(-1.0, 1.0), (0.0, -2.0), (1.0, 1.0)]);
        assert!(within(scattered.value, f64::EPSILON), "{scattered:?}");
        assert!(within(scattered.uncertainty - 3.0_f64.sqrt(), 4.0 * f64::EPSILON), "{scattered:?}");
    }

    #[test]
    fn the_finest_points_that_lie_on_a_line_are_fitted() {
        let bent = [(0.0, 9.0), (1.0, 0.0), (2.0, 1.0), (3.0, 2.0), (4.0, 3.0)];
        let (finest, slope) = fit_finest(&bent, 4..=5).expect("five points");
        assert_eq!((finest.len(), slope.value), (4, 1.0));
        assert!(fit_finest(&bent[..3], 4..=5).is_none());
    }

    #[test]
    fn nothing_to_fit_is_nan() {
        assert!(fit(&[]).value.is_nan());
        assert!(fit(&[(1.0, 1.0)]).value.is_nan());
    }
}
