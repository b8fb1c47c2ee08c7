//! The table of elementary functions: name, derivative, value. Tests iterate over its rows.

use super::{Comparison, Graph, NodeId};

/// The smallest number whose square is a normal number. The runtime's reals have their own.
pub(crate) const LEAST: f64 = f64::from_bits((1023 - 511) << 52);

/// An elementary function, as a position in [`TABLE`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct Function(u8);

/// The builder of the derivative of a function of one argument, from the argument `x` and the value `y`.
type Slope = fn(graph: &mut Graph, x: NodeId, y: NodeId) -> NodeId;
/// The builder of the two partial derivatives of a function of two arguments, from the arguments and the value.
type Slopes = fn(graph: &mut Graph, a: NodeId, b: NodeId, y: NodeId) -> [NodeId; 2];

/// The builder of the condition that a value is the first of two arguments, from these.
type Choice = fn(graph: &mut Graph, a: NodeId, b: NodeId) -> NodeId;

/// The value and the derivative of a function of one or two arguments.
#[derive(Clone, Copy)]
pub(crate) enum Rule {
    /// One argument; no derivative where it is zero wherever it exists.
    Unary(fn(f64) -> f64, Option<Slope>),
    /// Two arguments.
    Binary(fn(f64, f64) -> f64, Slopes),
}

/// A row of the table.
pub(crate) struct Row {
    /// The name of the method on `f64` and on the runtime's reals.
    pub(crate) name: &'static str,
    /// The method of the runtime's reals that is faster and less precise, if there is one.
    pub(crate) fast: Option<&'static str>,
    /// Whether value and derivative are finite for all finite arguments, but for overflow.
    pub(crate) total: bool,
    pub(crate) parity: Parity,
    /// Whether two arguments may be exchanged.
    pub(crate) commutative: bool,
    /// Whether no value is below zero.
    pub(crate) never_negative: bool,
    /// Whether the value is the first of two arguments, as a condition, where it is always one of them.
    pub(crate) chooses: Option<Choice>,
    pub(crate) rule: Rule,
}

/// Parity of a function: its value where an argument changes its sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Parity {
    Neither,
    /// `f(-x) == f(x)`; for both of two arguments.
    Even,
    /// `f(-x) == -f(x)`; for the first of two arguments.
    Odd,
}

impl Row {
    const fn with_fast(self, name: &'static str) -> Self {
        Self { fast: Some(name), ..self }
    }

    const fn total(self) -> Self {
        Self { total: true, ..self }
    }

    const fn even(self) -> Self {
        Self { parity: Parity::Even, ..self }
    }

    const fn odd(self) -> Self {
        Self { parity: Parity::Odd, ..self }
    }

    const fn commutative(self) -> Self {
        Self { commutative: true, ..self }
    }

    const fn never_negative(self) -> Self {
        Self { never_negative: true, ..self }
    }

    const fn choosing(self, first: Choice) -> Self {
        Self { chooses: Some(first), ..self }
    }
}

const fn row(name: &'static str, rule: Rule) -> Row {
    Row {
        name,
        fast: None,
        total: false,
        parity: Parity::Neither,
        commutative: false,
        never_negative: false,
        chooses: None,
        rule,
    }
}

const fn unary(name: &'static str, value: fn(f64) -> f64, slope: Slope) -> Row {
    row(name, Rule::Unary(value, Some(slope)))
}

/// A function that is constant but for its jumps, so that its derivative is zero wherever it has one.
const fn step(name: &'static str, value: fn(f64) -> f64) -> Row {
    row(name, Rule::Unary(value, None)).total()
}

const fn binary(name: &'static str, value: fn(f64, f64) -> f64, slopes: Slopes) -> Row {
    row(name, Rule::Binary(value, slopes))
}

/// `1 / g`
fn over(graph: &mut Graph, g: NodeId) -> NodeId {
    graph.power(g, -2)
}

