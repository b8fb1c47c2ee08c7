//! Terms of pairs in other loops over the two bodies.

use super::order::rewritten;
use crate::graph::{
    Graph, Node, NodeId,
    index::{Loop, LoopId, LoopSet},
    rename::{Parameters, Place, Renaming, rename},
};

/// A node with other indices; `None` where a parameter has no such text.
pub(crate) fn renamed(
    graph: &mut Graph,
    root: NodeId,
    renaming: Renaming,
    parameters: &mut dyn Parameters,
) -> Option<NodeId> {
    let mut fits = true;
    let new = rewritten(graph, root, |graph, id| {
        if let Node::Sum(by, body) = graph.node(id)
            && let Some(inner) = loop_there(graph, by, renaming, parameters)
        {
            let body = renamed(graph, body, renaming, parameters);
            let body = body.and_then(|body| renamed(graph, body, Renaming::one(by, inner), parameters));
            fits &= body.is_some();
            return body.map(|body| graph.sum(inner, body));
        }
        if graph.node(id).children().next().is_some() || renaming.keeps(graph.loops_of(id)) {
            return None;
        }
        let renamed = rename(graph, id, renaming, parameters);
        fits &= renamed.is_some();
        renamed
    });
    fits.then_some(new)
}

/// The loop over components inside of the new loops over a pair, in place of one inside of the old ones.
fn loop_there(graph: &mut Graph, by: LoopId, renaming: Renaming, parameters: &mut dyn Parameters) -> Option<LoopId> {
    let Loop { parent, from, to } = graph.loops.get(by);
    let (second, first) = (parent?, graph.loops.get(parent?).parent?);
    let (Place::Loop(a), Place::Loop(b)) = (renaming.of(second), renaming.of(first)) else { return None };
    let is_inside = |inner: LoopId, outer: LoopId| graph.loops.get(inner).parent == Some(outer);
    let innermost = if is_inside(a, b) { a } else { Some(b).filter(|b| is_inside(*b, a))? };
    if innermost == second || graph.loops.count() >= LoopSet::CAPACITY {
        return None;
    }
    let [from, to] = [renaming.index(graph, from)?, renaming.index(graph, to)?];
    let inner = graph.loops.range(Loop { parent: Some(innermost), from, to });
    parameters.name_if_new(inner, by);
    Some(inner)
}
