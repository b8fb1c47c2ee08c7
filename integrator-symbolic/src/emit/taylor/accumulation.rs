//! Accumulation of addends into the coefficients of coordinates.

use crate::{
    graph::{Element, Graph},
    program::{Item, Sink, results::Results},
};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

/// The way in which lines accumulate what moves coordinates.
pub(super) enum Accumulation {
    /// In a local sum for each of a few coordinates.
    Scalars(Vec<Element>),
    /// In the table of coefficients.
    InPlace,
    /// In the table, once in a run, by loops as they stand.
    InPlaceOnce,
    /// In results of iterations that share vectors, which the runtime scatters.
    Lanes(Results),
}

impl Accumulation {
    /// Local sums where it is known which coordinates lines move.
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
            Self::Scalars(elements)
        })
    }

    /// The results of iterations that share vectors; empty for other lines.
    pub(super) fn results(self) -> Results {
        match self {
            Self::Lanes(results) => results,
            Self::Scalars(_) | Self::InPlace | Self::InPlaceOnce => Results::default(),
        }
    }
}

/// The lines that declare the sums of this number of derivatives: minus zero is the empty sum.
pub(super) fn declare_derivatives(count: usize, scalar: &Ident) -> TokenStream {
    let names = (0..count).map(derivative);
    quote!(#(let mut #names = #scalar::of(-0.0);)*)
}

/// The name of the local sum of a coordinate's derivative.
pub(super) fn derivative(number: usize) -> Ident {
    format_ident!("derivative_{number}")
}
