//! Rust code for bodies with pair interactions: the motion of a body, and the force of one body on another. The loops
//! over bodies and pairs belong to the runtime.

mod triplets;

use super::through_buffer;
use crate::{
    emit::printer::{
        block::Emitter,
        frame::Frame,
        function::{Body, Lines},
    },
    graph::{NodeId, Part, index::LoopId},
    model::Model,
    pattern::{
        all_pairs::{
            AllPairs, Bodies, EmbeddedOfBodies, EnergiesOfBodies, First, Included, LISTED_FROM, Listed, Others, ROW,
        },
        bodies::{Constants, OfBodies},
    },
    syntax::names::Names,
};
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

/// The parts of a stepper for bodies that act in pairs.
pub(crate) struct ManyBody {
    /// How many bodies, where they are one row.
    row: Option<Literal>,
    /// How many coordinates and how many prepared constants a body has.
    sizes: [Literal; 2],
    /// What the runtime requires of the system.
    functions: TokenStream,
    /// The prepared constants of one body, by its index, and how many bodies act and move.
    per_body: TokenStream,
    /// Whether neighbours within a cutoff are listed, and whether they are those in a box.
    listed: Option<bool>,
    /// Whether there are terms of three bodies.
    has_triplets: bool,
    /// The energy of the terms beside pairs, if there are any.
    others: Option<NodeId>,
    /// Whether the runtime sums the energies of pairs.
    sums_pairs: bool,
    /// What the kinetic energy is beside those of bodies, if the runtime sums these.
    kinetic_beside: Option<NodeId>,
}

