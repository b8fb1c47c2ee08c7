//! The table of elementary functions, one row each: name, value, domain, derivative and properties. Tests iterate over
//! its rows. Recurrences of Taylor coefficients follow from the derivative.

use super::{Comparison, Graph, NodeId};
use Device::{Exact, Kernel, Library};

/// The smallest number whose square is a normal number. The runtime's reals have their own.
pub(crate) const LEAST: f64 = f64::from_bits((1023 - 511) << 52);

/// A number far above what divides a derivative where that matters, and so far below the largest number that derivatives of the
/// divisor are finite. The runtime's reals have their own.
pub(crate) const HUGE: f64 = f64::from_bits((1023 + 896) << 52);

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
    /// Whether it overflows where its argument is some hundreds.
    pub(crate) overflows: bool,
    /// Whether its slope falls faster than the reciprocal of its argument where this overflows.
    pub(crate) levels_off: bool,
    /// Whether it is a series in even powers, so that it is smooth in space as a function of a distance.
    pub(crate) of_square: bool,
    /// Whether it has pieces: a kink, a jump or a cut.
    pub(crate) piecewise: bool,
    pub(crate) device: Device,
    /// Whether the value is the first of two arguments, as a condition, where it is always one of them.
    pub(crate) chooses: Option<Choice>,
    pub(crate) rule: Rule,
    /// Where tests draw arguments from: inside the domain, on both sides of zero where it has both.
    #[cfg(test)]
    domain: [f64; 2],
}

/// The code that devices have of a function (`integrator-gpu/src/cuda/functions.h`).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Device {
    None,
    /// That of the device's library, which is exact.
    Exact,
    /// That of the device's library, whose bits are others than those of the processor.
    Library,
    /// The same, and a kernel with the bits of the Rust kernel.
    Kernel,
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

    const fn overflows(self) -> Self {
        Self { overflows: true, ..self }
    }

    const fn levels_off(self) -> Self {
        Self { levels_off: true, ..self }
    }

    const fn of_square(self) -> Self {
        Self { of_square: true, ..self }
    }

    const fn piecewise(self) -> Self {
        Self { piecewise: true, ..self }
    }

    /// Has this code on devices.
    const fn on(self, device: Device) -> Self {
        Self { device, ..self }
    }
}

#[cfg_attr(not(test), allow(unused_variables, reason = "tests draw arguments from the domain"))]
const fn row(name: &'static str, domain: [f64; 2], rule: Rule) -> Row {
    Row {
        name,
        fast: None,
        total: false,
        parity: Parity::Neither,
        commutative: false,
        never_negative: false,
        overflows: false,
        levels_off: false,
        of_square: false,
        piecewise: false,
        device: Device::None,
        chooses: None,
        rule,
        #[cfg(test)]
        domain,
    }
}

const fn unary(name: &'static str, value: fn(f64) -> f64, domain: [f64; 2], slope: Slope) -> Row {
    row(name, domain, Rule::Unary(value, Some(slope)))
}

/// A function that is constant but for its jumps, so that its derivative is zero wherever it has one.
const fn step(name: &'static str, value: fn(f64) -> f64, domain: [f64; 2]) -> Row {
    row(name, domain, Rule::Unary(value, None)).total().piecewise()
}

