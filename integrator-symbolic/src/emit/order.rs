//! The check of the order that an annotation claims, by the compiler: only it knows which compositions the names mean.

use super::flow::nested;
use crate::{
    model::Model,
    syntax::{Input, names::Names},
};
use proc_macro2::{Literal, TokenStream};
use quote::quote_spanned;

/// A constant that does not compile, at the claimed order, if a step of this composition has a lower order.
pub(super) fn check(input: &Input, model: &Model, compose: &TokenStream, names: &Names) -> Option<TokenStream> {
    let claim = input.order.as_ref()?;
    let (order, nests) = (Literal::u32_unsuffixed(claim.order), nested::facts(model, names));
    let runtime = names.runtime_at(claim.place);
    Some(quote_spanned!(claim.place=> const _: () = #runtime::claims_order::<#compose>(#order, &[#(#nests),*]);))
}
