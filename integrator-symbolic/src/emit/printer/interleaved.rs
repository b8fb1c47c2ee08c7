//! Indices of interleaved coordinates outside of loops: computed once per call, since they need a division.

use super::{expression::Printer, fields::Fields, function::Body};
use crate::graph::{Element, Graph, Node, index::IndexId};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

/// The names of these indices.
pub(crate) struct InterleavedIndices {
    names: Vec<((IndexId, Option<IndexId>), Ident)>,
}

impl InterleavedIndices {
    /// The indices of the coordinates that a graph reads.
    pub(crate) fn of(graph: &Graph) -> Self {
        let mut found: Vec<(IndexId, Option<IndexId>)> = graph
            .nodes()
            .filter_map(|node| match node {
                Node::Coordinate(element) => Some(element),
                _ => None,
            })
            .filter(|element| graph.loops.of_element(*element).is_empty())
            .map(|element| (element.index, element.component))
            .collect();
        found.sort_unstable();
        found.dedup();
        let name = |(number, of)| (of, format_ident!("index_{number}"));
        Self { names: found.into_iter().enumerate().map(name).collect() }
    }

    /// The name of a coordinate's index, if it has one.
    pub(crate) fn name(&self, element: Element) -> Option<&Ident> {
        let of = (element.index, element.component);
        self.names.iter().find(|(known, _)| *known == of).map(|(_, name)| name)
    }

    /// The lines that compute the indices that other lines mention.
    pub(crate) fn lines(&self, printer: &Printer<'_>, fields: &mut Fields, body: &Body) -> TokenStream {
        let mentioned = self.names.iter().filter(|(_, name)| body.mentions(&name.to_string()));
        let lines = mentioned.map(|((index, component), name)| {
            let index_printed = printer.interleaved_index(fields, *index, *component);
            quote!(let #name = #index_printed;)
        });
        lines.collect()
    }
}
