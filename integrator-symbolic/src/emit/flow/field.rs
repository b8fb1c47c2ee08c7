//! The vector field of the whole `H`.

use super::Flow;
use crate::{
    differentiate::gradient,
    emit::printer::{block::Emitter, frame::Frame},
    graph::Part,
    model::Length,
};
use proc_macro2::TokenStream;
use quote::quote;

/// The most coordinates of an H = T + V with a field of its own: its loops over pairs are as the user wrote them.
const MOST_COORDINATES: u64 = 32;

/// The field, where flows of `T` and of `V` do not determine it, or where it is faster than they are, for implicit methods.
pub(crate) fn items(emitter: &mut Emitter<'_>, is_restated: bool) -> Option<TokenStream> {
    let model = &emitter.model;
    if !model.is_separable() || model.jacobi().is_some() {
        return Some(function(emitter));
    }
    let lengths = std::iter::once(&model.shape.length).chain(model.shape.dimension());
    let count = lengths.map(|length| if let Length::Literal(length) = length { *length } else { u64::MAX });
    let is_small = count.fold(1, u64::saturating_mul) <= MOST_COORDINATES;
    (is_small && model.autonomous && !is_restated).then(|| {
        let function = function(emitter);
        quote! {
            const HAS_FIELD: bool = true;
            #function
        }
    })
}

/// The function that moves coordinates along the field at others.
fn function(emitter: &mut Emitter<'_>) -> TokenStream {
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
