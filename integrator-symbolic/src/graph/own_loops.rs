//! Products of sums of coordinates with a separate loop for each sum, `(Σᵢ cᵢ qᵢ)(Σⱼ cⱼ qⱼ)`.
//!
//! Two loops over the same range in the same position are one loop in this crate. A second derivative of a squared sum
//! has an index from each of its two factors, which could not be distinguished then.

use super::{
    Graph, Node, NodeId,
    index::{IndexId, Loop, LoopId, LoopSet},
    rename::{Parameters, Renaming, rename},
};
use std::collections::HashSet;

impl Graph {
    /// The same quadratic form, in which sums that are multiplied by each other, or by what has the same index, have other
    /// loops; `None` where a text or a list does not show how it would be written with another index.
    pub(crate) fn with_own_loops(&mut self, form: NodeId, texts: &mut dyn Parameters) -> Option<NodeId> {
        let products = self.multiplying_sums(form);
        let mut apart = Apart { products, texts, made: Vec::new() };
        apart.terms(self, form, LoopSet::EMPTY)
    }
}

struct Apart<'t> {
    /// The values that have a product to be taken apart.
    products: HashSet<NodeId>,
    texts: &'t mut dyn Parameters,
    /// Loops that were made, each in the place of another one.
    made: Vec<(LoopId, LoopId)>,
}

impl Apart<'_> {
    /// A sum of terms inside of loops.
    fn terms(&mut self, graph: &mut Graph, id: NodeId, around: LoopSet) -> Option<NodeId> {
        if !self.products.contains(&id) {
            return Some(id);
        }
        Some(match graph.node(id) {
            Node::Add(a, b) => {
                let (a, b) = (self.terms(graph, a, around)?, self.terms(graph, b, around)?);
                graph.add(a, b)
            }
            Node::Neg(a) => {
                let a = self.terms(graph, a, around)?;
                graph.neg(a)
            }
            Node::Sum(by, body) => {
                let body = self.terms(graph, body, around.union(LoopSet::of(by)))?;
                graph.sum(by, body)
            }
            Node::Div(a, divisor) => {
                let a = self.terms(graph, a, around)?;
                graph.div(a, divisor)
            }
            Node::Select(condition, a, b) => {
                let (a, b) = (self.terms(graph, a, around)?, self.terms(graph, b, around)?);
                graph.select(condition, a, b)
            }
            Node::Mul(factor, a) | Node::Mul(a, factor) if !graph.reads_coordinates(factor) => {
                let a = self.terms(graph, a, around)?;
                graph.mul(factor, a)
            }
            Node::Mul(a, b) => self.product(graph, [a, b], around)?,
            // The square of a linear form.
            Node::Power(a, _) => self.product(graph, [a, a], around)?,
            _ => return None,
        })
    }

    /// The product of two linear forms inside of loops.
    fn product(&mut self, graph: &mut Graph, [a, b]: [NodeId; 2], around: LoopSet) -> Option<NodeId> {
        let a = self.linear(graph, a, around)?;
        let taken = around.union(summed(graph, a));
        let b = self.linear(graph, b, taken)?;
        Some(graph.mul(a, b))
    }

    /// A linear form whose sums run over none of the loops that are taken.
    fn linear(&mut self, graph: &mut Graph, id: NodeId, taken: LoopSet) -> Option<NodeId> {
        if summed(graph, id).intersection(taken).is_empty() {
            return Some(id);
        }
        Some(match graph.node(id) {
            Node::Add(a, b) => {
                let (a, b) = (self.linear(graph, a, taken)?, self.linear(graph, b, taken)?);
                graph.add(a, b)
            }
            Node::Neg(a) => {
                let a = self.linear(graph, a, taken)?;
                graph.neg(a)
            }
            Node::Mul(factor, a) | Node::Mul(a, factor) if !graph.reads_coordinates(factor) => {
                let a = self.linear(graph, a, taken)?;
                graph.mul(factor, a)
            }
            Node::Div(a, divisor) => {
                let a = self.linear(graph, a, taken)?;
                graph.div(a, divisor)
            }
            Node::Select(condition, a, b) => {
                let (a, b) = (self.linear(graph, a, taken)?, self.linear(graph, b, taken)?);
                graph.select(condition, a, b)
            }
            Node::Sum(by, body) => {
                let body = self.linear(graph, body, taken)?;
                match taken.contains(by) {
                    true => self.moved(graph, by, body, taken)?,
                    false => graph.sum(by, body),
                }
            }
            _ => return None,
        })
    }

    /// The sum of what has the index of a loop, over another loop.
    fn moved(&mut self, graph: &mut Graph, by: LoopId, body: NodeId, taken: LoopSet) -> Option<NodeId> {
        if !is_renamed_by_its_text(graph, by, body) {
            return None;
        }
        let taken = taken.union(graph.loops_of(body)).union(all_summed(graph, body));
        let known = self.made.iter().find(|(like, own)| *like == by && !taken.contains(*own));
        let own = match known {
            Some((_, own)) => *own,
            None => {
                let own = graph.loops.beside(by)?;
                self.texts.name(own, by);
                self.made.push((by, own));
                own
            }
        };
        let body = rename(graph, body, Renaming::one(by, own), self.texts)?;
        Some(graph.sum(own, body))
    }
}

