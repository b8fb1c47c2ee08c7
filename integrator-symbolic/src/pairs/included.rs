//! Conditions of the indices and parameters of a pair without which it contributes nothing, such as that its bodies are not of the
//! same molecule.
//!
//! In: the energy of a pair. Out: the condition, and the energy of the pairs for which it holds. Always true: the energy is zero for
//! all other pairs, wherever the bodies are, so lists of neighbours may leave them out.

use super::{exchange::Forms, order::rewritten};
use crate::graph::{Graph, Node, NodeId, index::LoopId};
use std::collections::{BTreeMap, HashMap};

/// Conditions, each with the value without which an energy is zero.
type Required = BTreeMap<NodeId, bool>;

/// The condition under which a pair has an energy, and the energy there; `None` if it has one for all indices, or if the condition
/// changes where the bodies are exchanged.
pub(super) fn included(
    graph: &mut Graph,
    energy: NodeId,
    pair: [LoopId; 2],
    forms: &mut Forms<'_>,
) -> Option<(NodeId, NodeId)> {
    let required = required(graph, energy, pair).filter(|required| !required.is_empty())?;
    let mut condition = graph.truth(true);
    for (one, holds) in &required {
        let one = if *holds { *one } else { graph.not(*one) };
        condition = graph.and(condition, one);
    }
    let both = [false, true].map(|exchanged| forms.of(graph, condition, exchanged));
    if both[0].is_none() || both[0] != both[1] {
        return None;
    }
    let inner = rewritten(graph, energy, |graph, id| required.get(&id).map(|holds| graph.truth(*holds)));
    Some((condition, inner))
}

/// What a pair needs to have an energy; `None` if it never has one.
fn required(graph: &Graph, energy: NodeId, pair: [LoopId; 2]) -> Option<Required> {
    let all = |a: Option<Required>, b: Option<Required>| {
        let mut all = a?;
        all.extend(b?);
        Some(all)
    };
    let common = |a: Option<Required>, b: Option<Required>| match (a, b) {
        (Some(mut a), Some(b)) => {
            a.retain(|condition, holds| b.get(condition) == Some(holds));
            Some(a)
        }
        (a, b) => a.or(b),
    };
    let mut known: HashMap<NodeId, Option<Required>> = HashMap::new();
    for id in graph.reachable([energy]) {
        let of = |id| known.get(&id).cloned().unwrap_or_default();
        let found = match graph.node(id) {
            Node::Constant(_) if graph.as_constant(id) == Some(0.0) => None,
            Node::Neg(a) | Node::Power(a, 1..) => of(a),
            Node::Mul(a, b) => all(of(a), of(b)),
            Node::Div(a, b) if graph.is_prepared(b) => of(a),
            Node::Add(a, b) => common(of(a), of(b)),
            Node::Select(condition, a, b) => {
                let side = |side, holds| {
                    let mut own = Required::new();
                    of_condition(graph, condition, holds, pair, &mut own);
                    all(Some(own), of(side))
                };
                common(side(a, true), side(b, false))
            }
            _ => Some(Required::new()),
        };
        known.insert(id, found);
    }
    known.remove(&energy).flatten()
}

/// Adds the conditions of the pair's indices and parameters that follow from the value of a condition.
fn of_condition(graph: &Graph, condition: NodeId, holds: bool, pair: [LoopId; 2], known: &mut Required) {
    match graph.node(condition) {
        Node::Not(inner) => of_condition(graph, inner, !holds, pair, known),
        Node::And(a, b) if holds => [a, b].into_iter().for_each(|one| of_condition(graph, one, holds, pair, known)),
        Node::Or(a, b) if !holds => [a, b].into_iter().for_each(|one| of_condition(graph, one, holds, pair, known)),
        _ => {
            let loops = graph.loops_of(condition);
            if graph.is_prepared(condition) && pair.iter().any(|by| loops.contains(*by)) {
                known.insert(condition, holds);
            }
        }
    }
}
