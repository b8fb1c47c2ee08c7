//! The values that a flow along a gradient computes, and their destinations.

use crate::{
    differentiate::{Contribution, fold_branches},
    graph::{Element, Graph, NodeId, Part},
    lower::lower,
    model::{Model, is_leaf},
    program::{
        Sink, Store, is_direct, is_protected,
        lanes::{are_many, is_function},
    },
};
use std::collections::HashSet;

/// Stores that are computed together, and the coordinates that they move by way of a buffer, or on the spot.
pub(crate) struct Pass {
    pub(crate) stores: Vec<Store>,
    pub(crate) moved: Option<Part>,
}

/// What moves each coordinate by `step` times its component: on the spot where every coordinate gets one contribution,
/// else collected in a buffer, and each half in one of its own. A mean field is collected as well, since loops that collect
/// compute functions in lanes.
pub(crate) fn passes(model: &mut Model, gradient: &[Contribution], part: Part) -> Vec<Pass> {
    if gradient.is_empty() {
        return Vec::new();
    }
    let folded = fold_branches(&mut model.graph, gradient);
    let apart = gradient.iter().any(|contribution| is_protected(&mut model.graph, contribution));
    let in_lanes = are_many(&model.graph, &model.lengths)
        && folded.iter().any(|contribution| has_functions_and_sums(&model.graph, contribution.value));
    if !apart && !in_lanes && is_direct(&model.graph.loops, &folded) {
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

/// Whether a value is computed from sums over coordinates, and by functions or divisions outside of these.
fn has_functions_and_sums(graph: &Graph, value: NodeId) -> bool {
    let (mut has_functions, mut has_sums) = (false, false);
    let (mut open, mut seen) = (vec![value], HashSet::new());
    while let Some(id) = open.pop() {
        if graph.is_prepared(id) || !seen.insert(id) {
            continue;
        }
        if graph.loops_of(id).is_empty() && !graph.summed_in(id).is_empty() {
            has_sums = true;
            continue;
        }
        has_functions |= is_function(graph.node(id));
        open.extend(graph.node(id).children());
    }
    has_functions && has_sums
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
