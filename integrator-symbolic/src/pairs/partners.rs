//! Loops over the partners of a body.

use super::{
    merged::{in_one_direction, sum},
    order::rewritten,
    renamed::renamed,
};
use crate::graph::{
    Comparison, Graph, Node, NodeId,
    index::{Index, IndexId, Loop, LoopId, LoopSet},
    rename::{Parameters, Renaming},
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

/// What a loop over all other bodies adds, if the order of the indices decides that.
pub(super) struct Half {
    /// The loop over the bodies before the first of the pair.
    pub(super) before: LoopId,
    /// What both visits of a pair add.
    pub(super) addend: NodeId,
    /// Whether the second body of the pairs that add something has the larger index; `None` if both visits add something.
    pub(super) ascending: Option<bool>,
}

impl Half {
    pub(super) fn of(
        graph: &mut Graph,
        pair: [LoopId; 2],
        addend: NodeId,
        parameters: &mut dyn Parameters,
    ) -> Option<Self> {
        let [by, other] = pair;
        let visits = [Ordering::Less, Ordering::Greater].map(|order| in_order(graph, addend, pair, Some(order)));
        let [behind, before] = visits;
        if behind == before || graph.loops.count() >= LoopSet::CAPACITY {
            return None;
        }
        let exchanged = renamed(graph, behind, Renaming::exchange(pair), parameters)?;
        let both = [before, exchanged].map(|addend| in_one_direction(graph, addend, pair, parameters));
        let both = sum(graph, both, (pair, [None; 2]), parameters);
        let [from, to] = [Index::Literal(0), Index::Running(by)].map(|bound| graph.loops.intern(bound));
        let half = graph.loops.range(Loop { parent: Some(by), from, to });
        parameters.name_if_new(half, other);
        let ascending = match visits.map(|addend| graph.as_constant(addend) == Some(0.0)) {
            [false, true] => Some(true),
            [true, false] => Some(false),
            _ => None,
        };
        let addend = renamed(graph, both, Renaming::one(other, half), parameters)?;
        Some(Self { before: half, addend, ascending })
    }
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
