//! Tables of numbers that the user wrote in the terms of a series.

use super::parameter_text::Texts;
use crate::{
    graph::{Graph, ParameterId, index::LoopId},
    model::parameters::running_index::running_index,
};
use proc_macro2::{Ident, TokenStream};
use quote::quote;

/// How many numbers at the beginning of a table are shown to people; more where two tables would look the same.
const SHOWN: usize = 2;

impl Texts<'_> {
    /// The parameter with the numbers of a table in the iterations of a loop. People see the first numbers and the last one.
    pub(crate) fn of_numbers(
        &mut self,
        graph: &mut Graph,
        by: LoopId,
        table: &Ident,
        literals: &[TokenStream],
    ) -> ParameterId {
        self.name_apart(by);
        let index = running_index(by);
        let id = self.of_index(graph, by, |index| quote!(#table[#index]));
        let Some((last, first)) = literals.split_last() else { return id };
        let mut shown = (SHOWN..first.len()).map(|count| {
            let first = &first[..count];
            quote!([#(#first,)* .., #last][#index])
        });
        let text = shown.find(|text| !self.is_shown(text, id)).unwrap_or_else(|| self.text(id));
        self.show(id, &text);
        id
    }
}
