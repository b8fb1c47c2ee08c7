//! The smart constructors. Each rewrite is *exact* (the same bits), *finite* (the same for finite arguments) or
//! *reassociating* (other roundings, as many or fewer); the last kind only gathers numbers and parameters, so that they
//! are multiplied once per run.
//!
//! Nothing hides a NaN: `0·x` and `x - x` stay, and a square root is only undone under a sum of squares.

use super::{
    Element, ExternalId, Graph, Node, NodeId, ParameterId,
    function::{Function, Rule},
    index::{Index, IndexId, LoopId},
};

impl Graph {
    pub(crate) fn constant(&mut self, value: f64) -> NodeId {
        self.intern(Node::Constant(value.to_bits()))
    }

    pub(crate) fn parameter(&mut self, id: ParameterId) -> NodeId {
        self.intern(Node::Parameter(id))
    }

    pub(crate) fn coordinate(&mut self, element: Element) -> NodeId {
        self.intern(Node::Coordinate(element))
    }

    pub(crate) fn time(&mut self) -> NodeId {
        self.intern(Node::Time)
    }

    pub(crate) fn step(&mut self) -> NodeId {
        self.intern(Node::Step)
    }

    /// An integer as a number.
    pub(crate) fn number_of(&mut self, index: IndexId) -> NodeId {
        match self.loops.literal(index) {
            Some(value) => self.constant(value as f64),
            None => self.intern(Node::FromIndex(index)),
        }
    }

    /// A change of sign. It stays outside of products, so that equal products of either sign are one node.
    pub(crate) fn neg(&mut self, x: NodeId) -> NodeId {
        match self.node(x) {
            // exact: -(c) is a number, and --x == x
            Node::Constant(bits) => self.constant(-f64::from_bits(bits)),
            Node::Neg(inner) => inner,
            _ => self.intern(Node::Neg(x)),
        }
    }

    pub(crate) fn add(&mut self, a: NodeId, b: NodeId) -> NodeId {
        match (self.as_constant(a), self.as_constant(b)) {
            (Some(a), Some(b)) => return self.constant(a + b),
            // finite: 0 + x == x
            (Some(0.0), None) => return b,
            (None, Some(0.0)) => return a,
            _ => {}
        }
        if a == b {
            // exact: x + x == 2 x
            let two = self.constant(2.0);
            return self.mul(two, a);
        }
        match (self.node(a), self.node(b)) {
            // exact: -x - y == -(x + y), and the sign goes to the right
            (Node::Neg(x), Node::Neg(y)) => {
                let sum = self.add(x, y);
                self.neg(sum)
            }
            (Node::Neg(_), _) => self.intern(Node::Add(b, a)),
            (_, Node::Neg(_)) => self.intern(Node::Add(a, b)),
            // exact: addition commutes; one order, so that equal sums meet, with numbers on the right
            (Node::Constant(_), _) => self.intern(Node::Add(b, a)),
            (_, Node::Constant(_)) => self.intern(Node::Add(a, b)),
            _ => self.intern(Node::Add(a.min(b), a.max(b))),
        }
    }

    pub(crate) fn sub(&mut self, a: NodeId, b: NodeId) -> NodeId {
        let b = self.neg(b);
        self.add(a, b)
    }

    /// A product. Numbers are gathered from both sides and put, with parameters, at the far left, where they are
    /// multiplied once per run.
    pub(crate) fn mul(&mut self, a: NodeId, b: NodeId) -> NodeId {
        if let (Some(a), Some(b)) = (self.as_constant(a), self.as_constant(b)) {
            return self.constant(a * b);
        }
        // exact: signs move outwards
        match (self.node(a), self.node(b)) {
            (Node::Neg(x), Node::Neg(y)) => return self.mul(x, y),
            (Node::Neg(x), _) => {
                let product = self.mul(x, b);
                return self.neg(product);
            }
            (_, Node::Neg(y)) => {
                let product = self.mul(a, y);
                return self.neg(product);
            }
            _ => {}
        }
        // reassociating: (c x)(d y) == (c d)(x y)
        let ((c, x), (d, y)) = (self.strip(a), self.strip(b));
        let product = match (x, y) {
            (Some(x), Some(y)) => self.product(x, y),
            (Some(rest), None) | (None, Some(rest)) => rest,
            (None, None) => return self.constant(c * d),
        };
        self.scaled(c * d, product)
    }

