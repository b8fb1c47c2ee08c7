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
    gather::{Extent, Gathered, Share, gathered},
    graph::{
        Around, Element, Part,
        index::{Index, LoopSet},
    },
    model::Model,
    program::{Placed, Sink},
};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

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
    let Model { graph, parameters, length, .. } = model;
    let mut gathered = gathered(graph, gradient, *length, |graph, id| is_leaf(graph, parameters, id))?;
    let first = gradient.iter().find_map(|contribution| contribution.loops().next())?;
    let index = model.running.get(&first)?.clone();
    model.running.entry(gathered.site).or_insert(index);

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
        let method = format_ident!("{}", self.flow.to_string().to_lowercase());
        quote!(motion.#method::<Self>(duration, time);)
    }

    /// The items of the runtime's `Gather`.
    pub(super) fn items(&self, names: &Names) -> TokenStream {
        let Self { body, gathered: Gathered { first, last, behind, ahead, periodic, .. }, .. } = self;
        let Names { runtime, scalar, wide, .. } = names;
        let onward = self.gathered.onward();
        let count = Literal::usize_unsuffixed(onward + 1);
        let onward = Literal::usize_unsuffixed(onward);
        let [first, last, behind, ahead] = [first, last, behind, ahead].map(|number| Literal::u64_unsuffixed(*number));
        let (near, parameters, time) = (body.argument("near"), body.argument("parameters"), body.argument("time"));
        let (read, body) = (body.time(wide), &body.0);
        quote! {
            type Shares<#wide: ::core::marker::Copy> = [#wide; #count];

            const EDGES: #runtime::Edges = #runtime::Edges {
                first: #first,
                last: #last,
                onward: #onward,
                behind: #behind,
                ahead: #ahead,
                periodic: #periodic,
            };

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
        fn sites<#scalar: #runtime::Real, #leaf: #runtime::Keep>(
            motion: &mut Self::Motion<#scalar, #leaf>,
        ) -> ::core::option::Option<#sites> {
            ::core::option::Option::Some(motion.sites())
        }
        #[inline(always)]
        fn along<#scalar: #runtime::Real, #leaf: #runtime::Keep>(
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
    let context = vec![Around::Loop(gathered.site)];
    let placed = gathered.shares.iter().enumerate().map(|(number, share)| Placed {
        context: context.clone(),
        sink: Sink::Share(number),
        value: share.value,
    });
    placed.collect()
}

/// The name of the shares that go `onward`.
pub(super) fn share(onward: usize) -> Ident {
    format_ident!("share_{onward}")
}

impl Printer<'_> {
    /// A coordinate of a neighbour.
    pub(super) fn neighbour(&self, element: Element) -> TokenStream {
        let literal = |id| Literal::u64_unsuffixed(self.graph.loops.literal(id).unwrap_or_default());
        let ahead = match self.graph.loops.index(element.index) {
            Index::Add(_, far) => {
                let far = literal(far);
                quote!(#far)
            }
            Index::Sub(_, far) => {
                let far = literal(far);
                quote!(-#far)
            }
            _ => quote!(0),
        };
        quote!(near.at(#ahead))
    }

    /// A prepared constant, the same at all sites, or what a table holds for them.
    pub(super) fn spread(&self, lattice: &Gathered, name: Ident, loops: LoopSet) -> TokenStream {
        let wide = self.scalar;
        match loops.iter().next() {
            None => quote!(#wide::splat(parameters.#name)),
            Some(by) => {
                let ahead = -lattice.begins.get(&by).copied().unwrap_or_default();
                let ahead = Literal::i64_unsuffixed(ahead);
                quote!(near.table(&parameters.#name, #ahead))
            }
        }
    }

    /// The line that notes a share.
    pub(super) fn share(&self, fields: &mut Fields, number: usize, value: TokenStream) -> TokenStream {
        let Frame::Sites(lattice) = self.frame else { return TokenStream::new() };
        let Share { onward, sites, .. } = lattice.shares[number];
        let name = share(onward);
        let begun = lattice.shares[..number].iter().any(|share| share.onward == onward);
        let mut range = |from, to| {
            let (from, to) = (self.bound(fields, from), self.bound(fields, to));
            quote!(#from..#to)
        };
        let share = match sites {
            Extent::All => value,
            Extent::Most(from, to) => {
                let sites = range(from, to);
                quote!(near.within(#sites, #value))
            }
            Extent::Few(from, to) => {
                let sites = range(from, to);
                let before = if begun { quote!(#name) } else { self.lifted(quote!(0.0)) };
                return quote!(let #name = near.plus(#sites, #before, #value););
            }
        };
        if begun { quote!(let #name = #name + #share;) } else { quote!(let #name = #share;) }
    }
}
