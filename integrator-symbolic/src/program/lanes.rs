//! Innermost loops in lanes: sums and gradients of which several iterations are computed in one vector.
//!
//! In: a loop of a program without others inside. Out: what an iteration reads and has, the sums that it adds to, and the
//! point of the gradient. The result is nothing if iterations depend on each other, or read coordinates that are not
//! beside each other. Always true: the program alone determines which loops these are, and so the order of every sum.

use super::{
    Item, Program,
    lists::{computes, is_called, is_over_list, literal_count, position, read_together},
    nest::{Nest, NestContext},
};
use crate::graph::{
    Element, Graph, Node, NodeId, Part,
    index::{Index, IndexId, LoopId},
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
    /// The number of components of a point, where coordinates are points.
    pub(crate) components: Option<usize>,
    /// The lines of an iteration.
    pub(crate) body: Vec<&'p Item>,
    /// The parts of the coordinates that iterations read.
    pub(crate) parts: Vec<Part>,
    /// The points that an iteration reads: the part, and how far the index is from that of the loop.
    pub(crate) reads: Vec<(usize, i64)>,
    /// The coordinates that it reads, each by its point and its component.
    pub(crate) coordinates: Vec<(NodeId, usize, usize)>,
    /// Its own numbers, which are elements of tables.
    pub(crate) constants: Vec<NodeId>,
    /// What all iterations have in common.
    pub(crate) common: Vec<NodeId>,
    /// The sums that it adds to.
    pub(crate) sums: Vec<NodeId>,
    /// How far the index of the point whose gradient it adds to is from that of the loop.
    pub(crate) target: Option<i64>,
    /// Whether it computes functions or divides, which gains from the widest vectors.
    pub(crate) is_wide: bool,
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
                    Err(_) => self.add_to(found, body),
                },
                Item::Branch { body, .. } => self.add_to(found, body),
                _ => {}
            }
        }
    }

    /// The loop in lanes that a line among others is.
    pub(crate) fn loop_in_lanes<'p>(self, beside: &[Item], item: &'p Item) -> Result<LoopInLanes<'p>, Reason> {
        let Self { graph, lengths, named, .. } = self;
        let Item::Loop { by, body } = item else { return Err(Reason::NoLoop) };
        let by = *by;
        let are_few = literal_count(graph, by).is_some_and(|count| count < FEWEST);
        let is_volume = graph.loops.sites_of_row().is_some();
        let obstacles = [
            (!are_many(graph, lengths), Reason::FewCoordinates),
            (are_few, Reason::FewIterations),
            (is_volume || is_over_list(graph, by, body), Reason::Unrecognised),
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
        let is_wide = body.iter().any(|line| computes(graph, named, line, is_function));
        let is_other = !sums.iter().all(is_sum) || sums.is_empty() && targets.is_empty();
        let obstacles = [
            (!predicates.is_empty(), Reason::LoopCondition),
            (body.iter().any(|line| computes(graph, named, line, is_called)), Reason::Method),
            (reads.len() > MOST || sums.len() > MOST, Reason::LongLoop),
            (is_other, Reason::Unrecognised),
        ];
        if let Some((_, reason)) = obstacles.into_iter().find(|(is_met, _)| *is_met) {
            return Err(reason);
        }
        let components = read_together(graph, lengths.get(1).copied()).ok_or(Reason::Unrecognised)?;
        let mut lanes = LoopInLanes {
            components,
            body,
            parts: Vec::new(),
            reads: Vec::new(),
            coordinates: Vec::new(),
            constants: Vec::new(),
            common: invariants,
            sums,
            target: None,
            is_wide,
        };
        for (id, element) in reads {
            if graph.loops.of_element(element).contains(by) {
                let (offset, component) = lanes.place(graph, by, element).ok_or(Reason::LoopIndex)?;
                let part = position(&mut lanes.parts, element.part);
                let point = position(&mut lanes.reads, (part, offset));
                lanes.coordinates.push((id, point, component));
            } else {
                // Without a name, it is read inside of the loop because it may not be there without iterations.
                lanes.common.push(Some(id).filter(|id| named.contains(id)).ok_or(Reason::Unrecognised)?);
            }
        }
        for id in constants {
            lanes.constant(self, by, id).ok_or(Reason::Unrecognised)?;
        }
        for element in targets {
            let (offset, _) = lanes.place(graph, by, element).ok_or(Reason::LoopIndex)?;
            if *lanes.target.get_or_insert(offset) != offset {
                return Err(Reason::LoopTargets);
            }
        }
        let made: BTreeSet<NodeId> = lanes.body.iter().flat_map(|line| line.named()).collect();
        if lanes.common.iter().any(|id| made.contains(id)) {
            return Err(Reason::Unrecognised);
        }
        if lanes.parts.is_empty() {
            // The runtime learns from it how coordinates are kept.
            lanes.parts.push(Part::Position);
        }
        Ok(lanes)
    }
}

impl LoopInLanes<'_> {
    /// How far the index of a coordinate is from that of the loop, and its component.
    fn place(&self, graph: &Graph, by: LoopId, element: Element) -> Option<(i64, usize)> {
        let component = element.component.map_or(Some(0), |component| graph.loops.literal(component))?;
        let is_point = element.component.is_some() == self.components.is_some();
        let number = |id| graph.loops.literal(id).and_then(|number| i64::try_from(number).ok());
        let is_own = |id| graph.loops.index(id) == Index::Running(by);
        let offset = match graph.loops.index(element.index) {
            Index::Running(own) if own == by => 0,
            Index::Add(a, b) if is_own(a) => number(b)?,
            Index::Add(a, b) if is_own(b) => number(a)?,
            Index::Sub(a, b) if is_own(a) => -number(b)?,
            _ => return None,
        };
        is_point.then_some((offset, component as usize))
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
