//! Flat coordinates as points: `q[3 * i + k]` is component `k` of body `i`.
//!
//! In: an energy of flat coordinates. Out: the same energy of points, or nothing where an index has another form. Always true:
//! the point and the component name the number that the index names, if the number of coordinates is a multiple of the number
//! of components.

use super::order::rewritten;
use crate::graph::{
    Element, Graph, MOST_COMPONENTS, Node, NodeId, Part,
    index::{Index, IndexId, Loop, LoopId, LoopSet},
    rename::Parameters,
};
use std::collections::HashMap;

/// The number of components of the points that flat positions are: the factor that all indices of positions have in common.
pub(crate) fn components(graph: &Graph, potential: NodeId) -> Option<u64> {
    let mut found = None;
    for id in graph.reachable([potential]) {
        let Node::Coordinate(Element { part: Part::Position, index, .. }) = graph.node(id) else { continue };
        let Some(factor) = factor(graph, index) else { continue };
        if found.is_some_and(|known| known != factor) {
            return None;
        }
        found = Some(factor);
    }
    found.filter(|components| (2..=MOST_COMPONENTS).contains(components))
}

/// The number that an index is a multiple of, but for an addend.
fn factor(graph: &Graph, index: IndexId) -> Option<u64> {
    match graph.loops.index(index) {
        Index::Add(a, b) => factor(graph, a).or_else(|| factor(graph, b)),
        Index::Mul(a, b) => graph.loops.literal(a).or_else(|| graph.loops.literal(b)),
        _ => None,
    }
}

/// The energy of `length` flat coordinates as one of points.
pub(crate) fn of_points(
    graph: &mut Graph,
    energy: NodeId,
    components: u64,
    length: IndexId,
    parameters: &mut dyn Parameters,
) -> Option<NodeId> {
    let mut points = Points { components, length, loops: HashMap::new() };
    let mut new: HashMap<NodeId, NodeId> = HashMap::new();
    let nodes = graph.reachable([energy]);
    for id in nodes.iter().copied() {
        if let Node::Coordinate(element) = graph.node(id) {
            let element = points.element(graph, element, parameters)?;
            new.insert(id, graph.coordinate(element));
        }
    }
    for id in nodes {
        let of = |id: NodeId| new.get(&id).copied().unwrap_or(id);
        // The constructor of a sum guards it where it has to be: fewer reads of points have to be than of numbers.
        if let Some(sum) = graph.guarded_sum(id) {
            let sum = of(sum);
            new.insert(id, sum);
            continue;
        }
        let node = match graph.node(id) {
            Node::Coordinate(_) => of(id),
            Node::Parameter(parameter) => match points.split_around(graph, id) {
                Some((by, point)) => {
                    let of_point = parameters.of_point(graph, parameter, by, components, point)?;
                    graph.parameter(of_point)
                }
                None => id,
            },
            Node::Sum(by, body) => match points.loops.get(&by).copied() {
                Some([point, component]) => {
                    // Numbers of the system by the index of a coordinate are not those of a body.
                    if graph.loops_of(of(body)).contains(by) {
                        return None;
                    }
                    let inner = graph.sum(component, of(body));
                    graph.sum(point, inner)
                }
                None => graph.sum(by, of(body)),
            },
            Node::External(..) => return None,
            node if node.children().all(|child| of(child) == child) => id,
            Node::Select(condition, a, b) => graph.select(of(condition), of(a), of(b)),
            node => graph.rebuilt(node.map(of)),
        };
        new.insert(id, node);
    }
    Some(new[&energy])
}

/// The number of points that `length` flat coordinates are.
pub(crate) fn number_of_points(graph: &mut Graph, length: IndexId, components: u64) -> IndexId {
    let components = graph.loops.intern(Index::Literal(components));
    graph.loops.intern(Index::Div(length, components))
}

