//! Loops over all bodies whose terms depend on the order of the two indices, as loops over half of the pairs.

use super::{
    merged::{in_one_direction, sum},
    partners::in_order,
    renamed::renamed,
};
use crate::graph::{
    Graph, NodeId,
    index::{Index, Loop, LoopId, LoopSet},
    rename::{Parameters, Renaming},
};
use std::cmp::Ordering;

/// What a loop over all other bodies adds, if the order of the indices decides that.
pub(super) struct Half {
    /// The loop over the bodies before the first of the pair.
    pub(super) before: LoopId,
    /// What both visits of a pair add.
    pub(super) addend: NodeId,
    /// Whether the second body of the pairs that add something has the larger index; `None` if both visits add something.
    pub(super) ascending: Option<bool>,
}

impl Half {
    pub(super) fn of(
        graph: &mut Graph,
        pair: [LoopId; 2],
        addend: NodeId,
        parameters: &mut dyn Parameters,
    ) -> Option<Self> {
        let [by, other] = pair;
        let visits = [Ordering::Less, Ordering::Greater].map(|order| in_order(graph, addend, pair, Some(order)));
        let [behind, before] = visits;
        if behind == before || graph.loops.count() >= LoopSet::CAPACITY {
            return None;
        }
        let exchanged = renamed(graph, behind, Renaming::exchange(pair), parameters)?;
        let both = [before, exchanged].map(|addend| in_one_direction(graph, addend, pair, parameters));
        let both = sum(graph, both, (pair, [None; 2]), parameters);
        let [from, to] = [Index::Literal(0), Index::Running(by)].map(|bound| graph.loops.intern(bound));
        let half = graph.loops.range(Loop { parent: Some(by), from, to });
        parameters.name_if_new(half, other);
        let ascending = match visits.map(|addend| graph.as_constant(addend) == Some(0.0)) {
            [false, true] => Some(true),
            [true, false] => Some(false),
            _ => None,
        };
        let addend = renamed(graph, both, Renaming::one(other, half), parameters)?;
        Some(Self { before: half, addend, ascending })
    }
}