/// `1 ± x²`, as a product where it may cancel
fn one_minus_square(graph: &mut Graph, x: NodeId) -> NodeId {
    let one = graph.constant(1.0);
    let (plus, minus) = (graph.add(one, x), graph.sub(one, x));
    graph.mul(minus, plus)
}

fn one_plus_square(graph: &mut Graph, x: NodeId) -> NodeId {
    let (one, square) = (graph.constant(1.0), graph.power(x, 4));
    graph.add(square, one)
}

fn scaled_reciprocal(graph: &mut Graph, x: NodeId, scale: f64) -> NodeId {
    let (scale, reciprocal) = (graph.constant(scale), over(graph, x));
    graph.mul(scale, reciprocal)
}

/// The exponent of a slope. x^0 is 1 everywhere, at zero too, where 0 x^-1 has no value; 0 x^0 is zero.
fn from_zero(graph: &mut Graph, exponent: NodeId, less: NodeId) -> NodeId {
    let zero = graph.constant(0.0);
    let flat = graph.compare(Comparison::Equal, exponent, zero);
    graph.select(flat, zero, less)
}

/// Slopes of a function whose value is one of its arguments: one for that, zero for the other.
fn of_chosen(graph: &mut Graph, first: NodeId) -> [NodeId; 2] {
    let (zero, one) = (graph.constant(0.0), graph.constant(1.0));
    [graph.select(first, one, zero), graph.select(first, zero, one)]
}

/// Whether the minimum is the first of two: the smaller one, and the other of a NaN.
fn is_minimum(graph: &mut Graph, a: NodeId, b: NodeId) -> NodeId {
    let first = graph.compare(Comparison::LessOrEqual, a, b);
    or_other_of_nan(graph, first, b)
}

/// Whether the maximum is the first of two: the larger one, and the other of a NaN.
fn is_maximum(graph: &mut Graph, a: NodeId, b: NodeId) -> NodeId {
    if graph.is_total(a) && graph.is_total(b) {
        let second = graph.compare(Comparison::LessOrEqual, a, b);
        return graph.not(second);
    }
    let first = graph.compare(Comparison::Less, b, a);
    or_other_of_nan(graph, first, b)
}

/// A comparison with a NaN does not hold, so that the second is taken: it must not be one itself.
fn or_other_of_nan(graph: &mut Graph, first: NodeId, b: NodeId) -> NodeId {
    if graph.is_total(b) {
        return first;
    }
    let number = graph.compare(Comparison::Equal, b, b);
    let nan = graph.not(number);
    graph.or(first, nan)
}

