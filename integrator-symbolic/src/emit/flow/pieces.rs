//! Code for a Hamiltonian with pieces in time: how flows find the middle of the step.

use crate::emit::printer::fields::Fields;
use crate::syntax::names::Names;
use proc_macro2::TokenStream;
use quote::quote;

/// The items that are written where a flow reads the middle of its step, and none elsewhere.
#[derive(Default)]
pub(crate) struct Pieces {
    /// That there are pieces.
    pub(crate) piecewise: Option<TokenStream>,
    /// How a motion receives a step.
    pub(crate) begin: Option<TokenStream>,
    /// How prepared constants are.
    pub(crate) set: Option<TokenStream>,
}

impl Pieces {
    /// Those of the flows that have requested these fields.
    pub(crate) fn of(fields: &Fields, in_jacobi: bool, names: &Names) -> Self {
        let Some(middle) = fields.known_middle() else { return Self::default() };
        let Names { runtime, scalar, leaf, .. } = names;
        let begin = match in_jacobi {
            true => quote!(motion.begin_step(middle);),
            false => quote!(#runtime::Prepared::begin_step(&mut motion.parameters, middle);),
        };
        Self {
            piecewise: Some(quote! {
                const PIECEWISE_IN_TIME: bool = true;
            }),
            begin: Some(quote! {
                #[inline(always)]
                fn begin_step<#scalar: #runtime::Real, #leaf: #runtime::Precision>(motion: &mut Self::Motion<#scalar, #leaf>, middle: f64) {
                    #begin
                }
            }),
            set: Some(quote! {
                #[inline(always)]
                fn begin_step(&mut self, middle: f64) {
                    self.#middle = #scalar::of(middle);
                }
            }),
        }
    }
}
