//! Results of `reference.py` with fifty digits.

use serde_json::{Map, Value};
use std::sync::LazyLock;

/// A number of the reference, and the scale of its evaluation error.
#[derive(Debug)]
pub(crate) struct Exact {
    /// The number, rounded to `f64`.
    pub(crate) value: f64,
    /// The number with every sum replaced by a sum of absolute terms, each times the amplification of rounding errors.
    pub(crate) scale: f64,
}

/// A point and its energies and gradients. Coordinates and time have few binary digits, so they are exact.
pub(crate) struct Point {
    pub(crate) q: Vec<f64>,
    pub(crate) p: Vec<f64>,
    pub(crate) time: f64,
    pub(crate) kinetic: Exact,
    pub(crate) potential: Exact,
    pub(crate) kinetic_gradient: Vec<Exact>,
    pub(crate) potential_gradient: Vec<Exact>,
}

/// Returns the points of a system.
pub(crate) fn points(system: &str) -> Vec<Point> {
    let points = SYSTEMS[system].as_array().expect("a list of points");
    points.iter().map(Point::of).collect()
}

/// Returns the names of the systems, in alphabetical order.
pub(crate) fn names() -> Vec<&'static str> {
    SYSTEMS.keys().map(String::as_str).collect()
}

static SYSTEMS: LazyLock<Map<String, Value>> =
    LazyLock::new(|| serde_json::from_str(include_str!("reference.json")).expect("a map of systems"));

impl Point {
    fn of(point: &Value) -> Self {
        let list = |key: &str| point[key].as_array().unwrap_or_else(|| panic!("a list `{key}`")).iter();
        Self {
            q: list("q").map(number).collect(),
            p: list("p").map(number).collect(),
            time: number(&point["time"]),
            kinetic: Exact::of(&point["kinetic"]),
            potential: Exact::of(&point["potential"]),
            kinetic_gradient: list("kinetic_gradient").map(Exact::of).collect(),
            potential_gradient: list("potential_gradient").map(Exact::of).collect(),
        }
    }
}

impl Exact {
    fn of(pair: &Value) -> Self {
        Self { value: digits(&pair[0]), scale: digits(&pair[1]) }
    }
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

/// Parses a number with more digits than an `f64`, which is stored as a string, and rounds it to the nearest `f64`.
fn digits(value: &Value) -> f64 {
    value.as_str().and_then(|digits| digits.parse().ok()).expect("decimal digits")
}
