//! A message for an annotation that names a method as the field does and the catalogue does not.
//!
//! In: the name in `compose = ..`. Out: nothing, but for names that are known from elsewhere. For these, a function that compiles
//! if the user has an item of that name, in any scope, and else has an error with the name of the method here. The macro sees no
//! items, so the compiler finds out in two ways: a pattern of one name is a new variable only if no unit struct has that name, and
//! names in a block hide those of the module around it.

use crate::{
    other_names::named_otherwise,
    syntax::{Compose, Input, names::Names},
};
use proc_macro2::{Span, TokenStream};
use quote::{quote, quote_spanned};

/// The function, if the name is known from elsewhere.
pub(super) fn check(input: &Input, names: &Names) -> Option<TokenStream> {
    let Some(Compose::Named(path)) = &input.compose else { return None };
    let name = path.get_ident()?;
    let [message, help] = named_otherwise(&name.to_string())?;
    let runtime = &names.runtime;
    // The place of the message, with names of its own.
    let here = name.span().resolved_at(Span::call_site());
    let call = quote_spanned!(here=> own::<{ names::IS_ITEM_OF_USER }, _>(#name));
    Some(quote! {
        const _: fn() = || {
            #[diagnostic::on_unimplemented(message = #message, label = "unknown composition", note = #help)]
            trait Own<const IS_ITEM: bool> {}
            impl<Method> Own<true> for Method {}
            #[diagnostic::do_not_recommend]
            impl<Method: #runtime::Described> Own<false> for Method {}
            fn own<const IS_ITEM: bool, Method: Own<IS_ITEM>>(_: Method) {}

            #[allow(dead_code, unused_imports, reason = "the item of the user hides one of these")]
            mod names {
                struct #name;
                impl #name {
                    const IS_ITEM_OF_USER: bool = false;
                }
                trait Item {
                    const IS_ITEM_OF_USER: bool = true;
                }
                impl<Method: ?Sized> Item for Method {}
                pub(super) const IS_ITEM_OF_USER: bool = {
                    use super::*;
                    <#name>::IS_ITEM_OF_USER
                };
            }
            #[allow(non_snake_case, unreachable_code, unreachable_patterns, unused_variables, reason = "only its type is read")]
            {
                let method = return;
                match method {
                    #name => #call,
                }
            }
        };
    })
}
