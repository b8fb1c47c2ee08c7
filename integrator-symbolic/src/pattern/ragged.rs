//! Lists of lists as one list: `for i in 0..n { for &j in &self.neighbours[i] { .. } }` becomes a loop over all entries.
//!
//! In: a potential. Out: the same potential, in which such sums run over one list of terms, whose indices and numbers are
//! prepared once per run. So terms share vectors, however short the inner lists are. Always true: the terms are the same, in the
//! order of the loops.

use super::once::add_terms;
use crate::{
    graph::{
        Element, Graph, Node, NodeId, ParameterId,
        index::{Index, IndexId, Loop, LoopId, LoopSet},
        rename::Parameters,
    },
    model::{Entries, Texts},
    pairs::{are_equal, rewritten},
};
use std::collections::HashMap;

/// The potential with such sums over one list each; `None` if there are none.
pub(super) fn flattened(graph: &mut Graph, potential: NodeId, texts: &mut Texts<'_>) -> Option<NodeId> {
    let mut terms = Terms { texts, count: 0 };
    let flattened = terms.of_sum(graph, potential);
    (terms.count > 0).then_some(flattened)
}

struct Terms<'t, 'm> {
    texts: &'t mut Texts<'m>,
    /// The number of sums that were flattened.
    count: usize,
}

impl Terms<'_, '_> {
    /// A sum of terms outside of all loops.
    fn of_sum(&mut self, graph: &mut Graph, id: NodeId) -> NodeId {
        match graph.node(id) {
            Node::Add(a, b) => {
                let (a, b) = (self.of_sum(graph, a), self.of_sum(graph, b));
                graph.add(a, b)
            }
            Node::Neg(a) => {
                let a = self.of_sum(graph, a);
                graph.neg(a)
            }
            Node::Mul(factor, a) if graph.is_prepared(factor) => {
                let a = self.of_sum(graph, a);
                graph.mul(factor, a)
            }
            Node::Sum(by, body) if is_from_zero(graph, by) && graph.loops.of_range(by).is_empty() => {
                self.of_loop(graph, by, body, None)
            }
            _ => match graph.guarded_sum(id) {
                Some(sum) => {
                    let count = self.count;
                    let flat = self.of_sum(graph, sum);
                    if self.count > count { flat } else { id }
                }
                None => id,
            },
        }
    }

    /// The sum over a loop of `factor` times a body, whose addends that are sums over a list of each iteration become sums over
    /// one list.
    fn of_loop(&mut self, graph: &mut Graph, by: LoopId, body: NodeId, factor: Option<NodeId>) -> NodeId {
        let times = |graph: &mut Graph, node| factor.map_or(node, |factor| graph.mul(factor, node));
        match graph.node(body) {
            Node::Add(a, b) => {
                let (a, b) = (self.of_loop(graph, by, a, factor), self.of_loop(graph, by, b, factor));
                graph.add(a, b)
            }
            Node::Neg(a) => {
                let a = self.of_loop(graph, by, a, factor);
                graph.neg(a)
            }
            Node::Mul(own, a) if graph.is_prepared(own) => {
                let factor = times(graph, own);
                self.of_loop(graph, by, a, Some(factor))
            }
            Node::Sum(inner, term) => {
                let term = times(graph, term);
                let flat = self.flat(graph, [by, inner], term);
                flat.unwrap_or_else(|| {
                    let sum = graph.sum(inner, term);
                    graph.sum(by, sum)
                })
            }
            _ => {
                if let Some(sum) = graph.guarded_sum(body) {
                    return self.of_loop(graph, by, sum, factor);
                }
                let body = times(graph, body);
                graph.sum(by, body)
            }
        }
    }

    /// The sum over all entries of the lists of a loop, or over all pairs that these name.
    fn flat(&mut self, graph: &mut Graph, [by, inner]: [LoopId; 2], term: NodeId) -> Option<NodeId> {
        let Loop { parent, from, to } = graph.loops.get(inner);
        let is_list = parent == Some(by) && graph.loops.of_index(to).contains(by);
        // Bounds that are indices themselves, as in triangular loops, need no lists.
        if !is_list || graph.loops.is_without_lists(to) || graph.loops.count() >= LoopSet::CAPACITY {
            return None;
        }
        let rows = [graph.loops.get(by).to, graph.loops.span(from, to)];
        let entries = Entries { rows, loops: [by, inner], from };
        let sum = self.of_pairs(graph, term, entries).or_else(|| self.of_entries(graph, term, entries))?;
        self.count += 1;
        Some(sum)
    }

