//! Flows of lattices as Rust: what each site computes from its neighbourhood, for the runtime to sweep along.

use super::{
    Body, block,
    expression::Printer,
    fields::{Fields, is_leaf},
    frame::Frame,
    names::Names,
};
use crate::{
    differentiate::Contribution,
    gather::{Direction, Extent, Gathered, gathered},
    graph::{
        Around, Element, Part,
        index::{Index, IndexId, LoopId, LoopSet},
    },
    model::Model,
    program::{Placed, Sink},
};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, format_ident, quote};

/// A flow that all sites take part in alike.
pub(super) struct Sweep {
    /// Its type in the runtime.
    flow: Ident,
    body: Body,
    gathered: Gathered,
}

/// The flow along `gradient`, if it has that form.
pub(super) fn sweep(
    model: &mut Model,
    fields: &mut Fields,
    names: &Names,
    gradient: &[Contribution],
    part: Part,
) -> Option<Sweep> {
    let Model { graph, parameters, lengths, .. } = model;
    let mut gathered = gathered(graph, gradient, lengths, |graph, id| is_leaf(graph, parameters, id))?;
    for Direction { place, begins, .. } in &gathered.directions {
        let first = gradient.iter().flat_map(Contribution::loops).find(|by| begins.contains_key(by))?;
        let index = model.running.get(&first)?.clone();
        model.running.entry(*place).or_insert(index);
    }

    let values: Vec<_> = gathered.shares.iter().map(|share| share.value).collect();
    for (share, value) in gathered.shares.iter_mut().zip(block::lowered(model, &values)) {
        share.value = value;
    }
    let body = Body::new(block::shares(model, fields, names, &gathered));
    let flow = match part {
        Part::Momentum => format_ident!("Drift"),
        Part::Position => format_ident!("Kick"),
    };
    Some(Sweep { flow, body, gathered })
}

impl Sweep {
    /// The flow, as the runtime goes about it.
    pub(super) fn flow(&self) -> TokenStream {
        let rows = if self.is_plane() { "_rows" } else { "" };
        let method = format_ident!("{}{rows}", self.flow.to_string().to_lowercase());
        quote!(motion.#method::<Self>(duration, time);)
    }

    /// The items of the runtime's `Gather`.
    pub(super) fn items(&self, names: &Names) -> TokenStream {
        let (body, Names { runtime, scalar, wide, .. }) = (&self.body, names);
        let onward = self.gathered.onward();
        let count = Literal::usize_unsuffixed(self.gathered.places().len());
        let edges = self.gathered.directions.iter().zip(onward).rev();
        let mut edges = edges.map(|(direction, onward)| edges_of(direction, onward, runtime));
        let sites = edges.next();
        let rows = edges.next().map(|rows| {
            quote! {
                const ROWS: ::core::option::Option<#runtime::Edges> = ::core::option::Option::Some(#rows);
            }
        });
        let (near, parameters, time) = (body.argument("near"), body.argument("parameters"), body.argument("time"));
        let (read, body) = (body.time(wide), &body.0);
        quote! {
            type Shares<#wide: ::core::marker::Copy> = [#wide; #count];

            const EDGES: #runtime::Edges = #sites;
            #rows

            #[inline(always)]
            fn shares<#scalar: #runtime::Real, #wide: #runtime::Block<#scalar>>(
                #near: &#runtime::Neighbours<#scalar, #wide>,
                #parameters: &Self::Parameters<#scalar>,
                #time: f64,
            ) -> [#wide; #count] { #read #body }
        }
    }

    /// The type of the flow in the runtime.
    pub(super) fn name(&self) -> &Ident {
        &self.flow
    }

    /// Whether it moves the sites of a plane.
    pub(super) fn is_plane(&self) -> bool {
        self.gathered.is_plane()
    }
}

/// The runtime's `Edges` of a direction in which shares go so far.
fn edges_of(direction: &Direction, onward: usize, runtime: &Ident) -> TokenStream {
    let Direction { first, last, behind, ahead, periodic, .. } = direction;
    let onward = Literal::usize_unsuffixed(onward);
    let [first, last, behind, ahead] = [first, last, behind, ahead].map(|number| Literal::u64_unsuffixed(*number));
    quote! {
        #runtime::Edges {
            first: #first,
            last: #last,
            onward: #onward,
            behind: #behind,
            ahead: #ahead,
            periodic: #periodic,
        }
    }
}

/// What lets the runtime move a lattice a part at a time: how far its flows look, and its sites.
pub(super) fn parts(names: &Names) -> (TokenStream, TokenStream) {
    let Names { runtime, scalar, leaf, .. } = names;
    let reach = quote! {
        const REACH: ::core::option::Option<#runtime::Reach> = ::core::option::Option::Some(#runtime::Reach::of::<Self>());
    };
    let sites = quote!(#runtime::Sites<'_, #scalar, #leaf, Self::Parameters<#scalar>>);
    let lattice = quote! {
        #[inline(always)]
        fn sites<#scalar: #runtime::Real, #leaf: #runtime::Precision>(
            motion: &mut Self::Motion<#scalar, #leaf>,
        ) -> ::core::option::Option<#sites> {
            ::core::option::Option::Some(motion.sites())
        }
        #[inline(always)]
        fn along<#scalar: #runtime::Real, #leaf: #runtime::Precision>(
            lattice: &mut #sites,
            flow: &#runtime::Flow,
            sites: ::core::ops::Range<usize>,
        ) {
            lattice.take::<Self>(flow, sites);
        }
    };
    (reach, lattice)
}

