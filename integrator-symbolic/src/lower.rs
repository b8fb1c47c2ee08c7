//! Lowering of powers to multiplications, roots and divisions.
//!
//! In: roots that the algebra has built. Out: roots of equal value without any power except the square root. Always
//! true:
//!
//! - A negative power that is used once becomes a division; one that is used several times, or in a loop that does not change
//!   it, becomes a shared reciprocal.
//! - Several negative powers of one base share the reciprocal of the base. In a sum of two of them, the smaller one is
//!   factored out.
//! - Values that conditions compare are lowered by their own formula only. Every function with such a condition hence
//!   decides it in the same way.

use crate::graph::{Graph, Node, NodeId};
use std::collections::{HashMap, HashSet};

/// Lowers `roots` together. `leaf` decides which nodes are computed elsewhere and are left as they are.
pub(crate) fn lower(graph: &mut Graph, roots: &[NodeId], leaf: impl Fn(&Graph, NodeId) -> bool) -> Vec<NodeId> {
    let used = used(graph, roots, &leaf);
    let mut lowering = Lowering::new(graph, roots, &used, &leaf);
    for id in used {
        let lowered = if leaf(graph, id) { id } else { lowering.node(graph, id) };
        lowering.lowered.insert(id, lowered);
    }
    roots.iter().map(|root| lowering.lowered[root]).collect()
}

/// The nodes that `roots` are made of down to leaves, children first.
fn used(graph: &Graph, roots: &[NodeId], leaf: &impl Fn(&Graph, NodeId) -> bool) -> Vec<NodeId> {
    let mut seen = std::collections::BTreeSet::new();
    let mut open = roots.to_vec();
    while let Some(id) = open.pop() {
        if seen.insert(id) && !leaf(graph, id) {
            open.extend(graph.node(id).children());
        }
    }
    seen.into_iter().collect()
}

struct Lowering {
    lowered: HashMap<NodeId, NodeId>,
    uses: HashMap<NodeId, u32>,
    /// What is computed elsewhere.
    leaves: HashSet<NodeId>,
    /// How many different negative powers of a base there are.
    reciprocals: HashMap<NodeId, u32>,
    /// What conditions compare: no use elsewhere changes how it is computed.
    compared: HashSet<NodeId>,
}

/// `factor base^(halves / 2)`
struct Term {
    factor: NodeId,
    base: NodeId,
    halves: i32,
}

impl Lowering {
    fn new(graph: &Graph, roots: &[NodeId], used: &[NodeId], leaf: &impl Fn(&Graph, NodeId) -> bool) -> Self {
        let (mut uses, mut reciprocals) = (HashMap::new(), HashMap::new());
        for root in roots {
            *uses.entry(*root).or_insert(0) += 1;
        }
        for id in used.iter().filter(|id| !leaf(graph, **id)) {
            for child in graph.node(*id).children() {
                *uses.entry(child).or_insert(0) += 1;
            }
            if let Node::Power(base, ..=-1) = graph.node(*id) {
                *reciprocals.entry(base).or_insert(0) += 1;
            }
        }
        let leaves = used.iter().copied().filter(|id| leaf(graph, *id)).collect();
        let compared = graph.compared(roots.iter().copied());
        Self { lowered: HashMap::new(), uses, leaves, reciprocals, compared }
    }

    fn node(&self, graph: &mut Graph, id: NodeId) -> NodeId {
        let of = |id: NodeId| self.lowered[&id];
        match graph.node(id) {
            Node::Mul(a, b) => {
                if let Some(divisor) = self.divisor(graph, id, b) {
                    return graph.quotient(of(a), divisor);
                }
                if let Some(divisor) = self.divisor(graph, id, a) {
                    return graph.quotient(of(b), divisor);
                }
                graph.times(of(a), of(b))
            }
            Node::Div(a, b) => match graph.as_constant(b) {
                // one rounding more than the division, several times its speed
                Some(divisor) if !graph.is_prepared(a) => {
                    let reciprocal = graph.constant(1.0 / divisor);
                    graph.times(reciprocal, of(a))
                }
                _ => graph.quotient(of(a), of(b)),
            },
            Node::Power(base, halves @ ..=-1) if self.compared.contains(&id) => {
                let (one, divisor) = (graph.constant(1.0), positive(graph, of(base), halves.unsigned_abs()));
                graph.quotient(one, divisor)
            }
            Node::Power(base, halves) => self.power(graph, base, halves),
            Node::Add(a, b) if !self.compared.contains(&id) => {
                self.factored(graph, a, b).unwrap_or_else(|| graph.rebuilt(Node::Add(of(a), of(b))))
            }
            node => graph.rebuilt(node.map(of)),
        }
    }

