//! The vector field of the whole `H`.

use super::Flow;
use crate::{
    differentiate::{Contribution, gradient},
    emit::printer::{block::Emitter, frame::Frame},
    graph::{Graph, NodeId, Part},
    model::Length,
    syntax::names::Names,
};
use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

/// The most coordinates of an H = T + V with a field of its own: its loops over pairs are as the user wrote them.
const MOST_COORDINATES: u64 = 32;

/// The field, where flows of `T` and of `V` do not determine it, or where it is faster than they are, for implicit methods.
pub(crate) fn items(emitter: &mut Emitter<'_>, is_restated: bool) -> Option<TokenStream> {
    let model = &emitter.model;
    if !model.is_separable() || model.jacobi().is_some() {
        let energy = emitter.model.energy();
        let field = field(&mut emitter.model.graph, energy);
        return Some(function(emitter, "along_field", &field, Part::Momentum));
    }
    let lengths = std::iter::once(&model.shape.length).chain(model.shape.dimension());
    let count = lengths.map(|length| if let Length::Literal(length) = length { *length } else { u64::MAX });
    let is_small = count.fold(1, u64::saturating_mul) <= MOST_COORDINATES;
    (is_small && model.autonomous && !is_restated).then(|| {
        let [kinetic, potential] = [emitter.model.kinetic, emitter.model.potential];
        let velocity = gradient(&mut emitter.model.graph, kinetic, Part::Momentum);
        let force = gradient(&mut emitter.model.graph, potential, Part::Position);
        let velocity = function(emitter, "along_velocity", &velocity, Part::Momentum);
        let force = function(emitter, "along_force", &force, Part::Position);
        quote! {
            const HAS_FIELD: bool = true;
            #velocity
            #force
        }
    })
}

/// The function that moves coordinates along a field at others, by the derivatives of an energy by a part or by their negatives.
fn function(emitter: &mut Emitter<'_>, name: &str, field: &[Contribution], part: Part) -> TokenStream {
    let body = Flow::along(emitter, field, part, &Frame::Apart).body;
    let [motion, moved, duration, time] = ["motion", "moved", "duration", "time"].map(|name| body.argument(name));
    let [generics, read_by, moved_by] = argument_types(emitter.names);
    let (name, body) = (Ident::new(name, Span::call_site()), &body.0);
    quote! {
        #[inline(always)]
        fn #name #generics(
            #motion: #read_by,
            #moved: #moved_by,
            #duration: f64,
            #time: f64,
        ) { #body }
    }
}

/// The generics of functions that read coordinates apart from those that they move, and the types of these two arguments.
pub(super) fn argument_types(names: &Names) -> [TokenStream; 3] {
    let Names { runtime, scalar, leaf, .. } = names;
    [
        quote!(<#scalar: #runtime::Real, #leaf: #runtime::Precision>),
        quote!(#runtime::ReadBy<'_, Self, #scalar, #leaf>),
        quote!(#runtime::MovedBy<'_, Self, #scalar, #leaf>),
    ]
}

/// The field of an energy: both halves share what they compute.
pub(super) fn field(graph: &mut Graph, energy: NodeId) -> Vec<Contribution> {
    let velocity = gradient(graph, energy, Part::Momentum);
    let mut field = gradient(graph, energy, Part::Position);
    field.iter_mut().for_each(|contribution| contribution.value = graph.neg(contribution.value));
    field.extend(velocity);
    field
}
