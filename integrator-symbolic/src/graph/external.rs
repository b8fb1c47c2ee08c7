//! Methods of the user that are called as they are, with the methods that give their derivatives.

use super::{ExternalId, Graph, Node, NodeId};

impl Graph {
    /// A method of the user whose derivatives are not known yet.
    pub(crate) fn declare_external(&mut self) -> ExternalId {
        self.externals.push([None; 2]);
        ExternalId(self.externals.len() as u32 - 1)
    }

    /// States which methods give the derivatives of a method.
    pub(crate) fn derive_external(&mut self, id: ExternalId, slopes: [Option<ExternalId>; 2]) {
        self.externals[id.0 as usize] = slopes;
    }

    /// The methods that give the derivatives of a method.
    pub(crate) fn external_slopes(&self, id: ExternalId) -> [Option<ExternalId>; 2] {
        self.externals[id.0 as usize]
    }

    /// A method of the user, of one argument or two.
    pub(crate) fn external(&mut self, id: ExternalId, a: NodeId, b: Option<NodeId>) -> NodeId {
        self.intern(match b {
            None => Node::External(id, a),
            Some(b) => Node::ExternalTwo(id, a, b),
        })
    }
}
