//! Rust code for parts that take inner steps: the flows of each level, and the loops of the runtime over them.

use super::Flows;
use crate::{
    emit::printer::{block::Emitter, function::Body},
    model::{ExactPart, Model},
    syntax::{Nest, names::Names},
};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, quote, quote_spanned};
use syn::spanned::Spanned;

/// Flows that take inner steps: all from one on.
pub(crate) struct NestedFlows {
    /// The number of flows before them.
    first: usize,
    /// The field that holds how many steps they take.
    steps: Ident,
    /// The inner composition.
    compose: TokenStream,
}

impl NestedFlows {
    /// Those of the parts in parentheses, the outermost first.
    pub(super) fn of(emitter: &mut Emitter<'_>) -> Vec<Self> {
        let Emitter { model, names, fields } = emitter;
        let nests = model.nests.iter().enumerate();
        let of = |(level, nest): (usize, &Nest)| Self {
            first: nest.first,
            steps: fields.inner_steps(level),
            compose: composition(nest, names),
        };
        nests.map(of).collect()
    }
}

fn composition(nest: &Nest, Names { runtime, .. }: &Names) -> TokenStream {
    nest.compose.as_ref().map_or_else(|| quote!(#runtime::Verlet), ToTokens::to_token_stream)
}

/// The facts of each level of inner steps.
pub(crate) fn facts(model: &Model, names: &Names) -> Vec<TokenStream> {
    let runtime = &names.runtime;
    let of = |nest: &Nest| {
        let (steps, compose) = (Literal::u32_unsuffixed(nest.steps), composition(nest, names));
        let parts = model.parts[nest.first..].iter().map(ExactPart::name);
        quote!(#runtime::InnerSteps::of::<#compose>(#steps, &[#(#parts),*]))
    };
    model.nests.iter().map(of).collect()
}

/// The item for the runtime about parts that take inner steps, and the check of each inner composition at its name.
pub(crate) fn stated(model: &Model, names: &Names) -> Option<[TokenStream; 2]> {
    let runtime = &names.runtime;
    let (nests, mut checks) = (facts(model, names), TokenStream::new());
    for (level, nest) in model.nests.iter().enumerate() {
        let compose = composition(nest, names);
        let (span, parts) = (compose.span(), Literal::usize_unsuffixed(model.parts.len() - nest.first));
        let runtime = names.runtime_at(span);
        let admits = match level + 1 == model.nests.len() {
            true => quote_spanned!(span=> #runtime::admits_inner::<#compose>(#parts)),
            false => quote_spanned!(span=> #runtime::admits_nested::<#compose>()),
        };
        checks.extend(quote_spanned!(span=> const _: () = #admits;));
    }
    let stated = quote!(
        const NESTED: &'static [#runtime::InnerSteps] = &[#(#nests),*];
    );
    (!nests.is_empty()).then_some([stated, checks])
}

impl Flows {
    /// The functions `drift` and `kick` where the last part takes inner steps, and those of the other flows.
    pub(super) fn functions_of_nests(&self, names: &Names) -> TokenStream {
        let (drift, kick) = (self.drift.body.flow("drift", names), inner_steps(0, ["kick", "kick_together"], names));
        let Names { runtime, scalar, leaf, .. } = names;
        let of_level = |level: usize, function: TokenStream| {
            let level = Literal::usize_unsuffixed(level);
            quote!(<Self as #runtime::Nested<#level>>::#function::<#scalar, #leaf>)
        };
        let innermost = self.nests.len() - 1;
        let drifts: Vec<_> = (0..=innermost).map(|level| of_level(level, quote!(inner_drift))).collect();
        let backwards = drifts.iter().rev();
        let inner_middle = of_level(innermost, quote!(inner_middle));
        let (last, steps) = (of_level(innermost, quote!(inner_kick)), &self.nests[0].steps);
        quote! {
            fn set_inner_steps(parameters: &mut Self::Parameters<f64>, steps: usize) {
                parameters.#steps = steps;
            }
            #drift
            #[inline(always)]
            fn middle<#scalar: #runtime::Real, #leaf: #runtime::Precision>(
                motion: &mut Self::Motion<#scalar, #leaf>,
                duration: f64,
                time: f64,
                backwards: bool,
            ) {
                if backwards {
                    #inner_middle(motion, duration, time, true);
                    #(#backwards(motion, duration, time);)*
                } else {
                    #(#drifts(motion, duration, time);)*
                    #inner_middle(motion, duration, time, false);
                }
            }
            #[inline(always)]
            fn last<#scalar: #runtime::Real, #leaf: #runtime::Precision>(
                motion: &mut Self::Motion<#scalar, #leaf>,
                duration: f64,
                time: f64,
            ) {
                #last(motion, duration, time);
            }
            #kick
        }
    }

    /// What the system implements of the runtime for each level of inner steps.
    pub(crate) fn of_nests(
        &self,
        implementation: impl Fn(TokenStream, &TokenStream) -> TokenStream,
        names: &Names,
    ) -> TokenStream {
        let Names { runtime, scalar, leaf, .. } = names;
        let flows: Vec<_> = self.all().collect();
        let of = |(level, nest): (usize, &NestedFlows)| {
            let NestedFlows { first, steps, compose } = nest;
            let drift = flows[*first].body.flow("inner_drift", names);
            let (middle, kick) = match self.nests.get(level + 1) {
                Some(_) => (None, inner_steps(level + 1, ["inner_kick", "inner_kick_together"], names)),
                None => {
                    let last = flows.len() - 1;
                    let middle = Self::middle_function("inner_middle", &flows[first + 1..last], names);
                    (middle, flows[last].body.flow("inner_kick", names))
                }
            };
            let level = Literal::usize_unsuffixed(level);
            let items = quote! {
                type Inner = #compose;

                #[inline(always)]
                fn steps<#scalar: #runtime::Real, #leaf: #runtime::Precision>(motion: &Self::Motion<#scalar, #leaf>) -> usize {
                    motion.parameters.#steps
                }
                #drift
                #middle
                #kick
            };
            implementation(quote!(#runtime::Nested<#level>), &items)
        };
        self.nests.iter().enumerate().map(of).collect()
    }
}

/// The functions of these names that take the inner steps of a level, with one motion and with several.
fn inner_steps(level: usize, [one, several]: [&str; 2], names: &Names) -> TokenStream {
    let Names { runtime, scalar, leaf, .. } = names;
    let (level, several) = (Literal::usize_unsuffixed(level), Ident::new(several, proc_macro2::Span::call_site()));
    let body = Body::new(quote! {
        #runtime::inner_steps::<Self, #level, #scalar, #leaf, 1>(::core::array::from_mut(motion), duration, time);
    });
    let one = body.flow(one, names);
    quote! {
        #one
        #[inline(always)]
        fn #several<#scalar: #runtime::Real, #leaf: #runtime::Precision, const MOTIONS: usize>(
            motions: &mut [Self::Motion<#scalar, #leaf>; MOTIONS],
            duration: f64,
            time: f64,
        ) {
            #runtime::inner_steps::<Self, #level, #scalar, #leaf, MOTIONS>(motions, duration, time);
        }
    }
}
