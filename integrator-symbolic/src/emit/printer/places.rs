//! Where interleaved coordinates are that no loop runs over: found once, since it takes a division.

use super::{expression::Printer, fields::Fields, function::Body};
use crate::graph::{Element, Graph, Node, index::IndexId};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

/// The names of such places.
pub(crate) struct Places {
    names: Vec<((IndexId, Option<IndexId>), Ident)>,
}

impl Places {
    /// Those of the coordinates that a graph reads.
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
        let name = |(number, place)| (place, format_ident!("place_{number}"));
        Self { names: found.into_iter().enumerate().map(name).collect() }
    }

    /// The name of a coordinate's place, if it has one.
    pub(crate) fn name(&self, element: Element) -> Option<&Ident> {
        let place = (element.index, element.component);
        self.names.iter().find(|(known, _)| *known == place).map(|(_, name)| name)
    }

    /// The lines that find those that other lines mention.
    pub(crate) fn found(&self, printer: &Printer<'_>, fields: &mut Fields, lines: &Body) -> TokenStream {
        let mentioned = self.names.iter().filter(|(_, name)| lines.mentions(&name.to_string()));
        let found = mentioned.map(|((index, component), name)| {
            let place = printer.dealt_place(fields, *index, *component);
            quote!(let #name = #place;)
        });
        found.collect()
    }
}
