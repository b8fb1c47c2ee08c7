//! What `reference.py` found with fifty digits.

use serde_json::{Map, Value};
use std::sync::LazyLock;

/// A coefficient, and the scale of the error that its evaluation may have.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Exact {
    /// The coefficient, rounded to `f64`.
    pub(crate) value: f64,
    /// What it may be off by, in units of a rounding, if each term of each operation on series is off by one.
    pub(crate) scale: f64,
}

/// The motion of a system, as the coefficients of each coordinate by order. Those of order 0 are exact.
pub(crate) struct Motion {
    pub(crate) q: Vec<Vec<Exact>>,
    pub(crate) p: Vec<Vec<Exact>>,
    pub(crate) time: f64,
}

/// The motion of the system with a name.
pub(crate) fn motion(name: &str) -> Motion {
    let row = SYSTEMS.get(name).unwrap_or_else(|| panic!("reference.py knows `{name}`"));
    let list = |value: &Value| value.as_array().expect("a list").clone();
    let exact = |pair: &Value| Exact { value: digits(&pair[0]), scale: digits(&pair[1]) };
    let series = |part: &str| list(&row[part]).iter().map(|series| list(series).iter().map(exact).collect()).collect();
    Motion { q: series("q"), p: series("p"), time: row["time"].as_f64().expect("a number") }
}

/// The systems, in alphabetical order.
pub(crate) fn names() -> Vec<&'static str> {
    SYSTEMS.keys().map(String::as_str).collect()
}

static SYSTEMS: LazyLock<Map<String, Value>> =
    LazyLock::new(|| serde_json::from_str(include_str!("reference.json")).expect("a map of systems"));

/// A number whose digits are more than an `f64` holds, and so stand in a string. Parsing rounds to the nearest `f64`.
fn digits(value: &Value) -> f64 {
    value.as_str().and_then(|digits| digits.parse().ok()).expect("decimal digits")
}
