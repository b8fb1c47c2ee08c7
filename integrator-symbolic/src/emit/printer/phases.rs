//! Rust code for loops over rows in three phases: the sums of each row, functions of these in lanes, and what follows from them.

use super::{
    block::{Accumulation, Block},
    fields::Fields,
};
use crate::{
    graph::{NodeId, index::LoopId},
    program::{Item, phases::Phases},
    syntax::names::Names,
};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

impl Block<'_> {
    /// The phases of a loop among other lines, if it has some here.
    pub(super) fn phases<'p>(&self, beside: &[Item], item: &'p Item) -> Option<Phases<'p>> {
        let is_plain = self.masks.is_empty() && matches!(self.accumulation, Accumulation::Fused);
        self.lanes.filter(|_| is_plain)?.phases(beside, item)
    }

    /// The three loops, with the beginning of the sums of the second one.
    pub(super) fn in_phases(&mut self, fields: &mut Fields, by: LoopId, phases: &Phases<'_>) -> TokenStream {
        let Names { runtime, scalar, kept, results, .. } = self.names;
        let Phases { before, kept: sums, middle, given, after } = phases;
        let to = self.printer.graph.loops.get(by).to;
        let (to, index) = (self.printer.index(fields, to), self.printer.running.get(&by).cloned());
        let values_of = |count: usize| {
            let values = (0..count).map(|_| quote!(#runtime::repeated(#to, #scalar::of(0.0))));
            quote!([#(#values),*])
        };
        let (all_sums, all_results) = (values_of(sums.len()), values_of(middle.results.len()));
        let place_of = |id: &NodeId| {
            let (list, number) = match middle.results.iter().position(|result| result == id) {
                Some(number) => (results, number),
                None => (kept, sums.iter().position(|sum| sum == id).unwrap_or_default()),
            };
            let number = Literal::usize_unsuffixed(number);
            quote!(#list[#number])
        };
        let before = owned(before);
        let first = match self.inner_products(fields, by, (&before, sums), &quote!(&mut #kept[0])) {
            Some(call) => call,
            None => {
                let lines = self.items(fields, &before);
                let keeps = sums.iter().map(|id| {
                    let (place, name) = (place_of(id), &self.printer.names[id]);
                    quote!(#place[#index] = #name;)
                });
                let keeps: TokenStream = keeps.collect();
                self.printer.loop_over(fields, by, &quote!(#lines #keeps))
            }
        };
        let second = self.in_lanes(fields, by, middle);
        let results_begin = (!middle.results.is_empty()).then(|| quote!(let mut #results = #all_results;));
        let third = (!after.is_empty()).then(|| {
            let after = owned(after);
            let list = |id| given.contains(&id).then(|| place_of(&id)).map(|place| quote!(&#place));
            if let Some(call) = self.multiples_of_rows(fields, by, &after, list) {
                return call;
            }
            let lines = self.items(fields, &after);
            let reads = given.iter().map(|id| {
                let (place, name) = (place_of(id), &self.printer.names[id]);
                quote!(let #name = #place[#index];)
            });
            self.printer.loop_over(fields, by, &quote!(#(#reads)* #lines))
        });
        quote!(let mut #kept = #all_sums; #first #results_begin #second #third)
    }
}

fn owned(lines: &[&Item]) -> Vec<Item> {
    lines.iter().map(|line| (*line).clone()).collect()
}
