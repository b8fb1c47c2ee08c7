//! What one call of the recurrences finds: an order of all coefficients, or, where positions merely follow momenta, two
//! orders of forces at once, since those of an order do not wait for those of the one before.

use super::{
    moves::{Moves, begun, next},
    orders::Writer,
};
use crate::{
    emit::printer::{fields::Fields, function::Body},
    program::Item,
};
use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

/// How many orders are found in one call.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Pass {
    One,
    Two,
}

impl Pass {
    /// How many.
    pub(super) fn orders(self) -> usize {
        match self {
            Pass::One => 1,
            Pass::Two => 2,
        }
    }
}

/// Which coefficients lines read that say how the clock moves: those of one, and those of the time.
pub(super) fn clock_read(lines: &Body) -> Vec<Ident> {
    let read = ["step", "time"].into_iter().filter(|name| lines.mentions(name));
    read.map(|name| Ident::new(name, Span::call_site())).collect()
}

/// The line that gives the coefficients of the time, where they are read.
pub(super) fn clock(runtime: &Ident, lines: &TokenStream) -> Option<TokenStream> {
    let is_read = !clock_read(&Body::new(lines.clone())).is_empty();
    is_read.then(|| quote!(let (step, time) = #runtime::time_coefficients(order, time);))
}

impl Writer<'_> {
    /// The lines that find an order of all coefficients: what is added up is divided by the order at the end.
    pub(super) fn order_of_all(&mut self, fields: &mut Fields, items: &[Item]) -> TokenStream {
        let body = self.items(fields, items);
        let (opening, scalar, runtime) = (&self.opening, self.printer.scalar, self.printer.runtime);
        let lines = match &self.moves {
            Moves::Alone(elements) => {
                let begun = begun(elements.len(), scalar);
                let moved = elements.iter().enumerate().map(|(number, element)| {
                    let (next, part) = (next(number), self.printer.part(*element));
                    let place = self.printer.in_row(fields, *element);
                    let rate = self.keep_rate_of(element, &next);
                    quote!(#rate #part[order + 1][#place] = #runtime::div_by_order(#next, order + 1);)
                });
                quote!(#opening #begun #body #(#moved)*)
            }
            _ => quote! {
                q[order + 1].fill(#scalar::of(-0.0));
                p[order + 1].fill(#scalar::of(-0.0));
                #opening
                #body
                q.divide(order + 1);
                p.divide(order + 1);
            },
        };
        let clock = clock(runtime, &lines);
        quote!(#clock #lines)
    }

    /// The lines that find the orders of momenta, which positions follow. `mobilities` adds what positions multiply
    /// momenta by to their coefficients of order 1.
    pub(super) fn orders_of_momenta(
        &mut self,
        fields: &mut Fields,
        items: &[Item],
        mobilities: &TokenStream,
    ) -> TokenStream {
        self.pass = if self.is_for_two(items) { Pass::Two } else { Pass::One };
        let (scalar, runtime) = (self.printer.scalar, self.printer.runtime);
        let begin = quote! {
            if order == 0 {
                if tape.inverse_mass.is_empty() {
                    q[1].fill(#scalar::of(-0.0));
                    #mobilities
                    tape.inverse_mass = #runtime::InverseMass::of(&q[1]);
                }
                tape.inverse_mass.first_order(q, p);
            }
        };
        if self.pass == Pass::One {
            let body = self.items(fields, items);
            let opening = &self.opening;
            let lines = quote!(p[order + 1].fill(#scalar::of(-0.0)); #opening #body);
            let clock = clock(runtime, &lines);
            return quote!(#begin #clock #lines tape.inverse_mass.next_order(q, p, order + 1););
        }
        let (loops, own): (Vec<&Item>, Vec<&Item>) = items.iter().partition(|item| matches!(item, Item::Loop { .. }));
        let own = self.items(fields, own);
        let loops = self.items(fields, loops);
        let opening = &self.opening;
        let own = quote!(p[order + 1].fill(#scalar::of(-0.0)); #opening #own);
        let clock = clock(runtime, &own);
        quote! {
            #begin
            for order in [order, order + 1] { #clock #own }
            #loops
            tape.inverse_mass.next_order(q, p, order + 1);
            tape.inverse_mass.next_order(q, p, order + 2);
        }
    }

    /// Whether all loops are nests of iterations side by side that need nothing from the lines around them.
    fn is_for_two(&self, items: &[Item]) -> bool {
        items.iter().all(|item| match item {
            Item::Loop { by, body } => self.nests(*by, body).is_some_and(|nests| {
                nests.iter().flat_map(|nest| &nest.invariants).all(|id| self.printer.graph.is_prepared(*id))
            }),
            Item::Branch { body, .. } => !body.iter().any(|item| matches!(item, Item::Loop { .. })),
            _ => true,
        })
    }
}
