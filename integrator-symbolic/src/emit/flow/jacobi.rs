//! Bodies in Jacobi coordinates: the validity check, and the code of the map and of the Kepler parts.

use crate::{
    emit::printer::{block::Emitter, function::Body, names::Names},
    graph::{
        Graph, NodeId, ParameterId, Part,
        index::{Index, Loop, LoopId},
        rename::{Parameters, Renaming, rename},
    },
    model::{Jacobi, Model, Shape, Texts, with_own_self},
    pairs::{Pairs, attraction, canonical, inverse_mass, pairs, per_body, softening},
    pattern::all_pairs::AllPairs,
    syntax::Coordinates,
};
use proc_macro2::{Literal, TokenStream};
use quote::{ToTokens, quote};

/// The names of the parts of a motion in Jacobi coordinates.
pub(crate) const KEPLER_PARTS: [&str; 2] = ["kepler", "interaction"];

/// What keeps a Hamiltonian from Jacobi coordinates.
pub(crate) enum Obstacle {
    /// The shape of the coordinates.
    Shape(String),
    /// `T`.
    Kinetic(String),
    /// `V`.
    Potential(String),
    /// What `V` adds to the square of a distance.
    Softening(NodeId),
}

/// What Jacobi coordinates are made with, or what stands in their way. Energies that are not recognised as written are
/// tried in their one form.
pub(crate) fn judged(coordinates: &Coordinates, model: &mut Model, names: &Names) -> Result<Jacobi, Obstacle> {
    let obstacle = match read(coordinates, model, names) {
        Err(obstacle @ (Obstacle::Kinetic(_) | Obstacle::Potential(_))) => obstacle,
        other => return other,
    };
    let energies = [model.kinetic, model.potential];
    let Model { graph, parameters, running, lengths, .. } = &mut *model;
    let mut texts = Texts::new(parameters, running);
    let canonical = energies.map(|energy| canonical(graph, energy, lengths[0], &mut texts).unwrap_or(energy));
    if canonical == energies {
        return Err(obstacle);
    }
    model.set_energies(canonical);
    let read = read(coordinates, model, names);
    if read.is_err() {
        model.set_energies(energies);
    }
    read
}

/// The same of energies as they stand.
fn read(coordinates: &Coordinates, model: &mut Model, names: &Names) -> Result<Jacobi, Obstacle> {
    let dimension = dimension(&model.shape)?;
    let Model { graph, parameters, running, kinetic, potential, lengths, .. } = &mut *model;
    let length = lengths[0];
    let mut texts = Texts::new(parameters, running);
    let found = pairs(graph, *potential, length, &mut texts);
    let Pairs { bodies, pair, energy, .. } = found.ok_or_else(|| {
        Obstacle::Potential(
            "Jacobi coordinates require V as a sum over all pairs of bodies\nhelp: write a loop over `i` and one over \
             `j` in `0..i`, with the term `-G m[i] m[j] / |q[i] - q[j]|` of each pair\nnote: further terms may belong \
             to each pair, to each body, or to the first body and each other one"
                .to_owned(),
        )
    })?;
    let velocity = per_body(graph, *kinetic, length, Part::Momentum, &mut texts);
    let inverse = velocity.and_then(|velocity| inverse_mass(graph, &velocity, dimension));
    let inverse = inverse.ok_or_else(|| {
        Obstacle::Kinetic(
            "Jacobi coordinates require T = Σ |p[i]|² / 2m[i]\nhelp: write a loop over all bodies `i` that sums all \
             components of `p[i]`"
                .to_owned(),
        )
    })?;
    let strength = attraction(graph, energy, pair, dimension).ok_or_else(|| {
        softening(graph, energy, pair, dimension).map(Obstacle::Softening).unwrap_or_else(|| {
            Obstacle::Potential(
                "Jacobi coordinates require the term `-G m[i] m[j] / |q[i] - q[j]|` of each pair in V\nhelp: write it \
                 as a separate term, with the distance as the root of a sum of squares or by `hypot`\nnote: the \
                 Kepler part consists of these terms"
                    .to_owned(),
            )
        })
    })?;
    let partners = Loop {
        parent: Some(bodies),
        from: graph.loops.get(bodies).from,
        to: graph.loops.intern(Index::Running(bodies)),
    };
    let partners = graph.loops.range(partners);
    texts.name_in_place(bodies, pair[0], &pair);
    texts.name_in_place(partners, pair[1], &pair.map(|by| if by == bodies { partners } else { by }));
    let masses = masses(coordinates);
    let mass = texts.item(graph, &masses, bodies);
    let (leading, leader) = leader(&masses, bodies, graph, &mut texts, names);
    texts.name(leader, partners);
    let mut strengths = [partners, leader].into_iter().map(|other| {
        let strength = rename(graph, strength, Renaming::both(pair, [bodies, other]), &mut texts)?;
        Some(graph.sum(other, strength))
    });
    let strengths = strengths.next().flatten().zip(strengths.next().flatten());
    let jacobi = strengths.map(|(before, leading_after)| Jacobi {
        bodies,
        leading,
        mass: graph.parameter(mass),
        inverse_mass: inverse,
        attraction: graph.add(before, leading_after),
    });
    let in_rows = AllPairs::of(model).is_some();
    jacobi.filter(|_| in_rows).ok_or_else(|| {
        Obstacle::Potential(
            "the terms of V do not have the same form for every pair of bodies\nhelp: use parameters of one body at a \
             time, such as `self.mass[i]`, and call no methods in their index"
                .to_owned(),
        )
    })
}

