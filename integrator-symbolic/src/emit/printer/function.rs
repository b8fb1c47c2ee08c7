//! The signatures of generated functions: unused arguments begin with an underscore.

use crate::program::Program;
use crate::syntax::names::Names;
use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

/// The lines of a function, and the program that they are printed from.
#[derive(Default)]
pub(crate) struct Lines {
    pub(crate) tokens: TokenStream,
    pub(crate) program: Program,
}

impl Lines {
    /// The same lines with others around them.
    pub(crate) fn map(self, around: impl FnOnce(TokenStream) -> TokenStream) -> Self {
        Self { tokens: around(self.tokens), ..self }
    }

    /// The body that they are, after the explicit time as a number where it is read.
    pub(crate) fn body(self, scalar: &Ident) -> Body {
        let (lines, read) = (self.tokens, self.program.reads_time.then(|| quote!(let time = #scalar::of(time);)));
        Body(quote!(#read #lines))
    }
}

/// The body of a generated function.
#[derive(Default)]
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
        let (name, body) = (Ident::new(name, Span::call_site()), &self.0);
        let Names { runtime, scalar, leaf, .. } = names;
        let (motion, time) = (self.argument("motion"), self.argument("time"));
        quote! {
            #[inline(always)]
            fn #name<#scalar: #runtime::Real, #leaf: #runtime::Precision>(#motion: &Self::Motion<#scalar, #leaf>, #time: f64) -> #scalar { #body }
        }
    }
}
