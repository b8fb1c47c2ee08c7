//! Loops with bounds from lists: their largest extent is computed once per run, from the lists themselves.

use crate::graph::{
    ParameterId,
    index::{Index, IndexId, LoopSet},
};
use crate::model::{Reader, parameters::running_index::running_index};
use proc_macro2::TokenStream;
use quote::quote;

impl Reader<'_> {
    /// States how large the values of lists in a bound may be, whatever the indices of loops are.
    pub(crate) fn bound_lists(&mut self, bound: IndexId) {
        let index = self.graph.loops.index(bound);
        for operand in index.operands().into_iter().flatten() {
            self.bound_lists(operand);
        }
        if let Index::Parameter(id) = index
            && !self.graph.loops.of_parameter(id).is_empty()
            && self.graph.loops.range_of(id).is_none()
        {
            let values = self.values_over_loops(id);
            let text = quote!(::core::option::Option::unwrap_or(::core::iter::Iterator::max(#values), 0));
            // The values bring the arms around them.
            let arms = std::mem::take(&mut self.arms);
            let greatest = self.parameter(text, "integer", LoopSet::EMPTY);
            self.arms = arms;
            let greatest = self.graph.loops.intern(Index::Parameter(greatest));
            // A least value would be requested at every element of a table; lists begin at zero nearly always.
            let least = self.literal_index(0);
            self.graph.loops.declare_range(id, least, greatest);
        }
    }

    /// An iterator over the values of a parameter for all indices of the loops that it depends on.
    fn values_over_loops(&self, id: ParameterId) -> TokenStream {
        let loops = self.graph.loops.with_outer(self.graph.loops.of_parameter(id));
        let loops: Vec<_> = loops.iter().collect();
        let value = &self.parameters[id.0 as usize].text;
        let mut text = quote!(#value);
        for (inner, by) in loops.into_iter().rev().enumerate() {
            let range = self.graph.loops.get(by);
            let (name, from, to) = (running_index(by), self.bound_text(range.from), self.bound_text(range.to));
            let adaptor = if inner == 0 { quote!(map) } else { quote!(flat_map) };
            text = quote!(::core::iter::Iterator::#adaptor(#from..#to, move |#name: usize| #text));
        }
        text
    }
}
