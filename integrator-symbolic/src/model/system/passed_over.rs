//! Functions of the impl with a reserved name that are not part of `H`.

use crate::model::{Reader, code::shape::has_coordinates};
use proc_macro2::{TokenStream, TokenTree};
use quote::ToTokens;
use syn::ImplItemFn;

/// The names that mean something.
const KNOWN: [&str; 4] = ["kinetic", "potential", "hamiltonian", "rate"];

impl Reader<'_> {
    /// Notes each function with such a name that is neither one of those that H is made of, `used`, nor called by another one,
    /// nor calls them, as a function does that adds them up.
    pub(crate) fn check_passed_over(&mut self, used: &[&str]) {
        let input = self.input;
        for name in KNOWN.into_iter().filter(|name| !used.contains(name)) {
            let Some(function) = input.function(name).filter(|function| has_coordinates(function)) else { continue };
            let others = input.functions().filter(|other| other.sig.ident != name);
            let is_called = others.into_iter().any(|other| calls(other, name));
            if is_called || used.iter().any(|used| calls(function, used)) {
                continue;
            }
            let made: Vec<String> =
                used.iter().filter(|name| **name != "rate").map(|name| format!("`{name}`")).collect();
            let message = match name {
                "rate" => "`rate` is not a function of all positions\nhelp: write `fn rate(&self, q: ..) -> f64`, or \
                           rename it\nnote: `rate` controls the step size by time transformation"
                    .to_owned(),
                _ => format!(
                    "`{name}` is not used\nhelp: remove it, or rename it\nnote: H is the sum of {}, which do not call \
                     it",
                    made.join(" and ")
                ),
            };
            self.errors.at(&function.sig.ident, message);
        }
    }
}

/// Whether a function calls a method of the impl.
fn calls(function: &ImplItemFn, name: &str) -> bool {
    mentions(function.block.to_token_stream(), name)
}

/// Whether a name stands after a dot or a colon.
fn mentions(tokens: TokenStream, name: &str) -> bool {
    let mut is_behind = false;
    tokens.into_iter().any(|tree| {
        let found = match &tree {
            TokenTree::Group(group) => mentions(group.stream(), name),
            TokenTree::Ident(word) => is_behind && word == name,
            _ => false,
        };
        is_behind = matches!(&tree, TokenTree::Punct(mark) if matches!(mark.as_char(), '.' | ':'));
        found
    })
}