/// The list of masses, whose `self` may be that of a macro of the user.
fn masses(coordinates: &Coordinates) -> TokenStream {
    with_own_self(coordinates.masses.to_token_stream())
}

/// The number of the body that leads, as a parameter, and the loop over it for those bodies that come before it in the
/// user's order and are attracted by it all the same.
fn leader(
    masses: &TokenStream,
    bodies: LoopId,
    graph: &mut Graph,
    texts: &mut Texts<'_>,
    names: &Names,
) -> (ParameterId, LoopId) {
    let runtime = &names.runtime;
    let leading = texts.fixed(graph, quote!(#runtime::leading_body(&(#masses)[..], length)));
    let end = texts.of_index(graph, bodies, |index| quote!(#runtime::end_of_leader(&(#masses)[..], length, #index)));
    texts.call(leading, "leading_body");
    texts.call(end, "end_of_leader");
    let [from, to] = [leading, end].map(|bound| graph.loops.intern(Index::Parameter(bound)));
    (leading, graph.loops.range(Loop { parent: Some(bodies), from, to }))
}

/// The number of components of the points that coordinates are.
fn dimension(shape: &Shape) -> Result<u64, Obstacle> {
    let dimension = shape.dimension().and_then(|dimension| dimension.literal());
    let many = shape.length.literal().is_none_or(|length| length > 1);
    dimension.filter(|_| many).ok_or_else(|| {
        let text = shape.text();
        Obstacle::Shape(format!(
            "Jacobi coordinates require the positions of at least two bodies, and these are `{text}`\nhelp: write \
             `[[f64; 3]; N]`, with a literal in place of 3"
        ))
    })
}

/// The layout of the motion, around that of bodies in inertial coordinates.
pub(crate) fn motion(bodies: &TokenStream, dimension: &Literal, names: &Names) -> TokenStream {
    let runtime = &names.runtime;
    quote!(#runtime::Jacobi<#bodies, #dimension>)
}

/// The flow of the Kepler parts.
pub(crate) fn drift() -> Body {
    Body::new(quote!(motion.drift(duration);))
}

/// The flow of the interaction by that of `V`.
pub(crate) fn kick(kick: &TokenStream) -> Body {
    Body::new(quote! {
        let jacobi = motion;
        jacobi.open_kick();
        let motion = &mut jacobi.inertial;
        #kick
        jacobi.close_kick(duration);
    })
}

/// The velocities where the momenta are a force.
pub(crate) fn velocity() -> TokenStream {
    quote! {
        bent = force;
        bent.divide_by_masses();
    }
}

/// The product with the interaction's Hessian by that with the Hessian of `V`.
pub(crate) fn hessian(product: &TokenStream) -> TokenStream {
    quote! {
        let jacobi = motion;
        jacobi.open_hessian();
        let motion = &mut jacobi.inertial;
        #product
        jacobi.close_hessian();
    }
}

/// The energy of a part by that of `T` or of `V`, whose name this is.
pub(crate) fn energy(name: &str, energy: &TokenStream) -> TokenStream {
    let sign = if name == "kinetic" { quote!(-) } else { quote!(+) };
    quote! {
        let jacobi = motion;
        let motion = &jacobi.to_inertial().plain::<Self::Coords>();
        let energy = { #energy };
        energy #sign jacobi.attraction()
    }
}

/// A function of positions and momenta, which are those of the user there.
pub(crate) fn in_own_coordinates(value: &TokenStream) -> TokenStream {
    quote! {
        let motion = &motion.to_inertial().plain::<Self::Coords>();
        #value
    }
}

/// What the runtime requires of the prepared constants.
pub(crate) fn constants(jacobi: Jacobi, emitter: &mut Emitter<'_>) -> TokenStream {
    let Emitter { model, fields, .. } = emitter;
    let index = model.running.get(&jacobi.bodies);
    let [mass, inverse_mass, attraction] = [jacobi.mass, jacobi.inverse_mass, jacobi.attraction].map(|id| {
        let field = fields.number(&model.graph, &model.parameters, id);
        // What is the same for all bodies is no table.
        if model.graph.loops_of(id).is_empty() { quote!(self.#field) } else { quote!(self.#field[#index]) }
    });
    let leading = fields.integer(&model.parameters, jacobi.leading);
    quote! {
        #[inline]
        fn leading_body(&self) -> usize { self.#leading }
        #[inline]
        fn mass_and_attraction(&self, #index: usize) -> [f64; 2] { [#mass, #attraction] }
        #[inline]
        fn inverse_mass(&self, #index: usize) -> f64 { #inverse_mass }
    }
}

/// The function that checks whether a run may begin.
pub(crate) fn admissible(coordinates: &Coordinates, names: &Names) -> TokenStream {
    let (Names { runtime, .. }, masses) = (names, masses(coordinates));
    quote! {
        fn admissible(&self, length: usize) -> ::core::result::Result<(), #runtime::Error> {
            #runtime::are_masses(&(#masses)[..], length)?;
            #runtime::are_masses_of_kinetic(&self.parameters(length), length)
        }
    }
}

#[cfg(test)]
mod tests;
