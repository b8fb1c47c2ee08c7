//! Rust tokens for a composition with friction: its properties, its stages, and the traits of methods.

use proc_macro2::{Ident, TokenStream};
use quote::quote;
use syn::Path;

use super::{facts::Facts, prove::Scheme, stages::Letter, table::number};

/// The implementations that make a unit struct a composition with friction, and its description.
pub(super) fn implementation(
    ident: &Ident,
    name: &str,
    citation: &str,
    scheme: &Scheme,
    root: &Path,
) -> (TokenStream, String) {
    let runtime = quote!(#root::__private);
    let letters = scheme.stages.elements().iter().map(|element| {
        let coefficient = number(element.coefficient.value.value());
        match element.letter {
            Letter::T => quote!(#runtime::Letter::T(#coefficient)),
            Letter::V => quote!(#runtime::Letter::V(#coefficient)),
            Letter::O => quote!(#runtime::Letter::O(#coefficient)),
        }
    });
    let facts = Facts::of(&scheme.without_friction());
    let (order, symmetric, limit) = (scheme.order, scheme.proof.symmetric, facts.stability_limit);
    let evaluations = facts.table.force_evaluations();
    let properties = properties(name, citation, (order, symmetric, evaluations, limit), quote!(#(#letters),*), root);
    let implementation = with_properties(ident, &properties, root);
    let symmetry = if symmetric { "symmetric" } else { "not symmetric" };
    let plural = if evaluations == 1 { "" } else { "s" };
    let source = match citation.trim_end_matches('.') {
        "" => String::new(),
        citation => format!(" Source: {citation}."),
    };
    let prose = format!(
        "Order {order} with friction, weak order with noise (proved), {symmetry}, {evaluations} force evaluation{plural} a step. \
         Stable up to `h ω = {limit:.3}`.{source}"
    );
    (implementation, prose)
}

/// The implementations for a declaration with errors: its users still type-check.
pub(super) fn stub(ident: &Ident, name: &str, root: &Path) -> TokenStream {
    with_properties(ident, &properties(name, "", (0, false, 0, 0.0), TokenStream::new(), root), root)
}

/// The constants: order, symmetry, force evaluations and limit of stability, and the stages.
fn properties(
    name: &str,
    citation: &str,
    (order, symmetric, evaluations, limit): (u32, bool, usize, f64),
    letters: TokenStream,
    root: &Path,
) -> TokenStream {
    let runtime = quote!(#root::__private);
    let stability_limit = number(limit);
    quote! {
        const NAME: &'static str = #name;
        const CITATION: &'static str = #citation;
        const ORDER: u32 = #order;
        const SYMMETRIC: bool = #symmetric;
        const FORCE_EVALUATIONS: usize = #evaluations;
        const STABILITY_LIMIT: f64 = #stability_limit;
        const LETTERS: &'static [#runtime::Letter] = &[#letters];
    }
}

/// The implementations with these constants.
fn with_properties(ident: &Ident, properties: &TokenStream, root: &Path) -> TokenStream {
    let runtime = quote!(#root::__private);
    quote! {
        #[allow(clippy::approx_constant, reason = "the order conditions, not known constants, choose the coefficients")]
        impl #runtime::FrictionScheme for #ident {
            #properties
        }

        impl #runtime::Described for #ident {
            fn facts(self) -> #runtime::Facts {
                #runtime::facts_with_friction::<Self>()
            }
        }

        #[diagnostic::do_not_recommend]
        impl<__System: #runtime::WithFriction> #runtime::Method<__System> for #ident {
            type Constants = #runtime::FrictionConstants<__System::Parameters<f64>>;
            type Motion<__R: #runtime::Real, __K: #runtime::Precision> = #runtime::DampedOf<__System, __R, __K>;

            fn constants(self, parameters: #runtime::Arc<__System::Parameters<f64>>) -> #runtime::Arc<Self::Constants> {
                #runtime::FrictionConstants::new(parameters, __System::DISSIPATION)
            }
            fn step_functions<__R: #runtime::Real, __K: #runtime::Precision, __E: #runtime::Executor>()
            -> #runtime::StepFunctions<Self::Motion<__R, __K>> {
                #runtime::steps_with_friction::<Self, __System, __R, __K, __E>()
            }
        }

        #[diagnostic::do_not_recommend]
        impl<__System: #runtime::WithFriction> #runtime::Resumable<__System> for #ident {}
        #[diagnostic::do_not_recommend]
        impl<__System: #runtime::WithFriction> #runtime::Differentiable<__System> for #ident {}
        #[diagnostic::do_not_recommend]
        impl<__System: #runtime::WithFriction> #runtime::Memoryless<__System> for #ident {}
        #[diagnostic::do_not_recommend]
        impl<__System: #runtime::WithFriction> #runtime::InLanes<__System> for #ident {}
        #[diagnostic::do_not_recommend]
        impl<__System: #runtime::WithFriction> #runtime::ResumableInLanes<__System> for #ident {}
    }
}
