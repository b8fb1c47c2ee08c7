//! Texts of lists that have the entries of all lists of a loop, one list after the other.

use super::{parameter_text::Texts, running_index::running_index};
use crate::graph::{
    Graph, ParameterId,
    index::{Index, IndexId, LoopId, LoopSet},
};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

impl Texts<'_> {
    /// The number of all entries of the lists of a loop; `rows` are the number of lists and the length of each.
    pub(crate) fn total_of(&mut self, graph: &mut Graph, rows: [IndexId; 2], by: LoopId) -> Option<ParameterId> {
        let [count, length] = [self.text_of(graph, rows[0])?, self.text_of(graph, rows[1])?];
        let by = running_index(by);
        Some(self.fixed(graph, quote!((0..#count).map(|#by: usize| #length).sum::<usize>())))
    }

    /// A number of each entry.
    pub(crate) fn entry_of(
        &mut self,
        graph: &mut Graph,
        number: ParameterId,
        rows: [IndexId; 2],
        loops: [LoopId; 2],
        entries: LoopId,
    ) -> Option<ParameterId> {
        if !is_of(graph.loops.of_parameter(number), loops) {
            return None;
        }
        let (text, own) = (self.is_plain_number(number).then(|| self.text(number))?, self.own_text(number));
        let entry = self.of_entries(graph, &text, rows, loops, entries)?;
        self.show(entry, &own);
        graph.declare_missing_like(entry, number);
        Some(entry)
    }

    /// An index for each entry.
    pub(crate) fn list_of(
        &mut self,
        graph: &mut Graph,
        index: IndexId,
        rows: [IndexId; 2],
        loops: [LoopId; 2],
        entries: LoopId,
    ) -> Option<ParameterId> {
        if !is_of(graph.loops.of_index(index), loops) {
            return None;
        }
        let text = self.text_of(graph, index)?;
        let list = self.of_entries(graph, &text, rows, loops, entries)?;
        self.show(list, &text);
        Some(list)
    }

    fn of_entries(
        &mut self,
        graph: &mut Graph,
        text: &TokenStream,
        rows: [IndexId; 2],
        loops: [LoopId; 2],
        entries: LoopId,
    ) -> Option<ParameterId> {
        let [count, length] = [self.text_of(graph, rows[0])?, self.text_of(graph, rows[1])?];
        let (root, [by, inner]) = (self.root, loops.map(running_index));
        let code = quote!(#root::__private::entries(#count, &|#by: usize| #length, &|#by: usize, #inner: usize| #text));
        let index = running_index(entries);
        Some(self.list(graph, quote!((#code)[#index]), LoopSet::of(entries), code))
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

/// Whether a text depends on the indices of these loops alone.
fn is_of(own: LoopSet, loops: [LoopId; 2]) -> bool {
    own.is_subset(LoopSet::of(loops[0]).union(LoopSet::of(loops[1])))
}
