//! Why a faster layout does not apply to a flow.
//!
//! Recognisers return the reason with which they give up. This module calls them again for reports and messages, so that
//! an expansion without these does not pay for reasons.

use super::{Form, form_along, forms, forms_of_bodies, lane_context, list_sum, program_along, scheduled};
use crate::{
    differentiate::{Contribution, fold_branches, gradient},
    graph::{
        Graph, Node, NodeId, Part,
        exact::Exact,
        index::{Index, LoopId},
    },
    model::{Model, Texts, is_field},
    pairs::{acting, pairs},
    pattern::{
        Pattern,
        all_pairs::{AllPairs, Others},
        gradients, recognise,
        sites::{components, stencil_of},
    },
    program::{Item, Program, Sink, lists::is_over_list},
    reason::Reason,
};

/// A faster layout that a flow, or one of its loops, does not have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Lost {
    pub(crate) form: Form,
    /// The loop, if only one is concerned.
    pub(crate) by: Option<LoopId>,
    pub(crate) reason: Reason,
}

/// The faster layouts that the flow along the gradient of `T` or of `V` does not have.
pub(crate) fn lost(model: &mut Model, gradient: &[Contribution], part: Part, pattern: &Pattern) -> Vec<Lost> {
    let of_flow = |form, reason| Lost { form, by: None, reason };
    match (pattern, part) {
        (Pattern::AllPairs(_), Part::Momentum) => Vec::new(),
        (Pattern::AllPairs(pairs), Part::Position) => {
            // Without any condition on the distance, lists are not meant.
            let lists = pairs.listed.as_ref().err().filter(|reason| **reason >= Reason::CutoffOfTerm);
            let lists = lists.map(|reason| of_flow(Form::Lists, *reason));
            let triplets = pairs.triplet_obstacle.map(|reason| of_flow(Form::Triplets, reason));
            let lists = lists.into_iter().chain(triplets);
            lists.chain(pairs.others.iter().flat_map(|others| lost_of_others(model, others))).collect()
        }
        (Pattern::Sites([Some(_), _]), Part::Momentum) | (Pattern::Sites([_, Some(_)]), Part::Position) => Vec::new(),
        _ if gradient.is_empty() => Vec::new(),
        _ => {
            let of_pairs = (part == Part::Position).then(|| of_pairs(model)).flatten();
            let form = form_along(model, gradient, part);
            let of_pairs = of_pairs.filter(|reason| *reason != Reason::PairWithItself || form == Form::Plain);
            let whole = match of_pairs {
                Some(reason) => Some(of_flow(Form::Pairs, reason)),
                None => of_sites(model, gradient).map(|(form, reason)| of_flow(form, reason)),
            };
            whole.into_iter().chain(lost_along(model, gradient, part)).collect()
        }
    }
}

/// The same of the flow of a part that `split` names, if it moves along a gradient, with its layout.
pub(crate) fn of_part(model: &mut Model, number: usize) -> Option<(Form, Vec<Lost>)> {
    let energy = model.parts[number].energy;
    let part = match model.parts[number].form {
        Exact::OfMomenta => Part::Momentum,
        Exact::OfPositions => Part::Position,
        _ => return None,
    };
    let gradient = gradient(&mut model.graph, energy, part);
    if part == Part::Position
        && let Some(pairs) = AllPairs::of_part(model, energy)
    {
        let lost = pairs.listed.as_ref().err().map(|reason| Lost { form: Form::Lists, by: None, reason: *reason });
        return Some((forms_of_bodies(model, &pairs)[1], lost.into_iter().collect()));
    }
    let mut all = lost_along(model, &gradient, part);
    if is_of_pairs(model, energy) {
        all.insert(0, Lost { form: Form::Pairs, by: None, reason: Reason::InPart });
    }
    Some((form_along(model, &gradient, part), all))
}

/// The layout of the kick, and why it is not the wanted one, if that is known.
pub(crate) fn why_not(model: &mut Model, wanted: Form) -> (Form, Option<Reason>) {
    model.choose_in_the_middle();
    let [kinetic, potential] = gradients(model);
    let pattern = recognise(model, [&kinetic, &potential]);
    let mut stated = model.potential;
    let [kinetic, potential] = match pattern.restate(model, &mut stated) {
        true => gradients(model),
        false => [kinetic, potential],
    };
    let ([_, kick], _) = forms(model, [&kinetic, &potential], &pattern);
    let reason = match wanted {
        _ if kick.name() == wanted.name() => None,
        Form::Plain => None,
        Form::Triplets | Form::TripletsOfPairs => match AllPairs::of(model) {
            Err(reason) => Some(reason),
            Ok(pairs) => Some(pairs.triplet_obstacle.unwrap_or(Reason::NoTriplets)),
        },
        Form::Row | Form::Pairs | Form::Lists | Form::ListsInBox => match AllPairs::of(model) {
            Err(reason) => Some(reason),
            Ok(_) if wanted == Form::Row => Some(Reason::ManyBodies),
            Ok(_) if wanted == Form::Pairs => (kick == Form::Row).then_some(Reason::FewBodies),
            Ok(pairs) => pairs.listed.err(),
        },
        Form::Line | Form::Plane | Form::Volume => match (model.extents.len(), wanted) {
            (1, Form::Line) | (2, Form::Plane) | (3, Form::Volume) => stencil_reason(model, &potential),
            (1, _) => Some(Reason::OneIndex),
            (2, _) => Some(Reason::TwoIndices),
            _ => Some(Reason::ThreeIndices),
        },
        Form::Lanes | Form::Terms => {
            let loops = lost_along(model, &potential, Part::Position);
            let of_wanted = loops.into_iter().find(|lost| lost.form == wanted).map(|lost| lost.reason);
            of_wanted.or(Some(if wanted == Form::Terms { Reason::NoList } else { Reason::NoLoop }))
        }
    };
    (kick, reason.filter(|reason| *reason != Reason::Unrecognised))
}

