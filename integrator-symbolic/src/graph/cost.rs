//! What expressions cost, in arithmetic operations.

use super::{Graph, Node, NodeId};
use std::collections::HashMap;

/// Operations of expressions; the body of a sum counts once, a change of sign not at all.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Cost {
    /// As often as they occur in the formulas.
    pub(crate) written: u64,
    /// Once each, shared ones too.
    pub(crate) shared: u64,
}

impl Graph {
    /// What `roots` cost together per evaluation of a flow: what depends on parameters alone is there already.
    pub(crate) fn cost(&self, roots: &[NodeId]) -> Cost {
        let mut written: HashMap<NodeId, u64> = HashMap::new();
        let mut shared = 0;
        for id in self.reachable(roots.iter().copied()) {
            let total = if self.is_prepared(id) {
                0
            } else {
                let own = u64::from(self.node(id).is_operation());
                shared += own;
                self.node(id).children().map(|child| written[&child]).fold(own, u64::saturating_add)
            };
            written.insert(id, total);
        }
        let written = roots.iter().map(|root| written[root]).fold(0, u64::saturating_add);
        Cost { written, shared }
    }
}

impl Node {
    fn is_operation(self) -> bool {
        self.children().next().is_some() && !matches!(self, Node::Neg(_))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::graph::{Element, Part, index::Index};

    #[test]
    fn what_is_shared_counts_once() {
        let mut graph = Graph::default();
        let index = graph.loops.intern(Index::Literal(0));
        let q = graph.coordinate(Element { part: Part::Position, index, component: None });
        let sine = graph.call("sin", q);
        let square = graph.times(sine, sine);
        let sum = graph.add(square, sine);
        // sin(q) sin(q) + sin(q): three sines, a product and a sum; one sine is enough.
        assert_eq!(graph.cost(&[sum]), Cost { written: 5, shared: 3 });
    }
}
