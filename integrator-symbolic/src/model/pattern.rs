//! Patterns: names for the parts of a value.

use super::{
    Reader,
    text::{place, referent},
    value::{Opaque, Value, View},
};
use crate::graph::index::Index;
use proc_macro2::{Literal, TokenStream};
use quote::quote;
use syn::{Pat, PatIdent, PatStruct, spanned::Spanned, visit::Visit};

impl Reader<'_> {
    /// Binds the names of a pattern to the parts of a value.
    pub(super) fn bind(&mut self, pattern: &Pat, value: Value) {
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
            Pat::Slice(parts) => self.bind_all(pattern, &parts.elems.iter().collect::<Vec<_>>(), value),
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
                        "this pattern is not understood: names, `_`, `&x`, arrays `[x, y]` and tuples `(x, y)` are",
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

    /// The elements of a value that has to have `count` of them.
    fn parts(&mut self, value: &Value, count: usize, pattern: &Pat) -> Option<Vec<Value>> {
        match value {
            Value::Array(parts) | Value::Tuple(parts) if parts.len() == count => Some(parts.clone()),
            Value::View(view) => {
                let shape = self.shape.clone()?;
                let extent = shape.extent(view.at.len())?;
                if extent.literal().is_some_and(|length| length != count as u64) {
                    let message = format!("the coordinates are `{}`: {count} names do not fit", shape.text());
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
                let message = format!("{} cannot be taken apart into {count} parts", other.describe());
                self.errors.at_span(pattern.span(), message);
                None
            }
        }
    }
}

/// A part of a struct, a tuple or a list, which is behind a reference where the whole is.
fn part(whole: &Opaque, at: &TokenStream) -> Value {
    let Opaque { text, loops } = whole;
    let place = place(text.clone());
    let part = Value::Opaque(Opaque { text: quote!(#place #at), loops: *loops });
    if referent(text).is_some() || place.to_string() == "self" { part.into_reference() } else { part }
}

/// The names that a pattern declares.
pub(super) struct Names(pub(super) Vec<String>);

impl Visit<'_> for Names {
    fn visit_pat_ident(&mut self, name: &PatIdent) {
        self.0.push(name.ident.to_string());
        syn::visit::visit_pat_ident(self, name);
    }
}
