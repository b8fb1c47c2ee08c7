//! The items of an implementation of `Recurrences`.

use super::tape::{self, Tape, per_body};
use crate::emit::printer::function::Body;
use crate::syntax::names::Names;
use proc_macro2::{Literal, TokenStream};
use quote::quote;

/// The constants of the implementation.
pub(super) struct Kind {
    pub(super) rolled: bool,
    pub(super) interleaved: bool,
    pub(super) orders_per_call: usize,
}

pub(super) fn implementation(body: TokenStream, tape: &Tape<'_>, kind: &Kind, names: &Names) -> TokenStream {
    let Names { runtime, scalar, .. } = names;
    let name = &names.tape;
    let tape_of = if tape.is_empty() { quote!(()) } else { quote!(#name<#scalar>) };
    let Kind { rolled, interleaved, orders_per_call } = kind;
    let body = Body::new(body);
    let [parameters, length, time] = ["parameters", "length", "time"].map(|name| body.argument(name));
    let pairs = body.mentions("pair").then(|| quote!(use #runtime::Pair as _;));
    let stride = body.mentions("stride").then(|| quote!(let stride = q.stride();));
    let layout = body.mentions("layout").then(|| quote!(let layout = q.layout();));
    let orders_per_call = Literal::usize_unsuffixed(*orders_per_call);
    let body = &body.0;
    let counters = per_body(tape.records).map(|number| {
        let next = tape::next(number);
        quote!(let mut #next = 0;)
    });
    quote! {
        type Tape<#scalar: #runtime::Real> = #tape_of;
        const ROLLED: bool = #rolled;
        const INTERLEAVED: bool = #interleaved;
        const ORDERS_PER_CALL: usize = #orders_per_call;

        #[cfg_attr(not(debug_assertions), inline(always))]
        fn order<#scalar: #runtime::Real>(
            #parameters: &Self::Parameters<#scalar>,
            #length: usize,
            q: &mut #runtime::Coefficients<'_, #scalar>,
            p: &mut #runtime::Coefficients<'_, #scalar>,
            tape: &mut Self::Tape<#scalar>,
            order: usize,
            #time: #scalar,
        ) {
            #pairs
            #stride
            #layout
            #(#counters)*
            #body
        }
    }
}
