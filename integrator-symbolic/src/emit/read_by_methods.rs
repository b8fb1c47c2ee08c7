//! The fields that opaque methods read: hand-written flows, and methods with user-supplied derivatives.
//!
//! In: the impl, and the names of these methods. Out: every field in their source and in that of the methods of the
//! impl that they call. Always true: an overlooked field would let a checkpoint resume with another value of it. If a
//! method cannot be analysed, it hence counts as reading the whole system.

use crate::syntax::names::Names;
use crate::{model::Model, syntax::Input};
use proc_macro2::{Delimiter, Group, Ident, TokenStream, TokenTree};
use quote::{ToTokens, quote};
use std::collections::{BTreeMap, BTreeSet};
use syn::{FnArg, ImplItemFn, ReturnType};

/// The name of the method by which a system is compared where the macro cannot compare its fields.
const FINGERPRINT: &str = "fingerprint";

/// What these methods are and read.
pub(super) struct ReadByMethods {
    /// Their signatures and bodies, one after the other.
    pub(super) text: TokenStream,
    /// The type of what is kept of the values that they read.
    pub(super) kind: TokenStream,
    /// The expression that makes it of a system.
    pub(super) value: TokenStream,
}

impl ReadByMethods {
    /// That of the methods that generated code calls, if it calls any.
    pub(super) fn of(input: &Input, model: &Model, names: &Names) -> Option<Self> {
        let own = model.parts.iter().filter_map(|part| part.own.as_ref());
        let called: Vec<&Ident> = model.externals.iter().map(|method| &method.name).chain(own).collect();
        if called.is_empty() {
            return None;
        }
        let (reached, fields) = followed(input, &called);
        let runtime = &names.runtime;
        let value = match input.function(FINGERPRINT).filter(|method| gives_fingerprint(method)) {
            Some(method) => {
                let name = &method.sig.ident;
                quote!(#runtime::ReadByMethods::of_fingerprint(self.#name()))
            }
            None => {
                let reads = fields
                    .iter()
                    .map(|(name, place)| quote!((&&&#runtime::Field(&#place)).read_into(#name, &mut read);));
                quote!({
                    use #runtime::{Compared as _, Hashed as _, Unknown as _};
                    let mut read = #runtime::ReadByMethods::default();
                    #(#reads)*
                    read
                })
            }
        };
        Some(Self { text: reached.into_iter().map(text).collect(), kind: quote!(#runtime::ReadByMethods), value })
    }
}

/// Whether a method is `fn fingerprint(&self) -> u64`.
fn gives_fingerprint(method: &ImplItemFn) -> bool {
    let signature = &method.sig;
    let is_number =
        matches!(&signature.output, ReturnType::Type(_, kind) if kind.to_token_stream().to_string() == "u64");
    is_number && signature.inputs.len() == 1 && matches!(signature.inputs.first(), Some(FnArg::Receiver(_)))
}

fn text(method: &ImplItemFn) -> TokenStream {
    let (signature, body) = (&method.sig, &method.block);
    quote!(#signature #body)
}

/// The methods of the impl that are reached from some of them, in the order of the impl, and the fields that their bodies read:
/// each as it is written and as tokens.
fn followed<'i>(input: &'i Input, from: &[&Ident]) -> (Vec<&'i ImplItemFn>, BTreeMap<String, TokenStream>) {
    let mut reached: BTreeSet<String> = BTreeSet::new();
    let mut next: Vec<String> = from.iter().map(ToString::to_string).collect();
    let mut reading = Reading { input, fields: BTreeMap::new(), calls: Vec::new() };
    while let Some(name) = next.pop() {
        let Some(method) = input.function(&name) else { continue };
        if reached.insert(name) {
            reading.tokens(method.block.to_token_stream());
            next.append(&mut reading.calls);
        }
    }
    let reached = input.functions().filter(|method| reached.contains(&method.sig.ident.to_string()));
    (reached.collect(), reading.fields)
}

/// The reading of a body, token by token: what macros of the user hold is read like everything else.
struct Reading<'i> {
    input: &'i Input,
    fields: BTreeMap<String, TokenStream>,
    /// Methods of the impl that are called.
    calls: Vec<String>,
}

impl Reading<'_> {
    fn tokens(&mut self, tokens: TokenStream) {
        let trees: Vec<TokenTree> = tokens.into_iter().collect();
        let mut at = 0;
        while let Some(tree) = trees.get(at) {
            match tree {
                TokenTree::Ident(word) if word == "self" => {
                    at += self.of_self(&trees, at);
                    continue;
                }
                TokenTree::Ident(name) if at > 0 && is_mark(&trees[at - 1], ':') => self.call(name),
                TokenTree::Group(group) if !self.is_handed_on(&trees[..at], group) => self.tokens(group.stream()),
                TokenTree::Group(group) => self.tokens(behind_self(group)),
                _ => {}
            }
            at += 1;
        }
    }

    /// What `self` at a place is read for; returns how many tokens that takes.
    fn of_self(&mut self, trees: &[TokenTree], at: usize) -> usize {
        let mut path: Vec<&TokenTree> = Vec::new();
        let mut end = at + 1;
        while let [dot, name @ (TokenTree::Ident(_) | TokenTree::Literal(_)), ..] = &trees[end..]
            && is_mark(dot, '.')
        {
            if is_call(&trees[end + 2..]) {
                match name {
                    TokenTree::Ident(method) if path.is_empty() && self.is_own(method) => {
                        self.call(method);
                        return end + 2 - at;
                    }
                    _ => break,
                }
            }
            path.push(name);
            end += 2;
        }
        match destructured(&trees[..at]) {
            Some(fields) if path.is_empty() => fields.iter().for_each(|field| self.field(&[field])),
            _ => self.field(&path),
        }
        end - at
    }

    /// Notes a field by its path, or all of the system.
    fn field(&mut self, path: &[&TokenTree]) {
        let name = path.iter().fold("self".to_owned(), |name, field| format!("{name}.{field}"));
        self.fields.entry(name).or_insert_with(|| match path {
            [] => quote!(*self),
            path => quote!(self #(.#path)*),
        });
    }

    fn is_own(&self, method: &Ident) -> bool {
        self.input.function(&method.to_string()).is_some()
    }

    fn call(&mut self, method: &Ident) {
        if self.is_own(method) {
            self.calls.push(method.to_string());
        }
    }

    /// Whether a group is the arguments of `Self::method(self, ...)` for a method of the impl, which is read itself.
    fn is_handed_on(&self, before: &[TokenTree], group: &Group) -> bool {
        let [.., mark, TokenTree::Ident(method)] = before else { return false };
        let is_path = is_mark(mark, ':') && self.is_own(method) && group.delimiter() == Delimiter::Parenthesis;
        is_path && first_is_self(group)
    }
}

/// Whether the first argument is `self` or `&self`, and nothing of it.
fn first_is_self(group: &Group) -> bool {
    let trees: Vec<TokenTree> = group.stream().into_iter().take(3).collect();
    let trees = if trees.first().is_some_and(|tree| is_mark(tree, '&')) { &trees[1..] } else { &trees[..] };
    let is_self = matches!(trees.first(), Some(TokenTree::Ident(word)) if word == "self");
    is_self && trees.get(1).is_none_or(|tree| is_mark(tree, ','))
}

/// The arguments after the first.
fn behind_self(group: &Group) -> TokenStream {
    group.stream().into_iter().skip_while(|tree| !is_mark(tree, ',')).collect()
}

fn is_mark(tree: &TokenTree, mark: char) -> bool {
    matches!(tree, TokenTree::Punct(found) if found.as_char() == mark)
}

/// Whether what follows a name makes it a call: parentheses, or `::<`.
fn is_call(behind: &[TokenTree]) -> bool {
    match behind {
        [TokenTree::Group(group), ..] => group.delimiter() == Delimiter::Parenthesis,
        [first, second, ..] => is_mark(first, ':') && is_mark(second, ':'),
        _ => false,
    }
}

/// The fields that a pattern takes out of `self`, where what stands before it is `let Self { mass, length: l, .. } =`.
fn destructured(before: &[TokenTree]) -> Option<Vec<TokenTree>> {
    let before = match before {
        [before @ .., reference] if is_mark(reference, '&') || is_mark(reference, '*') => before,
        before => before,
    };
    let [before @ .., TokenTree::Group(pattern), equals] = before else { return None };
    let is_pattern = pattern.delimiter() == Delimiter::Brace && is_mark(equals, '=');
    let named = before.iter().rev().find(|tree| {
        !matches!(tree, TokenTree::Ident(word) if word != "let") && !is_mark(tree, ':') && !is_mark(tree, '&')
    });
    if !is_pattern || !matches!(named, Some(TokenTree::Ident(word)) if word == "let") {
        return None;
    }
    let trees: Vec<TokenTree> = pattern.stream().into_iter().collect();
    let fields = trees.split(|tree| is_mark(tree, ','));
    let named = fields.filter(|field| !field.first().is_none_or(|tree| is_mark(tree, '.')));
    let name = |field: &[TokenTree]| {
        let is_mode = |tree: &&TokenTree| matches!(tree, TokenTree::Ident(word) if word == "ref" || word == "mut");
        field.iter().find(|tree| !is_mode(tree)).cloned()
    };
    named.map(name).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{errors::Errors, syntax};
    use proc_macro2::Span;

    /// What the method `flow` reads, where the impl has these functions.
    fn read(functions: &str) -> Vec<String> {
        let item = format!("impl System {{ {functions} }}").parse().expect("tokens");
        let input = syntax::input(TokenStream::new(), item, &mut Errors::default()).expect("an impl");
        let flow = Ident::new("flow", Span::call_site());
        let (_, fields) = followed(&input, &[&flow]);
        for (name, place) in &fields {
            let expected = if name == "self" { "*self" } else { name };
            assert_eq!(place.to_string().replace(' ', ""), expected);
        }
        fields.into_keys().collect()
    }

    #[test]
    fn every_field_that_a_method_reads_is_found() {
        for (body, expected) in [
            ("", &[][..]),
            ("1.0 + Self::WIDTH", &[]),
            ("self.a * self.b", &["self.a", "self.b"]),
            ("q[0] += self.a[self.b]", &["self.a", "self.b"]),
            ("self.a.len()", &["self.a"]),
            ("self.a.0.b.abs()", &["self.a.0.b"]),
            ("self.0", &["self.0"]),
            ("self.0.1", &["self.0.1"]),
            ("self.a.iter().zip(&self.b).sum::<f64>()", &["self.a", "self.b"]),
            ("(self.a)(x)", &["self.a"]),
            ("assert!(self.a > 0.0, \"{}\", self.b)", &["self.a", "self.b"]),
            ("self.helper(self.a)", &["self.a", "self.h"]),
            ("self.helper::<3>(1.0)", &["self.h"]),
            ("Self::helper(self, self.a)", &["self.a", "self.h"]),
            ("Self::helper(&self, 1.0)", &["self.h"]),
            ("System::deep(self)", &["self.d", "self.h"]),
            ("self.deep()", &["self.d", "self.h"]),
            ("let Self { a, b: _b, ref c, .. } = self; a", &["self.a", "self.b", "self.c"]),
            ("let System { a, .. } = *self; a", &["self.a"]),
            ("let a = &self; a.b", &["self"]),
            ("self.elsewhere()", &["self"]),
            ("Self::helper(&self.a)", &["self.a", "self.h"]),
            ("outside(self)", &["self"]),
            ("self.a; let f = |x| self.b * x; f(1.0)", &["self.a", "self.b"]),
        ] {
            let functions = format!(
                "fn flow(&self) {{ {body} }}
                 fn helper(&self, x: f64) -> f64 {{ self.h }}
                 fn deep(&self) -> f64 {{ self.d * self.helper(1.0) + self.deep() }}
                 fn potential(&self, q: [f64; 1]) -> f64 {{ self.v * q[0] }}"
            );
            assert_eq!(read(&functions), expected, "{body}");
        }
    }
}
