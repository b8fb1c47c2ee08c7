//! Renaming of indices in expressions.

use super::{
    Element, Graph, Node, NodeId, ParameterId,
    index::{Index, IndexId, LoopId, LoopSet},
};

/// The texts behind parameters.
pub(crate) trait Parameters {
    /// The parameter that the user would have written with other indices; `None` where the text does not show it.
    fn rename(&mut self, graph: &mut Graph, id: ParameterId, renaming: Renaming) -> Option<ParameterId>;
    /// The parameters that a product is made of, each with its exponent; a parameter itself where it is no product.
    fn factors(&mut self, graph: &mut Graph, id: ParameterId) -> Vec<(ParameterId, i32)>;
    /// Whether a parameter is the negative of another one by its text, and that one, without a condition around it on indices
    /// and the number of bodies.
    fn bare(&mut self, _graph: &mut Graph, id: ParameterId) -> (bool, ParameterId) {
        (false, id)
    }
    /// A number and the parameter that a parameter is a multiple of by its text; one and itself where it is none.
    fn multiple(&mut self, _graph: &mut Graph, id: ParameterId) -> (f64, ParameterId) {
        (1.0, id)
    }
    /// The parameter that is one where the index of a loop is zero, or where it is not, and zero elsewhere.
    fn indicator(&mut self, _graph: &mut Graph, _by: LoopId, _is_zero: bool) -> Option<ParameterId> {
        None
    }
    /// The parameter that has its value at one where the index of a loop is zero; `None` as for others.
    fn behind_first(&mut self, _graph: &mut Graph, _id: ParameterId, _by: LoopId) -> Option<ParameterId> {
        None
    }
    /// A condition of parameters as one on a number of each body of a pair. The number of a body is not read at the end that is
    /// given for the body. `None` if the text depends on more than that.
    fn flag(
        &mut self,
        _graph: &mut Graph,
        _id: ParameterId,
        _pair: [LoopId; 2],
        _ends: [Option<End>; 2],
    ) -> Option<NodeId> {
        None
    }
    /// A parameter of both bodies of a pair as the entry of a table, by the classes of the bodies that it distinguishes; `None`
    /// where its text does not show these.
    fn entry(
        &mut self,
        _graph: &mut Graph,
        _id: ParameterId,
        _pair: [LoopId; 2],
        _ends: [Option<End>; 2],
    ) -> Option<NodeId> {
        None
    }
    /// A parameter of a body and two others without conditions around it that two of them differ, which loops leave out.
    fn of_distinct(&mut self, _graph: &mut Graph, id: ParameterId, _bodies: [LoopId; 3]) -> ParameterId {
        id
    }
    /// A choice between numbers by conditions on both bodies of a pair as the entry of a table; `None` as for others.
    fn choice(
        &mut self,
        _graph: &mut Graph,
        _id: NodeId,
        _pair: [LoopId; 2],
        _ends: [Option<End>; 2],
    ) -> Option<NodeId> {
        None
    }
    /// A sum of entries of tables as the entry of one table; `None` as for others.
    fn sum(&mut self, _graph: &mut Graph, _id: NodeId, _pair: [LoopId; 2], _ends: [Option<End>; 2]) -> Option<NodeId> {
        None
    }
    /// The parameter as a number that is zero at one end of a loop and does not read its list there; `None` as for others.
    fn without(
        &mut self,
        _graph: &mut Graph,
        _id: ParameterId,
        _is_integer: bool,
        _by: LoopId,
        _end: End,
    ) -> Option<ParameterId> {
        None
    }
    /// The parameter with the index of a point in place of that of a coordinate divided by the number of components; `None` where
    /// its text reads the index otherwise.
    fn of_point(
        &mut self,
        _graph: &mut Graph,
        _id: ParameterId,
        _by: LoopId,
        _components: u64,
        _point: LoopId,
    ) -> Option<ParameterId> {
        None
    }
    /// The least and the greatest value of a parameter of one body over all bodies, but for the body at an end; `None` as for
    /// others.
    fn extremes(
        &mut self,
        _graph: &mut Graph,
        _id: ParameterId,
        _by: LoopId,
        _end: Option<End>,
    ) -> Option<[ParameterId; 2]> {
        None
    }
    /// The least and the greatest entry of a table.
    fn extreme_entries(&mut self, _graph: &mut Graph, _table: ParameterId) -> Option<[ParameterId; 2]> {
        None
    }
    /// The parameter of a body that is one of its densities, which the runtime computes; `None` as for others.
    fn density(&mut self, _graph: &mut Graph, _by: LoopId, _number: usize) -> Option<ParameterId> {
        None
    }
    /// Calls the index of a new loop nearly as that of another one.
    fn name(&mut self, new: LoopId, like: LoopId);
    /// The same where it has no name yet.
    fn name_if_new(&mut self, _new: LoopId, _like: LoopId) {}
}

/// The first or the last index of a loop over all bodies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum End {
    First,
    Last,
}

/// What takes the place of a loop's index.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Place {
    Loop(LoopId),
    Number(u64),
}

