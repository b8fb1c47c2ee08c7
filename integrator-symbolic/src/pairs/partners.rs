//! Loops over the partners of a body.

use super::order::rewritten;
use crate::graph::{
    Comparison, Graph, Node, NodeId,
    index::{Index, IndexId, Loop, LoopId},
};
use std::cmp::Ordering;

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
pub(crate) fn addend_of_distinct_pair(graph: &mut Graph, pair: [LoopId; 2], body: NodeId) -> Option<NodeId> {
    let orders = [Ordering::Equal, Ordering::Less, Ordering::Greater];
    let [itself, behind, before] = orders.map(|order| in_order(graph, body, pair, Some(order)));
    let is_zero = graph.as_constant(itself) == Some(0.0);
    is_zero.then(|| if behind == before { before } else { in_order(graph, body, pair, None) })
}

/// A node where two indices have an order; `None` if they are merely not equal.
pub(super) fn in_order(graph: &mut Graph, node: NodeId, [a, b]: [LoopId; 2], order: Option<Ordering>) -> NodeId {
    let pair = [a, b].map(Index::Running);
    rewritten(graph, node, |graph, id| {
        let Node::CompareIndex(comparison, x, y) = graph.node(id) else { return None };
        let named = [x, y].map(|index| graph.loops.index(index));
        let order = match named {
            _ if named == pair => order,
            _ if named == [pair[1], pair[0]] => order.map(Ordering::reverse),
            _ => return None,
        };
        let holds = match (comparison, order) {
            (Comparison::Equal, _) => order == Some(Ordering::Equal),
            (_, None) => return None,
            (Comparison::Less, Some(order)) => order.is_lt(),
            (Comparison::LessOrEqual, Some(order)) => order.is_le(),
        };
        Some(graph.truth(holds))
    })
}
