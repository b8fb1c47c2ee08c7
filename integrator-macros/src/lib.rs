//! The procedural macros of `integrator-core`: a doorway to `integrator-symbolic`, where the work is done.

use proc_macro::TokenStream;

/// Writes the stepper of a Hamiltonian `H = T(p) + V(q)` given as two plain functions.
#[proc_macro_attribute]
pub fn hamiltonian(arguments: TokenStream, item: TokenStream) -> TokenStream {
    integrator_symbolic::hamiltonian(arguments.into(), item.into()).into()
}

/// Declares compositions of drifts and kicks and proves their order.
#[proc_macro]
pub fn composition(declarations: TokenStream) -> TokenStream {
    integrator_symbolic::composition(declarations.into()).into()
}
