//! The structs that hold the Taylor coefficients which recurrences read.
//!
//! Values outside of all loops lie beside each other; those inside of one have a place for every turn of it.

use super::names::Names;
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

/// What is kept in one block: the lines outside of all loops, or those of a turn.
pub(super) struct Record {
    /// What it is called inside the block.
    pub(super) at: Ident,
    /// The name of each value, and whether it is a condition.
    pub(super) slots: Vec<(Ident, bool)>,
}

/// The list that has a place for every turn of a loop.
pub(super) fn list(number: usize) -> Ident {
    format_ident!("turns_{number}")
}

/// The turn that comes next.
pub(super) fn next(number: usize) -> Ident {
    format_ident!("next_{number}")
}

/// The struct of the turns of a loop.
fn turn(number: usize, names: &Names) -> Ident {
    format_ident!("{}{number}", names.turn)
}

/// The numbers of the loops whose turns keep something.
pub(super) fn kept(records: &[Record]) -> impl Iterator<Item = usize> {
    (1..records.len()).filter(|number| !records[*number].slots.is_empty())
}

/// The structs of the tape.
pub(super) fn tape(records: &[Record], names: &Names) -> TokenStream {
    let Names { runtime, scalar, .. } = names;
    let structure = |name: &Ident, record: &Record, lists: &[usize], doc: &str| {
        let fields = record.slots.iter().map(|(slot, is_condition)| match is_condition {
            true => quote!(#slot: #scalar::Mask,),
            false => quote!(#slot: #runtime::Series<#scalar>,),
        });
        let values = record.slots.iter().map(|(slot, is_condition)| match is_condition {
            true => quote!(#slot: <#scalar::Mask as #runtime::Mask>::of(false),),
            false => quote!(#slot: [#scalar::of(0.0); #runtime::COEFFICIENTS],),
        });
        let names_of = lists.iter().map(|number| list(*number));
        let (declared, empty) = (
            lists.iter().zip(names_of.clone()).map(|(number, list)| {
                let turn = turn(*number, names);
                quote!(#list: #runtime::Vec<#turn<#scalar>>,)
            }),
            names_of.map(|list| quote!(#list: #runtime::Vec::new(),)),
        );
        quote! {
            #[doc = #doc]
            #[derive(::core::clone::Clone)]
            pub struct #name<#scalar: #runtime::Real> { #(#fields)* #(#declared)* }

            impl<#scalar: #runtime::Real> ::core::default::Default for #name<#scalar> {
                fn default() -> Self {
                    Self { #(#values)* #(#empty)* }
                }
            }
        }
    };
    let lists: Vec<usize> = kept(records).collect();
    let turns = lists
        .iter()
        .map(|number| structure(&turn(*number, names), &records[*number], &[], " What a turn of a loop keeps."));
    let whole = has_tape(records)
        .then(|| structure(&names.tape, &records[0], &lists, " The coefficients that recurrences read."));
    quote!(#(#turns)* #whole)
}

/// Whether anything is kept: a motion whose forces are linear reads coordinates alone.
pub(super) fn has_tape(records: &[Record]) -> bool {
    records.iter().any(|record| !record.slots.is_empty())
}
