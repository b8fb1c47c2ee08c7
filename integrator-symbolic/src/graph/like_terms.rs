//! Collecting like terms: sums with one addend for each product of powers, however these are written.
//!
//! Comes in: values. Goes out: values that are the same but for roundings. Prepared factors move out of products, the others
//! are multiplied as powers in one order, and sums have one addend for each product of powers: `a x x x` and `x (b x) x` are
//! multiples of `x³`, and together one of them. Products are not expanded.

use super::{Graph, Node, NodeId};
use std::collections::{BTreeMap, HashMap, HashSet, btree_map::Entry};

/// A product of whole powers of factors that are no products.
type Monomial = BTreeMap<NodeId, i32>;

/// A product: what is prepared of it, and the rest.
struct Term {
    coefficient: NodeId,
    monomial: Monomial,
}

/// Values by what they were before their like terms were collected.
#[derive(Default)]
pub(crate) struct LikeTerms {
    known: HashMap<NodeId, NodeId>,
    /// The values that are products, or sums with some.
    with_products: HashSet<NodeId>,
}

impl LikeTerms {
    /// A value whose like terms are collected.
    pub(crate) fn of(&mut self, graph: &mut Graph, root: NodeId) -> NodeId {
        let nodes = graph.reachable([root]);
        for id in &nodes {
            let is_product = |id: NodeId| self.with_products.contains(&id);
            let found = match graph.node(*id) {
                _ if graph.is_prepared(*id) => false,
                Node::Mul(a, b) if graph.is_prepared(a) || graph.is_prepared(b) => is_product(a) || is_product(b),
                Node::Mul(..) => true,
                Node::Add(a, b) => is_product(a) || is_product(b),
                Node::Neg(a) | Node::Div(a, _) => is_product(a),
                Node::Power(_, halves) => is_whole(halves),
                _ => false,
            };
            if found {
                self.with_products.insert(*id);
            }
        }
        // Sums within sums are not values of their own.
        let mut operands = HashSet::from([root]);
        for id in nodes.iter().rev() {
            if operands.contains(id) {
                match self.addends(graph, *id) {
                    Some(addends) => operands.extend(addends.into_iter().map(|(_, addend)| addend)),
                    None => operands.extend(graph.node(*id).children()),
                }
            }
        }
        for id in nodes {
            if operands.contains(&id) && !self.known.contains_key(&id) {
                let new = if graph.is_prepared(id) { id } else { self.collected(graph, id) };
                self.known.insert(id, new);
            }
        }
        self.known[&root]
    }

    /// The addends of a sum with products, in their order, and whether they are subtracted. A sum without products is an addend:
    /// in the differences of numbers it matters which is taken first.
    fn addends(&self, graph: &Graph, sum: NodeId) -> Option<Vec<(bool, NodeId)>> {
        let is_flat = |id: NodeId| !self.with_products.contains(&id);
        if is_flat(sum) || !matches!(graph.node(sum), Node::Add(..)) {
            return None;
        }
        let (mut found, mut open) = (Vec::new(), vec![(false, sum)]);
        while let Some((negative, id)) = open.pop() {
            match graph.node(id) {
                Node::Add(a, b) if !is_flat(id) => open.extend([(negative, b), (negative, a)]),
                Node::Neg(inner) => open.push((!negative, inner)),
                _ => found.push((negative, id)),
            }
        }
        Some(found)
    }

    /// A value whose operands are known.
    fn collected(&self, graph: &mut Graph, id: NodeId) -> NodeId {
        if let Some(addends) = self.addends(graph, id) {
            return self.sum(graph, addends);
        }
        let node = graph.rebuilt(graph.node(id).map(|child| self.known[&child]));
        let term = term(graph, node);
        product(graph, term)
    }

    /// A sum with one addend for each product of powers, in the order in which these are written first.
    fn sum(&self, graph: &mut Graph, addends: Vec<(bool, NodeId)>) -> NodeId {
        let mut terms: Vec<Term> = Vec::new();
        let mut numbers = BTreeMap::<Monomial, usize>::new();
        for (negative, addend) in addends {
            let Term { mut coefficient, monomial } = term(graph, self.known[&addend]);
            if negative {
                coefficient = graph.neg(coefficient);
            }
            match numbers.entry(monomial.clone()) {
                Entry::Occupied(number) if monomial.values().sum::<i32>() > 1 => {
                    let same: &mut Term = &mut terms[*number.get()];
                    same.coefficient = graph.add(same.coefficient, coefficient);
                }
                Entry::Occupied(_) => terms.push(Term { coefficient, monomial }),
                Entry::Vacant(number) => {
                    number.insert(terms.len());
                    terms.push(Term { coefficient, monomial });
                }
            }
        }
        let addends: Vec<_> = terms.into_iter().map(|term| product(graph, term)).collect();
        addends.into_iter().reduce(|sum, addend| graph.add(sum, addend)).unwrap_or_else(|| graph.constant(0.0))
    }
}