/// Why V is not a sum over pairs, if it has loops over pairs of bodies.
fn of_pairs(model: &mut Model) -> Option<Reason> {
    let is_other = |reason: &Reason| {
        matches!(reason, Reason::Unrecognised | Reason::NoPairs | Reason::BodyShape | Reason::OneBody)
    };
    if !model.is_separable() {
        return None;
    }
    AllPairs::of(model).err().filter(|reason| !is_other(reason))
}

/// Whether an energy is a sum over pairs of bodies.
fn is_of_pairs(model: &mut Model, energy: NodeId) -> bool {
    let Some(length) = model.lengths.first().copied() else { return false };
    let Model { graph, parameters, running, root, .. } = model;
    let Ok(acting) = acting(graph, energy, length) else { return false };
    pairs(graph, energy, acting, true, Err(Reason::NoCutoff), &mut Texts::new(parameters, running, root)).is_ok()
}

/// Why sites do not take part alike, if iterations read neighbours, and the lattice that they would be.
fn of_sites(model: &mut Model, gradient: &[Contribution]) -> Option<(Form, Reason)> {
    let form = match model.extents.len() {
        1 => Form::Line,
        2 => Form::Plane,
        _ => Form::Volume,
    };
    let reads_neighbours = gradient.iter().any(|contribution| reads_neighbours(&model.graph, contribution.value));
    let reason = stencil_reason(model, gradient).filter(|_| reads_neighbours)?;
    (!matches!(reason, Reason::Unrecognised | Reason::NoSites)).then_some((form, reason))
}

fn stencil_reason(model: &mut Model, gradient: &[Contribution]) -> Option<Reason> {
    let folded = fold_branches(&mut model.graph, gradient);
    let components = components(model, &folded);
    stencil_of(model, &folded, components).err()
}

/// Whether a value reads a coordinate at the index of a loop plus or minus a number.
fn reads_neighbours(graph: &Graph, value: NodeId) -> bool {
    graph.reachable([value]).into_iter().any(|id| match graph.node(id) {
        Node::Coordinate(element) => graph.loops.of_coordinate(element).any(|index| {
            let is_shifted = matches!(graph.loops.index(index), Index::Add(..) | Index::Sub(..) | Index::Rem(..));
            is_shifted && graph.loops.is_without_lists(index) && !graph.loops.of_index(index).is_empty()
        }),
        _ => false,
    })
}

fn lost_along(model: &mut Model, gradient: &[Contribution], part: Part) -> Vec<Lost> {
    program_along(model, gradient, part).map_or_else(Vec::new, |program| lost_in(model, &program))
}

fn lost_of_others(model: &Model, others: &Others) -> Vec<Lost> {
    lost_in(model, &scheduled(model, &others.gradient))
}

/// The innermost loops of a program that are plain code, and why; of loops with the same reason, the first.
fn lost_in(model: &Model, program: &Program) -> Vec<Lost> {
    let mut all = Vec::new();
    add_lost(model, program, &program.items, &mut all);
    let mut known: Vec<Lost> = Vec::new();
    for lost in all {
        if lost.reason != Reason::Unrecognised && !known.iter().any(|known| known.reason == lost.reason) {
            known.push(lost);
        }
    }
    known
}

fn add_lost(model: &Model, program: &Program, items: &[Item], all: &mut Vec<Lost>) {
    let is_kept = |id| is_field(&model.graph, &model.parameters, id);
    let context = lane_context(model, program, &is_kept);
    for item in items {
        match item {
            Item::Loop { by, body } if is_over_list(&model.graph, *by, body) => {
                let sum = list_sum(&model.graph, &model.lengths, &model.parameters, &program.named, *by, body);
                all.extend(sum.err().map(|reason| Lost { form: Form::Terms, by: Some(*by), reason }));
            }
            Item::Loop { body, .. } if body.iter().any(|item| matches!(item, Item::Loop { .. })) => {
                add_lost(model, program, body, all);
            }
            // Coordinates that move on the spot: a loop that the compiler vectorises.
            Item::Loop { body, .. } if body.iter().any(|item| matches!(item, Item::Sink(Sink::Update(_), _))) => {}
            Item::Loop { by, .. } => {
                let lanes = context.loop_in_lanes(items, item);
                all.extend(lanes.err().map(|reason| Lost { form: Form::Lanes, by: Some(*by), reason }));
            }
            Item::Branch { body, .. } => add_lost(model, program, body, all),
            _ => {}
        }
    }
}
