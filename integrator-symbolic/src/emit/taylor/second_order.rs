//! The second-order recurrence of a few positions with an inverse mass, `q' = m p`. Their coefficients follow from the
//! sums of momenta by one division, `qₖ₊₂ = m p'ₖ / ((k + 1) (k + 2))`, one order before they are needed.

use super::{
    accumulation::{Accumulation, declare_derivatives, derivative},
    orders_per_call::clock,
    writer::Writer,
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

/// The inverse mass of each momentum.
pub(super) struct InverseMasses(BTreeMap<Element, NodeId>);

impl InverseMasses {
    pub(super) fn of(contributions: &[Contribution]) -> Self {
        Self(contributions.iter().map(|contribution| (contribution.element, contribution.value)).collect())
    }
}

impl Writer<'_> {
    /// The lines that compute an order of momenta, and the next one of positions.
    pub(super) fn second_order(
        &mut self,
        fields: &mut Fields,
        items: &[Item],
        inverse_masses: &InverseMasses,
    ) -> TokenStream {
        let body = self.items(fields, items);
        let Accumulation::Scalars(elements) = &self.accumulation else { return body };
        let (opening, scalar, runtime) = (&self.opening, self.printer.scalar, self.printer.runtime);
        let derivatives = declare_derivatives(elements.len(), scalar);
        let first = inverse_masses.0.iter().map(|(momentum, inverse_mass)| {
            let place = self.printer.in_row(fields, *momentum);
            let value = self.moved(fields, *inverse_mass, &quote!(p[0][#place]));
            let rate = self.rate_of(&momentum.partner()).map(|rate| rate.of(&quote!(1)));
            let rate = rate.map(|rate| quote!(#rate = q[1][#place];));
            quote!(q[1][#place] = q.integral(#value, 1); #rate)
        });
        let first: TokenStream = first.collect();
        let lines = elements.iter().enumerate().map(|(number, momentum)| {
            let (derivative, place) = (derivative(number), self.printer.in_row(fields, *momentum));
            let position = inverse_masses.0.get(momentum).map(|inverse_mass| {
                let value = self.moved(fields, *inverse_mass, &quote!(#derivative));
                match self.rate_of(&momentum.partner()).map(|rate| rate.of(&quote!(order + 2))) {
                    Some(rate) => quote! {
                        #rate = q.rate(#value, order + 1);
                        q[order + 2][#place] = #runtime::div_by_order(#rate, order + 2);
                    },
                    None => quote!(q[order + 2][#place] = q.second_integral(#value, order + 1);),
                }
            });
            quote!(p[order + 1][#place] = p.integral(#derivative, order + 1); #position)
        });
        let lines: TokenStream = lines.collect();
        let lines = quote!(if order == 0 { #first } #opening #derivatives #body #lines);
        let clock = clock(runtime, &lines);
        quote!(#clock #lines)
    }

    /// A momentum, or what it gets, times an inverse mass.
    fn moved(&self, fields: &mut Fields, inverse_mass: NodeId, momentum: &TokenStream) -> TokenStream {
        if self.printer.graph.as_constant(inverse_mass) == Some(1.0) {
            return momentum.clone();
        }
        let inverse_mass = self.printer.receiver(fields, inverse_mass);
        quote!(#inverse_mass * #momentum)
    }
}