    /// The sum of a term of each entry.
    fn of_entries(&mut self, graph: &mut Graph, term: NodeId, entries: Entries) -> Option<NodeId> {
        let total = self.texts.total_of(graph, entries)?;
        let all = self.over(graph, total, entries);
        let [by, inner] = entries.loops;
        let mut new: HashMap<NodeId, NodeId> = HashMap::new();
        for id in graph.reachable([term]) {
            let of = |id: NodeId| new.get(&id).copied().unwrap_or(id);
            let loops = graph.loops_of(id);
            let node = match graph.node(id) {
                _ if !loops.contains(by) && !loops.contains(inner) => id,
                Node::Parameter(parameter) => {
                    let entry = self.texts.entry_of(graph, parameter, entries, all)?;
                    graph.parameter(entry)
                }
                Node::Coordinate(element) => {
                    let index = self.index(graph, element.index, entries, all)?;
                    entries.is_point(graph, element).then(|| graph.coordinate(Element { index, ..element }))?
                }
                Node::Sum(within, body) if graph.loops.of_range(within).is_empty() => graph.sum(within, of(body)),
                Node::Sum(..)
                | Node::Fold(..)
                | Node::External(..)
                | Node::FromIndex(_)
                | Node::CompareIndex(..)
                | Node::Flag(_)
                | Node::Entry(..) => return None,
                Node::Select(condition, a, b) => graph.select(of(condition), of(a), of(b)),
                node => graph.rebuilt(node.map(of)),
            };
            new.insert(id, node);
        }
        Some(graph.sum(all, new[&term]))
    }

    /// The sum of a term that is the same if its two points are exchanged, over the pairs that entries name: bonds that are in the
    /// lists of both ends come once.
    fn of_pairs(&mut self, graph: &mut Graph, term: NodeId, entries: Entries) -> Option<NodeId> {
        let mut points: Vec<IndexId> = Vec::new();
        for id in graph.reachable([term]) {
            if let Node::Coordinate(element) = graph.node(id)
                && entries.has(graph.loops.of_element(element))
                && !points.contains(&element.index)
            {
                entries.is_point(graph, element).then(|| points.push(element.index))?;
            }
        }
        let &[a, b] = &points[..] else { return None };
        let moved = |graph: &mut Graph, rest, to: &dyn Fn(IndexId) -> IndexId| {
            rewritten(graph, rest, |graph, id| match graph.node(id) {
                Node::Coordinate(element) => Some(graph.coordinate(Element { index: to(element.index), ..element })),
                _ => None,
            })
        };
        let exchange = |index| [(a, b), (b, a)].iter().find(|(from, _)| *from == index).map_or(index, |(_, to)| *to);
        let (one, mut terms) = (graph.constant(1.0), Vec::new());
        add_terms(graph, term, one, &mut terms);
        let mut numbers = Vec::new();
        for (coefficient, rest) in &terms {
            let exchanged = moved(graph, *rest, &exchange);
            let is_same = are_equal(graph, [*rest, exchanged], entries.loops, self.texts)?;
            (is_same && !has_numbers(graph, *rest, entries)).then_some(())?;
            numbers.push(match entries.has(graph.loops_of(*coefficient)) {
                true => Some(self.texts.as_parameter(graph, *coefficient)?),
                false => None,
            });
        }
        let pair = [a, b];
        let total = self.texts.count_of_pairs(graph, pair, entries)?;
        let all = self.over(graph, total, entries);
        let mut lists = [a, b];
        for (member, list) in lists.iter_mut().enumerate() {
            let member = self.texts.member_of_pair(graph, pair, member, entries, all)?;
            *list = graph.loops.intern(Index::Parameter(member));
        }
        let listed = |index| pair.iter().position(|own| *own == index).map_or(index, |member| lists[member]);
        let mut sum = graph.constant(0.0);
        for ((coefficient, rest), number) in terms.into_iter().zip(numbers) {
            let weight = self.texts.weight_of_pair(graph, pair, number, entries, all)?;
            let weight = graph.parameter(weight);
            let weight = if number.is_some() { weight } else { graph.mul(coefficient, weight) };
            let rest = moved(graph, rest, &listed);
            let value = graph.mul(weight, rest);
            sum = graph.add(sum, value);
        }
        Some(graph.sum(all, sum))
    }

    /// The loop over a number of entries or pairs.
    fn over(&mut self, graph: &mut Graph, total: ParameterId, entries: Entries) -> LoopId {
        let [from, to] = [Index::Literal(0), Index::Parameter(total)].map(|bound| graph.loops.intern(bound));
        let all = graph.loops.range(Loop { parent: None, from, to });
        self.texts.name_if_new(all, entries.loops[1]);
        all
    }

    /// The index of a coordinate as an element of a list of all entries.
    fn index(&mut self, graph: &mut Graph, index: IndexId, entries: Entries, all: LoopId) -> Option<IndexId> {
        if !entries.has(graph.loops.of_index(index)) {
            return Some(index);
        }
        let list = self.texts.list_of(graph, index, entries, all)?;
        Some(graph.loops.intern(Index::Parameter(list)))
    }
}

/// Whether a value reads numbers of an entry.
fn has_numbers(graph: &Graph, value: NodeId, entries: Entries) -> bool {
    let of_entry = |id: &NodeId| graph.is_prepared(*id) && entries.has(graph.loops_of(*id));
    graph.reachable([value]).iter().any(of_entry)
}

fn is_from_zero(graph: &Graph, by: LoopId) -> bool {
    graph.loops.literal(graph.loops.get(by).from) == Some(0)
}
