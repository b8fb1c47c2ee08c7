//! The user's own functions, as the runtime calls them to hold the generated code against them.

use crate::{emit::printer::function::Body, model::Model, syntax::Input};
use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

/// The two methods that call `kinetic` and `potential` as they are.
pub(crate) fn functions(input: &Input, model: &Model) -> TokenStream {
    let Some([kinetic, potential]) = &model.arguments else { return stub(input) };
    let method = |name: &str, coordinates: &str, arguments: &[TokenStream]| {
        let [name, coordinates] = [name, coordinates].map(|name| Ident::new(name, Span::call_site()));
        let stated = format_ident!("stated_{name}");
        let body = Body::new(quote!(Self::#name(#(#arguments),*)));
        let (time, call) = (body.argument("time"), &body.0);
        quote! {
            fn #stated(&self, #coordinates: &Self::Coords, #time: f64) -> f64 { #call }
        }
    };
    let (kinetic, potential) = (method("kinetic", "p", kinetic), method("potential", "q", potential));
    quote!(#kinetic #potential)
}

/// The same where a mistake was noted. The functions count as used all the same; one that is missing has been noted.
fn stub(input: &Input) -> TokenStream {
    let functions = ["kinetic", "potential"].into_iter().filter_map(|name| Some(&input.function(name)?.sig.ident));
    quote! {
        fn stated_kinetic(&self, _p: &Self::Coords, _time: f64) -> f64 {
            let _ = (#(Self::#functions),*);
            0.0
        }
        fn stated_potential(&self, _q: &Self::Coords, _time: f64) -> f64 { 0.0 }
    }
}
