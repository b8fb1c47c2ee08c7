//! The values that a flow along a gradient computes, and their destinations.

use crate::{
    differentiate::{Contribution, fold_branches, select_in_branch},
    graph::{
        Element, Graph, NodeId, Part, Scope,
        index::{Index, LoopId},
        unroll::{Unrolled, component, components},
    },
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
/// else collected in a buffer, and each half in one of its own. Functions are collected as well, since loops that collect
/// compute these in lanes.
pub(crate) fn passes(model: &mut Model, gradient: &[Contribution], part: Part) -> Vec<Pass> {
    if gradient.is_empty() {
        return Vec::new();
    }
    let folded = fold_branches(&mut model.graph, gradient);
    let apart = gradient.iter().any(|contribution| is_protected(&mut model.graph, contribution));
    let in_lanes = are_many(&model.graph, &model.lengths)
        && folded.iter().any(|contribution| has_functions(&model.graph, contribution.value));
    if !apart && !in_lanes && is_direct(&model.graph.loops, &folded) {
        return vec![Pass { stores: stores(model, &folded, Sink::Update), moved: None }];
    }
    let mut collected =
        |part: Part, half: &[Contribution]| Pass { stores: collecting(model, half), moved: Some(part.other()) };
    if gradient.iter().all(|contribution| contribution.element.part == part) {
        return vec![collected(part, gradient)];
    }
    let (own, other): (Vec<_>, Vec<_>) =
        gradient.iter().cloned().partition(|contribution| contribution.element.part == part);
    vec![collected(part, &own), collected(part.other(), &other)]
}

/// Whether a value is computed by functions or divisions outside of sums that are the same in all iterations.
fn has_functions(graph: &Graph, value: NodeId) -> bool {
    let (mut open, mut seen) = (vec![value], HashSet::new());
    while let Some(id) = open.pop() {
        let is_sum = graph.loops_of(id).is_empty() && !graph.summed_in(id).is_empty();
        if graph.is_prepared(id) || is_sum || !seen.insert(id) {
            continue;
        }
        if is_function(graph.node(id)) {
            return true;
        }
        open.extend(graph.node(id).children());
    }
    false
}

/// What collects a gradient in a buffer. Where loops may be in lanes, those over components are written out.
pub(crate) fn collecting(model: &mut Model, gradient: &[Contribution]) -> Vec<Store> {
    let unrolled =
        if are_many(&model.graph, &model.lengths) { by_components(&mut model.graph, gradient) } else { None };
    stores(model, unrolled.as_deref().unwrap_or(gradient), Sink::Collect)
}

/// A value that is computed beside such a gradient.
pub(crate) fn unrolled(model: &mut Model, value: NodeId) -> NodeId {
    let unrolled = are_many(&model.graph, &model.lengths).then(|| Unrolled::default().value(&mut model.graph, value));
    unrolled.flatten().unwrap_or(value)
}

/// Contributions without loops over components; `None` where these cannot be written out.
fn by_components(graph: &mut Graph, gradient: &[Contribution]) -> Option<Vec<Contribution>> {
    let (mut unrolled, mut all) = (Unrolled::default(), Vec::new());
    for contribution in gradient {
        all.extend(by_component(graph, &mut unrolled, contribution)?);
    }
    Some(all)
}

/// One of them, for each component.
fn by_component(graph: &mut Graph, unrolled: &mut Unrolled, contribution: &Contribution) -> Option<Vec<Contribution>> {
    let mut first = contribution.clone();
    first.value = unrolled.value(graph, contribution.value)?;
    for around in &mut first.context {
        if let Scope::Branch(condition, _) = around {
            *condition = unrolled.value(graph, *condition)?;
        }
    }
    let mut all = vec![first];
    let is_component = |graph: &Graph, by: LoopId| {
        let of = |component| graph.loops.index(component) == Index::Running(by);
        components(graph, by).is_some() && contribution.element.component.is_some_and(of)
    };
    let loops: Vec<LoopId> = contribution.loops().filter(|by| is_component(graph, *by)).collect();
    for by in loops {
        let numbers = components(graph, by)?;
        let mut next = Vec::new();
        for contribution in all {
            for number in numbers.clone() {
                let mut item = Contribution {
                    context: Vec::new(),
                    element: component(graph, contribution.element, by, number)?,
                    value: unrolled.item(graph, contribution.value, by, number)?,
                };
                for around in &contribution.context {
                    match around {
                        Scope::Loop(own) if *own == by => {}
                        Scope::Loop(other) if graph.loops.of_range(*other).contains(by) => return None,
                        Scope::Loop(_) => item.context.push(*around),
                        Scope::Branch(condition, holds) => {
                            let condition = unrolled.item(graph, *condition, by, number)?;
                            item.context.push(Scope::Branch(condition, *holds));
                        }
                    }
                }
                next.push(item);
            }
        }
        all = next;
    }
    all.iter_mut().try_for_each(|contribution| sum_up(graph, contribution))?;
    Some(all)
}

/// Turns the loops after all those of the coordinate into sums; `None` where one of these, or a condition among them, decides
/// whether the coordinate exists.
fn sum_up(graph: &mut Graph, contribution: &mut Contribution) -> Option<()> {
    let own = graph.loops.of_element(contribution.element);
    let is_own = |around: &Scope| matches!(around, Scope::Loop(by) if own.contains(*by));
    let deepest = contribution.context.iter().rposition(is_own).map_or(0, |deepest| deepest + 1);
    if contribution.context[deepest..].iter().any(|around| matches!(around, Scope::Loop(_))) {
        let coordinate = graph.coordinate(contribution.element);
        if contribution.context[deepest..].iter().any(|around| graph.protects(*around, coordinate)) {
            return None;
        }
        for around in contribution.context.split_off(deepest).into_iter().rev() {
            contribution.value = select_in_branch(graph, around, contribution.value);
        }
    }
    Some(())
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
