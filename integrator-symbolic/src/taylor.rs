//! Recurrences for the Taylor coefficients of a motion.
//!
//! In: gradients. Out: values, with the auxiliary nodes from which their coefficients are computed. Always true: a
//! node's coefficient of an order is computed from coefficients of its children up to this order, and from its own
//! lower ones and those of the slopes. One pass over the nodes, children first, hence computes an order.
//!
//! Sums, differences and products with prepared numbers are linear: their coefficients follow from those of their
//! children. For other functions `y = f(x)`, with the slope `g = f'(x)` from the table of elementary functions,
//! `y' = g x'` gives `k yₖ = Σ j xⱼ gₖ₋ⱼ`. The column of derivatives is hence the column of recurrences. A number that
//! is added to a series is its coefficient of order 0: it is multiplied by [`Node::Step`], which is one at order 0 and
//! zero at all others.

mod inverse_mass;

pub(crate) use inverse_mass::inverse_masses;

use crate::{
    differentiate::Contribution,
    graph::{Graph, Node, NodeId, Scope, function::Function, like_terms::with_like_terms_collected},
};
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// The number of orders that the runtime compiles one by one, its `HIGHEST`.
const ORDERS: usize = 28;

/// The series that recurrences read beside the values themselves.
#[derive(Debug, Default)]
pub(crate) struct Recurrences {
    /// The slopes of each node that is a function of another one or of two, by its arguments; those of numbers are
    /// `None`.
    pub(crate) slopes: BTreeMap<NodeId, [Option<NodeId>; 2]>,
    /// The nodes whose coefficients of all orders a node is computed from, itself perhaps among them.
    pub(crate) operands: BTreeMap<NodeId, Vec<NodeId>>,
    /// The nodes of which all coefficients are kept, because others are computed from lower ones.
    pub(crate) kept: BTreeSet<NodeId>,
    /// The nodes that have a recurrence of their own.
    pub(crate) nonlinear: BTreeSet<NodeId>,
}

impl Recurrences {
    /// Takes the values of gradients apart into addends, collects like terms where that leaves fewer products, and finds what
    /// coefficients are computed from.
    pub(crate) fn of(graph: &mut Graph, gradients: [&mut Vec<Contribution>; 2]) -> Self {
        let mut as_written = gradients.each_ref().map(|gradient| {
            let addends = gradient.iter().flat_map(|contribution| addends(graph, contribution.clone()));
            addends.collect::<Vec<_>>()
        });
        let values: Vec<_> = as_written.iter().flatten().flat_map(Contribution::values).collect();
        let known = with_like_terms_collected(graph, &values);
        let mut collected = as_written
            .each_ref()
            .map(|addends| addends.iter().map(|addend| addend.mapped(|id| known[&id])).collect::<Vec<_>>());
        let [of_written, of_collected] =
            [&mut as_written, &mut collected].map(|addends| Self::of_addends(graph, addends));
        // Where no product is saved, prepared factors stay where they were written, and fewer may be multiplied there.
        let (found, chosen) = match of_collected.products(graph) < of_written.products(graph) {
            true => (of_collected, collected),
            false => (of_written, as_written),
        };
        for (gradient, chosen) in gradients.into_iter().zip(chosen) {
            *gradient = chosen;
        }
        found
    }

    /// Rewrites addends, and finds what their coefficients are computed from.
    fn of_addends(graph: &mut Graph, addends: &mut [Vec<Contribution>; 2]) -> Self {
        let mut found = Self::default();
        let mut rewriting = HashMap::new();
        let mut open = Vec::new();
        let values: Vec<_> = addends.iter().flatten().flat_map(Contribution::values).collect();
        rewrite_all(graph, values, &mut rewriting);
        for addend in addends.iter_mut().flatten() {
            *addend = addend.mapped(|id| rewriting[&id]);
            addend.value = at_order_zero(graph, addend.value);
            open.extend(addend.values());
        }
        let mut seen = BTreeSet::new();
        while let Some(id) = open.pop() {
            if graph.is_prepared(id) || !seen.insert(id) {
                continue;
            }
            open.extend(graph.node(id).children());
            open.extend(found.read(graph, id, &mut rewriting));
        }
        found
    }

