//! Random systems in units of any size: coordinates are read in a unit of the system, from 1e-60 to 1e60, and states are in it.

use super::{Choices, Rc, System, Value, fixed_system, lattice, pairs};
use proc_macro2::{Delimiter, TokenStream, TokenTree};
use quote::{format_ident, quote};
use syn::{FnArg, ImplItem, ItemImpl, Pat, Type};

/// The highest power of ten of a unit.
const POWERS: f64 = 60.0;

/// A system of arrays whose functions get coordinates in units.
pub(crate) fn system_in_units(seed: u64) -> System {
    let System { item, cases } = fixed_system(seed);
    let mut item: ItemImpl = syn::parse2(item).unwrap_or_else(|error| panic!("{error}"));
    let mut wrappers = Vec::new();
    for function in item.items.iter_mut().filter_map(|item| match item {
        ImplItem::Fn(function) if function.sig.ident == "kinetic" || function.sig.ident == "potential" => {
            Some(function)
        }
        _ => None,
    }) {
        let name = format_ident!("{}_of_numbers", function.sig.ident);
        let mut wrapper = function.clone();
        let FnArg::Typed(coordinates) = &function.sig.inputs[1] else { continue };
        let (Pat::Ident(letter), of) = (&*coordinates.pat, &*coordinates.ty) else { continue };
        let (reference, of) = match of {
            Type::Reference(reference) => (quote!(&), &*reference.elem),
            other => (quote!(), other),
        };
        let numbers = in_units(&quote!(#letter), of);
        let time = (function.sig.inputs.len() > 2).then(|| quote!(, t));
        wrapper.block = syn::parse_quote!({ self.#name(#reference #numbers #time) });
        function.sig.ident = name;
        wrappers.push(ImplItem::Fn(wrapper));
    }
    item.items.extend(wrappers);
    with_units(System { item: quote!(#item), cases }, seed, &[0, 1])
}

/// Coordinates of a type over the unit.
fn in_units(place: &TokenStream, of: &Type) -> TokenStream {
    let Type::Array(array) = of else { return quote!(#place / self.unit) };
    let length: usize = match &array.len {
        syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Int(length), .. }) => length.base10_parse().unwrap_or_default(),
        _ => 0,
    };
    let items = (0..length).map(syn::Index::from).map(|index| in_units(&quote!(#place[#index]), &array.elem));
    quote!([#(#items),*])
}

/// A lattice whose positions are read in units.
pub(crate) fn lattice_in_units(seed: u64) -> System {
    with_positions_in_units(lattice(seed), seed)
}

/// Bodies in pairs whose positions are read in units.
pub(crate) fn pairs_in_units(seed: u64) -> System {
    with_positions_in_units(pairs(seed), seed)
}

fn with_positions_in_units(System { item, cases }: System, seed: u64) -> System {
    with_units(System { item: positions_in_units(item), cases }, seed, &[0])
}

/// The same text with `q[..]` and `q[..][..]` over the unit.
fn positions_in_units(text: TokenStream) -> TokenStream {
    let mut tokens = text.into_iter().peekable();
    let mut new = Vec::new();
    while let Some(token) = tokens.next() {
        let is_index =
            |next: &TokenTree| matches!(next, TokenTree::Group(group) if group.delimiter() == Delimiter::Bracket);
        match token {
            TokenTree::Ident(name) if name == "q" && tokens.peek().is_some_and(is_index) => {
                let indices: Vec<_> = std::iter::from_fn(|| tokens.next_if(is_index)).collect();
                new.push(quote!((#name #(#indices)* / self.unit)));
            }
            TokenTree::Group(group) => {
                let inner = positions_in_units(group.stream());
                new.push(TokenTree::Group(proc_macro2::Group::new(group.delimiter(), inner)).into());
            }
            other => new.push(other.into()),
        }
    }
    new.into_iter().collect()
}

/// The cases with a unit each, and the given halves of their states in it.
fn with_units(mut system: System, seed: u64, halves: &[usize]) -> System {
    let mut choices = Choices::new(seed);
    for case in &mut system.cases {
        let unit = match choices.percent(50) {
            true => 2.0_f64.powi(choices.between(-POWERS, POWERS) as i32 * 10 / 3),
            false => 10.0_f64.powf(choices.between(-POWERS, POWERS)),
        };
        if let Value::Struct(fields) = &mut case.fields {
            Rc::make_mut(fields).push(("unit".to_owned(), Value::plain(unit)));
        }
        for half in halves {
            case.state[*half].iter_mut().flatten().for_each(|coordinate| *coordinate *= unit);
        }
    }
    system
}
