//! Friction: the functions from which the runtime prepares the factors of the letter `O`.

use super::Flow;
use crate::{
    differentiate::gradient,
    emit::printer::{block::Emitter, frame::Frame},
    graph::{NodeId, Part},
    model::Rates,
    syntax::{Friction, RateFunction},
};
use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

/// The items of the runtime's `WithFriction`.
pub(crate) fn items(emitter: &mut Emitter<'_>, friction: &Rates, stated: &Friction) -> TokenStream {
    let call = |RateFunction { name, reads_time }: &RateFunction| {
        let time = reads_time.then(|| quote!(, time));
        quote!(self.#name(index #time))
    };
    let stated = [Some(&stated.rate), stated.temperature.as_ref()];
    let stated = stated.map(|function| function.map_or(quote!(0.0), call));
    let rates = function(emitter, "add_rates", friction.rates, Part::Position);
    let temperatures =
        friction.temperatures.map(|energy| function(emitter, "add_temperatures", energy, Part::Position));
    let velocities = friction.temperatures.map(|_| {
        let energy = emitter.model.energy();
        function(emitter, "add_velocities", energy, Part::Momentum)
    });
    let runtime = &emitter.names.runtime;
    let (scalar, leaf) = (&emitter.names.scalar, &emitter.names.leaf);
    let reads_time = friction.read_time.then(|| {
        quote!(
            const READS_TIME: bool = true;
        )
    });
    quote! {
        #reads_time
        type Wide<#scalar: #runtime::Real> = <Self::Motion<#scalar, f64> as #runtime::Momenta<#scalar, f64>>::Wide;

        #[inline(always)]
        fn momenta<#scalar: #runtime::Real, #leaf: #runtime::Precision>(
            motion: &mut Self::Motion<#scalar, #leaf>,
        ) -> &mut [#leaf::Slot<Self::Wide<#scalar>>] {
            #runtime::Momenta::<#scalar, #leaf>::momenta(motion)
        }
        fn coordinate<#scalar: #runtime::Real>(slot: usize, part: usize) -> usize {
            <Self::Motion<#scalar, f64> as #runtime::Momenta<#scalar, f64>>::coordinate(slot, part)
        }
        fn stated_rates(&self, index: usize, time: f64) -> [f64; 2] { [#(#stated),*] }
        #rates
        #temperatures
        #velocities
    }
}

/// The function that adds a gradient to the conjugate coordinates.
fn function(emitter: &mut Emitter<'_>, name: &str, energy: NodeId, part: Part) -> TokenStream {
    let gradient = gradient(&mut emitter.model.graph, energy, part);
    let lines = Flow::lines_along(emitter, &gradient, part, &Frame::Motion);
    let (runtime, scalar, leaf) = (&emitter.names.runtime, &emitter.names.scalar, &emitter.names.leaf);
    let body = lines.map(|lines| quote!(let step = #scalar::of(1.0); #lines)).body(scalar);
    let ([motion, time], body) = (["motion", "time"].map(|name| body.argument(name)), &body.0);
    let name = Ident::new(name, Span::call_site());
    quote! {
        fn #name<#scalar: #runtime::Real, #leaf: #runtime::Precision>(
            #motion: &mut #runtime::PlainMotion<Self, #scalar, #leaf>,
            #time: f64,
        ) { #body }
    }
}