impl ManyBody {
    /// What a potential of pairs and a kinetic energy of bodies are written as.
    pub(crate) fn of(emitter: &mut Emitter<'_>, pairs: &AllPairs) -> Self {
        let is_part = pairs.drift.is_none();
        let wide = &emitter.names.wide;
        let AllPairs {
            pair,
            visited: _,
            dimension,
            constants,
            drift,
            acts,
            force,
            central,
            reciprocal,
            alone,
            embedded,
            triplets,
            triplet_obstacle: _,
            others,
            energies,
            listed,
            included,
            of,
            number,
        } = pairs;
        let (pair, central) = (*pair, *central);
        let sizes = [Literal::u64_unsuffixed(*dimension), Literal::usize_unsuffixed(constants.count())];
        let row = emitter.model.shape.length.literal().filter(|length| *length <= ROW).map(Literal::u64_unsuffixed);
        let mut writer = Writer { emitter, constants, sizes: &sizes };
        let drift = drift.as_ref().map(|drift| writer.drift(drift));
        let functions = [drift, Some(writer.pair(force, central, pair))];
        let acts = acts.as_ref().map(|(condition, holds)| writer.acts(condition, *holds, pair));
        let included = included.as_ref().map(|included| writer.included(included, pair));
        let alone = alone.as_ref().map(|alone| writer.alone(alone));
        let embedded = embedded.as_ref().map(|embedded| writer.embedded(embedded));
        let has_triplets = triplets.is_some();
        let triplets = triplets.as_ref().map(|triplets| writer.triplets(triplets, energies.is_some()));
        let beside = others.as_ref().filter(|others| !others.gradient.is_empty());
        let beside = beside.map(|others| writer.others(others));
        let of_energies = energies.as_ref().map(|energies| writer.energies(energies, pair));
        let listed = listed.as_ref().ok();
        let neighbours = listed.map(|listed| writer.listed(listed));
        let per_body = writer.per_body(of, is_part);
        let parts = if central { Literal::u64_unsuffixed(1) } else { sizes[0].clone() };
        let number = number.filter(|_| listed.is_some()).map(|number| {
            let number = Literal::usize_unsuffixed(number);
            quote!(
                const NUMBER: ::core::option::Option<usize> = ::core::option::Option::Some(#number);
            )
        });
        let some_stay = (of.acting.is_some() || of.moving.is_some()).then(|| {
            quote!(
                const SOME_STAY: bool = true;
            )
        });
        let functions = quote! {
            #number
            #some_stay
            const RECIPROCAL: bool = #reciprocal;
            const CENTRAL: bool = #central;
            type Force<#wide: ::core::marker::Copy> = [#wide; #parts];

            #(#functions)*
            #acts
            #included
            #alone
            #embedded
            #triplets
            #beside
            #of_energies
            #neighbours
        };
        let listed = listed.map(|listed| listed.sides.is_some());
        let others = others.as_ref().map(|others| others.energy);
        let sums_pairs = energies.is_some();
        let kinetic_beside = energies.as_ref().and_then(|energies| energies.kinetic_beside);
        Self { row, sizes, functions, per_body, listed, has_triplets, others, sums_pairs, kinetic_beside }
    }

    /// Whether the runtime sums an energy, and what this has beside the terms of bodies and pairs.
    pub(crate) fn energy(&self, name: &str) -> (bool, Option<NodeId>) {
        match name {
            "potential" => (self.sums_pairs, self.others),
            _ => (self.kinetic_beside.is_some(), self.kinetic_beside),
        }
    }

    /// Whether neighbours within a cutoff are listed, and whether they are those in a box.
    pub(crate) fn listed(&self) -> Option<bool> {
        self.listed
    }

    /// Whether there are terms of three bodies.
    pub(crate) fn has_triplets(&self) -> bool {
        self.has_triplets
    }

    /// Whether the bodies are one row.
    pub(crate) fn is_row(&self) -> bool {
        self.row.is_some()
    }

    /// The flow that moves the other part, whose loops over bodies are the runtime's.
    pub(crate) fn flow(part: Part) -> Body {
        Body::new(match part {
            Part::Momentum => quote!(motion.drift::<Self>(duration, time);),
            Part::Position => quote!(motion.kick::<Self>(duration, time);),
        })
    }

    /// The layout of the motion.
    pub(crate) fn motion(&self, parameters: &TokenStream, names: &Names) -> TokenStream {
        let Names { runtime, scalar, leaf, .. } = names;
        let [d, s] = &self.sizes;
        match &self.row {
            Some(row) => quote!(#runtime::OneRow<#scalar, #leaf, #parameters, #row, #d, #s>),
            None => quote!(#runtime::ManyRows<#scalar, #leaf, #parameters, #d, #s>),
        }
    }

    /// The number of coordinates of a body.
    pub(crate) fn dimension(&self) -> &Literal {
        &self.sizes[0]
    }

    /// The implementations of what the runtime requires of the system and of its prepared constants.
    pub(crate) fn implementations(
        &self,
        implementation: impl Fn(TokenStream, &TokenStream) -> TokenStream,
        parameters: &TokenStream,
        names: &Names,
    ) -> TokenStream {
        let (runtime, Self { sizes: [d, s], functions, per_body, .. }) = (&names.runtime, self);
        let many_body = implementation(quote!(#runtime::ManyBody<#d, #s>), functions);
        quote! {
            #many_body

            impl #runtime::BodyConstants<#s> for #parameters { #per_body }
        }
    }
}

impl ManyBody {
    /// How many coordinates and how many prepared constants a body has.
    pub(crate) fn sizes(&self) -> &[Literal; 2] {
        &self.sizes
    }

    /// What the runtime requires of a part of H, and of its prepared constants.
    pub(crate) fn of_part(&self) -> [&TokenStream; 2] {
        [&self.functions, &self.per_body]
    }
}

/// The number of bodies that act on each other as Rust, by the length of the coordinates, if it is not this length.
pub(crate) fn count(pairs: &AllPairs, model: &Model) -> Option<TokenStream> {
    let Bodies { flat, acting, .. } = pairs.of;
    let all = flat.map(|components| {
        let components = Literal::u64_unsuffixed(components);
        quote!(length / #components)
    });
    match acting {
        None => all,
        Some(First { number, or_all: false }) => Some(model.text(number)),
        Some(First { number, or_all: true }) => {
            let (number, all) = (model.text(number), all.unwrap_or_else(|| quote!(length)));
            Some(quote!(::core::cmp::Ord::min(#number, #all)))
        }
    }
}

/// What writes the functions.
struct Writer<'w, 'm> {
    emitter: &'w mut Emitter<'m>,
    constants: &'w Constants,
    sizes: &'w [Literal; 2],
}

impl Writer<'_, '_> {
    /// What the flow of `T` does to a body.
    fn drift(&mut self, drift: &OfBodies) -> TokenStream {
        let [q, p, of] = ["q", "p", "constants"].map(|what| OfBodies::name_of(what, self.emitter.model, drift.of[0]));
        let body = self.lines(drift);
        let (Names { runtime, wide, leaf, .. }, [d, s]) = (self.emitter.names, self.sizes);
        let generics = quote!(#leaf: #runtime::Slot<#wide>);
        let arguments = quote!(#q: &mut [#leaf; #d], #p: [#wide; #d], #of: [#wide; #s], step: #wide);
        self.function("drift_body", generics, arguments, None, body)
    }

    /// The gradient of the energy of a pair by the coordinates of its first body, or what their displacement is to be
    /// multiplied by.
    fn pair(&mut self, pair: &OfBodies, central: bool, of: [LoopId; 2]) -> TokenStream {
        let body = if central {
            self.lines(pair).map(|pull| quote!(let radial = { #pull }; [radial]))
        } else {
            self.gradient(pair, quote!(gradient))
        };
        let wide = &self.emitter.names.wide;
        self.function("pair", TokenStream::new(), self.two_bodies(of), Some(quote!(Self::Force<#wide>)), body)
    }

    /// Whether a condition holds for a pair.
    fn acts(&mut self, condition: &OfBodies, holds: bool, of: [LoopId; 2]) -> TokenStream {
        let negated = (!holds).then(|| quote!(.not()));
        let body =
            self.lines(condition).map(|condition| quote!(let interacting = { #condition }; interacting #negated.any()));
        self.function("interacts", TokenStream::new(), self.two_bodies(of), Some(quote!(bool)), body)
    }

    /// Whether lists do not leave a pair out.
    fn included(&mut self, Included { condition, own }: &Included, of: [LoopId; 2]) -> TokenStream {
        let (wide, own) = (self.emitter.names.wide.clone(), Literal::usize_unsuffixed(*own));
        let body = self.lines(condition);
        let included =
            self.function("included", TokenStream::new(), self.two_bodies(of), Some(quote!(#wide::Mask)), body);
        quote! {
            const LEAVES_OUT: ::core::option::Option<usize> = ::core::option::Option::Some(#own);

            #included
        }
    }

    /// The coordinates and prepared constants of a pair, as arguments.
    fn two_bodies(&self, of: [LoopId; 2]) -> TokenStream {
        let [q_i, q_j] = of.map(|by| OfBodies::name_of("q", self.emitter.model, by));
        let [of_i, of_j] = of.map(|by| OfBodies::name_of("constants", self.emitter.model, by));
        let (wide, [d, s]) = (&self.emitter.names.wide, self.sizes);
        quote!(#q_i: [#wide; #d], #q_j: [#wide; #d], #of_i: [#wide; #s], #of_j: [#wide; #s])
    }

    /// The gradient of what a body has alone.
    fn alone(&mut self, alone: &OfBodies) -> TokenStream {
        let body = self.gradient(alone, quote!(::core::option::Option::Some(gradient)));
        let (d, wide) = (&self.sizes[0], &self.emitter.names.wide);
        let result = quote!(::core::option::Option<[#wide; #d]>);
        self.function("one_body", TokenStream::new(), self.one_body(alone), Some(result), body)
    }

    /// The densities of a body, and their weights.
    fn embedded(&mut self, EmbeddedOfBodies { densities, weights, .. }: &EmbeddedOfBodies) -> TokenStream {
        let places = self.constants.densities.iter().map(|place| Literal::usize_unsuffixed(*place));
        let places = quote!(&[#(#places),*]);
        let (wide, d) = (self.emitter.names.wide.clone(), self.sizes[0].clone());
        let result = || Some(quote!([#wide; #d]));
        let pair = [densities.of[0], densities.of[1]];
        let body = self.gradient(densities, quote!(gradient));
        let densities = self.function("densities", TokenStream::new(), self.two_bodies(pair), result(), body);
        let (of, s) = (OfBodies::name_of("constants", self.emitter.model, weights.of[0]), self.sizes[1].clone());
        let body = self.gradient(weights, quote!(gradient));
        let weights = self.function("weights", TokenStream::new(), quote!(#of: [#wide; #s]), result(), body);
        quote! {
            const DENSITIES: &'static [usize] = #places;

            #densities
            #weights
        }
    }

    /// The gradient of the terms beside pairs, in the user's own coordinates.
    fn others(&mut self, others: &Others) -> TokenStream {
        let put = |place, value| quote!(#place = #value;);
        let lines = through_buffer(self.emitter, &Frame::Motion, Part::Momentum, &others.gradient, put);
        let Names { runtime, scalar, .. } = self.emitter.names;
        let body = lines.body(scalar);
        let (motion, time, body) = (body.argument("motion"), body.argument("time"), &body.0);
        quote! {
            const OTHER_TERMS: bool = true;

            #[inline(always)]
            fn other_terms<#scalar: #runtime::Real>(
                #motion: #runtime::Unpacked<'_, #scalar, Self::Coords, Self::Parameters<#scalar>>,
                #time: f64,
            ) { #body }
        }
    }

    /// The coordinates and prepared constants of a body, as arguments.
    fn one_body(&self, alone: &OfBodies) -> TokenStream {
        let [q, of] = ["q", "constants"].map(|what| OfBodies::name_of(what, self.emitter.model, alone.of[0]));
        let ([d, s], wide) = (self.sizes, &self.emitter.names.wide);
        quote!(#q: [#wide; #d], #of: [#wide; #s])
    }

    /// The condition under which neighbours within a cutoff are listed.
    fn listed(&mut self, listed: &Listed) -> TokenStream {
        let Listed { square, sides } = listed;
        let (wide, d, none) = (self.emitter.names.wide.clone(), self.sizes[0].clone(), TokenStream::new);
        let square = self.lines(square);
        let square = self.function("cutoff", none(), none(), Some(quote!(#wide)), square);
        let sides = sides.as_ref().map(|sides| {
            let sides = self.gradient(sides, quote!(gradient));
            self.function("sides", none(), none(), Some(quote!([#wide; #d])), sides)
        });
        let from = Literal::u64_unsuffixed(LISTED_FROM);
        quote! {
            const LISTED_FROM: usize = #from;

            #square
            #sides
        }
    }

    /// The energies of a pair and of a body.
    fn energies(&mut self, energies: &EnergiesOfBodies, of: [LoopId; 2]) -> TokenStream {
        let EnergiesOfBodies { pair, alone, .. } = energies;
        let (wide, none) = (self.emitter.names.wide.clone(), TokenStream::new);
        let pair = self.lines(pair);
        let pair = self.function("energy", none(), self.two_bodies(of), Some(quote!(#wide)), pair);
        let alone = alone.as_ref().map(|alone| {
            let lines = self.lines(alone).map(|energy| quote!(::core::option::Option::Some({ #energy })));
            let result = quote!(::core::option::Option<#wide>);
            self.function("energy_alone", none(), self.one_body(alone), Some(result), lines)
        });
        quote!(#pair #alone)
    }

    fn lines(&mut self, of: &OfBodies) -> Lines {
        of.lines(self.emitter, self.constants)
    }

    /// A function of bodies in lanes.
    fn function(
        &self,
        name: &str,
        generics: TokenStream,
        arguments: TokenStream,
        result: Option<TokenStream>,
        lines: Lines,
    ) -> TokenStream {
        let Names { runtime, scalar, wide, .. } = self.emitter.names;
        let (name, result) = (format_ident!("{name}"), result.map(|result| quote!(-> #result)));
        let body = lines.body(wide);
        let (time, parameters, body) = (body.argument("time"), body.argument("parameters"), &body.0);
        let comma = (!arguments.is_empty()).then(|| quote!(,));
        quote! {
            #[inline(always)]
            fn #name<#scalar: #runtime::Real, #wide: #runtime::Row<#scalar>, #generics>(
                #parameters: &Self::Parameters<#scalar>,
                #arguments #comma
                #time: f64,
            ) #result { #body }
        }
    }

    /// The components of a gradient as an array, and what is returned of it.
    fn gradient(&mut self, of: &OfBodies, result: TokenStream) -> Lines {
        let (wide, d) = (&self.emitter.names.wide, &self.sizes[0]);
        self.lines(of).map(|lines| {
            quote! {
                let mut gradient = [#wide::of(0.0); #d];
                #lines
                #result
            }
        })
    }

    /// The prepared constants of a body as an array.
    ///
    /// They are methods of the struct of prepared constants, or functions of it for a part of H.
    fn per_body(&mut self, of: &Bodies, is_part: bool) -> TokenStream {
        let (receiver, from) = match is_part {
            true => (quote!(parameters: &Self::Parameters<f64>), quote!(parameters)),
            false => (quote!(&self), quote!(self)),
        };
        let index = self.emitter.model.running.get(&self.constants.bodies);
        let index = index.map_or_else(|| format_ident!("body"), Clone::clone);
        let fields = self.constants.of_body(self.emitter.model, &mut self.emitter.fields, &from, &index);
        let reads_any = self.constants.densities.len() < fields.len();
        let argument = if reads_any { index } else { format_ident!("_body") };
        let s = &self.sizes[1];
        // The rows of bodies in Jacobi coordinates begin with the one that leads.
        let leading = self.emitter.model.jacobi().filter(|_| reads_any).map(|jacobi| {
            let (runtime, parameters) = (&self.emitter.names.runtime, &self.emitter.model.parameters);
            let leading = self.emitter.fields.integer(parameters, jacobi.leading);
            quote!(let #argument = #runtime::body_at(self.#leading, #argument);)
        });
        let counts = [("acting", of.acting), ("moving", of.moving)];
        let (parameters, fields_of) = (&self.emitter.model.parameters, &mut self.emitter.fields);
        let counts = counts.into_iter().filter_map(|(name, first)| {
            let (name, number) = (format_ident!("{name}"), fields_of.integer(parameters, first?.number));
            Some(quote! {
                #[inline]
                fn #name(#receiver, bodies: usize) -> usize { ::core::cmp::Ord::min(#from.#number, bodies) }
            })
        });
        let counts: TokenStream = counts.collect();
        quote! {
            #[inline]
            fn body_constants(#receiver, #argument: usize) -> [f64; #s] { #leading [#(#fields),*] }
            #counts
        }
    }
}
