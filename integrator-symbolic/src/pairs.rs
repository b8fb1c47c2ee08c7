//! Pair potentials: their recognition, and the force of one body on another.
//!
//! In: a potential. Out: the gradient of one pair's energy and of the one-body terms, or nothing for another kind of
//! potential. Always true: the energy of a pair is symmetric in its bodies, so an executor may process the pairs in any
//! order and may let either body be the first; a pair reads only the coordinates of its two bodies.

mod attraction;
mod canonical;
mod central;
mod components;
mod cutoff;
mod embedded;
mod exchange;
mod extremes;
mod half;
mod images;
mod included;
mod merged;
mod order;
mod partners;
pub(crate) mod points;
mod renamed;
mod shifted;
mod terms;
mod triplets;

use crate::{
    differentiate::{Contribution, gradient},
    graph::{
        Graph, Node, NodeId, Part,
        index::{Index, IndexId, Loop, LoopId},
        rename::{Parameters, Renaming},
    },
    reason::Reason,
};
pub(crate) use attraction::{attraction, inverse_mass, softening};
pub(crate) use canonical::canonical;
pub(crate) use central::pull;
pub(crate) use components::written_out;
pub(crate) use cutoff::Cutoff;
use cutoff::cutoff;
pub(crate) use embedded::{Density, Embedded};
use exchange::Forms;
pub(crate) use exchange::{are_equal, sign_of_exchange};
pub(crate) use images::with_one_form;
use order::Order;
pub(crate) use order::{rewritten, with_numbers_of_each};
pub(crate) use partners::{Visited, addend_of_distinct_pair};
pub(crate) use renamed::renamed;
use terms::{Terms, addends};
pub(crate) use terms::{acting, moving};
pub(crate) use triplets::Triplets;

/// A potential of pairs.
pub(crate) struct Pairs {
    /// The loop over all bodies.
    pub(crate) bodies: LoopId,
    /// The loops over the two bodies of a pair.
    pub(crate) pair: [LoopId; 2],
    /// All loops over the two bodies of a pair.
    pub(crate) visited: Vec<Visited>,
    /// The distance beyond which bodies do not act on each other, or why lists of neighbours are not used.
    pub(crate) cutoff: Result<Cutoff, Reason>,
    /// The condition of indices and parameters without which a pair contributes nothing, where lists leave such pairs out.
    pub(crate) included: Option<NodeId>,
    /// The energy of a pair that is not left out.
    pub(crate) energy: NodeId,
    /// The gradient of a pair's energy by the coordinates of its first body.
    pub(crate) force: Vec<Contribution>,
    /// Whether the gradient by those of the second body is the same with another sign: action is reaction.
    pub(crate) reciprocal: bool,
    /// The energy of a body alone.
    pub(crate) energy_alone: NodeId,
    /// The gradient of the one-body terms.
    pub(crate) alone: Vec<Contribution>,
    /// The energies of a body that depend on sums over its partners.
    pub(crate) embedded: Embedded,
    /// The terms of a body and two others within a cutoff.
    pub(crate) triplets: Option<Triplets>,
    /// Why a sum over a body and two others is among other terms.
    pub(crate) triplet_obstacle: Option<Reason>,
    /// The energy of all other terms, and its gradient.
    pub(crate) others: (NodeId, Vec<Contribution>),
}