    /// The number of products that an order sums, in halves of the order.
    fn products(&self, graph: &Graph) -> usize {
        let of = |id: &NodeId| match graph.node(*id) {
            // The products of a square are the same from both sides.
            Node::Power(_, 4) => 1,
            _ => 2 * self.slopes[id].iter().flatten().count().max(1),
        };
        self.nonlinear.iter().map(of).sum()
    }

    /// The number of operations in the code of all orders, where each is compiled on its own: sums of products, whose
    /// lengths are the orders, and the values themselves.
    pub(crate) fn operations_of_all_orders(&self, graph: &Graph) -> usize {
        let values = self.kept.union(&self.nonlinear).count();
        self.products(graph) * ORDERS * ORDERS / 4 + values * ORDERS
    }

    /// Notes what a node is computed from, and returns the slopes that come with it.
    fn read(&mut self, graph: &mut Graph, id: NodeId, rewriting: &mut HashMap<NodeId, NodeId>) -> Vec<NodeId> {
        let (operands, slopes) = match graph.node(id) {
            Node::Mul(a, b) if !graph.is_prepared(a) && !graph.is_prepared(b) => (vec![a, b], [None, None]),
            Node::Div(_, b) if !graph.is_prepared(b) => (vec![id, b], [None, None]),
            Node::Power(a, 4) => (vec![a], [None, None]),
            Node::Power(a, _) => (vec![id, a], [None, None]),
            Node::Unary(function, a) => (vec![a], [graph.slope(function, a, id), None]),
            Node::Binary(function, a, b) if is_power(function) && graph.is_prepared(b) => (vec![id, a], [None, None]),
            Node::Binary(function, a, b) => {
                let [of_a, of_b] = graph.slopes(function, a, b, id);
                let moves = |x: NodeId| !graph.is_prepared(x);
                (vec![a, b], [of_a.filter(|_| moves(a)), of_b.filter(|_| moves(b))])
            }
            _ => return Vec::new(),
        };
        self.nonlinear.insert(id);
        let slopes = slopes.map(|slope| {
            let slope = slope?;
            rewrite_all(graph, [slope], rewriting);
            Some(at_order_zero(graph, rewriting[&slope]))
        });
        self.slopes.insert(id, slopes);
        let operands = operands.into_iter().chain(slopes.into_iter().flatten()).map(|id| graph.signed(id).1);
        let operands: Vec<NodeId> = operands.filter(|id| !graph.is_prepared(*id)).collect();
        // What an order begins with is read where it is, or kept by the lines that begin with it.
        self.kept.extend(operands.iter().copied().filter(|id| !graph.node(*id).is_read()));
        self.operands.insert(id, operands);
        slopes.into_iter().flatten().collect()
    }
}

/// Whether a function is the power with any exponent.
pub(crate) fn is_power(function: Function) -> bool {
    function.name() == "powf"
}

/// A contribution as addends. Repeated products are found later, where the products are collected.
fn addends(graph: &mut Graph, Contribution { context, element, value }: Contribution) -> Vec<Contribution> {
    let addends = addends_within(graph, context, value).into_iter();
    addends.map(|(context, value)| Contribution { context, element, value }).collect()
}

