//! Loops over the components of a point, written out.
//!
//! In: values with sums over components. Out: the same values, in which each such sum is a chain of additions in the order of the
//! loop. So the loops around them are innermost ones. A value is left as it is where it reads lists by component.

use super::{
    Element, Graph, MOST_COMPONENTS, Node, NodeId,
    index::{Index, LoopId},
};
use std::{collections::HashMap, ops::Range};

/// Values with sums over components written out, so far.
#[derive(Default)]
pub(crate) struct Unrolled {
    values: HashMap<NodeId, Option<NodeId>>,
    items: HashMap<(NodeId, LoopId, u64), Option<NodeId>>,
}

impl Unrolled {
    /// A value with its sums over components written out; `None` where that is not possible.
    pub(crate) fn value(&mut self, graph: &mut Graph, root: NodeId) -> Option<NodeId> {
        for id in graph.reachable([root]) {
            if !self.values.contains_key(&id) {
                let value = self.of_children(graph, id);
                self.values.insert(id, value);
            }
        }
        self.values[&root]
    }

    /// The same for a node whose children have such values.
    fn of_children(&mut self, graph: &mut Graph, id: NodeId) -> Option<NodeId> {
        let node = graph.node(id);
        if graph.is_prepared(id) || graph.summed_in(id).is_empty() {
            return Some(id);
        }
        let mapped = mapped(node, |child| self.values[&child])?;
        match mapped {
            Node::Sum(by, body) if components(graph, by).is_some() => {
                let numbers = components(graph, by)?;
                let mut sum = self.item(graph, body, by, numbers.start)?;
                for number in numbers.skip(1) {
                    let item = self.item(graph, body, by, number)?;
                    sum = graph.add(sum, item);
                }
                Some(sum)
            }
            _ if mapped == node => Some(id),
            _ => Some(graph.rebuilt(mapped)),
        }
    }

    /// A value for one component of a loop over them; `None` if it reads more than coordinates by component.
    pub(crate) fn item(&mut self, graph: &mut Graph, root: NodeId, by: LoopId, number: u64) -> Option<NodeId> {
        for id in graph.reachable([root]) {
            if !self.items.contains_key(&(id, by, number)) {
                let item = self.item_of_children(graph, id, by, number);
                self.items.insert((id, by, number), item);
            }
        }
        self.items[&(root, by, number)]
    }

    fn item_of_children(&self, graph: &mut Graph, id: NodeId, by: LoopId, number: u64) -> Option<NodeId> {
        if !graph.loops_of(id).contains(by) {
            return Some(id);
        }
        match graph.node(id) {
            Node::Coordinate(element) => {
                let element = component(graph, element, by, number)?;
                Some(graph.rebuilt(Node::Coordinate(element)))
            }
            Node::Parameter(_)
            | Node::Entry(..)
            | Node::FromIndex(_)
            | Node::CompareIndex(..)
            | Node::Flag(_)
            | Node::External(..) => None,
            Node::Sum(inner, _) | Node::Fold(_, inner, _) if graph.loops.of_range(inner).contains(by) => None,
            node => mapped(node, |child| self.items[&(child, by, number)]).map(|node| graph.rebuilt(node)),
        }
    }
}

/// A node with other children; `None` if one has no other.
fn mapped(node: Node, of: impl Fn(NodeId) -> Option<NodeId>) -> Option<Node> {
    node.children().all(|child| of(child).is_some()).then(|| node.map(|child| of(child).unwrap_or(child)))
}

/// The components that a loop runs over, if it runs over the first few numbers and reads coordinates by component alone.
pub(crate) fn components(graph: &Graph, by: LoopId) -> Option<Range<u64>> {
    let range = graph.loops.get(by);
    let (from, to) = (graph.loops.literal(range.from)?, graph.loops.literal(range.to)?);
    (from < to && to <= MOST_COMPONENTS).then_some(from..to)
}

/// A coordinate whose component is the index of a loop, for one of its numbers.
pub(crate) fn component(graph: &mut Graph, element: Element, by: LoopId, number: u64) -> Option<Element> {
    let own = element.component.is_some_and(|component| graph.loops.index(component) == Index::Running(by));
    let is_elsewhere = graph.loops.of_index(element.index).contains(by);
    if is_elsewhere || !own {
        return None;
    }
    let component = graph.loops.intern(Index::Literal(number));
    Some(Element { component: Some(component), ..element })
}
