//! The stepper as Rust code.
//!
//! In: a valid model. Out: the implementations of the runtime's `Hamiltonian` and `System`, in a separate scope. Always
//! true: nothing here fails but the code for devices; the same model gives the same tokens; the code contains only paths
//! of the user, of `::core`, and of the runtime's private API.

mod fingerprint;
mod flow;
mod order;
mod other_name;
mod printer;
mod read_by_methods;
mod taylor;

use crate::{
    differentiate::Contribution,
    graph::NodeId,
    judge::coordinates::KEPLER_PARTS,
    model::{ExactPart, Length, Model, Split, operand},
    pattern::{Pattern, all_pairs::AllPairs, gradients, gradients_of, recognise},
    prose::{equations, motion_documentation, stated},
    scheme::Class,
    syntax::{Compose, Gpu, Input, names::Names},
};
use fingerprint::fingerprint;
pub use flow::device::exported::{Exported, ExportedConstant};
use flow::{
    Flows,
    constants::{Constants, with_count},
    device::{DeviceText, exported},
    field, force_gradient, friction, invariants, jacobi, nested, parameter_slopes,
    pieces::Pieces,
    rated_field, transformed, user_energies,
};
pub(crate) use printer::cuda::{device_functions, identifier_of};
use printer::{block::Emitter, fields::Fields};
use proc_macro2::{Literal, TokenStream};
use quote::{ToTokens, quote, quote_spanned};
use read_by_methods::ReadByMethods;
use syn::spanned::Spanned;
use taylor::{
    edges,
    orders::{Orders, orders},
};

/// Returns the implementations of `Hamiltonian` and `System` for the annotated type. If code for devices is requested and
/// cannot be generated, also returns the reason.
pub(crate) fn stepper(input: &Input, model: Model) -> (TokenStream, Option<String>) {
    let (stepper, obstacle) = Stepper::of(input, model);
    (stepper.tokens(), obstacle)
}

/// Returns the code of a system for programs in other languages, or the reason why there is none.
pub(crate) fn exported(input: &Input, mut model: Model) -> Result<Exported, String> {
    let mut energies = [model.kinetic, model.potential];
    let of_parts: Vec<_> = model.parts.iter().map(|part| part.energy).collect();
    model.choose_in_the_middle();
    let mut found = gradients(&mut model);
    let equations = equations(&mut model, &found[0], &found[1]);
    let pattern = recognise(&mut model, [&found[0], &found[1]]);
    if pattern.restate(&mut model, &mut energies[1]) {
        found = gradients(&mut model);
    }
    let names = Names::new(input);
    let graph = &mut model.graph;
    let energy = match of_parts.into_iter().reduce(|sum, part| graph.add(sum, part)) {
        Some(energy) => energy,
        None => graph.add(energies[0], energies[1]),
    };
    let mut emitter = Emitter { model: &mut model, names: &names, fields: Fields::default() };
    let exported = exported::exported(&mut emitter, [&found[0], &found[1]], energy, &pattern)?;
    Ok(Exported { equations, ..exported })
}

/// What is emitted for a Hamiltonian, each part by the module that knows it.
struct Stepper<'i> {
    input: &'i Input,
    names: Names,
    documentation: TokenStream,
    /// The energies and the equations of motion for programs.
    equations: Option<TokenStream>,
    coordinates: TokenStream,
    /// Its type, and its declaration where it was written in place.
    composition: (TokenStream, Option<TokenStream>),
    constants: Constants,
    /// The tables of numbers that constants are prepared from.
    tables: Vec<TokenStream>,
    /// The text of methods that are called as they are.
    called: Option<TokenStream>,
    flows: Flows,
    /// The vector field of H, and whether it is more than the flows of `T` and of `V`.
    field: (Option<TokenStream>, bool),
    /// The functions of energies, and the item for the runtime about their form.
    energies: (TokenStream, Option<TokenStream>),
    /// The user's own energies.
    stated: TokenStream,
    /// What is said to be conserved.
    invariants: Option<TokenStream>,
    /// The derivatives of energies with respect to parameters.
    slopes: Option<TokenStream>,
    /// The items for the runtime about named parts.
    parts: Option<TokenStream>,
    /// The item for the runtime about parts that take inner steps, and the checks of their compositions.
    nested: Option<[TokenStream; 2]>,
    /// The check of the claimed order.
    order: Option<TokenStream>,
    /// Shows the compositions that it admits, where the runtime cannot know which.
    visit: Option<TokenStream>,
    autonomous: bool,
    /// The items of a Hamiltonian with quadratic `T`.
    quadratic: Option<TokenStream>,
    taylor: Option<Orders>,
    /// Flows whose durations are numbers of each lane.
    transformed: Option<TokenStream>,
    /// The trait of the pace that the user gives, and its items.
    rated: Option<(TokenStream, TokenStream)>,
    /// What friction is prepared from, and whether it has a temperature.
    friction: Option<(TokenStream, TokenStream)>,
    /// What Jacobi coordinates require of the prepared constants.
    of_jacobi: Option<TokenStream>,
    /// The flows as text for devices.
    device: Option<DeviceText>,
    /// The check of the length of a start.
    admissible: Option<TokenStream>,
    /// The number of bodies, for expressions of parameters.
    count: Option<TokenStream>,
}