/// A value in its surroundings as addends without sums over inner loops: what such a sum adds up is added in every
/// iteration of its loop, what is chosen or zero where it is chosen.
fn addends_within(graph: &mut Graph, context: Vec<Scope>, value: NodeId) -> Vec<(Vec<Scope>, NodeId)> {
    let within = |around: Scope| -> Vec<Scope> { context.iter().copied().chain([around]).collect() };
    let zero = |graph: &Graph, id| graph.as_constant(id) == Some(0.0);
    if !has_sums(graph, &context, value) {
        return vec![(context, value)];
    }
    match graph.node(value) {
        Node::Sum(by, body) => addends_within(graph, within(Scope::Loop(by)), body),
        Node::Select(condition, body, other) if zero(graph, other) => {
            addends_within(graph, within(Scope::Branch(condition, true)), body)
        }
        Node::Select(condition, other, body) if zero(graph, other) => {
            addends_within(graph, within(Scope::Branch(condition, false)), body)
        }
        Node::Add(a, b) => {
            let mut both = addends_within(graph, context.clone(), a);
            both.extend(addends_within(graph, context, b));
            both
        }
        Node::Neg(inner) => {
            let inner = addends_within(graph, context, inner).into_iter();
            inner.map(|(context, value)| (context, graph.neg(value))).collect()
        }
        Node::Mul(factor, inner) if graph.is_prepared(factor) => {
            let inner = addends_within(graph, context, inner).into_iter();
            inner.map(|(context, value)| (context, graph.mul(factor, value))).collect()
        }
        _ => vec![(context, value)],
    }
}

/// Whether a value is made of sums over loops inside its surroundings, by additions and prepared factors.
fn has_sums(graph: &Graph, context: &[Scope], id: NodeId) -> bool {
    match graph.node(id) {
        Node::Sum(by, _) => {
            let of_loop = |around: &Scope| if let Scope::Loop(by) = around { Some(*by) } else { None };
            graph.loops.get(by).parent == context.iter().rev().find_map(of_loop)
        }
        Node::Add(a, b) | Node::Select(_, a, b) => has_sums(graph, context, a) || has_sums(graph, context, b),
        Node::Neg(a) => has_sums(graph, context, a),
        Node::Mul(factor, a) => graph.is_prepared(factor) && has_sums(graph, context, a),
        _ => false,
    }
}

/// A value as a series: a number is its coefficient of order 0.
fn at_order_zero(graph: &mut Graph, id: NodeId) -> NodeId {
    if graph.is_prepared(id) { graph.stepped(id) } else { id }
}

/// Finds the values whose added numbers are coefficients of order 0, whose powers with a moving exponent are exponentials,
/// whose distances are roots, and whose whole powers are products.
fn rewrite_all(graph: &mut Graph, roots: impl IntoIterator<Item = NodeId>, known: &mut HashMap<NodeId, NodeId>) {
    for id in graph.reachable(roots) {
        if known.contains_key(&id) {
            continue;
        }
        let new = if graph.is_prepared(id) { id } else { rewrite(graph, id, known) };
        known.insert(id, new);
    }
}

fn rewrite(graph: &mut Graph, id: NodeId, known: &HashMap<NodeId, NodeId>) -> NodeId {
    let of = |id: NodeId| known[&id];
    match graph.node(id) {
        Node::Add(a, b) => {
            let (a, b) = (at_order_zero(graph, of(a)), at_order_zero(graph, of(b)));
            graph.add(a, b)
        }
        Node::Select(condition, a, b) => {
            let zero = |graph: &Graph, id| graph.as_constant(id) == Some(0.0);
            let part = |graph: &mut Graph, id| if zero(graph, id) { id } else { at_order_zero(graph, id) };
            let (a, b) = (part(graph, of(a)), part(graph, of(b)));
            graph.select(of(condition), a, b)
        }
        Node::Sum(by, body) => {
            let body = at_order_zero(graph, of(body));
            graph.rebuilt(Node::Sum(by, body))
        }
        // The recurrence of a power would divide by the base, which may be zero.
        Node::Power(base, halves @ 5..) if halves % 2 == 0 => whole_power(graph, of(base), halves / 2),
        // The root of a sum of squares has one recurrence, and so do distances within it.
        Node::Binary(function, a, b) if function.is_distance() => {
            let [first, second] = [a, b].map(|side| {
                let square = graph.mul(of(side), of(side));
                at_order_zero(graph, square)
            });
            let square = graph.add(first, second);
            graph.power(square, 1)
        }
        Node::Binary(function, a, b) if is_power(function) && !graph.is_prepared(b) => {
            let base = at_order_zero(graph, of(a));
            let logarithm = graph.call("ln", base);
            let exponent = graph.mul(of(b), logarithm);
            graph.call("exp", exponent)
        }
        node => graph.rebuilt(node.map(of)),
    }
}

