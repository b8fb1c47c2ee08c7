//! Access patterns: how the iterations of the gradients of `T` and `V` access the coordinates.
//!
//! In: a model and its gradients. Out: their pattern, found once before code generation. Flows, device code, Taylor's
//! recurrences and reports use it. Always true: the sum of a pattern equals the input; iterations with an unknown
//! access pattern run as written, one after the other. Loops over lists (`program/lists.rs`) and independent iterations
//! (`program/nest.rs`) are found in these lines.

pub(crate) mod all_pairs;
pub(crate) mod bodies;
mod energy;
mod flat;
mod once;
mod ragged;
pub(crate) mod sites;
pub(crate) mod stores;
pub(crate) mod triplets;

use crate::{
    differentiate::{Contribution, fold_branches, gradient},
    graph::{NodeId, Part},
    model::{Model, Texts},
    pairs::{with_numbers_of_each, written_out},
    program::lanes::are_many,
    stencil::Stencil,
};
use all_pairs::AllPairs;
pub(crate) use energy::stencil_of_energy;
pub(crate) use sites::lowered;

/// The gradient of H by the momenta and by the positions.
pub(crate) fn gradients(model: &mut Model) -> [Vec<Contribution>; 2] {
    let energies = [model.kinetic, model.potential];
    gradients_of(model, energies)
}

/// The same of an H with these energies.
pub(crate) fn gradients_of(model: &mut Model, [kinetic, potential]: [NodeId; 2]) -> [Vec<Contribution>; 2] {
    let by = [(Part::Momentum, kinetic), (Part::Position, potential)];
    let is_separable = model.is_separable();
    let whole = model.graph.add(kinetic, potential);
    by.map(|(part, own)| gradient(&mut model.graph, if is_separable { own } else { whole }, part))
}

/// How iterations reach the coordinates.
pub(crate) enum Pattern {
    /// Bodies act on each other in pairs, and move as their kinetic energy says.
    AllPairs(Box<AllPairs>),
    /// Sites of a lattice read their neighbours, in the gradient by the momenta and in that by the positions; or else
    /// iterations go one after the other.
    Sites([Option<Stencil>; 2]),
}

/// The pattern of the gradients of `T` and of `V`.
pub(crate) fn recognise(model: &mut Model, [kinetic, potential]: [&[Contribution]; 2]) -> Pattern {
    if model.is_separable()
        && let Ok(pairs) = AllPairs::of(model)
    {
        return Pattern::AllPairs(Box::new(pairs));
    }
    let folded = [kinetic, potential].map(|gradient| fold_branches(&mut model.graph, gradient));
    if let Some(stencils) = flat::stencils(model, &folded) {
        return Pattern::Sites(stencils);
    }
    let components = sites::components(model, &folded[1]);
    Pattern::Sites(folded.map(|gradient| sites::stencil_of(model, &gradient, components).ok()))
}

impl Pattern {
    /// Replaces the potential, and the same as stated, by equal ones: of pairs by one that prepares less, of lists of lists by one of
    /// one list, of loops over all pairs of indices by one that visits each pair once. `false` if nothing changes.
    pub(crate) fn restate(&self, model: &mut Model, stated: &mut NodeId) -> bool {
        let may_be_flat = model.is_separable() && model.sensitive.is_empty() && are_many(&model.graph, &model.lengths);
        let Model { graph, parameters, running, potential, root, .. } = model;
        let known = *potential;
        match self {
            Self::AllPairs(pairs) => {
                let mut texts = Texts::of_bodies(parameters, running, root, pairs.are_of_length());
                for energy in [potential, stated] {
                    *energy = written_out(graph, *energy, &mut texts);
                    for visited in &pairs.visited {
                        *energy = with_numbers_of_each(graph, *energy, *visited, &mut texts);
                    }
                }
            }
            Self::Sites([_, None]) if may_be_flat => {
                let mut texts = Texts::new(parameters, running, root);
                for energy in [potential, stated] {
                    *energy = once::visited_once(graph, *energy, &mut texts).unwrap_or(*energy);
                    *energy = ragged::flattened(graph, *energy, &mut texts).unwrap_or(*energy);
                }
            }
            Self::Sites(_) => {}
        }
        model.potential != known
    }

    /// The pairs, if bodies act on each other in pairs.
    pub(crate) fn pairs(&self) -> Option<&AllPairs> {
        match self {
            Self::AllPairs(pairs) => Some(pairs),
            Self::Sites(_) => None,
        }
    }

    /// The stencil of the gradient of `V`, whose indices are those of the user's coordinates.
    pub(crate) fn stencil_of_potential(&self) -> Option<&Stencil> {
        match self {
            Self::Sites([_, potential]) => potential.as_ref().filter(|stencil| stencil.flat.is_none()),
            Self::AllPairs(_) => None,
        }
    }
}
