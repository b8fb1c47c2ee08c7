//! Antiderivatives with respect to one coordinate.
//!
//! Polynomials in the coordinate have one, and so have powers and some functions of what is linear in it with a slope of
//! parameters, and sums of all these times whatever does not read the coordinate.

use super::{Element, Graph, Node, NodeId};

/// Functions with an antiderivative in the table of elementary functions, and whether that has a minus sign.
const FUNCTIONS: [(&str, &str, bool); 5] = [
    ("sin", "cos", true),
    ("cos", "sin", false),
    ("exp", "exp", false),
    ("sinh", "cosh", false),
    ("cosh", "sinh", false),
];

/// The highest degree of a product that is expanded.
const EXPANDED: usize = 16;

impl Graph {
    /// The antiderivative of a value with respect to a coordinate, or the term that has none here.
    pub(super) fn antiderivative(&mut self, value: NodeId, by: Element) -> Result<NodeId, NodeId> {
        let coordinate = self.coordinate(by);
        let reads = self.reading_any(value, by);
        Integral { graph: self, coordinate, reads }.of(value)
    }

    /// For each node up to a value, by its position, whether it reads what may be this coordinate.
    pub(super) fn reading_any(&self, value: NodeId, coordinate: Element) -> Vec<bool> {
        let mut reads = vec![false; value.position() + 1];
        for id in self.reachable([value]) {
            reads[id.position()] = match self.node(id) {
                Node::Coordinate(element) => self.may_be_conjugates(element, coordinate.partner()),
                node => node.children().any(|child| reads[child.position()]),
            };
        }
        reads
    }
}

struct Integral<'g> {
    graph: &'g mut Graph,
    coordinate: NodeId,
    /// Whether a node reads what may be the coordinate, by its position.
    reads: Vec<bool>,
}

