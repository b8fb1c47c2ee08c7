//! Whether a step of an accumulation is a sum.

use super::{Graph, Node, NodeId};

impl Graph {
    /// What `value` adds to `accumulator`: `value == accumulator + addend` with an addend in which the accumulator does
    /// not occur; `None` where it has no such form.
    pub(crate) fn added_to(&mut self, accumulator: NodeId, value: NodeId) -> Option<NodeId> {
        let mut depends = vec![false; self.len()];
        for id in self.reachable([value]) {
            depends[id.position()] =
                id == accumulator || self.node(id).children().any(|child| depends[child.position()]);
        }
        self.added(accumulator, value, &depends)
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
