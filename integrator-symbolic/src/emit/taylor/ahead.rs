//! Few coordinates whose positions merely follow momenta, `q' = m p`. Their coefficients come straight from what momenta
//! have got, by one division, `qₖ₊₂ = m p'ₖ / ((k + 1) (k + 2))`, and so they are there an order before they are read.

use super::{
    moves::{Moves, begun, next},
    orders::Writer,
    pass::clock,
};
use crate::{
    differentiate::Contribution,
    emit::printer::fields::Fields,
    graph::{Element, NodeId},
    program::Item,
};
use proc_macro2::TokenStream;
use quote::quote;
use std::collections::BTreeMap;

/// What each momentum is multiplied by.
pub(super) struct Mobilities(BTreeMap<Element, NodeId>);

impl Mobilities {
    pub(super) fn of(contributions: &[Contribution]) -> Self {
        Self(contributions.iter().map(|contribution| (contribution.element, contribution.value)).collect())
    }
}

impl Writer<'_> {
    /// The lines that find an order of momenta, and the next one of positions.
    pub(super) fn order_ahead(&mut self, fields: &mut Fields, items: &[Item], mobilities: &Mobilities) -> TokenStream {
        let body = self.items(fields, items);
        let Moves::Alone(elements) = &self.moves else { return body };
        let (opening, scalar, runtime) = (&self.opening, self.printer.scalar, self.printer.runtime);
        let begun = begun(elements.len(), scalar);
        let first = mobilities.0.iter().map(|(momentum, mobility)| {
            let place = self.printer.in_row(fields, *momentum);
            let value = self.moved(fields, *mobility, &quote!(p[0][#place]));
            let rate = self.rate_of(&momentum.partner()).map(|rate| rate.of(&quote!(1)));
            let rate = rate.map(|rate| quote!(#rate = q[1][#place];));
            quote!(q[1][#place] = #value; #rate)
        });
        let first: TokenStream = first.collect();
        let lines = elements.iter().enumerate().map(|(number, momentum)| {
            let (next, place) = (next(number), self.printer.in_row(fields, *momentum));
            let position = mobilities.0.get(momentum).map(|mobility| {
                let value = self.moved(fields, *mobility, &quote!(#next));
                match self.rate_of(&momentum.partner()).map(|rate| rate.of(&quote!(order + 2))) {
                    Some(rate) => quote! {
                        #rate = #runtime::div_by_order(#value, order + 1);
                        q[order + 2][#place] = #runtime::div_by_order(#rate, order + 2);
                    },
                    None => quote!(q[order + 2][#place] = #runtime::div_by_two_orders(#value, order + 1);),
                }
            });
            quote!(p[order + 1][#place] = #runtime::div_by_order(#next, order + 1); #position)
        });
        let lines: TokenStream = lines.collect();
        let lines = quote!(if order == 0 { #first } #opening #begun #body #lines);
        let clock = clock(runtime, &lines);
        quote!(#clock #lines)
    }

    /// A momentum, or what it gets, times a mobility.
    fn moved(&self, fields: &mut Fields, mobility: NodeId, momentum: &TokenStream) -> TokenStream {
        if self.printer.graph.as_constant(mobility) == Some(1.0) {
            return momentum.clone();
        }
        let mobility = self.printer.receiver(fields, mobility);
        quote!(#mobility * #momentum)
    }
}
