//! Rust code for flows of lattices: the computation of each site from its neighbourhood, over which the runtime sweeps.

use crate::{
    emit::printer::{block::Emitter, expression::Printer, frame::Frame, function::Body, sites::contributions},
    graph::{Part, index::IndexId},
    pattern::sites::{lowered, stores},
    program::Program,
    stencil::{Direction, Lattice, Stencil},
    syntax::names::Names,
};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

/// A flow or an energy that all sites take part in alike.
pub(crate) struct Sweep {
    /// Its type in the runtime.
    flow: Ident,
    body: Body,
    stencil: Stencil,
    /// Where coordinates are flat, the number of sites in a row if rows are all of them.
    columns: Option<TokenStream>,
}

/// The flow along a gradient with this stencil.
pub(crate) fn sweep(emitter: &mut Emitter<'_>, stencil: &Stencil, part: Part) -> Sweep {
    let flow = match part {
        Part::Momentum => format_ident!("Drift"),
        Part::Position => format_ident!("Kick"),
    };
    of_sites(emitter, stencil, flow)
}

/// An energy, `kinetic` or `potential`, whose terms have this stencil.
pub(crate) fn energy(emitter: &mut Emitter<'_>, stencil: &Stencil, name: &str) -> Sweep {
    let energy = if name == "kinetic" { "KineticEnergy" } else { "PotentialEnergy" };
    of_sites(emitter, stencil, format_ident!("{energy}"))
}

/// What sites compute from their neighbourhoods.
fn of_sites(emitter: &mut Emitter<'_>, stencil: &Stencil, flow: Ident) -> Sweep {
    let stencil = lowered(emitter.model, stencil);
    // The runtime goes from site to site.
    let sites: Vec<_> = stencil.directions.iter().map(|along| along.place).collect();
    let lines = emitter.evaluate(&Frame::Sites(&stencil), &sites, &stores(&stencil));
    let contributions = contributions(&stencil, emitter.names);
    let body = lines.map(|lines| quote!(#lines [#(#contributions),*])).body(&emitter.names.wide);
    let columns = stencil.flat.map(|lengths| columns(emitter, lengths));
    Sweep { flow, body, stencil, columns }
}

/// The function that returns the number of sites in a row of flat coordinates.
fn columns(emitter: &mut Emitter<'_>, lengths: [IndexId; 2]) -> TokenStream {
    let Emitter { model, names, fields } = emitter;
    let Names { runtime, scalar, .. } = names;
    let program = Program::default();
    let printer = Printer::new(model, names, &program, &Frame::Constants);
    let [rows, width] = lengths.map(|number| printer.index(fields, number));
    let body = Body::new(quote!(#runtime::columns(#width, length, || #rows)));
    let (parameters, body) = (body.argument("parameters"), &body.0);
    quote! {
        const FLAT_ROWS: bool = true;
        #[inline(always)]
        fn columns<#scalar: #runtime::Real>(#parameters: &Self::Parameters<#scalar>, length: usize) -> ::core::option::Option<usize> {
            #body
        }
    }
}

impl Sweep {
    /// The flow, as the runtime goes about it.
    fn flow(&self) -> TokenStream {
        let layers = if self.lattice() == Lattice::Line { "" } else { "_layers" };
        let method = format_ident!("{}{layers}", self.flow.to_string().to_lowercase());
        quote!(motion.#method::<Self>(duration, time);)
    }

    /// The flow, or other lines where flat coordinates are no rows of sites.
    pub(crate) fn flow_or(&self, otherwise: impl FnOnce() -> TokenStream) -> TokenStream {
        let flow = self.flow();
        if self.columns.is_none() {
            return flow;
        }
        let otherwise = otherwise();
        quote!(if motion.layers::<Self>().is_some() { #flow } else { #otherwise })
    }

    /// The lines that return an energy; other lines where flat coordinates are no rows of sites.
    pub(crate) fn energy_or(&self, name: &str, otherwise: impl FnOnce() -> TokenStream, names: &Names) -> TokenStream {
        let (method, scalar) = (format_ident!("{name}_of_layers"), &names.scalar);
        let energy = quote!(motion.#method::<Self>(time));
        if self.columns.is_none() {
            return energy;
        }
        let otherwise = otherwise();
        quote! {
            if Self::columns::<#scalar>(&motion.parameters, motion.q.len()).is_some() { #energy } else { #otherwise }
        }
    }

    /// The stencil of the sites.
    pub(crate) fn stencil(&self) -> &Stencil {
        &self.stencil
    }

    /// What the runtime is told about rows of flat coordinates.
    pub(super) fn columns(&self) -> Option<&TokenStream> {
        self.columns.as_ref()
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
            /// What every site computes from its neighbourhood, for itself and for the sites ahead.
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
    let Names { runtime, scalar, leaf, .. } = names;
    let (all, apply) = match lattice {
        Lattice::Line => (quote!(::core::option::Option::Some(motion.sites())), format_ident!("apply")),
        Lattice::Plane | Lattice::Volume => (quote!(motion.layers::<Self>()), format_ident!("apply_to_layers")),
    };
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
            #all
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
