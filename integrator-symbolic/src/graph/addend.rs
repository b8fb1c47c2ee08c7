//! Accumulations: whether an iteration adds a term or is a step of Horner's rule.

use super::{Graph, Node, NodeId};

impl Graph {
    /// The addend of `value` beside `accumulator`: `value == accumulator + addend` with an addend in which the
    /// accumulator does not occur; `None` where it has no such form.
    pub(crate) fn added_to(&mut self, accumulator: NodeId, value: NodeId) -> Option<NodeId> {
        let depends = self.dependent_on(accumulator, value);
        self.added(accumulator, value, &depends)
    }

    /// The factor and the addend of `value == accumulator * factor + addend`, in which the accumulator does not occur;
    /// `None` where it has no such form.
    pub(crate) fn linear_in(&mut self, accumulator: NodeId, value: NodeId) -> Option<(NodeId, NodeId)> {
        let depends = self.dependent_on(accumulator, value);
        self.linear(accumulator, value, &depends)
    }

    /// Whether any of `accumulators` occurs in `value`.
    pub(crate) fn mentions(&self, value: NodeId, accumulators: &[NodeId]) -> bool {
        self.reachable([value]).iter().any(|id| accumulators.contains(id))
    }

    /// For each node, by its position, whether `value` reads the accumulator through it.
    fn dependent_on(&self, accumulator: NodeId, value: NodeId) -> Vec<bool> {
        let mut depends = vec![false; self.len()];
        for id in self.reachable([value]) {
            depends[id.position()] =
                id == accumulator || self.node(id).children().any(|child| depends[child.position()]);
        }
        depends
    }

    fn linear(&mut self, accumulator: NodeId, value: NodeId, depends: &[bool]) -> Option<(NodeId, NodeId)> {
        let (zero, one) = (self.constant(0.0), self.constant(1.0));
        let depends_on = |id: NodeId| depends[id.position()];
        if value == accumulator {
            return Some((one, zero));
        }
        if !depends_on(value) {
            return Some((zero, value));
        }
        let node = self.node(value);
        let inner = match node {
            Node::Add(a, b) => {
                let (a, b) = (self.linear(accumulator, a, depends)?, self.linear(accumulator, b, depends)?);
                return Some([(a.0, b.0), (a.1, b.1)].map(|(a, b)| self.add(a, b)).into());
            }
            Node::Neg(a) => a,
            Node::Div(a, b) if !depends_on(b) => a,
            Node::Mul(a, b) if depends_on(a) != depends_on(b) => {
                [a, b].into_iter().find(|factor| depends_on(*factor))?
            }
            _ => return None,
        };
        let (factor, addend) = self.linear(accumulator, inner, depends)?;
        let mut outside = |x| match node {
            _ if x == zero => zero,
            Node::Neg(_) => self.neg(x),
            Node::Div(_, by) => self.div(x, by),
            Node::Mul(a, b) => self.mul(x, if a == inner { b } else { a }),
            _ => x,
        };
        Some((outside(factor), outside(addend)))
    }

    fn added(&mut self, accumulator: NodeId, value: NodeId, depends: &[bool]) -> Option<NodeId> {
        let depends_on = |id: NodeId| depends[id.position()];
        let (mut rest, mut addends) = (value, Vec::new());
        let mut sum = loop {
            match self.node(rest) {
                _ if rest == accumulator => break self.constant(0.0),
                Node::Add(a, b) if depends_on(a) != depends_on(b) => {
                    let (next, addend) = if depends_on(a) { (a, b) } else { (b, a) };
                    addends.push(addend);
                    rest = next;
                }
                Node::Select(condition, a, b) if !depends_on(condition) => {
                    let (a, b) = (self.added(accumulator, a, depends)?, self.added(accumulator, b, depends)?);
                    break self.select(condition, a, b);
                }
                _ => return None,
            }
        };
        // In the order in which they were written.
        for addend in addends.into_iter().rev() {
            sum = self.add(sum, addend);
        }
        Some(sum)
    }
}
