//! Texts of lists that have the entries of all lists of a loop, one list after the other.

use super::{parameter_text::Texts, running_index::running_index};
use crate::graph::{
    Element, Graph, ParameterId,
    index::{Index, IndexId, LoopId, LoopSet},
};
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

/// The entries of the lists of a loop.
#[derive(Clone, Copy)]
pub(crate) struct Entries {
    /// The number of lists and the length of each.
    pub(crate) rows: [IndexId; 2],
    /// The loops over the lists and over the entries of each.
    pub(crate) loops: [LoopId; 2],
    /// The index of the first entry of each list.
    pub(crate) from: IndexId,
}

impl Entries {
    /// Whether something depends on the index of a list or of an entry.
    pub(crate) fn has(self, own: LoopSet) -> bool {
        self.loops.into_iter().any(|by| own.contains(by))
    }

    /// Whether a coordinate is one of a point with such an index, by components that do not depend on it.
    pub(crate) fn is_point(self, graph: &Graph, element: Element) -> bool {
        element.component.is_none_or(|component| !self.has(graph.loops.of_index(component)))
    }

    /// Whether a text depends on the indices of a list and of an entry alone.
    fn are_of(self, own: LoopSet) -> bool {
        own.is_subset(LoopSet::of(self.loops[0]).union(LoopSet::of(self.loops[1])))
    }
}

impl Texts<'_> {
    /// The number of all entries.
    pub(crate) fn total_of(&mut self, graph: &mut Graph, entries: Entries) -> Option<ParameterId> {
        let [count, length] = [self.text_of(graph, entries.rows[0])?, self.text_of(graph, entries.rows[1])?];
        let by = running_index(entries.loops[0]);
        Some(self.fixed(graph, quote!((0..#count).map(|#by: usize| #length).sum::<usize>())))
    }

    /// A number of each entry, in a loop over all of them.
    pub(crate) fn entry_of(
        &mut self,
        graph: &mut Graph,
        number: ParameterId,
        entries: Entries,
        all: LoopId,
    ) -> Option<ParameterId> {
        let text = self.number_of_entry(graph, number, entries)?;
        let own = self.own_text(number);
        let (code, index) = (self.of_all(graph, entries, "entries", &[text])?, running_index(all));
        let entry = self.list(graph, quote!((#code)[#index]), LoopSet::of(all), code);
        self.show(entry, &own);
        graph.declare_like(entry, number);
        Some(entry)
    }

    /// An index of each entry, in a loop over all of them.
    pub(crate) fn list_of(
        &mut self,
        graph: &mut Graph,
        index: IndexId,
        entries: Entries,
        all: LoopId,
    ) -> Option<ParameterId> {
        let text = self.index_of_entry(graph, index, entries)?;
        let code = self.of_all(graph, entries, "entries", std::slice::from_ref(&text))?;
        let own = running_index(all);
        let list = self.list(graph, quote!((#code)[#own]), LoopSet::of(all), code);
        self.show(list, &text);
        Some(list)
    }

    /// The number of pairs that entries name by two indices, in either order.
    pub(crate) fn count_of_pairs(
        &mut self,
        graph: &mut Graph,
        pair: [IndexId; 2],
        entries: Entries,
    ) -> Option<ParameterId> {
        let pair = self.pair_of_entry(graph, pair, entries)?;
        let code = self.of_all(graph, entries, "distinct_pairs", &[pair])?;
        Some(self.fixed(graph, quote!((#code).len())))
    }

    /// An index of each of these pairs, in a loop over them.
    pub(crate) fn member_of_pair(
        &mut self,
        graph: &mut Graph,
        pair: [IndexId; 2],
        member: usize,
        entries: Entries,
        all: LoopId,
    ) -> Option<ParameterId> {
        let shown = self.text_of(graph, pair[member])?;
        let pair = self.pair_of_entry(graph, pair, entries)?;
        let code = self.of_all(graph, entries, "distinct_pairs", &[pair])?;
        let (index, member) = (running_index(all), Literal::usize_unsuffixed(member));
        let list = self.list(graph, quote!((#code)[#index][#member]), LoopSet::of(all), code);
        self.show(list, &shown);
        Some(list)
    }

    /// The sum of a number of all entries that name a pair, in a loop over the pairs; without a number, how many name it.
    pub(crate) fn weight_of_pair(
        &mut self,
        graph: &mut Graph,
        pair: [IndexId; 2],
        number: Option<ParameterId>,
        entries: Entries,
        all: LoopId,
    ) -> Option<ParameterId> {
        let (text, own) = match number {
            Some(number) => (self.number_of_entry(graph, number, entries)?, self.own_text(number)),
            None => (quote!(1.0), quote!(visits)),
        };
        let pair = self.pair_of_entry(graph, pair, entries)?;
        let (code, index) = (self.of_all(graph, entries, "weights", &[pair, text])?, running_index(all));
        let weight = self.list(graph, quote!((#code)[#index]), LoopSet::of(all), code);
        self.show(weight, &own);
        Some(weight)
    }

    fn number_of_entry(&self, graph: &Graph, number: ParameterId, entries: Entries) -> Option<TokenStream> {
        let is_of_entry = entries.are_of(graph.loops.of_parameter(number)) && self.is_plain_number(number);
        is_of_entry.then(|| self.text(number))
    }

    fn index_of_entry(&self, graph: &Graph, index: IndexId, entries: Entries) -> Option<TokenStream> {
        if !entries.are_of(graph.loops.of_index(index)) {
            return None;
        }
        self.text_of(graph, index)
    }

    fn pair_of_entry(&self, graph: &Graph, [a, b]: [IndexId; 2], entries: Entries) -> Option<TokenStream> {
        let (a, b) = (self.index_of_entry(graph, a, entries)?, self.index_of_entry(graph, b, entries)?);
        Some(quote!([#a, #b]))
    }

    /// The call of a function of the runtime with functions of each entry.
    fn of_all(
        &self,
        graph: &Graph,
        Entries { rows, loops, from }: Entries,
        function: &str,
        of_entry: &[TokenStream],
    ) -> Option<TokenStream> {
        let [count, length] = [self.text_of(graph, rows[0])?, self.text_of(graph, rows[1])?];
        let (root, [by, inner], function) = (self.root, loops.map(running_index), format_ident!("{function}"));
        // Entries are counted from zero.
        let shift = match graph.loops.literal(from) {
            Some(0) => None,
            _ => {
                let from = self.text_of(graph, from)?;
                Some(quote!(let #inner = #from + #inner;))
            }
        };
        let of_entry = of_entry.iter().map(|text| match &shift {
            None => quote!(&|#by: usize, #inner: usize| #text),
            Some(shift) => quote!(&|#by: usize, #inner: usize| { #shift #text }),
        });
        Some(quote!(#root::__private::#function(#count, &|#by: usize| #length, #(#of_entry),*)))
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
            Index::Monus(a, b) => {
                let (a, b) = (of(a)?, of(b)?);
                quote!(#a.saturating_sub(#b))
            }
            Index::Min(a, b) => {
                let (a, b) = (of(a)?, of(b)?);
                quote!(::core::cmp::Ord::min(#a, #b))
            }
            _ => return None,
        })
    }
}
