//! Reduction of any number of items by adding, by multiplying, or by the maximum or minimum.

use crate::graph::{
    Fold, Node, NodeId,
    index::{Index, IndexId},
};
use crate::model::{
    Reader,
    loops::total::{Accumulator, Step},
    values::value::{Sequence, Value},
};
use syn::ExprMethodCall;

/// How an item is joined to what there is.
#[derive(Clone, Copy)]
enum Join {
    Added(NodeId),
    Multiplied(NodeId),
    Largest(NodeId),
    Smallest(NodeId),
}

impl Reader<'_> {
    /// What a loop of any length makes of its items, if each step joins one item to each number; outside, whether it was read.
    pub(crate) fn by_joining(
        &mut self,
        sequence: &Sequence,
        start: &Accumulator,
        step: &Step,
        call: &ExprMethodCall,
    ) -> Option<Option<Value>> {
        let by = self.enter(None, sequence.from, sequence.to, call)?;
        let index = self.graph.loops.intern(Index::Running(by));
        let joins = self.joins(sequence, index, start, step, call);
        self.leave();
        let Some(joins) = joins? else { return Some(None) };
        let mut totals = Vec::new();
        for (join, start) in joins.into_iter().zip(&start.numbers) {
            let begins_infinite = self.is_infinite(*start);
            let graph = &mut self.graph;
            totals.push(match join {
                Join::Added(item) => {
                    let sum = graph.sum(by, item);
                    graph.add(*start, sum)
                }
                Join::Multiplied(item) => {
                    let product = graph.fold(Fold::Product, by, item);
                    graph.mul(*start, product)
                }
                // An infinite number, with which a search for the largest begins, is no item.
                Join::Largest(item) => {
                    let largest = graph.fold(Fold::Largest, by, item);
                    if begins_infinite == Some(false) { largest } else { graph.call_two("max", *start, largest) }
                }
                Join::Smallest(item) => {
                    let turned = graph.neg(item);
                    let largest = graph.fold(Fold::Largest, by, turned);
                    let smallest = graph.neg(largest);
                    if begins_infinite == Some(true) { smallest } else { graph.call_two("min", *start, smallest) }
                }
            });
        }
        Some(Some(start.with(&totals)))
    }

    /// How the item for an index is joined to each number; that of a filter leaves out is joined as what changes nothing.
    fn joins(
        &mut self,
        sequence: &Sequence,
        index: IndexId,
        start: &Accumulator,
        step: &Step,
        call: &ExprMethodCall,
    ) -> Option<Option<Vec<Join>>> {
        let item = self.item_of(sequence, index)?;
        let before = self.unknown(start);
        let next = self.under(item.condition, true, |reader| reader.stepped(step, &before, item.value, call))?;
        let mut joins = Vec::new();
        for (so_far, next) in before.numbers.iter().zip(next) {
            let graph = &mut self.graph;
            let join = graph.added_to(*so_far, next).map(Join::Added);
            let join = join.or_else(|| graph.multiplied_to(*so_far, next).map(Join::Multiplied));
            let join = join.or_else(|| graph.compared_to(*so_far, next, true).map(Join::Largest));
            let join = join.or_else(|| graph.compared_to(*so_far, next, false).map(Join::Smallest));
            let Some(join) = join else { return Some(None) };
            let (Join::Added(joined) | Join::Multiplied(joined) | Join::Largest(joined) | Join::Smallest(joined)) =
                join;
            if graph.mentions(joined, &before.numbers) {
                return Some(None);
            }
            joins.push(match item.condition {
                None => join,
                Some(condition) => {
                    let mut or = |number: f64| {
                        let nothing = graph.constant(number);
                        graph.select(condition, joined, nothing)
                    };
                    match join {
                        Join::Added(_) => Join::Added(or(0.0)),
                        Join::Multiplied(_) => Join::Multiplied(or(1.0)),
                        Join::Largest(_) => Join::Largest(or(f64::NEG_INFINITY)),
                        Join::Smallest(_) => Join::Smallest(or(f64::INFINITY)),
                    }
                }
            });
        }
        Some(Some(joins))
    }

    /// Whether a number is written as an infinite one, and whether that is the positive one.
    pub(crate) fn is_infinite(&self, number: NodeId) -> Option<bool> {
        let Node::Parameter(parameter) = self.graph.node(number) else { return None };
        let text = self.parameters[parameter.0 as usize].own.to_string().replace([' ', '(', ')'], "");
        let (negative, name) = match text.strip_prefix('-') {
            Some(rest) => (true, rest.to_owned()),
            None => (false, text),
        };
        match name.trim_start_matches("::").trim_start_matches("std::").trim_start_matches("core::") {
            "f64::INFINITY" => Some(!negative),
            "f64::NEG_INFINITY" => Some(negative),
            _ => None,
        }
    }
}
