//! The procedural macros of `integrator-core`. `integrator-symbolic` implements them.
//!
//! Use them through `integrator_core`, which re-exports both and provides the items that the generated code calls.
#![forbid(unsafe_code)]

use proc_macro::TokenStream;

#[doc = include_str!("hamiltonian.md")]
#[proc_macro_attribute]
pub fn hamiltonian(arguments: TokenStream, item: TokenStream) -> TokenStream {
    integrator_symbolic::hamiltonian(arguments.into(), item.into()).into()
}

#[doc = include_str!("composition.md")]
#[proc_macro]
pub fn composition(declarations: TokenStream) -> TokenStream {
    integrator_symbolic::composition(declarations.into()).into()
}
