//! Methods of the user that are called unchanged, and the methods that compute their derivatives.

use super::{ExternalId, Graph, Node, NodeId};

/// The arguments of a method of the user, in order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Arguments {
    /// Elements after the last argument repeat the first one.
    ids: [NodeId; Self::MOST],
    count: u8,
}

impl Arguments {
    /// The largest number of arguments of a method.
    pub(crate) const MOST: usize = 8;

    /// Whether this many arguments fit.
    pub(crate) fn fits(count: usize) -> bool {
        (1..=Self::MOST).contains(&count)
    }

    /// `None` for none, and for more than can be held.
    pub(crate) fn new(arguments: &[NodeId]) -> Option<Self> {
        let first = *arguments.first()?;
        let mut ids = [first; Self::MOST];
        ids.get_mut(..arguments.len())?.copy_from_slice(arguments);
        Some(Self { ids, count: u8::try_from(arguments.len()).ok()? })
    }

    pub(crate) fn iter(self) -> impl Iterator<Item = NodeId> {
        self.ids.into_iter().take(usize::from(self.count))
    }

    pub(crate) fn map(self, of: impl Fn(NodeId) -> NodeId) -> Self {
        Self { ids: self.ids.map(of), ..self }
    }
}

impl Graph {
    /// A method of the user whose derivatives are not known yet.
    pub(crate) fn declare_external(&mut self) -> ExternalId {
        self.externals.push(Vec::new());
        ExternalId(self.externals.len() as u32 - 1)
    }

    /// States which methods give the derivatives of a method, one for each argument.
    pub(crate) fn derive_external(&mut self, id: ExternalId, slopes: Vec<ExternalId>) {
        self.externals[id.0 as usize] = slopes;
    }

    /// The method that gives the derivative of a method by an argument, if it is stated.
    pub(crate) fn external_slope(&self, id: ExternalId, argument: usize) -> Option<ExternalId> {
        self.externals[id.0 as usize].get(argument).copied()
    }

    /// A method of the user.
    pub(crate) fn external(&mut self, id: ExternalId, arguments: Arguments) -> NodeId {
        self.intern(Node::External(id, arguments))
    }
}
