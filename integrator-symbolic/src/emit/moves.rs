//! How the coefficients of coordinates get their addends.

use super::{fields::Fields, orders::Writer};
use crate::{
    graph::{Element, Graph},
    program::{Item, Sink},
};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

/// How lines move coordinates.
pub(super) enum Moves {
    /// Each of a few coordinates has a sum of its own.
    Alone(Vec<Element>),
    /// They are added to coordinates where these are.
    InPlace,
    /// They are those of turns side by side, which have found numbers for so many targets so far.
    Abreast(usize),
}

impl Moves {
    /// Coordinates are moved alone where it is known which they are.
    pub(super) fn of(graph: &Graph, items: &[Item]) -> Self {
        fn elements(graph: &Graph, items: &[Item]) -> Option<Vec<Element>> {
            let mut found = Vec::new();
            for item in items {
                match item {
                    Item::Loop { .. } => return None,
                    Item::Branch { body, .. } => found.extend(elements(graph, body)?),
                    Item::Sink(Sink::Collect(element), _) => {
                        let known = [Some(element.index), element.component].into_iter().flatten();
                        known.map(|index| graph.loops.literal(index)).collect::<Option<Vec<_>>>()?;
                        found.push(*element);
                    }
                    _ => {}
                }
            }
            Some(found)
        }
        elements(graph, items).map_or(Self::InPlace, |mut elements| {
            elements.sort_unstable();
            elements.dedup();
            Self::Alone(elements)
        })
    }
}

/// What the sum of a coordinate that is moved alone is called.
pub(super) fn next(number: usize) -> Ident {
    format_ident!("next_{number}")
}

impl Writer<'_> {
    /// The lines that the function begins with, and those that it ends with: the coefficients are divided by their order.
    pub(super) fn ends(&mut self, fields: &mut Fields) -> (TokenStream, TokenStream) {
        let (opening, scalar, runtime) = (&self.opening, self.printer.scalar, self.printer.runtime);
        let Moves::Alone(elements) = &self.moves else {
            return (
                quote! {
                    q[order + 1].fill(#scalar::of(-0.0));
                    p[order + 1].fill(#scalar::of(-0.0));
                    #opening
                },
                quote!(q.divide(order + 1); p.divide(order + 1);),
            );
        };
        // Minus zero is what nothing has been added to.
        let begun = (0..elements.len()).map(|number| {
            let next = next(number);
            quote!(let mut #next = #scalar::of(-0.0);)
        });
        let moved = elements.iter().enumerate().map(|(number, element)| {
            let (next, part) = (next(number), self.printer.part(*element));
            let place = self.printer.in_row(fields, *element);
            quote!(#part[order + 1][#place] = #runtime::over(#next, order + 1);)
        });
        (quote!(#opening #(#begun)*), quote!(#(#moved)*))
    }
}
