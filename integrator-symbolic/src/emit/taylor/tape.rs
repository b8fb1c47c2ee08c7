//! The structs for the Taylor coefficients that recurrences read.
//!
//! Values outside of all loops are adjacent; a value inside of a loop has one entry per iteration.

use crate::syntax::names::Names;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

/// The location of a value's coefficients.
#[derive(Clone)]
pub(super) enum Series {
    /// In the rows of a part of the state.
    Row { part: Ident, place: TokenStream },
    /// In a record.
    Kept { at: Ident, name: Ident },
    /// In a row of a record.
    Own { at: Ident, name: Ident },
}

impl Series {
    /// The coefficient of an order.
    pub(super) fn of(&self, order: &TokenStream) -> TokenStream {
        match self {
            Series::Row { part, place } => quote!(#part[#order][#place]),
            Series::Kept { at, name } => quote!(#at.kept[#order].#name),
            Series::Own { at, name } => quote!(#at.#name[#order]),
        }
    }
}

/// The number of orders that one call computes.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum OrdersPerCall {
    One,
    Two,
}

impl OrdersPerCall {
    /// The number.
    pub(super) fn count(self) -> usize {
        match self {
            OrdersPerCall::One => 1,
            OrdersPerCall::Two => 2,
        }
    }
}

/// The record of a block of lines: those outside of all loops, or those of an iteration.
pub(super) struct Record {
    /// Its name inside the block.
    pub(super) at: Ident,
    /// The name of each value, and the kind of its slot.
    pub(super) slots: Vec<(Ident, Kept)>,
    /// The number of its copies.
    pub(super) iterations: Iterations,
}

impl Record {
    pub(super) fn of(at: &str, iterations: Iterations) -> Self {
        Self { at: format_ident!("{at}"), slots: Vec::new(), iterations }
    }

    /// Gives a value its place. One that is computed in several branches has one place, which each of them writes
    /// before it reads it.
    pub(super) fn keep(&mut self, name: Ident, kept: Kept) {
        if !self.slots.contains(&(name.clone(), kept)) {
            self.slots.push((name, kept));
        }
    }
}

/// The kind of a slot.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Kept {
    /// The coefficients of a value.
    Series,
    /// The coefficients of its derivative, each its own multiplied by the order.
    Rates,
    /// Two coefficients of each order as a pair.
    Pairs,
    /// A number, the same for all orders.
    Number,
    /// A mask, the same for all orders.
    Condition,
}

/// The copies of a record.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Iterations {
    /// One, of the lines outside of all loops.
    Once,
    /// One for each iteration.
    OneByOne,
    /// One for each block of eight iterations, which read this number of points, have this number of constants, and
    /// move this number of coordinates by this number of values, of this number of orders per call.
    Blocks([usize; 5]),
    /// One for each vector of the sites of a line, or for several, by the number of values and of orders per call.
    Sites([usize; 2]),
}

/// The list that has a place for every iteration of a loop.
pub(super) fn list(number: usize) -> Ident {
    format_ident!("iterations_{number}")
}

/// The iteration that comes next.
pub(super) fn next(number: usize) -> Ident {
    format_ident!("next_{number}")
}

/// The struct of the iterations of a loop.
pub(super) fn iteration(number: usize, names: &Names) -> Ident {
    format_ident!("{}{number}", names.iteration)
}

/// The numbers of the loops whose iterations keep something, one by one.
pub(super) fn per_body(records: &[Record]) -> impl Iterator<Item = usize> {
    (1..records.len())
        .filter(|number| records[*number].iterations == Iterations::OneByOne && !records[*number].slots.is_empty())
}

