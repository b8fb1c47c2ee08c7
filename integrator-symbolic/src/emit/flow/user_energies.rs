//! The user's own functions, which the runtime compares with the generated code.

use crate::{
    model::{Called, Model, PartFunction},
    syntax::Input,
    syntax::names::Names,
};
use proc_macro2::TokenStream;
use quote::quote;

/// The method that calls the user's functions as they are.
pub(crate) fn function(input: &Input, model: &Model, names: &Names) -> TokenStream {
    let runtime = &names.runtime;
    let stated = match &model.called {
        // The parts that move are not those that the user wrote.
        Some(Called::Separate([kinetic, potential])) if model.jacobi().is_some() => quote! {
            #runtime::StatedEnergy::Whole(Self::kinetic(#(#kinetic),*) + Self::potential(#(#potential),*))
        },
        Some(Called::Separate([kinetic, potential])) => quote! {
            #runtime::StatedEnergy::Separate {
                kinetic: Self::kinetic(#(#kinetic),*),
                potential: Self::potential(#(#potential),*),
            }
        },
        Some(Called::Parts) => {
            let call = |PartFunction { name, arguments, .. }: &PartFunction| quote!(Self::#name(#(#arguments),*));
            let mut parts = model.parts.iter().map(|part| part.functions.iter().map(call));
            let (first, others) = (parts.next().into_iter().flatten(), parts.flatten());
            quote!(#runtime::StatedEnergy::Separate { kinetic: #(#first)+*, potential: #(#others)+* })
        }
        Some(Called::Whole(arguments)) => quote!(#runtime::StatedEnergy::Whole(Self::hamiltonian(#(#arguments),*))),
        // A mistake was noted. The functions count as used all the same; one that is missing has been noted.
        None => {
            let parts = input.split.iter().map(ToString::to_string);
            let functions = ["kinetic", "potential", "hamiltonian"].map(str::to_owned).into_iter().chain(parts);
            let functions = functions.filter_map(|name| Some(&input.function(&name)?.sig.ident));
            quote! {
                let _ = (#(Self::#functions),*);
                #runtime::StatedEnergy::Whole(0.0)
            }
        }
    };
    quote! {
        fn stated(&self, q: &Self::Coords, p: &Self::Coords, time: f64) -> #runtime::StatedEnergy { #stated }
    }
}