/// A simultaneous replacement of loops' indices, each by that of another loop or by a number.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Renaming([(LoopId, Place); 2]);

impl Renaming {
    /// One index by another.
    pub(crate) fn one(from: LoopId, to: LoopId) -> Self {
        Self::to(from, Place::Loop(to))
    }

    /// One index by another, or by a number.
    pub(crate) fn to(from: LoopId, place: Place) -> Self {
        Self([(from, place); 2])
    }

    /// Two indices, each by another.
    pub(crate) fn both(from: [LoopId; 2], to: [LoopId; 2]) -> Self {
        Self([(from[0], Place::Loop(to[0])), (from[1], Place::Loop(to[1]))])
    }

    /// Two indices by each other.
    pub(crate) fn exchange([first, second]: [LoopId; 2]) -> Self {
        Self::both([first, second], [second, first])
    }

    /// What stands where the index of `by` was.
    pub(crate) fn of(self, by: LoopId) -> Place {
        self.0.iter().find(|(from, _)| *from == by).map_or(Place::Loop(by), |(_, to)| *to)
    }

    /// Whether none of these indices is replaced.
    pub(crate) fn keeps(self, loops: LoopSet) -> bool {
        loops.iter().all(|by| self.of(by) == Place::Loop(by))
    }

    /// An integer expression for the other indices; `None` of what is looked up in a list by one of them.
    pub(crate) fn index(self, graph: &mut Graph, id: IndexId) -> Option<IndexId> {
        let known = graph.loops.index(id);
        let index = match (known, known.operands()) {
            _ if self.keeps(graph.loops.of_index(id)) => return Some(id),
            (Index::Running(by), _) => match self.of(by) {
                Place::Loop(to) => Index::Running(to),
                Place::Number(value) => Index::Literal(value),
            },
            (_, Some([a, b])) => known.with_operands([self.index(graph, a)?, self.index(graph, b)?]),
            (_, None) => return None,
        };
        Some(graph.loops.intern(index))
    }

    /// A coordinate for the other indices.
    pub(crate) fn element(self, graph: &mut Graph, element: Element) -> Option<Element> {
        let component = match element.component {
            Some(component) => Some(self.index(graph, component)?),
            None => None,
        };
        Some(Element { index: self.index(graph, element.index)?, component, ..element })
    }
}

/// Renames the indices of a prepared node; `None` where a parameter has no such text.
pub(crate) fn rename(
    graph: &mut Graph,
    id: NodeId,
    renaming: Renaming,
    parameters: &mut dyn Parameters,
) -> Option<NodeId> {
    if renaming.keeps(graph.loops_of(id)) {
        return Some(id);
    }
    let mut of = |graph: &mut Graph, id| rename(graph, id, renaming, parameters);
    let node = match graph.node(id) {
        Node::Parameter(parameter) => Node::Parameter(parameters.rename(graph, parameter, renaming)?),
        Node::FromIndex(index) => Node::FromIndex(match graph.loops.index(index) {
            Index::Parameter(parameter) => {
                let parameter = parameters.rename(graph, parameter, renaming)?;
                graph.loops.intern(Index::Parameter(parameter))
            }
            _ => renaming.index(graph, index)?,
        }),
        Node::Coordinate(element) => Node::Coordinate(renaming.element(graph, element)?),
        Node::Neg(a) => Node::Neg(of(graph, a)?),
        Node::Add(a, b) => Node::Add(of(graph, a)?, of(graph, b)?),
        Node::Mul(a, b) => Node::Mul(of(graph, a)?, of(graph, b)?),
        Node::Div(a, b) => Node::Div(of(graph, a)?, of(graph, b)?),
        Node::Power(a, halves) => Node::Power(of(graph, a)?, halves),
        Node::Unary(function, a) => Node::Unary(function, of(graph, a)?),
        Node::Binary(function, a, b) => Node::Binary(function, of(graph, a)?, of(graph, b)?),
        Node::Entry(table, a, b) => Node::Entry(table, of(graph, a)?, of(graph, b)?),
        Node::Sum(by, body) => Node::Sum(by, of(graph, body)?),
        Node::Fold(fold, by, body) => Node::Fold(fold, by, of(graph, body)?),
        Node::Compare(comparison, a, b) => Node::Compare(comparison, of(graph, a)?, of(graph, b)?),
        Node::And(a, b) => Node::And(of(graph, a)?, of(graph, b)?),
        Node::Or(a, b) => Node::Or(of(graph, a)?, of(graph, b)?),
        Node::Not(a) => Node::Not(of(graph, a)?),
        Node::Select(condition, a, b) => Node::Select(of(graph, condition)?, of(graph, a)?, of(graph, b)?),
        Node::CompareIndex(comparison, a, b) => {
            Node::CompareIndex(comparison, renaming.index(graph, a)?, renaming.index(graph, b)?)
        }
        Node::Flag(_) | Node::External(..) => return None,
        same @ (Node::Constant(_) | Node::Time | Node::Middle | Node::Step) => same,
    };
    Some(graph.rebuilt(node))
}
