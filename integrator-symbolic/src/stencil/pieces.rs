//! Contributions with conditions on the position of a site, such as `if i + 1 < q.len() { .. }`, in pieces without
//! them.
//!
//! In: contributions. Out: the values of each on either side of its conditions, with the conditions that hold there,
//! which a direction converts to fewer iterations. Always true: in each iteration, the pieces whose conditions hold add
//! up to the contribution.

use super::computed;
use crate::{
    differentiate::Contribution,
    graph::{Graph, Node, NodeId, Scope},
};
use std::collections::{BTreeSet, HashMap};

/// The most pieces of a contribution: more are as slow as a plain loop.
const MOST: usize = 16;

/// Comparisons of integers, and whether each holds.
type Conditions = Vec<(NodeId, bool)>;

/// A contribution where conditions on the numbers of iterations hold.
pub(super) struct Piece {
    pub(super) contribution: Contribution,
    pub(super) conditions: Conditions,
}

/// The pieces of all contributions; `leaf` decides which nodes are read, not computed.
pub(super) fn pieces(
    graph: &mut Graph,
    gradient: &[Contribution],
    leaf: impl Fn(&Graph, NodeId) -> bool,
) -> Option<Vec<Piece>> {
    let mut pieces = Vec::new();
    for contribution in gradient {
        let (mut context, mut conditions) = (Vec::new(), Vec::new());
        for scope in &contribution.context {
            if let Scope::Branch(condition, holds) = *scope
                && let Some(compared) = compared(graph, condition)
            {
                conditions.push((compared, holds == (compared == condition)));
            } else {
                context.push(*scope);
            }
        }
        for (value, conditions) in split(graph, contribution.value, conditions, &leaf)? {
            let contribution = Contribution { context: context.clone(), element: contribution.element, value };
            pieces.push(Piece { contribution, conditions });
        }
    }
    Some(pieces)
}

/// The comparison of integers that a condition is, or is the opposite of.
fn compared(graph: &Graph, condition: NodeId) -> Option<NodeId> {
    match graph.node(condition) {
        Node::CompareIndex(..) => Some(condition),
        Node::Not(inner) if matches!(graph.node(inner), Node::CompareIndex(..)) => Some(inner),
        _ => None,
    }
}

/// The values of a contribution, each with the conditions under which it is one.
fn split(
    graph: &mut Graph,
    value: NodeId,
    conditions: Conditions,
    leaf: &impl Fn(&Graph, NodeId) -> bool,
) -> Option<Vec<(NodeId, Conditions)>> {
    let nodes = computed(graph, value, leaf);
    let of_sites = |id: &NodeId| matches!(graph.node(*id), Node::CompareIndex(..)) && !graph.loops_of(*id).is_empty();
    let Some(condition) = nodes.iter().copied().find(of_sites) else {
        let is_zero = graph.as_constant(value) == Some(0.0);
        return Some(if is_zero { Vec::new() } else { vec![(value, conditions)] });
    };
    let mut pieces = Vec::new();
    match graph.node(value) {
        // What other addends are does not depend on it.
        Node::Add(a, b) => {
            for addend in [a, b] {
                pieces.extend(split(graph, addend, conditions.clone(), leaf)?);
            }
        }
        Node::Neg(a) => {
            for (value, conditions) in split(graph, a, conditions, leaf)? {
                pieces.push((graph.neg(value), conditions));
            }
        }
        _ => {
            for holds in [true, false] {
                let truth = graph.truth(holds);
                let value = with(graph, value, (condition, truth), &nodes)?;
                let conditions = conditions.iter().copied().chain([(condition, holds)]).collect();
                pieces.extend(split(graph, value, conditions, leaf)?);
            }
        }
    }
    (pieces.len() <= MOST).then_some(pieces)
}

/// A value with another node in place of one; `None` where it is in a sum or in a method of the user.
fn with(graph: &mut Graph, value: NodeId, (from, to): (NodeId, NodeId), nodes: &BTreeSet<NodeId>) -> Option<NodeId> {
    let mut rebuilt: HashMap<NodeId, NodeId> = HashMap::from([(from, to)]);
    for id in nodes.iter().copied() {
        let node = graph.node(id);
        let of = |child: NodeId| rebuilt.get(&child).copied().unwrap_or(child);
        if id == from || node.children().all(|child| of(child) == child) {
            continue;
        }
        let new = match node {
            Node::Neg(a) => graph.neg(of(a)),
            Node::Add(a, b) => graph.add(of(a), of(b)),
            Node::Mul(a, b) => graph.mul(of(a), of(b)),
            Node::Div(a, b) => graph.div(of(a), of(b)),
            Node::Power(a, halves) => graph.power(of(a), halves),
            Node::Unary(function, a) => graph.unary(function, of(a)),
            Node::Binary(function, a, b) => graph.binary(function, of(a), of(b)),
            Node::Compare(comparison, a, b) => graph.compare(comparison, of(a), of(b)),
            Node::And(a, b) => graph.and(of(a), of(b)),
            Node::Or(a, b) => graph.or(of(a), of(b)),
            Node::Not(a) => graph.not(of(a)),
            Node::Select(condition, a, b) => graph.select(of(condition), of(a), of(b)),
            _ => return None,
        };
        rebuilt.insert(id, new);
    }
    Some(rebuilt.get(&value).copied().unwrap_or(value))
}
