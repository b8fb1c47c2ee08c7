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

    /// The items of the runtime's `Stencil`.
    pub(super) fn items(&self, names: &Names) -> TokenStream {
        let (body, Names { runtime, scalar, wide, .. }) = (&self.body, names);
        let onward = self.gathered.onward();
        let count = Literal::usize_unsuffixed(self.gathered.places().len());
        let boundaries = self.gathered.directions.iter().zip(onward).rev();
        let mut boundaries = boundaries.map(|(direction, onward)| boundary_of(direction, onward, runtime));
        let sites = boundaries.next();
        let rows = boundaries.next().map(|rows| {
            quote! {
                const ROW_BOUNDARY: ::core::option::Option<#runtime::Boundary> = ::core::option::Option::Some(#rows);
            }
        });
        let (window, parameters, time) = (body.argument("window"), body.argument("parameters"), body.argument("time"));
        let (read, body) = (body.time(wide), &body.0);
        quote! {
            type Contributions<#wide: ::core::marker::Copy> = [#wide; #count];

            const BOUNDARY: #runtime::Boundary = #sites;
            #rows

            #[inline(always)]
            fn contributions<#scalar: #runtime::Real, #wide: #runtime::Block<#scalar>>(
                #window: &#runtime::Window<#scalar, #wide>,
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

/// The runtime's `Boundary` of a direction in which shares go so far.
fn boundary_of(direction: &Direction, onward: usize, runtime: &Ident) -> TokenStream {
    let Direction { first, last, behind, ahead, periodic, .. } = direction;
    let forward = Literal::usize_unsuffixed(onward);
    let [first, last, behind, ahead] = [first, last, behind, ahead].map(|number| Literal::u64_unsuffixed(*number));
    quote! {
        #runtime::Boundary {
            first: #first,
            last: #last,
            forward: #forward,
            behind: #behind,
            ahead: #ahead,
            periodic: #periodic,
        }
    }
}

/// What lets the runtime move a lattice a segment at a time: the stencil radii of its flows, and its sites.
pub(super) fn parts(names: &Names) -> (TokenStream, TokenStream) {
    let Names { runtime, scalar, leaf, .. } = names;
    let radii = quote! {
        const STENCIL_RADII: ::core::option::Option<#runtime::StencilRadii> =
            ::core::option::Option::Some(#runtime::StencilRadii::of::<Self>());
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
        fn apply_to_sites<#scalar: #runtime::Real, #leaf: #runtime::Precision>(
            lattice: &mut #sites,
            flow: &#runtime::Flow,
            sites: ::core::ops::Range<usize>,
        ) {
            lattice.apply::<Self>(flow, sites);
        }
    };
    (radii, lattice)
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

/// The name of the shares that go `onward`: `contribution_1`, or `contribution_1_0` over rows and sites.
fn share(onward: &[usize]) -> Ident {
    let onward: Vec<_> = onward.iter().map(ToString::to_string).collect();
    format_ident!("contribution_{}", onward.join("_"))
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
        if is_ahead { quote!(window.#row(#far)) } else { quote!(window.#row(-#far)) }
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
            ([(_, rows), (_, sites)], _) => quote!(window.table_of_rows(&parameters.#name, #rows, #sites)),
            ([(0, rows)], true) => quote!(window.table_over_rows(&parameters.#name, #rows)),
            ([(_, sites)], _) => quote!(window.table(&parameters.#name, #sites)),
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
        let methods = [(quote!(masked), quote!(masked_add)), (quote!(row_masked), quote!(row_masked_add))];
        // Sites come last, rows before them.
        for (along, (within, plus)) in of.along.iter().rev().zip(methods) {
            match along.places {
                Extent::All => {}
                Extent::Few(from, to) if few.is_none() => few = Some((plus, range(from, to))),
                Extent::Most(from, to) | Extent::Few(from, to) => {
                    let places = range(from, to);
                    value = quote!(window.#within(#places, #value));
                }
            }
        }
        if let Some((plus, places)) = few {
            let before = if begun { quote!(#name) } else { self.lifted(quote!(0.0)) };
            return quote!(let #name = window.#plus(#places, #before, #value););
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
