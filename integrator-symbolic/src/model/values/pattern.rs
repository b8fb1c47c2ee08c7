//! Patterns: names for the components of a value.

use crate::graph::index::Index;
use crate::model::{
    Reader,
    code::assigned::Names,
    parameters::text::{place, referent},
    values::value::{Opaque, Sequence, Value, View},
};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, quote};
use syn::{Expr, Pat, PatParen, PatReference, PatStruct, spanned::Spanned, visit::Visit};

impl Reader<'_> {
    /// Binds the names of a pattern to the parts of a value.
    pub(crate) fn bind(&mut self, pattern: &Pat, value: Value) {
        match pattern {
            Pat::Ident(name) if name.subpat.is_none() => {
                let value = if name.by_ref.is_some() { value.into_reference() } else { value };
                self.declare(name.ident.to_string(), value);
                if let Some(binding) = self.bindings.last_mut() {
                    binding.mutable = name.mutability.is_some();
                }
            }
            Pat::Wild(_) => {}
            Pat::Type(typed) => {
                let value = self.of_type(value, &typed.ty);
                self.bind(&typed.pat, value);
            }
            Pat::Paren(inner) => self.bind(&inner.pat, value),
            Pat::Reference(inner) => self.bind(&inner.pat, value.into_place()),
            Pat::Struct(parts) if matches!(value, Value::Opaque(_)) => self.bind_fields(parts, &value),
            Pat::Slice(parts) => {
                let names: Vec<&Pat> = parts.elems.iter().collect();
                match names.iter().position(|name| rest_of(name).is_some()) {
                    Some(at) => self.bind_ends(pattern, &names, at, &value),
                    None => self.bind_all(pattern, &names, value),
                }
            }
            Pat::Tuple(parts) => self.bind_all(pattern, &parts.elems.iter().collect::<Vec<_>>(), value),
            other => {
                // The names exist all the same, so that one mistake gives one message.
                let mut names = Names(Vec::new());
                names.visit_pat(other);
                for name in names.0 {
                    self.declare(name, Value::Unknown);
                }
                if !matches!(value, Value::Unknown) {
                    self.errors.at(
                        other,
                        "this pattern is not supported\nnote: supported are names, `_`, `&x`, arrays `[x, y]` and \
                         tuples `(x, y)`",
                    );
                }
            }
        }
    }

    /// Binds the names of a struct's fields. Behind a reference they are references, as Rust has it.
    fn bind_fields(&mut self, parts: &PatStruct, value: &Value) {
        let Value::Opaque(opaque) = value else { return };
        for field in &parts.fields {
            let member = &field.member;
            let number = self.sensitive_field(&place(opaque.text.clone()), member);
            self.bind(&field.pat, number.unwrap_or_else(|| part(opaque, &quote!(.#member))));
        }
    }

    fn bind_all(&mut self, pattern: &Pat, names: &[&Pat], value: Value) {
        let Some(parts) = self.parts(&value, names.len(), pattern) else {
            // The names exist all the same, so that one mistake gives one message.
            for name in names {
                self.bind(name, Value::Unknown);
            }
            return;
        };
        for (name, part) in names.iter().zip(parts) {
            self.bind(name, part);
        }
    }

    /// `[x, y, ..]`, `[first, rest @ .., last]`: names for the first items, for the last ones, and for those between.
    fn bind_ends(&mut self, pattern: &Pat, names: &[&Pat], at: usize, value: &Value) {
        let (first, last) = (&names[..at], &names[at + 1..]);
        let Some((parts, between)) = self.ends(value, first.len(), last.len(), pattern) else {
            for name in first.iter().chain(last) {
                self.bind(name, Value::Unknown);
            }
            rest_of(names[at]).flatten().into_iter().for_each(|name| self.declare(name.to_string(), Value::Unknown));
            return;
        };
        for (name, part) in first.iter().chain(last).zip(parts) {
            self.bind(name, part);
        }
        rest_of(names[at]).flatten().into_iter().for_each(|name| self.declare(name.to_string(), between.clone()));
    }

    /// The first and the last items of a list, and the list of those between.
    fn ends(&mut self, value: &Value, first: usize, last: usize, pattern: &Pat) -> Option<(Vec<Value>, Value)> {
        match value {
            Value::Unknown => None,
            Value::Opaque(Opaque { text, loops }) => {
                let list = place(text.clone());
                let [from, back] = [first, last].map(Literal::usize_unsuffixed);
                let between = Opaque { text: quote!((&#list[#from..#list.len() - #back])), loops: *loops };
                let at =
                    |position: TokenStream| Value::Opaque(Opaque { text: quote!(#list[#position]), loops: *loops });
                let back = |distance: usize| {
                    let distance = Literal::usize_unsuffixed(distance);
                    quote!(#list.len() - #distance)
                };
                let from_front = (0..first).map(|position| at(Literal::usize_unsuffixed(position).to_token_stream()));
                let parts = from_front.chain((1..=last).rev().map(|distance| at(back(distance)))).collect();
                Some((parts, Value::Opaque(between)))
            }
            value => {
                let list = self.listed(value.clone(), pattern)?;
                if let Some(count) = self.count_of_literal(&list)
                    && count < (first + last) as u64
                {
                    let message = format!("{} names do not match {count} items", first + last);
                    self.errors.at(pattern, message);
                    return None;
                }
                let from = self.offset(list.from, first as u64);
                let back = self.literal_index(last as u64);
                let to = self.graph.loops.intern(Index::Sub(list.to, back));
                let from_front = (0..first as u64).map(|position| (list.from, position));
                let places: Vec<_> = from_front.chain((0..last as u64).map(|position| (to, position))).collect();
                let parts = places.into_iter().map(|(from, position)| {
                    let index = self.offset(from, position);
                    Some(self.item_of(&list, index)?.value)
                });
                let parts = parts.collect::<Option<_>>()?;
                Some((parts, Value::List(Sequence { from, to, ..list })))
            }
        }
    }

    /// Whether a pattern of this number of items fits a value with a known number of them, with its names bound if it
    /// does; nothing is said of other patterns and values.
    pub(crate) fn fits_length(&mut self, pattern: &Pat, value: &Expr) -> Option<Option<bool>> {
        let mut inner = pattern;
        while let Pat::Reference(PatReference { pat, .. }) | Pat::Paren(PatParen { pat, .. }) = inner {
            inner = pat;
        }
        let Pat::Slice(parts) = inner else { return Some(None) };
        let value = self.expression(value)?;
        let count = match &value {
            Value::Array(_) | Value::View(_) | Value::List(_) => {
                let list = self.listed(value.clone(), pattern)?;
                self.count_of_literal(&list)
            }
            _ => None,
        };
        let Some(count) = count else { return Some(None) };
        let names = parts.elems.len() as u64;
        let has_rest = parts.elems.iter().any(|name| rest_of(name).is_some());
        let fits = if has_rest { count + 1 >= names } else { count == names };
        if fits {
            self.bind(pattern, value);
        }
        Some(Some(fits))
    }

    /// The elements of a value that has to have `count` of them.
    fn parts(&mut self, value: &Value, count: usize, pattern: &Pat) -> Option<Vec<Value>> {
        match value {
            Value::Array(parts) | Value::Tuple(parts) if parts.len() == count => Some(parts.clone()),
            Value::View(view) => {
                let shape = self.shape.clone()?;
                let extent = shape.extent(view.at.len())?;
                if extent.literal().is_some_and(|length| length != count as u64) {
                    let message = format!("{count} names do not match the coordinates `{}`", shape.text());
                    self.errors.at(pattern, message);
                    return None;
                }
                let elements = (0..count as u64).map(|position| {
                    let index = self.graph.loops.intern(Index::Literal(position));
                    self.element(View { part: view.part, at: view.at.iter().copied().chain([index]).collect() })
                });
                Some(elements.collect())
            }
            Value::Opaque(opaque) => {
                let parts = (0..count).map(|position| {
                    let position = Literal::usize_unsuffixed(position);
                    let position = match pattern {
                        Pat::Slice(_) => quote!([#position]),
                        _ => quote!(.#position),
                    };
                    part(opaque, &position)
                });
                Some(parts.collect())
            }
            Value::List(list) if self.count_of_literal(list) == Some(count as u64) => (0..count as u64)
                .map(|position| {
                    let position = self.literal_index(position);
                    self.nth(list, position)
                })
                .collect(),
            Value::Unknown => None,
            other => {
                let message = format!("{} cannot be destructured into {count} parts", other.describe());
                let message = self.several_sensitive(other).unwrap_or(message);
                self.errors.at_span(pattern.span(), message);
                None
            }
        }
    }
}

/// The name of the items that `..` or `rest @ ..` leaves, if it has one; `None` of other patterns.
fn rest_of(pattern: &Pat) -> Option<Option<&Ident>> {
    match pattern {
        Pat::Rest(_) => Some(None),
        Pat::Ident(name) => {
            name.subpat.as_ref().filter(|(_, rest)| matches!(**rest, Pat::Rest(_))).map(|_| Some(&name.ident))
        }
        _ => None,
    }
}

/// A part of a struct, a tuple or a list, which is behind a reference where the whole is.
fn part(whole: &Opaque, at: &TokenStream) -> Value {
    let Opaque { text, loops } = whole;
    let place = place(text.clone());
    let part = Value::Opaque(Opaque { text: quote!(#place #at), loops: *loops });
    if referent(text).is_some() || place.to_string() == "self" { part.into_reference() } else { part }
}
