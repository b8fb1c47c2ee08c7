//! Bounds of a prepared number over all pairs, for cutoffs that depend on the bodies.
//!
//! In: a prepared number of a pair, such as `self.sigma[i] + self.sigma[j]`. Out: two numbers that a run prepares once. Always
//! true: the number of each pair lies between them, by interval arithmetic, or it is a root or a quotient that is not a number. So
//! lists of neighbours within the larger bound contain every pair within its own cutoff.

use crate::graph::{
    Comparison, Graph, Node, NodeId,
    index::LoopId,
    rename::{End, Parameters},
};
use std::collections::HashMap;

/// The pairs that numbers are bounded over.
pub(super) struct Extremes<'p> {
    pub(super) pair: [LoopId; 2],
    /// The ends of the list at which the bodies have no partner.
    pub(super) ends: [Option<End>; 2],
    pub(super) parameters: &'p mut dyn Parameters,
    /// The bounds found so far.
    pub(super) known: HashMap<NodeId, Option<[NodeId; 2]>>,
}

impl Extremes<'_> {
    /// The least and the greatest value; `None` of operations without a rule.
    pub(super) fn of(&mut self, graph: &mut Graph, id: NodeId) -> Option<[NodeId; 2]> {
        if graph.loops_of(id).is_empty() {
            return Some([id; 2]);
        }
        if let Some(known) = self.known.get(&id) {
            return *known;
        }
        let bounds = self.of_operation(graph, id);
        self.known.insert(id, bounds);
        bounds
    }

    /// Whether a number may be NaN for finite parameters: a root or a quotient of numbers of the pair.
    pub(super) fn may_be_nan(graph: &Graph, id: NodeId) -> bool {
        let mut numbers = graph.reachable([id]).into_iter().filter(|id| !graph.loops_of(*id).is_empty());
        numbers.any(|id| match graph.node(id) {
            Node::Div(..) => true,
            Node::Power(_, halves) => halves < 0 || halves % 2 != 0,
            _ => false,
        })
    }

    fn of_operation(&mut self, graph: &mut Graph, id: NodeId) -> Option<[NodeId; 2]> {
        match graph.node(id) {
            Node::Parameter(parameter) => {
                let of_loop = |by: &LoopId| graph.loops.of_parameter(parameter).contains(*by);
                let body = self.pair.iter().position(of_loop)?;
                let (by, end) = (self.pair[body], self.ends[body]);
                let [least, greatest] = self.parameters.extremes(graph, parameter, by, end)?;
                Some([graph.parameter(least), graph.parameter(greatest)])
            }
            Node::Entry(table, ..) => {
                let Node::Parameter(table) = graph.node(table) else { return None };
                let [least, greatest] = self.parameters.extreme_entries(graph, table)?;
                Some([graph.parameter(least), graph.parameter(greatest)])
            }
            Node::Neg(a) => {
                let [least, greatest] = self.of(graph, a)?;
                Some([graph.neg(greatest), graph.neg(least)])
            }
            Node::Add(a, b) => {
                let [a, b] = [self.of(graph, a)?, self.of(graph, b)?];
                Some([graph.add(a[0], b[0]), graph.add(a[1], b[1])])
            }
            Node::Mul(a, b) => {
                let both = [self.of(graph, a)?, self.of(graph, b)?];
                Some(Self::of_ends(graph, both, Graph::mul))
            }
            Node::Div(a, b) => self.quotient(graph, a, b),
            Node::Power(a, halves) if halves < 0 => {
                let (one, power) = (graph.constant(1.0), graph.power(a, -halves));
                self.quotient(graph, one, power)
            }
            Node::Power(a, halves) => {
                let (ends, zero) = (self.of(graph, a)?, graph.constant(0.0));
                // A root is not a number below zero.
                let ends = if halves % 2 == 0 { ends } else { ends.map(|end| graph.call_two("max", end, zero)) };
                let [least, greatest] = ends.map(|end| graph.power(end, halves));
                if halves % 4 != 0 {
                    return Some([least, greatest]);
                }
                let opposite = graph.neg(ends[1]);
                let nearest = graph.call_two("max", ends[0], opposite);
                let nearest = graph.call_two("max", nearest, zero);
                Some([graph.power(nearest, halves), graph.call_two("max", least, greatest)])
            }
            Node::Binary(function, a, b) if matches!(function.name(), "max" | "min") => {
                let both = [self.of(graph, a)?, self.of(graph, b)?];
                Some([0, 1].map(|end| graph.call_two(function.name(), both[0][end], both[1][end])))
            }
            Node::Select(_, a, b) => {
                let both = [self.of(graph, a)?, self.of(graph, b)?];
                let [a, b] = both;
                Some([graph.call_two("min", a[0], b[0]), graph.call_two("max", a[1], b[1])])
            }
            _ => None,
        }
    }

    /// Bounds of a quotient; infinite if the divisor depends on the pair and may be zero or negative.
    fn quotient(&mut self, graph: &mut Graph, a: NodeId, b: NodeId) -> Option<[NodeId; 2]> {
        let both = [self.of(graph, a)?, self.of(graph, b)?];
        let quotients = Self::of_ends(graph, both, Graph::div);
        if graph.loops_of(b).is_empty() {
            return Some(quotients);
        }
        let zero = graph.constant(0.0);
        let is_positive = graph.compare(Comparison::Less, zero, both[1][0]);
        let unbounded = [f64::NEG_INFINITY, f64::INFINITY].map(|bound| graph.constant(bound));
        Some([0, 1].map(|end| graph.select(is_positive, quotients[end], unbounded[end])))
    }

    /// The least and the greatest result of an operation on the ends of two intervals.
    fn of_ends(
        graph: &mut Graph,
        [a, b]: [[NodeId; 2]; 2],
        operation: fn(&mut Graph, NodeId, NodeId) -> NodeId,
    ) -> [NodeId; 2] {
        let results = [(0, 0), (0, 1), (1, 0), (1, 1)].map(|(i, j)| operation(graph, a[i], b[j]));
        ["min", "max"].map(|name| {
            let [first, others @ ..] = results;
            others.into_iter().fold(first, |so_far, next| match so_far == next {
                true => so_far,
                false => graph.call_two(name, so_far, next),
            })
        })
    }
}
