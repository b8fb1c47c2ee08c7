//! Rust code for a part of H in which many bodies act on each other in pairs: rows of bodies beside the state.

use super::{Flow, Flows, pairs::ManyBody};
use crate::{
    emit::printer::{block::Emitter, function::Body},
    graph::NodeId,
    layout::Form,
    pattern::{all_pairs::AllPairs, stores::lower_roots},
    syntax::names::Names,
};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

/// A part that is a sum over pairs.
pub(crate) struct PartOfPairs {
    /// The type that stands for the part in the runtime.
    kind: Ident,
    many_body: ManyBody,
    /// Where a motion keeps its rows of bodies.
    pub(super) solver: TokenStream,
}

impl PartOfPairs {
    pub(super) fn many_body(&self) -> &ManyBody {
        &self.many_body
    }
}

/// The flow of a part of positions, if it is a sum over pairs of many bodies.
pub(super) fn flow(emitter: &mut Emitter<'_>, number: usize) -> Option<Flow> {
    let energy = emitter.model.parts[number].energy;
    let pairs = AllPairs::of_part(emitter.model, energy)?;
    let many_body = ManyBody::of(emitter, &pairs);
    let Names { runtime, scalar, leaf, part, .. } = emitter.names;
    let (kind, [d, s]) = (format_ident!("{part}{number}"), many_body.sizes());
    let body = quote! {
        solver.kick::<#runtime::Shaped<Self, #leaf>>(&motion.q, &mut motion.p, duration, time);
    };
    let solver = quote!(#runtime::PartOfBodies<#kind, #scalar, #d, #s>);
    let [_, form] = Form::of_bodies(many_body.listed(), false, many_body.has_triplets());
    let pairs = PartOfPairs { kind, many_body, solver: TokenStream::new() };
    Some(Flow {
        body: Body::new(body),
        form,
        is_wide: true,
        is_large: true,
        solver: Some(solver),
        pairs: Some(pairs),
        ..Flow::default()
    })
}

impl Flows {
    /// What the types of such parts implement of the runtime.
    pub(crate) fn of_parts_of_pairs(
        &self,
        parameters: &TokenStream,
        coordinates: &TokenStream,
        names: &Names,
    ) -> TokenStream {
        let Names { runtime, scalar, .. } = names;
        let parts = self.all().filter_map(|flow| flow.pairs.as_ref());
        let of = |PartOfPairs { kind, many_body, .. }: &PartOfPairs| {
            let ([d, s], [functions, per_body]) = (many_body.sizes(), many_body.of_part());
            quote! {
                /// A part of H that is a sum over pairs.
                pub struct #kind;

                impl #runtime::OfBodies for #kind {
                    type Coords = #coordinates;
                    type Parameters<#scalar: #runtime::Real> = #parameters;
                }
                impl #runtime::ManyBody<#d, #s> for #kind { #functions }
                impl #runtime::PartConstants<#s> for #kind { #per_body }
            }
        };
        parts.map(of).collect()
    }

    /// The function that returns an energy of parts, if the runtime sums one of them.
    pub(super) fn energy_of_parts(
        &self,
        emitter: &mut Emitter<'_>,
        name: &str,
        energies: &[NodeId],
    ) -> Option<TokenStream> {
        let flows = self.all().zip(energies).enumerate();
        let flows = flows.filter(|(number, _)| (*number == 0) == (name == "kinetic"));
        let Names { runtime, leaf, .. } = emitter.names;
        let (mut sums, mut beside) = (Vec::new(), emitter.model.graph.constant(0.0));
        for (_, (flow, energy)) in flows {
            let of_flow = flow.pairs.as_ref().map(|pairs| (pairs, pairs.many_body.energy("potential")));
            let other = match of_flow {
                Some((PartOfPairs { solver, .. }, (true, others))) => {
                    sums.push(quote!(#solver.energy::<#runtime::Shaped<Self, #leaf>>(&motion.q, time)));
                    others
                }
                _ => Some(*energy),
            };
            beside = other.map_or(beside, |other| emitter.model.graph.add(beside, other));
        }
        if sums.is_empty() {
            return None;
        }
        if emitter.model.graph.as_constant(beside) != Some(0.0) {
            let beside = lower_roots(emitter.model, &[beside])[0];
            let Body(lines) = emitter.value_in_lanes(beside).0.body(&emitter.names.scalar);
            sums.push(quote!({ #lines }));
        }
        Some(Body::new(quote!(#(#sums)+*)).energy(name, emitter.names))
    }
}