    /// A quotient. By a number it stays one, so that `3x/3` can cancel; by anything else it is a negative power.
    pub(crate) fn div(&mut self, a: NodeId, b: NodeId) -> NodeId {
        let Some(divisor) = self.as_constant(b) else {
            // reassociating by one rounding at most: a / (c x) == (a / c) (1 / x); a / x is printed as a division
            let (scale, rest) = self.strip(b);
            return match rest {
                Some(rest) if scale != 1.0 && scale != 0.0 && !self.is_prepared(rest) => {
                    let scale = self.constant(scale);
                    let scaled = self.div(a, scale);
                    self.div(scaled, rest)
                }
                _ => {
                    let reciprocal = self.power(b, -2);
                    self.mul(a, reciprocal)
                }
            };
        };
        // exact: a number or a coefficient is divided where the quotient is a number without rounding
        let (scale, rest) = self.strip(a);
        if let Some(quotient) = exact_quotient(scale, divisor) {
            return match rest {
                Some(rest) => self.scaled(quotient, rest),
                None => self.constant(quotient),
            };
        }
        self.intern(Node::Div(a, b))
    }

    /// `base` to the power of `halves / 2`.
    pub(crate) fn power(&mut self, base: NodeId, halves: i32) -> NodeId {
        match (halves, self.node(base)) {
            (0, _) => self.constant(1.0),
            (2, _) => base,
            (-2, Node::Constant(_)) => {
                let one = self.constant(1.0);
                self.div(one, base)
            }
            // exact: (-x)^2 == x^2 and (-x)^3 == -(x^3)
            (_, Node::Neg(x)) if halves % 4 == 0 => self.power(x, halves),
            (_, Node::Neg(x)) if halves % 2 == 0 => {
                let power = self.power(x, halves);
                self.neg(power)
            }
            // finite: (x^a)^b == x^(a b) where b is whole, and a is not a root that b would undo
            (_, Node::Power(x, inner)) if halves % 2 == 0 && (inner % 2 == 0 || self.is_square_sum(x)) => {
                match inner.checked_mul(halves / 2) {
                    Some(product) => self.power(x, product),
                    None => self.intern(Node::Power(base, halves)),
                }
            }
            _ => self.intern(Node::Power(base, halves)),
        }
    }

    /// The function of the table with this name, of one argument.
    pub(crate) fn call(&mut self, name: &str, x: NodeId) -> NodeId {
        match Function::named(name) {
            Some(function) => self.unary(function, x),
            None => x,
        }
    }

    /// The function of the table with this name, of two arguments.
    pub(crate) fn call_two(&mut self, name: &str, a: NodeId, b: NodeId) -> NodeId {
        match Function::named(name) {
            Some(function) => self.binary(function, a, b),
            None => a,
        }
    }

    /// A function of one argument; of a number, its value.
    pub(crate) fn unary(&mut self, function: Function, x: NodeId) -> NodeId {
        if let (Rule::Unary(value, _), Some(x)) = (function.row().rule, self.as_constant(x)) {
            return self.constant(value(x));
        }
        self.intern(Node::Unary(function, x))
    }

    /// A function of two arguments; powers with a whole or half number become multiplications and roots.
    pub(crate) fn binary(&mut self, function: Function, a: NodeId, b: NodeId) -> NodeId {
        let (first, second) = (self.as_constant(a), self.as_constant(b));
        if let (Rule::Binary(value, _), Some(a), Some(b)) = (function.row().rule, first, second) {
            return self.constant(value(a, b));
        }
        match second {
            Some(exponent) if function.name() == "powf" && is_half_whole(exponent) => {
                self.power(a, (2.0 * exponent) as i32)
            }
            _ => self.intern(Node::Binary(function, a, b)),
        }
    }

    /// A method of the user whose derivatives are not known yet.
    pub(crate) fn declare_external(&mut self) -> ExternalId {
        self.externals.push([None; 2]);
        ExternalId(self.externals.len() as u32 - 1)
    }

    /// States which methods give the derivatives of a method.
    pub(crate) fn derive_external(&mut self, id: ExternalId, slopes: [Option<ExternalId>; 2]) {
        self.externals[id.0 as usize] = slopes;
    }

    /// The methods that give the derivatives of a method.
    pub(crate) fn external_slopes(&self, id: ExternalId) -> [Option<ExternalId>; 2] {
        self.externals[id.0 as usize]
    }

    /// A method of the user, of one argument or two.
    pub(crate) fn external(&mut self, id: ExternalId, a: NodeId, b: Option<NodeId>) -> NodeId {
        self.intern(match b {
            None => Node::External(id, a),
            Some(b) => Node::ExternalTwo(id, a, b),
        })
    }