impl Integral<'_> {
    fn is_constant(&self, id: NodeId) -> bool {
        !self.reads[id.position()]
    }

    fn of(&mut self, id: NodeId) -> Result<NodeId, NodeId> {
        if self.is_constant(id) {
            return Ok(self.graph.mul(id, self.coordinate));
        }
        Ok(match self.graph.node(id) {
            Node::Neg(a) => {
                let integral = self.of(a)?;
                self.graph.neg(integral)
            }
            Node::Add(a, b) => {
                let (a, b) = (self.of(a)?, self.of(b)?);
                self.graph.add(a, b)
            }
            Node::Mul(factor, a) | Node::Mul(a, factor) if self.is_constant(factor) => {
                let integral = self.of(a)?;
                self.graph.mul(factor, integral)
            }
            Node::Div(a, divisor) if self.is_constant(divisor) => {
                let integral = self.of(a)?;
                self.graph.div(integral, divisor)
            }
            Node::Sum(by, body) => {
                let integral = self.of(body)?;
                self.graph.sum(by, integral)
            }
            _ => self.of_linear(id).or_else(|| self.of_polynomial(id)).ok_or(id)?,
        })
    }

    /// That of a power or a function of what is linear in the coordinate.
    fn of_linear(&mut self, id: NodeId) -> Option<NodeId> {
        match self.graph.node(id) {
            // Without the reciprocal, whose antiderivative is a logarithm.
            Node::Power(a, halves) if halves != -2 => {
                let slope = self.slope(a)?;
                let (power, exponent) = (self.graph.power(a, halves + 2), f64::from(halves + 2) / 2.0);
                let exponent = self.graph.constant(exponent);
                let divisor = self.graph.mul(slope, exponent);
                Some(self.graph.div(power, divisor))
            }
            Node::Unary(function, a) => {
                let (_, integral, is_negative) = FUNCTIONS.iter().find(|(name, ..)| *name == function.name())?;
                let slope = self.slope(a)?;
                let value = self.graph.call(integral, a);
                let integral = self.graph.div(value, slope);
                Some(if *is_negative { self.graph.neg(integral) } else { integral })
            }
            _ => None,
        }
    }

    /// What multiplies the coordinate in a linear function of it, if that depends on parameters alone.
    fn slope(&mut self, id: NodeId) -> Option<NodeId> {
        match self.coefficients(id)?[..] {
            [_, slope] if self.graph.is_prepared(slope) && self.graph.as_constant(slope) != Some(0.0) => Some(slope),
            _ => None,
        }
    }

    fn of_polynomial(&mut self, id: NodeId) -> Option<NodeId> {
        let coefficients = self.coefficients(id)?;
        let mut integral = self.graph.constant(0.0);
        for (degree, coefficient) in (1..).zip(coefficients) {
            if !self.is_zero(coefficient) {
                let power = self.graph.power(self.coordinate, 2 * degree);
                let term = self.graph.mul(coefficient, power);
                let divisor = self.graph.constant(f64::from(degree));
                let term = self.graph.div(term, divisor);
                integral = self.graph.add(integral, term);
            }
        }
        Some(integral)
    }

    /// The coefficients of a polynomial in the coordinate, that of degree zero first.
    fn coefficients(&mut self, id: NodeId) -> Option<Vec<NodeId>> {
        if self.is_constant(id) {
            return Some(vec![id]);
        }
        if id == self.coordinate {
            return Some([0.0, 1.0].map(|number| self.graph.constant(number)).into());
        }
        match self.graph.node(id) {
            Node::Neg(a) => {
                let of_a = self.coefficients(a)?;
                Some(of_a.into_iter().map(|coefficient| self.graph.neg(coefficient)).collect())
            }
            Node::Add(a, b) => {
                let (mut sum, other) = (self.coefficients(a)?, self.coefficients(b)?);
                let zero = self.graph.constant(0.0);
                sum.resize(sum.len().max(other.len()), zero);
                for (sum, other) in sum.iter_mut().zip(other) {
                    *sum = self.graph.add(*sum, other);
                }
                Some(sum)
            }
            Node::Mul(a, b) => {
                let (a, b) = (self.coefficients(a)?, self.coefficients(b)?);
                self.product(&a, &b)
            }
            Node::Div(a, divisor) if self.is_constant(divisor) => {
                let of_a = self.coefficients(a)?;
                Some(of_a.into_iter().map(|coefficient| self.graph.div(coefficient, divisor)).collect())
            }
            Node::Power(a, halves) if halves > 0 && halves % 2 == 0 => {
                let of_a = self.coefficients(a)?;
                (1..halves / 2).try_fold(of_a.clone(), |power, _| self.product(&power, &of_a))
            }
            _ => None,
        }
    }

    fn product(&mut self, a: &[NodeId], b: &[NodeId]) -> Option<Vec<NodeId>> {
        let count = a.len() + b.len() - 1;
        if count > EXPANDED + 1 {
            return None;
        }
        let mut product = vec![self.graph.constant(0.0); count];
        for (first, a) in a.iter().enumerate() {
            for (second, b) in b.iter().enumerate() {
                if !self.is_zero(*a) && !self.is_zero(*b) {
                    let term = self.graph.mul(*a, *b);
                    product[first + second] = self.graph.add(product[first + second], term);
                }
            }
        }
        Some(product)
    }

    fn is_zero(&self, id: NodeId) -> bool {
        self.graph.as_constant(id) == Some(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        differentiate::gradient,
        graph::{ParameterId, Part, evaluate::Point, index::Index},
    };

    /// Builds a value from `q0`, `q1` and a parameter.
    type Build = fn(&mut Graph, [NodeId; 3]) -> NodeId;

    const INTEGRABLE: [(&str, Build); 8] = [
        ("q1", |_, [_, y, _]| y),
        ("q0^3 sin(q1) / k", |g, [x, y, k]| {
            let (cube, sine) = (g.power(x, 6), g.call("sin", y));
            let product = g.mul(cube, sine);
            g.div(product, k)
        }),
        ("q0 (q1 - q0 (k + q0))", |g, [x, y, k]| {
            let sum = g.add(k, x);
            let product = g.mul(x, sum);
            let difference = g.sub(y, product);
            g.mul(x, difference)
        }),
        ("-q1 sin(k q0 + q1)", |g, [x, y, k]| {
            let phase = g.mul(k, x);
            let phase = g.add(phase, y);
            let sine = g.call("sin", phase);
            let product = g.mul(y, sine);
            g.neg(product)
        }),
        ("cos(k (q0 - q1)) + exp(-q0)", |g, [x, y, k]| {
            let difference = g.sub(x, y);
            let phase = g.mul(k, difference);
            let minus = g.neg(x);
            let (cosine, decay) = (g.call("cos", phase), g.call("exp", minus));
            g.add(cosine, decay)
        }),
        ("sinh(q0 / k) cosh(q1) + cosh(2 q0)", |g, [x, y, k]| {
            let (quotient, two) = (g.div(x, k), g.constant(2.0));
            let double = g.mul(two, x);
            let (a, b, c) = (g.call("sinh", quotient), g.call("cosh", y), g.call("cosh", double));
            let product = g.mul(a, b);
            g.add(product, c)
        }),
        ("(q0 + q1)^5", |g, [x, y, _]| {
            let sum = g.add(x, y);
            g.power(sum, 10)
        }),
        ("sqrt(q0 + q1) + 1 / (q0 + q1)^2", |g, [x, y, _]| {
            let sum = g.add(x, y);
            let (root, inverse) = (g.power(sum, 1), g.power(sum, -4));
            g.add(root, inverse)
        }),
    ];

    const OTHERS: [(&str, Build); 4] = [
        ("1 / q0", |g, [x, ..]| g.power(x, -2)),
        ("sin(q0 q1)", |g, [x, y, _]| {
            let product = g.mul(x, y);
            g.call("sin", product)
        }),
        ("q0 exp(q0)", |g, [x, ..]| {
            let exponential = g.call("exp", x);
            g.mul(x, exponential)
        }),
        ("tanh(q0)", |g, [x, ..]| g.call("tanh", x)),
    ];

    fn arguments(graph: &mut Graph) -> (Element, [NodeId; 3]) {
        let [x, y] = [0, 1].map(|index| {
            let index = graph.loops.intern(Index::Literal(index));
            Element { part: Part::Position, index, component: None }
        });
        (x, [graph.coordinate(x), graph.coordinate(y), graph.parameter(ParameterId(0))])
    }

    #[test]
    fn the_derivative_of_an_antiderivative_is_the_value() {
        for (name, build) in INTEGRABLE {
            let mut graph = Graph::default();
            let (by, arguments) = arguments(&mut graph);
            let value = build(&mut graph, arguments);
            let integral = graph.antiderivative(value, by).unwrap_or_else(|_| panic!("{name} has one"));
            for at in [[0.3, 0.7], [1.9, -0.4]] {
                let mut point = Point { parameters: &[1.7], ..Point::new(&at, &[]) };
                let slope: f64 = gradient(&mut graph, integral, Part::Position)
                    .into_iter()
                    .filter(|contribution| contribution.element == by)
                    .map(|contribution| point.value(&graph, contribution.value))
                    .sum();
                let expected = point.value(&graph, value);
                // A dozen roundings of numbers below 1000.
                assert!((slope - expected).abs() < 1e-11, "{name}: {slope} and not {expected}");
            }
        }
    }

    #[test]
    fn others_are_named() {
        for (name, build) in OTHERS {
            let mut graph = Graph::default();
            let (by, arguments) = arguments(&mut graph);
            let (other, linear) = (build(&mut graph, arguments), graph.mul(arguments[0], arguments[1]));
            let sum = graph.sub(linear, other);
            assert_eq!(graph.antiderivative(sum, by), Err(other), "{name}");
        }
    }
}