impl<'i> Stepper<'i> {
    fn of(input: &'i Input, mut model: Model) -> (Self, Option<String>) {
        let mut stated_energies = [model.kinetic, model.potential];
        let stated_parts: Vec<_> = model.parts.iter().map(|part| part.energy).collect();
        model.choose_in_the_middle();
        let [mut kinetic, mut potential] = gradients(&mut model);
        let equations = equations(&mut model, &kinetic, &potential);
        let (documentation, equations) = (motion_documentation(&model, &equations), stated(&model, &equations));
        let pattern = recognise(&mut model, [&kinetic, &potential]);
        let is_restated = pattern.restate(&mut model, &mut stated_energies[1]);
        if is_restated {
            [kinetic, potential] = gradients(&mut model);
        }

        let names = Names::new(input);
        let (coordinates, composition) = (coordinates(&model, &names), composition(input, &model, &names));
        let (parts, visit) = (named_parts(&model), visit_compositions(&model, &names));
        let nested = nested::stated(&model, &names);
        let order = order::check(input, &model, &composition.0, &names);
        let (autonomous, is_quadratic) = (model.autonomous, model.quadratic);
        let stated = user_energies::function(input, &model, &names);
        let pairs = pattern.pairs();
        let admissible = match input.coordinates.as_ref().filter(|_| model.jacobi().is_some()) {
            Some(coordinates) => Some(jacobi::admissible(coordinates, &names)),
            None => admissible(&model, pairs, &names),
        };
        let count = pairs.and_then(|pairs| flow::pairs::count(pairs, &model));
        let mut emitter = Emitter { model: &mut model, names: &names, fields: Fields::default() };
        let mut flows = match emitter.model.split {
            Split::Copies(coupling) => Flows::of_copies(&mut emitter, coupling),
            Split::Whole => Flows::none(),
            _ if emitter.model.is_separable() => Flows::of(&mut emitter, &kinetic, &potential, &pattern),
            _ => Flows::of_parts(&mut emitter),
        };
        let quadratic = is_quadratic.then(|| force_gradient::functions(&mut emitter, flows.are_of_bodies()));
        let is_field_of_flows = emitter.model.is_separable() && emitter.model.jacobi().is_none();
        let field = (field::items(&mut emitter, is_restated), !is_field_of_flows);
        let energies = ["kinetic", "potential"].into_iter().zip(stated_energies);
        let energies = energies.map(|(name, energy)| flows.energy(&mut emitter, name, energy, &stated_parts));
        let (energies, in_lanes): (TokenStream, Vec<bool>) = energies.unzip();
        let in_lanes = in_lanes.contains(&true).then(|| {
            quote!(
                const ENERGIES_IN_LANES: bool = true;
            )
        });
        let invariants = invariants::items(&flows, &mut emitter);
        let slopes = parameter_slopes::items(&flows, &mut emitter, stated_energies);
        let taylor = input.taylor.map(|_| series(&mut emitter, stated_energies, [&kinetic, &potential], &pattern));
        let transformed = (autonomous && is_field_of_flows)
            .then(|| transformed::functions(&mut emitter, &kinetic, &potential, flows.are_of_bodies()));
        let rated = emitter.model.rate.take().and_then(|(rate, arguments)| match (autonomous, is_field_of_flows) {
            (false, _) => None,
            (true, false) => Some((quote!(RatedField), rated_field::items(&mut emitter, rate, &arguments))),
            (true, true) => Some((quote!(Rated), transformed::rated(&mut emitter, rate, &arguments, is_quadratic))),
        });
        let friction = emitter.model.friction.take().zip(input.friction.as_ref()).map(|(rates, stated)| {
            let kind = if rates.temperatures.is_some() { quote!(Heat) } else { quote!(Friction) };
            (friction::items(&mut emitter, &rates, stated), kind)
        });
        let of_jacobi = emitter.model.jacobi().map(|jacobi| jacobi::constants(jacobi, &mut emitter));
        let text = |gpu: &Gpu| DeviceText::of(&mut emitter, [&kinetic, &potential], &pattern, gpu.functions);
        let (device, obstacle) = match input.gpu.as_ref().map(text) {
            None => (None, None),
            Some(Ok(text)) => (Some(text), None),
            Some(Err(obstacle)) => (None, Some(obstacle)),
        };
        let read = ReadByMethods::of(input, emitter.model, &names);
        let tables = std::mem::take(&mut emitter.model.tables);
        let constants = Constants::of(emitter).with_read(read.as_ref(), &names);
        let stepper = Self {
            called: read.map(|read| read.text),
            input,
            documentation,
            equations,
            coordinates,
            composition,
            constants,
            tables,
            flows,
            field,
            energies: (energies, in_lanes),
            stated,
            invariants,
            slopes,
            parts,
            nested,
            order,
            visit,
            autonomous,
            quadratic,
            taylor,
            transformed,
            rated,
            friction,
            of_jacobi,
            device,
            admissible,
            count,
            names,
        };
        (stepper, obstacle)
    }

