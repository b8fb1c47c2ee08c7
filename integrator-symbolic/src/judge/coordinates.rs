//! Jacobi coordinates: the numbers of each body that they are made with, or the reason why there are none.

use crate::{
    errors::Errors,
    graph::{
        Graph, NodeId, ParameterId, Part,
        index::{Index, Loop, LoopId},
        rename::{Parameters, Renaming, rename},
    },
    model::{Jacobi, Model, Shape, Split, Texts, with_own_self},
    pairs::{Pairs, attraction, canonical, inverse_mass, pairs, per_body, softening},
    pattern::all_pairs::AllPairs,
    reason::Reason,
    syntax::{Coordinates, Input, names::Names},
};
use proc_macro2::TokenStream;
use quote::{ToTokens, quote};

/// The names of the parts of a motion in Jacobi coordinates.
pub(crate) const KEPLER_PARTS: [&str; 2] = ["kepler", "interaction"];

/// The coordinates of the motion have to fit the Hamiltonian.
pub(super) fn check_coordinates(input: &Input, model: &mut Model, errors: &mut Errors) {
    let Some(coordinates) = &input.coordinates else { return };
    let named = input.split.iter().zip(KEPLER_PARTS).find(|(name, part)| name != part).map(|(name, _)| name);
    if named.is_some() || input.split.len() != KEPLER_PARTS.len() {
        let wrong = named.or(input.split.get(2)).unwrap_or(&coordinates.name);
        let message = "Jacobi coordinates require the parts `kepler` and `interaction`\nhelp: write `split = kepler + \
                       interaction`\nnote: these are the Kepler motion of each body and the rest of V";
        errors.at(wrong, message);
        return;
    }
    let function = |name: &str| input.function(name).or_else(|| input.function("hamiltonian"));
    match jacobi(coordinates, model, &Names::new(input)) {
        Ok(jacobi) => model.split = Split::Jacobi(jacobi),
        Err(Obstacle::Shape(message)) => {
            if let Some(function) = function("potential") {
                errors.at(&function.sig.inputs, message);
            }
        }
        Err(Obstacle::Kinetic(message)) => {
            if let Some(function) = function("kinetic") {
                errors.at(&function.sig.ident, message);
            }
        }
        Err(Obstacle::Potential(message)) => {
            if let Some(function) = function("potential") {
                errors.at(&function.sig.ident, message);
            }
        }
        Err(Obstacle::Softening(softening)) => {
            let message = "Jacobi coordinates do not support a softened distance of two bodies\nhelp: leave out the \
                           softening, or `coordinates` and `split`\nnote: Kepler's equation solves the potential `-G \
                           m[i] m[j] / r`";
            match (model.place_of(softening), function("potential")) {
                (Some(place), _) => errors.at(place, message),
                (None, Some(function)) => errors.at(&function.sig.ident, message),
                (None, None) => {}
            }
        }
    }
}

/// What keeps a Hamiltonian from Jacobi coordinates.
enum Obstacle {
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
fn jacobi(coordinates: &Coordinates, model: &mut Model, names: &Names) -> Result<Jacobi, Obstacle> {
    let obstacle = match read(coordinates, model, names) {
        Err(obstacle @ (Obstacle::Kinetic(_) | Obstacle::Potential(_))) => obstacle,
        other => return other,
    };
    let energies = [model.kinetic, model.potential];
    let Model { graph, parameters, running, lengths, root, .. } = &mut *model;
    let mut texts = Texts::new(parameters, running, root);
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
    let Model { graph, parameters, running, kinetic, potential, lengths, root, .. } = &mut *model;
    let length = lengths[0];
    let mut texts = Texts::new(parameters, running, root);
    let found = pairs(graph, *potential, length, false, Err(Reason::ListsInJacobi), &mut texts);
    let Pairs { bodies, pair, energy, .. } = found.map_err(|_| {
        Obstacle::Potential(
            "Jacobi coordinates require V as a sum over all pairs of bodies\nhelp: write a loop over `i` and one over \
             `j` in `0..i`, with the term `-G m[i] m[j] / |q[i] - q[j]|` of each pair\nnote: further terms may belong \
             to each pair, to each body, or to the first body and each other one"
                .to_owned(),
        )
    })?;
    let of_motion = per_body(graph, *kinetic, length, Part::Momentum, &mut texts);
    let inverse = of_motion.and_then(|(.., velocity)| inverse_mass(graph, &velocity, dimension));
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
    let in_rows = AllPairs::of(model).is_ok();
    jacobi.filter(|_| in_rows).ok_or_else(|| {
        Obstacle::Potential(
            "the terms of V do not have the same form for every pair of bodies\nhelp: use parameters of one body at a \
             time, such as `self.mass[i]`, and call no methods in their index"
                .to_owned(),
        )
    })
}

/// The list of masses, whose `self` may be that of a macro of the user.
pub(crate) fn masses(coordinates: &Coordinates) -> TokenStream {
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

#[cfg(test)]
mod tests;
