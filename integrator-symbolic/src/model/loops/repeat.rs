//! Loops: the sequence of a `for` loop, and sums that remain sums.

use crate::graph::{
    Comparison, NodeId,
    index::{Index, IndexId, Loop, LoopId, LoopSet},
};
use crate::model::{
    Frame, Reader, Target,
    code::{
        assigned::Assigned,
        escape::{CONTINUE, continue_further_inside},
        flatten::nested_loop,
    },
    loops::{fill::indexed_loop, sequence::FEW},
    values::value::{Sequence, Value},
};
use proc_macro2::Ident;
use quote::{ToTokens, format_ident};
use std::{collections::HashMap, ops::Range};
use syn::{Expr, ExprForLoop, Pat, visit::Visit};

/// Names that the generated functions use themselves.
const RESERVED: [&str; 14] = [
    "motion",
    "step",
    "time",
    "duration",
    "of_lane",
    "lane",
    "table",
    "order",
    "tape",
    "parameters",
    "length",
    "stride",
    "q",
    "p",
];

/// What an iteration of a loop adds to variables.
type Sums = Vec<(Target, NodeId)>;

/// Reads the iteration of a loop for an index.
type Iteration<'t> = dyn Fn(&mut Reader<'_>, IndexId) -> Option<Value> + 't;

/// How many it may have in a term of a list, where it is written out in any case: those of the components of a point in space-time.
const COMPONENTS: u64 = 4;

