//! Loop indices in the source of parameters, identified by their loop.
//!
//! Always true: source code refers to the index of a loop by an identifier that belongs to this loop only, whatever its
//! name in the user's code. The identifier gets the name of the index when it is printed. Source that is moved between
//! loops hence captures no variable.

use crate::graph::{
    index::{LoopId, LoopSet},
    rename::End,
};
use proc_macro2::{Group, Ident, TokenStream, TokenTree};
use quote::{format_ident, quote};

/// What the identifiers begin with, before the number of the loop.
const PREFIX: &str = "__index_of_loop_";

/// The identifier of a loop's index in the text of parameters.
pub(crate) fn running_index(by: LoopId) -> Ident {
    format_ident!("{PREFIX}{}", by.position())
}

/// The loop whose index an identifier is.
pub(crate) fn loop_of(name: &Ident) -> Option<LoopId> {
    let text = name.to_string();
    let position = text.strip_prefix(PREFIX)?.parse().ok()?;
    LoopSet::ALL.iter().find(|by| by.position() == position)
}

/// A text with other identifiers, or numbers, for the indices of loops.
pub(crate) fn with_indices(text: &TokenStream, of: &dyn Fn(LoopId) -> Option<TokenTree>) -> TokenStream {
    let renamed = text.clone().into_iter().map(|token| match token {
        TokenTree::Ident(name) => loop_of(&name).and_then(of).unwrap_or(TokenTree::Ident(name)),
        TokenTree::Group(group) => {
            let mut other = Group::new(group.delimiter(), with_indices(&group.stream(), of));
            other.set_span(group.span());
            other.into()
        }
        other => other,
    });
    renamed.collect()
}

/// A text with something else for the index of one loop.
pub(crate) fn with_index(text: &TokenStream, by: LoopId, index: impl Into<TokenTree>) -> TokenStream {
    let index = index.into();
    with_indices(text, &|other| (other == by).then(|| index.clone()))
}

/// The range of this number of bodies but the one at an end.
pub(super) fn but_for(end: Option<End>, count: &Ident) -> TokenStream {
    match end {
        None => quote!(0..#count),
        Some(End::First) => quote!(1..#count),
        Some(End::Last) => quote!(0..#count.saturating_sub(1)),
    }
}

/// The loops among these whose indices a text mentions.
pub(super) fn mentioned(text: &TokenStream, loops: LoopSet) -> LoopSet {
    let own = loops.iter().filter(|by| mentions(text, *by));
    own.fold(LoopSet::EMPTY, |set, by| set.union(LoopSet::of(by)))
}

/// Whether a text mentions the index of a loop.
pub(crate) fn mentions(text: &TokenStream, by: LoopId) -> bool {
    text.clone().into_iter().any(|token| match token {
        TokenTree::Ident(name) => loop_of(&name) == Some(by),
        TokenTree::Group(group) => mentions(&group.stream(), by),
        TokenTree::Punct(_) | TokenTree::Literal(_) => false,
    })
}