    /// The sum of `body` over a loop; of what does not depend on the index, the number of turns times it.
    pub(crate) fn sum(&mut self, by: LoopId, body: NodeId) -> NodeId {
        if self.as_constant(body) == Some(0.0) {
            return body;
        }
        if self.loops_of(body).contains(by) {
            // exact: signs move outwards
            return match self.node(body) {
                Node::Neg(inner) => {
                    let sum = self.sum(by, inner);
                    self.neg(sum)
                }
                _ => self.intern(Node::Sum(by, body)),
            };
        }
        let range = self.loops.get(by);
        let turns = self.loops.intern(Index::Sub(range.to, range.from));
        let turns = self.number_of(turns);
        self.mul(turns, body)
    }

    /// The derivative of a function of one argument, if it is not zero.
    pub(crate) fn slope(&mut self, function: Function, x: NodeId, y: NodeId) -> Option<NodeId> {
        match function.row().rule {
            Rule::Unary(_, slope) => slope.map(|slope| slope(self, x, y)),
            Rule::Binary(..) => None,
        }
    }

    /// The derivatives of a function of two arguments.
    pub(crate) fn slopes(&mut self, function: Function, a: NodeId, b: NodeId, y: NodeId) -> [Option<NodeId>; 2] {
        match function.row().rule {
            Rule::Binary(_, slopes) => slopes(self, a, b, y).map(Some),
            Rule::Unary(..) => [None, None],
        }
    }

    /// Division as such, without a look at what it divides: for what powers are lowered to.
    pub(crate) fn quotient(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.intern(Node::Div(a, b))
    }

    /// Multiplication as such, without a look at what it multiplies: for what powers are lowered to.
    pub(crate) fn times(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.intern(Node::Mul(a, b))
    }

    /// The square root, for what powers are lowered to.
    pub(crate) fn root(&mut self, base: NodeId) -> NodeId {
        self.intern(Node::Power(base, 1))
    }

    /// A node with other children, as it stands.
    pub(crate) fn rebuilt(&mut self, node: Node) -> NodeId {
        self.intern(node)
    }

    /// The product of two factors without numbers.
    fn product(&mut self, a: NodeId, b: NodeId) -> NodeId {
        if let Some(merged) = self.merged_powers(a, b) {
            return merged;
        }
        match (self.is_prepared(a), self.is_prepared(b)) {
            // reassociating: x (k y) stays; k (l y) == (k l) y and (k x) l == (k l) x
            (true, false) => self.scaled_by(a, b),
            (false, true) => self.scaled_by(b, a),
            (true, true) => self.intern(Node::Mul(a, b)),
            // exact: multiplication commutes; a product keeps its own left side so that x y x grows to the right
            (false, false) => match (self.node(a), self.node(b)) {
                (Node::Mul(..), _) => self.intern(Node::Mul(a, b)),
                (_, Node::Mul(..)) => self.intern(Node::Mul(b, a)),
                _ => self.intern(Node::Mul(a.min(b), a.max(b))),
            },
        }
    }

    /// finite: x^a x^b == x^(a+b), for exponents of one sign that do not undo a root.
    fn merged_powers(&mut self, a: NodeId, b: NodeId) -> Option<NodeId> {
        let exponent = |id| match self.node(id) {
            Node::Power(base, halves) => (base, halves),
            _ => (id, 2),
        };
        let ((base, first), (other, second)) = (exponent(a), exponent(b));
        let undoes = first % 2 != 0 && second % 2 != 0 && !self.is_square_sum(base);
        if base != other || first.signum() != second.signum() || undoes {
            return None;
        }
        Some(self.power(base, first.checked_add(second)?))
    }

    /// Whether a node is a sum of even powers and numbers that are not negative, so never below zero.
    fn is_square_sum(&self, id: NodeId) -> bool {
        match self.node(id) {
            Node::Power(_, halves) => halves % 4 == 0,
            Node::Constant(bits) => f64::from_bits(bits) >= 0.0,
            Node::Add(a, b) => self.is_square_sum(a) && self.is_square_sum(b),
            Node::Sum(_, body) => self.is_square_sum(body),
            _ => false,
        }
    }

    /// A product as a number times the rest; `1` and the node itself where there is no number.
    fn strip(&mut self, id: NodeId) -> (f64, Option<NodeId>) {
        match self.node(id) {
            Node::Constant(bits) => (f64::from_bits(bits), None),
            Node::Mul(a, b) => match self.strip(a) {
                (1.0, _) => (1.0, Some(id)),
                (scale, None) => (scale, Some(b)),
                (scale, Some(rest)) => {
                    let rest = self.product(rest, b);
                    (scale, Some(rest))
                }
            },
            _ => (1.0, Some(id)),
        }
    }

