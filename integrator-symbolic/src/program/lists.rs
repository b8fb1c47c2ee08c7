//! Loops over lists: sums whose terms name their coordinates by index, such as `for &(a, b) in &self.bonds`.
//!
//! In: a loop of a program. Out: the reads of a term, their lists, and the destinations of its values. The result is
//! nothing if terms depend on each other, or read coordinates that no list names. Always true: the program alone
//! determines whether values are rounded before they are added, so all code printed from it is bitwise identical.

use super::{
    Item, Sink, Store,
    nest::{Nest, NestContext},
};
use crate::graph::{
    Element, Graph, MOST_COMPONENTS, Node, NodeId, Part, Scope,
    index::{Index, IndexId, LoopId},
};
use crate::reason::Reason;
use std::collections::{BTreeMap, BTreeSet};

/// The fewest terms of which vectors are made where their number is known.
const FEWEST: u64 = 8;

/// The most values that a term adds or reads; a longer one would fill registers many times over.
const MOST: usize = 48;

/// The sum over a list: what its terms need.
pub(crate) struct ListSum<'p> {
    /// The number of components of a point, where coordinates are points.
    pub(crate) components: Option<usize>,
    /// The lines of a term.
    pub(crate) body: Vec<&'p Item>,
    /// The lists that name points.
    pub(crate) lists: Vec<IndexId>,
    /// The parts of the coordinates that terms read.
    pub(crate) parts: Vec<Part>,
    /// The points that a term reads, each of one of these parts and by one of the lists.
    pub(crate) reads: Vec<(usize, usize)>,
    /// The coordinates that it reads, each by its point and its component.
    pub(crate) coordinates: Vec<(NodeId, usize, usize)>,
    /// Its own numbers, which are elements of tables.
    pub(crate) constants: Vec<NodeId>,
    /// What all terms have in common.
    pub(crate) common: Vec<NodeId>,
    /// Where its values go: the list and the component of each.
    pub(crate) targets: Vec<(usize, usize)>,
}

/// Whether an iteration of a loop adds to coordinates that a list names: values are rounded before they are added, so that
/// those of several iterations may be computed in lanes.
pub(crate) fn is_over_list(graph: &Graph, by: LoopId, body: &[Item]) -> bool {
    body.iter().any(|line| adds_to_list(graph, by, line))
}

/// Whether a line adds to such coordinates.
pub(super) fn adds_to_list(graph: &Graph, by: LoopId, line: &Item) -> bool {
    match line {
        Item::Sink(Sink::Collect(element), _) => is_listed(graph, by, element.index),
        Item::Branch { body, .. } => is_over_list(graph, by, body),
        _ => false,
    }
}

/// Whether an index is an element of a list of the system, the loop's index being the last of its own.
fn is_listed(graph: &Graph, by: LoopId, index: IndexId) -> bool {
    match graph.loops.index(index) {
        Index::Parameter(parameter) => graph.loops.of_parameter(parameter).iter().last() == Some(by),
        _ => false,
    }
}

/// The stores in an order in which what a term of a list adds to one point stands together.
pub(super) fn by_point(graph: &Graph, stores: &[Store]) -> Vec<Store> {
    let point = |store: &Store| match (store.context.last(), store.sink) {
        (Some(Scope::Loop(by)), Sink::Collect(element)) if is_listed(graph, *by, element.index) => Some(element.index),
        _ => None,
    };
    let mut sorted = stores.to_vec();
    for term in sorted.chunk_by_mut(|a, b| a.context == b.context && point(a).is_some() == point(b).is_some()) {
        term.sort_by_key(point);
    }
    sorted
}