/// A whole power as squares, of which an order sums half as many products, and as few other products as these leave.
fn whole_power(graph: &mut Graph, base: NodeId, exponent: i32) -> NodeId {
    match exponent {
        1 => base,
        exponent if exponent % 2 == 0 => {
            let root = whole_power(graph, base, exponent / 2);
            graph.rebuilt(Node::Power(root, 4))
        }
        exponent => {
            let square = whole_power(graph, base, exponent - 1);
            graph.times(square, base)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Recurrences;
    use crate::{
        differentiate::gradient,
        graph::{Element, Graph, NodeId, ParameterId, Part, index::Index},
    };

    type Potential = fn(&mut Graph, [NodeId; 3]) -> NodeId;

    /// A product of factors, as somebody writes it.
    fn product<const N: usize>(graph: &mut Graph, factors: [NodeId; N]) -> NodeId {
        factors.into_iter().reduce(|product, factor| graph.mul(product, factor)).expect("factors")
    }

    /// Potentials of `x` and `y`, with a parameter `k`, and the products that an order of their forces sums, in halves of the
    /// order.
    const POTENTIALS: &[(&str, Potential, usize)] = &[
        ("k x x x", |g, [x, _, k]| product(g, [k, x, x, x]), 1),
        ("x k x x", |g, [x, _, k]| product(g, [x, k, x, x]), 1),
        ("k x x x x", |g, [x, _, k]| product(g, [k, x, x, x, x]), 3),
        ("x^8", |g, [x, ..]| g.power(x, 16), 1 + 2 + 1 + 2),
        (
            "k x x x + k y y y + x k y",
            |g, [x, y, k]| {
                let terms = [product(g, [k, x, x, x]), product(g, [k, y, y, y]), product(g, [x, k, y])];
                terms.into_iter().reduce(|sum, term| g.add(sum, term)).expect("terms")
            },
            2,
        ),
        // x² and x y, from either side.
        ("x k x y", |g, [x, y, k]| product(g, [x, k, x, y]), 3),
        // x², y² and their products with y and x.
        ("x y k x y", |g, [x, y, k]| product(g, [x, y, k, x, y]), 6),
        // The root that all have in common and its third power, which is multiplied by k once: x k / r³, and y as well.
        (
            "k / r",
            |g, [x, y, k]| {
                let squares = [g.power(x, 4), g.power(y, 4)];
                let square = g.add(squares[0], squares[1]);
                let reciprocal = g.power(square, -1);
                g.mul(k, reciprocal)
            },
            2 + 2 + 2 * 2,
        ),
    ];

    #[test]
    fn products_are_as_few_as_hand_written() {
        for (name, potential, products) in POTENTIALS {
            let mut graph = Graph::default();
            let [x, y] = [0, 1].map(|position| {
                let index = graph.loops.intern(Index::Literal(position));
                graph.coordinate(Element { part: Part::Position, index, component: None })
            });
            let k = graph.parameter(ParameterId(0));
            let potential = potential(&mut graph, [x, y, k]);
            let mut forces = gradient(&mut graph, potential, Part::Position);
            let found = Recurrences::of(&mut graph, [&mut forces, &mut Vec::new()]);
            assert_eq!(found.products(&graph), *products, "{name}");
        }
    }
}
