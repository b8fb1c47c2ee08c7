//! Rust code for functions with bodies as arguments.

use crate::{
    emit::printer::{
        block::Emitter,
        fields::Fields,
        frame::{Bodies, Frame},
        function::Lines,
    },
    graph::{NodeId, index::LoopId},
    model::Model,
    pattern::bodies::{Constants, OfBodies},
    program::Constraints,
};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

impl Constants {
    /// What a prepared constant of a body is called.
    fn name(&self, model: &Model, fields: &mut Fields, place: usize, by: LoopId) -> Ident {
        let name = match self.densities.iter().position(|density| *density == place) {
            Some(number) => format!("density_{number}_of"),
            None => format!("{}_of", fields.number(&model.graph, &model.parameters, self.nodes[place])),
        };
        OfBodies::name_of(&name, model, by)
    }

    /// Those of the body with an index, read from the struct of prepared constants; zeros for what the runtime computes.
    pub(crate) fn of_body(
        &self,
        model: &Model,
        fields: &mut Fields,
        from: &TokenStream,
        index: &Ident,
    ) -> Vec<TokenStream> {
        let of = |(place, id): (usize, &NodeId)| match self.densities.contains(&place) {
            true => quote!(0.0),
            false => {
                let field = fields.number(&model.graph, &model.parameters, *id);
                quote!(#from.#field[#index])
            }
        };
        self.nodes.iter().enumerate().map(of).collect()
    }
}

impl OfBodies {
    /// The name of something that belongs to a body.
    pub(crate) fn name_of(what: &str, model: &Model, by: LoopId) -> Ident {
        format_ident!("{what}{}", Self::suffix(model, by))
    }

    fn suffix(model: &Model, by: LoopId) -> String {
        model.running.get(&by).map_or_else(String::new, |index| format!("_{index}"))
    }

    /// Names for what it reads of the prepared constants of its bodies.
    fn constants(&self, model: &Model, fields: &mut Fields, constants: &Constants) -> TokenStream {
        let mut reads: Vec<_> = self.reads.iter().map(|(_, by, place)| (*place, *by)).collect();
        reads.sort();
        reads.dedup();
        let lets = reads.into_iter().map(|(place, by)| {
            let (name, of) = (constants.name(model, fields, place, by), Self::name_of("constants", model, by));
            let place = Literal::usize_unsuffixed(place);
            quote!(let #name = #of[#place];)
        });
        lets.collect()
    }

    /// The lines of the function.
    pub(crate) fn lines(&self, emitter: &mut Emitter<'_>, constants: &Constants) -> Lines {
        let Emitter { model, fields, .. } = emitter;
        let suffixes = self.of.iter().map(|by| (*by, Self::suffix(model, *by)));
        let reads = self.reads.iter().map(|(id, by, place)| (*id, constants.name(model, fields, *place, *by)));
        let bodies = Bodies { suffixes: suffixes.collect(), constants: reads.collect() };
        let constants = self.constants(model, fields, constants);
        let constraints = Constraints { selects: true, ..Constraints::default() };
        let lines = emitter.evaluate_with(&Frame::Bodies(bodies), &self.of, &self.stores, &constraints);
        lines.map(|lines| quote!(#constants #lines))
    }
}
