//! The rows of the table, compared with differences and values.

use super::*;
use crate::graph::{Element, ParameterId, Part, evaluate::Point, index::Index};

/// The argument at which a test evaluates, one of nine in the interval.
fn argument([low, high]: [f64; 2], position: usize) -> f64 {
    low + (high - low) * (position as f64 + 0.37) / 9.0
}

fn coordinate(graph: &mut Graph, position: u64) -> NodeId {
    let index = graph.loops.intern(Index::Literal(position));
    graph.coordinate(Element { part: Part::Position, index, component: None })
}

/// A derivative from differences that are symmetric and extrapolated once (Richardson): with h = 1e-3 its own error
/// is of the size h^4 = 1e-12 times a fifth derivative, and eps/h = 2e-13 from rounding.
fn difference(f: impl Fn(f64) -> f64, x: f64) -> f64 {
    let central = |h: f64| (f(x + h) - f(x - h)) / (2.0 * h);
    (4.0 * central(5e-4) - central(1e-3)) / 3.0
}

#[test]
fn every_row_has_the_derivative_of_its_value() {
    for row in TABLE {
        for position in 0..9 {
            let (x, y) = (argument(row.domain, position), argument(row.domain, (position + 4) % 9));
            let mut graph = Graph::default();
            let (a, b) = (coordinate(&mut graph, 0), coordinate(&mut graph, 1));
            let (slopes, expected) = match row.rule {
                Rule::Unary(value, _) => {
                    let call = graph.call(row.name, a);
                    let function = Function::named(row.name).expect("a row");
                    (vec![graph.slope(function, a, call)], vec![difference(value, x)])
                }
                Rule::Binary(value, _) => {
                    let call = graph.call_two(row.name, a, b);
                    let function = Function::named(row.name).expect("a row");
                    let by = [difference(|x| value(x, y), x), difference(|y| value(x, y), y)];
                    (graph.slopes(function, a, b, call).to_vec(), by.to_vec())
                }
            };
            for (slope, expected) in slopes.into_iter().zip(expected) {
                let slope = slope.map_or(0.0, |slope| Point::new(&[x, y], &[]).value(&graph, slope));
                // The differences are good to 1e-9 of the largest derivatives met here, of which some are about
                // 100.
                let bound = 1e-7 * (1.0 + expected.abs());
                assert!((slope - expected).abs() < bound, "{}' at {x}, {y}: {slope} for {expected}", row.name);
            }
        }
    }
}

/// Zero, the edges of domains, and what is far from both.
const EVERYWHERE: [f64; 9] = [-300.0, -2.0, -1.0, -0.5, 0.0, 0.5, 1.0, 2.0, 300.0];

#[test]
fn a_function_is_total_where_nothing_of_it_has_a_pole_or_an_edge() {
    for row in TABLE {
        let mut graph = Graph::default();
        let (a, b) = (coordinate(&mut graph, 0), coordinate(&mut graph, 1));
        let function = Function::named(row.name).expect("a row");
        let parts = match row.rule {
            Rule::Unary(..) => {
                let call = graph.call(row.name, a);
                [Some(call), graph.slope(function, a, call), None]
            }
            Rule::Binary(..) => {
                let call = graph.call_two(row.name, a, b);
                let [first, second] = graph.slopes(function, a, b, call);
                [Some(call), first, second]
            }
        };
        let points = EVERYWHERE.into_iter().flat_map(|x| EVERYWHERE.map(|y| [x, y]));
        let mut values = points.flat_map(|at| {
            let parts = parts.into_iter().flatten();
            parts.map(|part| Point::new(&at, &[]).value(&graph, part)).collect::<Vec<_>>()
        });
        assert_eq!(values.all(f64::is_finite), row.total, "{}", row.name);
    }
}

#[test]
fn functions_marked_never_negative_are_never_negative() {
    for row in TABLE {
        let points = EVERYWHERE.into_iter().flat_map(|x| EVERYWHERE.map(|y| [x, y]));
        let below = points.map(|[x, y]| match row.rule {
            Rule::Unary(value, _) => value(x),
            Rule::Binary(value, _) => value(x, y),
        });
        assert_eq!(!below.into_iter().any(|value| value < 0.0), row.never_negative, "{}", row.name);
    }
}

/// Whether the values of a row have the parity and the commutativity that it claims.
fn symmetries_hold(row: &Row) -> bool {
    let value = |[x, y]: [f64; 2]| match row.rule {
        Rule::Unary(value, _) => value(x),
        Rule::Binary(value, _) => value(x, y),
    };
    (0..9).all(|position| {
        let [x, y] = [0, 4].map(|shift| argument(row.domain, (position + shift) % 9));
        let own = value([x, y]);
        // `atanh` of `std` takes a logarithm of (1 + x) / (1 - x), whose roundings differ on the two sides of zero.
        let is = |at: [f64; 2], expected: f64| (value(at) - expected).abs() <= 4.0 * f64::EPSILON * expected.abs();
        let parity = match row.parity {
            Parity::Neither => true,
            Parity::Even => is([-x, y], own) && is([x, -y], own),
            Parity::Odd => is([-x, y], -own),
        };
        parity && (!row.commutative || is([y, x], own))
    })
}

#[test]
fn symmetries_are_those_of_the_values() {
    for row in TABLE {
        assert!(symmetries_hold(row), "{}", row.name);
    }
    let row = |name| Row { fast: None, ..*Function::named(name).expect("a row").row() };
    for wrong in [row("sin").even(), row("cos").odd(), row("powf").commutative(), row("remainder").even()] {
        assert!(!symmetries_hold(&wrong), "{}", wrong.name);
    }
}

#[test]
fn a_power_with_exponent_zero_is_flat_at_zero_too() {
    let mut graph = Graph::default();
    let (x, exponent) = (coordinate(&mut graph, 0), graph.parameter(ParameterId(0)));
    let power = graph.call_two("powf", x, exponent);
    let [slope, _] = graph.slopes(Function::named("powf").expect("a row"), x, exponent, power);
    for (exponent, expected) in [(0.0, 0.0), (1.0, 1.0), (2.0, 0.0)] {
        let mut point = Point { parameters: &[exponent], ..Point::new(&[0.0], &[]) };
        assert_eq!(slope.map(|slope| point.value(&graph, slope)), Some(expected), "x^{exponent}");
    }
}

#[test]
fn a_fast_variant_is_named_after_its_function() {
    for row in TABLE {
        assert!(row.fast.is_none_or(|fast| fast == format!("fast_{}", row.name)), "of `{}`", row.name);
    }
}

#[test]
fn a_wrong_derivative_would_be_seen() {
    assert!((difference(f64::sin, 1.0) - 1.0_f64.sin()).abs() > 0.1);
    assert!((difference(f64::sin, 1.0) - 1.0_f64.cos()).abs() < 1e-9);
}

#[test]
fn tanh_keeps_its_digits_where_it_is_flat() {
    let mut graph = Graph::default();
    let x = coordinate(&mut graph, 0);
    let tanh = graph.call("tanh", x);
    let slope = graph.slope(Function::named("tanh").expect("a row"), x, tanh).expect("a slope");
    // 1/cosh²(20) = 4 e^-40 (1 - 2e^-40 + ...)
    let expected = 4.0 * (-40.0_f64).exp();
    let value = Point::new(&[20.0], &[]).value(&graph, slope);
    assert!((value / expected - 1.0).abs() < 1e-14, "{value} for {expected}");
}
