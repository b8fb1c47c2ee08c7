//! Series that are written out: a model with loops over tables in their place.

use crate::{
    graph::{Graph, NodeId, exact::Exact, index::LoopId},
    model::{Model, Texts, values::integer::number_literal},
};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};
use std::collections::HashMap;

impl Model {
    /// Replaces terms that differ in their numbers alone by loops over tables. What exact flows are solved with remains as it
    /// is.
    pub(crate) fn replace_series_by_loops(&mut self) {
        if self.jacobi().is_some() {
            return;
        }
        let is_solved = |form: &Exact| !matches!(form, Exact::OfPositions | Exact::OfMomenta);
        let solved = self.parts.iter().filter(|part| is_solved(&part.form)).map(|part| part.energy);
        let kept: Vec<NodeId> = self.quadratic.then_some(self.kinetic).into_iter().chain(solved).collect();
        let roots: Vec<NodeId> = self.values().map(|value| *value).collect();
        let Self { graph, parameters, running, root, tables, .. } = &mut *self;
        let mut texts = Texts::new(parameters, running, root);
        let mut names: HashMap<String, Ident> = HashMap::new();
        let mut table = |graph: &mut Graph, by: LoopId, numbers: &[f64]| {
            let literals: Vec<TokenStream> = numbers.iter().map(|number| signed_literal(*number)).collect();
            let (values, length) = (quote!([#(#literals),*]), Literal::usize_unsuffixed(numbers.len()));
            let name = names.entry(values.to_string()).or_insert_with(|| {
                let name = format_ident!("__TABLE_{}", tables.len());
                tables.push(quote!(static #name: [f64; #length] = #values;));
                name
            });
            texts.of_numbers(graph, by, name, &literals)
        };
        let known = graph.with_series_as_loops(&roots, &kept, &mut table);
        if !known.is_empty() {
            self.values().for_each(|value| *value = known[value]);
        }
    }

    /// The energies, and what else is computed from coordinates.
    fn values(&mut self) -> impl Iterator<Item = &mut NodeId> {
        let parts = self.parts.iter_mut().flat_map(|part| {
            let functions = part.functions.iter_mut().map(|function| &mut function.energy);
            functions.chain([&mut part.energy])
        });
        let rate = self.rate.iter_mut().map(|(rate, _)| rate);
        let invariants = self.invariants.iter_mut().map(|invariant| &mut invariant.value);
        [&mut self.kinetic, &mut self.potential].into_iter().chain(parts).chain(rate).chain(invariants)
    }
}

/// A finite number with its sign.
fn signed_literal(number: f64) -> TokenStream {
    let literal = number_literal(number.abs());
    if number.is_sign_negative() { quote!(-#literal) } else { quote!(#literal) }
}
