//! Numbers made of a whole sequence: `sum`, `product` and `fold`.

#[cfg(test)]
mod tests;

use super::{Reader, flatten::nested_sum, repeat::FEW, sequence::Sequence, value::Value};
use crate::graph::{
    Comparison, NodeId,
    index::{Index, IndexId},
};
use quote::quote;
use std::rc::Rc;
use syn::{ExprClosure, ExprMethodCall};

/// What is done with every item.
enum Step {
    /// It is added.
    Add,
    /// It is a factor.
    Multiply,
    /// `|accumulator, item| ...`
    Fold(Rc<ExprClosure>),
}

impl Reader<'_> {
    /// `sequence.sum()`, `sequence.product()` and `sequence.fold(start, |accumulator, item| ...)`: a sum where all that is
    /// done is to add, else written out item by item.
    pub(super) fn total(&mut self, call: &ExprMethodCall) -> Option<Value> {
        if let Some(nested) = nested_sum(call) {
            return self.expression(&nested);
        }
        let sequence = self.sequence(&call.receiver)?;
        let (start, step) = self.step(call)?;
        if !sequence.literal
            && let Some(sum) = self.as_sum(&sequence, &step, call)?
        {
            return Some(Value::Real(self.graph.add(start, sum)));
        }
        self.item_by_item(sequence, start, &step, call)
    }

    /// What the accumulator begins with, and what is done with every item.
    fn step(&mut self, call: &ExprMethodCall) -> Option<(NodeId, Step)> {
        match (call.method.to_string().as_str(), call.args.len()) {
            ("fold", 2) => {
                let start = self.expression(&call.args[0])?;
                Some((self.number(&start, &call.args[0])?, Step::Fold(self.closure(&call.args[1])?)))
            }
            ("product", _) => Some((self.graph.constant(1.0), Step::Multiply)),
            _ => Some((self.graph.constant(0.0), Step::Add)),
        }
    }

    /// The accumulator behind an item.
    fn stepped(&mut self, step: &Step, accumulator: NodeId, item: Value, call: &ExprMethodCall) -> Option<NodeId> {
        match step {
            Step::Add => {
                let item = self.number(&item, &call.receiver)?;
                Some(self.graph.add(accumulator, item))
            }
            Step::Multiply => {
                let item = self.number(&item, &call.receiver)?;
                if self.mixes(accumulator, item) {
                    self.not_separable(&syn::Expr::MethodCall(call.clone()));
                    return None;
                }
                Some(self.graph.mul(accumulator, item))
            }
            Step::Fold(closure) => {
                let value = self.applied(closure, vec![Value::Real(accumulator), item])?;
                self.number(&value, &closure.body)
            }
        }
    }

    /// All items one after the other; notes a mistake if they are too many.
    fn item_by_item(&mut self, sequence: Sequence, start: NodeId, step: &Step, call: &ExprMethodCall) -> Option<Value> {
        let sequence = self.with_conditions(sequence);
        let turns = if sequence.literal { Some(self.few_turns(&sequence, call)?) } else { self.known_turns(&sequence) };
        let Some(turns) = turns else {
            let name = &call.method;
            let message = format!(
                "this `{name}` does more than add, so it is written out, for up to {FEW} items whose number is known \
                 here: run over literals, as in `(0..4).rev().fold(0.0, |sum, k| sum * x + self.c[k])`, or write a sum"
            );
            self.errors.at(name, message);
            return None;
        };
        let mut accumulator = start;
        for turn in turns {
            let index = self.literal_index(turn);
            let item = self.item_of(&sequence, index)?;
            let next = self.stepped(step, accumulator, item.value, call)?;
            accumulator = item.condition.map_or(next, |condition| self.graph.select(condition, next, accumulator));
        }
        Some(Value::Real(accumulator))
    }

    /// The sum that a sequence adds, if adding is all that is done with its items; outside, whether it was read.
    fn as_sum(&mut self, sequence: &Sequence, step: &Step, call: &ExprMethodCall) -> Option<Option<NodeId>> {
        if let Step::Multiply = step {
            return Some(None);
        }
        if let Some((whole, end)) = self.graph.loops.end_without_lists(sequence.to) {
            // As one that lists do not end, with coefficients that are zero behind their ends.
            let by = self.enter(None, sequence.from, whole, call)?;
            let index = self.graph.loops.intern(Index::Running(by));
            let addend = self.addend_of(sequence, index, step, call);
            self.leave();
            let Some(addend) = addend? else { return Some(None) };
            let inside = self.graph.compare_index(Comparison::Less, index, end);
            if let Some(addend) = self.graph.weighted(by, inside, addend) {
                return Some(Some(self.graph.sum(by, addend)));
            }
        }
        let by = self.enter(None, sequence.from, sequence.to, call)?;
        let index = self.graph.loops.intern(Index::Running(by));
        let addend = self.addend_of(sequence, index, step, call);
        self.leave();
        Some(addend?.map(|addend| self.graph.sum(by, addend)))
    }

    /// What the item for an index adds, if adding is all that is done with it.
    fn addend_of(
        &mut self,
        sequence: &Sequence,
        index: IndexId,
        step: &Step,
        call: &ExprMethodCall,
    ) -> Option<Option<NodeId>> {
        let item = self.item_of(sequence, index)?;
        let addend = self.under(item.condition, true, |reader| match step {
            Step::Add => Some(Some(reader.number(&item.value, &call.receiver)?)),
            Step::Multiply => Some(None),
            Step::Fold(_) => {
                let accumulator = reader.accumulator();
                let next = reader.stepped(step, accumulator, item.value, call)?;
                Some(reader.graph.added_to(accumulator, next))
            }
        })?;
        let zero = self.graph.constant(0.0);
        let under = |addend| item.condition.map_or(addend, |condition| self.graph.select(condition, addend, zero));
        Some(addend.map(under))
    }

    /// A number of which nothing is known, another one each time.
    fn accumulator(&mut self) -> NodeId {
        let number = self.parameters.len();
        let parameter = self.parameter(quote!(accumulator #number), "accumulator", Default::default());
        self.graph.parameter(parameter)
    }
}

/// Whether a method makes a number of a sequence.
pub(super) fn is_total(call: &ExprMethodCall) -> bool {
    matches!(call.method.to_string().as_str(), "sum" | "product" | "fold")
}