/// Where the values of shares go.
pub(super) fn placed(gathered: &Gathered) -> Vec<Placed> {
    let context: Vec<_> = gathered.directions.iter().map(|direction| Around::Loop(direction.place)).collect();
    let placed = gathered.shares.iter().enumerate().map(|(number, share)| Placed {
        context: context.clone(),
        sink: Sink::Share(number),
        value: share.value,
    });
    placed.collect()
}

/// The name of the shares that go `onward`: `share_1`, or `share_1_0` over rows and sites.
fn share(onward: &[usize]) -> Ident {
    let onward: Vec<_> = onward.iter().map(ToString::to_string).collect();
    format_ident!("share_{}", onward.join("_"))
}

impl Printer<'_> {
    /// A coordinate of a neighbour.
    pub(super) fn neighbour(&self, element: Element) -> TokenStream {
        let far = |index| match self.graph.loops.index(index) {
            Index::Add(_, far) => (true, self.graph.loops.literal(far).unwrap_or_default()),
            Index::Sub(_, far) => (false, self.graph.loops.literal(far).unwrap_or_default()),
            _ => (true, 0),
        };
        let row = match element.component.map(|_| far(element.index)) {
            None | Some((_, 0)) => quote!(at),
            Some((true, _)) => quote!(below),
            Some((false, _)) => quote!(above),
        };
        let (is_ahead, far) = far(element.component.unwrap_or(element.index));
        let far = Literal::u64_unsuffixed(far);
        if is_ahead { quote!(near.#row(#far)) } else { quote!(near.#row(-#far)) }
    }

    /// A prepared constant, the same at all sites, or what a table holds for them.
    pub(super) fn spread(&self, lattice: &Gathered, name: Ident, loops: LoopSet) -> TokenStream {
        let wide = self.scalar;
        let place = |by: LoopId| {
            let mut directions = lattice.directions.iter().enumerate();
            directions.find_map(|(number, direction)| {
                let ahead = Literal::i64_unsuffixed(-*direction.begins.get(&by)?);
                Some((number, ahead))
            })
        };
        match (&loops.iter().filter_map(place).collect::<Vec<_>>()[..], lattice.is_plane()) {
            ([(_, rows), (_, sites)], _) => quote!(near.table_of_rows(&parameters.#name, #rows, #sites)),
            ([(0, rows)], true) => quote!(near.table_over_rows(&parameters.#name, #rows)),
            ([(_, sites)], _) => quote!(near.table(&parameters.#name, #sites)),
            _ => quote!(#wide::splat(parameters.#name)),
        }
    }

    /// The line that notes a share.
    pub(super) fn share(&self, fields: &mut Fields, number: usize, value: TokenStream) -> TokenStream {
        let Frame::Sites(lattice) = self.frame else { return TokenStream::new() };
        let of = &lattice.shares[number];
        let name = share(&of.onward());
        let begun = lattice.shares[..number].iter().any(|before| before.onward() == of.onward());
        let mut range = |from: IndexId, to: IndexId| {
            let (from, to) = (self.index(fields, from), self.index(fields, to));
            quote!(#from..#to)
        };
        let (mut value, mut few) = (value, None);
        let methods = [(quote!(within), quote!(plus)), (quote!(within_rows), quote!(plus_in_rows))];
        // Sites come last, rows before them.
        for (along, (within, plus)) in of.along.iter().rev().zip(methods) {
            match along.places {
                Extent::All => {}
                Extent::Few(from, to) if few.is_none() => few = Some((plus, range(from, to))),
                Extent::Most(from, to) | Extent::Few(from, to) => {
                    let places = range(from, to);
                    value = quote!(near.#within(#places, #value));
                }
            }
        }
        if let Some((plus, places)) = few {
            let before = if begun { quote!(#name) } else { self.lifted(quote!(0.0)) };
            return quote!(let #name = near.#plus(#places, #before, #value););
        }
        if begun { quote!(let #name = #name + #value;) } else { quote!(let #name = #value;) }
    }

    /// All shares in order, with zero for those that no site has.
    pub(super) fn shares(&self, lattice: &Gathered) -> Vec<TokenStream> {
        let named = |onward: &Vec<usize>| match lattice.shares.iter().any(|share| share.onward() == *onward) {
            true => share(onward).to_token_stream(),
            false => self.lifted(quote!(0.0)),
        };
        lattice.places().iter().map(named).collect()
    }
}
