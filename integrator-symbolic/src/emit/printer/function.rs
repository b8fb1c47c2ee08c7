//! The heads of generated functions: arguments that a body does not read are written with an underscore.

use super::names::Names;
use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

/// The body of a generated function.
pub(crate) struct Body(pub(crate) TokenStream);

impl Body {
    pub(crate) fn new(tokens: TokenStream) -> Self {
        Self(tokens)
    }

    /// Whether the body mentions a name, so that an argument that it does not is written with an underscore.
    pub(crate) fn mentions(&self, name: &str) -> bool {
        fn within(tokens: TokenStream, name: &str) -> bool {
            tokens.into_iter().any(|token| match token {
                proc_macro2::TokenTree::Ident(ident) => ident == name,
                proc_macro2::TokenTree::Group(group) => within(group.stream(), name),
                _ => false,
            })
        }
        within(self.0.clone(), name)
    }

    pub(crate) fn argument(&self, name: &str) -> Ident {
        let underscore = if self.mentions(name) { "" } else { "_" };
        Ident::new(&format!("{underscore}{name}"), Span::call_site())
    }

    /// The explicit time as a number of the flow, where it is read.
    pub(crate) fn time(&self, scalar: &Ident) -> Option<TokenStream> {
        self.mentions("time").then(|| quote!(let time = #scalar::of(time);))
    }

    pub(crate) fn flow(&self, name: &str, names: &Names) -> TokenStream {
        let (name, body) = (Ident::new(name, Span::call_site()), &self.0);
        let Names { runtime, scalar, leaf, .. } = names;
        let (motion, duration, time) = (self.argument("motion"), self.argument("duration"), self.argument("time"));
        quote! {
            #[inline(always)]
            fn #name<#scalar: #runtime::Real, #leaf: #runtime::Precision>(#motion: &mut Self::Motion<#scalar, #leaf>, #duration: f64, #time: f64) { #body }
        }
    }

    pub(crate) fn energy(&self, name: &str, names: &Names) -> TokenStream {
        let (name, body, read) = (Ident::new(name, Span::call_site()), &self.0, self.time(&names.scalar));
        let Names { runtime, scalar, leaf, .. } = names;
        let (motion, time) = (self.argument("motion"), self.argument("time"));
        quote! {
            #[inline(always)]
            fn #name<#scalar: #runtime::Real, #leaf: #runtime::Precision>(#motion: &Self::Motion<#scalar, #leaf>, #time: f64) -> #scalar { #read #body }
        }
    }
}