    fn tokens(&self) -> TokenStream {
        let Self { input, names, documentation, composition: (_, composition), constants, tables, flows, .. } = self;
        let (root, Names { runtime, scalar, .. }) = (&input.root, names);
        let declaration = constants.declaration(names);
        let is_generic = !input.item.generics.params.is_empty();
        let order = &self.order;
        let checks = self.nested.as_ref().map(|[_, checks]| checks).filter(|_| !is_generic);
        let implementation = |of, items: &TokenStream| self.implementation(of, items);
        let of_bodies = flows.of_bodies(implementation, &constants.kind(&quote!(f64), names), names);
        let quadratic = self.quadratic.as_ref().map(|items| implementation(quote!(#runtime::QuadraticKinetic), items));
        let taylor = self.taylor.as_ref().map(|Orders { tape, items }| {
            let recurrences = implementation(quote!(#runtime::Recurrences), items);
            quote!(#tape #recurrences)
        });
        let of_lattice = flows.of_lattice(implementation, names);
        let of_nests = flows.of_nests(implementation, names);
        let of_parts = flows.of_parts_of_pairs(&constants.kind(&quote!(#scalar), names), &self.coordinates, names);
        let of_forms = flows.of_quadratic_forms(&constants.kind(&quote!(f64), names), names);
        let of_jacobi = self.of_jacobi.as_ref().map(|items| {
            let constants = constants.kind(&quote!(f64), names);
            quote!(impl #runtime::JacobiConstants for #constants { #items })
        });
        let transformed =
            self.transformed.as_ref().map(|items| implementation(quote!(#runtime::TimeTransformed), items));
        let rated = self.rated.as_ref().map(|(of, items)| implementation(quote!(#runtime::#of), items));
        let friction = self.friction.as_ref().map(|(items, _)| implementation(quote!(#runtime::WithFriction), items));
        let sensitive = constants.sensitive(&input.sensitive, self.count.as_ref(), names);
        let has_slopes = sensitive.is_some().then(|| implementation(quote!(#runtime::Sensitive), &TokenStream::new()));
        let others = quote!(#of_bodies #of_jacobi #quadratic #transformed #rated #friction #taylor #of_lattice #of_nests #of_parts #of_forms);
        let system = implementation(quote!(#runtime::System), &self.system(&others));
        let hamiltonian = implementation(quote!(#runtime::Hamiltonian), &self.hamiltonian());
        let slopes = &self.slopes;
        let by_parameters = implementation(quote!(#runtime::ParameterDerivatives), &quote!(#sensitive #slopes));
        // No part of the fingerprint: with text for devices or without, a checkpoint belongs to the same motion.
        let device =
            self.device.as_ref().map(|device| implementation(quote!(#runtime::DeviceText), &device.items(names)));
        quote! {
            #[allow(warnings, clippy::all, clippy::pedantic, reason = "generated")]
            const _: () = {
                use #root::__private::{self as #runtime, Mask as _, Slot as _};

                #composition
                #checks
                #order
                #(#tables)*
                #declaration
                #documentation
                #hamiltonian
                #system
                #others
                #by_parameters
                #has_slopes
                #device
            };
        }
    }

    /// The implementation of a trait for the annotated type.
    fn implementation(&self, of: TokenStream, items: &TokenStream) -> TokenStream {
        let (generics, _, bounds) = self.input.item.generics.split_for_impl();
        let system = &self.input.item.self_ty;
        quote! {
            #[automatically_derived]
            impl #generics #of for #system #bounds { #items }
        }
    }

    /// The items of `Hamiltonian`: the annotated composition, and the methods that can replace it.
    fn hamiltonian(&self) -> TokenStream {
        let Self { names: Names { runtime, .. }, composition: (composition, _), visit, equations, .. } = self;
        let visit_recurrences = self.taylor.as_ref().map(|_| {
            quote! {
                fn visit_recurrences(visitor: &mut impl #runtime::RecurrencesVisitor<Self>) {
                    #runtime::RecurrencesVisitor::visit(visitor);
                }
            }
        });
        quote! {
            type Compose = #composition;

            #equations
            #visit
            #visit_recurrences
        }
    }

    /// The items of `System`. What else is implemented, `others`, is known by the fingerprint alone.
    fn system(&self, others: &TokenStream) -> TokenStream {
        let Self {
            names,
            coordinates,
            constants,
            called,
            flows,
            field,
            stated,
            invariants,
            parts,
            nested,
            autonomous,
            admissible,
            friction,
            ..
        } = self;
        let nested = nested.as_ref().map(|[stated, _]| stated);
        let Names { runtime, scalar, leaf, .. } = names;
        let [parameters, single] = [quote!(#scalar), quote!(f64)].map(|scalar| constants.kind(&scalar, names));
        let (motion, (layout, sites), moves) =
            (flows.motion(&parameters, names), flows.layout(names), flows.functions(names));
        let dissipation = friction.as_ref().map(|(_, kind)| {
            quote!(
                const DISSIPATION: #runtime::Dissipation = #runtime::Dissipation::#kind;
            )
        });
        let ((energies, in_lanes), Pieces { piecewise, begin, .. }) = (&self.energies, &constants.pieces);
        let prepare = with_count(constants.prepare(names), self.count.as_ref());
        let (length, prepare) = (prepare.argument("length"), &prepare.0);
        let is_listed = flows.is_listed(self.count.as_ref());
        // What only implicit methods use says nothing about the flows.
        let (field, is_own) = field;
        let own_field = field.as_ref().filter(|_| *is_own);
        let fingerprint = fingerprint(quote!(#prepare #moves #own_field #energies #others #called));
        quote! {
            type Coords = #coordinates;
            type Parameters<#scalar: #runtime::Real> = #parameters;
            type Motion<#scalar: #runtime::Real, #leaf: #runtime::Precision> = #motion;

            #parts
            #nested
            const AUTONOMOUS: bool = #autonomous;
            #dissipation
            const FINGERPRINT: u64 = #fingerprint;
            #layout
            #in_lanes
            #piecewise

            #admissible
            #is_listed
            fn parameters(&self, #length: usize) -> #single { #prepare }

            #begin
            #moves
            #field
            #energies
            #stated
            #invariants
            #sites
        }
    }
}

/// The function that checks whether a start has the coordinates that are read by number, and those of all bodies that act.
fn admissible(model: &Model, pairs: Option<&AllPairs>, names: &Names) -> Option<TokenStream> {
    let runtime = &names.runtime;
    let check = length_check(model, pairs, names);
    let rates = model.friction.as_ref().map(|_| quote!(#runtime::are_rates(self, length)));
    let check = match (check, rates) {
        (None, None) => return None,
        (Some(check), Some(rates)) => quote!(#check.and_then(|()| #rates)),
        (check, rates) => quote!(#check #rates),
    };
    Some(quote! {
        fn admissible(&self, length: usize) -> ::core::result::Result<(), #runtime::Error> { #check }
    })
}

/// The check of the length of a start.
fn length_check(model: &Model, pairs: Option<&AllPairs>, names: &Names) -> Option<TokenStream> {
    if model.shape.length.literal().is_some() {
        return None;
    }
    let runtime = &names.runtime;
    let rate = model.rate.iter().map(|(rate, _)| *rate);
    let invariants = model.invariants.iter().map(|invariant| invariant.value);
    let least = model.graph.least_length([model.kinetic, model.potential].into_iter().chain(rate).chain(invariants));
    let flat = pairs.and_then(|pairs| pairs.of.flat);
    let components = flat.map(Literal::u64_unsuffixed);
    let counts = pairs.into_iter().flat_map(|pairs| [pairs.of.acting, pairs.of.moving]).flatten();
    let mut counts: Vec<_> = counts.filter(|first| !first.or_all).map(|first| first.number).collect();
    counts.dedup();
    let counts = counts.into_iter().map(|number| {
        let (number, factor) = (operand(model.text(number)), components.iter());
        quote!(#number #(* #factor)*)
    });
    let literal = Literal::u64_unsuffixed(least).to_token_stream();
    let mut counts: Vec<_> = (least > 0).then_some(literal).into_iter().chain(counts).collect();
    let first = counts.pop();
    let least =
        first.map(|first| counts.into_iter().fold(first, |most, next| quote!(::core::cmp::Ord::max(#next, #most))));
    let check = match components {
        Some(components) => {
            let least = least.unwrap_or_else(|| quote!(0));
            quote!(are_points(#components, #least, length))
        }
        None => {
            let least = least?;
            quote!(are_at_least(#least, length))
        }
    };
    Some(quote!(#runtime::#check))
}

/// The recurrences of the motion, whose flows follow from these gradients. Steps of the Taylor method end where a condition
/// on the time changes, so that recurrences read the time there and not the middle of a step.
fn series(
    emitter: &mut Emitter<'_>,
    energies: [NodeId; 2],
    [kinetic, potential]: [&Vec<Contribution>; 2],
    pattern: &Pattern,
) -> Orders {
    let is_piecewise = energies != [emitter.model.kinetic, emitter.model.potential];
    let [kinetic, potential] = match is_piecewise {
        true => gradients_of(emitter.model, energies),
        false => [kinetic, potential].map(Clone::clone),
    };
    let edges = edges::items(emitter, [&kinetic, &potential]);
    let stencil = pattern.stencil_of_potential().filter(|_| !is_piecewise);
    let Emitter { model, names, fields } = emitter;
    let mut orders = orders(model, fields, names, kinetic, potential, stencil);
    orders.items.extend(edges);
    orders
}

/// The names of parts, and that these are no `T` and `V`.
fn named_parts(model: &Model) -> Option<TokenStream> {
    let names: Vec<_> = match model.split {
        Split::Copies(_) => {
            return Some(quote! {
                const PARTS: &'static [&'static str] = &["hamiltonian", "hamiltonian of the copy", "coupling"];
                const SEPARABLE: bool = false;
                const COPIES: bool = true;
            });
        }
        Split::Whole => {
            return Some(quote! {
                const PARTS: &'static [&'static str] = &[];
                const SEPARABLE: bool = false;
            });
        }
        Split::Jacobi(_) => KEPLER_PARTS.map(str::to_owned).into(),
        _ => model.parts.iter().map(ExactPart::name).collect(),
    };
    let separable = (!model.is_separable() || model.jacobi().is_some()).then(|| {
        quote!(
            const SEPARABLE: bool = false;
        )
    });
    let own = model.parts.iter().any(|part| part.own.is_some());
    let differences = own.then(|| {
        quote!(
            const TANGENT_ERROR: f64 = 128.0;
        )
    });
    let paired = matches!(model.split, Split::Pair).then(|| {
        quote!(
            const PAIRED: bool = true;
        )
    });
    (!names.is_empty())
        .then(|| quote!(const PARTS: &'static [&'static str] = &[#(#names),*]; #separable #paired #differences))
}

/// The loop over the compositions. The runtime shows every Hamiltonian those for general `T`; only here is it known that
/// there are more, or fewer.
fn visit_compositions(model: &Model, names: &Names) -> Option<TokenStream> {
    if matches!(model.split, Split::Whole) || model.friction.is_some() {
        let runtime = &names.runtime;
        return Some(quote!(
            fn visit_compositions(_visitor: &mut impl #runtime::Visitor<Self>) {}
        ));
    }
    // Who names two parts may well have made the second one small.
    let are_two = model.jacobi().is_some() || model.parts.len() == 2;
    let visit = match model {
        Model { quadratic: true, .. } if are_two => quote!(visit_two_parts_quadratic),
        Model { quadratic: true, .. } => quote!(visit_quadratic),
        _ if are_two => quote!(visit_two_parts),
        Model { split: Split::Pair, .. } => quote!(visit_pairs),
        Model { split: Split::Nested, .. } => quote!(visit_nested),
        model if model.flows() > 2 => quote!(visit_many_parts),
        _ => return None,
    };
    let runtime = &names.runtime;
    Some(quote! {
        fn visit_compositions(visitor: &mut impl #runtime::Visitor<Self>) {
            #runtime::#visit(visitor);
        }
    })
}

/// The type of the coordinates.
fn coordinates(model: &Model, names: &Names) -> TokenStream {
    let runtime = &names.runtime;
    let element = model.shape.element(quote!(f64));
    match &model.shape.length {
        Length::OfStart => quote!(#runtime::Vec<#element>),
        length => {
            let length = match length {
                Length::Constant(_) => {
                    let length = length.tokens();
                    quote!({ #length })
                }
                _ => length.tokens(),
            };
            quote!([#element; #length])
        }
    }
}

/// The composition's type, and its declaration where it was written in place.
fn composition(input: &Input, model: &Model, names: &Names) -> (TokenStream, Option<TokenStream>) {
    let (root, runtime) = (&input.root, &names.runtime);
    let is_whole = matches!(model.split, Split::Whole);
    let named_otherwise = other_name::check(input, names);
    match &input.compose {
        // A stub has no friction.
        _ if input.friction.is_some() && model.friction.is_none() => (quote!(#runtime::Verlet), None),
        None if is_whole => (quote!(#runtime::ImplicitMidpoint), None),
        None if model.friction.is_some() => (quote!(#runtime::Baoab), None),
        None => (quote!(#runtime::Verlet), None),
        Some(Compose::Named(path)) if is_whole => {
            let held = quote_spanned! {path.span()=>
                const _: fn() = || {
                    fn takes_whole<Method: #runtime::TakesWhole>() {}
                    takes_whole::<#path>();
                };
            };
            // A type parameter is not known out here.
            let held = input.item.generics.params.is_empty().then_some(held);
            (quote!(#path), Some(quote!(#held #named_otherwise)))
        }
        Some(Compose::Named(path)) => {
            let parts = model.flows();
            // The compiler knows what the path names.
            let held = parts > 2 && input.item.generics.params.is_empty();
            let (span, runtime) = (path.span(), names.runtime_at(path.span()));
            let admits = match model.split {
                Split::Pair => quote_spanned!(span=> #runtime::admits_pairs::<#path>()),
                Split::Nested => quote_spanned!(span=> #runtime::admits_nested::<#path>()),
                _ => quote_spanned!(span=> #runtime::admits::<#path>(#parts)),
            };
            let check = quote_spanned!(span=> const _: () = #admits;);
            let check = held.then_some(check);
            (quote!(#path), Some(quote!(#check #named_otherwise)))
        }
        Some(Compose::InPlace(sequence, _)) => {
            let name = &names.composition;
            let class = if model.quadratic { Class::QuadraticKinetic } else { Class::General };
            (quote!(#name), Some(sequence.emit(name, class, root)))
        }
    }
}
