//! Loops over the components of points inside of loops over pairs, written out.
//!
//! In: an energy. Out: the same energy, in which each such sum is a chain of additions in the order of the loop, so that an energy
//! has the same code whether its user writes the loop or its terms. A sum stays as it is if a parameter in it cannot be renamed.

use super::{order::rewritten, renamed::renamed};
use crate::graph::{
    Element, Graph, Node, NodeId,
    index::LoopId,
    rename::{Parameters, Place, Renaming},
    unroll::components,
};

/// The maximum number of terms that a sum is written out to, sums in it included.
const TERMS: u64 = 16;

/// An energy whose sums over components inside of two other loops are written out.
pub(crate) fn written_out(graph: &mut Graph, energy: NodeId, parameters: &mut dyn Parameters) -> NodeId {
    rewritten(graph, energy, |graph, id| match graph.node(id) {
        Node::Sum(by, _) if is_in_pair(graph, by) => terms(graph, id, parameters),
        _ => None,
    })
}

/// Whether a loop is inside of two others.
fn is_in_pair(graph: &Graph, by: LoopId) -> bool {
    graph.loops.get(by).parent.is_some_and(|parent| graph.loops.get(parent).parent.is_some())
}

/// Whether a node reads the components of a point by the index of a loop.
fn reads_by(graph: &Graph, root: NodeId, by: LoopId) -> bool {
    graph.reachable([root]).into_iter().any(|id| match graph.node(id) {
        Node::Coordinate(Element { component: Some(component), .. }) => graph.loops.of_index(component).contains(by),
        _ => false,
    })
}

/// A sum as a chain of additions; `None` if it stays as it is.
fn terms(graph: &mut Graph, id: NodeId, parameters: &mut dyn Parameters) -> Option<NodeId> {
    let Node::Sum(by, body) = graph.node(id) else { return None };
    let count = |by| components(graph, by).map(|numbers| numbers.end - numbers.start);
    let product = graph.summed_in(id).iter().try_fold(1, |product: u64, by| product.checked_mul(count(by)?))?;
    if product > TERMS || !reads_by(graph, body, by) {
        return None;
    }
    let body = written_out(graph, body, parameters);
    let mut term =
        |graph: &mut Graph, number| renamed(graph, body, Renaming::to(by, Place::Number(number)), parameters);
    let mut numbers = components(graph, by)?;
    let first = term(graph, numbers.next()?)?;
    numbers.try_fold(first, |sum, number| {
        let term = term(graph, number)?;
        Some(graph.add(sum, term))
    })
}
