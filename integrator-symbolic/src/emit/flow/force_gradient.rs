//! The force-gradient kick of a Hamiltonian with quadratic `T`: the exact flow of `b V + c |grad V|^2`.
//!
//! In: the gradient of `V`. Out: the functions of the runtime's `QuadraticKinetic`. The norm is that of the inverse
//! mass matrix `M`, so the kick is `p -= b grad V + 2 c V'' M^-1 grad V`. Always true: the product with the Hessian
//! `V''` is the derivative of the generated gradient, so the kick is symplectic to rounding.

use super::{jacobi, through_buffer};
use crate::{
    differentiate::{gradient, hessian_product},
    emit::printer::{block::Emitter, frame::Frame, function::Lines},
    graph::Part,
    pattern::stores::stores,
    program::Sink,
    syntax::names::Names,
};
use proc_macro2::TokenStream;
use quote::quote;

/// `hessian` and `gradient_kick`.
///
/// The kick is put together from the flows of a motion that starts at rest: a kick by -1 leaves it with the momenta
/// `grad V`, and the inverse mass matrix makes positions of these. Where the first part is `T` alone, a drift by 1 from
/// the origin does that.
pub(crate) fn functions(emitter: &mut Emitter<'_>, many_body: bool) -> TokenStream {
    let in_jacobi = emitter.model.jacobi().is_some();
    let potential = gradient(&mut emitter.model.graph, emitter.model.potential, Part::Position);
    let product = hessian_product(&mut emitter.model.graph, &potential, Part::Position);
    let product = stores(emitter.model, &product, Sink::Collect);
    // Nothing is written before all is read.
    let lines =
        through_buffer(emitter, &Frame::Motion, Part::Momentum, &product, |place, value| quote!(#place = #value;));
    let velocity = velocity(emitter);
    let Names { runtime, scalar, leaf, .. } = emitter.names;
    // Bodies in lanes are unpacked for results that are rarely needed.
    let lines = if many_body {
        lines.map(|lines| {
            quote! {
                let bodies = motion;
                let motion = &mut bodies.plain::<Self::Coords>();
                #lines
                bodies.set_momenta(motion);
            }
        })
    } else {
        lines
    };
    let lines = if in_jacobi { lines.map(|lines| jacobi::hessian(&lines)) } else { lines };
    let product = lines.body(scalar);
    let (motion, time, product) = (product.argument("motion"), product.argument("time"), &product.0);
    quote! {
        #[inline(always)]
        fn hessian<#scalar: #runtime::Real>(#motion: &mut Self::Motion<#scalar, f64>, #time: f64) { #product }

        #[inline(always)]
        fn gradient_kick<#scalar: #runtime::Real, #leaf: #runtime::Precision>(
            motion: &mut Self::Motion<#scalar, #leaf>,
            duration: f64,
            gradient: f64,
            time: f64,
        ) {
            let mut force = motion.at_rest();
            <Self as #runtime::System>::kick::<#scalar, f64>(&mut force, -1.0, time);
            motion.push(#scalar::of(-duration), &force);
            let mut bent = motion.at_rest();
            #velocity
            <Self as #runtime::QuadraticKinetic>::hessian::<#scalar>(&mut bent, time);
            motion.push(#scalar::of(-2.0 * gradient), &bent);
        }
    }
}

/// The lines that give `bent` the inverse mass matrix times the momenta of `force`.
fn velocity(emitter: &mut Emitter<'_>) -> TokenStream {
    if emitter.model.jacobi().is_some() {
        return jacobi::velocity();
    }
    if emitter.model.is_separable() {
        let Names { runtime, scalar, .. } = emitter.names;
        return quote! {
            ::core::mem::swap(&mut force.q, &mut bent.p);
            <Self as #runtime::System>::drift::<#scalar, f64>(&mut force, 1.0, time);
            bent.p = force.q;
        };
    }
    let graph = &mut emitter.model.graph;
    let velocity = gradient(graph, emitter.model.kinetic, Part::Momentum);
    let product = hessian_product(graph, &velocity, Part::Momentum);
    let product = stores(emitter.model, &product, Sink::Collect);
    let Lines { tokens, .. } =
        through_buffer(emitter, &Frame::Motion, Part::Momentum, &product, |place, value| quote!(#place = #value;));
    quote! {
        ::core::mem::swap(&mut force.q, &mut force.p);
        bent.p = {
            let motion = &mut force;
            #tokens
            force.p
        };
    }
}
