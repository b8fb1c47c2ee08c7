//! Rust code for terms of a body and two others.

use super::Writer;
use crate::{
    graph::index::LoopId,
    pattern::{bodies::OfBodies, triplets::TripletsOfBodies},
};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

impl Writer<'_, '_> {
    /// The gradient and the energy of a body and two others, and the cutoff of these.
    pub(super) fn triplets(&mut self, triplets: &TripletsOfBodies, sums_energies: bool) -> TokenStream {
        let TripletsOfBodies { force, energy, cutoff, .. } = triplets;
        let (wide, d, none) = (self.emitter.names.wide.clone(), self.sizes[0].clone(), TokenStream::new);
        let dimension: usize = d.to_string().parse().unwrap_or(1);
        let [first, second] = [0, dimension].map(|first| {
            let places = (first..first + dimension).map(Literal::usize_unsuffixed);
            quote!([#(gradient[#places]),*])
        });
        let numbers = Literal::usize_unsuffixed(2 * dimension);
        let lines = self.lines(force).map(|lines| {
            quote! {
                let mut gradient = [#wide::of(0.0); #numbers];
                #lines
                [#first, #second]
            }
        });
        let result = quote!([[#wide; #d]; 2]);
        let force = self.function("triplet", none(), self.three_bodies(&force.of), Some(result), lines);
        let energy = sums_energies.then(|| {
            let lines = self.lines(energy);
            self.function("triplet_energy", none(), self.three_bodies(&energy.of), Some(quote!(#wide)), lines)
        });
        let square = self.lines(&cutoff.square);
        let square = self.function("triplet_cutoff", none(), none(), Some(quote!(#wide)), square);
        let sides = cutoff.sides.as_ref().map(|sides| {
            let sides = self.gradient(sides, quote!(gradient));
            self.function("triplet_sides", none(), none(), Some(quote!([#wide; #d])), sides)
        });
        quote! {
            const TRIPLETS: bool = true;

            #force
            #energy
            #square
            #sides
        }
    }

    /// The coordinates and prepared constants of three bodies, as arguments.
    fn three_bodies(&self, of: &[LoopId]) -> TokenStream {
        let (wide, [d, s]) = (&self.emitter.names.wide, self.sizes);
        let named = |what| of.iter().map(move |by| OfBodies::name_of(what, self.emitter.model, *by));
        let (q, constants) = (named("q"), named("constants"));
        quote!(#(#q: [#wide; #d]),*, #(#constants: [#wide; #s]),*)
    }
}
