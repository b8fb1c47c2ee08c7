//! Tests that folds have the same value as those of `std`, or are errors: the meaning of a closure is never guessed
//! from a few values.

use crate::{graph::evaluate::Point, model::loops::sequence::tests::potential};

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

/// Horner's rule, over any number of items.
const POLYNOMIALS: [Row; 6] = rows![
    |sum, x| sum * 0.5 + x,
    |sum, x| x - sum,
    |sum, _x| sum + sum,
    |sum, x| -(sum / 1.25 - x) * 0.5,
    |sum, x| 0.25 + x.mul_add(x, 1.5 * sum - 0.125 * sum),
    |sum, x| (sum + x) * 0.75 + x * x,
];

/// Products, and what keeps the largest or the smallest item, over any number of items.
const JOINED: [Row; 7] = rows![
    |sum, x| sum + x * sum,
    |sum, x| sum.max(x),
    |sum, x| sum * x.cos() * 0.5,
    |sum, x| if sum < x * x { x * x } else { sum },
    |sum, x| if x > sum { sum } else { x },
    |sum, x| (x - 1.0).min(sum).min(x * x),
    |sum, x| if x > 0.0 { sum * x } else { sum },
];

/// What is more than that; many are sums at 0 and at 1.
const OTHERS: [Row; 9] = rows![
    |sum, x| sum.abs() + x,
    |sum, x| sum.max(0.0) + x,
    |sum, x| sum.min(1.0) + x * x,
    |sum, x| sum.clamp(0.0, 1.0) + x,
    |sum, x| sum * sum + x * x,
    |sum, x| sum * sum * sum + x,
    |sum, x| if sum < x * x { x } else { sum },
    |sum, x| if sum > 0.5 { sum + x } else { sum },
    |sum, x| sum.powi(3) + x,
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
    for row in SUMS.into_iter().chain(POLYNOMIALS).chain(JOINED).chain(OTHERS) {
        let (found, expected) = both(row, "[f64; 5]");
        let found = found.unwrap_or_else(|error| panic!("{}: {error}", row.0));
        assert!((found - expected).abs() <= TOLERANCE * expected.abs().max(1.0), "{}: {found} for {expected}", row.0);
    }
}

/// Folds that carry several numbers, as text and as what they are. `true` where any number of items will do.
type Several = (&'static str, fn(&[f64]) -> f64, bool);

macro_rules! several {
    ($(|$q:ident| $any:literal $body:block),+ $(,)?) => {
        [$((stringify!($body), |$q: &[f64]| $body, $any)),+]
    };
}

const SEVERAL: [Several; 6] = several![
    |q| true { let (a, b) = q.iter().fold((0.0, 0.5), |(a, b), x| (a + x, b + x * x)); a * b },
    |q| true { let [a, b] = q.iter().fold([0.0, 0.5], |[a, b], x| [a + x, x * x + b]); a - b * b },
    |q| true { let (a, (b, c)) = q.iter().fold((1.0, (0.0, 0.0)), |(a, (b, c)), x| (a * 0.5 + x, (b + x, c - x * x))); a * b + c },
    |q| true { let (mut a, mut b) = (0.25, 1.0); for x in q.iter().rev() { a = a * 0.75 + x; b *= 0.5; } a * b },
    |q| false { let (a, b) = q.iter().fold((0.0, 0.5), |(a, b), x| (a + b * x, b + x)); a * b },
    |q| false { let (a, b) = q.iter().fold((0.0, 0.5), |(a, b), x| (b, a + x)); a - b },
];

#[test]
fn folds_may_carry_several_numbers() {
    for (text, value, any) in SEVERAL {
        let expected = value(&Q);
        for (kind, accepted) in [("[f64; 5]", true), ("&[f64]", any)] {
            match potential(kind, &format!("let v = {text}; v + 0.0 * t")) {
                Ok(model) => {
                    let found = Point::new(&Q, &[]).value(&model.graph, model.potential);
                    let near = (found - expected).abs() <= TOLERANCE * expected.abs().max(1.0);
                    assert!(accepted && near, "{text}: {found} for {expected}");
                }
                Err(error) => {
                    assert!(!accepted && error.to_string().contains("is not supported over"), "{text}: {error}");
                }
            }
        }
    }
}

#[test]
fn folds_over_any_number_of_items_are_sums_polynomials_joined_or_refused() {
    for row in SUMS.into_iter().chain(POLYNOMIALS).chain(JOINED) {
        let (found, expected) = both(row, "&[f64]");
        let found = found.unwrap_or_else(|error| panic!("{}: {error}", row.0));
        assert!((found - expected).abs() <= TOLERANCE * expected.abs().max(1.0), "{}: {found} for {expected}", row.0);
    }
    for row in OTHERS {
        let (found, _) = both(row, "&[f64]");
        assert!(found.is_err_and(|error| error.contains("is not supported over")), "{} is accepted", row.0);
    }
}
