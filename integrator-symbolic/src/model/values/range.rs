//! Ranges of integers of any type: bounds from the system are converted at the beginning of a loop, and the items have
//! the type of the bounds.

use crate::graph::index::{Index, IndexId, IntegerType, LoopSet};
use crate::model::{
    Reader,
    code::index_method::is_index,
    values::{
        integer::Own,
        value::{Opaque, Sequence, Value},
    },
};
use crate::syntax::Input;
use proc_macro2::TokenStream;
use quote::{ToTokens, format_ident, quote};
use syn::{
    Expr, ExprIndex, ExprLit, ExprMethodCall, ExprRange, Lit, Pat, RangeLimits,
    visit::{Visit, visit_expr_index, visit_expr_method_call},
};

impl Reader<'_> {
    /// Whether a body reads lists by the name of a pattern, or by what is added to it: then its type is `usize`.
    pub(crate) fn indexes(&self, pattern: &Pat, body: &impl ToTokens) -> bool {
        let name = match pattern {
            Pat::Ident(name) if name.subpat.is_none() => &name.ident,
            Pat::Reference(inner) => return self.indexes(&inner.pat, body),
            Pat::Paren(inner) => return self.indexes(&inner.pat, body),
            _ => return false,
        };
        let mut search = Search { name: name.to_string(), found: false, input: self.input };
        match syn::parse2::<Expr>(body.to_token_stream()) {
            Ok(body) => search.visit_expr(&body),
            Err(_) => return false,
        }
        search.found
    }

    /// The integers of a range; `is_indexed` where they are known to be indices, whose type is `usize`.
    pub(crate) fn range(&mut self, range: &ExprRange, is_indexed: bool) -> Option<Sequence> {
        let (Some(start), Some(end)) = (&range.start, &range.end) else {
            self.errors.at(range, "the range of a loop requires both bounds\nhelp: write `a..b` or `a..=b`");
            return None;
        };
        let (first, last) = (self.bound_value(start), self.bound_value(end));
        let (first, last) = (first?, last?);
        let is_closed = matches!(range.limits, RangeLimits::Closed(_));
        let kind = if is_indexed { None } else { self.type_of_bounds([(&first, start), (&last, end)]) };
        let Some(kind) = kind else {
            let (from, to) = (self.integer(&first)?, self.integer(&last)?);
            let to = if is_closed { self.offset(to, 1) } else { to };
            return Some(self.integers(from, to));
        };
        let items = match [&first, &last].map(|bound| self.exact(bound)) {
            [Some(from), Some(to)] => {
                let to = if is_closed { self.offset(to, 1) } else { to };
                self.integers(from, to)
            }
            [Some(from), None] if !self.graph.loops.is_signed(from) => {
                let (last, function) = (self.opaque(&last)?, if is_closed { "bound_through" } else { "bound" });
                let text = &last.text;
                let shown = if is_closed { quote!(#text + 1) } else { text.clone() };
                let to = self.converted(function, &[&last], shown);
                self.integers(from, to)
            }
            [from, _] => {
                let function = if is_closed { "span_through" } else { "span" };
                let (own, last) = (self.opaque(&first)?, self.opaque(&last)?);
                let (a, b, one) = (&own.text, &last.text, is_closed.then(|| quote!(+ 1)));
                let count = self.converted(function, &[&own, &last], quote!(#b - #a #one));
                let from = match from {
                    Some(from) => from,
                    None => {
                        let from = self.converted("wrapped", &[&own], own.text.clone());
                        self.graph.loops.signed(from)
                    }
                };
                self.counted(from, count)
            }
        };
        Some(items.of_type(kind))
    }

    /// A bound as a value that may be an integer.
    fn bound_value(&mut self, bound: &Expr) -> Option<Value> {
        let value = self.expression(bound)?.into_own();
        if matches!(value, Value::Integer(_) | Value::Opaque(_)) {
            return Some(value.into_place());
        }
        let message = format!(
            "the bounds of a loop have to be integers, and this one is {}\nhelp: loop over \
                               integers, and write `i as f64` for the number",
            value.describe()
        );
        self.errors.at(bound, message);
        None
    }

    /// A bound of a range of indices.
    pub(crate) fn bound(&mut self, bound: &Expr) -> Option<IndexId> {
        let value = self.bound_value(bound)?;
        self.integer(&value)
    }

    /// The type of a range, where it may be another than `usize`.
    fn type_of_bounds(&mut self, bounds: [(&Value, &Expr); 2]) -> Option<IntegerType> {
        let mut own = None;
        for (bound, place) in bounds {
            match self.type_of(bound) {
                Own::Usize => return None,
                Own::Named(kind) => return Some(kind),
                Own::Unknown => own = own.or_else(|| self.type_like(bound)),
                Own::Untyped => own = own.or_else(|| suffix(place)),
            }
        }
        own
    }

    /// The integer that a bound is, whatever its type.
    fn exact(&self, bound: &Value) -> Option<IndexId> {
        match bound {
            Value::Integer(index) if !self.own_integers.contains_key(index) => Some(*index),
            _ => None,
        }
    }

    /// An integer without a sign that a function of the runtime makes of bounds.
    fn converted(&mut self, function: &str, bounds: &[&Opaque], shown: TokenStream) -> IndexId {
        let (root, function) = (&self.input.root, format_ident!("{function}"));
        let texts = bounds.iter().map(|bound| &bound.text);
        let text = quote!(#root::__private::#function(#(#texts),*));
        let loops = bounds.iter().fold(LoopSet::EMPTY, |loops, bound| loops.union(bound.loops));
        let parameter = self.parameter_shown(text, shown, "integer", loops);
        self.graph.loops.intern(Index::Parameter(parameter))
    }

    /// A number of consecutive integers; the first one may be negative.
    fn counted(&mut self, from: IndexId, count: IndexId) -> Sequence {
        let zero = self.literal_index(0);
        Sequence::new(zero, count, move |reader, index| {
            Some(Value::Integer(reader.graph.loops.intern(Index::Add(from, index))))
        })
    }

    /// The integers in `from..to`; those that may begin below zero are counted from the first one.
    pub(crate) fn integers(&mut self, from: IndexId, to: IndexId) -> Sequence {
        let loops = &mut self.graph.loops;
        let count = loops.span(from, to);
        if loops.is_signed(from) {
            return self.counted(from, count);
        }
        let [from, to] = [from, to].map(|bound| loops.ending(bound));
        Sequence::new(from, to, |_, index| Some(Value::Integer(index)))
    }
}

impl Sequence {
    /// The same integers in a type of their own.
    fn of_type(self, kind: IntegerType) -> Self {
        self.changed(move |reader, value| match value {
            Value::Integer(index) if reader.graph.loops.cast_type(index).is_none_or(|known| known != kind) => {
                Value::Integer(reader.graph.loops.intern(Index::Typed(kind, index)))
            }
            other => other,
        })
    }
}

/// The type that a literal names.
fn suffix(bound: &Expr) -> Option<IntegerType> {
    match bound {
        Expr::Lit(ExprLit { lit: Lit::Int(number), .. }) => {
            IntegerType::named(number.suffix()).filter(|kind| !kind.is_usize())
        }
        _ => None,
    }
}

/// Whether an adaptor hands on the items of a range as they are.
pub(crate) fn keeps_items(call: &ExprMethodCall) -> bool {
    const KEEPS: [&str; 8] = ["by_ref", "cloned", "copied", "filter", "into_iter", "rev", "skip", "step_by"];
    KEEPS.iter().any(|name| call.method == name) || call.method == "take"
}

struct Search<'i> {
    name: String,
    found: bool,
    input: &'i Input,
}

impl Search<'_> {
    /// Whether an index is made of the name by arithmetic alone.
    fn is_made_of_it(&self, index: &Expr) -> bool {
        match index {
            Expr::Paren(inner) => self.is_made_of_it(&inner.expr),
            Expr::Binary(both) => self.is_made_of_it(&both.left) || self.is_made_of_it(&both.right),
            Expr::Path(path) => path.path.get_ident().is_some_and(|name| *name == self.name),
            _ => false,
        }
    }
}

impl Visit<'_> for Search<'_> {
    /// The arguments of a method that computes an index are `usize`.
    fn visit_expr_method_call(&mut self, call: &ExprMethodCall) {
        let is_self = matches!(&*call.receiver, Expr::Path(path) if path.path.is_ident("self"));
        let helper = self.input.function(&call.method.to_string()).filter(|_| is_self);
        self.found |= helper.is_some_and(is_index) && call.args.iter().any(|argument| self.is_made_of_it(argument));
        visit_expr_method_call(self, call);
    }
    fn visit_expr_index(&mut self, index: &ExprIndex) {
        self.found |= self.is_made_of_it(&index.index);
        visit_expr_index(self, index);
    }
}