/// The loops that coordinates are summed over in a value.
fn summed(graph: &Graph, id: NodeId) -> LoopSet {
    let sums = graph.reachable([id]).into_iter().filter_map(|id| match graph.node(id) {
        Node::Sum(by, body) if graph.reads_coordinates(body) => Some(by),
        _ => None,
    });
    sums.fold(LoopSet::EMPTY, |all, by| all.union(LoopSet::of(by)))
}

/// The loops that anything is summed over in a value.
fn all_summed(graph: &Graph, id: NodeId) -> LoopSet {
    let sums = graph.reachable([id]).into_iter().filter_map(|id| match graph.node(id) {
        Node::Sum(by, _) => Some(by),
        _ => None,
    });
    sums.fold(LoopSet::EMPTY, |all, by| all.union(LoopSet::of(by)))
}

/// Whether all that a value has of an index is in its indices and in texts, and not in lists of indices or in bounds of loops.
fn is_renamed_by_its_text(graph: &Graph, by: LoopId, body: NodeId) -> bool {
    let has_index = |index: IndexId| graph.loops.of_index(index).contains(by);
    let is_plain = |index: IndexId| !has_index(index) || graph.loops.is_without_lists(index);
    graph.reachable([body]).into_iter().all(|id| match graph.node(id) {
        Node::Coordinate(element) => is_plain(element.index) && element.component.is_none_or(is_plain),
        Node::FromIndex(index) => is_plain(index),
        Node::CompareIndex(_, a, b) => is_plain(a) && is_plain(b),
        Node::Sum(inner, _) => {
            let Loop { from, to, .. } = graph.loops.get(inner);
            !has_index(from) && !has_index(to)
        }
        _ => true,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::graph::{Element, ParameterId, Part, evaluate::Point, index::Index};

    /// No text.
    struct Untold;

    impl Parameters for Untold {
        fn rename(&mut self, _: &mut Graph, _: ParameterId, _: Renaming) -> Option<ParameterId> {
            None
        }
        fn factors(&mut self, _: &mut Graph, id: ParameterId) -> Vec<(ParameterId, i32)> {
            vec![(id, 1)]
        }
        fn name(&mut self, _: LoopId, _: LoopId) {}
    }

    #[test]
    fn squares_of_sums_are_products_over_two_loops() {
        let mut graph = Graph::default();
        let [from, to] = [0, 3].map(|bound| graph.loops.intern(Index::Literal(bound)));
        let by = graph.loops.range(Loop { parent: None, from, to });
        let index = graph.loops.intern(Index::Running(by));
        let q = graph.coordinate(Element { part: Part::Position, index, component: None });
        let number = graph.number_of(index);
        let weighted = graph.mul(number, q);
        let all = graph.sum(by, weighted);
        // Around a mean, inside of the loop that the mean is over.
        let difference = graph.sub(q, all);
        let [square, squares] = [all, difference].map(|of| graph.power(of, 4));
        let squares = graph.sum(by, squares);
        let form = graph.add(square, squares);
        assert!(!graph.multiplying_sums(form).is_empty());
        let apart = graph.with_own_loops(form, &mut Untold).expect("no text is used");
        assert!(graph.multiplying_sums(apart).is_empty(), "{:?}", graph.node(apart));
        let q = [0.5, -2.0, 3.0];
        let [before, after] = [form, apart].map(|of| Point::new(&q, &[]).value(&graph, of));
        assert_eq!((before, after), (16.0 + 12.25 + 36.0 + 1.0, before));
        // What a text hides is left alone.
        let hidden = ParameterId(0);
        graph.loops.declare_parameter(hidden, LoopSet::of(by));
        let hidden = graph.parameter(hidden);
        let weighted = graph.mul(hidden, weighted);
        let all = graph.sum(by, weighted);
        let square = graph.power(all, 4);
        assert_eq!(graph.with_own_loops(square, &mut Untold), None);
    }
}