/// Recognises a potential of pairs among `length` bodies. Only of many bodies are the pairs apart from other terms, and are
/// those in order that may not be exchanged. `dimension` is the number of coordinates of a body whose neighbours may be listed, or the
/// reason why not.
pub(crate) fn pairs(
    graph: &mut Graph,
    potential: NodeId,
    length: IndexId,
    are_many: bool,
    dimension: Result<u64, Reason>,
    parameters: &mut dyn Parameters,
) -> Result<Pairs, Reason> {
    let Terms {
        pair,
        ascending,
        bodies,
        mut visited,
        pairs,
        alone,
        embedded,
        triplets,
        triplet_obstacle,
        others,
        obstacle,
        ..
    } = Terms::of(graph, potential, length, (are_many, dimension.ok()), parameters);
    let of_triplet = triplets.as_ref();
    let pair = pair.or_else(|| embedded.densities.first().map(|density| density.pair));
    let pair = pair.or_else(|| of_triplet.map(|Triplets { bodies: [i, j, _], .. }| [*i, *j]));
    let pair = pair.ok_or(triplet_obstacle.or(obstacle).unwrap_or(Reason::NoPairs))?;
    visited.extend(embedded.densities.iter().map(|density| Visited { pair: density.pair, ascending: None }));
    let [alone, others] = [alone, others].map(|terms| total(graph, terms));
    let mut written = graph.constant(0.0);
    for term in pairs {
        let term = merged::in_one_direction(graph, term, pair, parameters);
        written = merged::sum(graph, [written, term], (pair, order::ends(ascending)), parameters);
    }
    let of_others = gradient(graph, others, Part::Position);
    if !of_others.is_empty() && !are_many {
        return Err(obstacle.unwrap_or(Reason::PairsAndOthers));
    }
    let order = ascending.filter(|_| are_many).map(|ascending| Order::of(graph, pair, ascending));
    let (energy, order) = match order {
        None => (written, None),
        Some(order) => (order.symmetric(graph, written, parameters).ok_or(Reason::PairOrder)?, Some(order)),
    };
    let embedded_pairs = embedded.of_pair(graph, pair, parameters).ok_or(Reason::PairOrder)?;
    if order.is_none() {
        let mut forms = Forms::new(pair, order, parameters);
        let exchanged = [false, true].map(|exchanged| forms.of(graph, energy, exchanged));
        if exchanged[0].is_none() || exchanged[0] != exchanged[1] {
            return Err(Reason::PairOrder);
        }
    }
    let ends = order.map_or([None; 2], |order| order.ends);
    let cutoff = dimension.and_then(|dimension| {
        // Bodies come in the order of the loops, without choices by their numbers.
        let written = graph.add(written, embedded_pairs);
        let of_pairs = match of_triplet {
            Some(triplets) if graph.as_constant(written) == Some(0.0) => return Ok(triplets.cutoff.clone()),
            _ => cutoff(graph, written, (pair, ends), bodies, dimension, parameters)?,
        };
        match of_triplet {
            None => Ok(of_pairs),
            Some(triplets) => of_pairs.or_larger(graph, triplets.cutoff.clone()).ok_or(Reason::CutoffBoxes),
        }
    });
    let mut forms = Forms::new(pair, order, parameters);
    let (mut energy, mut included) = (energy, None);
    if cutoff.is_ok()
        && embedded.densities.is_empty()
        && of_triplet.is_none()
        && let Some((condition, inner)) = included::included(graph, energy, pair, &mut forms)
    {
        (energy, included) = (inner, Some(condition));
    }
    let with_embedded = graph.add(energy, embedded_pairs);
    let gradients = gradient(graph, with_embedded, Part::Position);
    let [force, reaction] = pair.map(|by| -> Vec<Contribution> {
        let own = |contribution: &&Contribution| graph.loops.index(contribution.element.index) == Index::Running(by);
        gradients.iter().filter(own).cloned().collect()
    });
    let reciprocal = force.len() == reaction.len()
        && force.iter().all(|action| {
            reaction.iter().any(|reaction| {
                let same_place =
                    action.context == reaction.context && action.element.component == reaction.element.component;
                let [action, reaction] = [action, reaction].map(|of| forms.of(graph, of.value, false));
                same_place && action.zip(reaction).is_some_and(|(action, reaction)| action.opposite() == reaction)
            })
        });
    let energy_alone = alone;
    let alone = gradient(graph, alone, Part::Position);
    let others = (others, of_others);
    Ok(Pairs {
        bodies,
        pair,
        visited,
        cutoff,
        included,
        energy,
        force,
        reciprocal,
        energy_alone,
        alone,
        embedded,
        triplets,
        triplet_obstacle,
        others,
    })
}

