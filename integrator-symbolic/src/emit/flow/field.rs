//! The vector field of the whole `H`, if it cannot be taken from flows of `T` and `V`.

use super::Flow;
use crate::{
    differentiate::gradient,
    emit::printer::{block::Emitter, frame::Frame},
    graph::Part,
};
use proc_macro2::TokenStream;
use quote::quote;

/// The function that moves coordinates along the field at others.
pub(crate) fn function(emitter: &mut Emitter<'_>) -> TokenStream {
    let body = along_field(emitter).body;
    let names = emitter.names;
    let [motion, moved, duration, time] = ["motion", "moved", "duration", "time"].map(|name| body.argument(name));
    let (body, runtime, scalar, leaf) = (&body.0, &names.runtime, &names.scalar, &names.leaf);
    quote! {
        #[inline(always)]
        fn along_field<#scalar: #runtime::Real, #leaf: #runtime::Precision>(
            #motion: #runtime::ReadBy<'_, Self, #scalar, #leaf>,
            #moved: #runtime::MovedBy<'_, Self, #scalar, #leaf>,
            #duration: f64,
            #time: f64,
        ) { #body }
    }
}

/// The motion along the field of H, of coordinates that it does not read: both halves share what they compute.
fn along_field(emitter: &mut Emitter<'_>) -> Flow {
    let [first, others] = [emitter.model.kinetic, emitter.model.potential];
    let graph = &mut emitter.model.graph;
    let energy = graph.add(first, others);
    let velocity = gradient(graph, energy, Part::Momentum);
    let mut field = gradient(graph, energy, Part::Position);
    field.iter_mut().for_each(|contribution| contribution.value = graph.neg(contribution.value));
    field.extend(velocity);
    Flow::along(emitter, &field, Part::Momentum, &Frame::Apart)
}
