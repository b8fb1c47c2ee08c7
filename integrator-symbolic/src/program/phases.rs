//! Loops over rows in three phases: loops whose iterations sum over inner loops, compute functions of these sums, and add what
//! follows in inner loops again, as those over rows of data.
//!
//! In: a loop of a program. Out: the lines of each phase, and the values that pass from one to the next. A phase is a loop of its
//! own, so that the functions of several rows are computed in one vector. Always true: the phases have the lines of the loop, each
//! in the order of the loop; a value that only reads or copies may be computed in several phases.

use super::{
    Item, Sink,
    lanes::{LaneContext, LoopInLanes, is_function},
    lists::{computes, literal_count},
};
use crate::graph::{Node, NodeId};
use std::collections::{BTreeMap, BTreeSet};

/// A loop in phases.
pub(crate) struct Phases<'p> {
    /// The lines with the inner loops that sum.
    pub(crate) before: Vec<&'p Item>,
    /// The sums of each row that later phases read.
    pub(crate) kept: Vec<NodeId>,
    /// The lines with functions.
    pub(crate) middle: LoopInLanes<'p>,
    /// The sums of each row, and the values of the middle, that the lines after it read.
    pub(crate) given: Vec<NodeId>,
    /// The lines with the inner loops that add to a gradient.
    pub(crate) after: Vec<&'p Item>,
}

impl LaneContext<'_> {
    /// The phases of a loop among other lines; `None` if it has no functions of inner sums.
    pub(crate) fn phases<'p>(self, beside: &[Item], item: &'p Item) -> Option<Phases<'p>> {
        let Item::Loop { by, body } = item else { return None };
        let is_from_zero = self.graph.loops.literal(self.graph.loops.get(*by).from) == Some(0);
        if !is_from_zero || literal_count(self.graph, *by).is_some() {
            return None;
        }
        let made: BTreeSet<NodeId> = body.iter().flat_map(Item::named).collect();
        let begun: BTreeSet<NodeId> = body.iter().filter_map(begins).collect();
        let sums = |line: &Item| matches!(line, Item::Loop { body, .. } if adds_to_all_of(body, &begun));
        let is_before = |line: &&Item| matches!(line, Item::Begin(_)) || sums(line);
        let (mut before, others): (Vec<&Item>, Vec<&Item>) = body.iter().partition(is_before);
        let (mut after, middle): (Vec<&Item>, Vec<&Item>) =
            others.into_iter().partition(|line| matches!(line, Item::Loop { .. }));
        let is_plain = |line: &&Item| match line {
            Item::Let(_) | Item::SineCosine { .. } => true,
            Item::Add { sum, .. } => !begun.contains(sum),
            _ => false,
        };
        let is_of_sums = before.iter().any(|line| sums(line));
        if !is_of_sums || !middle.iter().all(is_plain) || !after.iter().all(|line| is_apart(line, &begun)) {
            return None;
        }
        // A value that is read alone is read wherever it is used.
        let copies: BTreeMap<NodeId, &Item> = middle.iter().filter_map(|line| self.copied(line)).collect();
        let needed_before = self.used(&before);
        if !needed_before.iter().all(|id| !made.contains(id) || copies.contains_key(id)) {
            return None;
        }
        before.splice(0..0, copies.iter().filter(|(id, _)| needed_before.contains(id)).map(|(_, line)| *line));
        let needed_after = self.used(&after);
        after.splice(0..0, copies.iter().filter(|(id, _)| needed_after.contains(id)).map(|(_, line)| *line));
        let needed = self.used(&middle);
        let kept: Vec<NodeId> =
            begun.iter().copied().filter(|id| needed.contains(id) || needed_after.contains(id)).collect();
        let given = |id: &NodeId| needed_after.contains(id) && !copies.contains_key(id);
        let results: Vec<NodeId> = made.iter().copied().filter(given).collect();
        let given = begun.iter().copied().filter(given).chain(results.iter().copied()).collect();
        if !middle.iter().any(|line| computes(self.graph, self.named, line, is_function)) {
            return None;
        }
        let middle = self.iterations(beside, *by, middle, &kept, results).ok()?;
        Some(Phases { before, kept, middle, given, after })
    }

    /// The value that a line copies of the coordinates or of what is prepared.
    fn copied(self, line: &Item) -> Option<(NodeId, &Item)> {
        let Item::Let(id) = line else { return None };
        let is_copy = matches!(self.graph.node(*id), Node::Coordinate(_)) || self.graph.is_prepared(*id);
        is_copy.then_some((*id, line))
    }

    /// The values with a name that lines use.
    fn used(self, lines: &[&Item]) -> BTreeSet<NodeId> {
        let (mut open, mut seen, mut used) = (Vec::new(), BTreeSet::new(), BTreeSet::new());
        lines.iter().for_each(|line| self.add_values(line, &mut open));
        while let Some(id) = open.pop() {
            if self.named.contains(&id) {
                used.insert(id);
            } else if seen.insert(id) {
                open.extend(self.graph.node(id).children());
            }
        }
        used
    }

    /// Adds the values that a line is computed from.
    fn add_values(self, line: &Item, found: &mut Vec<NodeId>) {
        match line {
            Item::Begin(_) => {}
            Item::Let(id) => found.extend(self.graph.node(*id).children()),
            Item::SineCosine { argument, .. } => found.push(*argument),
            Item::Loop { body, .. } => body.iter().for_each(|line| self.add_values(line, found)),
            Item::Branch { condition, body, .. } => {
                found.push(*condition);
                body.iter().for_each(|line| self.add_values(line, found));
            }
            Item::Add { value, .. } | Item::Choose { value, .. } | Item::Sink(_, value) => found.push(*value),
        }
    }
}

/// The sum that a line begins.
fn begins(line: &Item) -> Option<NodeId> {
    match line {
        Item::Begin(id) => Some(*id),
        _ => None,
    }
}

/// Whether lines do nothing but add to sums, and compute what is added.
fn adds_to_all_of(lines: &[Item], sums: &BTreeSet<NodeId>) -> bool {
    lines.iter().all(|line| match line {
        Item::Add { sum, .. } => sums.contains(sum),
        Item::Let(_) | Item::SineCosine { .. } => true,
        _ => false,
    })
}

/// Whether a line is a loop without others or conditions, which adds to none of these sums.
fn is_apart(line: &Item, sums: &BTreeSet<NodeId>) -> bool {
    let is_plain = |line: &Item| match line {
        Item::Let(_) | Item::SineCosine { .. } | Item::Sink(Sink::Collect(_), _) => true,
        Item::Add { sum, .. } => !sums.contains(sum),
        _ => false,
    };
    matches!(line, Item::Loop { body, .. } if body.iter().all(is_plain))
}
