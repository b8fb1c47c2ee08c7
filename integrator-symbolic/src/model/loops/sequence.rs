//! The sequences of loops and iterator chains: ranges, coordinates and lists of parameters, with one item per index.

#[cfg(test)]
pub(crate) mod tests;

use crate::graph::{
    Comparison, NodeId,
    index::{Index, IndexId},
};
use crate::model::{
    Reader,
    code::assigned::Assigned,
    parameters::text::{self, referent},
    values::{
        range::keeps_items,
        value::{Item, Opaque, Sequence, Value, View},
    },
};
use quote::{ToTokens, quote};
use std::rc::Rc;
use syn::{Block, Expr, ExprCall, ExprIndex, ExprMethodCall, ExprRange, RangeLimits, parse_quote, visit::Visit};

impl Sequence {
    /// One item for every index in `from..to`.
    pub(crate) fn new(
        from: IndexId,
        to: IndexId,
        at: impl Fn(&mut Reader<'_>, IndexId) -> Option<Value> + 'static,
    ) -> Self {
        let at = Rc::new(move |reader: &mut Reader<'_>, index| at(reader, index).map(Item::plain));
        Self { from, to, at, filtered: false, literal: false }
    }

    /// The same sequence with something done to the value of every item.
    pub(crate) fn with(self, change: fn(Value) -> Value) -> Self {
        self.changed(move |_, value| change(value))
    }

    /// The same by means of the reader.
    pub(crate) fn changed(self, change: impl Fn(&mut Reader<'_>, Value) -> Value + 'static) -> Self {
        let Self { at, .. } = self;
        let at = move |reader: &mut Reader<'_>, index| {
            let Item { value, condition } = at(reader, index)?;
            Some(Item { value: change(reader, value), condition })
        };
        Self { at: Rc::new(at), ..self }
    }

    /// References to the items, which differ from the items themselves only in the code of parameters.
    pub(crate) fn of_references(self) -> Self {
        self.with(Value::into_reference)
    }
}

const EXPECTED: &str = "help: write `for i in a..b`, `for x in q.iter()` or `for &(a, b) in &self.bonds`";

/// `std::iter::zip(a, b)` as `a.into_iter().zip(b)`.
fn zipped(call: &ExprCall) -> Option<Expr> {
    let Expr::Path(function) = &*call.func else { return None };
    let mut names = function.path.segments.iter().rev();
    let is = names.next()?.ident == "zip" && names.next().is_none_or(|module| module.ident == "iter");
    let (true, [a, b]) = (is, &call.args.iter().collect::<Vec<_>>()[..]) else { return None };
    Some(parse_quote!((#a).into_iter().zip(#b)))
}

/// Whether an expression is an iterator and no list, so that its items have to be collected before they are counted.
fn is_iterator(expression: &Expr) -> bool {
    match expression {
        Expr::Paren(inner) => matches!(*inner.expr, Expr::Range(_)) || is_iterator(&inner.expr),
        Expr::MethodCall(call) => match call.method.to_string().as_str() {
            "iter" | "into_iter" | "windows" | "array_windows" | "chunks_exact" | "chunks" | "rchunks" | "values"
            | "keys" | "into_values" | "into_keys" | "chars" | "bytes" => true,
            "collect" | "unwrap" | "expect" => false,
            _ => is_iterator(&call.receiver),
        },
        _ => false,
    }
}

impl Reader<'_> {
    /// The sequence that an expression is; notes a mistake if it is none.
    pub(crate) fn sequence(&mut self, expression: &Expr) -> Option<Sequence> {
        let is_indexed = std::mem::take(&mut self.items_are_indices);
        if let Expr::Call(call) = expression
            && let Some(zipped) = zipped(call)
        {
            return self.sequence(&zipped);
        }
        if let Expr::Index(ExprIndex { expr, index, .. }) = expression
            && let Expr::Range(range) = &**index
            && let Some(part) = self.part_of_list(expr, range)
        {
            return part;
        }
        match expression {
            Expr::Paren(inner) => {
                self.items_are_indices = is_indexed;
                self.sequence(&inner.expr)
            }
            Expr::Reference(inner) => self.sequence(&inner.expr).map(Sequence::of_references),
            Expr::Range(range) => self.range(range, is_indexed),
            Expr::MethodCall(call)
                if is_adaptor(call) && !(call.method == "chunks" && self.verbatim(expression).is_some()) =>
            {
                self.items_are_indices = match call.args.first() {
                    Some(Expr::Closure(closure))
                        if closure.inputs.first().is_some_and(|item| self.indexes(item, &closure.body)) =>
                    {
                        true
                    }
                    _ => is_indexed && keeps_items(call),
                };
                self.adapted(call)
            }
            other => {
                let value = self.expression(other)?;
                self.listed(value, other)
            }
        }
    }

    /// `list[a..b]` of coordinates or of an array; `None` where the list is one of the system, which has text of its own.
    pub(crate) fn part_of_list(&mut self, list: &Expr, range: &ExprRange) -> Option<Option<Sequence>> {
        let value = match self.expression(list) {
            Some(Value::Opaque(_)) => return None,
            Some(value) => value,
            None => return Some(None),
        };
        Some(self.listed(value, list).and_then(|base| {
            let mut bound = |bound: &Option<Box<Expr>>| match bound {
                Some(bound) => self.bound(bound).map(Some),
                None => Some(None),
            };
            let (start, end) = (bound(&range.start)?, bound(&range.end)?);
            let closed = u64::from(matches!(range.limits, RangeLimits::Closed(_)));
            let to = end.map(|end| {
                let end = self.offset(end, closed);
                self.graph.loops.intern(Index::Add(base.from, end))
            });
            let from = start.map(|start| self.graph.loops.intern(Index::Add(base.from, start)));
            Some(Sequence { from: from.unwrap_or(base.from), to: to.unwrap_or(base.to), ..base })
        }))
    }

    pub(crate) fn literal_index(&mut self, value: u64) -> IndexId {
        self.graph.loops.intern(Index::Literal(value))
    }

    pub(crate) fn offset(&mut self, index: IndexId, by: u64) -> IndexId {
        let by = self.literal_index(by);
        self.graph.loops.intern(Index::Add(index, by))
    }

    /// The elements of coordinates, of an array, or of a list of parameters.
    pub(crate) fn listed(&mut self, value: Value, place: &impl ToTokens) -> Option<Sequence> {
        let zero = self.literal_index(0);
        if let Value::Array(parts) = &value
            && parts.len() as u64 > FEW
        {
            if let Some(list) = self.list_text(parts) {
                return self.listed(Value::Opaque(list), place);
            }
            if let Some(list) = self.as_list(&value) {
                return Some(list);
            }
        }
        match value {
            Value::View(view) => {
                let length = self.extent(view.at.len(), place)?;
                Some(Sequence::new(zero, length, move |reader, index| {
                    let at = view.at.iter().copied().chain([index]).collect();
                    Some(reader.element(View { part: view.part, at }))
                }))
            }
            Value::Array(parts) => {
                let length = self.literal_index(parts.len() as u64);
                let items = Sequence::new(zero, length, move |reader, index| {
                    let position = reader.graph.loops.literal(index)?;
                    parts.get(usize::try_from(position).ok()?).cloned()
                });
                Some(Sequence { literal: true, ..items })
            }
            Value::Opaque(Opaque { text, loops }) => {
                let behind_reference = referent(&text).is_some();
                let text = text::place(text);
                let text = match syn::parse2(text.clone()) {
                    Ok(expression) if is_iterator(&expression) => quote!((#text).collect::<Vec<_>>()),
                    _ => text,
                };
                let length = self.parameter(quote!(#text.len()), "integer", loops);
                let length = self.graph.loops.intern(Index::Parameter(length));
                self.graph.loops.declare_list_length(length);
                let items = Sequence::new(zero, length, move |reader, index| {
                    let (at, mentioned) = (reader.index_text(index), reader.graph.loops.of_index(index));
                    Some(Value::Opaque(Opaque { text: quote!(#text[#at]), loops: loops.union(mentioned) }))
                });
                Some(if behind_reference { items.of_references() } else { items })
            }
            Value::List(part) => Some(part),
            Value::Unknown => None,
            other => {
                self.errors.at(place, format!("a loop over {} is not supported\n{EXPECTED}", other.describe()));
                None
            }
        }
    }

    /// How many items the coordinates have at a level, as an integer.
    pub(crate) fn extent(&mut self, level: usize, place: &impl ToTokens) -> Option<IndexId> {
        let shape = self.shape.clone()?;
        match shape.extent(level) {
            Some(extent) => Some(self.length(extent)),
            None => {
                self.errors
                    .at(place, format!("a coordinate is an `f64`, and a loop over it is not supported\n{EXPECTED}"));
                None
            }
        }
    }

    /// How many items there are.
    pub(crate) fn count_of(&mut self, sequence: &Sequence) -> IndexId {
        self.graph.loops.span(sequence.from, sequence.to)
    }

    /// The same, if it is known here.
    pub(crate) fn count_of_literal(&mut self, sequence: &Sequence) -> Option<u64> {
        let count = self.count_of(sequence);
        self.graph.loops.literal(count)
    }

    /// The item at a position, counted from the first one.
    pub(crate) fn nth(&mut self, sequence: &Sequence, position: IndexId) -> Option<Value> {
        let index = self.graph.loops.intern(Index::Add(sequence.from, position));
        self.item_of(sequence, index).map(|item| item.value)
    }

    /// The item for an index.
    pub(crate) fn item_of(&mut self, sequence: &Sequence, index: IndexId) -> Option<Item> {
        let at = Rc::clone(&sequence.at);
        at(self, index)
    }

    /// A sequence that lists of the system may end, as one with conditions on its items that they do not end; any other
    /// as it is.
    pub(crate) fn with_conditions(&mut self, sequence: Sequence) -> Sequence {
        let Some((to, end)) = self.graph.loops.end_without_lists(sequence.to) else { return sequence };
        let at = Rc::clone(&sequence.at);
        let at = move |reader: &mut Reader<'_>, index| {
            let Item { value, condition } = at(reader, index)?;
            let inside = reader.graph.compare_index(Comparison::Less, index, end);
            let condition = condition.map_or(inside, |condition| reader.graph.and(inside, condition));
            Some(Item { value, condition: Some(condition) })
        };
        Sequence { to, at: Rc::new(at), ..sequence }
    }

    /// The body of a loop under the condition of a filter.
    pub(crate) fn guarded(&mut self, condition: NodeId, body: &Block) -> Option<Value> {
        let mut assigned = Assigned::default();
        assigned.visit_block(body);
        self.choose(Some(condition), assigned, &|reader| reader.block(body), &|_| Some(Value::Unit), body)
    }
}

/// Whether a method makes a sequence of a sequence.
pub(crate) fn is_adaptor(call: &ExprMethodCall) -> bool {
    const ADAPTORS: [&str; 13] = [
        "iter",
        "into_iter",
        "copied",
        "cloned",
        "map",
        "filter",
        "enumerate",
        "rev",
        "zip",
        "skip",
        "take",
        "step_by",
        "by_ref",
    ];
    let name = call.method.to_string();
    ADAPTORS.contains(&name.as_str())
        || matches!(name.as_str(), "windows" | "array_windows" | "chunks_exact" | "chunks" | "cycle")
}

/// The methods of sequences, for messages.
pub(crate) const ADAPTED: &str =
    "iter, map, filter, enumerate, zip, rev, skip, take, step_by, windows, array_windows and chunks_exact";

/// How many iterations a loop may have that is written out, because its body is more than a sum.
pub(crate) const FEW: u64 = 16;
