//! Rust tokens for a composition: its type, its properties and its table of stages.
//!
//! Generated code uses `::core` and the runtime crate's private API, nothing else. An invalid declaration becomes a
//! stub, so that code using it still type-checks.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;
use syn::{LitStr, Path, Visibility, parse_quote};

use super::{
    facts::Facts,
    friction_code,
    inner_errors::lower_bounds,
    prove::{Class, Scheme},
    syntax::{Declaration, Sequence},
    table::number,
};

/// The path of the runtime crate where the user does not rename it.
pub(super) fn default_root() -> Path {
    parse_quote!(::integrator_core)
}

/// A declared composition.
pub(super) fn declaration(declaration: &Declaration, name: &str, scheme: Option<&Scheme>, root: &Path) -> TokenStream {
    let Declaration { attributes, visibility, name: ident, .. } = declaration;
    let citation = declaration.claims.citation.as_ref().map(LitStr::value).unwrap_or_default();
    let (implementation, prose) = match scheme {
        Some(scheme) => described(ident, name, &citation, scheme, root),
        None if declaration.sequence.as_ref().is_some_and(Sequence::has_friction) => {
            (friction_code::stub(ident, name, root), "Refused.".to_owned())
        }
        None => (implementation(ident, name, &citation, &Facts::stub(), root), "Refused.".to_owned()),
    };
    let prose = format!(" {prose}");
    // The facts are a paragraph of their own after what the user wrote.
    let gap = (!attributes.is_empty()).then(|| quote!(#[doc = ""]));
    let definition = definition(visibility, ident);
    quote! {
        #(#attributes)*
        #gap
        #[doc = #prose]
        #definition

        #implementation
    }
}

/// The implementations that make a unit struct the composition, with its description.
pub(super) fn described(
    ident: &Ident,
    name: &str,
    citation: &str,
    scheme: &Scheme,
    root: &Path,
) -> (TokenStream, String) {
    if scheme.stages.has_friction() {
        return friction_code::implementation(ident, name, citation, scheme, root);
    }
    let facts = Facts::of(scheme);
    (implementation(ident, name, citation, &facts, root), facts.prose(citation))
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

/// The two implementations that make a unit struct a composition.
fn implementation(ident: &Ident, name: &str, citation: &str, facts: &Facts, root: &Path) -> TokenStream {
    let Facts { table, symmetric, .. } = facts;
    let order = Literal::u32_unsuffixed(facts.order);
    let force_evaluations = Literal::usize_unsuffixed(table.force_evaluations());
    let gradient_evaluations = Literal::usize_unsuffixed(table.gradient_evaluations());
    let stability_limit = number(facts.stability_limit);
    let leading_error = match facts.leading_error {
        Some(norm) => {
            let norm = number(norm);
            quote!(::core::option::Option::Some(#norm))
        }
        None => quote!(::core::option::Option::None),
    };
    let generalised = (!facts.generalised.is_empty()).then(|| {
        let orders = facts.generalised.iter().map(|order| Literal::u32_unsuffixed(*order));
        quote!(const GENERALISED_ORDERS: &'static [u32] = &[#(#orders),*];)
    });
    // Those of second order keep it anyway.
    let keeps_pairs = (facts.over_inner.keeps_pairs && facts.order > 2).then(|| {
        quote!(
            const KEEPS_PAIRS: bool = true;
        )
    });
    let orders = facts.over_inner.orders;
    let orders_over_inner = (orders != lower_bounds(facts.order)).then(|| {
        let orders = orders.map(Literal::u32_unsuffixed);
        quote!(const ORDERS_OVER_INNER: [u32; 4] = [#(#orders),*];)
    });
    let stages = table.stages(root);
    let processor =
        table.processor(root).map(|processor| quote!(const PROCESSOR: #root::__private::Processor = #processor;));
    let kick = facts.has_gradients().then(|| gradient_kick(root));
    let (bound, class) = match facts.class {
        Class::General => (quote!(System), quote!(General)),
        Class::QuadraticKinetic => (quote!(QuadraticKinetic), quote!(QuadraticKinetic)),
    };
    quote! {
        #[allow(clippy::approx_constant, reason = "the order conditions, not known constants, choose the coefficients")]
        impl #root::__private::Scheme for #ident {
            const NAME: &'static str = #name;
            const CITATION: &'static str = #citation;
            const ORDER: u32 = #order;
            #generalised
            #keeps_pairs
            #orders_over_inner
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

/// A kick that also goes along the gradient of the squared force, where the stage requests it.
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
