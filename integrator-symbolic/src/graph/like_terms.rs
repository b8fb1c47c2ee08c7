//! Collection of like terms: sums with one addend for each product of powers, for every way of writing it.
//!
//! In: values. Out: the same values except for rounding.
//!
//! - Prepared factors move out of products; the other factors are multiplied as powers in a fixed order.
//! - Sums have one addend for each product of powers: `a x x x` and `x (b x) x` are multiples of `x³`, and together one
//!   of them.
//! - Products are not expanded. Sums and products that are used several times are not taken apart. Time and output size
//!   are hence proportional to the input.
//! - Values that conditions compare do not change.

use super::{Graph, Node, NodeId};
use std::collections::{BTreeMap, HashMap, HashSet, btree_map::Entry};

/// A product of whole powers of factors that are no products.
type Monomial = BTreeMap<NodeId, i32>;

/// A product: what is prepared of it, and the rest.
struct Term {
    coefficient: NodeId,
    monomial: Monomial,
}

/// What a product consists of, each with an exponent.
#[derive(Default)]
struct Factors {
    negative: bool,
    over: Vec<(NodeId, i32)>,
    under: Vec<(NodeId, i32)>,
}

/// The values with their like terms collected that these and what they are made of become.
pub(crate) fn with_like_terms_collected(graph: &mut Graph, roots: &[NodeId]) -> HashMap<NodeId, NodeId> {
    let nodes = graph.reachable(roots.iter().copied());
    let compared = graph.compared(roots.iter().copied());
    let mut values = Values { used_once: roots.iter().copied().collect(), compared, ..Values::default() };
    for id in &nodes {
        values.note(graph, *id);
    }
    // Sums within sums and products within products are not values of their own.
    let mut operands: HashSet<NodeId> = roots.iter().copied().collect();
    for id in nodes.iter().rev().filter(|id| !graph.is_prepared(**id)) {
        if operands.contains(id) && !values.compared.contains(id) {
            operands.extend(values.operands(graph, *id));
        }
    }
    for id in nodes.into_iter().filter(|id| operands.contains(id)) {
        let stays = graph.is_prepared(id) || values.compared.contains(&id);
        let new = if stays { id } else { values.collected(graph, id) };
        values.known.insert(id, new);
    }
    values.known
}

/// What is known of the values whose like terms are collected.
#[derive(Default)]
struct Values {
    /// What they become.
    known: HashMap<NodeId, NodeId>,
    /// Those that are products, or sums with some.
    with_products: HashSet<NodeId>,
    /// Those that one other value is made of, or that are requested,
    used_once: HashSet<NodeId>,
    /// and those that are used again.
    used_again: HashSet<NodeId>,
    /// Those that conditions compare.
    compared: HashSet<NodeId>,
}

impl Values {
    /// Notes a value whose operands have been noted.
    fn note(&mut self, graph: &Graph, id: NodeId) {
        let node = graph.node(id);
        for child in node.children() {
            if !self.used_once.insert(child) {
                self.used_again.insert(child);
            }
        }
        let is_product = |id: NodeId| self.with_products.contains(&id);
        let found = match node {
            _ if graph.is_prepared(id) => false,
            Node::Mul(a, b) if graph.is_prepared(a) || graph.is_prepared(b) => is_product(a) || is_product(b),
            Node::Mul(..) => true,
            Node::Add(a, b) => is_product(a) || is_product(b),
            Node::Neg(a) | Node::Div(a, _) => is_product(a),
            Node::Power(_, halves) => is_whole(halves),
            _ => false,
        };
        if found {
            self.with_products.insert(id);
        }
    }

    /// Whether a value is a part of one other value alone.
    fn is_part(&self, id: NodeId) -> bool {
        !self.used_again.contains(&id) && !self.compared.contains(&id)
    }

    /// The values that a value is computed from.
    fn operands(&self, graph: &Graph, id: NodeId) -> Vec<NodeId> {
        if let Some(addends) = self.addends(graph, id) {
            return addends.into_iter().map(|(_, addend)| addend).collect();
        }
        match self.factors(graph, id) {
            Some(Factors { over, under, .. }) => over.into_iter().chain(under).map(|(factor, _)| factor).collect(),
            None => graph.node(id).children().collect(),
        }
    }