    /// A number times a node without one.
    fn scaled(&mut self, scale: f64, rest: NodeId) -> NodeId {
        match scale {
            1.0 => rest,
            // exact: (-c) x == -(c x)
            _ if scale.is_sign_negative() => {
                let product = self.scaled(-scale, rest);
                self.neg(product)
            }
            _ => {
                let scale = self.constant(scale);
                self.scaled_by(scale, rest)
            }
        }
    }

    /// A number or parameter times a node, put at the far left of the node's factors.
    fn scaled_by(&mut self, scale: NodeId, rest: NodeId) -> NodeId {
        match (self.node(rest), self.as_constant(scale)) {
            (Node::Neg(inner), _) => {
                let product = self.scaled_by(scale, inner);
                self.neg(product)
            }
            (Node::Mul(a, b), _) => {
                let left = self.scaled_by(scale, a);
                match self.as_constant(left) {
                    Some(number) => self.scaled(number, b),
                    None => self.intern(Node::Mul(left, b)),
                }
            }
            (Node::Div(numerator, divisor), Some(number)) => {
                // exact: c (x / d) == (c/d) x where c/d is a number without rounding
                let quotient = self.as_constant(divisor).and_then(|divisor| exact_quotient(number, divisor));
                match quotient {
                    Some(quotient) => {
                        let quotient = self.constant(quotient);
                        self.mul(quotient, numerator)
                    }
                    None => self.intern(Node::Mul(scale, rest)),
                }
            }
            _ => self.intern(Node::Mul(scale, rest)),
        }
    }

    /// The step times a node: at the far left of its factors, beside what is shared or prepared.
    pub(crate) fn stepped(&mut self, x: NodeId) -> NodeId {
        let step = self.step();
        match self.node(x) {
            Node::Neg(inner) => {
                let update = self.stepped(inner);
                self.intern(Node::Neg(update))
            }
            Node::Mul(a, b) if !self.is_prepared(x) => {
                let left = self.stepped(a);
                self.intern(Node::Mul(left, b))
            }
            _ if self.as_constant(x) == Some(1.0) => step,
            _ => self.intern(Node::Mul(step, x)),
        }
    }
}

/// Whether a power is a product of factors and roots, few enough to be written out.
fn is_half_whole(exponent: f64) -> bool {
    (2.0 * exponent).fract() == 0.0 && exponent.abs() <= 64.0
}

