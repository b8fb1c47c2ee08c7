//! Innermost loops in lanes: sums and gradients whose iterations are computed several at a time, in one vector.
//!
//! In: a loop of a program without others inside. Out: what an iteration reads and has, the sums that it adds to, and the
//! point of the gradient. The result is nothing if iterations depend on each other, or read coordinates that are not
//! beside each other. Always true: the program alone determines which loops these are, and so the order of every sum.

use super::{
    Item, Program,
    lists::{adds_to_list, computes, is_called, literal_count, position, read_together},
    nest::{Nest, NestContext},
    phases::Phases,
};
use crate::graph::{
    Element, Graph, MOST_COMPONENTS, Node, NodeId, Part,
    index::{Index, IndexId, Linear, LoopId},
    series,
};
use crate::reason::Reason;
use std::collections::{BTreeMap, BTreeSet, HashSet};

/// The fewest iterations of a loop in lanes, where their number is known.
const FEWEST: u64 = 16;

/// The fewest coordinates, where their number is known: fewer are registers of unrolled loops, and those of devices.
pub(crate) const FEWEST_COORDINATES: u64 = 65;

/// The most points that an iteration reads, and the most sums that it adds to.
const MOST: usize = 16;

/// A loop in lanes: what its iterations need.
pub(crate) struct LoopInLanes<'p> {
    /// How coordinates are points.
    pub(crate) points: Points,
    /// The lines of an iteration.
    pub(crate) body: Vec<&'p Item>,
    /// The coordinates that iterations read.
    pub(crate) parts: Vec<Coordinates>,
    /// The points that an iteration reads: the coordinates, and how far the index is from that of the loop.
    pub(crate) reads: Vec<(usize, i64)>,
    /// The coordinates that it reads, each by its point and its component.
    pub(crate) coordinates: Vec<(NodeId, usize, usize)>,
    /// Its own numbers, which are elements of tables.
    pub(crate) constants: Vec<NodeId>,
    /// What other loops over the same rows computed of each, with its number among all that is kept.
    pub(crate) kept: Vec<(NodeId, usize)>,
    /// What other loops over the same rows read of each.
    pub(crate) results: Vec<NodeId>,
    /// What all iterations have in common.
    pub(crate) common: Vec<NodeId>,
    /// The sums that it adds to.
    pub(crate) sums: Vec<NodeId>,
    /// How far the indices of the points whose gradient it adds to are from that of the loop.
    pub(crate) target: Option<i64>,
    /// The index from which on the second one of two such points is counted.
    pub(crate) apart: Option<IndexId>,
    /// The point and the component of each coordinate whose gradient it adds to.
    pub(crate) targets: BTreeMap<Element, (usize, usize)>,
    /// Whether it computes functions or divides, which gains from the widest vectors.
    pub(crate) is_wide: bool,
}

/// How coordinates are points.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Points {
    /// They are numbers.
    Numbers,
    /// They are points with this number of components.
    Components(usize),
    /// They are numbers, and this many at a time are a point: iteration `i` reads those from `i` times this number on.
    Groups(usize),
}

impl Points {
    /// The number of components of a point.
    pub(crate) fn components(self) -> usize {
        match self {
            Self::Numbers => 1,
            Self::Components(count) | Self::Groups(count) => count,
        }
    }
}

/// The coordinates of a part, all of them or those from an index on.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) struct Coordinates {
    pub(crate) part: Part,
    pub(crate) from: Option<IndexId>,
}

impl From<Part> for Coordinates {
    fn from(part: Part) -> Self {
        Self { part, from: None }
    }
}

/// The place of a coordinate: the index from which on points are counted, how far the index of the point is from that of the
/// loop, and the component.
#[derive(Clone, Copy, PartialEq, Eq)]
struct Place {
    from: Option<IndexId>,
    offset: i64,
    component: usize,
}

/// What decides which loops of a program are in lanes.
#[derive(Clone, Copy)]
pub(crate) struct LaneContext<'s> {
    pub(crate) graph: &'s Graph,
    /// How many numbers or points the coordinates are, and how many components a point has.
    pub(crate) lengths: &'s [IndexId],
    /// The nodes that have a name.
    pub(crate) named: &'s BTreeSet<NodeId>,
    /// What conditions compare.
    pub(crate) compared: &'s HashSet<NodeId>,
    /// Whether a prepared number is kept in a table or a field.
    pub(crate) is_kept: &'s dyn Fn(NodeId) -> bool,
}

