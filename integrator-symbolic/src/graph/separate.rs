//! Separation of a function of positions and momenta into a sum of two functions, one of each.

use super::{Graph, Node, NodeId, Part};
use std::collections::HashMap;

impl Graph {
    /// `T(p)` and `V(q)` whose sum a value is, term by term, those of sums too; nothing where a term depends on both. What
    /// depends on neither is part of `V`.
    pub(crate) fn separated(&mut self, energy: NodeId) -> Option<[NodeId; 2]> {
        self.separate(energy, &mut HashMap::new())
    }

    /// Whether a node depends on positions and on momenta.
    pub(crate) fn is_mixed(&self, id: NodeId) -> bool {
        self.reads(id, Part::Position) && self.reads(id, Part::Momentum)
    }

    fn separate(&mut self, id: NodeId, known: &mut HashMap<NodeId, Option<[NodeId; 2]>>) -> Option<[NodeId; 2]> {
        if let Some(known) = known.get(&id) {
            return *known;
        }
        let zero = self.constant(0.0);
        let separated = match self.node(id) {
            _ if !self.reads(id, Part::Momentum) => Some([zero, id]),
            Node::Add(a, b) => {
                let (a, b) = (self.separate(a, known)?, self.separate(b, known)?);
                Some([self.add(a[0], b[0]), self.add(a[1], b[1])])
            }
            _ if !self.reads(id, Part::Position) => Some([id, zero]),
            Node::Neg(a) => self.separate(a, known).map(|parts| parts.map(|part| self.neg(part))),
            Node::Mul(factor, a) | Node::Mul(a, factor) if !self.reads_coordinates(factor) => {
                self.separate(a, known).map(|parts| parts.map(|part| self.mul(factor, part)))
            }
            Node::Div(a, divisor) if !self.reads_coordinates(divisor) => {
                self.separate(a, known).map(|parts| parts.map(|part| self.div(part, divisor)))
            }
            Node::Sum(by, body) => self.separate(body, known).map(|parts| parts.map(|part| self.sum(by, part))),
            Node::Select(condition, a, b) => {
                let (a, b) = (self.separate(a, known)?, self.separate(b, known)?);
                let decides = [Part::Position, Part::Momentum].map(|other| self.reads(condition, other));
                let is_decided_by_its_own = (0..2).all(|part| a[part] == b[part] || !decides[part]);
                is_decided_by_its_own.then(|| [0, 1].map(|part| self.select(condition, a[part], b[part])))
            }
            _ => None,
        };
        known.insert(id, separated);
        separated
    }

    pub(crate) fn reads_coordinates(&self, id: NodeId) -> bool {
        self.reads(id, Part::Position) || self.reads(id, Part::Momentum)
    }
}
