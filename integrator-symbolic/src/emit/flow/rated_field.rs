//! The vector field of `(H + B)/Ω`, for implicit methods in a fictitious time: the user's rate function is `Ω`, and `-B` the energy.

use super::{
    Flow,
    field::{argument_types, field},
};
use crate::{
    emit::printer::{block::Emitter, frame::Frame, function::Body},
    graph::{NodeId, Part},
    pattern::stores::lower_roots,
};
use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

/// The items of the runtime's `RatedField`.
pub(crate) fn items(emitter: &mut Emitter<'_>, rate: NodeId, arguments: &[TokenStream]) -> TokenStream {
    let energy = emitter.model.energy();
    let values = [value(emitter, "energy_at", energy), value(emitter, "rate_at", rate)];
    // No energy here reads the explicit time, whose leaf stands for `B`.
    let graph = &mut emitter.model.graph;
    let time = graph.time();
    let sum = graph.add(energy, time);
    let paced = graph.div(sum, rate);
    let field = field(graph, paced);
    let lines = Flow::lines_along(emitter, &field, Part::Momentum, &Frame::Apart);
    let scalar = &emitter.names.scalar;
    let body = Body::new(lines.map(|lines| quote!(let (step, time) = (#scalar::of(1.0), conjugate); #lines)).tokens);
    let [motion, moved] = ["motion", "moved"].map(|name| body.argument(name));
    let [generics, read_by, moved_by] = argument_types(emitter.names);
    let body = &body.0;
    quote! {
        #(#values)*

        fn stated_rate(&self, q: &Self::Coords) -> f64 { Self::rate(#(#arguments),*) }

        #[inline(always)]
        fn along_rated_field #generics(#motion: #read_by, #moved: #moved_by, conjugate: #scalar) { #body }
    }
}

/// The function that returns a value at a point.
fn value(emitter: &mut Emitter<'_>, name: &str, node: NodeId) -> TokenStream {
    let node = lower_roots(emitter.model, &[node])[0];
    let body = Body::new(emitter.value(&Frame::Apart, node).tokens);
    let (name, motion) = (Ident::new(name, Span::call_site()), body.argument("motion"));
    let [generics, read_by, _] = argument_types(emitter.names);
    let (body, scalar) = (&body.0, &emitter.names.scalar);
    quote! {
        #[inline(always)]
        fn #name #generics(#motion: #read_by) -> #scalar { #body }
    }
}
