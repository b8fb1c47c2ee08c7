//! Lists of lists as one list: `for i in 0..n { for &j in &self.neighbours[i] { .. } }` becomes a loop over all entries.
//!
//! In: a potential. Out: the same potential, in which such sums run over one list of terms, whose indices and numbers are
//! prepared once per run. So terms share vectors, however short the inner lists are. Always true: the terms are the same, in the
//! order of the loops.

use crate::{
    graph::{
        Element, Graph, Node, NodeId,
        index::{Index, IndexId, Loop, LoopId, LoopSet},
        rename::Parameters,
    },
    model::{Entries, Texts},
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
            _ => id,
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

    /// The sum over all entries of the lists of a loop.
    fn flat(&mut self, graph: &mut Graph, [by, inner]: [LoopId; 2], term: NodeId) -> Option<NodeId> {
        let Loop { parent, to, .. } = graph.loops.get(inner);
        let is_list = parent == Some(by) && is_from_zero(graph, inner) && graph.loops.of_index(to).contains(by);
        // Bounds that are indices themselves, as in triangular loops, need no lists.
        if !is_list || graph.loops.is_without_lists(to) || graph.loops.count() >= LoopSet::CAPACITY {
            return None;
        }
        let rows = [graph.loops.get(by).to, to];
        let total = self.texts.total_of(graph, rows, by)?;
        let [from, to] = [Index::Literal(0), Index::Parameter(total)].map(|bound| graph.loops.intern(bound));
        let all = graph.loops.range(Loop { parent: None, from, to });
        self.texts.name_if_new(all, inner);
        let entries = Entries { rows, loops: [by, inner], all };
        let mut new: HashMap<NodeId, NodeId> = HashMap::new();
        for id in graph.reachable([term]) {
            let of = |id: NodeId| new.get(&id).copied().unwrap_or(id);
            let loops = graph.loops_of(id);
            let node = match graph.node(id) {
                _ if !loops.contains(by) && !loops.contains(inner) => id,
                Node::Parameter(parameter) => {
                    let entry = self.texts.entry_of(graph, parameter, entries)?;
                    graph.parameter(entry)
                }
                Node::Coordinate(element) => {
                    let index = self.index(graph, element.index, entries)?;
                    let is_apart = element.component.is_none_or(|component| {
                        let loops = graph.loops.of_index(component);
                        !loops.contains(by) && !loops.contains(inner)
                    });
                    is_apart.then(|| graph.coordinate(Element { index, ..element }))?
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
        self.count += 1;
        Some(graph.sum(all, new[&term]))
    }

    /// The index of a coordinate as an element of a list of all entries.
    fn index(&mut self, graph: &mut Graph, index: IndexId, entries: Entries) -> Option<IndexId> {
        let own = graph.loops.of_index(index);
        if !entries.loops.into_iter().any(|by| own.contains(by)) {
            return Some(index);
        }
        let list = self.texts.list_of(graph, index, entries)?;
        Some(graph.loops.intern(Index::Parameter(list)))
    }
}

fn is_from_zero(graph: &Graph, by: LoopId) -> bool {
    graph.loops.literal(graph.loops.get(by).from) == Some(0)
}