/// Every function but `sqrt`, which is the power ½, and the ones that are arithmetic (`recip`, `mul_add`, ...).
///
/// Derivatives avoid cancellation: `tanh'` is `1/cosh²`, not `1 - tanh²`; `asin'` has `(1-x)(1+x)` under its root.
pub(crate) const TABLE: &[Row] = &[
    unary("sin", f64::sin, |g, x, _| g.call("cos", x)).total().with_fast("fast_sin").odd(),
    unary("cos", f64::cos, |g, x, _| {
        let sine = g.call("sin", x);
        g.neg(sine)
    })
    .total()
    .with_fast("fast_cos")
    .even(),
    unary("tan", f64::tan, |g, _, y| one_plus_square(g, y)).total().with_fast("fast_tan").odd(),
    unary("asin", f64::asin, |g, x, _| {
        let square = one_minus_square(g, x);
        g.power(square, -1)
    })
    .with_fast("fast_asin")
    .odd(),
    unary("acos", f64::acos, |g, x, _| {
        let square = one_minus_square(g, x);
        let slope = g.power(square, -1);
        g.neg(slope)
    })
    .with_fast("fast_acos")
    .never_negative(),
    unary("atan", f64::atan, |g, x, _| {
        let square = one_plus_square(g, x);
        over(g, square)
    })
    .total()
    .with_fast("fast_atan")
    .odd(),
    unary("sinh", f64::sinh, |g, x, _| g.call("cosh", x)).total().odd(),
    unary("cosh", f64::cosh, |g, x, _| g.call("sinh", x)).total().even().never_negative(),
    unary("tanh", f64::tanh, |g, x, _| {
        let cosine = g.call("cosh", x);
        g.power(cosine, -4)
    })
    .total()
    .with_fast("fast_tanh")
    .odd(),
    unary("asinh", f64::asinh, |g, x, _| {
        let square = one_plus_square(g, x);
        g.power(square, -1)
    })
    .total()
    .odd(),
    unary("acosh", f64::acosh, |g, x, _| {
        let one = g.constant(1.0);
        let (minus, plus) = (g.sub(x, one), g.add(x, one));
        let square = g.mul(minus, plus);
        g.power(square, -1)
    })
    .never_negative(),
    unary("atanh", f64::atanh, |g, x, _| {
        let square = one_minus_square(g, x);
        over(g, square)
    })
    .odd(),
    unary("exp", f64::exp, |_, _, y| y).total().with_fast("fast_exp").never_negative(),
    unary("exp2", f64::exp2, |g, _, y| {
        let scale = g.constant(std::f64::consts::LN_2);
        g.mul(scale, y)
    })
    .total()
    .never_negative(),
    unary("exp_m1", f64::exp_m1, |g, x, _| g.call("exp", x)).total(),
    unary("ln", f64::ln, |g, x, _| over(g, x)).with_fast("fast_ln"),
    unary("ln_1p", f64::ln_1p, |g, x, _| {
        let one = g.constant(1.0);
        let shifted = g.add(x, one);
        over(g, shifted)
    }),
    unary("log2", f64::log2, |g, x, _| scaled_reciprocal(g, x, std::f64::consts::LOG2_E)),
    unary("log10", f64::log10, |g, x, _| scaled_reciprocal(g, x, std::f64::consts::LOG10_E)),
    unary("cbrt", f64::cbrt, |g, _, y| {
        let (square, three) = (g.power(y, -4), g.constant(3.0));
        g.div(square, three)
    })
    .with_fast("fast_cbrt")
    .odd(),
    unary("abs", f64::abs, |g, x, _| g.call("signum", x)).total().even().never_negative(),
    binary("min", f64::min, |g, a, b, _| {
        let first = is_minimum(g, a, b);
        of_chosen(g, first)
    })
    .choosing(is_minimum)
    .total()
    .commutative(),
    binary("max", f64::max, |g, a, b, _| {
        let first = is_maximum(g, a, b);
        of_chosen(g, first)
    })
    .choosing(is_maximum)
    .total()
    .commutative(),
    step("signum", f64::signum).odd(),
    step("floor", f64::floor),
    step("ceil", f64::ceil),
    step("trunc", f64::trunc).odd(),
    step("round", f64::round).odd(),
    step("round_ties_even", f64::round_ties_even).odd(),
    binary(
        "remainder",
        |x, y| x % y,
        |g, a, b, _| {
            let quotient = g.div(a, b);
            let whole = g.call("trunc", quotient);
            [g.constant(1.0), g.neg(whole)]
        },
    )
    .odd(),
    binary("powf", f64::powf, |g, a, b, y| {
        let one = g.constant(1.0);
        let (less, logarithm) = (g.sub(b, one), g.call("ln", a));
        let less = if g.is_prepared(b) { from_zero(g, b, less) } else { less };
        let lowered = g.call_two("powf", a, less);
        [g.mul(b, lowered), g.mul(y, logarithm)]
    }),
    binary("atan2", f64::atan2, |g, a, b, _| {
        // The angle of two multiples of a value jumps where that is zero, and else stays: the quotient below would be 0/0.
        if g.without_factors(a) == g.without_factors(b) {
            return [g.constant(0.0); 2];
        }
        let (aa, bb) = (g.power(a, 4), g.power(b, 4));
        let square = g.add(aa, bb);
        let scale = over(g, square);
        let along = g.mul(scale, a);
        [g.mul(scale, b), g.neg(along)]
    })
    .with_fast("fast_atan2"),
    binary("hypot", f64::hypot, |g, a, b, y| {
        let scale = over(g, y);
        [g.mul(scale, a), g.mul(scale, b)]
    })
    .even()
    .commutative()
    .never_negative(),
];

