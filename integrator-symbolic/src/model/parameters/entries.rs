//! Texts of lists that have the entries of all lists of a loop, one list after the other.

use super::{parameter_text::Texts, running_index::running_index};
use crate::graph::{
    Graph, ParameterId,
    index::{Index, IndexId, LoopId, LoopSet},
};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// The entries of the lists of a loop.
#[derive(Clone, Copy)]
pub(crate) struct Entries {
    /// The number of lists and the length of each.
    pub(crate) rows: [IndexId; 2],
    /// The loops over the lists and over the entries of each.
    pub(crate) loops: [LoopId; 2],
    /// The loop over all entries.
    pub(crate) all: LoopId,
}

impl Entries {
    /// Whether a text depends on the indices of a list and of an entry alone.
    fn are_of(self, own: LoopSet) -> bool {
        own.is_subset(LoopSet::of(self.loops[0]).union(LoopSet::of(self.loops[1])))
    }
}

impl Texts<'_> {
    /// The number of all entries of the lists of a loop; `rows` are the number of lists and the length of each.
    pub(crate) fn total_of(&mut self, graph: &mut Graph, rows: [IndexId; 2], by: LoopId) -> Option<ParameterId> {
        let [count, length] = [self.text_of(graph, rows[0])?, self.text_of(graph, rows[1])?];
        let by = running_index(by);
        Some(self.fixed(graph, quote!((0..#count).map(|#by: usize| #length).sum::<usize>())))
    }

    /// A number of each entry.
    pub(crate) fn entry_of(&mut self, graph: &mut Graph, number: ParameterId, entries: Entries) -> Option<ParameterId> {
        if !entries.are_of(graph.loops.of_parameter(number)) {
            return None;
        }
        let (text, own) = (self.is_plain_number(number).then(|| self.text(number))?, self.own_text(number));
        let entry = self.of_entries(graph, &text, entries)?;
        self.show(entry, &own);
        graph.declare_like(entry, number);
        Some(entry)
    }

    /// An index for each entry.
    pub(crate) fn list_of(&mut self, graph: &mut Graph, index: IndexId, entries: Entries) -> Option<ParameterId> {
        if !entries.are_of(graph.loops.of_index(index)) {
            return None;
        }
        let text = self.text_of(graph, index)?;
        let list = self.of_entries(graph, &text, entries)?;
        self.show(list, &text);
        Some(list)
    }

    fn of_entries(&mut self, graph: &mut Graph, text: &TokenStream, entries: Entries) -> Option<ParameterId> {
        let Entries { rows, loops, all } = entries;
        let [count, length] = [self.text_of(graph, rows[0])?, self.text_of(graph, rows[1])?];
        let (root, [by, inner]) = (self.root, loops.map(running_index));
        let code = quote!(#root::__private::entries(#count, &|#by: usize| #length, &|#by: usize, #inner: usize| #text));
        let index = running_index(all);
        Some(self.list(graph, quote!((#code)[#index]), LoopSet::of(all), code))
    }

    /// An integer as text, if it is made of lengths, parameters and indices by simple operations.
    pub(super) fn text_of(&self, graph: &Graph, id: IndexId) -> Option<TokenStream> {
        let of = |id| self.text_of(graph, id);
        Some(match graph.loops.index(id) {
            Index::Literal(value) => {
                let value = Literal::u64_unsuffixed(value);
                quote!(#value)
            }
            Index::Running(by) => {
                let by = running_index(by);
                quote!(#by)
            }
            Index::Length => quote!(length),
            Index::Parameter(parameter) => {
                let text = self.text(parameter);
                quote!((#text))
            }
            Index::Add(a, b) => {
                let (a, b) = (of(a)?, of(b)?);
                quote!((#a + #b))
            }
            Index::Mul(a, b) => {
                let (a, b) = (of(a)?, of(b)?);
                quote!((#a * #b))
            }
            Index::Min(a, b) => {
                let (a, b) = (of(a)?, of(b)?);
                quote!(::core::cmp::Ord::min(#a, #b))
            }
            _ => return None,
        })
    }
}
