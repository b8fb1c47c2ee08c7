//! The results of iterations that are computed in vectors.

use crate::graph::{Graph, NodeId};

/// The results of an iteration so far.
#[derive(Default)]
pub(crate) struct Results {
    /// The values; those that are computed in all lanes may move several coordinates.
    values: Vec<Option<NodeId>>,
    /// The value that each coordinate gets, and whether it is subtracted.
    pub(crate) targets: Vec<(usize, bool)>,
}

impl Results {
    /// Appends a target. Returns the index of its value in the results, unless the value is there already.
    pub(crate) fn push(&mut self, graph: &Graph, value: NodeId, in_all_lanes: bool) -> Option<usize> {
        let (negative, value) = graph.signed(value);
        let of_all = in_all_lanes.then_some(value);
        let known = of_all.and_then(|_| self.values.iter().position(|known| *known == of_all));
        self.targets.push((known.unwrap_or(self.values.len()), negative));
        if known.is_some() {
            return None;
        }
        self.values.push(of_all);
        Some(self.values.len() - 1)
    }
    /// The number of values.
    pub(crate) fn values(&self) -> usize {
        self.values.len()
    }
}
