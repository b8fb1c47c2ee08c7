//! Sums over all pairs of indices with each pair once: `for i in 0..n { for j in 0..n { .. } }` visits `i, j` and `j, i`.
//!
//! In: a potential. Out: the same potential, in which such sums run over `j < i`, with the terms of both visits in one, and the
//! terms of `i, i` in the loop around. So functions and tables are those of half the pairs. Always true: each term is a
//! coefficient times a value that is the same, or changes its sign, if the indices are exchanged; the sum of the coefficients of
//! both visits is prepared.

use crate::{
    graph::{
        Graph, Node, NodeId,
        index::{Index, IndexId, Loop, LoopId, LoopSet},
        rename::{Parameters, Renaming},
    },
    model::Texts,
    pairs::{addend_of_distinct_pair, renamed, sign_of_exchange},
};

/// The potential with such sums over each pair once; `None` if there are none.
pub(super) fn visited_once(graph: &mut Graph, potential: NodeId, texts: &mut Texts<'_>) -> Option<NodeId> {
    let mut sums = Sums { texts, count: 0, apart: Vec::new() };
    let once = sums.of_all(graph, potential);
    (sums.count > 0).then_some(once)
}

struct Sums<'t, 'm> {
    texts: &'t mut Texts<'m>,
    /// The number of sums whose pairs are visited once now.
    count: usize,
    /// Those of the present loop that run over all indices, where lists of the system may end that loop.
    apart: Vec<(LoopId, NodeId)>,
}

impl Sums<'_, '_> {
    /// A sum of terms outside of all loops.
    fn of_all(&mut self, graph: &mut Graph, id: NodeId) -> NodeId {
        match graph.node(id) {
            Node::Sum(by, body) if graph.loops.get(by).parent.is_none() => {
                let one = graph.constant(1.0);
                let body = self.of_body(graph, by, body, one);
                let sum = graph.sum(by, body);
                std::mem::take(&mut self.apart).into_iter().fold(sum, |sum, (by, body)| {
                    let apart = graph.sum(by, body);
                    graph.add(sum, apart)
                })
            }
            Node::Add(a, b) => {
                let (a, b) = (self.of_all(graph, a), self.of_all(graph, b));
                graph.add(a, b)
            }
            Node::Neg(a) => {
                let a = self.of_all(graph, a);
                graph.neg(a)
            }
            Node::Mul(factor, a) if graph.is_prepared(factor) => {
                let a = self.of_all(graph, a);
                graph.mul(factor, a)
            }
            _ => id,
        }
    }

    /// `factor` times a part of the body of a loop.
    fn of_body(&mut self, graph: &mut Graph, by: LoopId, id: NodeId, factor: NodeId) -> NodeId {
        let has_squares =
            |graph: &Graph, id| graph.summed_in(id).iter().any(|inner| Square::of(graph, by, inner).is_some());
        let count = self.count;
        let once = match graph.node(id) {
            Node::Sum(inner, term) if Square::of(graph, by, inner).is_some() => {
                let term = graph.mul(factor, term);
                let once = self.once(graph, [by, inner], term);
                self.count += usize::from(once.is_some());
                once.map(|(outer, once)| match outer == by {
                    true => once,
                    false => {
                        self.apart.push((outer, once));
                        graph.constant(0.0)
                    }
                })
            }
            Node::Add(a, b) => {
                let (a, b) = (self.of_body(graph, by, a, factor), self.of_body(graph, by, b, factor));
                Some(graph.add(a, b))
            }
            Node::Neg(a) => {
                let a = self.of_body(graph, by, a, factor);
                Some(graph.neg(a))
            }
            Node::Mul(own, a) | Node::Mul(a, own) if has_squares(graph, a) && !has_squares(graph, own) => {
                let factor = graph.mul(factor, own);
                Some(self.of_body(graph, by, a, factor))
            }
            _ => None,
        };
        // Without such sums, it stays as written.
        once.filter(|_| self.count > count).unwrap_or_else(|| graph.mul(factor, id))
    }

