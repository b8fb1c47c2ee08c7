//! The one table of elementary functions: name, derivative, value. Tests iterate over its rows.

use super::{Graph, NodeId};

/// An elementary function, as a position in [`TABLE`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct Function(u8);

/// How the derivative of a function of one argument is built from the argument `x` and the value `y`.
type Slope = fn(graph: &mut Graph, x: NodeId, y: NodeId) -> NodeId;
/// How the two partial derivatives of a function of two arguments are built from the arguments and the value.
type Slopes = fn(graph: &mut Graph, a: NodeId, b: NodeId, y: NodeId) -> [NodeId; 2];

/// What a function does to one or two arguments.
#[derive(Clone, Copy)]
pub(crate) enum Rule {
    /// One argument: value, derivative (`None` where it is zero wherever it exists), and the interval tests draw from.
    Unary(fn(f64) -> f64, Option<Slope>, [f64; 2]),
    /// Two arguments: value, derivatives, and the interval tests draw both arguments from.
    Binary(fn(f64, f64) -> f64, Slopes, [f64; 2]),
}

/// A row of the table.
pub(crate) struct Row {
    /// The name of the method on `f64` and on the runtime's reals.
    pub(crate) name: &'static str,
    pub(crate) rule: Rule,
}

const fn unary(name: &'static str, value: fn(f64) -> f64, slope: Slope, domain: [f64; 2]) -> Row {
    Row { name, rule: Rule::Unary(value, Some(slope), domain) }
}

const fn binary(name: &'static str, value: fn(f64, f64) -> f64, slopes: Slopes, domain: [f64; 2]) -> Row {
    Row { name, rule: Rule::Binary(value, slopes, domain) }
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

/// Every function but `sqrt`, which is the power ½, and the ones that are arithmetic (`recip`, `mul_add`, ...).
///
/// Derivatives avoid cancellation: `tanh'` is `1/cosh²`, not `1 - tanh²`; `asin'` has `(1-x)(1+x)` under its root.
pub(crate) const TABLE: &[Row] = &[
    unary("sin", f64::sin, |g, x, _| g.call("cos", x), [-9.0, 9.0]),
    unary(
        "cos",
        f64::cos,
        |g, x, _| {
            let sine = g.call("sin", x);
            g.neg(sine)
        },
        [-9.0, 9.0],
    ),
    unary("tan", f64::tan, |g, _, y| one_plus_square(g, y), [-1.4, 1.4]),
    unary(
        "asin",
        f64::asin,
        |g, x, _| {
            let square = one_minus_square(g, x);
            g.power(square, -1)
        },
        [-0.9, 0.9],
    ),
    unary(
        "acos",
        f64::acos,
        |g, x, _| {
            let square = one_minus_square(g, x);
            let slope = g.power(square, -1);
            g.neg(slope)
        },
        [-0.9, 0.9],
    ),
    unary(
        "atan",
        f64::atan,
        |g, x, _| {
            let square = one_plus_square(g, x);
            over(g, square)
        },
        [-9.0, 9.0],
    ),
    unary("sinh", f64::sinh, |g, x, _| g.call("cosh", x), [-3.0, 3.0]),
    unary("cosh", f64::cosh, |g, x, _| g.call("sinh", x), [-3.0, 3.0]),
    unary(
        "tanh",
        f64::tanh,
        |g, x, _| {
            let cosine = g.call("cosh", x);
            g.power(cosine, -4)
        },
        [-3.0, 3.0],
    ),
    unary(
        "asinh",
        f64::asinh,
        |g, x, _| {
            let square = one_plus_square(g, x);
            g.power(square, -1)
        },
        [-9.0, 9.0],
    ),
    unary(
        "acosh",
        f64::acosh,
        |g, x, _| {
            let one = g.constant(1.0);
            let (minus, plus) = (g.sub(x, one), g.add(x, one));
            let square = g.mul(minus, plus);
            g.power(square, -1)
        },
        [1.1, 9.0],
    ),
    unary(
        "atanh",
        f64::atanh,
        |g, x, _| {
            let square = one_minus_square(g, x);
            over(g, square)
        },
        [-0.9, 0.9],
    ),
    unary("exp", f64::exp, |_, _, y| y, [-3.0, 3.0]),
    unary(
        "exp2",
        f64::exp2,
        |g, _, y| {
            let scale = g.constant(std::f64::consts::LN_2);
            g.mul(scale, y)
        },
        [-3.0, 3.0],
    ),
    unary("exp_m1", f64::exp_m1, |g, x, _| g.call("exp", x), [-3.0, 3.0]),
    unary("ln", f64::ln, |g, x, _| over(g, x), [0.1, 9.0]),
    unary(
        "ln_1p",
        f64::ln_1p,
        |g, x, _| {
            let one = g.constant(1.0);
            let shifted = g.add(x, one);
            over(g, shifted)
        },
        [-0.9, 9.0],
    ),
    unary("log2", f64::log2, |g, x, _| scaled_reciprocal(g, x, std::f64::consts::LOG2_E), [0.1, 9.0]),
    unary("log10", f64::log10, |g, x, _| scaled_reciprocal(g, x, std::f64::consts::LOG10_E), [0.1, 9.0]),
    unary(
        "cbrt",
        f64::cbrt,
        |g, _, y| {
            let (square, three) = (g.power(y, -4), g.constant(3.0));
            g.div(square, three)
        },
        [0.1, 9.0],
    ),
    unary("abs", f64::abs, |g, x, _| g.call("signum", x), [0.1, 9.0]),
    Row { name: "signum", rule: Rule::Unary(f64::signum, None, [0.1, 9.0]) },
    binary(
        "powf",
        f64::powf,
        |g, a, b, y| {
            let one = g.constant(1.0);
            let (less, logarithm) = (g.sub(b, one), g.call("ln", a));
            let lowered = g.call_two("powf", a, less);
            [g.mul(b, lowered), g.mul(y, logarithm)]
        },
        [0.2, 4.0],
    ),
    binary(
        "atan2",
        f64::atan2,
        |g, a, b, _| {
            let (aa, bb) = (g.power(a, 4), g.power(b, 4));
            let square = g.add(aa, bb);
            let scale = over(g, square);
            let along = g.mul(scale, a);
            [g.mul(scale, b), g.neg(along)]
        },
        [-4.0, -0.5],
    ),
    binary(
        "hypot",
        f64::hypot,
        |g, a, b, y| {
            let scale = over(g, y);
            [g.mul(scale, a), g.mul(scale, b)]
        },
        [0.2, 4.0],
    ),
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
}
