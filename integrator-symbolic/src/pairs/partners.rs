//! Loops over the partners of a body.

use crate::graph::{
    Comparison, Graph, Node, NodeId,
    index::{Index, IndexId, Loop, LoopId},
};

/// Loops over the two bodies of a pair.
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct Visited {
    pub(crate) pair: [LoopId; 2],
    /// Whether the second body has the larger index; `None` if each pair comes twice.
    pub(crate) ascending: Option<bool>,
}

/// Whether a loop runs over the partners of the body with the index of `by` among `count` bodies; `true` if each pair comes
/// twice.
pub(super) fn is_partner(graph: &Graph, count: IndexId, by: LoopId, other: LoopId) -> Option<bool> {
    let Loop { parent, from, to } = graph.loops.get(other);
    if parent != Some(by) {
        return None;
    }
    if is_before(graph, by, other) {
        return Some(false);
    }
    let after = match graph.loops.index(from) {
        Index::Add(a, b) => graph.loops.index(a) == Index::Running(by) && graph.loops.literal(b) == Some(1),
        _ => false,
    };
    let all = graph.loops.literal(from) == Some(0);
    (to == count && (after || all)).then_some(all)
}

/// Whether a loop runs over the bodies before the one with the index of `by`.
pub(super) fn is_before(graph: &Graph, by: LoopId, other: LoopId) -> bool {
    let Loop { from, to, .. } = graph.loops.get(other);
    graph.loops.literal(from) == Some(0) && graph.loops.index(to) == Index::Running(by)
}

/// The addend where the two indices differ, if nothing is added where they are equal.
pub(crate) fn addend_of_distinct_pair(graph: &Graph, first: LoopId, second: LoopId, body: NodeId) -> Option<NodeId> {
    let Node::Select(condition, same, other) = graph.node(body) else { return None };
    let (condition, same, other) = match graph.node(condition) {
        Node::Not(inner) => (inner, other, same),
        _ => (condition, same, other),
    };
    let Node::CompareIndex(Comparison::Equal, a, b) = graph.node(condition) else { return None };
    let named = [a, b].map(|index| graph.loops.index(index));
    let both = [first, second].map(Index::Running);
    let alike = named == both || named == [both[1], both[0]];
    (alike && graph.as_constant(same) == Some(0.0)).then_some(other)
}
