//! What is read by an index: whether it may be read where the user's text does not.

use super::{
    Around, Element, Graph, Node, NodeId,
    index::{Index, IndexId, Loops},
};

/// How far the reads of a value depend on where it stands.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Access {
    /// It can be computed anywhere: what it reads is always there.
    #[default]
    Anywhere,
    /// What it reads is there in all turns of the loops whose indices it reads by, unless these are compared with a length.
    ByRunning,
    /// What it reads is there in all turns of the loops that it depends on, unless a condition on integers says otherwise.
    InTurns,
    /// Its indices are computed, and may be out of bounds where a loop further in has no turn, too.
    WhereWritten,
}

impl Loops {
    /// The access of a coordinate with this index.
    fn access(&self, id: IndexId) -> Access {
        match self.index(id) {
            // How far such an index gets was held against the length when it was read.
            _ if self.has_known_extents() && self.is_of_numbers(id) => Access::Anywhere,
            Index::Running(_) => Access::ByRunning,
            Index::Literal(_) | Index::Length | Index::Parameter(_) => Access::InTurns,
            Index::Rem(..) if self.computes(id) == Access::Anywhere => Access::InTurns,
            _ => Access::WhereWritten,
        }
    }

    /// Whether a comparison may keep an index from being too large; indices of loops are compared to tell bodies apart,
    /// and with a number on their left to leave out the first ones.
    pub(crate) fn bounds_from_above(&self, a: IndexId, b: IndexId) -> bool {
        let is_running = |id| matches!(self.index(id), Index::Running(_));
        !(is_running(b) && (is_running(a) || self.literal(a).is_some()))
    }

    /// Whether an integer is made of numbers, and of indices between numbers, without differences.
    fn is_of_numbers(&self, id: IndexId) -> bool {
        match self.index(id) {
            Index::Literal(_) => true,
            Index::Running(by) => self.is_of_numbers(self.get(by).to),
            Index::Add(a, b) | Index::Mul(a, b) => self.is_of_numbers(a) && self.is_of_numbers(b),
            _ => false,
        }
    }

    /// The access of an integer: a difference may be below zero, and nothing is divided by zero.
    fn computes(&self, id: IndexId) -> Access {
        match self.index(id) {
            Index::Literal(_) | Index::Length | Index::Running(_) | Index::Parameter(_) => Access::Anywhere,
            Index::Add(a, b) | Index::Mul(a, b) | Index::Monus(a, b) | Index::Min(a, b) => {
                self.computes(a).max(self.computes(b))
            }
            Index::Div(a, b) | Index::Rem(a, b) if self.is_positive(b) => self.computes(a),
            _ => Access::WhereWritten,
        }
    }

    /// Whether an integer is a number, but not zero, or counts coordinates.
    fn is_positive(&self, id: IndexId) -> bool {
        self.literal(id).map_or_else(|| self.is_extent(id), |number| number > 0)
    }
}

impl Graph {
    /// The access of a node, with all that it is computed from.
    pub(crate) fn access(&self, id: NodeId) -> Access {
        self.facts[id.position()].access
    }

    /// The access of a node beside that of its children.
    pub(super) fn own_access(&self, node: Node) -> Access {
        match node {
            Node::Coordinate(Element { index, component, .. }) => {
                // How many components a point has is known.
                let computed = component.filter(|component| self.loops.literal(*component).is_none());
                let component = computed.map_or(Access::Anywhere, |component| self.loops.access(component));
                self.loops.access(index).max(component)
            }
            Node::FromIndex(index) => self.loops.computes(index),
            Node::CompareIndex(_, a, b) => self.loops.computes(a).max(self.loops.computes(b)),
            // A method of the user may look anything up.
            Node::External(..) | Node::ExternalTwo(..) => Access::InTurns,
            _ => Access::Anywhere,
        }
    }

    /// Whether something around a place may decide that what a node reads is there.
    pub(crate) fn protects(&self, around: Around, id: NodeId) -> bool {
        match (around, self.access(id)) {
            (_, Access::Anywhere) => false,
            (Around::Loop(by), access) => access == Access::WhereWritten && !self.loops.has_turns(by),
            (Around::Branch(condition, _), access) => self.is_on_integers(condition, access),
        }
    }

    /// Whether a condition has a part on integers, or one of parameters, that bears on reads of an access.
    fn is_on_integers(&self, condition: NodeId, access: Access) -> bool {
        match self.node(condition) {
            Node::CompareIndex(_, a, b) => access == Access::WhereWritten || self.loops.bounds_from_above(a, b),
            Node::Flag(_) => access >= Access::InTurns,
            Node::And(a, b) | Node::Or(a, b) => self.is_on_integers(a, access) || self.is_on_integers(b, access),
            Node::Not(a) => self.is_on_integers(a, access),
            // A loop asks in this way whether it had turns.
            Node::Compare(_, _, count) => match self.node(count) {
                Node::Sum(_, body) => self.is_on_integers(body, access),
                _ => false,
            },
            Node::Select(condition, ..) => self.is_on_integers(condition, access),
            _ => false,
        }
    }
}
