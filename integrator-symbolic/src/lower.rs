//! Powers become multiplications, roots and divisions.
//!
//! Comes in: roots that the algebra has built. Goes out: roots of equal value without any power but the square root.
//! Always true: a negative power used once divides what it multiplies, one used more often is a reciprocal that is
//! shared, and several negative powers of one base share the reciprocal of the base.

use crate::graph::{Graph, Node, NodeId};
use std::collections::HashMap;

/// Lowers `roots` together. `leaf` tells which nodes are computed elsewhere and are left as they are.
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
    /// How many different negative powers of a base there are.
    reciprocals: HashMap<NodeId, u32>,
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
        Self { lowered: HashMap::new(), uses, reciprocals }
    }

    fn node(&self, graph: &mut Graph, id: NodeId) -> NodeId {
        let of = |id: NodeId| self.lowered[&id];
        match graph.node(id) {
            Node::Mul(a, b) => {
                if let Some(divisor) = self.divisor(graph, b) {
                    return graph.quotient(of(a), divisor);
                }
                if let Some(divisor) = self.divisor(graph, a) {
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
            Node::Power(base, halves) => self.power(graph, base, halves),
            node => graph.rebuilt(node.map(of)),
        }
    }

    /// What a factor divides by, if it is a negative power that is used nowhere else.
    fn divisor(&self, graph: &mut Graph, factor: NodeId) -> Option<NodeId> {
        match graph.node(factor) {
            Node::Power(base, halves @ ..=-1) if self.uses[&factor] == 1 && self.reciprocals.get(&base) == Some(&1) => {
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