fn total(graph: &mut Graph, terms: Vec<NodeId>) -> NodeId {
    let zero = graph.constant(0.0);
    terms.into_iter().fold(zero, |sum, term| graph.add(sum, term))
}

/// The energy of a body alone, what the energy is beside it, which depends on parameters alone, and the gradient of the first by
/// positions or by momenta: without the loop over all bodies, which is around all of them.
pub(crate) fn per_body(
    graph: &mut Graph,
    energy: NodeId,
    length: IndexId,
    part: Part,
    parameters: &mut dyn Parameters,
) -> Option<(NodeId, NodeId, Vec<Contribution>)> {
    let Terms { pair, alone, others, .. } = Terms::of(graph, energy, length, (false, None), parameters);
    let [alone, others] = [alone, others].map(|terms| total(graph, terms));
    let apart = pair.is_none() && graph.is_prepared(others);
    apart.then(|| (alone, others, gradient(graph, alone, part)))
}

/// The loop over this number of bodies.
pub(crate) fn over_all(graph: &mut Graph, length: IndexId) -> LoopId {
    let from = graph.loops.intern(Index::Literal(0));
    graph.loops.range(Loop { parent: None, from, to: length })
}

/// Whether a node reads the coordinates of the bodies with the indices of `own` and of no others, and parameters of one
/// of these bodies at a time.
fn reads_only(graph: &mut Graph, root: NodeId, own: &[LoopId], parameters: &mut dyn Parameters) -> bool {
    let mut open = vec![root];
    let mut seen = vec![false; graph.len()];
    while let Some(id) = open.pop() {
        if std::mem::replace(&mut seen[id.position()], true) {
            continue;
        }
        let loops = graph.loops_of(id);
        let named = own.iter().filter(|by| loops.contains(**by)).count();
        if graph.is_prepared(id) && named == 0 && !graph.node(id).is_condition() {
            continue;
        }
        let alone = named == 0 || loops.iter().count() == 1;
        let fits = match graph.node(id) {
            Node::Coordinate(element) => {
                let of_body = own.iter().any(|by| graph.loops.index(element.index) == Index::Running(*by));
                let component = element.component.map(|component| graph.loops.of_index(component));
                of_body && own.iter().all(|by| component.is_none_or(|component| !component.contains(*by)))
            }
            Node::Sum(by, _) => {
                let range = graph.loops.get(by);
                let counted = |index| {
                    let bounds = graph.loops.of_index(index);
                    let known = matches!(graph.loops.index(index), Index::Literal(_) | Index::Parameter(_));
                    known && !own.iter().any(|own| bounds.contains(*own))
                };
                !own.contains(&by) && counted(range.from) && counted(range.to)
            }
            Node::Parameter(parameter) => {
                let to = own[0];
                let known = |by: LoopId| loops.contains(by);
                let from = own.iter().copied().find(|by| known(*by)).unwrap_or(to);
                alone && parameters.rename(graph, parameter, Renaming::one(from, to)).is_some()
            }
            Node::FromIndex(_) => alone,
            Node::Flag(_) | Node::CompareIndex(..) => named == 0,
            // A method of the user is called member by member, not body by body.
            Node::External(..) => false,
            _ => true,
        };
        if !fits {
            return false;
        }
        match graph.node(id) {
            // A number of one body that is chosen once per run, such as that of a list which ends before the bodies do.
            Node::Select(condition, a, b)
                if alone && graph.is_prepared(id) && matches!(graph.node(condition), Node::CompareIndex(..)) =>
            {
                open.extend([a, b]);
            }
            node => open.extend(node.children()),
        }
    }
    true
}
