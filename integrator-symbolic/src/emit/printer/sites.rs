//! The values that sites of a lattice read from their neighbourhood, and the contributions that they pass on.

use super::{expression::Printer, fields::Fields, frame::Frame};
use crate::{
    graph::{
        Element,
        index::{Index, IndexId, LoopId, LoopSet},
    },
    stencil::{Extent, Stencil},
    syntax::names::Names,
};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, format_ident, quote};

/// The name of the contributions that go `onward`: `contribution_1`, or `contribution_1_0` over rows and sites, after a
/// zero for planes where there are any.
fn contribution(onward: &[usize]) -> Ident {
    let onward: Vec<_> = onward.iter().map(ToString::to_string).collect();
    format_ident!("contribution_{}", onward.join("_"))
}

impl Printer<'_> {
    /// A coordinate of a neighbour.
    pub(crate) fn neighbour(&self, element: Element) -> TokenStream {
        let far = |index| match self.graph.loops.index(index) {
            Index::Add(_, far) => (true, self.graph.loops.literal(far).unwrap_or_default()),
            Index::Sub(_, far) => (false, self.graph.loops.literal(far).unwrap_or_default()),
            _ => (true, 0),
        };
        let far: Vec<_> = self.graph.loops.of_coordinate(element).map(far).collect();
        let row = match far[..] {
            [.., (true, 1..), _] if far.len() == 2 || far[0].1 == 0 => quote!(below),
            [.., (false, 1..), _] if far.len() == 2 || far[0].1 == 0 => quote!(above),
            [(true, 1..), _, _] => quote!(next_plane),
            [(false, 1..), _, _] => quote!(previous_plane),
            _ => quote!(at),
        };
        let (is_ahead, far) = far.last().copied().unwrap_or((true, 0));
        let far = Literal::u64_unsuffixed(far);
        if is_ahead { quote!(window.#row(#far)) } else { quote!(window.#row(-#far)) }
    }

    /// A prepared constant, the same at all sites, or what a table holds for them.
    pub(crate) fn spread(&self, lattice: &Stencil, name: Ident, loops: LoopSet) -> TokenStream {
        let wide = self.scalar;
        // Rows are counted from the sites outwards.
        let place = |by: LoopId| {
            let mut directions = lattice.directions.iter().rev().enumerate();
            directions.find_map(|(number, direction)| {
                let ahead = Literal::i64_unsuffixed(-*direction.begins.get(&by)?);
                Some((number, ahead))
            })
        };
        match &loops.iter().filter_map(place).collect::<Vec<_>>()[..] {
            [(_, planes), (_, rows), (_, sites)] => {
                quote!(window.table_of_planes(&parameters.#name, [#planes, #rows], #sites))
            }
            [(_, rows), (_, sites)] => quote!(window.table_of_rows(&parameters.#name, #rows, #sites)),
            [(0, sites)] => quote!(window.table(&parameters.#name, #sites)),
            [(1, rows)] => quote!(window.table_over_rows(&parameters.#name, #rows)),
            [(_, planes)] => quote!(window.table_over_planes(&parameters.#name, #planes)),
            _ => quote!(#wide::splat(parameters.#name)),
        }
    }

    /// The line that notes a contribution.
    pub(crate) fn contribution(&self, fields: &mut Fields, number: usize, value: TokenStream) -> TokenStream {
        let Frame::Sites(lattice) = self.frame else { return TokenStream::new() };
        let of = &lattice.contributions[number];
        let name = contribution(&of.onward());
        let begun = lattice.contributions[..number].iter().any(|before| before.onward() == of.onward());
        let mut range = |from: IndexId, to: IndexId| {
            let (from, to) = (self.index(fields, from), self.index(fields, to));
            quote!(#from..#to)
        };
        let (mut value, mut few) = (value, None);
        let methods = [
            (quote!(masked), quote!(masked_add)),
            (quote!(row_masked), quote!(row_masked_add)),
            (quote!(plane_masked), quote!(plane_masked_add)),
        ];
        // Sites come last, rows before them, planes first.
        for (along, (within, plus)) in of.along.iter().rev().zip(methods) {
            match along.places {
                Extent::All => {}
                Extent::Few(from, to) if few.is_none() => few = Some((plus, range(from, to))),
                Extent::Most(from, to) | Extent::Few(from, to) => {
                    let places = range(from, to);
                    value = quote!(window.#within(#places, #value));
                }
            }
        }
        if let Some((plus, places)) = few {
            let before = if begun { quote!(#name) } else { self.lift(quote!(0.0)) };
            return quote!(let #name = window.#plus(#places, #before, #value););
        }
        if begun { quote!(let #name = #name + #value;) } else { quote!(let #name = #value;) }
    }
}

/// All contributions of a lattice in order, with zero for those that no site has.
pub(crate) fn contributions(lattice: &Stencil, names: &Names) -> Vec<TokenStream> {
    let wide = &names.wide;
    let named =
        |onward: &Vec<usize>| match lattice.contributions.iter().any(|contribution| contribution.onward() == *onward) {
            true => contribution(onward).to_token_stream(),
            false => quote!(#wide::of(0.0)),
        };
    lattice.places().iter().map(named).collect()
}