/// Whether there may be enough coordinates for loops in lanes: their number is known at run time, or is large.
pub(crate) fn are_many(graph: &Graph, lengths: &[IndexId]) -> bool {
    let count =
        |product: u64, length: &IndexId| graph.loops.literal(*length).map(|length| product.saturating_mul(length));
    lengths.first().is_some_and(|length| graph.loops.index(*length) == Index::Length)
        || lengths.iter().try_fold(1, count).is_some_and(|count| count >= FEWEST_COORDINATES)
}

/// Whether a loop ends where data of the system do.
fn is_over_data(graph: &Graph, by: LoopId) -> bool {
    fn is_of_data(graph: &Graph, end: IndexId) -> bool {
        match graph.loops.index(end) {
            _ if graph.loops.is_extent(end) => false,
            Index::Parameter(_) => graph.loops.of_index(end).is_empty(),
            Index::Min(a, b) => is_of_data(graph, a) && is_of_data(graph, b),
            Index::Div(a, b) | Index::Sub(a, b) | Index::Monus(a, b) => {
                is_of_data(graph, a) && graph.loops.literal(b).is_some()
            }
            _ => false,
        }
    }
    is_of_data(graph, graph.loops.get(by).to)
}

/// Whether a node is a function, a division or a root, which take many times as long as a sum.
pub(crate) fn is_function(node: Node) -> bool {
    matches!(node, Node::Unary(..) | Node::Binary(..) | Node::Div(..) | Node::Power(..))
}