/// `a / b`, if it is a number without rounding.
fn exact_quotient(a: f64, b: f64) -> Option<f64> {
    let quotient = a / b;
    (quotient.is_finite() && (-quotient).mul_add(b, a) == 0.0).then_some(quotient)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::graph::{Part, evaluate::Point};

    fn coordinates(graph: &mut Graph) -> [NodeId; 3] {
        [0, 1, 2].map(|position| {
            let index = graph.loops.intern(Index::Literal(position));
            graph.coordinate(Element { part: Part::Position, index, component: None })
        })
    }

    type Build = fn(&mut Graph, [NodeId; 3]) -> NodeId;

    /// What is built on the left is the very node on the right.
    const REWRITES: &[(&str, Build, Build)] = &[
        (
            "--x == x",
            |g, [x, ..]| {
                let n = g.neg(x);
                g.neg(n)
            },
            |_, [x, ..]| x,
        ),
        ("x + y == y + x", |g, [x, y, _]| g.add(y, x), |g, [x, y, _]| g.add(x, y)),
        ("x y == y x", |g, [x, y, _]| g.mul(y, x), |g, [x, y, _]| g.mul(x, y)),
        (
            "x + x == 2 x",
            |g, [x, ..]| g.add(x, x),
            |g, [x, ..]| {
                let two = g.constant(2.0);
                g.mul(two, x)
            },
        ),
        (
            "x + 0 == x",
            |g, [x, ..]| {
                let zero = g.constant(0.0);
                g.add(x, zero)
            },
            |_, [x, ..]| x,
        ),
        (
            "x 1 == x",
            |g, [x, ..]| {
                let one = g.constant(1.0);
                g.mul(x, one)
            },
            |_, [x, ..]| x,
        ),
        (
            "(-x) y == -(x y)",
            |g, [x, y, _]| {
                let n = g.neg(x);
                g.mul(n, y)
            },
            |g, [x, y, _]| {
                let m = g.mul(x, y);
                g.neg(m)
            },
        ),
        ("x x == x^2", |g, [x, ..]| g.mul(x, x), |g, [x, ..]| g.power(x, 4)),
        (
            "x^2 x == x^3",
            |g, [x, ..]| {
                let s = g.power(x, 4);
                g.mul(s, x)
            },
            |g, [x, ..]| g.power(x, 6),
        ),
        (
            "(-x)^3 == -(x^3)",
            |g, [x, ..]| {
                let n = g.neg(x);
                g.power(n, 6)
            },
            |g, [x, ..]| {
                let cube = g.power(x, 6);
                g.neg(cube)
            },
        ),
        (
            "(-x)^2 == x^2",
            |g, [x, ..]| {
                let n = g.neg(x);
                g.power(n, 4)
            },
            |g, [x, ..]| g.power(x, 4),
        ),
        (
            "3 x / 3 == x",
            |g, [x, ..]| {
                let three = g.constant(3.0);
                let m = g.mul(three, x);
                g.div(m, three)
            },
            |_, [x, ..]| x,
        ),
        (
            "3 (x / 3) == x",
            |g, [x, ..]| {
                let three = g.constant(3.0);
                let d = g.div(x, three);
                g.mul(three, d)
            },
            |_, [x, ..]| x,
        ),
        (
            "(2 x)(y/2) == x y",
            |g, [x, y, _]| {
                let two = g.constant(2.0);
                let (a, b) = (g.mul(two, x), g.div(y, two));
                g.mul(a, b)
            },
            |g, [x, y, _]| g.mul(x, y),
        ),
    ];

    #[test]
    fn rewrites_lead_to_one_node() {
        for (name, left, right) in REWRITES {
            let mut graph = Graph::default();
            let at = coordinates(&mut graph);
            let (left, right) = (left(&mut graph, at), right(&mut graph, at));
            assert_eq!(graph.node(left), graph.node(right), "{name}");
        }
    }

    /// What is not finite stays not finite: evaluated at a point where the user's formula has no value.
    const NOT_HIDDEN: &[(&str, Build, f64)] = &[
        ("x - x", |g, [x, ..]| g.sub(x, x), f64::INFINITY),
        (
            "0 x",
            |g, [x, ..]| {
                let zero = g.constant(0.0);
                g.mul(zero, x)
            },
            f64::INFINITY,
        ),
        ("x / x", |g, [x, ..]| g.div(x, x), 0.0),
        (
            "sqrt(x) sqrt(x)",
            |g, [x, ..]| {
                let root = g.power(x, 1);
                g.mul(root, root)
            },
            -1.0,
        ),
        (
            "sqrt(x)^2",
            |g, [x, ..]| {
                let root = g.power(x, 1);
                g.power(root, 4)
            },
            -1.0,
        ),
        (
            "x^2 / x",
            |g, [x, ..]| {
                let square = g.power(x, 4);
                g.div(square, x)
            },
            0.0,
        ),
    ];

    #[test]
    fn nothing_hides_a_nan() {
        for (name, build, at) in NOT_HIDDEN {
            let mut graph = Graph::default();
            let coordinates = coordinates(&mut graph);
            let node = build(&mut graph, coordinates);
            let value = Point::new(&[*at, 1.0, 1.0], &[]).value(&graph, node);
            assert!(value.is_nan(), "{name} at {at} is {value}");
        }
    }

    #[test]
    fn a_root_is_undone_under_a_sum_of_squares() {
        let mut graph = Graph::default();
        let [x, y, _] = coordinates(&mut graph);
        let (xx, yy) = (graph.power(x, 4), graph.power(y, 4));
        let square = graph.add(xx, yy);
        let root = graph.power(square, 1);
        assert_eq!(graph.mul(root, root), square);
        let (inverse, cube) = (graph.power(square, -1), graph.power(square, -2));
        let product = graph.mul(inverse, cube);
        assert_eq!(graph.node(product), Node::Power(square, -3));
    }

    #[test]
    fn numbers_and_parameters_gather_at_the_left() {
        let mut graph = Graph::default();
        let [x, y, _] = coordinates(&mut graph);
        let k = graph.parameter(ParameterId(0));
        let two = graph.constant(2.0);
        let product = graph.mul(x, y);
        let scaled = graph.mul(product, k);
        let doubled = graph.mul(scaled, two);
        let Node::Mul(left, _) = graph.node(doubled) else { panic!("a product") };
        let Node::Mul(coefficient, _) = graph.node(left) else { panic!("a product") };
        assert!(graph.is_prepared(coefficient), "2 k is computed once per run");
        let update = graph.stepped(doubled);
        let Node::Mul(left, _) = graph.node(update) else { panic!("a product") };
        let Node::Mul(stepped, _) = graph.node(left) else { panic!("a product") };
        let step = graph.step();
        assert_eq!(graph.node(stepped), Node::Mul(step, coefficient));
    }
}