    /// The sum of a term over all indices of the second loop, as one over those before the index of the first loop and a term of
    /// this index alone; and the first loop, which is another one where lists end the loops of the pair.
    fn once(&mut self, graph: &mut Graph, pair: [LoopId; 2], term: NodeId) -> Option<(LoopId, NodeId)> {
        if graph.loops.count() + 2 > LoopSet::CAPACITY {
            return None;
        }
        let [by, inner] = pair;
        let square = Square::of(graph, by, inner)?;
        let (term, has_equal) = match addend_of_distinct_pair(graph, pair, term) {
            Some(term) => (term, false),
            None => (term, true),
        };
        let (zero, one) = (graph.constant(0.0), graph.constant(1.0));
        let mut terms = Vec::new();
        add_terms(graph, term, one, &mut terms);
        let is_odd = |rest| sign_of_exchange(graph, rest, pair, self.texts);
        let are_odd = terms.iter().map(|(_, rest)| *rest).map(is_odd).collect::<Option<Vec<_>>>()?;
        let outer = match square {
            Square::Whole => by,
            Square::EndedByLists(to) => {
                let from = graph.loops.get(by).from;
                graph.loops.range(Loop { parent: None, from, to })
            }
        };
        let [from, to] = [Index::Literal(0), Index::Running(outer)].map(|bound| graph.loops.intern(bound));
        let before = graph.loops.range(Loop { parent: Some(outer), from, to });
        self.texts.name_if_new(outer, by);
        self.texts.name_if_new(before, inner);
        let (mut of_pair, mut of_equal) = (zero, zero);
        for ((coefficient, rest), is_odd) in terms.into_iter().zip(are_odd) {
            let coefficient = match square {
                Square::Whole => coefficient,
                Square::EndedByLists(_) => {
                    let ends = pair.map(|by| (by, graph.loops.get(by).to));
                    self.texts.ended(graph, coefficient, ends)?
                }
            };
            let exchanged = renamed(graph, coefficient, Renaming::exchange(pair), self.texts)?;
            let both = if is_odd { graph.sub(coefficient, exchanged) } else { graph.add(coefficient, exchanged) };
            let both = self.texts.as_table(graph, both)?;
            let value = graph.mul(both, rest);
            let value = renamed(graph, value, Renaming::both(pair, [outer, before]), self.texts)?;
            of_pair = graph.add(of_pair, value);
            if has_equal && !is_odd {
                let value = graph.mul(coefficient, rest);
                let value = renamed(graph, value, Renaming::both(pair, [outer, outer]), self.texts)?;
                of_equal = graph.add(of_equal, value);
            }
        }
        let pairs = graph.sum(before, of_pair);
        Some((outer, graph.add(pairs, of_equal)))
    }
}

/// Adds the terms of `factor` times a node, each with what is prepared of it and the rest.
pub(super) fn add_terms(graph: &mut Graph, id: NodeId, factor: NodeId, terms: &mut Vec<(NodeId, NodeId)>) {
    match graph.node(id) {
        Node::Add(a, b) => {
            add_terms(graph, a, factor, terms);
            add_terms(graph, b, factor, terms);
        }
        Node::Neg(a) => {
            let factor = graph.neg(factor);
            add_terms(graph, a, factor, terms);
        }
        _ => {
            let (coefficient, rest) = coefficient_and_rest(graph, id);
            match graph.node(rest) {
                Node::Add(..) => {
                    let factor = graph.mul(factor, coefficient);
                    add_terms(graph, rest, factor, terms);
                }
                _ => terms.push((graph.mul(factor, coefficient), rest)),
            }
        }
    }
}

/// What is prepared of a product, and the rest.
fn coefficient_and_rest(graph: &mut Graph, id: NodeId) -> (NodeId, NodeId) {
    let one = graph.constant(1.0);
    match graph.node(id) {
        _ if graph.is_prepared(id) => (id, one),
        Node::Neg(a) => {
            let (coefficient, rest) = coefficient_and_rest(graph, a);
            (graph.neg(coefficient), rest)
        }
        Node::Mul(a, b) => {
            let ((c, x), (d, y)) = (coefficient_and_rest(graph, a), coefficient_and_rest(graph, b));
            (graph.mul(c, d), graph.mul(x, y))
        }
        Node::Div(a, b) if graph.is_prepared(b) => {
            let (coefficient, rest) = coefficient_and_rest(graph, a);
            (graph.div(coefficient, b), rest)
        }
        _ => (one, id),
    }
}

/// Two loops over the same indices, one inside of the other.
#[derive(Clone, Copy)]
enum Square {
    /// Both run over all of these.
    Whole,
    /// Both would run up to the same end, before which lists of the system may end them.
    EndedByLists(IndexId),
}

impl Square {
    fn of(graph: &Graph, by: LoopId, inner: LoopId) -> Option<Self> {
        let (around, within) = (graph.loops.get(by), graph.loops.get(inner));
        if within.parent != Some(by) || [around.from, within.from].map(|from| graph.loops.literal(from)) != [Some(0); 2]
        {
            return None;
        }
        if around.to == within.to && graph.loops.of_index(around.to).is_empty() {
            return Some(Self::Whole);
        }
        let extent = |to: IndexId| match graph.loops.index(to) {
            Index::Min(a, b) => [a, b].into_iter().find(|end| graph.loops.is_extent(*end)),
            _ => Some(to).filter(|to| graph.loops.is_extent(*to)),
        };
        let ends = extent(around.to).zip(extent(within.to));
        ends.filter(|(a, b)| a == b).map(|(end, _)| Self::EndedByLists(end))
    }
}
