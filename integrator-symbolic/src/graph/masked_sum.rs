//! Masked sums: sums in which only the first items count, with the mask in their coefficients.
//!
//! A list of the system may be shorter than the coordinates with which it is zipped. An item is then a product with a
//! coefficient that is zero from some index on, prepared once per run. The loop still runs over all coordinates, as
//! lattices and pairs of bodies require.

use super::{Graph, Node, NodeId, index::LoopId};

impl Graph {
    /// `value` where the condition holds, else zero, with the condition in prepared coefficients alone; `None` where
    /// something else reads lists by the index of the loop, or might be infinite where the condition does not hold.
    pub(crate) fn mask_coefficients(&mut self, by: LoopId, condition: NodeId, value: NodeId) -> Option<NodeId> {
        if self.is_prepared(value) && self.loops_of(value).iter().all(|other| other == by) {
            let zero = self.constant(0.0);
            return Some(self.select(condition, value, zero));
        }
        match self.node(value) {
            // finite: c ? -x : 0 == -(c ? x : 0)
            Node::Neg(x) => {
                let x = self.mask_coefficients(by, condition, x)?;
                Some(self.neg(x))
            }
            // finite: c ? x + y : 0 == (c ? x : 0) + (c ? y : 0)
            Node::Add(x, y) => {
                let (x, y) = (self.mask_coefficients(by, condition, x)?, self.mask_coefficients(by, condition, y)?);
                Some(self.add(x, y))
            }
            // finite: c ? x y : 0 == (c ? x : 0) y, for an x that is a coefficient
            Node::Mul(x, y) if self.is_finite_without_lists(by, y) => {
                let x = self.mask_coefficients(by, condition, x)?;
                Some(self.mul(x, y))
            }
            Node::Mul(x, y) if self.is_finite_without_lists(by, x) => {
                let y = self.mask_coefficients(by, condition, y)?;
                Some(self.mul(x, y))
            }
            Node::Div(x, y) if self.as_constant(y).is_some() => {
                let x = self.mask_coefficients(by, condition, x)?;
                Some(self.div(x, y))
            }
            Node::Sum(inner, body) => {
                let body = self.mask_coefficients(by, condition, body)?;
                Some(self.sum(inner, body))
            }
            _ => None,
        }
    }

    /// Whether a node is finite for any coordinates, and reads no list by the index of a loop.
    fn is_finite_without_lists(&self, by: LoopId, root: NodeId) -> bool {
        self.reachable([root]).into_iter().all(|id| match self.node(id) {
            Node::Parameter(parameter) => !self.loops.of_parameter(parameter).contains(by),
            Node::Coordinate(element) => {
                [Some(element.index), element.component].into_iter().flatten().all(|at| self.loops.is_without_lists(at))
            }
            node @ (Node::Constant(_)
            | Node::Time
            | Node::Step
            | Node::Neg(_)
            | Node::Add(..)
            | Node::Mul(..)
            | Node::Div(..)
            | Node::Power(..)
            | Node::Unary(..)
            | Node::Binary(..)
            | Node::Sum(..)) => self.is_total_by_itself(node),
            _ => false,
        })
    }
}
