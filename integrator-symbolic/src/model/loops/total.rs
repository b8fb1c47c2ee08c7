//! Reductions of a whole sequence: `sum`, `product` and `fold`.

#[cfg(test)]
mod tests;

use crate::graph::{
    Comparison, NodeId,
    index::{Index, IndexId, LoopId},
};
use crate::model::{
    BindingId, Reader,
    code::{assigned::Assigned, flatten::nested_sum},
    loops::sequence::FEW,
    values::value::{Sequence, Value},
};
use proc_macro2::Ident;
use quote::{format_ident, quote};
use std::{ops::Range, rc::Rc};
use syn::{Expr, ExprClosure, ExprForLoop, ExprMethodCall, parse_quote, visit::Visit};

/// What is done with every item.
pub(crate) enum Step {
    /// It is added.
    Add,
    /// It is a factor.
    Multiply,
    /// `|accumulator, item| ...`
    Fold(Rc<ExprClosure>),
}

impl Reader<'_> {
    /// `sequence.sum()`, `sequence.product()` and `sequence.fold(start, |accumulator, item| ...)`: a sum where all that
    /// is done is to add, powers where it is Horner's rule, else written out item by item.
    pub(crate) fn total(&mut self, call: &ExprMethodCall) -> Option<Value> {
        if let Some(nested) = nested_sum(call) {
            return self.expression(&nested);
        }
        let item = match call.args.last() {
            Some(Expr::Closure(step)) => step.inputs.last(),
            _ => None,
        };
        let sequence = self.sequence_of(&call.receiver, item)?;
        let (start, step) = self.step(call)?;
        let written_out = self.few_in_term_of_list(&sequence).is_some()
            || self.known_iterations(&sequence).is_some() && self.indexes_values(&call.receiver);
        if !sequence.literal
            && !written_out
            && let Some(sums) = self.as_sums(&sequence, &start, &step, call)?
        {
            let totals: Vec<NodeId> =
                start.numbers.iter().zip(sums).map(|(start, sum)| self.graph.add(*start, sum)).collect();
            return Some(start.with(&totals));
        }
        let sequence = self.with_conditions(sequence);
        let iterations = if sequence.literal {
            Some(self.few_iterations(&sequence, call)?)
        } else {
            self.known_iterations(&sequence)
        };
        if let Some(iterations) = iterations {
            return self.item_by_item(&sequence, iterations, &start, &step, call);
        }
        if let Some(total) = self.by_powers(&sequence, &start, &step, call)? {
            return Some(total);
        }
        if let Some(iterations) = self.iterations_by_constants(&sequence) {
            return self.item_by_item(&sequence, iterations, &start, &step, call);
        }
        if let Some(total) = self.by_joining(&sequence, &start, &step, call)? {
            return Some(total);
        }
        let name = &call.method;
        let message = format!(
            "this `{name}` is not supported over more than {FEW} items, or over a number that is not known \
             here\nhelp: use literal bounds, as in `(0..4).rev().fold(0.0, |sum, k| sum * x + self.c[k])`, or write a \
             sum\nnote: sums, products, maxima, minima and polynomials `sum * x + c` with one `x` are supported over \
             any number of items{}",
            self.unseen(sequence.to)
        );
        self.errors.at(name, message);
        None
    }

    /// A loop that does to variables what Horner's rule does, `v = v * x + c`, or joins an item to each of them, as a fold over
    /// its items; outside, whether it was read.
    pub(crate) fn loop_by_powers(&mut self, repeat: &ExprForLoop, sequence: &Sequence) -> Option<Option<Value>> {
        let mut assigned = Assigned::default();
        assigned.visit_block(&repeat.body);
        let mut names: Vec<String> = assigned.names.into_iter().filter(|name| self.lookup(name).is_some()).collect();
        names.sort();
        names.dedup();
        let ids: Vec<BindingId> = names.iter().filter_map(|name| self.lookup(name)).collect();
        let values: Vec<Value> = ids.iter().map(|id| self.bindings[id.0].value.clone()).collect();
        let here = |id: &BindingId| self.bindings[id.0].depth == self.frames.len();
        if !ids.iter().all(here)
            || !values.iter().all(|value| matches!(value, Value::Real(_) | Value::Joint(_) | Value::Opaque(_)))
        {
            return Some(None);
        }
        let variables: Vec<Ident> = names.iter().map(|name| format_ident!("{name}")).collect();
        let ExprForLoop { pat: pattern, expr: items, body, .. } = repeat;
        let call: ExprMethodCall = parse_quote!(
            (#items).fold((#(#variables,)*), |(#(mut #variables,)*), #pattern| { #body (#(#variables,)*) })
        );
        let (start, step) = self.step(&call)?;
        let total = match self.by_powers(sequence, &start, &step, &call)? {
            None => self.by_joining(sequence, &start, &step, &call)?,
            total => total,
        };
        let Some(Value::Tuple(totals)) = total else { return Some(None) };
        for (id, total) in ids.into_iter().zip(totals) {
            self.bindings[id.0].value = total;
        }
        Some(Some(Value::Unit))
    }

    /// What the accumulator begins with, and what is done with every item.
    fn step(&mut self, call: &ExprMethodCall) -> Option<(Accumulator, Step)> {
        match (call.method.to_string().as_str(), call.args.len()) {
            ("fold", 2) => {
                let shape = self.expression(&call.args[0])?;
                let mut numbers = Vec::new();
                self.flat(&shape, &call.args[0], &mut numbers)?;
                Some((Accumulator { shape, numbers }, Step::Fold(self.closure(&call.args[1], 2)?)))
            }
            ("product", _) => Some((self.beginning(1.0), Step::Multiply)),
            _ => Some((self.beginning(0.0), Step::Add)),
        }
    }

    fn beginning(&mut self, number: f64) -> Accumulator {
        let number = self.graph.constant(number);
        Accumulator { shape: Value::Real(number), numbers: vec![number] }
    }

    /// The numbers of a value, which may be a tuple or an array of some.
    fn flat(&mut self, value: &Value, place: &Expr, numbers: &mut Vec<NodeId>) -> Option<()> {
        match value {
            Value::Tuple(parts) | Value::Array(parts) => {
                parts.iter().try_for_each(|part| self.flat(part, place, numbers))
            }
            value => {
                numbers.push(self.number(value, place)?);
                Some(())
            }
        }
    }

    /// The numbers of the accumulator after an item.
    pub(crate) fn stepped(
        &mut self,
        step: &Step,
        before: &Accumulator,
        item: Value,
        call: &ExprMethodCall,
    ) -> Option<Vec<NodeId>> {
        match step {
            Step::Add => {
                let item = self.number(&item, &call.receiver)?;
                Some(before.numbers.iter().map(|sum| self.graph.add(*sum, item)).collect())
            }
            Step::Multiply => {
                let item = self.number(&item, &call.receiver)?;
                if before.numbers.iter().any(|product| self.mixes(*product, item)) {
                    self.not_separable(&Expr::MethodCall(call.clone()));
                    return None;
                }
                Some(before.numbers.iter().map(|product| self.graph.mul(*product, item)).collect())
            }
            Step::Fold(closure) => {
                let value = self.applied(closure, vec![before.with(&before.numbers), item])?;
                let mut numbers = Vec::new();
                self.flat(&value, &closure.body, &mut numbers)?;
                if numbers.len() != before.numbers.len() {
                    self.errors.at(&closure.body, "this closure has to return as many numbers as the fold begins with");
                    return None;
                }
                Some(numbers)
            }
        }
    }

    /// All items one after the other.
    fn item_by_item(
        &mut self,
        sequence: &Sequence,
        iterations: Range<u64>,
        start: &Accumulator,
        step: &Step,
        call: &ExprMethodCall,
    ) -> Option<Value> {
        let mut before = start.clone();
        for iteration in iterations {
            let index = self.literal_index(iteration);
            let item = self.item_of(sequence, index)?;
            let next = self.stepped(step, &before, item.value, call)?;
            let joined = next.into_iter().zip(&before.numbers).map(|(next, before)| {
                item.condition.map_or(next, |condition| self.graph.select(condition, next, *before))
            });
            before.numbers = joined.collect();
        }
        Some(before.with(&before.numbers))
    }

    /// The sums that a sequence adds, if adding is all that is done with its items; outside, whether it was read.
    fn as_sums(
        &mut self,
        sequence: &Sequence,
        start: &Accumulator,
        step: &Step,
        call: &ExprMethodCall,
    ) -> Option<Option<Vec<NodeId>>> {
        if let Step::Multiply = step {
            return Some(None);
        }
        if let Some((whole, end)) = self.graph.loops.end_without_lists(sequence.to) {
            // As one that lists do not end, with coefficients that are zero after their ends.
            let by = self.enter(None, sequence.from, whole, call)?;
            let index = self.graph.loops.intern(Index::Running(by));
            let addends = self.addends_of(sequence, index, start, step, call);
            self.leave();
            let Some(addends) = addends? else { return Some(None) };
            let inside = self.graph.compare_index(Comparison::Less, index, end);
            let addends = addends.into_iter().map(|addend| self.graph.mask_coefficients(by, inside, addend));
            if let Some(addends) = addends.collect::<Option<Vec<NodeId>>>() {
                return Some(Some(addends.into_iter().map(|addend| self.graph.sum(by, addend)).collect()));
            }
        }
        let by = self.enter(None, sequence.from, sequence.to, call)?;
        let index = self.graph.loops.intern(Index::Running(by));
        let addends = self.addends_of(sequence, index, start, step, call);
        self.leave();
        Some(addends?.map(|addends| addends.into_iter().map(|addend| self.graph.sum(by, addend)).collect()))
    }

    /// What the item for an index adds, if adding is all that is done with it.
    fn addends_of(
        &mut self,
        sequence: &Sequence,
        index: IndexId,
        start: &Accumulator,
        step: &Step,
        call: &ExprMethodCall,
    ) -> Option<Option<Vec<NodeId>>> {
        let item = self.item_of(sequence, index)?;
        let addends = self.under(item.condition, true, |reader| match step {
            Step::Add => Some(Some(vec![reader.number(&item.value, &call.receiver)?])),
            Step::Multiply => Some(None),
            Step::Fold(_) => {
                let before = reader.unknown(start);
                let next = reader.stepped(step, &before, item.value, call)?;
                let pairs = before.numbers.iter().zip(next);
                let addends = pairs.map(|(before, next)| reader.graph.added_to(*before, next));
                let addends = addends.collect::<Option<Vec<NodeId>>>();
                let alone = |addend: &NodeId| !reader.graph.mentions(*addend, &before.numbers);
                Some(addends.filter(|addends| addends.iter().all(alone)))
            }
        })?;
        let zero = self.graph.constant(0.0);
        let under = |addend| item.condition.map_or(addend, |condition| self.graph.select(condition, addend, zero));
        Some(addends.map(|addends| addends.into_iter().map(under).collect()))
    }

    /// Horner's rule over any number of items, `sum * x + c`, as the sum over `c xᵏ`, with k counted from the last
    /// item; outside, whether it was read.
    fn by_powers(
        &mut self,
        sequence: &Sequence,
        start: &Accumulator,
        step: &Step,
        call: &ExprMethodCall,
    ) -> Option<Option<Value>> {
        let (zero, count) = (self.literal_index(0), self.count_of(sequence));
        let by = self.enter(None, zero, count, call)?;
        let terms = self.terms_of(sequence, by, start, step, call);
        self.leave();
        let Some(terms) = terms? else { return Some(None) };
        let index = self.graph.loops.intern(Index::Running(by));
        let mut totals = Vec::new();
        for ((factor, addend), start) in terms.into_iter().zip(&start.numbers) {
            let [power, whole] = [index, count].map(|exponent| self.index_power(factor, exponent));
            let term = self.graph.mul(addend, power);
            let sum = self.graph.sum(by, term);
            // Zero, with which a polynomial begins, is no term.
            totals.push(match self.graph.as_constant(*start) {
                Some(0.0) => sum,
                _ => {
                    let first = self.graph.mul(*start, whole);
                    self.graph.add(first, sum)
                }
            });
        }
        Some(Some(start.with(&totals)))
    }

    /// The factors and addends of Horner's rule, where a loop counts from the last item, if a step is that.
    fn terms_of(
        &mut self,
        sequence: &Sequence,
        by: LoopId,
        start: &Accumulator,
        step: &Step,
        call: &ExprMethodCall,
    ) -> Option<Option<Vec<(NodeId, NodeId)>>> {
        let (index, one) = (self.graph.loops.intern(Index::Running(by)), self.literal_index(1));
        let last = self.graph.loops.intern(Index::Sub(sequence.to, one));
        let from_last = self.graph.loops.intern(Index::Sub(last, index));
        let item = self.item_of(sequence, from_last)?;
        if item.condition.is_some() {
            return Some(None);
        }
        let before = self.unknown(start);
        let next = self.stepped(step, &before, item.value, call)?;
        let graph = &mut self.graph;
        let terms = before.numbers.iter().zip(next).map(|(before, next)| graph.linear_in(*before, next));
        let Some(terms) = terms.collect::<Option<Vec<_>>>() else { return Some(None) };
        let fits = |(factor, addend): &(NodeId, NodeId)| {
            let alone = [factor, addend].into_iter().all(|number| !graph.mentions(*number, &before.numbers));
            alone && !graph.loops_of(*factor).contains(by)
        };
        Some(terms.iter().all(fits).then_some(terms))
    }

    /// A number to the power of an integer.
    fn index_power(&mut self, x: NodeId, exponent: IndexId) -> NodeId {
        if self.graph.as_constant(x) == Some(1.0) {
            return x;
        }
        let exponent = self.graph.number_of(exponent);
        self.graph.call_two("powf", x, exponent)
    }

    /// An accumulator of numbers of which nothing is known, other ones each time.
    pub(crate) fn unknown(&mut self, like: &Accumulator) -> Accumulator {
        let numbers = like.numbers.iter().map(|_| {
            let number = self.parameters.len();
            let parameter = self.parameter(quote!(accumulator #number), "accumulator", Default::default());
            self.graph.parameter(parameter)
        });
        Accumulator { numbers: numbers.collect(), shape: like.shape.clone() }
    }
}

/// What a fold carries from item to item: a number, or a tuple or an array of some.
#[derive(Clone)]
pub(crate) struct Accumulator {
    /// A value with this many numbers in these places.
    shape: Value,
    pub(crate) numbers: Vec<NodeId>,
}

impl Accumulator {
    /// The value with other numbers.
    pub(crate) fn with(&self, numbers: &[NodeId]) -> Value {
        filled(&self.shape, &mut numbers.iter().copied())
    }
}

/// A value of the same shape, made of other numbers.
fn filled(shape: &Value, numbers: &mut impl Iterator<Item = NodeId>) -> Value {
    match shape {
        Value::Tuple(parts) => Value::Tuple(parts.iter().map(|part| filled(part, numbers)).collect()),
        Value::Array(parts) => Value::Array(parts.iter().map(|part| filled(part, numbers)).collect()),
        _ => numbers.next().map_or(Value::Unknown, Value::Real),
    }
}

/// Whether a method makes a number of a sequence.
pub(crate) fn is_total(call: &ExprMethodCall) -> bool {
    matches!(call.method.to_string().as_str(), "sum" | "product" | "fold")
}