    /// `c x^-m + d x^-n` as `x^-n (c x^(n - m) + d)` for `m > n`: of attraction and repulsion, as Lennard-Jones has them, two
    /// multiplications fewer. Exact but for roundings, as are multiplications in place of powers.
    fn factored(&self, graph: &mut Graph, a: NodeId, b: NodeId) -> Option<NodeId> {
        let [a, b] = [self.term(graph, a)?, self.term(graph, b)?];
        let (high, low) = if a.halves < b.halves { (a, b) } else { (b, a) };
        let between = high.halves - low.halves;
        if high.base != low.base || between == 0 || between % 2 != 0 {
            return None;
        }
        let power = self.power(graph, high.base, between);
        let product = graph.times(high.factor, power);
        let sum = graph.rebuilt(Node::Add(product, low.factor));
        let outer = self.power(graph, low.base, low.halves);
        Some(graph.times(outer, sum))
    }

    /// A number times a negative power that is used nowhere else.
    fn term(&self, graph: &mut Graph, id: NodeId) -> Option<Term> {
        if self.leaves.contains(&id) {
            return None;
        }
        let (power, factor) = match graph.node(id) {
            Node::Power(..) => (id, graph.constant(1.0)),
            Node::Neg(inner) if self.uses[&id] == 1 => {
                let Term { factor, base, halves } = self.term(graph, inner)?;
                return Some(Term { factor: graph.neg(factor), base, halves });
            }
            Node::Mul(a, b) if self.uses[&id] == 1 && graph.is_prepared(a) => (b, self.lowered[&a]),
            Node::Mul(a, b) if self.uses[&id] == 1 && graph.is_prepared(b) => (a, self.lowered[&b]),
            _ => return None,
        };
        match graph.node(power) {
            Node::Power(base, halves @ ..=-1) if self.uses[&power] == 1 && !self.leaves.contains(&power) => {
                Some(Term { factor, base, halves })
            }
            _ => None,
        }
    }

    /// What a factor of a product divides by, if it is a negative power that is used nowhere else and changes whenever the
    /// product does, or if a condition compares the product.
    fn divisor(&self, graph: &mut Graph, product: NodeId, factor: NodeId) -> Option<NodeId> {
        let is_compared = self.compared.contains(&product) && !self.leaves.contains(&factor);
        let changes = graph.loops_of(product).is_subset(graph.loops_of(factor));
        let is_used_once = |base| changes && self.uses[&factor] == 1 && self.reciprocals.get(base) == Some(&1);
        match graph.node(factor) {
            Node::Power(base, halves @ ..=-1) if is_used_once(&base) || is_compared => {
                Some(positive(graph, self.lowered[&base], halves.unsigned_abs()))
            }
            _ => None,
        }
    }

    fn power(&self, graph: &mut Graph, base: NodeId, halves: i32) -> NodeId {
        let lowered = self.lowered[&base];
        if halves > 0 {
            return positive(graph, lowered, halves.unsigned_abs());
        }
        let one = graph.constant(1.0);
        if self.reciprocals.get(&base).is_some_and(|distinct| *distinct > 1) {
            let reciprocal = graph.quotient(one, lowered);
            return positive(graph, reciprocal, halves.unsigned_abs());
        }
        let divisor = positive(graph, lowered, halves.unsigned_abs());
        graph.quotient(one, divisor)
    }
}

/// `base` to the power of `halves / 2`, by squaring, times a root if that is not whole.
fn positive(graph: &mut Graph, base: NodeId, halves: u32) -> NodeId {
    match (halves / 2, halves % 2) {
        (whole, 0) => repeated(graph, base, whole),
        (0, _) => graph.root(base),
        (whole, _) => {
            let (product, root) = (repeated(graph, base, whole), graph.root(base));
            graph.times(product, root)
        }
    }
}

fn repeated(graph: &mut Graph, base: NodeId, times: u32) -> NodeId {
    match times {
        0 | 1 => base,
        even if even % 2 == 0 => {
            let half = repeated(graph, base, even / 2);
            graph.times(half, half)
        }
        odd => {
            let product = repeated(graph, base, odd - 1);
            graph.times(product, base)
        }
    }
}
