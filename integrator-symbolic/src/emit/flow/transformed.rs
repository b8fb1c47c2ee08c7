//! Flows for time transformations, whose durations differ between lanes.
//!
//! In: the gradients of `T(p)` and `V(q)`, and the user's rate function. Out: the functions of the runtime's
//! `TimeTransformed` and `Rated`, for the plain layout.
//!
//! The logarithmic Hamiltonian is `ln(T + B) - ln(-V)` (Mikkola and Tanikawa 1999; Preto and Tremaine 1999). It has a
//! special kick: the gradient of `ln(-V)` is simplified as a whole, so an attraction by `1/r` needs no square root. The
//! kick returns `V`, which is part of that gradient, or only its sign if that is the same everywhere.

use super::{Flow, buffer};
use crate::{
    differentiate::{Contribution, gradient},
    emit::printer::{
        block::Emitter,
        frame::Frame,
        function::{Body, Lines},
    },
    graph::{Graph, Node, NodeId, Part},
    pattern::stores::{Pass, collecting, lower_roots, passes, unrolled},
    program::{Sink, Store, is_direct},
    syntax::names::Names,
};
use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

/// The items of the runtime's `TimeTransformed`.
pub(crate) fn functions(
    emitter: &mut Emitter<'_>,
    kinetic: &[Contribution],
    potential: &[Contribution],
    many_body: bool,
) -> TokenStream {
    let [t, v] = [emitter.model.kinetic, emitter.model.potential];
    let graph = &mut emitter.model.graph;
    let (logarithm, kept) = (logarithm(graph, v), kept_sign(graph, v));
    let logarithm = graph.neg(logarithm);
    let logarithmic = gradient(graph, logarithm, Part::Position);
    // No energy here reads the explicit time, whose leaf stands for what is added: one rounding less, and one addition.
    let graph = &mut emitter.model.graph;
    let time = graph.time();
    let sum = graph.add(t, time);
    let kinetic_plus = value_with(emitter, "kinetic_plus", sum, true);
    let by_potential = match many_body {
        true => of_bodies(emitter, potential, v),
        false => of_plain(emitter.names),
    };
    let drift = Flow::lines_along(emitter, kinetic, Part::Momentum, &Frame::OwnTime);
    let is_direct = is_direct(&emitter.model.graph.loops, &logarithmic);
    let kept = kept.filter(|_| is_direct);
    let logarithmic = match is_direct {
        true => simplified(emitter, &logarithmic, kept.unwrap_or(v)),
        false => collected(emitter, potential, v),
    };
    let scalar = &emitter.names.scalar;
    let returns = quote!(-> #scalar);
    let drift = flow(emitter, "drift_for", quote!(duration), drift, None);
    let logarithmic = flow(emitter, "logarithmic_kick", quote!(-duration), logarithmic, Some(returns));
    let keeps_sign = kept.map(|_| {
        quote!(
            const KEEPS_SIGN: bool = true;
        )
    });
    quote!(#keeps_sign #kinetic_plus #by_potential #drift #logarithmic)
}

/// The energy and the kick of `V` where bodies have a layout of their own.
fn of_bodies(emitter: &mut Emitter<'_>, potential: &[Contribution], energy: NodeId) -> TokenStream {
    let energy = value(emitter, "potential_of", energy);
    let kick = Flow::lines_along(emitter, potential, Part::Position, &Frame::OwnTime);
    let kick = flow(emitter, "kick_for", quote!(-duration), kick, None);
    quote!(#energy #kick)
}

/// The same where the layout is the plain one: by what is written for it, the kick on a motion at rest.
fn of_plain(names: &Names) -> TokenStream {
    let Names { runtime, scalar, leaf, .. } = names;
    quote! {
        #[inline(always)]
        fn potential_of<#scalar: #runtime::Real, #leaf: #runtime::Precision>(motion: &#runtime::PlainMotion<Self, #scalar, #leaf>) -> #scalar {
            <Self as #runtime::System>::potential::<#scalar, #leaf>(motion, 0.0)
        }

        #[inline(always)]
        fn kick_for<#scalar: #runtime::Real, #leaf: #runtime::Precision>(motion: &mut #runtime::PlainMotion<Self, #scalar, #leaf>, duration: #scalar) {
            let mut force = motion.at_rest();
            <Self as #runtime::System>::kick::<#scalar, f64>(&mut force, 1.0, 0.0);
            motion.push(duration, &force);
        }
    }
}

/// The items of the runtime's `Rated`.
pub(crate) fn rated(
    emitter: &mut Emitter<'_>,
    rate: NodeId,
    arguments: &[TokenStream],
    is_quadratic: bool,
) -> TokenStream {
    let slope = gradient(&mut emitter.model.graph, rate, Part::Position);
    let value = value(emitter, "rate_of", rate);
    let slope = Flow::lines_along(emitter, &slope, Part::Position, &Frame::OwnTime);
    let kick = flow(emitter, "kick_by_rate", quote!(-duration), slope, None);
    let linear = is_quadratic.then(|| {
        quote!(
            const LINEAR_VELOCITY: bool = true;
        )
    });
    quote! {
        #linear
        #value

        fn stated_rate(&self, q: &Self::Coords) -> f64 { Self::rate(#(#arguments),*) }

        #kick
    }
}

/// The logarithm of the absolute value of a number, but for what parameters alone add to it: one for each factor, so that
/// what factors share cancels in its gradient.
fn logarithm(graph: &mut Graph, x: NodeId) -> NodeId {
    if graph.is_prepared(x) {
        return graph.constant(0.0);
    }
    match graph.node(x) {
        Node::Neg(x) => logarithm(graph, x),
        Node::Mul(a, b) => {
            let [a, b] = [a, b].map(|factor| logarithm(graph, factor));
            graph.add(a, b)
        }
        Node::Div(a, b) => {
            let [a, b] = [a, b].map(|factor| logarithm(graph, factor));
            graph.sub(a, b)
        }
        Node::Power(base, halves) => {
            let (exponent, of_base) = (graph.constant(f64::from(halves) / 2.0), logarithm(graph, base));
            graph.mul(exponent, of_base)
        }
        Node::Binary(function, a, b) if function.name() == "hypot" => {
            let [a, b] = [a, b].map(|side| graph.power(side, 4));
            let (half, square) = (graph.constant(0.5), graph.add(a, b));
            let of_square = logarithm(graph, square);
            graph.mul(half, of_square)
        }
        _ => graph.call("ln", x),
    }
}

/// A number made of parameters alone with the sign of another one, where that has the same sign everywhere.
fn kept_sign(graph: &mut Graph, x: NodeId) -> Option<NodeId> {
    match graph.node(x) {
        _ if graph.is_prepared(x) => Some(x),
        Node::Neg(x) => {
            let sign = kept_sign(graph, x)?;
            Some(graph.neg(sign))
        }
        Node::Mul(a, b) | Node::Div(a, b) => {
            let (a, b) = (kept_sign(graph, a)?, kept_sign(graph, b)?);
            Some(graph.mul(a, b))
        }
        // Even powers, and roots where they are numbers.
        Node::Power(_, halves) if halves % 4 != 2 && halves % 4 != -2 => Some(graph.constant(1.0)),
        Node::Power(base, _) => kept_sign(graph, base),
        Node::Unary(function, _) | Node::Binary(function, ..) if function.row().never_negative => {
            Some(graph.constant(1.0))
        }
        _ => None,
    }
}

/// The logarithmic kick by the gradient of `-ln(-V)`, whose components each move a coordinate on the spot.
fn simplified(emitter: &mut Emitter<'_>, gradient: &[Contribution], returned: NodeId) -> Lines {
    let value = lower_roots(emitter.model, &[returned])[0];
    let returned = Store { context: Vec::new(), sink: Sink::Return, value };
    let Some(Pass { mut stores, moved }) = passes(emitter.model, gradient, Part::Position).pop() else {
        return emitter.evaluate(&Frame::OwnTime, &[], &[returned]);
    };
    stores.push(returned);
    match moved {
        None => emitter.evaluate(&Frame::OwnTime, &[], &stores),
        Some(_) => buffered(emitter, &stores, |lines, close| quote!(let returned = { #lines }; #close returned)),
    }
}

/// The logarithmic kick by a potential energy that is summed together with its gradient.
fn collected(emitter: &mut Emitter<'_>, potential: &[Contribution], energy: NodeId) -> Lines {
    let mut stores = collecting(emitter.model, potential);
    let energy = unrolled(emitter.model, energy);
    let energy = lower_roots(emitter.model, &[energy])[0];
    stores.push(Store { context: Vec::new(), sink: Sink::Return, value: energy });
    buffered(emitter, &stores, |lines, close| quote!(let energy = { #lines }; let step = step / -energy; #close energy))
}

/// The lines that collect a gradient in a buffer, between the buffer and its application to the momenta.
fn buffered(
    emitter: &mut Emitter<'_>,
    stores: &[Store],
    around: impl FnOnce(TokenStream, TokenStream) -> TokenStream,
) -> Lines {
    let apply = |place, value| quote!(#place.fma(step, #value););
    let (open, close) = buffer(&emitter.model.shape, &Frame::OwnTime, Part::Momentum, emitter.names, apply);
    let lines = emitter.evaluate(&Frame::OwnTime, &[], stores);
    lines.map(|lines| {
        let lines = around(lines, close);
        quote!(#open #lines)
    })
}

/// The function that returns a value.
fn value(emitter: &mut Emitter<'_>, name: &str, node: NodeId) -> TokenStream {
    value_with(emitter, name, node, false)
}

/// The same, perhaps with a number that it adds.
fn value_with(emitter: &mut Emitter<'_>, name: &str, node: NodeId, adds: bool) -> TokenStream {
    let node = lower_roots(emitter.model, &[node])[0];
    let Lines { tokens: body, .. } = emitter.value(&Frame::OwnTime, node);
    let motion = Body::new(body.clone()).argument("motion");
    let name = Ident::new(name, Span::call_site());
    let Names { runtime, scalar, leaf, .. } = emitter.names;
    let (argument, binding) = match adds {
        true => (Some(quote!(, more: #scalar)), Some(quote!(let time = more;))),
        false => (None, None),
    };
    quote! {
        #[inline(always)]
        fn #name<#scalar: #runtime::Real, #leaf: #runtime::Precision>(#motion: &#runtime::PlainMotion<Self, #scalar, #leaf> #argument) -> #scalar {
            #binding
            #body
        }
    }
}

/// The function that moves coordinates for a while, and returns what its lines end in, if anything.
fn flow(
    emitter: &Emitter<'_>,
    name: &str,
    step: TokenStream,
    lines: Lines,
    returns: Option<TokenStream>,
) -> TokenStream {
    let body = if lines.tokens.is_empty() { lines } else { lines.map(|lines| quote!(let step = #step; #lines)) };
    let body = body.body(&emitter.names.scalar);
    let ([motion, duration], body) = (["motion", "duration"].map(|name| body.argument(name)), &body.0);
    let name = Ident::new(name, Span::call_site());
    let Names { runtime, scalar, leaf, .. } = emitter.names;
    quote! {
        #[inline(always)]
        fn #name<#scalar: #runtime::Real, #leaf: #runtime::Precision>(#motion: &mut #runtime::PlainMotion<Self, #scalar, #leaf>, #duration: #scalar) #returns { #body }
    }
}
