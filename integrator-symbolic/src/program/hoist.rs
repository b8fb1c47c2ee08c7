//! Conditions that are the same for all iterations are asked in front of the loop.
//!
//! In: a program. Out: the same, where a loop that does nothing but what one condition decides is inside of the branch. Always
//! true: the lines and their order stay. A loop that does more than that keeps its branch, because two loops would compute
//! twice what both need.

use super::{Item, Program};
use crate::graph::{Graph, NodeId, index::LoopId};

impl Program {
    /// The same program with branches outside of loops.
    pub(crate) fn hoisted(self, graph: &Graph) -> Self {
        Self { items: hoisted(graph, self.items), ..self }
    }
}

fn hoisted(graph: &Graph, items: Vec<Item>) -> Vec<Item> {
    let line = |item| match item {
        Item::Loop { by, body } => in_front(graph, by, hoisted(graph, body)),
        Item::Branch { condition, holds, body } => {
            vec![Item::Branch { condition, holds, body: hoisted(graph, body) }]
        }
        other => vec![other],
    };
    items.into_iter().flat_map(line).collect()
}

/// A loop, inside of the branches that its iterations consist of if these are on one condition for all of them.
fn in_front(graph: &Graph, by: LoopId, body: Vec<Item>) -> Vec<Item> {
    match decided_by(graph, by, &body) {
        None => vec![Item::Loop { by, body }],
        Some(_) => body
            .into_iter()
            .flat_map(|line| match line {
                Item::Branch { condition, holds, body } => {
                    vec![Item::Branch { condition, holds, body: in_front(graph, by, body) }]
                }
                other => vec![other],
            })
            .collect(),
    }
}

/// The condition that all lines of a loop are under, on either side, if it does not depend on the loop.
fn decided_by(graph: &Graph, by: LoopId, body: &[Item]) -> Option<NodeId> {
    let of = |line: &Item| match line {
        Item::Branch { condition, .. } => Some(*condition),
        _ => None,
    };
    let first = body.first().and_then(of)?;
    let is_of_all = !graph.loops_of(first).contains(by) && body.iter().all(|line| of(line) == Some(first));
    is_of_all.then_some(first)
}
