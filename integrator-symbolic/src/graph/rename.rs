//! Renaming of indices in expressions.

use super::{
    Element, Graph, Node, NodeId, ParameterId,
    index::{Index, IndexId, LoopId},
};

/// The texts behind parameters.
pub(crate) trait Parameters {
    /// The parameter that the user would have written with other indices; `None` where the text does not show it.
    fn rename(&mut self, graph: &mut Graph, id: ParameterId, renaming: Renaming) -> Option<ParameterId>;
    /// The parameters that a product is made of, each with its exponent; a parameter itself where it is no product.
    fn factors(&mut self, graph: &mut Graph, id: ParameterId) -> Vec<(ParameterId, i32)>;
    /// Calls the index of a new loop nearly as that of another one.
    fn name(&mut self, new: LoopId, like: LoopId);
}

/// A simultaneous replacement of loops' indices, each by that of another loop.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Renaming([(LoopId, LoopId); 2]);

impl Renaming {
    /// One index by another.
    pub(crate) fn one(from: LoopId, to: LoopId) -> Self {
        Self([(from, to); 2])
    }

    /// Two indices, each by another.
    pub(crate) fn both(from: [LoopId; 2], to: [LoopId; 2]) -> Self {
        Self([(from[0], to[0]), (from[1], to[1])])
    }

    /// Two indices by each other.
    pub(crate) fn exchange([first, second]: [LoopId; 2]) -> Self {
        Self([(first, second), (second, first)])
    }

    /// The loop whose index stands where that of `by` was.
    pub(crate) fn of(self, by: LoopId) -> LoopId {
        self.0.iter().find(|(from, _)| *from == by).map_or(by, |(_, to)| *to)
    }

    /// An integer expression for the other indices.
    pub(crate) fn index(self, graph: &mut Graph, id: IndexId) -> IndexId {
        let known = graph.loops.index(id);
        let index = match (known, known.operands()) {
            (Index::Running(by), _) => Index::Running(self.of(by)),
            (_, Some(both)) => known.with_operands(both.map(|id| self.index(graph, id))),
            (_, None) => known,
        };
        graph.loops.intern(index)
    }
}

/// Renames the indices of a prepared node; `None` where a parameter has no such text.
pub(crate) fn rename(
    graph: &mut Graph,
    id: NodeId,
    renaming: Renaming,
    parameters: &mut dyn Parameters,
) -> Option<NodeId> {
    if graph.loops_of(id).iter().all(|by| renaming.of(by) == by) {
        return Some(id);
    }
    let mut of = |graph: &mut Graph, id| rename(graph, id, renaming, parameters);
    let node = match graph.node(id) {
        Node::Parameter(parameter) => Node::Parameter(parameters.rename(graph, parameter, renaming)?),
        Node::FromIndex(index) => Node::FromIndex(renaming.index(graph, index)),
        Node::Coordinate(element) => {
            let component = element.component.map(|component| renaming.index(graph, component));
            Node::Coordinate(Element { index: renaming.index(graph, element.index), component, ..element })
        }
        Node::Neg(a) => Node::Neg(of(graph, a)?),
        Node::Add(a, b) => Node::Add(of(graph, a)?, of(graph, b)?),
        Node::Mul(a, b) => Node::Mul(of(graph, a)?, of(graph, b)?),
        Node::Div(a, b) => Node::Div(of(graph, a)?, of(graph, b)?),
        Node::Power(a, halves) => Node::Power(of(graph, a)?, halves),
        Node::Unary(function, a) => Node::Unary(function, of(graph, a)?),
        Node::Binary(function, a, b) => Node::Binary(function, of(graph, a)?, of(graph, b)?),
        Node::Sum(by, body) => Node::Sum(by, of(graph, body)?),
        Node::Fold(fold, by, body) => Node::Fold(fold, by, of(graph, body)?),
        Node::Compare(comparison, a, b) => Node::Compare(comparison, of(graph, a)?, of(graph, b)?),
        Node::And(a, b) => Node::And(of(graph, a)?, of(graph, b)?),
        Node::Or(a, b) => Node::Or(of(graph, a)?, of(graph, b)?),
        Node::Not(a) => Node::Not(of(graph, a)?),
        Node::Select(condition, a, b) => Node::Select(of(graph, condition)?, of(graph, a)?, of(graph, b)?),
        Node::CompareIndex(comparison, a, b) => {
            Node::CompareIndex(comparison, renaming.index(graph, a), renaming.index(graph, b))
        }
        Node::Flag(_) | Node::External(..) => return None,
        same @ (Node::Constant(_) | Node::Time | Node::Middle | Node::Step) => same,
    };
    Some(graph.rebuilt(node))
}
