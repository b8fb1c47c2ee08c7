//! Attraction of two bodies by the inverse distance, and masses: the potentials for Jacobi coordinates.

use super::{addends, central::cofactor};
use crate::{
    differentiate::{Contribution, gradient},
    graph::{
        Element, Graph, Node, NodeId, Part, Scope,
        index::{Index, LoopId},
    },
};

/// The strength `c` of the attraction `-c / r` of a pair, `r` the distance of its two bodies with this number of
/// components; all other terms of its energy are left out. `None` where no term is of this form.
pub(crate) fn attraction(graph: &mut Graph, energy: NodeId, pair: [LoopId; 2], dimension: u64) -> Option<NodeId> {
    let one = graph.constant(-1.0);
    let mut open = vec![(energy, one)];
    let mut strength = None;
    while let Some((term, factor)) = open.pop() {
        if let Some(parts) = addends(graph, term, factor) {
            open.extend(parts);
        } else if let Node::Power(square, -1) = graph.node(term)
            && is_squared_distance(graph, square, pair, dimension)
        {
            strength = Some(match strength {
                Some(sum) => graph.add(sum, factor),
                None => factor,
            });
        }
    }
    strength
}

/// What is added to the square of the distance of a softened attraction: a term that does not move, under a root.
pub(crate) fn softening(graph: &mut Graph, energy: NodeId, pair: [LoopId; 2], dimension: u64) -> Option<NodeId> {
    graph.reachable([energy]).into_iter().find_map(|id| {
        let Node::Power(square, -1 | 1) = graph.node(id) else { return None };
        let (mut moving, mut fixed, mut open) = (graph.constant(0.0), None, vec![square]);
        while let Some(term) = open.pop() {
            match graph.node(term) {
                Node::Add(a, b) => open.extend([b, a]),
                _ if graph.is_prepared(term) => fixed = Some(term),
                _ => moving = graph.add(moving, term),
            }
        }
        fixed.filter(|_| is_squared_distance(graph, moving, pair, dimension))
    })
}

/// Whether a node is the square of the distance of two bodies: its gradient is twice their displacement, and it is a sum
/// of terms that move.
fn is_squared_distance(graph: &mut Graph, square: NodeId, pair: [LoopId; 2], dimension: u64) -> bool {
    if !all_terms_move(graph, square) {
        return false;
    }
    let gradient = gradient(graph, square, Part::Position);
    pair.into_iter().zip([pair[1], pair[0]]).all(|(by, other)| {
        let own = gradient.iter().filter(|one| graph.loops.index(one.element.index) == Index::Running(by)).cloned();
        let own: Vec<Contribution> = own.collect();
        let twice = multiple(graph, &own, dimension, |graph, element| {
            let index = graph.loops.intern(Index::Running(other));
            let [here, there] = [element, Element { index, ..element }].map(|element| graph.coordinate(element));
            [graph.sub(here, there), graph.sub(there, here)]
        });
        twice.and_then(|twice| graph.as_constant(twice)) == Some(2.0)
    })
}

/// Whether all terms of a sum depend on positions.
fn all_terms_move(graph: &Graph, id: NodeId) -> bool {
    match graph.node(id) {
        Node::Add(a, b) => all_terms_move(graph, a) && all_terms_move(graph, b),
        Node::Sum(_, body) => all_terms_move(graph, body),
        _ => graph.reads(id, Part::Position),
    }
}

/// What the momentum of a body is multiplied by, for its velocity, in this number of components; `None` where the
/// velocity is something else.
pub(crate) fn inverse_mass(graph: &mut Graph, velocity: &[Contribution], dimension: u64) -> Option<NodeId> {
    let factor = multiple(graph, velocity, dimension, |graph, element| {
        let momentum = graph.coordinate(element);
        [momentum, graph.neg(momentum)]
    })?;
    graph.is_prepared(factor).then_some(factor)
}

/// The number that each component of a vector, or of its opposite, is multiplied by in a gradient of this number of
/// components.
fn multiple(
    graph: &mut Graph,
    gradient: &[Contribution],
    dimension: u64,
    mut of: impl FnMut(&mut Graph, Element) -> [NodeId; 2],
) -> Option<NodeId> {
    let (mut factor, mut components) = (None, 0);
    for Contribution { context, element, value } in gradient {
        components += match (&context[..], element.component.map(|component| graph.loops.index(component))) {
            ([], None | Some(Index::Literal(_))) => 1,
            ([Scope::Loop(by)], Some(Index::Running(component))) if *by == component => {
                let range = graph.loops.get(component);
                let [from, to] = [range.from, range.to].map(|bound| graph.loops.literal(bound));
                to?.checked_sub(from?)?
            }
            _ => return None,
        };
        let [component, opposite] = of(graph, *element);
        let found = match cofactor(graph, *value, component) {
            Some(found) => found,
            None => {
                let found = cofactor(graph, *value, opposite)?;
                graph.neg(found)
            }
        };
        if *factor.get_or_insert(found) != found {
            return None;
        }
    }
    factor.filter(|_| components == dimension)
}
