//! Sites of a lattice with the same formula.

use super::stores::lower_roots;
use crate::{
    differentiate::Contribution,
    graph::{Graph, Scope, index::IndexId},
    model::{Model, is_leaf},
    program::{Sink, Store},
    reason::Reason,
    stencil::{Components, Direction, Stencil, stencil},
};

/// What the gradient of the potential shows about coordinates with two indices. A kinetic energy looks the same for
/// points as for rows of sites.
pub(crate) fn components(model: &mut Model, potential: &[Contribution]) -> Components {
    let Model { graph, parameters, extents, .. } = model;
    let has_unknown_width = matches!(extents[..], [_, width] if graph.loops.literal(width).is_none());
    if !has_unknown_width {
        return Components::Unknown;
    }
    let leaf = |graph: &Graph, id| is_leaf(graph, parameters, id);
    stencil(graph, potential, extents, Components::Unknown, leaf).map_or(Components::Unknown, |_| Components::Sites)
}

/// The stencil of a gradient, if all sites take part alike.
pub(crate) fn stencil_of(
    model: &mut Model,
    gradient: &[Contribution],
    components: Components,
) -> Result<Stencil, Reason> {
    let extents = model.extents.clone();
    stencil_on(model, gradient, &extents, components)
}

/// The stencil of a gradient on a lattice of these lengths, if all sites take part alike.
pub(super) fn stencil_on(
    model: &mut Model,
    gradient: &[Contribution],
    lengths: &[IndexId],
    components: Components,
) -> Result<Stencil, Reason> {
    let Model { graph, parameters, running, .. } = model;
    let stencil = stencil(graph, gradient, lengths, components, |graph, id| is_leaf(graph, parameters, id))?;
    for Direction { place, begins, .. } in &stencil.directions {
        let first = gradient.iter().flat_map(Contribution::loops).find(|by| begins.contains_key(by));
        let index = first.and_then(|first| running.get(&first)).ok_or(Reason::Unrecognised)?.clone();
        running.entry(*place).or_insert(index);
    }
    Ok(stencil)
}

/// A stencil whose values have no powers.
pub(crate) fn lowered(model: &mut Model, stencil: &Stencil) -> Stencil {
    let mut stencil = stencil.clone();
    let values: Vec<_> = stencil.contributions.iter().map(|contribution| contribution.value).collect();
    for (contribution, value) in stencil.contributions.iter_mut().zip(lower_roots(model, &values)) {
        contribution.value = value;
    }
    stencil
}

/// Where the values of contributions go.
pub(crate) fn stores(stencil: &Stencil) -> Vec<Store> {
    let context: Vec<_> = stencil.directions.iter().map(|direction| Scope::Loop(direction.place)).collect();
    let stores = stencil.contributions.iter().enumerate().map(|(number, contribution)| Store {
        context: context.clone(),
        sink: Sink::Contribution(number),
        value: contribution.value,
    });
    stores.collect()
}
