//! Bounds of the values of a parameter: over all bodies, or over the entries of a table by classes.

use super::{
    parameter_text::Texts,
    presence::looked_up,
    running_index::{but_for, running_index},
};
use crate::graph::{
    Graph, ParameterId,
    index::{LoopId, LoopSet},
    rename::End,
};
use proc_macro2::TokenStream;
use quote::quote;

impl Texts<'_> {
    /// The least and the greatest value of a parameter of one body, but for the body at the end without a partner.
    pub(super) fn extreme_values(
        &mut self,
        graph: &mut Graph,
        id: ParameterId,
        by: LoopId,
        end: Option<End>,
    ) -> Option<[ParameterId; 2]> {
        let (text, root, index) = (self.text(id), self.root, running_index(by));
        if !self.is_plain_number(id) || graph.loops.of_parameter(id) != LoopSet::of(by) {
            return None;
        }
        let text = looked_up(&text, root).unwrap_or(text);
        let bodies = but_for(end, &self.count);
        Some(self.both(graph, id, |name| quote!(#root::__private::#name(#bodies, &|#index: usize| #text))))
    }

    /// The least and the greatest entry of a table.
    pub(super) fn extremes_of_table(&mut self, graph: &mut Graph, table: ParameterId) -> Option<[ParameterId; 2]> {
        let text = self.text(table);
        Some(self.both(graph, table, |name| quote!(#text.#name())))
    }

    fn both(
        &mut self,
        graph: &mut Graph,
        like: ParameterId,
        text: impl Fn(TokenStream) -> TokenStream,
    ) -> [ParameterId; 2] {
        let shown = self.own_text(like);
        [quote!(least), quote!(greatest)].map(|name| {
            let id = self.fixed(graph, text(name));
            self.show(id, &shown);
            id
        })
    }
}
