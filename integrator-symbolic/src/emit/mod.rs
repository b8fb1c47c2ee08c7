//! The stepper as Rust.
//!
//! Comes in: a model that is known to make sense. Goes out: the implementation of the runtime's `Hamiltonian`, in a
//! scope of its own. Always true: nothing here fails; the same model gives the same tokens; the text names only paths
//! of the user, of `::core`, and of the runtime's private door.

mod fingerprint;
mod flow;
mod printer;
mod prose;
mod taylor;

use crate::{
    differentiate::{Contribution, gradient},
    graph::Part,
    model::{Length, Model},
    scheme::{Class, InPlace},
    syntax::{Compose, Input},
};
use fingerprint::fingerprint;
pub use flow::form::Form;
pub(crate) use flow::form::forms;
use flow::{
    constants::{Prepared, constants},
    flow, force_gradient, lattice,
    pairs::ManyBody,
    pieces::Pieces,
    stated, value,
};
use printer::{
    expression::Dialect,
    fields::{Fields, lowered},
    function::Body,
    names::Names,
};
use proc_macro2::TokenStream;
use prose::{Formulas, documented_motion};
pub(crate) use prose::{equations, ranges};
use quote::quote;
use taylor::orders;

/// What in a sequence asks for a quadratic `T` that this Hamiltonian does not have: the message for it.
pub(crate) fn refusal(sequence: &InPlace, model: &Model) -> Option<String> {
    if model.quadratic {
        return None;
    }
    let term = Formulas::of(model).not_quadratic(model.kinetic);
    let proof = sequence.proof();
    match proof.general {
        None => Some(format!(
            "a force-gradient kick needs T = ½ pᵀ M⁻¹ p, but T has the term `{term}`: use kicks `V(b)` alone"
        )),
        Some(general) if general.order < proof.quadratic.order => Some(format!(
            "this sequence is of order {} only where T is quadratic in p with constant masses; T has the term `{term}`, \
             for which the order is {}: use a sequence for general T, such as `Yoshida4`",
            proof.quadratic.order, general.order
        )),
        Some(_) => None,
    }
}

