//! Forces along the line between two bodies: a gradient that is a multiple of their displacement.

use crate::{
    differentiate::{Contribution, fold_branches},
    graph::{
        Element, Graph, Node, NodeId, Part,
        index::{Index, LoopId},
    },
};

/// The number that the displacement from the second body of a pair to the first is to be multiplied by, if the gradient
/// of the pair's energy, with a component for each of `dimension` coordinates, is a multiple of it.
pub(crate) fn pull(graph: &mut Graph, pair: [LoopId; 2], gradient: &[Contribution], dimension: u64) -> Option<NodeId> {
    let components = fold_branches(graph, gradient);
    let (first, others) = components.split_first()?;
    let pull = along(graph, pair, first)?;
    let complete = components.len() as u64 == dimension;
    let alike = others.iter().all(|other| along(graph, pair, other) == Some(pull));
    (complete && alike).then_some(pull)
}

/// A component of the gradient over that of the displacement.
fn along(graph: &mut Graph, pair: [LoopId; 2], component: &Contribution) -> Option<NodeId> {
    let Contribution { context, element, value } = component;
    if !context.is_empty() {
        return None;
    }
    let [first, second] = pair.map(|by| {
        let index = graph.loops.intern(Index::Running(by));
        graph.coordinate(Element { part: Part::Position, index, component: element.component })
    });
    let displacement = graph.sub(first, second);
    if let Some(pull) = cofactor(graph, *value, displacement) {
        return Some(pull);
    }
    let back = graph.sub(second, first);
    let pull = cofactor(graph, *value, back)?;
    Some(graph.neg(pull))
}

/// The cofactor of `factor` in `value`.
pub(super) fn cofactor(graph: &mut Graph, value: NodeId, factor: NodeId) -> Option<NodeId> {
    if value == factor {
        return Some(graph.constant(1.0));
    }
    match graph.node(value) {
        Node::Neg(x) => {
            let rest = cofactor(graph, x, factor)?;
            Some(graph.neg(rest))
        }
        Node::Mul(a, b) => match cofactor(graph, a, factor) {
            Some(rest) => Some(graph.mul(rest, b)),
            None => {
                let rest = cofactor(graph, b, factor)?;
                Some(graph.mul(a, rest))
            }
        },
        Node::Add(a, b) => {
            let [a, b] = [cofactor(graph, a, factor)?, cofactor(graph, b, factor)?];
            Some(graph.add(a, b))
        }
        Node::Select(condition, a, b) => {
            let [a, b] = [cofactor(graph, a, factor)?, cofactor(graph, b, factor)?];
            Some(graph.select(condition, a, b))
        }
        Node::Constant(_) if graph.as_constant(value) == Some(0.0) => Some(value),
        _ => None,
    }
}
