//! Folds have the value that those of `std` have, or are refused: what a closure does is never guessed from a few values.

use crate::{graph::evaluate::Point, model::sequence::tests::potential};

/// A closure as text and as what it is.
type Row = (&'static str, fn(f64, f64) -> f64);

macro_rules! rows {
    ($(|$sum:ident, $x:ident| $body:expr),+ $(,)?) => {
        [$((
            concat!("|", stringify!($sum), ": f64, ", stringify!($x), "| { let ", stringify!($x), ": f64 = *",
                stringify!($x), "; ", stringify!($body), " }"),
            |$sum: f64, $x: f64| $body,
        )),+]
    };
}

/// Sums, over any number of items.
const SUMS: [Row; 6] = rows![
    |sum, x| sum + x * x,
    |sum, x| x + sum,
    |sum, x| sum - x + 2.0 * x.cos(),
    |sum, x| x.mul_add(x, sum),
    |sum, x| if x > 0.0 { sum + x } else { sum },
    |sum, x| 1.0 + (sum + (x - 3.0)),
];

/// What is more than that; many are sums at 0 and at 1.
const OTHERS: [Row; 13] = rows![
    |sum, x| sum.abs() + x,
    |sum, x| sum.max(0.0) + x,
    |sum, x| sum.min(1.0) + x * x,
    |sum, x| sum.clamp(0.0, 1.0) + x,
    |sum, x| sum * sum + x * x,
    |sum, x| sum * sum * sum + x,
    |sum, x| sum * 0.5 + x,
    |sum, x| x - sum,
    |sum, x| sum + x * sum,
    |sum, x| sum.max(x),
    |sum, x| if sum > 0.5 { sum + x } else { sum },
    |sum, x| sum.powi(3) + x,
    |sum, _x| sum + sum,
];

const Q: [f64; 5] = [0.7, -1.3, 0.4, 2.1, -0.2];

/// The fold that is read, if it is accepted, and the one of `std`.
fn both((text, step): Row, kind: &str) -> (Result<f64, String>, f64) {
    let body = format!("q.iter().fold(0.3, {text}) + 0.0 * t");
    let read = potential(kind, &body).map_err(|error| error.to_string());
    let value = read.map(|model| Point::new(&Q, &[]).value(&model.graph, model.potential));
    (value, Q.iter().fold(0.3, |sum, x| step(sum, *x)))
}

/// Five steps of a few operations, each rounded in another order: 32 roundings at most that matter, of numbers about one.
const TOLERANCE: f64 = 32.0 * f64::EPSILON;

#[test]
fn folds_over_few_items_have_the_value_of_std() {
    for row in SUMS.into_iter().chain(OTHERS) {
        let (found, expected) = both(row, "[f64; 5]");
        let found = found.unwrap_or_else(|error| panic!("{}: {error}", row.0));
        assert!((found - expected).abs() <= TOLERANCE * expected.abs().max(1.0), "{}: {found} for {expected}", row.0);
    }
}

#[test]
fn folds_over_any_number_of_items_are_sums_or_refused() {
    for row in SUMS {
        let (found, expected) = both(row, "&[f64]");
        let found = found.unwrap_or_else(|error| panic!("{}: {error}", row.0));
        assert!((found - expected).abs() <= TOLERANCE * expected.abs().max(1.0), "{}: {found} for {expected}", row.0);
    }
    for row in OTHERS {
        let (found, _) = both(row, "&[f64]");
        assert!(found.is_err_and(|error| error.contains("does more than add")), "{} is accepted", row.0);
    }
}