impl Function {
    /// The function of this name, if the table has it.
    pub(crate) fn named(name: &str) -> Option<Self> {
        TABLE.iter().position(|row| row.name == name).map(|position| Self(position as u8))
    }

    pub(crate) fn row(self) -> &'static Row {
        &TABLE[usize::from(self.0)]
    }

    pub(crate) fn name(self) -> &'static str {
        self.row().name
    }

    /// Whether it is the root of a sum of two squares.
    pub(crate) fn is_distance(self) -> bool {
        self.name() == "hypot"
    }

    /// Whether it overflows where its argument is some hundreds.
    pub(crate) fn overflows(self) -> bool {
        matches!(self.name(), "exp" | "exp2" | "exp_m1" | "sinh" | "cosh")
    }

    /// Whether its slope falls faster than the reciprocal of its argument where this overflows.
    pub(crate) fn levels_off(self) -> bool {
        matches!(self.name(), "atan" | "tanh")
    }

    /// Whether it is a series in even powers, so that it is smooth in space as a function of a distance.
    pub(crate) fn is_of_square(self) -> bool {
        matches!(self.name(), "cos" | "cosh")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::graph::{Element, ParameterId, Part, evaluate::Point, index::Index};

    /// Where the arguments of each function are drawn from: inside its domain, on both sides of zero where it has both.
    const DOMAINS: &[(&str, [f64; 2])] = &[
        ("sin", [-9.0, 9.0]),
        ("cos", [-9.0, 9.0]),
        ("tan", [-1.4, 1.4]),
        ("asin", [-0.9, 0.9]),
        ("acos", [-0.9, 0.9]),
        ("atan", [-9.0, 9.0]),
        ("sinh", [-3.0, 3.0]),
        ("cosh", [-3.0, 3.0]),
        ("tanh", [-3.0, 3.0]),
        ("asinh", [-9.0, 9.0]),
        ("acosh", [1.1, 9.0]),
        ("atanh", [-0.9, 0.9]),
        ("exp", [-3.0, 3.0]),
        ("exp2", [-3.0, 3.0]),
        ("exp_m1", [-3.0, 3.0]),
        ("ln", [0.1, 9.0]),
        ("ln_1p", [-0.9, 9.0]),
        ("log2", [0.1, 9.0]),
        ("log10", [0.1, 9.0]),
        ("cbrt", [0.1, 9.0]),
        ("abs", [0.1, 9.0]),
        ("powf", [0.2, 4.0]),
        ("atan2", [-4.0, -0.5]),
        ("hypot", [0.2, 4.0]),
        ("min", [0.2, 4.0]),
        ("max", [0.2, 4.0]),
        ("signum", [0.1, 9.0]),
        ("floor", [0.1, 9.0]),
        ("ceil", [-9.0, 0.1]),
        ("trunc", [0.1, 9.0]),
        ("round", [-9.0, 0.1]),
        ("round_ties_even", [-9.0, 0.1]),
        ("remainder", [2.0, 9.0]),
    ];

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
    fn every_row_has_a_domain_and_the_derivative_of_its_value() {
        for row in TABLE {
            let domain = DOMAINS.iter().find(|(name, _)| *name == row.name).map(|(_, domain)| *domain);
            let domain = domain.unwrap_or_else(|| panic!("`{}` has no domain to be tested on", row.name));
            for position in 0..9 {
                let (x, y) = (argument(domain, position), argument(domain, (position + 4) % 9));
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
        let (_, domain) = *DOMAINS.iter().find(|(name, _)| *name == row.name).expect("a domain");
        let value = |[x, y]: [f64; 2]| match row.rule {
            Rule::Unary(value, _) => value(x),
            Rule::Binary(value, _) => value(x, y),
        };
        (0..9).all(|position| {
            let [x, y] = [0, 4].map(|shift| argument(domain, (position + shift) % 9));
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
}