impl<'s> LaneContext<'s> {
    /// The loops in lanes of a program; those of branches as well.
    pub(crate) fn all<'p>(self, program: &'p Program) -> Vec<LoopInLanes<'p>> {
        let mut found = Vec::new();
        self.add_to(&mut found, &program.items);
        found
    }

    fn add_to<'p>(self, found: &mut Vec<LoopInLanes<'p>>, items: &'p [Item]) {
        for item in items {
            match item {
                Item::Loop { body, .. } => match self.loop_in_lanes(items, item) {
                    Ok(lanes) => found.push(lanes),
                    Err(_) => {
                        // A function of a row takes little time beside the products of its entries.
                        let of_rows = |phases: Phases<'p>| LoopInLanes { is_wide: false, ..phases.middle };
                        found.extend(self.phases(items, item).map(of_rows));
                        self.add_to(found, body);
                    }
                },
                Item::Branch { body, .. } => self.add_to(found, body),
                _ => {}
            }
        }
    }

    /// The loop in lanes that a line among others is.
    pub(crate) fn loop_in_lanes<'p>(self, beside: &[Item], item: &'p Item) -> Result<LoopInLanes<'p>, Reason> {
        let Item::Loop { by, body } = item else { return Err(Reason::NoLoop) };
        self.iterations(beside, *by, body.iter().collect(), &[], Vec::new())
    }

    /// The loop in lanes with these lines. Values are kept of each iteration for it, and results for others.
    pub(super) fn iterations<'p>(
        self,
        beside: &[Item],
        by: LoopId,
        body: Vec<&'p Item>,
        kept: &[NodeId],
        results: Vec<NodeId>,
    ) -> Result<LoopInLanes<'p>, Reason> {
        let Self { graph, lengths, named, .. } = self;
        let are_few = literal_count(graph, by).is_some_and(|count| count < FEWEST);
        let is_wide = body.iter().any(|line| computes(graph, named, line, is_function));
        // A loop over data may be long however few the coordinates are.
        let is_over_data = is_wide && is_over_data(graph, by)
            || graph.loops.get(by).parent.is_some_and(|parent| is_over_data(graph, parent));
        let has_many = are_many(graph, lengths) || is_over_data;
        // So may one over tables of constants be, such as the terms of a series.
        let is_over_tables = is_wide && literal_count(graph, by).is_some_and(|count| count >= series::FEWEST as u64);
        let is_volume = graph.loops.sites_of_row().is_some();
        let obstacles = [
            (!has_many && !is_over_tables, Reason::FewCoordinates),
            (are_few, Reason::FewIterations),
            (is_volume || body.iter().any(|line| adds_to_list(graph, by, line)), Reason::Unrecognised),
        ];
        if let Some((_, reason)) = obstacles.into_iter().find(|(is_met, _)| *is_met) {
            return Err(reason);
        }
        let context = NestContext { graph, named, operands: &BTreeMap::new() };
        let nest = context.innermost(by, body).ok_or(Reason::LoopBody)?;
        let is_sum = |id: &NodeId| {
            matches!(graph.node(*id), Node::Sum(..))
                && !self.compared.contains(id)
                && beside.contains(&Item::Begin(*id))
        };
        let Nest { body, reads, constants, predicates, invariants, targets, sums, .. } = nest;
        let number_of = |id: NodeId| kept.iter().position(|known| *known == id).map(|number| (id, number));
        let kept = invariants.iter().filter_map(|id| number_of(*id)).collect();
        let common = invariants.iter().copied().filter(|id| number_of(*id).is_none()).collect();
        let adds = !(sums.is_empty() && targets.is_empty() && results.is_empty());
        let is_other = !sums.iter().all(is_sum) || !adds || !(targets.is_empty() || results.is_empty());
        let obstacles = [
            (!predicates.is_empty(), Reason::LoopCondition),
            (body.iter().any(|line| computes(graph, named, line, is_called)), Reason::Method),
            (reads.len() > MOST || sums.len() > MOST, Reason::LongLoop),
            (is_other, Reason::Unrecognised),
        ];
        if let Some((_, reason)) = obstacles.into_iter().find(|(is_met, _)| *is_met) {
            return Err(reason);
        }
        let own = reads.iter().map(|(_, element)| *element).chain(targets.iter().copied());
        let own: Vec<Element> = own.filter(|element| graph.loops.of_element(*element).contains(by)).collect();
        if !has_many && !own.is_empty() {
            return Err(Reason::FewCoordinates);
        }
        let points = match read_together(graph, lengths.get(1).copied()).ok_or(Reason::Unrecognised)? {
            Some(components) => Points::Components(components),
            None => groups(graph, by, &own).map_or(Points::Numbers, Points::Groups),
        };
        // Results are numbers, as points are that iterations read beside them.
        if !results.is_empty() && points.components() != 1 {
            return Err(Reason::Unrecognised);
        }
        let mut lanes = LoopInLanes {
            points,
            body,
            parts: Vec::new(),
            reads: Vec::new(),
            coordinates: Vec::new(),
            constants: Vec::new(),
            kept,
            results,
            common,
            sums,
            target: None,
            apart: None,
            targets: BTreeMap::new(),
            is_wide,
        };
        for (id, element) in reads {
            if graph.loops.of_element(element).contains(by) {
                let place = points.place(graph, by, element).ok_or(Reason::LoopIndex)?;
                let part = position(&mut lanes.parts, Coordinates { part: element.part, from: place.from });
                let point = position(&mut lanes.reads, (part, place.offset));
                lanes.coordinates.push((id, point, place.component));
            } else {
                // Without a name, it is read inside of the loop because it may not be there without iterations.
                lanes.common.push(Some(id).filter(|id| named.contains(id)).ok_or(Reason::Unrecognised)?);
            }
        }
        for id in constants {
            lanes.constant(self, by, id).ok_or(Reason::Unrecognised)?;
        }
        lanes.add_targets(graph, by, targets)?;
        let made: BTreeSet<NodeId> = lanes.body.iter().flat_map(|line| line.named()).collect();
        if lanes.common.iter().any(|id| made.contains(id)) {
            return Err(Reason::Unrecognised);
        }
        if lanes.parts.is_empty() {
            // The runtime learns from it how coordinates are kept.
            lanes.parts.push(Part::Position.into());
        }
        Ok(lanes)
    }
}

