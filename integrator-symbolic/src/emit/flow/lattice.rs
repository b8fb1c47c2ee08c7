//! Flows of lattices as Rust: what each site computes from its neighbourhood, for the runtime to sweep along.

use crate::{
    differentiate::{Contribution, fold_branches},
    emit::printer::{
        block::Emitter,
        fields::{is_leaf, lower_roots},
        frame::Frame,
        function::Body,
        names::Names,
        sites::contributions,
    },
    graph::{Graph, Part, Scope},
    model::Model,
    program::{Sink, Store},
    stencil::{Components, Direction, Lattice, Stencil, stencil},
};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

/// A flow that all sites take part in alike.
pub(crate) struct Sweep {
    /// Its type in the runtime.
    flow: Ident,
    body: Body,
    stencil: Stencil,
}

/// What the gradient of the potential tells of coordinates with two indices. A kinetic energy looks the same for points as
/// for rows of sites.
pub(super) fn components(emitter: &mut Emitter<'_>, potential: &[Contribution]) -> Components {
    let Model { graph, parameters, extents, .. } = &mut *emitter.model;
    let has_unknown_width = matches!(extents[..], [_, width] if graph.loops.literal(width).is_none());
    if !has_unknown_width {
        return Components::Unknown;
    }
    let folded = fold_branches(graph, potential);
    let leaf = |graph: &Graph, id| is_leaf(graph, parameters, id);
    stencil(graph, &folded, extents, Components::Unknown, leaf).map_or(Components::Unknown, |_| Components::Sites)
}

/// The stencil of `gradient`, if all sites take part alike.
pub(super) fn alike(emitter: &mut Emitter<'_>, gradient: &[Contribution], components: Components) -> Option<Stencil> {
    let model = &mut *emitter.model;
    let Model { graph, parameters, extents, .. } = &mut *model;
    let mut stencil = stencil(graph, gradient, extents, components, |graph, id| is_leaf(graph, parameters, id))?;
    for Direction { place, begins, .. } in &stencil.directions {
        let first = gradient.iter().flat_map(Contribution::loops).find(|by| begins.contains_key(by))?;
        let index = model.running.get(&first)?.clone();
        model.running.entry(*place).or_insert(index);
    }

    let values: Vec<_> = stencil.contributions.iter().map(|contribution| contribution.value).collect();
    for (contribution, value) in stencil.contributions.iter_mut().zip(lower_roots(model, &values)) {
        contribution.value = value;
    }
    Some(stencil)
}

