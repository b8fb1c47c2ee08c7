//! Enclosures of all functions, compared with their values.

use super::*;

macro_rules! every_function {
    (unary: $($unary:ident)*; binary: $($binary:ident)*;) => {
        /// Every function of one argument: its name, on intervals and on numbers.
        #[allow(clippy::type_complexity, reason = "a table of pairs of functions")]
        fn unary_table() -> Vec<(&'static str, fn(Interval) -> Interval, fn(f64) -> f64)> {
            vec![$((stringify!($unary), <Interval as Real>::$unary, <f64 as Real>::$unary)),*]
        }
        /// Every function of two arguments.
        #[allow(clippy::type_complexity, reason = "a table of pairs of functions")]
        fn binary_table() -> Vec<(&'static str, fn(Interval, Interval) -> Interval, fn(f64, f64) -> f64)> {
            vec![
                $((stringify!($binary), <Interval as Real>::$binary, <f64 as Real>::$binary),)*
                ("add", |a, b| a + b, |a, b| a + b),
                ("sub", |a, b| a - b, |a, b| a - b),
                ("mul", |a, b| a * b, |a, b| a * b),
                ("div", |a, b| a / b, |a, b| a / b),
                ("square_add", |a, b| a.square_add(b), |a, b| a * a + b),
                ("square_from", |a, b| a.square_from(b), |a, b| b - a * a),
            ]
        }
    };
}
elementary_functions!(every_function! {});

/// Intervals of all signs and widths, and points of each.
fn intervals() -> Vec<(Interval, Vec<f64>)> {
    let mut found = Vec::new();
    for middle in [-7.3, -2.0, -0.6, 0.0, 0.4, 1.0, 2.5, 11.0] {
        for radius in [0.0, 1e-9, 0.3, 1.5, 9.0] {
            let interval = Interval::new(middle - radius, middle + radius);
            let points = (0..=40).map(|k| interval.low + (interval.high - interval.low) * f64::from(k) / 40.0);
            found.push((interval, points.filter(|x| interval.contains(*x)).collect()));
        }
    }
    found
}

#[test]
fn every_function_encloses_its_values() {
    for (name, enclose, value) in unary_table() {
        for (interval, points) in intervals() {
            let found = enclose(interval);
            for x in points {
                let value = value(x);
                assert!(value.is_nan() || found.contains(value), "{name} of {x} in {interval:?}: {value}, {found:?}");
            }
        }
    }
    for (name, enclose, value) in binary_table() {
        for (first, xs) in intervals() {
            for (second, ys) in intervals() {
                let found = enclose(first, second);
                for (x, y) in xs.iter().step_by(5).flat_map(|x| ys.iter().step_by(5).map(move |y| (*x, *y))) {
                    let value = value(x, y);
                    assert!(
                        value.is_nan() || found.contains(value),
                        "{name} of {x}, {y} in {first:?}, {second:?}: {value}, {found:?}"
                    );
                }
            }
        }
    }
}

#[test]
fn narrow_intervals_stay_narrow() {
    let x = Interval::new(0.6 - 1e-9, 0.6 + 1e-9);
    for (name, enclose, _) in unary_table().into_iter().filter(|(name, ..)| *name != "acosh") {
        let found = enclose(x);
        assert!(found.high - found.low < 1e-8, "{name}: {found:?}");
    }
    assert_eq!(Interval::of(0.1) - Interval::of(0.1), Interval::of(0.0), "exact sums are not widened");
}

#[test]
fn an_undecided_condition_allows_for_both_sides() {
    let (x, one) = (Interval::new(0.5, 1.5), Interval::of(1.0));
    assert_eq!(Interval::select(x.less(one), x, one), x);
    assert_eq!(Interval::select(one.less(x).and(Mask::of(false)), x, one), one);
    assert_eq!(Interval::select(one.equal(one).not(), x, one), one);
}