/// Whether a power of so many halves is a product.
fn is_whole(halves: i32) -> bool {
    halves > 0 && halves % 2 == 0
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
        Node::Power(base, halves) if is_whole(halves) => {
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
    let Some(product) = value(graph, &monomial) else { return coefficient };
    let (negative, coefficient) = graph.signed(coefficient);
    let product = match graph.node(coefficient) {
        // A fraction of numbers is no constant to prepare: what is divided by a number is multiplied by its reciprocal.
        Node::Div(over, under) if [over, under].iter().all(|id| graph.as_constant(*id).is_some()) => {
            let product = graph.mul(over, product);
            graph.div(product, under)
        }
        _ => graph.mul(coefficient, product),
    };
    if negative { graph.neg(product) } else { product }
}

/// The value of a monomial, if it has factors: the square of what it has half of, and the rest. Few products, and of two
/// series the cheapest, since those of a square are the same from both sides.
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
    square.into_iter().chain(rest).reduce(|product, factor| graph.mul(product, factor))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::graph::{Element, ParameterId, Part, evaluate::Point, index::Index};

    /// A value of `x`, `y`, `z` and a parameter `k`.
    type Build = fn(&mut Graph, [NodeId; 4]) -> NodeId;

    fn product<const N: usize>(graph: &mut Graph, factors: [NodeId; N]) -> NodeId {
        factors.into_iter().reduce(|product, factor| graph.mul(product, factor)).expect("factors")
    }

    /// What is collected from the left is the very node on the right.
    const COLLECTED: &[(&str, Build, Build)] = &[
        (
            "x (k x) x == k x³",
            |g, [x, _, _, k]| product(g, [x, k, x, x]),
            |g, [x, _, _, k]| {
                let cube = g.power(x, 6);
                g.mul(k, cube)
            },
        ),
        (
            "k x y + z - y x k / 2 == k / 2 x y + z",
            |g, [x, y, z, k]| {
                let (first, last, two) = (product(g, [k, x, y]), product(g, [y, x, k]), g.constant(2.0));
                let (sum, half) = (g.add(first, z), g.div(last, two));
                g.sub(sum, half)
            },
            |g, [x, y, z, k]| {
                let (half, product) = (g.constant(0.5), g.mul(x, y));
                let coefficient = g.mul(half, k);
                let coefficient = g.sub(k, coefficient);
                let product = g.mul(coefficient, product);
                g.add(product, z)
            },
        ),
        (
            "(x y)(y x z) == (x y)² z",
            |g, [x, y, z, _]| product(g, [x, y, y, x, z]),
            |g, [x, y, z, _]| {
                let root = g.mul(x, y);
                let square = g.power(root, 4);
                g.mul(square, z)
            },
        ),
        (
            "(x - y) - (y - z) as it is",
            |g, [x, y, z, _]| {
                let (first, second) = (g.sub(x, y), g.sub(y, z));
                g.sub(first, second)
            },
            |g, [x, y, z, _]| {
                let (first, second) = (g.sub(x, y), g.sub(y, z));
                g.sub(first, second)
            },
        ),
        (
            "((x - k) + k) + x y as it is",
            |g, [x, y, _, k]| {
                let (near, product) = (g.sub(x, k), g.mul(x, y));
                let back = g.add(near, k);
                g.add(back, product)
            },
            |g, [x, y, _, k]| {
                let (near, product) = (g.sub(x, k), g.mul(x, y));
                let back = g.add(near, k);
                g.add(back, product)
            },
        ),
    ];

    fn at(graph: &mut Graph) -> [NodeId; 4] {
        let [x, y, z] = [0, 1, 2].map(|position| {
            let index = graph.loops.intern(Index::Literal(position));
            graph.coordinate(Element { part: Part::Position, index, component: None })
        });
        [x, y, z, graph.parameter(ParameterId(0))]
    }

    #[test]
    fn like_terms_are_one_and_differences_stay() {
        for (name, written, expected) in COLLECTED {
            let mut graph = Graph::default();
            let at = at(&mut graph);
            let (written, expected) = (written(&mut graph, at), expected(&mut graph, at));
            let collected = LikeTerms::default().of(&mut graph, written);
            let point = || Point { parameters: &[0.5], ..Point::new(&[0.75, -1.5, 2.25], &[]) };
            let [collected_value, value] = [collected, written].map(|id| point().value(&graph, id));
            // Few binary digits: nothing is rounded.
            assert_eq!(collected_value, value, "{name}");
            assert_eq!(graph.node(collected), graph.node(expected), "{name}");
        }
    }
}