/// The flow along `gradient`, if it has that form.
pub(crate) fn sweep(
    emitter: &mut Emitter<'_>,
    gradient: &[Contribution],
    part: Part,
    components: Components,
) -> Option<Sweep> {
    let stencil = alike(emitter, gradient, components)?;
    // The runtime goes from site to site.
    let sites: Vec<_> = stencil.directions.iter().map(|along| along.place).collect();
    let lines = emitter.evaluate(&Frame::Sites(&stencil), &sites, &stores(&stencil));
    let contributions = contributions(&stencil, emitter.names);
    let body = lines.map(|lines| quote!(#lines [#(#contributions),*])).body(&emitter.names.wide);
    let flow = match part {
        Part::Momentum => format_ident!("Drift"),
        Part::Position => format_ident!("Kick"),
    };
    Some(Sweep { flow, body, stencil })
}

impl Sweep {
    /// The flow, as the runtime goes about it.
    pub(crate) fn flow(&self) -> TokenStream {
        let layers = if self.lattice() == Lattice::Line { "" } else { "_layers" };
        let method = format_ident!("{}{layers}", self.flow.to_string().to_lowercase());
        quote!(motion.#method::<Self>(duration, time);)
    }

    /// What the runtime calls at every site.
    pub(super) fn implementation(
        &self,
        implementation: impl Fn(TokenStream, &TokenStream) -> TokenStream,
        names: &Names,
    ) -> TokenStream {
        let (runtime, flow) = (&names.runtime, &self.flow);
        let stencil = implementation(quote!(#runtime::Stencil<#runtime::#flow>), &self.items(names));
        quote! {
            /// What every site computes from its neighbourhood, for itself and for the sites further on.
            #stencil
        }
    }

    /// The items of the runtime's `Stencil`.
    fn items(&self, names: &Names) -> TokenStream {
        let (body, Names { runtime, scalar, wide, .. }) = (&self.body, names);
        let onward = self.stencil.onward();
        let count = Literal::usize_unsuffixed(self.stencil.places().len());
        let boundaries = self.stencil.directions.iter().zip(onward).rev();
        let mut boundaries = boundaries.map(|(direction, onward)| boundary_of(direction, onward, runtime));
        let sites = boundaries.next();
        let across = [format_ident!("ROW_BOUNDARY"), format_ident!("PLANE_BOUNDARY")];
        let across = across.iter().zip(boundaries).map(|(name, boundary)| {
            quote! {
                const #name: ::core::option::Option<#runtime::Boundary> = ::core::option::Option::Some(#boundary);
            }
        });
        let (window, parameters, time) = (body.argument("window"), body.argument("parameters"), body.argument("time"));
        let body = &body.0;
        quote! {
            type Contributions<#wide: ::core::marker::Copy> = [#wide; #count];

            const BOUNDARY: #runtime::Boundary = #sites;
            #(#across)*

            #[inline(always)]
            fn contributions<#scalar: #runtime::Real, #wide: #runtime::Block<#scalar>>(
                #window: &#runtime::Window<#scalar, #wide>,
                #parameters: &Self::Parameters<#scalar>,
                #time: f64,
            ) -> [#wide; #count] { #body }
        }
    }

    /// What the sites that it moves make up.
    pub(crate) fn lattice(&self) -> Lattice {
        self.stencil.lattice()
    }
}

/// The runtime's `Boundary` of a direction in which contributions go so far.
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
pub(crate) fn parts(lattice: Lattice, names: &Names) -> (TokenStream, TokenStream) {
    let [all, apply] = match lattice {
        Lattice::Line => ["sites", "apply"],
        Lattice::Plane | Lattice::Volume => ["layers", "apply_to_layers"],
    };
    let [all, apply] = [all, apply].map(|name| format_ident!("{name}"));
    let Names { runtime, scalar, leaf, .. } = names;
    let radii = quote! {
        const STENCIL_RADII: ::core::option::Option<#runtime::StencilRadii> =
            ::core::option::Option::Some(#runtime::StencilRadii::of::<Self>());
    };
    let [sites, moved] = ["Sites", "MovedSites"].map(|name| {
        let name = format_ident!("{name}");
        quote!(#runtime::#name<'_, #scalar, #leaf, Self::Parameters<#scalar>>)
    });
    let lattice = quote! {
        #[inline(always)]
        fn sites<#scalar: #runtime::Real, #leaf: #runtime::Precision>(
            motion: &mut Self::Motion<#scalar, #leaf>,
        ) -> ::core::option::Option<#sites> {
            ::core::option::Option::Some(motion.#all())
        }
        #[inline(always)]
        fn apply_to_sites<#scalar: #runtime::Real, #leaf: #runtime::Precision>(
            lattice: #moved,
            flow: &#runtime::Flow,
            sites: ::core::ops::Range<usize>,
        ) {
            lattice.#apply::<Self>(flow, sites);
        }
    };
    (radii, lattice)
}

/// Where the values of contributions go.
pub(super) fn stores(stencil: &Stencil) -> Vec<Store> {
    let context: Vec<_> = stencil.directions.iter().map(|direction| Scope::Loop(direction.place)).collect();
    let stores = stencil.contributions.iter().enumerate().map(|(number, contribution)| Store {
        context: context.clone(),
        sink: Sink::Contribution(number),
        value: contribution.value,
    });
    stores.collect()
}
