//! Products in one form, so that few of them are multiplied anew at each order.
//!
//! Comes in: a value. Goes out: one that is the same but for roundings. A product with a prepared factor costs one
//! multiplication at each order, a product of two series as many as the order has. So prepared factors move out of products, the
//! others are multiplied as powers in one order, and sums have one addend for each product of powers: `a x x x` and `x (b x) x`
//! are multiples of `x³`.

use crate::graph::{Graph, Node, NodeId};
use std::collections::{BTreeMap, HashMap, HashSet, btree_map::Entry};

/// A product of whole powers of factors that are no products.
type Monomial = BTreeMap<NodeId, i32>;

/// A product: what is prepared of it, and the rest.
struct Term {
    coefficient: NodeId,
    monomial: Monomial,
}

/// Values by what they were before their products were gathered.
#[derive(Default)]
pub(super) struct Gathered {
    known: HashMap<NodeId, NodeId>,
}

impl Gathered {
    /// A value whose products have one form.
    pub(super) fn of(&mut self, graph: &mut Graph, root: NodeId) -> NodeId {
        let nodes = graph.reachable([root]);
        // Sums within sums are not values of their own.
        let mut operands = HashSet::from([root]);
        for id in nodes.iter().rev() {
            if operands.contains(id) {
                match graph.node(*id) {
                    Node::Add(..) => operands.extend(addends(graph, *id).into_iter().map(|(_, addend)| addend)),
                    node => operands.extend(node.children()),
                }
            }
        }
        for id in nodes {
            if operands.contains(&id) && !self.known.contains_key(&id) {
                let new = if graph.is_prepared(id) { id } else { self.gather(graph, id) };
                self.known.insert(id, new);
            }
        }
        self.known[&root]
    }

    /// A value whose operands are gathered.
    fn gather(&self, graph: &mut Graph, id: NodeId) -> NodeId {
        match graph.node(id) {
            Node::Add(..) => self.sum(graph, id),
            node => {
                let node = graph.rebuilt(node.map(|child| self.known[&child]));
                let term = term(graph, node);
                product(graph, term)
            }
        }
    }

    /// A sum with one addend for each monomial, in the order in which these are written first.
    fn sum(&self, graph: &mut Graph, id: NodeId) -> NodeId {
        let mut terms: Vec<Term> = Vec::new();
        let mut numbers = BTreeMap::<Monomial, usize>::new();
        for (negative, addend) in addends(graph, id) {
            let Term { mut coefficient, monomial } = term(graph, self.known[&addend]);
            if negative {
                coefficient = graph.neg(coefficient);
            }
            match numbers.entry(monomial.clone()) {
                Entry::Occupied(number) => {
                    let same: &mut Term = &mut terms[*number.get()];
                    same.coefficient = graph.add(same.coefficient, coefficient);
                }
                Entry::Vacant(number) => {
                    number.insert(terms.len());
                    terms.push(Term { coefficient, monomial });
                }
            }
        }
        let addends: Vec<_> = terms.into_iter().map(|term| product(graph, term)).collect();
        addends.into_iter().reduce(|sum, addend| graph.add(sum, addend)).unwrap_or(id)
    }
}

/// The addends of a sum in their order, and whether they are subtracted.
fn addends(graph: &Graph, sum: NodeId) -> Vec<(bool, NodeId)> {
    let (mut found, mut open) = (Vec::new(), vec![(false, sum)]);
    while let Some((negative, id)) = open.pop() {
        match graph.node(id) {
            Node::Add(a, b) => open.extend([(negative, b), (negative, a)]),
            Node::Neg(inner) => open.push((!negative, inner)),
            _ => found.push((negative, id)),
        }
    }
    found
}

/// A value as a product.
fn term(graph: &mut Graph, id: NodeId) -> Term {
    match graph.node(id) {
        _ if graph.is_prepared(id) => Term { coefficient: id, monomial: Monomial::new() },
        Node::Neg(inner) => {
            let inner = term(graph, inner);
            Term { coefficient: graph.neg(inner.coefficient), ..inner }
        }
        Node::Mul(a, b) => {
            let (a, b) = (term(graph, a), term(graph, b));
            let mut monomial = a.monomial;
            for (factor, exponent) in b.monomial {
                *monomial.entry(factor).or_default() += exponent;
            }
            Term { coefficient: graph.mul(a.coefficient, b.coefficient), monomial }
        }
        Node::Div(a, by) if graph.is_prepared(by) => {
            let a = term(graph, a);
            Term { coefficient: graph.div(a.coefficient, by), ..a }
        }
        Node::Power(base, halves) if halves > 0 && halves % 2 == 0 => {
            let mut base = term(graph, base);
            base.monomial.values_mut().for_each(|exponent| *exponent *= halves / 2);
            let coefficient = match graph.as_constant(base.coefficient) {
                Some(number) => graph.constant(number.powi(halves / 2)),
                None => graph.power(base.coefficient, halves),
            };
            Term { coefficient, ..base }
        }
        _ => Term { coefficient: graph.constant(1.0), monomial: Monomial::from([(id, 1)]) },
    }
}

/// The value of a product.
fn product(graph: &mut Graph, Term { coefficient, monomial }: Term) -> NodeId {
    match value(graph, &monomial) {
        Some(product) => graph.mul(coefficient, product),
        None => coefficient,
    }
}

/// The value of a monomial, if it has factors: the square of what it has half of, of which an order sums half as many
/// products as of others, and the rest.
fn value(graph: &mut Graph, monomial: &Monomial) -> Option<NodeId> {
    if monomial.is_empty() {
        return None;
    }
    let part = |of: fn(i32) -> i32| -> Monomial {
        let exponents = monomial.iter().map(|(factor, exponent)| (*factor, of(*exponent)));
        exponents.filter(|(_, exponent)| *exponent > 0).collect()
    };
    let root = value(graph, &part(|exponent| exponent / 2));
    let square = root.map(|root| graph.rebuilt(Node::Power(root, 4)));
    let rest = part(|exponent| exponent % 2).into_keys();
    square.into_iter().chain(rest).reduce(|product, factor| graph.times(product, factor))
}

/// A whole power as a product.
pub(super) fn whole_power(graph: &mut Graph, base: NodeId, exponent: i32) -> NodeId {
    value(graph, &Monomial::from([(base, exponent)])).unwrap_or(base)
}

#[cfg(test)]
mod tests {
    use crate::{
        differentiate::gradient,
        graph::{Element, Graph, NodeId, ParameterId, Part, index::Index},
        taylor::Recurrences,
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
    fn products_are_as_few_as_by_hand() {
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
