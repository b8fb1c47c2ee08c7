//! The derivatives of both energies of `H = T(p) + V(q)` with respect to the parameters in `sensitive(...)`, for gradients.

use super::Flows;
use crate::{
    emit::printer::{block::Emitter, frame::Frame, function::Body},
    graph::NodeId,
    pattern::stores::lower_roots,
    program::{Sink, Store},
};
use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

/// The functions that add a multiple of these derivatives to a list; nothing without parameters, or for other H.
pub(crate) fn items(flows: &Flows, emitter: &mut Emitter<'_>, energies: [NodeId; 2]) -> Option<TokenStream> {
    let model = &emitter.model;
    if model.sensitive.is_empty() || !model.is_separable() || model.jacobi().is_some() {
        return None;
    }
    let [kinetic, potential] = [("kinetic", energies[0]), ("potential", energies[1])]
        .map(|(part, energy)| function(flows, emitter, &format!("add_slopes_of_{part}"), energy));
    Some(quote! {
        const ENERGIES_HAVE_SLOPES: bool = true;
        #kinetic
        #potential
    })
}

/// The function for one energy; nothing if it has no parameters.
fn function(flows: &Flows, emitter: &mut Emitter<'_>, name: &str, energy: NodeId) -> Option<TokenStream> {
    let graph = &mut emitter.model.graph;
    let slopes: Vec<_> = emitter.model.sensitive.iter().map(|by| graph.by_parameter(energy, *by)).collect();
    let stores = lower_roots(emitter.model, &slopes).into_iter().enumerate();
    let stores = stores.map(|(number, value)| Store { context: Vec::new(), sink: Sink::Slope(number), value });
    let graph = &emitter.model.graph;
    let stores: Vec<_> = stores.filter(|store| graph.as_constant(store.value) != Some(0.0)).collect();
    if stores.is_empty() {
        return None;
    }
    let lines = emitter.evaluate(&Frame::Motion, &[], &stores);
    let scalar = &emitter.names.scalar;
    let lines = lines.map(|lines| {
        let lines = flows.plain(&lines);
        quote!(let step = #scalar::of(duration); #lines)
    });
    let Body(body) = lines.body(scalar);
    let (runtime, leaf) = (&emitter.names.runtime, &emitter.names.leaf);
    let body = Body::new(body);
    let (motion, time) = (body.argument("motion"), body.argument("time"));
    let (name, body) = (Ident::new(name, Span::call_site()), &body.0);
    Some(quote! {
        #[inline(always)]
        fn #name<#scalar: #runtime::Real, #leaf: #runtime::Precision>(
            #motion: &Self::Motion<#scalar, #leaf>,
            duration: f64,
            #time: f64,
            slopes: &mut [#scalar],
        ) { #body }
    })
}
