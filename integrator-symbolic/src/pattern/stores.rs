//! The values that a flow along a gradient computes, and their destinations.

use crate::{
    differentiate::{Contribution, fold_branches},
    graph::{Element, NodeId, Part},
    lower::lower,
    model::{Model, is_leaf},
    program::{Sink, Store, is_direct, is_protected},
};

/// Stores that are computed together, and the coordinates that they move by way of a buffer, or on the spot.
pub(crate) struct Pass {
    pub(crate) stores: Vec<Store>,
    pub(crate) moved: Option<Part>,
}

/// What moves each coordinate by `step` times its component: on the spot where every coordinate gets one contribution,
/// else collected in a buffer, and each half in one of its own.
pub(crate) fn passes(model: &mut Model, gradient: &[Contribution], part: Part) -> Vec<Pass> {
    if gradient.is_empty() {
        return Vec::new();
    }
    let folded = fold_branches(&mut model.graph, gradient);
    let apart = gradient.iter().any(|contribution| is_protected(&mut model.graph, contribution));
    if !apart && is_direct(&model.graph.loops, &folded) {
        return vec![Pass { stores: stores(model, &folded, Sink::Update), moved: None }];
    }
    let mut collected = |part: Part, half: &[Contribution]| Pass {
        stores: stores(model, half, Sink::Collect),
        moved: Some(part.other()),
    };
    if gradient.iter().all(|contribution| contribution.element.part == part) {
        return vec![collected(part, gradient)];
    }
    let (own, other): (Vec<_>, Vec<_>) =
        gradient.iter().cloned().partition(|contribution| contribution.element.part == part);
    vec![collected(part, &own), collected(part.other(), &other)]
}

/// Where the components of a gradient go; what updates a coordinate is multiplied by the step.
pub(crate) fn stores(model: &mut Model, gradient: &[Contribution], sink: fn(Element) -> Sink) -> Vec<Store> {
    let target = |contribution: &Contribution| {
        let element = contribution.element;
        sink(element.partner())
    };
    let mut value = |contribution: &Contribution| match target(contribution) {
        Sink::Update(_) => model.graph.stepped(contribution.value),
        _ => contribution.value,
    };
    let values: Vec<NodeId> = gradient.iter().map(&mut value).collect();
    let conditions = gradient.iter().flat_map(Contribution::conditions);
    let roots: Vec<NodeId> = values.iter().copied().chain(conditions).collect();
    let lowered = lower_roots(model, &roots);
    let of = |id: NodeId| roots.iter().position(|root| *root == id).map_or(id, |position| lowered[position]);
    let stores = gradient.iter().zip(values).map(|(contribution, value)| Store {
        context: contribution.around(of),
        sink: target(contribution),
        value: of(value),
    });
    stores.collect()
}

/// Values for `roots` without powers, whose prepared constants are left alone.
pub(crate) fn lower_roots(model: &mut Model, roots: &[NodeId]) -> Vec<NodeId> {
    let Model { graph, parameters, .. } = model;
    lower(graph, roots, |graph, id| is_leaf(graph, parameters, id))
}
