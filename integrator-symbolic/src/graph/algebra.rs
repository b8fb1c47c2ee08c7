//! The smart constructors; products have a separate file.
//!
//! Each rewrite is *exact* (bitwise identical), *finite* (identical for finite arguments) or *reassociating* (other
//! roundings, not more of them). Reassociating rewrites only collect numbers and parameters, which are then multiplied
//! once per run.
//!
//! Nothing hides a NaN: `0·x` and `x - x` remain, and a square root is removed only if its argument is a sum of
//! squares.

use super::{
    Element, Graph, Node, NodeId, ParameterId, Scope,
    function::{Function, Rule},
    index::{IndexId, LoopId},
};

impl Graph {
    pub(crate) fn constant(&mut self, value: f64) -> NodeId {
        self.intern(Node::Constant(value.to_bits()))
    }

    /// Declares that a parameter is never negative, before any node is made of it.
    pub(crate) fn declare_never_negative(&mut self, id: ParameterId) {
        self.never_negative.insert(id);
    }

    /// Declares that a parameter may be NaN where its value is not used, as the element of a list that is too short for
    /// it, before any node is made of it.
    pub(crate) fn declare_maybe_missing(&mut self, id: ParameterId) {
        self.maybe_missing.insert(id);
    }

    /// Declares that the runtime computes a parameter in every step, so that nothing made of it is prepared, before any node is
    /// made of it.
    pub(crate) fn declare_computed(&mut self, id: ParameterId) {
        self.computed.insert(id);
    }

    /// Declares that the entries of a table stay the same if rows and columns are exchanged, before any node is made of it.
    pub(crate) fn declare_symmetric(&mut self, table: ParameterId) {
        self.symmetric.insert(table);
    }

    /// Whether the entries of a table stay the same if rows and columns are exchanged.
    pub(crate) fn is_symmetric(&self, table: NodeId) -> bool {
        matches!(self.node(table), Node::Parameter(id) if self.symmetric.contains(&id))
    }

    /// The same of a parameter with the text of another one, if it was declared of that.
    pub(crate) fn declare_like(&mut self, id: ParameterId, other: ParameterId) {
        for declared in [&mut self.maybe_missing, &mut self.computed] {
            if declared.contains(&other) {
                declared.insert(id);
            }
        }
    }

    pub(crate) fn parameter(&mut self, id: ParameterId) -> NodeId {
        self.intern(Node::Parameter(id))
    }

    /// The entry of a table in a row and a column.
    pub(crate) fn entry(&mut self, table: ParameterId, row: NodeId, column: NodeId) -> NodeId {
        let table = self.parameter(table);
        self.intern(Node::Entry(table, row, column))
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
        let index = self.loops.plain(index);
        match self.loops.signed_literal(index) {
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

    /// Whether a value is the negative of another one, and that one.
    pub(crate) fn signed(&self, x: NodeId) -> (bool, NodeId) {
        match self.node(x) {
            Node::Neg(inner) => (true, inner),
            _ => (false, x),
        }
    }

    /// A value, or what it is the negative of.
    pub(crate) fn without_sign(&self, x: NodeId) -> NodeId {
        self.signed(x).1
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

    /// The sum of `body` over a loop; of what does not depend on the index, the number of iterations times it.
    pub(crate) fn sum(&mut self, by: LoopId, body: NodeId) -> NodeId {
        if self.as_constant(body) == Some(0.0) {
            return body;
        }
        let range = self.loops.get(by);
        let iterations = self.loops.span(range.from, range.to);
        if self.loops.literal(iterations) == Some(0) {
            return self.constant(0.0);
        }
        if self.loops_of(body).contains(by) {
            // exact: signs move outwards
            return match self.node(body) {
                Node::Neg(inner) => {
                    let sum = self.sum(by, inner);
                    self.neg(sum)
                }
                _ => {
                    let sum = self.intern(Node::Sum(by, body));
                    if self.is_kept_by_iterations(by, body) { self.where_entered(by, body, sum) } else { sum }
                }
            };
        }
        let iterations = self.number_of(iterations);
        let product = self.mul(iterations, body);
        // Where there is no iteration, nothing is added, whatever the body would be.
        if self.is_harmless(body, &[Scope::Loop(by)]) { product } else { self.where_entered(by, body, product) }
    }

    /// The value of a loop with some body, and zero where the loop has no iteration.
    fn where_entered(&mut self, by: LoopId, body: NodeId, value: NodeId) -> NodeId {
        let (entered, zero) = (self.has_iterations(by, body), self.constant(0.0));
        self.select(entered, value, zero)
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

    /// Division without simplification, to which powers are lowered.
    pub(crate) fn quotient(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.intern(Node::Div(a, b))
    }

    /// Multiplication without simplification, to which powers are lowered.
    pub(crate) fn times(&mut self, a: NodeId, b: NodeId) -> NodeId {
        self.intern(Node::Mul(a, b))
    }

    /// The square root, to which powers are lowered.
    pub(crate) fn root(&mut self, base: NodeId) -> NodeId {
        self.intern(Node::Power(base, 1))
    }

    /// A node with other children, as it stands.
    pub(crate) fn rebuilt(&mut self, node: Node) -> NodeId {
        self.intern(node)
    }
}

/// Whether a power is a product of factors and roots, few enough to be written out.
fn is_half_whole(exponent: f64) -> bool {
    (2.0 * exponent).fract() == 0.0 && exponent.abs() <= 64.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::graph::{Part, evaluate::Point, index::Index};

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
        (
            "2 (3 x - 5 y) == 6 x - 10 y",
            |g, [x, y, _]| {
                let [two, three, five] = [2.0, 3.0, 5.0].map(|number| g.constant(number));
                let [x, y] = [g.mul(three, x), g.mul(five, y)];
                let difference = g.sub(x, y);
                g.mul(two, difference)
            },
            |g, [x, y, _]| {
                let [six, ten] = [6.0, 10.0].map(|number| g.constant(number));
                let [x, y] = [g.mul(six, x), g.mul(ten, y)];
                g.sub(x, y)
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
            "hypot(x, y)^2 == x^2 + y^2",
            |g, [x, y, _]| {
                let distance = g.call_two("hypot", x, y);
                g.mul(distance, distance)
            },
            |g, [x, y, _]| {
                let [xx, yy] = [g.power(x, 4), g.power(y, 4)];
                g.add(xx, yy)
            },
        ),
        (
            "hypot(hypot(x, y), z)^3 == (x^2 + y^2 + z^2)^(3/2)",
            |g, [x, y, z]| {
                let in_plane = g.call_two("hypot", x, y);
                let distance = g.call_two("hypot", in_plane, z);
                g.power(distance, 6)
            },
            |g, [x, y, z]| {
                let [xx, yy, zz] = [g.power(x, 4), g.power(y, 4), g.power(z, 4)];
                let in_plane = g.add(xx, yy);
                let square = g.add(in_plane, zz);
                g.power(square, 3)
            },
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
