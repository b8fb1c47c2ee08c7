//! Conditions, and the choice between two values.

use super::{
    Comparison, Graph, Node, NodeId, ParameterId,
    index::{Index, IndexId},
};

impl Graph {
    /// A condition that always holds, or never.
    pub(crate) fn truth(&mut self, holds: bool) -> NodeId {
        let zero = self.loops.intern(Index::Literal(0));
        let always = self.intern(Node::CompareIndex(Comparison::Equal, zero, zero));
        if holds { always } else { self.intern(Node::Not(always)) }
    }

    /// Whether a condition is one of [`Graph::truth`].
    pub(crate) fn as_truth(&self, condition: NodeId) -> Option<bool> {
        match self.node(condition) {
            Node::CompareIndex(Comparison::Equal, a, b) if a == b => Some(true),
            Node::Not(inner) => self.as_truth(inner).map(|holds| !holds),
            _ => None,
        }
    }

    /// `a < b`, `a <= b` or `a == b`.
    pub(crate) fn compare(&mut self, comparison: Comparison, a: NodeId, b: NodeId) -> NodeId {
        match (self.as_constant(a), self.as_constant(b)) {
            (Some(a), Some(b)) => self.truth(match comparison {
                Comparison::Less => a < b,
                Comparison::LessOrEqual => a <= b,
                Comparison::Equal => a == b,
            }),
            _ => self.intern(Node::Compare(comparison, a, b)),
        }
    }

    /// The same for integers.
    pub(crate) fn compare_index(&mut self, comparison: Comparison, a: IndexId, b: IndexId) -> NodeId {
        match (self.loops.literal(a), self.loops.literal(b)) {
            (Some(a), Some(b)) => self.truth(match comparison {
                Comparison::Less => a < b,
                Comparison::LessOrEqual => a <= b,
                Comparison::Equal => a == b,
            }),
            _ => self.intern(Node::CompareIndex(comparison, a, b)),
        }
    }

    /// A condition of parameters alone.
    pub(crate) fn flag(&mut self, id: ParameterId) -> NodeId {
        self.intern(Node::Flag(id))
    }

    /// exact: !!c == c
    pub(crate) fn not(&mut self, condition: NodeId) -> NodeId {
        match (self.as_truth(condition), self.node(condition)) {
            (Some(holds), _) => self.truth(!holds),
            (None, Node::Not(inner)) => inner,
            _ => self.intern(Node::Not(condition)),
        }
    }

    pub(crate) fn and(&mut self, a: NodeId, b: NodeId) -> NodeId {
        match (self.as_truth(a), self.as_truth(b)) {
            (Some(true), _) => b,
            (_, Some(true)) => a,
            (Some(false), _) | (_, Some(false)) => self.truth(false),
            _ if a == b => a,
            _ => self.intern(Node::And(a, b)),
        }
    }

    pub(crate) fn or(&mut self, a: NodeId, b: NodeId) -> NodeId {
        match (self.as_truth(a), self.as_truth(b)) {
            (Some(false), _) => b,
            (_, Some(false)) => a,
            (Some(true), _) | (_, Some(true)) => self.truth(true),
            _ if a == b => a,
            _ => self.intern(Node::Or(a, b)),
        }
    }

    /// `a` where the condition holds, else `b`. Both may be conditions.
    pub(crate) fn select(&mut self, condition: NodeId, a: NodeId, b: NodeId) -> NodeId {
        match (self.as_truth(condition), self.node(condition)) {
            _ if a == b => a,
            (Some(true), _) => a,
            (Some(false), _) => b,
            _ if self.node(a).is_condition() => {
                let (otherwise, first) = (self.not(condition), self.and(condition, a));
                let second = self.and(otherwise, b);
                self.or(first, second)
            }
            // exact: choosing the other way round
            (None, Node::Not(inner)) => self.select(inner, b, a),
            _ => self.intern(Node::Select(condition, a, b)),
        }
    }
}