/// The implementation of `Hamiltonian` for the annotated type.
pub(crate) fn stepper(input: &Input, mut model: Model) -> TokenStream {
    let energies = [model.kinetic, model.potential];
    [model.kinetic, model.potential] = model.graph.by_pieces(energies);
    let kinetic = gradient(&mut model.graph, model.kinetic, Part::Momentum);
    let potential = gradient(&mut model.graph, model.potential, Part::Position);
    let (kinetic_gradient, potential_gradient) = (kinetic.clone(), potential.clone());
    let documentation = documented_motion(&mut model, &kinetic, &potential);

    let names = Names::new(input);
    let mut fields = Fields::default();
    let many_body = ManyBody::of(&mut model, &mut fields, &names);
    let mut flow = |gradient: &[Contribution], part| match many_body {
        Some(_) => (ManyBody::flow(part), None),
        None => flow(&mut model, &mut fields, &names, gradient, part),
    };
    let (drift, drift_along) = flow(&kinetic, Part::Momentum);
    let (kick, kick_along) = flow(&potential, Part::Position);
    let force_gradient = model
        .quadratic
        .then(|| force_gradient::functions(&mut model, &mut fields, &names, &potential, many_body.is_some()));
    // Bodies side by side are taken apart for what is seldom asked.
    let plain = many_body.as_ref().map(|_| quote!(let motion = &motion.plain::<Self::Coords>();));
    let [kinetic, potential] = energies.map(|energy| {
        let lowered = lowered(&mut model, &[energy])[0];
        let energy = value(&model, &mut fields, &names, lowered, Dialect::Generic);
        quote!(#plain #energy)
    });
    let [drift, kick, kinetic, potential] = [drift, kick, kinetic, potential].map(Body::new);

    let orders =
        input.taylor.map(|_| orders::orders(&mut model, &mut fields, &names, kinetic_gradient, potential_gradient));

    let pieces = Pieces::of(&fields, &names);
    let root = &input.root;
    let Pieces { piecewise, begin, set } = pieces;
    let Names { runtime, parameters, scalar, leaf, .. } = &names;
    let Prepared { fields, gathered, values, common, searched, digested } = constants(fields, &mut model, &names);
    let alike = (!common.is_empty()).then(|| {
        quote! {
            #[inline]
            fn alike(a: &Self::Single, b: &Self::Single) -> bool { #(#common)&&* }
        }
    });
    let not_finite = (!searched.is_empty()).then(|| {
        quote! {
            fn not_finite(single: &Self::Single) -> #runtime::Vec<#runtime::NotFinite> {
                #runtime::all_found([#(#searched),*])
            }
        }
    });
    let digest = (!digested.is_empty()).then(|| {
        quote! {
            fn digest(single: &Self::Single, digest: &mut #runtime::Digest) {
                #(digest.add(&single.#digested);)*
            }
        }
    });
    // Integers and methods are the same whatever a flow computes in; so may be all that is prepared.
    let generic = Body::new(fields.clone()).mentions(&scalar.to_string());
    let of = |scalar: TokenStream| if generic { quote!(#parameters<#scalar>) } else { quote!(#parameters) };
    let (structure, gather, prepare) = if fields.is_empty() {
        (
            quote!(
                pub struct #parameters;
            ),
            quote!(
                fn gather(_members: &[&Self::Single]) -> Self {
                    #parameters
                }
            ),
            quote!(#parameters),
        )
    } else {
        let declared = of(quote!(#scalar));
        (
            quote!(pub struct #declared { #fields }),
            quote!(fn gather(members: &[&Self::Single]) -> Self {
                #parameters { #gathered }
            }),
            quote!(#parameters { #values }),
        )
    };
    let stated = stated::functions(input, &model);
    let length = Body::new(prepare.clone()).argument("length");
    let (of_r, of_f64) = (of(quote!(#scalar)), of(quote!(f64)));

    let (generics, _, bounds) = input.item.generics.split_for_impl();
    let system = &input.item.self_ty;
    let coordinates = coordinates(&model, &names);
    let (composition, declared) = composition(input, &model, &names);
    let autonomous = model.autonomous;
    // The runtime shows every Hamiltonian the compositions for general `T`; only here is it known that there are more.
    let visit = model.quadratic.then(|| {
        quote! {
            fn visit_compositions(visitor: &mut impl #runtime::Visitor<Self>) {
                #runtime::visit_quadratic(visitor);
            }
        }
    });
    let visit_recurrences = input.taylor.map(|_| {
        quote! {
            fn visit_recurrences(visitor: &mut impl #runtime::RecurrencesVisitor<Self>) {
                #runtime::RecurrencesVisitor::visit(visitor);
            }
        }
    });
    let implementation = |of: TokenStream, functions: TokenStream| {
        quote! {
            #[automatically_derived]
            impl #generics #of for #system #bounds { #functions }
        }
    };
    let quadratic = force_gradient.map(|functions| implementation(quote!(#runtime::QuadraticKinetic), functions));
    let taylor = orders.map(|orders::Orders { tape, items }| {
        let recurrences = implementation(quote!(#runtime::Recurrences), items);
        quote!(#tape #recurrences)
    });
    let motion = match &many_body {
        Some(many_body) => many_body.motion(&of_r, &names),
        None => quote!(#runtime::Plain<#scalar, #runtime::Shaped<Self, #leaf>, #of_r>),
    };
    let along = [&drift_along, &kick_along].into_iter().flatten().map(|sweep| {
        let (flow, items) = (sweep.name(), sweep.items(&names));
        let along = implementation(quote!(#runtime::Stencil<#runtime::#flow>), items);
        quote! {
            /// What every site computes from its neighbourhood, for itself and for the sites further on.
            #along
        }
    });
    let roots = [&drift, &kick].into_iter().any(|flow| flow.mentions("div_pow_3_2"));
    let wide = (kick_along.is_some() || many_body.is_some() || roots).then(|| {
        quote!(
            const WIDE: bool = true;
        )
    });
    let sweeps = drift_along.as_ref().zip(kick_along.as_ref());
    let line = sweeps.filter(|(drift, kick)| !drift.is_plane() && !kick.is_plane());
    let (radii, lattice) = line.map(|_| lattice::parts(&names)).unzip();
    let (drift, kick) = (drift.flow("drift", &names), kick.flow("kick", &names));
    let many_body = many_body.map(|many_body| many_body.implementations(implementation, &of_f64, &names));
    let (kinetic, potential) = (kinetic.energy("kinetic", &names), potential.energy("potential", &names));
    let along: TokenStream = along.collect();
    let fingerprint =
        fingerprint(quote!(#prepare #drift #kick #kinetic #potential #many_body #quadratic #taylor #along));
    quote! {
        #[allow(warnings, clippy::all, clippy::pedantic, reason = "generated")]
        const _: () = {
            use #root::__private::{self as #runtime, Mask as _, Slot as _};

            #declared

            /// What depends on parameters alone, evaluated once per run.
            #[derive(::core::clone::Clone)]
            #structure

            impl<#scalar: #runtime::Real> #runtime::Prepared<#scalar> for #of_r {
                type Single = #of_f64;

                #[inline(always)]
                #gather

                #alike
                #not_finite
                #digest
                #set
            }

            #documentation
            #[automatically_derived]
            impl #generics #runtime::Hamiltonian for #system #bounds {
                type Coords = #coordinates;
                type Compose = #composition;
                type Parameters<#scalar: #runtime::Real> = #of_r;
                type Motion<#scalar: #runtime::Real, #leaf: #runtime::Precision> = #motion;

                const AUTONOMOUS: bool = #autonomous;
                const FINGERPRINT: u64 = #fingerprint;
                #wide
                #radii
                #piecewise

                fn parameters(&self, #length: usize) -> #of_f64 {
                    #prepare
                }

                #begin
                #drift
                #kick
                #kinetic
                #potential
                #stated
                #lattice
                #visit
                #visit_recurrences
            }

            #many_body
            #quadratic
            #taylor
            #along
        };
    }
}

/// The type of the coordinates.
fn coordinates(model: &Model, names: &Names) -> TokenStream {
    let runtime = &names.runtime;
    let element = match &model.shape.dimension {
        None => quote!(f64),
        Some(dimension) => {
            let dimension = dimension.tokens();
            quote!([f64; #dimension])
        }
    };
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
    match &input.compose {
        None => (quote!(#runtime::Verlet), None),
        Some(Compose::Named(path)) => (quote!(#path), None),
        Some(Compose::InPlace(sequence, _)) => {
            let name = &names.composition;
            let class = if model.quadratic { Class::QuadraticKinetic } else { Class::General };
            (quote!(#name), Some(sequence.emit(name, class, root)))
        }
    }
}