    /// What a value is the product of, if it is one.
    fn factors(&self, graph: &Graph, id: NodeId) -> Option<Factors> {
        let found = factors(graph, id, |id| self.is_part(id), usize::MAX);
        (!matches!(found.over[..], [(single, _)] if single == id)).then_some(found)
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
                Node::Add(a, b) if !is_flat(id) && (id == sum || self.is_part(id)) => {
                    open.extend([(negative, b), (negative, a)]);
                }
                Node::Neg(inner) if self.is_part(id) => open.push((!negative, inner)),
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
        let Some(Factors { negative, over, under }) = self.factors(graph, id) else {
            return graph.rebuilt(graph.node(id).map(|child| self.known[&child]));
        };
        let new = |factors: Vec<(NodeId, i32)>| {
            factors.into_iter().map(|(factor, exponent)| (self.known[&factor], exponent)).collect()
        };
        let term = term(graph, Factors { negative, over: new(over), under: new(under) });
        product(graph, term)
    }

    /// A sum with one addend for each product of powers, in the order in which these are written first.
    fn sum(&self, graph: &mut Graph, addends: Vec<(bool, NodeId)>) -> NodeId {
        let mut terms: Vec<Term> = Vec::new();
        let mut numbers = BTreeMap::<Monomial, usize>::new();
        for (negative, addend) in addends {
            let addend = Factors { negative, over: vec![(self.known[&addend], 1)], under: Vec::new() };
            let Term { coefficient, monomial } = term(graph, addend);
            match numbers.entry(monomial.clone()) {
                Entry::Occupied(number) if monomial.len() > 1 || monomial.values().any(|exponent| *exponent > 1) => {
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

/// The largest exponent to which a power is taken for a product: exponents of exponents are numbers still.
const LARGEST: i32 = 1 << 14;

/// The most factors of a value that is multiplied factor by factor wherever it is one: the derivatives of a long product share
/// products of its factors.
const LONG: usize = 8;

/// Whether a power of this number of halves is a product.
fn is_whole(halves: i32) -> bool {
    halves > 0 && halves % 2 == 0 && halves / 2 <= LARGEST
}

/// What a value is the product of, down to what is no product or no part of it alone; of more factors than are
/// requested, one more.
fn factors(graph: &Graph, value: NodeId, is_part: impl Fn(NodeId) -> bool, most: usize) -> Factors {
    let mut found = Factors::default();
    let mut open = vec![(value, 1)];
    while let Some((id, exponent)) = open.pop() {
        if found.over.len() > most {
            break;
        }
        match graph.node(id) {
            _ if graph.is_prepared(id) || id != value && !is_part(id) => found.over.push((id, exponent)),
            Node::Neg(inner) => {
                found.negative ^= exponent % 2 != 0;
                open.push((inner, exponent));
            }
            Node::Mul(a, b) => open.extend([(b, exponent), (a, exponent)]),
            Node::Div(a, by) if graph.is_prepared(by) => {
                found.under.push((by, exponent));
                open.push((a, exponent));
            }
            Node::Power(base, halves)
                if is_whole(halves) && halves / 2 * exponent <= LARGEST && !has_prepared_factor(graph, base) =>
            {
                open.push((base, halves / 2 * exponent));
            }
            _ => found.over.push((id, exponent)),
        }
    }
    found
}

/// Whether a product has a prepared factor, or too many to look. Its powers stay together: of `(x / a)³⁰` for an `a` far from
/// one, neither `x³⁰` nor `a³⁰` may be a number.
fn has_prepared_factor(graph: &Graph, product: NodeId) -> bool {
    let (mut open, mut factors) = (vec![product], 0);
    while let Some(id) = open.pop() {
        match graph.node(id) {
            _ if graph.is_prepared(id) || factors > LONG => return true,
            Node::Neg(inner) => open.push(inner),
            Node::Mul(a, b) => open.extend([a, b]),
            Node::Div(_, by) if graph.is_prepared(by) => return true,
            // A power is a factor, or has none that is prepared: to look into it here would be to look twice at each level.
            _ => factors += 1,
        }
    }
    false
}

/// A product as what is prepared of it and the rest.
fn term(graph: &mut Graph, Factors { mut negative, over, mut under }: Factors) -> Term {
    let mut term = Term { coefficient: graph.constant(1.0), monomial: Monomial::new() };
    for (factor, outer) in over {
        let mut inner = factors(graph, factor, |_| true, LONG);
        if inner.over.len() > LONG {
            inner = Factors { negative: false, over: vec![(factor, 1)], under: Vec::new() };
        }
        negative ^= inner.negative && outer % 2 != 0;
        under.extend(inner.under.into_iter().map(|(factor, exponent)| (factor, outer * exponent)));
        for (factor, exponent) in inner.over {
            if graph.is_prepared(factor) {
                let power = power(graph, factor, outer * exponent);
                term.coefficient = graph.mul(term.coefficient, power);
            } else {
                let sum = term.monomial.entry(factor).or_default();
                *sum = sum.saturating_add(outer * exponent);
            }
        }
    }
    for (factor, exponent) in under {
        let power = power(graph, factor, exponent);
        term.coefficient = graph.div(term.coefficient, power);
    }
    if negative {
        term.coefficient = graph.neg(term.coefficient);
    }
    term
}

/// A power of what is prepared.
fn power(graph: &mut Graph, base: NodeId, exponent: i32) -> NodeId {
    match graph.as_constant(base) {
        Some(number) => graph.constant(number.powi(exponent)),
        None => graph.power(base, 2 * exponent),
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
    let mut factors: Vec<_> = square.into_iter().chain(rest).collect();
    // What is the same in all iterations is multiplied outside of their loop.
    factors.sort_by_key(|factor| graph.loops_of(*factor).iter().count());
    factors.into_iter().reduce(|product, factor| graph.mul(product, factor))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::differentiate::gradient;
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
            "(x / 1000)³⁰ x as it is",
            |g, [x, ..]| {
                let thousand = g.constant(1000.0);
                let quotient = g.div(x, thousand);
                let power = g.power(quotient, 60);
                g.mul(x, power)
            },
            |g, [x, ..]| {
                let thousand = g.constant(1000.0);
                let quotient = g.div(x, thousand);
                let root = g.power(quotient, 60);
                g.mul(x, root)
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
            let collected = with_like_terms_collected(&mut graph, &[written])[&written];
            let point = || Point { parameters: &[0.5], ..Point::new(&[0.75, -1.5, 2.25], &[]) };
            let [collected_value, value] = [collected, written].map(|id| point().value(&graph, id));
            // Few binary digits: nothing is rounded.
            assert_eq!(collected_value, value, "{name}");
            assert_eq!(graph.node(collected), graph.node(expected), "{name}");
        }
    }
    /// Sums that double at every level, products of the two before, and the derivatives of a product of many factors.
    #[test]
    fn shared_nodes_stay_shared() {
        let mut graph = Graph::default();
        let [x, y, z, k] = at(&mut graph);
        let mut sum = graph.mul(x, y);
        for _ in 0..200 {
            let product = product(&mut graph, [k, x, z]);
            let inner = graph.add(sum, product);
            sum = graph.add(sum, inner);
        }
        let mut powers = [x, y];
        for _ in 0..80 {
            let [before, last] = powers;
            powers = [last, graph.mul(last, before)];
        }
        let factors: Vec<NodeId> = (0..200).map(|i| graph.constant(f64::from(i) + 0.5)).collect();
        let mut rest = x;
        for number in factors {
            let factor = graph.add(y, number);
            rest = graph.mul(rest, factor);
        }
        let slopes = gradient(&mut graph, rest, Part::Position);
        let roots: Vec<NodeId> = slopes.iter().map(|slope| slope.value).chain([sum, powers[1]]).collect();
        with_like_terms_collected(&mut graph, &roots);
        // A few for each of 400 levels, where without sharing there would be 200 times 200, or more than could be counted.
        assert!(graph.len() < 10_000, "{}", graph.len());
    }
}
