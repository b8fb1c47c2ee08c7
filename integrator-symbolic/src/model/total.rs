//! Numbers made of a whole sequence: `sum` and `fold`.

use super::{Reader, sequence::Sequence, value::Value};
use crate::graph::{
    Comparison, NodeId,
    index::{Index, IndexId},
};
use syn::{ExprClosure, ExprMethodCall};

impl Reader<'_> {
    /// `sequence.sum()`, `sequence.fold(start, |sum, x| sum + ...)` and `sequence.count()`.
    pub(super) fn total(&mut self, call: &ExprMethodCall) -> Option<Value> {
        let sequence = self.sequence(&call.receiver)?;
        let (start, step) = match (call.method.to_string().as_str(), call.args.len()) {
            ("fold", 2) => {
                let start = self.expression(&call.args[0])?;
                (self.number(&start, &call.args[0])?, Some(self.closure(&call.args[1])?))
            }
            _ => (self.graph.constant(0.0), None),
        };
        if sequence.literal {
            let sequence = self.with_conditions(sequence);
            let mut sum = start;
            for turn in self.few_turns(&sequence, call)? {
                let index = self.literal_index(turn);
                let addend = self.addend_of(&sequence, index, step.as_deref(), call)?;
                sum = self.graph.add(sum, addend);
            }
            return Some(Value::Real(sum));
        }
        let addend = |reader: &mut Self, index| reader.addend_of(&sequence, index, step.as_deref(), call);
        let sum = match self.over_whole(&sequence, call, &addend)? {
            Some(sum) => sum,
            None => {
                let by = self.enter(None, sequence.from, sequence.to, call)?;
                let index = self.graph.loops.intern(Index::Running(by));
                let addend = addend(self, index);
                self.leave();
                self.graph.sum(by, addend?)
            }
        };
        Some(Value::Real(self.graph.add(start, sum)))
    }

    /// A sum that lists of the system may end, as one that they do not end, with coefficients that are zero behind their
    /// ends; nothing where the sum has no such form.
    fn over_whole(
        &mut self,
        sequence: &Sequence,
        call: &ExprMethodCall,
        addend: &dyn Fn(&mut Self, IndexId) -> Option<NodeId>,
    ) -> Option<Option<NodeId>> {
        let Some((whole, end)) = self.graph.loops.end_without_lists(sequence.to) else { return Some(None) };
        let by = self.enter(None, sequence.from, whole, call)?;
        let index = self.graph.loops.intern(Index::Running(by));
        let addend = addend(self, index);
        self.leave();
        let addend = addend?;
        let inside = self.graph.compare_index(Comparison::Less, index, end);
        let weighted = self.graph.weighted(by, inside, addend);
        Some(weighted.map(|addend| self.graph.sum(by, addend)))
    }

    /// What the item for an index adds to a sum.
    fn addend_of(
        &mut self,
        sequence: &Sequence,
        index: IndexId,
        step: Option<&ExprClosure>,
        call: &ExprMethodCall,
    ) -> Option<NodeId> {
        let item = self.item_of(sequence, index)?;
        let value = match step {
            None => self.number(&item.value, &call.receiver)?,
            Some(step) => self.folded(step, item.value)?,
        };
        let zero = self.graph.constant(0.0);
        Some(item.condition.map_or(value, |condition| self.graph.select(condition, value, zero)))
    }

    /// What `|sum, item| sum + addend` adds.
    fn folded(&mut self, step: &ExprClosure, item: Value) -> Option<NodeId> {
        let zero = self.graph.constant(0.0);
        let one = self.graph.constant(1.0);
        let [first, second] = [zero, one].map(|start| {
            let value = self.applied(step, vec![Value::Real(start), item.clone()]);
            value.and_then(|value| self.number(&value, &step.body))
        });
        // A fold is a sum if what it adds to 0 and to 1 differs by 1 for every item: `addend` and `addend + 1`.
        let (addend, next) = (first?, second?);
        let expected = self.graph.add(addend, one);
        if next != expected {
            self.errors.at(&step.body, "a `fold` over coordinates has to be a sum: write `|sum, x| sum + ...`");
            return None;
        }
        Some(addend)
    }
}

/// Whether a method makes a number of a sequence.
pub(super) fn is_total(call: &ExprMethodCall) -> bool {
    matches!(call.method.to_string().as_str(), "sum" | "fold")
}
