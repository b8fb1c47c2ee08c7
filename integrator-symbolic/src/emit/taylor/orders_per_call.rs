//! The number of orders that one call of the recurrences computes: usually one order of all coefficients.
//!
//! If positions follow from momenta by an inverse mass, a call computes two orders of forces, since each is independent
//! of the previous one.

use super::{
    accumulation::{Accumulation, declare_derivatives, derivative},
    tape::OrdersPerCall,
    writer::Writer,
};
use crate::{
    emit::printer::{fields::Fields, function::Body},
    program::Item,
};
use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

/// The coefficients that lines read of the step and of the time.
pub(super) fn clock_read(lines: &Body) -> Vec<Ident> {
    let read = ["step", "time"].into_iter().filter(|name| lines.mentions(name));
    read.map(|name| Ident::new(name, Span::call_site())).collect()
}

/// The line that gives the coefficients of the time, where they are read.
pub(super) fn clock(runtime: &Ident, lines: &TokenStream) -> Option<TokenStream> {
    let is_read = !clock_read(&Body::new(lines.clone())).is_empty();
    is_read.then(|| quote!(let (step, time) = #runtime::time_coefficients(order, time, q.unit());))
}

impl Writer<'_> {
    /// The lines that compute an order of all coefficients: sums are divided by the order at the end.
    pub(super) fn order_of_all(&mut self, fields: &mut Fields, items: &[Item]) -> TokenStream {
        let body = self.items(fields, items);
        let (opening, scalar, runtime) = (&self.opening, self.printer.scalar, self.printer.runtime);
        let lines = match &self.accumulation {
            Accumulation::Scalars(elements) => {
                let derivatives = declare_derivatives(elements.len(), scalar);
                let moved = elements.iter().enumerate().map(|(number, element)| {
                    let (derivative, part) = (derivative(number), self.printer.part(*element));
                    let place = self.printer.in_row(fields, *element);
                    let rate = self.keep_rate_of(element, &quote!(#part.integral(#derivative, 1)));
                    quote!(#rate #part[order + 1][#place] = #part.integral(#derivative, order + 1);)
                });
                quote!(#opening #derivatives #body #(#moved)*)
            }
            _ => quote! {
                q[order + 1].fill(#scalar::of(-0.0));
                p[order + 1].fill(#scalar::of(-0.0));
                #opening
                #body
                q.integrate(order + 1);
                p.integrate(order + 1);
            },
        };
        let clock = clock(runtime, &lines);
        quote!(#clock #lines)
    }

    /// The lines that compute the orders of momenta, which positions follow. `inverse_masses` adds the inverse masses
    /// to the positions' coefficients of order 1.
    pub(super) fn orders_of_momenta(
        &mut self,
        fields: &mut Fields,
        items: &[Item],
        inverse_masses: &TokenStream,
    ) -> TokenStream {
        self.orders_per_call = if self.is_for_two(items) { OrdersPerCall::Two } else { OrdersPerCall::One };
        let (scalar, runtime) = (self.printer.scalar, self.printer.runtime);
        let begin = self.first_order(inverse_masses);
        if self.orders_per_call == OrdersPerCall::One {
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

    /// The lines that begin an expansion: positions of order 1 follow the momenta.
    pub(super) fn first_order(&self, inverse_masses: &TokenStream) -> TokenStream {
        let (scalar, runtime) = (self.printer.scalar, self.printer.runtime);
        quote! {
            if order == 0 {
                if tape.inverse_mass.is_empty() {
                    q[1].fill(#scalar::of(-0.0));
                    #inverse_masses
                    tape.inverse_mass = #runtime::InverseMass::of(&q[1]);
                }
                tape.inverse_mass.first_order(q, p);
            }
        }
    }

    /// Whether all loops are nests of iterations that share vectors and need nothing from the lines around them.
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
