//! Rust tokens for a composition: its type, the facts about it and its table of stages.
//!
//! Generated code names `::core` and the runtime crate's private door, nothing else. A declaration that was refused
//! becomes a stub, so that its users still type-check.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;
use syn::{LitStr, Path, Visibility, parse_quote};

use super::{
    claims::{Class, Scheme},
    stability,
    syntax::Declaration,
    table::{Table, number},
};

/// The path of the runtime crate where the user does not rename it.
pub(super) fn default_root() -> Path {
    parse_quote!(::integrator_core)
}

/// A declared composition.
pub(super) fn declaration(declaration: &Declaration, name: &str, scheme: Option<&Scheme>, root: &Path) -> TokenStream {
    let Declaration { attributes, visibility, name: ident, .. } = declaration;
    let citation = declaration.claims.citation.as_ref().map(LitStr::value).unwrap_or_default();
    let summary = scheme.map(|scheme| summary(scheme, &citation, !attributes.is_empty()));
    let implementation = implementation(ident, name, &citation, scheme, root);
    let definition = definition(visibility, ident);
    quote! {
        #(#attributes)*
        #summary
        #definition

        #implementation
    }
}

/// The unit struct, without its documentation.
pub(super) fn definition(visibility: &Visibility, ident: &Ident) -> TokenStream {
    quote! {
        #[derive(
            ::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::default::Default,
            ::core::cmp::PartialEq, ::core::cmp::Eq, ::core::hash::Hash,
        )]
        #visibility struct #ident;
    }
}

/// The two implementations that make a unit struct a composition; stubs without a scheme.
pub(super) fn implementation(
    ident: &Ident,
    name: &str,
    citation: &str,
    scheme: Option<&Scheme>,
    root: &Path,
) -> TokenStream {
    let (order, symmetric, class) =
        scheme.map_or((0, false, Class::General), |scheme| (scheme.order, scheme.proof.symmetric, scheme.class));
    let order = Literal::u32_unsuffixed(order);
    let table = scheme.map_or_else(Table::stub, Table::of);
    let force_evaluations = Literal::usize_unsuffixed(table.force_evaluations());
    let gradient_evaluations = Literal::usize_unsuffixed(table.gradient_evaluations());
    let stability_limit = number(scheme.map_or(0.0, |scheme| stability::limit(&scheme.stages)));
    let leading_error = match scheme.and_then(Scheme::leading_error) {
        Some(norm) => {
            let norm = number(norm);
            quote!(::core::option::Option::Some(#norm))
        }
        None => quote!(::core::option::Option::None),
    };
    let stages = table.stages(root);
    let processor =
        table.processor(root).map(|processor| quote!(const PROCESSOR: #root::__private::Processor = #processor;));
    let kick = scheme.filter(|scheme| scheme.proof.general.is_none()).map(|_| gradient_kick(root));
    let (bound, class) = match class {
        Class::General => (quote!(Hamiltonian), quote!(General)),
        Class::QuadraticKinetic => (quote!(QuadraticKinetic), quote!(QuadraticKinetic)),
    };
    quote! {
        #[allow(clippy::approx_constant, reason = "the order conditions, not known constants, choose the coefficients")]
        impl #root::__private::Scheme for #ident {
            const NAME: &'static str = #name;
            const CITATION: &'static str = #citation;
            const ORDER: u32 = #order;
            const SYMMETRIC: bool = #symmetric;
            const CLASS: #root::__private::Class = #root::__private::Class::#class;
            const FORCE_EVALUATIONS: usize = #force_evaluations;
            const GRADIENT_EVALUATIONS: usize = #gradient_evaluations;
            const STABILITY_LIMIT: f64 = #stability_limit;
            const LEADING_ERROR: ::core::option::Option<f64> = #leading_error;
            const STAGES: #root::__private::Stages = #stages;
            #processor
        }

        impl<__System: #root::__private::#bound> #root::__private::Composition<__System> for #ident {
            #kick
        }
    }
}

/// A kick that also goes along the gradient of the squared force, where the stage asks for it.
fn gradient_kick(root: &Path) -> TokenStream {
    quote! {
        #[inline(always)]
        fn kick(
            flows: &mut impl #root::__private::Flows<__System>,
            stage: &#root::__private::Stage,
            h: f64,
            time: f64,
        ) {
            if stage.gradient != 0.0 {
                flows.gradient_kick(h * stage.kick, h * h * h * stage.gradient, time + h * stage.kick_time);
            } else {
                flows.kick(h * stage.kick, time + h * stage.kick_time);
            }
        }
    }
}

/// The proved facts, as the last paragraph of the documentation.
fn summary(scheme: &Scheme, citation: &str, follows_text: bool) -> TokenStream {
    let Scheme { proof, class, order, .. } = scheme;
    let orders = match (class, proof.general) {
        (Class::General, _) if proof.quadratic.order > *order => {
            format!("Order {order} for every `T`, {} where `T` is quadratic in `p` (proved)", proof.quadratic.order)
        }
        (Class::QuadraticKinetic, Some(general)) => {
            format!("Order {order} where `T` is quadratic in `p` (proved; {} for every other `T`)", general.order)
        }
        (Class::QuadraticKinetic, None) => format!("Order {order} for `T` quadratic in `p` (proved)"),
        (Class::General, _) => format!("Order {order} for every `T` (proved)"),
    };
    let symmetric = if proof.symmetric { "symmetric" } else { "not symmetric" };
    let table = Table::of(scheme);
    let evaluations = match table.force_evaluations() {
        1 => "1 force evaluation".to_owned(),
        many => format!("{many} force evaluations"),
    };
    let gradients = match table.gradient_evaluations() {
        0 => String::new(),
        some => format!(" ({some} with its gradient)"),
    };
    let mut facts = format!(" {orders}, {symmetric}, {evaluations}{gradients} a step.");
    facts += &format!(" Stable up to `h ω = {:.3}`", stability::limit(&scheme.stages));
    if let Some(norm) = scheme.leading_error() {
        facts += &format!(", leading error {norm:.1e}");
    }
    facts += ".";
    if !citation.is_empty() {
        facts += &format!(" Source: {}.", citation.trim_end_matches('.'));
    }
    let gap = follows_text.then(|| quote!(#[doc = ""]));
    quote!(#gap #[doc = #facts])
}
