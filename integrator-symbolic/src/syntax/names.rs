//! Names for generated items that do not shadow the user's own, or the reverse.

use crate::syntax::{Compose, Input};
use proc_macro2::{Ident, Span, TokenStream, TokenTree};
use quote::ToTokens;
use std::collections::HashSet;

/// The names of generated items and type parameters: none is one that the user's text mentions.
pub(crate) struct Names {
    /// The path of the runtime's private API.
    pub(crate) runtime: Ident,
    /// The struct of prepared constants.
    pub(crate) parameters: Ident,
    /// The field of it for what methods read that are called as they are.
    pub(crate) read: Ident,
    /// The composition that was written in place.
    pub(crate) composition: Ident,
    /// What flows compute in.
    pub(crate) scalar: Ident,
    /// What derivatives of parameters alone are computed in.
    pub(crate) double: Ident,
    /// Neighbours or bodies that a flow computes in lanes.
    pub(crate) wide: Ident,
    /// How coordinates are kept.
    pub(crate) leaf: Ident,
    /// The struct of Taylor coefficients that recurrences read.
    pub(crate) tape: Ident,
    /// What the structs of the iterations of its loops begin with.
    pub(crate) iteration: Ident,
    /// What the types of parts that are sums over pairs begin with.
    pub(crate) part: Ident,
    /// Values that loops keep of each iteration, and results of other ones.
    pub(crate) kept: Ident,
    pub(crate) results: Ident,
}

impl Names {
    pub(crate) fn new(input: &Input) -> Self {
        let mut used = HashSet::new();
        collect(input.item.to_token_stream(), &mut used);
        let outer = match &input.compose {
            Some(Compose::Named(path)) => Some(path),
            _ => None,
        };
        let inner = input.nests.iter().filter_map(|nest| nest.compose.as_ref());
        inner.chain(outer).for_each(|path| collect(path.to_token_stream(), &mut used));
        let free = |name: &str| {
            let mut free = name.to_owned();
            while used.contains(&free) {
                free.push('_');
            }
            Ident::new(&free, Span::call_site())
        };
        let beginning = |name: &str| {
            let mut free = name.to_owned();
            while used.iter().any(|used| used.starts_with(&free)) {
                free.push('_');
            }
            Ident::new(&free, Span::call_site())
        };
        Self {
            runtime: free("runtime"),
            parameters: free("Parameters"),
            read: free("read_by_methods"),
            composition: free("InPlace"),
            scalar: free("Scalar"),
            double: Ident::new("f64", Span::call_site()),
            wide: free("Wide"),
            leaf: free("Leaf"),
            tape: free("Tape"),
            iteration: free("Iteration"),
            part: beginning("Part"),
            kept: free("kept"),
            results: free("results"),
        }
    }

    /// Returns the path of the runtime's private API at a place, for errors that the compiler finds there.
    pub(crate) fn runtime_at(&self, place: Span) -> Ident {
        let mut runtime = self.runtime.clone();
        runtime.set_span(runtime.span().located_at(place));
        runtime
    }
}

fn collect(tokens: TokenStream, used: &mut HashSet<String>) {
    for token in tokens {
        match token {
            TokenTree::Ident(name) => {
                used.insert(name.to_string());
            }
            TokenTree::Group(group) => collect(group.stream(), used),
            TokenTree::Punct(_) | TokenTree::Literal(_) => {}
        }
    }
}