const fn binary(name: &'static str, value: fn(f64, f64) -> f64, domain: [f64; 2], slopes: Slopes) -> Row {
    row(name, domain, Rule::Binary(value, slopes))
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
    unary("sin", f64::sin, [-9.0, 9.0], |g, x, _| g.call("cos", x)).total().with_fast("fast_sin").odd().on(Kernel),
    unary("cos", f64::cos, [-9.0, 9.0], |g, x, _| {
        let sine = g.call("sin", x);
        g.neg(sine)
    })
    .total()
    .with_fast("fast_cos")
    .even()
    .of_square()
    .on(Kernel),
    unary("tan", f64::tan, [-1.4, 1.4], |g, _, y| one_plus_square(g, y)).total().with_fast("fast_tan").odd().on(Kernel),
    unary("asin", f64::asin, [-0.9, 0.9], |g, x, _| {
        let square = one_minus_square(g, x);
        g.power(square, -1)
    })
    .with_fast("fast_asin")
    .odd()
    .on(Kernel),
    unary("acos", f64::acos, [-0.9, 0.9], |g, x, _| {
        let square = one_minus_square(g, x);
        let slope = g.power(square, -1);
        g.neg(slope)
    })
    .with_fast("fast_acos")
    .never_negative()
    .on(Kernel),
    unary("atan", f64::atan, [-9.0, 9.0], |g, x, _| {
        let square = one_plus_square(g, x);
        over(g, square)
    })
    .total()
    .with_fast("fast_atan")
    .odd()
    .levels_off()
    .on(Kernel),
    unary("sinh", f64::sinh, [-3.0, 3.0], |g, x, _| g.call("cosh", x)).total().odd().overflows().on(Library),
    unary("cosh", f64::cosh, [-3.0, 3.0], |g, x, _| g.call("sinh", x))
        .total()
        .even()
        .never_negative()
        .overflows()
        .of_square()
        .on(Library),
    unary("tanh", f64::tanh, [-3.0, 3.0], |g, x, _| {
        let cosine = g.call("cosh", x);
        let square = g.power(cosine, 4);
        let slope = over(g, square);
        g.zero_beyond(square, slope)
    })
    .total()
    .with_fast("fast_tanh")
    .odd()
    .levels_off()
    .on(Kernel),
    unary("asinh", f64::asinh, [-9.0, 9.0], |g, x, _| {
        let square = one_plus_square(g, x);
        g.power(square, -1)
    })
    .total()
    .odd()
    .on(Library),
    unary("acosh", f64::acosh, [1.1, 9.0], |g, x, _| {
        let one = g.constant(1.0);
        let (minus, plus) = (g.sub(x, one), g.add(x, one));
        let square = g.mul(minus, plus);
        g.power(square, -1)
    })
    .never_negative()
    .on(Library),
    unary("atanh", f64::atanh, [-0.9, 0.9], |g, x, _| {
        let square = one_minus_square(g, x);
        over(g, square)
    })
    .odd()
    .on(Library),
    unary("exp", f64::exp, [-3.0, 3.0], |_, _, y| y)
        .total()
        .with_fast("fast_exp")
        .never_negative()
        .overflows()
        .on(Kernel),
    unary("exp2", f64::exp2, [-3.0, 3.0], |g, _, y| {
        let scale = g.constant(std::f64::consts::LN_2);
        g.mul(scale, y)
    })
    .total()
    .never_negative()
    .overflows()
    .on(Library),
    unary("exp_m1", f64::exp_m1, [-3.0, 3.0], |g, x, _| g.call("exp", x)).total().overflows().on(Library),
    unary("ln", f64::ln, [0.1, 9.0], |g, x, _| over(g, x)).with_fast("fast_ln").on(Kernel),
    unary("ln_1p", f64::ln_1p, [-0.9, 9.0], |g, x, _| {
        let one = g.constant(1.0);
        let shifted = g.add(x, one);
        over(g, shifted)
    })
    .with_fast("fast_ln_1p")
    .on(Kernel),
    unary("log2", f64::log2, [0.1, 9.0], |g, x, _| scaled_reciprocal(g, x, std::f64::consts::LOG2_E)).on(Library),
    unary("log10", f64::log10, [0.1, 9.0], |g, x, _| scaled_reciprocal(g, x, std::f64::consts::LOG10_E)).on(Library),
    unary("cbrt", f64::cbrt, [0.1, 9.0], |g, _, y| {
        let (square, three) = (g.power(y, -4), g.constant(3.0));
        g.div(square, three)
    })
    .with_fast("fast_cbrt")
    .odd()
    .on(Kernel),
    unary("abs", f64::abs, [0.1, 9.0], |g, x, _| g.call("signum", x))
        .total()
        .even()
        .never_negative()
        .piecewise()
        .on(Exact),
    binary("min", f64::min, [0.2, 4.0], |g, a, b, _| {
        let first = is_minimum(g, a, b);
        of_chosen(g, first)
    })
    .choosing(is_minimum)
    .total()
    .commutative()
    .piecewise()
    .on(Exact),
    binary("max", f64::max, [0.2, 4.0], |g, a, b, _| {
        let first = is_maximum(g, a, b);
        of_chosen(g, first)
    })
    .choosing(is_maximum)
    .total()
    .commutative()
    .piecewise()
    .on(Exact),
    step("signum", f64::signum, [0.1, 9.0]).odd().on(Exact),
    step("floor", f64::floor, [0.1, 9.0]).on(Exact),
    step("ceil", f64::ceil, [-9.0, 0.1]).on(Exact),
    step("trunc", f64::trunc, [0.1, 9.0]).odd().on(Exact),
    step("round", f64::round, [-9.0, 0.1]).odd().on(Exact),
    step("round_ties_even", f64::round_ties_even, [-9.0, 0.1]).odd().on(Exact),
    binary(
        "remainder",
        |x, y| x % y,
        [2.0, 9.0],
        |g, a, b, _| {
            let quotient = g.div(a, b);
            let whole = g.call("trunc", quotient);
            [g.constant(1.0), g.neg(whole)]
        },
    )
    .odd()
    .piecewise()
    .on(Exact),
    binary("powf", f64::powf, [0.2, 4.0], |g, a, b, y| {
        let one = g.constant(1.0);
        let (less, logarithm) = (g.sub(b, one), g.call("ln", a));
        let less = if g.is_prepared(b) { from_zero(g, b, less) } else { less };
        let lowered = g.call_two("powf", a, less);
        [g.mul(b, lowered), g.mul(y, logarithm)]
    })
    .on(Kernel),
    binary("atan2", f64::atan2, [-4.0, -0.5], |g, a, b, _| {
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
    .with_fast("fast_atan2")
    .piecewise()
    .on(Kernel),
    binary("hypot", f64::hypot, [0.2, 4.0], |g, a, b, y| {
        let scale = over(g, y);
        [g.mul(scale, a), g.mul(scale, b)]
    })
    .even()
    .commutative()
    .never_negative()
    .piecewise()
    .on(Library),
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
}

#[cfg(test)]
mod tests;
