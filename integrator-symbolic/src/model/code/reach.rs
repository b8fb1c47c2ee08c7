//! The range of an index under the surrounding conditions. Loops between numbers are enumerated, so every condition on
//! their indices counts, `i != 3` as well as `i + 1 < 4`.

use crate::graph::{
    Comparison, Graph, Node, NodeId,
    index::{IndexId, Loop, LoopId, LoopSet},
};
use crate::model::Reader;
use std::collections::HashMap;

/// How many iterations are walked through for one index.
const ITERATIONS: u32 = 20_000;

impl Reader<'_> {
    /// Whether an index stays below a length in all iterations in which the conditions around it may hold.
    pub(crate) fn stays_below(&mut self, position: IndexId, length: u64) -> bool {
        let conditions: Vec<_> = self.conditions.iter().map(|condition| (condition.node, condition.holds)).collect();
        if conditions.is_empty() {
            return false;
        }
        let own = self.graph.loops.with_outer(self.graph.loops.of_index(position));
        let of_conditions = conditions.iter().fold(own, |all, (node, _)| all.union(self.graph.loops_of(*node)));
        // The bounds of a loop are made of the indices of older ones.
        let loops: Vec<LoopId> = self.graph.loops.with_outer(of_conditions).iter().collect();
        let graph = &self.graph;
        let mut walk = Walk { graph, own, conditions, position, length, left: ITERATIONS, indices: HashMap::new() };
        let stays = walk.through(&loops) == Some(true);
        if stays {
            self.graph.loops.declare_guarded(position);
        }
        stays
    }
}

/// A walk through the iterations of some loops.
struct Walk<'g> {
    graph: &'g Graph,
    /// The loops that the index depends on.
    own: LoopSet,
    conditions: Vec<(NodeId, bool)>,
    position: IndexId,
    length: u64,
    left: u32,
    indices: HashMap<LoopId, i64>,
}

impl Walk<'_> {
    /// Whether the index stays below the length; `None` where the iterations are not known, or too many.
    fn through(&mut self, loops: &[LoopId]) -> Option<bool> {
        let Some((by, inner)) = loops.split_first() else {
            self.left = self.left.checked_sub(1)?;
            let is_reached = self.conditions.iter().all(|(node, holds)| self.holds(*node) != Some(!holds));
            let is_below = |value| u64::try_from(value).is_ok_and(|value| value < self.length);
            return Some(!is_reached || self.graph.loops.value(self.position, &self.indices).is_some_and(is_below));
        };
        let Loop { from, to, .. } = self.graph.loops.get(*by);
        let [from, to] = [from, to].map(|bound| self.graph.loops.value(bound, &self.indices));
        let (Some(from), Some(to)) = (from, to) else {
            // What a condition says of another loop is not known then.
            return if self.own.contains(*by) { None } else { self.through(inner) };
        };
        for index in from..to {
            self.indices.insert(*by, index);
            let stays = self.through(inner);
            if stays != Some(true) {
                return stays;
            }
        }
        self.indices.remove(by);
        Some(true)
    }

    /// Whether a condition holds, if its integers are known.
    fn holds(&self, condition: NodeId) -> Option<bool> {
        match self.graph.node(condition) {
            Node::CompareIndex(comparison, a, b) => {
                let [a, b] = [a, b].map(|index| self.graph.loops.value(index, &self.indices));
                let (a, b) = (a?, b?);
                Some(match comparison {
                    Comparison::Less => a < b,
                    Comparison::LessOrEqual => a <= b,
                    Comparison::Equal => a == b,
                })
            }
            Node::Not(inner) => self.holds(inner).map(|holds| !holds),
            Node::And(a, b) => match (self.holds(a), self.holds(b)) {
                (Some(false), _) | (_, Some(false)) => Some(false),
                (Some(true), Some(true)) => Some(true),
                _ => None,
            },
            Node::Or(a, b) => match (self.holds(a), self.holds(b)) {
                (Some(true), _) | (_, Some(true)) => Some(true),
                (Some(false), Some(false)) => Some(false),
                _ => None,
            },
            _ => None,
        }
    }
}
