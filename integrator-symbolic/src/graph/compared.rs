//! The values that conditions compare, with all that these are computed from.
//!
//! A force and an energy contain the same condition, and have to decide it alike where the two sides are equal but for a
//! rounding. So these values are computed by the operations of their own formula, one rounding each, whatever surrounds them.

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