impl Reader<'_> {
    /// `for pattern in sequence { ... }`
    pub(crate) fn repeat(&mut self, repeat: &ExprForLoop) -> Option<Value> {
        if let Some(found) = continue_further_inside(&repeat.body) {
            self.errors.at(found, CONTINUE);
            return None;
        }
        if let Some(rewritten) = nested_loop(repeat).or_else(|| indexed_loop(repeat)) {
            return self.repeat(&rewritten);
        }
        if let Some(loops) = self.gathered(repeat) {
            return loops.iter().try_fold(Value::Unit, |_, own| self.repeat(own));
        }
        self.items_are_indices = self.indexes(&repeat.pat, &repeat.body);
        let sequence = self.sequence_of(&repeat.expr, Some(&repeat.pat))?;
        if sequence.literal {
            let sequence = self.with_conditions(sequence);
            let iterations = self.few_iterations(&sequence, &repeat.expr)?;
            return self.write_out(repeat, &sequence, iterations);
        }
        if let Some(iterations) = self.few_in_term_of_list(&sequence) {
            let sequence = self.with_conditions(sequence);
            return self.write_out(repeat, &sequence, iterations);
        }
        if self.needs_writing_out(repeat) {
            if self.assigns_to_long_list(repeat)
                && let Some(value) = self.fill(repeat, &sequence)?
            {
                return Some(value);
            }
            let written = self.with_conditions(sequence.clone());
            if let Some(iterations) = self.known_iterations(&written) {
                return self.write_out(repeat, &written, iterations);
            }
            if let Some(value) = self.loop_by_powers(repeat, &sequence)? {
                return Some(value);
            }
            if let Some(value) = self.fill(repeat, &sequence)? {
                return Some(value);
            }
            if let Some(iterations) = self.iterations_by_constants(&written) {
                return self.write_out(repeat, &written, iterations);
            }
        }
        self.sums(repeat, &sequence, &|reader, index| reader.iteration(repeat, &sequence, index))
    }

    /// A loop that only adds to variables, as sums over what an iteration of it adds.
    pub(crate) fn sums(
        &mut self,
        repeat: &ExprForLoop,
        sequence: &Sequence,
        iteration: &Iteration<'_>,
    ) -> Option<Value> {
        if let Some((whole, end)) = self.graph.loops.end_without_lists(sequence.to) {
            let (by, sums) = self.summed(repeat, sequence.from, whole, iteration)?;
            let index = self.graph.loops.intern(Index::Running(by));
            let inside = self.graph.compare_index(Comparison::Less, index, end);
            let masked = sums
                .into_iter()
                .map(|(target, addend)| Some((target, self.graph.mask_coefficients(by, inside, addend)?)));
            if let Some(sums) = masked.collect::<Option<Vec<_>>>() {
                return self.add_sums(by, sums, &repeat.pat);
            }
        }
        let (by, sums) = self.summed(repeat, sequence.from, sequence.to, iteration)?;
        self.add_sums(by, sums, &repeat.pat)
    }

    /// What each iteration of a loop adds to variables, if it ends there.
    fn summed(
        &mut self,
        repeat: &ExprForLoop,
        from: IndexId,
        to: IndexId,
        iteration: &Iteration<'_>,
    ) -> Option<(LoopId, Sums)> {
        let by = self.enter(loop_name(&repeat.pat), from, to, &repeat.expr)?;
        let held = self.hold(&repeat.body);
        let index = self.graph.loops.intern(Index::Running(by));
        let body = iteration(self, index);
        let sums = self.leave();
        for (id, value) in held {
            self.bindings[id.0].value = value;
        }
        body.map(|_| (by, sums))
    }

    fn add_sums(&mut self, by: LoopId, sums: Sums, place: &Pat) -> Option<Value> {
        for (target, addend) in sums {
            let sum = self.graph.sum(by, addend);
            self.add_sum(target, sum, place)?;
        }
        Some(Value::Unit)
    }

    /// Adds a whole sum to its variable, or, where an outer loop sums that up too, to what an iteration of it adds.
    fn add_sum(&mut self, target: Target, sum: NodeId, place: &Pat) -> Option<()> {
        if self.bindings[target.id.0].depth < self.frames.len() {
            self.add_to_frame(target, sum);
            return Some(());
        }
        let now = self.element_of_mut(&target)?.clone();
        let now = match self.declared_literal(&target) {
            Some(literal) => self.number(&now, literal)?,
            None => self.number(&now, place)?,
        };
        let total = self.graph.add(now, sum);
        *self.element_of_mut(&target)? = Value::Real(total);
        Some(())
    }

    /// Whether a body does more than add to variables from outside: it replaces one, or reads an array by the index.
    fn needs_writing_out(&self, repeat: &ExprForLoop) -> bool {
        let mut assigned = Assigned::default();
        assigned.visit_block(&repeat.body);
        let is_outside = |name: &String| self.lookup(name).is_some();
        let is_array = |name: &String| {
            self.lookup(name).is_some_and(|id| match &self.bindings[id.0].value {
                // Of sums, arrays alone are indexed.
                Value::Array(_) | Value::Accumulating => true,
                // A list is read by any index, and assigned where its elements are known.
                Value::List(part) => part.literal || assigned.names.contains(name),
                _ => false,
            })
        };
        let is_read = |name: &String| is_outside(name) && assigned.read.contains(name);
        assigned.replaced.iter().any(is_outside)
            || assigned.indexed.iter().any(is_array)
            || assigned.names.iter().any(is_read)
    }

    /// Whether an iterator chain reads, by the index, an array of values that are not alike.
    pub(crate) fn indexes_values(&mut self, chain: &Expr) -> bool {
        let mut assigned = Assigned::default();
        assigned.visit_expr(chain);
        assigned.indexed.iter().any(|name| match self.lookup(name).map(|id| self.bindings[id.0].value.clone()) {
            Some(Value::Array(parts)) => {
                self.list_text(&parts).is_none() && self.as_list(&Value::Array(parts)).is_none()
            }
            _ => false,
        })
    }

    /// Whether a body assigns to a list, or to an array with more elements than a loop that is written out has
    /// iterations.
    fn assigns_to_long_list(&self, repeat: &ExprForLoop) -> bool {
        let mut assigned = Assigned::default();
        assigned.visit_block(&repeat.body);
        assigned.names.iter().any(|name| match self.lookup(name).map(|id| &self.bindings[id.0].value) {
            Some(Value::List(_)) => true,
            Some(Value::Array(parts)) => parts.len() as u64 > FEW,
            _ => false,
        })
    }

    /// The iterations of a loop, if their number is known and small.
    pub(crate) fn known_iterations(&self, sequence: &Sequence) -> Option<Range<u64>> {
        let (from, to) = (self.graph.loops.literal(sequence.from)?, self.graph.loops.literal(sequence.to)?);
        (to.saturating_sub(from) <= FEW).then_some(from..to)
    }

    /// The iterations of a loop over the components of points in a term of a list, `for &(a, b) in &self.bonds { for d in 0..3 {..} }`:
    /// several terms are computed in lanes where each is without loops.
    pub(crate) fn few_in_term_of_list(&self, sequence: &Sequence) -> Option<Range<u64>> {
        let loops = &self.graph.loops;
        let is_in_term = self.frames.iter().any(|frame| loops.mentions_lists(loops.get(frame.by).to));
        self.known_iterations(sequence)
            .filter(|range| is_in_term && range.end.saturating_sub(range.start) <= COMPONENTS)
    }

    /// The iterations of a loop over an array of values, which is written out; notes a mistake if they are too many.
    pub(crate) fn few_iterations(&mut self, sequence: &Sequence, place: &impl ToTokens) -> Option<Range<u64>> {
        let iterations = self.known_iterations(sequence);
        if iterations.is_none() {
            let message = format!(
                "a loop over an array of values supports at most {FEW} iterations\nnote: such a loop is unrolled"
            );
            self.errors.at(place, message);
        }
        iterations
    }

    /// The iterations of a loop one after the other.
    fn write_out(&mut self, repeat: &ExprForLoop, sequence: &Sequence, iterations: Range<u64>) -> Option<Value> {
        for iteration in iterations {
            let index = self.graph.loops.intern(Index::Literal(iteration));
            self.iteration(repeat, sequence, index)?;
        }
        Some(Value::Unit)
    }

    /// One iteration of a loop: its body with the pattern bound to the item for an index.
    fn iteration(&mut self, repeat: &ExprForLoop, sequence: &Sequence, index: IndexId) -> Option<Value> {
        self.scopes.push(HashMap::new());
        let body = self.item_of(sequence, index).and_then(|item| {
            self.bind(&repeat.pat, item.value);
            match item.condition {
                None => self.block(&repeat.body),
                // What a filter leaves out adds nothing.
                Some(condition) => self.guarded(condition, &repeat.body),
            }
        });
        self.scopes.pop();
        body
    }

    /// Opens a loop over `from..to`, with a name for its index that no loop around it has.
    pub(crate) fn enter(
        &mut self,
        name: Option<&Ident>,
        from: IndexId,
        to: IndexId,
        place: &impl ToTokens,
    ) -> Option<LoopId> {
        if self.graph.loops.count() >= LoopSet::CAPACITY {
            let message = format!("H has more than {} different loops", LoopSet::CAPACITY);
            self.errors.at(place, message);
            return None;
        }
        let [from, to] = [from, to].map(|bound| self.graph.loops.ending(bound));
        self.bound_lists(from);
        self.bound_lists(to);
        if self.graph.loops.upper(to).is_none() || self.graph.loops.lower(from).is_none() {
            let message = "the range of this loop is not known\nhelp: loop over the whole range, `for j in \
                           0..q.len()`, and wrap the added term in `if`\nnote: bounds may contain literals, integers \
                           of the system and non-negative indices of outer loops";
            self.errors.at(place, message);
            return None;
        }
        let parent = self.frames.last().map(|frame| frame.by);
        let by = self.graph.loops.range(Loop { parent, from, to });
        if !self.running.contains_key(&by) {
            // Loops beside each other are never nested in what is written, so they may share a name.
            let around: Vec<&Ident> = self.frames.iter().filter_map(|frame| self.running.get(&frame.by)).collect();
            let taken = |name: &Ident| RESERVED.iter().any(|word| name == word) || around.contains(&name);
            let base = match name {
                Some(name) if name != "_" => name.clone(),
                _ => format_ident!("k"),
            };
            let mut free = std::iter::once(base.clone()).chain((2..).map(|count| format_ident!("{base}_{count}")));
            let free = free.find(|name| !taken(name)).unwrap_or(base);
            self.running.insert(by, free);
        }
        self.frames.push(Frame { by, sums: Vec::new() });
        Some(by)
    }

    /// Closes the innermost loop and returns what an iteration of it adds.
    pub(crate) fn leave(&mut self) -> Sums {
        self.frames.pop().map(|frame| frame.sums).unwrap_or_default()
    }
}

/// The name of a loop's index: the pattern's own, or the first of a tuple's.
fn loop_name(pattern: &Pat) -> Option<&Ident> {
    match pattern {
        Pat::Ident(name) if name.subpat.is_none() => Some(&name.ident),
        Pat::Tuple(tuple) => tuple.elems.first().and_then(loop_name),
        _ => None,
    }
}
