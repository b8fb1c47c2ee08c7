//! `order = 4`: the order that the annotation claims for its steps.

use super::misfit;
use proc_macro2::Span;
use syn::{Lit, LitInt, parse::ParseStream};

/// A claimed order, with its place.
pub(crate) struct OrderClaim {
    pub(crate) order: u32,
    pub(crate) place: Span,
}

/// Reads the order.
pub(super) fn order_of(input: ParseStream<'_>, key: Span) -> syn::Result<OrderClaim> {
    let is = "the order has to be a positive integer\nhelp: write, for example, `order = 4`";
    if !input.peek(Lit) {
        return Err(misfit(input, key, is));
    }
    let literal: Lit = input.parse()?;
    let number = match &literal {
        Lit::Int(number) => LitInt::base10_parse(number).ok().filter(|order| *order > 0),
        _ => None,
    };
    let order = number.ok_or_else(|| syn::Error::new(literal.span(), is))?;
    Ok(OrderClaim { order, place: literal.span() })
}
