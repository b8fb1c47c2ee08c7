//! Tolerances: the one comparison of all checks, and norms that keep NaNs.
//!
//! Always true: NaN if any input is NaN, so that the check fails.

/// Whether `value` is at most `tolerance` in absolute value: the comparison of every verdict of every check.
///
/// A NaN on either side is not within, and neither is anything within a tolerance that is infinite.
pub(crate) fn within(value: f64, tolerance: f64) -> bool {
    tolerance.is_finite() && value.abs() <= tolerance
}

/// The largest absolute value, zero where there are none, NaN if any is NaN.
pub(crate) fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    let mut most = 0.0_f64;
    each(&mut values.into_iter(), &mut |value| {
        most = if most.is_nan() || value.abs() <= most { most } else { value.abs() };
    });
    most
}

/// The Euclidean length of `values`.
pub(crate) fn length(values: impl IntoIterator<Item = f64>) -> f64 {
    let mut squares = 0.0;
    each(&mut values.into_iter(), &mut |value| squares += value * value);
    squares.sqrt()
}

/// Not generic, so that checks do not compile a loop for every kind of iterator.
fn each(values: &mut dyn Iterator<Item = f64>, what: &mut dyn FnMut(f64)) {
    for value in values {
        what(value);
    }
}

/// `part` in units of `whole`, where nothing in units of nothing is nothing.
pub(crate) fn ratio(part: f64, whole: f64) -> f64 {
    if part == 0.0 { 0.0 } else { part / whole }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_number_within_a_number_is_within() {
        let table = [
            (0.0, 0.0, true),
            (-1.0, 1.0, true),
            (-2.0, 1.0, false),
            (1.0, -1.0, false),
            (f64::NAN, 1.0, false),
            (0.0, f64::NAN, false),
            (f64::INFINITY, f64::INFINITY, false),
            (0.0, f64::INFINITY, false),
        ];
        for (value, tolerance, expected) in table {
            assert_eq!(within(value, tolerance), expected, "{value} within {tolerance}");
        }
    }

    #[test]
    fn the_largest_keeps_a_nan_wherever_it_stands() {
        assert_eq!(largest([]), 0.0);
        assert_eq!(largest([1.0, -3.0, 2.0]), 3.0);
        for values in [[f64::NAN, 1.0, 2.0], [1.0, f64::NAN, 2.0], [1.0, 2.0, f64::NAN]] {
            assert!(largest(values).is_nan(), "{values:?}");
        }
    }
}