impl<'p> ListSum<'p> {
    /// The sum that a loop is, where points have this number of components; `is_table` decides which prepared numbers
    /// are kept in tables.
    pub(crate) fn of(
        graph: &Graph,
        components: Option<IndexId>,
        named: &BTreeSet<NodeId>,
        by: LoopId,
        body: &'p [Item],
        is_table: impl Fn(NodeId) -> bool,
    ) -> Result<Self, Reason> {
        if !is_over_list(graph, by, body) {
            return Err(Reason::NoList);
        }
        if literal_count(graph, by).is_some_and(|count| count < FEWEST) {
            return Err(Reason::FewTerms);
        }
        let context = NestContext { graph, named, operands: &BTreeMap::new() };
        let has_loop = body.iter().any(|item| matches!(item, Item::Loop { .. }));
        let reason = if has_loop { Reason::TermLoop } else { Reason::LoopBody };
        let mut nests = context.nests(by, body).ok_or(reason)?;
        let Nest { body, reads, constants, predicates, invariants, targets, .. } =
            nests.pop().ok_or(Reason::LoopBody)?;
        let obstacles = [
            (!nests.is_empty(), Reason::TermLoop),
            (!predicates.is_empty(), Reason::LoopCondition),
            (targets.len() > MOST || reads.len() > MOST, Reason::LongTerm),
            (body.iter().any(|line| computes(graph, named, line, is_called)), Reason::Method),
        ];
        if let Some((_, reason)) = obstacles.into_iter().find(|(is_met, _)| *is_met) {
            return Err(reason);
        }
        let components = read_together(graph, components).ok_or(Reason::Unrecognised)?;
        let mut sum = Self {
            components,
            body,
            lists: Vec::new(),
            parts: Vec::new(),
            reads: Vec::new(),
            coordinates: Vec::new(),
            constants: Vec::new(),
            common: invariants,
            targets: Vec::new(),
        };
        for (id, element) in reads {
            if graph.loops.of_element(element).contains(by) {
                let (list, component) = sum.place(graph, by, element).ok_or(Reason::TermIndex)?;
                let part = position(&mut sum.parts, element.part);
                let point = position(&mut sum.reads, (part, list));
                sum.coordinates.push((id, point, component));
            } else {
                sum.common.push(id);
            }
        }
        for id in constants {
            let loops = graph.loops_of(id);
            match loops.iter().last() == Some(by) {
                true if is_table(id) => sum.constants.push(id),
                false if !loops.contains(by) => sum.common.push(id),
                _ => return Err(Reason::Unrecognised),
            }
        }
        if sum.parts.is_empty() {
            // The runtime learns from it how coordinates are kept.
            sum.parts.push(Part::Position);
        }
        for element in targets {
            let place = sum.place(graph, by, element).ok_or(Reason::TermTarget)?;
            sum.targets.push(place);
        }
        Ok(sum)
    }

    /// The list and the component of a coordinate.
    fn place(&mut self, graph: &Graph, by: LoopId, element: Element) -> Option<(usize, usize)> {
        let component = element.component.map_or(Some(0), |component| graph.loops.literal(component))?;
        let is_point = element.component.is_some() == self.components.is_some();
        let is_listed = is_listed(graph, by, element.index);
        (is_listed && is_point).then(|| (position(&mut self.lists, element.index), component as usize))
    }
}

/// The number of iterations of a loop, if it is a number.
pub(super) fn literal_count(graph: &Graph, by: LoopId) -> Option<u64> {
    let range = graph.loops.get(by);
    graph.loops.literal(range.to).map(|to| to - graph.loops.literal(range.from).unwrap_or(0).min(to))
}

/// The number of components of a point, where coordinates are points; `None` where these are too many, or their number is not
/// known.
pub(super) fn read_together(graph: &Graph, components: Option<IndexId>) -> Option<Option<usize>> {
    let Some(components) = components else { return Some(None) };
    let known = graph.loops.literal(components).filter(|known| *known <= MOST_COMPONENTS)?;
    Some(Some(known as usize))
}

/// The position of an element, which is appended where it is new.
pub(super) fn position<T: PartialEq>(list: &mut Vec<T>, element: T) -> usize {
    list.iter().position(|known| *known == element).unwrap_or_else(|| {
        list.push(element);
        list.len() - 1
    })
}

/// Whether a node is one that vectors do not compute: a method of the user, which is called number by number, or what depends on
/// the step.
pub(super) fn is_called(node: Node) -> bool {
    matches!(node, Node::External(..) | Node::Step | Node::Middle)
}

/// Whether a line computes such a node, beside what is prepared or has a name elsewhere.
pub(super) fn computes(graph: &Graph, named: &BTreeSet<NodeId>, line: &Item, is: fn(Node) -> bool) -> bool {
    let of = |id: NodeId| contains(graph, named, id, false, is);
    let within = |body: &[Item]| body.iter().any(|line| computes(graph, named, line, is));
    match line {
        Item::Branch { condition, body, .. } => contains(graph, named, *condition, true, is) || within(body),
        Item::Let(id) => contains(graph, named, *id, true, is),
        Item::SineCosine { sine, cosine, .. } => [sine, cosine].iter().any(|id| contains(graph, named, **id, true, is)),
        Item::Choose { value, .. } | Item::Add { value, .. } | Item::Sink(_, value) => of(*value),
        Item::Begin(_) => false,
        Item::Loop { body, .. } => within(body),
    }
}

fn contains(graph: &Graph, named: &BTreeSet<NodeId>, id: NodeId, is_made: bool, is: fn(Node) -> bool) -> bool {
    match graph.node(id) {
        node if is(node) && (is_made || !named.contains(&id)) && !graph.is_prepared(id) => true,
        _ if !is_made && named.contains(&id) || graph.is_prepared(id) => false,
        node => node.children().any(|child| contains(graph, named, child, false, is)),
    }
}
