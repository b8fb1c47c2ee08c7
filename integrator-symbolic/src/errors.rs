//! Errors in the user's code: all of them are collected, each with the smallest accurate span.
//!
//! A message has the form of rustc's. The first line says what is wrong, in lower case and without a full stop. Lines
//! that begin with `help: ` say what to write instead; lines that begin with `note: ` give the reason. A constant that
//! begins with `help: ` or `note: ` is the end of several messages.

use proc_macro2::{Span, TokenStream, TokenTree};
use quote::ToTokens;
use std::{collections::HashSet, fmt::Display};

/// Tokens as one would type them, for a message: `Self::N`, `a[0]`, `2 * N`.
pub(crate) fn quoted(tokens: impl ToTokens) -> String {
    let text = tokens.to_token_stream().to_string();
    let (mut quoted, mut rest) = (String::new(), text.chars().peekable());
    let is_loose = |c: char| c.is_alphanumeric() || "_+-*/%<>=&|{}".contains(c);
    while let Some(c) = rest.next() {
        let before = quoted.chars().next_back().unwrap_or(' ');
        let after = rest.peek().copied().unwrap_or(' ');
        if c != ' ' || before == ',' || (is_loose(before) && is_loose(after)) {
            quoted.push(c);
        }
    }
    quoted
}

/// The mistakes found so far.
#[derive(Default)]
pub(crate) struct Errors(Vec<syn::Error>);

impl Errors {
    /// Notes a mistake at all tokens of `place`.
    pub(crate) fn at(&mut self, place: impl ToTokens, message: impl Display) {
        self.push(syn::Error::new_spanned(place, message));
    }

    /// Notes a mistake at a span.
    pub(crate) fn at_span(&mut self, span: Span, message: impl Display) {
        self.push(syn::Error::new(span, message));
    }

    /// Notes a mistake; one that is known already is not noted again.
    pub(crate) fn push(&mut self, error: syn::Error) {
        let key = |error: &syn::Error| format!("{error} {}", printed(error.span()));
        let same = |known: &syn::Error| key(known) == key(&error);
        if !self.0.iter().any(same) {
            self.0.push(error);
        }
    }

    /// The value, if there is one; else its error is noted.
    pub(crate) fn keep<T>(&mut self, outcome: syn::Result<T>) -> Option<T> {
        outcome.map_err(|error| self.push(error)).ok()
    }

    pub(crate) fn count(&self) -> usize {
        self.0.len()
    }

    /// All mistakes as one error, if there is any.
    pub(crate) fn combined(self) -> Option<syn::Error> {
        self.0.into_iter().reduce(|mut all, next| {
            all.combine(next);
            all
        })
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Returns the places at which the mistakes begin.
    pub(crate) fn places(&self) -> Places {
        let begin = |tokens: TokenStream| Some(printed(tokens.into_iter().next()?.span()));
        Places(self.0.iter().flatten().filter_map(|error| begin(error.to_compile_error())).collect())
    }

    /// All mistakes as `compile_error!` invocations.
    pub(crate) fn into_tokens(self) -> TokenStream {
        self.0.into_iter().map(|error| error.into_compile_error()).collect()
    }
}

/// The first tokens of mistakes.
pub(crate) struct Places(HashSet<String>);

impl Places {
    /// Whether a mistake begins within these tokens.
    pub(crate) fn are_in(&self, trees: &[TokenTree]) -> bool {
        !self.0.is_empty() && trees.iter().any(|tree| self.is_at(tree))
    }

    fn is_at(&self, tree: &TokenTree) -> bool {
        let begins = |span: Span| self.0.contains(&printed(span));
        match tree {
            TokenTree::Group(group) => {
                begins(group.span())
                    || begins(group.span_open())
                    || group.stream().into_iter().any(|tree| self.is_at(&tree))
            }
            tree => begins(tree.span()),
        }
    }
}

/// A span as text. Spans cannot be compared, but different spans print different text.
fn printed(span: Span) -> String {
    format!("{span:?}")
}