/// The energy of points as one of flat coordinates.
pub(crate) fn of_numbers(graph: &mut Graph, energy: NodeId, components: u64) -> NodeId {
    rewritten(graph, energy, |graph, id| {
        let Node::Coordinate(element @ Element { index, component: Some(component), .. }) = graph.node(id) else {
            return None;
        };
        let factor = graph.loops.intern(Index::Literal(components));
        let first = graph.loops.intern(Index::Mul(factor, index));
        let index = graph.loops.intern(Index::Add(first, component));
        Some(graph.coordinate(Element { index, component: None, ..element }))
    })
}

struct Points {
    components: u64,
    length: IndexId,
    /// The loops over points and over components that take the place of a loop over all coordinates.
    loops: HashMap<LoopId, [LoopId; 2]>,
}

impl Points {
    /// The component of a point that a flat coordinate is.
    fn element(&mut self, graph: &mut Graph, element: Element, parameters: &mut dyn Parameters) -> Option<Element> {
        let (index, component) = match graph.loops.index(element.index) {
            Index::Literal(number) => [number / self.components, number % self.components]
                .map(|number| graph.loops.intern(Index::Literal(number)))
                .into(),
            Index::Running(by) => {
                self.split(graph, by, parameters)?.map(|by| graph.loops.intern(Index::Running(by))).into()
            }
            Index::Mul(..) => (self.multiple(graph, element.index)?, graph.loops.intern(Index::Literal(0))),
            Index::Add(a, b) => match (self.multiple(graph, a), self.multiple(graph, b)) {
                (Some(point), None) => (point, b),
                (None, Some(point)) => (point, a),
                _ => return None,
            },
            _ => return None,
        };
        self.is_component(graph, component).then_some(Element { index, component: Some(component), ..element })
    }

    /// The index `i` of the point in `components * i`. A number of the system may be that of the coordinates after all points.
    fn multiple(&self, graph: &Graph, index: IndexId) -> Option<IndexId> {
        let point = self.quotient(graph, index)?;
        (graph.loops.literal(point).is_some() || !graph.loops.of_index(point).is_empty()).then_some(point)
    }

    /// The other factor of a multiple of the number of components.
    fn quotient(&self, graph: &Graph, index: IndexId) -> Option<IndexId> {
        let Index::Mul(a, b) = graph.loops.index(index) else { return None };
        let is_factor = |id| graph.loops.literal(id) == Some(self.components);
        if is_factor(a) { Some(b) } else { is_factor(b).then_some(a) }
    }

    /// Whether an index is less than the number of components in all iterations.
    fn is_component(&self, graph: &Graph, index: IndexId) -> bool {
        match graph.loops.index(index) {
            Index::Literal(number) => number < self.components,
            Index::Running(by) => graph.loops.literal(graph.loops.get(by).to).is_some_and(|to| to <= self.components),
            _ => false,
        }
    }

    /// The loop over all coordinates that a number depends on, and the loop over points in its place.
    fn split_around(&self, graph: &Graph, id: NodeId) -> Option<(LoopId, LoopId)> {
        let by = graph.loops_of(id).iter().find(|by| self.loops.contains_key(by))?;
        Some((by, self.loops[&by][0]))
    }

    /// The loops over points and components in place of one over all coordinates.
    fn split(&mut self, graph: &mut Graph, by: LoopId, parameters: &mut dyn Parameters) -> Option<[LoopId; 2]> {
        if let Some(known) = self.loops.get(&by) {
            return Some(*known);
        }
        let Loop { parent, from, to } = graph.loops.get(by);
        let is_full = graph.loops.count() + 2 > LoopSet::CAPACITY;
        if is_full || parent.is_some() || graph.loops.literal(from) != Some(0) {
            return None;
        }
        let factor = graph.loops.intern(Index::Literal(self.components));
        let point_end = match to == self.length {
            true => number_of_points(graph, self.length, self.components),
            false => self.quotient(graph, to)?,
        };
        let point = graph.loops.range(Loop { parent: None, from, to: point_end });
        let component = graph.loops.range(Loop { parent: Some(point), from, to: factor });
        for new in [point, component] {
            parameters.name_if_new(new, by);
        }
        self.loops.insert(by, [point, component]);
        Some([point, component])
    }
}
