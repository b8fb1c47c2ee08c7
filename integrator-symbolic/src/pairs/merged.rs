//! Energies of pairs from several loops as one: the same distance is computed once, and the constants in front of the same function of
//! it are added.
//!
//! In: energies in the loops over one pair. Out: one that is equal up to rounding. Always true: displacements point from the second body
//! to the first in every term that stays the same if they do.

use super::{
    exchange::{Forms, is_symmetric},
    order::rewritten,
};
use crate::graph::{
    Element, Graph, Node, NodeId, Part,
    index::{Index, LoopId},
    rename::{End, Parameters},
};

/// An energy whose displacements point from the second body to the first, if it is equal to that.
pub(super) fn in_one_direction(
    graph: &mut Graph,
    energy: NodeId,
    pair: [LoopId; 2],
    parameters: &mut dyn Parameters,
) -> NodeId {
    let mut is_opposite = false;
    let reachable = graph.reachable([energy]);
    for id in &reachable {
        if let Some((index, other)) = in_place_of(graph, *id, pair) {
            let displacement = graph.sub(other, *id);
            is_opposite |= index == 0 && reachable.contains(&displacement);
        }
    }
    if !is_opposite {
        return energy;
    }
    let turned = rewritten(graph, energy, |graph, id| Some(in_place_of(graph, id, pair)?.1));
    let mut forms = Forms::new(pair, None, parameters);
    let both = [energy, turned].map(|energy| forms.of(graph, energy, false));
    if both[0].is_some() && both[0] == both[1] { turned } else { energy }
}

/// Which body of a pair has this coordinate, and the one of the other body.
fn in_place_of(graph: &mut Graph, id: NodeId, pair: [LoopId; 2]) -> Option<(usize, NodeId)> {
    let Node::Coordinate(element @ Element { part: Part::Position, .. }) = graph.node(id) else { return None };
    let Index::Running(by) = graph.loops.index(element.index) else { return None };
    let own = pair.iter().position(|body| *body == by)?;
    let index = graph.loops.intern(Index::Running(pair[1 - own]));
    Some((own, graph.coordinate(Element { index, ..element })))
}

/// The sum of two energies, inside of a condition of both, and with a factor of both outside of the sum of their constants.
pub(super) fn sum(
    graph: &mut Graph,
    [a, b]: [NodeId; 2],
    of: ([LoopId; 2], [Option<End>; 2]),
    parameters: &mut dyn Parameters,
) -> NodeId {
    if let (Some((condition, of_a)), Some((other, of_b))) = (choice(graph, a), choice(graph, b))
        && condition == other
    {
        let [first, second] = [0, 1].map(|side| sum(graph, [of_a[side], of_b[side]], of, parameters));
        return graph.select(condition, first, second);
    }
    let (of_a, of_b) = (Product::of(graph, a), Product::of(graph, b));
    match of_a.moving.is_empty() || of_a.moving != of_b.moving {
        true => graph.add(a, b),
        false => {
            let constant = graph.add(of_a.constant, of_b.constant);
            let constant = looked_up_once(graph, constant, of, parameters).unwrap_or(constant);
            of_a.moving.into_iter().fold(constant, |product, factor| graph.mul(product, factor))
        }
    }
}

/// A sum of entries of tables as one entry. Where pairs come in both orders, the sum of two entries has to be the same in both.
fn looked_up_once(
    graph: &mut Graph,
    sum: NodeId,
    (pair, ends): ([LoopId; 2], [Option<End>; 2]),
    parameters: &mut dyn Parameters,
) -> Option<NodeId> {
    let are_both_orders = ends[0].is_none();
    let is_entry = |id: &NodeId| matches!(graph.node(*id), Node::Entry(..));
    let count = graph.reachable([sum]).iter().filter(|id| is_entry(id)).count();
    if are_both_orders && (count != 2 || !is_symmetric(graph, sum, pair, parameters)?) {
        return None;
    }
    let entry = parameters.sum(graph, sum, pair, ends)?;
    if are_both_orders
        && let Node::Entry(table, ..) = graph.node(entry)
        && let Node::Parameter(table) = graph.node(table)
    {
        graph.declare_symmetric(table);
    }
    Some(entry)
}

/// The condition of a choice, and both sides with the constants in front of it.
fn choice(graph: &mut Graph, id: NodeId) -> Option<(NodeId, [NodeId; 2])> {
    match graph.node(id) {
        Node::Select(condition, a, b) => Some((condition, [a, b])),
        Node::Neg(inner) => {
            let (condition, sides) = choice(graph, inner)?;
            Some((condition, sides.map(|side| graph.neg(side))))
        }
        Node::Mul(a, b) => {
            let (constant, inner) = if graph.is_prepared(a) { (a, b) } else { (b, a) };
            let (condition, sides) = choice(graph, inner).filter(|_| graph.is_prepared(constant))?;
            Some((condition, sides.map(|side| graph.mul(constant, side))))
        }
        _ => None,
    }
}

/// A product of what is prepared and of other factors.
struct Product {
    constant: NodeId,
    moving: Vec<NodeId>,
}

impl Product {
    fn of(graph: &mut Graph, id: NodeId) -> Self {
        let (mut constant, mut moving, mut open) = (graph.constant(1.0), Vec::new(), vec![id]);
        while let Some(id) = open.pop() {
            match graph.node(id) {
                _ if graph.is_prepared(id) => constant = graph.mul(constant, id),
                Node::Mul(a, b) => open.extend([a, b]),
                Node::Neg(a) => {
                    constant = graph.neg(constant);
                    open.push(a);
                }
                _ => moving.push(id),
            }
        }
        moving.sort();
        Self { constant, moving }
    }
}