/// The type of the list of a loop's records, if it has any.
fn kind(number: usize, record: &Record, names: &Names) -> Option<TokenStream> {
    let Names { runtime, scalar, .. } = names;
    let iteration = iteration(number, names);
    let kept = |vectors: TokenStream| if record.slots.is_empty() { quote!(()) } else { quote!(#iteration<#vectors>) };
    match record.iterations {
        Iterations::Blocks(counts) => {
            let (counts, kept) = (counts.map(Literal::usize_unsuffixed), kept(quote!(#runtime::Wide<#scalar>)));
            Some(quote!(#runtime::Iterations<#scalar, #kept, #(#counts),*>))
        }
        Iterations::Sites(counts) => {
            let counts = counts.map(Literal::usize_unsuffixed);
            let [wide, bundle] =
                [quote!(Wide), quote!(Bundle)].map(|vectors| kept(quote!(#runtime::#vectors<#scalar>)));
            Some(quote!(#runtime::Line<#scalar, #bundle, #wide, #(#counts),*>))
        }
        Iterations::OneByOne if !record.slots.is_empty() => Some(quote!(#runtime::Vec<#iteration<#scalar>>)),
        Iterations::Once | Iterations::OneByOne => None,
    }
}

/// All that is kept.
pub(super) struct Tape<'r> {
    /// The first one is that of the function.
    pub(super) records: &'r [Record],
    /// Whether positions follow momenta by an inverse mass.
    pub(super) has_inverse_mass: bool,
}

impl Tape<'_> {
    /// Whether nothing is kept: a motion whose forces are linear, without loops, reads coordinates alone.
    pub(super) fn is_empty(&self) -> bool {
        let of_vectors = |iterations| matches!(iterations, Iterations::Blocks(_) | Iterations::Sites(_));
        let keeps = |record: &Record| !record.slots.is_empty() || of_vectors(record.iterations);
        !self.has_inverse_mass && !self.records.iter().any(keeps)
    }

    /// The structs of the tape.
    pub(super) fn structs(&self, names: &Names) -> TokenStream {
        let Names { runtime, scalar, .. } = names;
        let numbered = || self.records.iter().enumerate().skip(1);
        let inverse_mass =
            self.has_inverse_mass.then(|| (format_ident!("inverse_mass"), quote!(#runtime::InverseMass<#scalar>)));
        let of_loops = numbered().filter_map(|(number, record)| Some((list(number), kind(number, record, names)?)));
        let lists: Vec<(Ident, TokenStream)> = inverse_mass.into_iter().chain(of_loops).collect();
        let iterations = numbered().filter(|(_, record)| !record.slots.is_empty()).map(|(number, record)| {
            structure(names, &iteration(number, names), record, &[], " What an iteration of a loop keeps.")
        });
        let doc = " The coefficients that recurrences read.";
        let whole = (!self.is_empty()).then(|| structure(names, &names.tape, &self.records[0], &lists, doc));
        quote!(#(#iterations)* #whole)
    }
}

/// The struct that holds a record, beside lists of what loops keep.
fn structure(names: &Names, name: &Ident, record: &Record, lists: &[(Ident, TokenStream)], doc: &str) -> TokenStream {
    let Names { runtime, scalar, .. } = names;
    let (mut series, mut fields, mut values) = (Vec::new(), TokenStream::new(), TokenStream::new());
    for (slot, kept) in &record.slots {
        match kept {
            Kept::Series => series.push(slot),
            Kept::Rates => {
                fields.extend(quote!(#slot: [#scalar; #runtime::COEFFICIENTS],));
                values.extend(quote!(#slot: [#scalar::of(0.0); #runtime::COEFFICIENTS],));
            }
            Kept::Pairs => {
                fields.extend(quote!(#slot: [#scalar::Pair; #runtime::COEFFICIENTS],));
                values.extend(quote!(#slot: [#runtime::twice(#scalar::of(0.0)); #runtime::COEFFICIENTS],));
            }
            Kept::Number => {
                fields.extend(quote!(#slot: #scalar,));
                values.extend(quote!(#slot: #scalar::of(0.0),));
            }
            Kept::Condition => {
                fields.extend(quote!(#slot: #scalar::Mask,));
                values.extend(quote!(#slot: <#scalar::Mask as #runtime::Mask>::of(false),));
            }
        }
    }
    let of_order = format_ident!("{name}Order");
    let orders = (!series.is_empty()).then(|| {
        fields.extend(quote!(kept: [#of_order<#scalar>; #runtime::COEFFICIENTS],));
        values.extend(quote!(kept: [#of_order { #(#series: #scalar::of(0.0)),* }; #runtime::COEFFICIENTS],));
        quote! {
            /// Coefficients of an order.
            #[derive(::core::clone::Clone, ::core::marker::Copy)]
            pub struct #of_order<#scalar: #runtime::Real> { #(#series: #scalar),* }
        }
    });
    for (list, kind) in lists {
        fields.extend(quote!(#list: #kind,));
        values.extend(quote!(#list: ::core::default::Default::default(),));
    }
    quote! {
        #orders

        #[doc = #doc]
        pub struct #name<#scalar: #runtime::Real> { #fields }

        impl<#scalar: #runtime::Real> ::core::default::Default for #name<#scalar> {
            fn default() -> Self {
                Self { #values }
            }
        }
    }
}
