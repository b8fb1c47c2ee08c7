//! Declared invariants: as generated code for any scalar, and as calls of the user's own functions.

use super::Flows;
use crate::{
    emit::printer::{block::Emitter, function::Body},
    model::Invariant,
};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// The items for the runtime about invariants; nothing if there are none.
pub(crate) fn items(flows: &Flows, emitter: &mut Emitter<'_>) -> Option<TokenStream> {
    let invariants = std::mem::take(&mut emitter.model.invariants);
    if invariants.is_empty() {
        return None;
    }
    let values: Vec<TokenStream> = invariants
        .iter()
        .zip(0..)
        .map(|(invariant, number)| {
            let (number, value) = (Literal::usize_unsuffixed(number), flows.value(emitter, invariant.value));
            quote!(#number => { #value })
        })
        .collect();
    let names = emitter.names;
    let (runtime, scalar, leaf) = (&names.runtime, &names.scalar, &names.leaf);
    let body = Body::new(quote! {
        match number {
            #(#values)*
            _ => #scalar::of(f64::NAN),
        }
    });
    let (motion, body) = (body.argument("motion"), &body.0);
    let called = invariants.iter().map(|Invariant { name, .. }| name.to_string());
    let stated = invariants.iter().zip(0..).map(|(Invariant { name, arguments, .. }, number)| {
        let number = Literal::usize_unsuffixed(number);
        quote!(#number => Self::#name(#(#arguments),*))
    });
    Some(quote! {
        const INVARIANTS: &'static [&'static str] = &[#(#called),*];
        fn invariant<#scalar: #runtime::Real, #leaf: #runtime::Precision>(#motion: &Self::Motion<#scalar, #leaf>, number: usize) -> #scalar { #body }
        fn stated_invariant(&self, number: usize, q: &Self::Coords, p: &Self::Coords) -> f64 {
            match number {
                #(#stated,)*
                _ => f64::NAN,
            }
        }
    })
}