impl Points {
    /// The place of a coordinate of an iteration.
    fn place(self, graph: &Graph, by: LoopId, element: Element) -> Option<Place> {
        let component = element.component.map_or(Some(0), |component| graph.loops.literal(component))?;
        let is_point = element.component.is_some() == matches!(self, Self::Components(_));
        let Linear { base: from, stride, offset } = graph.loops.linear_in(by, element.index)?;
        let group = match self {
            Self::Groups(count) => i64::try_from(count).ok()?,
            Self::Numbers | Self::Components(_) => 1,
        };
        // What comes before the index from which on points are counted is none of these.
        let first = graph.loops.literal(graph.loops.get(by).from).and_then(|first| i64::try_from(first).ok());
        let is_within = from.is_none() || first.unwrap_or(0).saturating_add(offset.div_euclid(group)) >= 0;
        let component = match self {
            Self::Groups(_) => offset.rem_euclid(group) as usize,
            Self::Numbers | Self::Components(_) => component as usize,
        };
        let place = Place { from, offset: offset.div_euclid(group), component };
        (is_point && is_within && stride == group).then_some(place)
    }
}

/// The number of coordinates of a point, if the coordinates of iterations are some of several at a time. The last ones of these
/// have to be there in every iteration.
fn groups(graph: &Graph, by: LoopId, elements: &[Element]) -> Option<usize> {
    let strides = elements.iter().map(|element| Some(graph.loops.linear_in(by, element.index)?.stride));
    let strides = strides.collect::<Option<BTreeSet<i64>>>()?;
    let count = usize::try_from(*strides.first()?).ok().filter(|_| strides.len() == 1)?;
    if count < 2 || count as u64 > MOST_COMPONENTS {
        return None;
    }
    let points = Points::Groups(count);
    let places = elements.iter().map(|element| points.place(graph, by, *element));
    let places = places.collect::<Option<Vec<_>>>()?;
    let has_last = |place: &Place| {
        let is_last = |other: &&Place| other.from == place.from && other.component + 1 == count;
        places.iter().filter(is_last).any(|other| other.offset >= place.offset)
    };
    places.iter().all(has_last).then_some(count)
}

impl LoopInLanes<'_> {
    /// Notes the coordinates whose gradient an iteration adds to: those of one point, or of two that are far apart.
    fn add_targets(&mut self, graph: &Graph, by: LoopId, targets: Vec<Element>) -> Result<(), Reason> {
        let mut found: Vec<(Element, Place)> = Vec::new();
        for element in targets {
            let place = self.points.place(graph, by, element).ok_or(Reason::LoopIndex)?;
            if *self.target.get_or_insert(place.offset) != place.offset {
                return Err(Reason::LoopTargets);
            }
            found.push((element, place));
        }
        // Two points are in two parts of the gradient: one part ends before the other begins.
        let mut ends: Vec<Option<IndexId>> = Vec::new();
        for (_, place) in &found {
            position(&mut ends, place.from);
        }
        match ends[..] {
            [] | [None] => {}
            [one, other] if one.is_none() != other.is_none() => self.apart = one.or(other),
            _ => return Err(Reason::LoopTargets),
        }
        let (first, second): (Vec<_>, Vec<_>) = found.iter().partition(|(_, place)| place.from.is_none());
        let is_before = |(a, _): &(Element, Place)| second.iter().all(|(b, _)| graph.loops.is_before(a.index, b.index));
        if !first.iter().all(is_before) {
            return Err(Reason::LoopTargets);
        }
        let point = |place: &Place| (usize::from(place.from.is_some()), place.component);
        self.targets = found.iter().map(|(element, place)| (*element, point(place))).collect();
        Ok(())
    }

    /// Notes a prepared number that depends on indices of loops: an element of a table, a number that all iterations have in
    /// common, or one that is computed from such.
    fn constant(&mut self, context: LaneContext<'_>, by: LoopId, id: NodeId) -> Option<()> {
        let loops = context.graph.loops_of(id);
        if !loops.contains(by) {
            if context.graph.as_constant(id).is_none() {
                position(&mut self.common, id);
            }
            return Some(());
        }
        if (context.is_kept)(id) {
            if loops.iter().last() == Some(by) {
                position(&mut self.constants, id);
                return Some(());
            }
            return None;
        }
        match context.graph.node(id) {
            Node::Neg(_) | Node::Add(..) | Node::Mul(..) | Node::Div(..) => {
                context.graph.node(id).children().try_for_each(|child| self.constant(context, by, child))
            }
            _ => None,
        }
    }
}
