//! The values that conditions compare, with all of their operands.
//!
//! A force and an energy contain the same condition. They must decide it in the same way, even if both sides differ by
//! a rounding only. These values are therefore computed by the operations of their own formula, with one rounding each,
//! independent of the surrounding code.

use super::{Graph, Node, NodeId};
use std::collections::HashSet;

impl Graph {
    /// The values that the conditions in `roots` compare, and the values that these are computed from.
    pub(crate) fn compared(&self, roots: impl IntoIterator<Item = NodeId>) -> HashSet<NodeId> {
        let mut compared = HashSet::new();
        for id in self.reachable(roots).into_iter().rev() {
            if compared.contains(&id) || matches!(self.node(id), Node::Compare(..)) {
                compared.extend(self.node(id).children());
            }
        }
        compared
    }
}
