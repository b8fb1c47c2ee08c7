//! The order of the bodies of a pair, for energies that change if the bodies are exchanged.
//!
//! Loops over pairs determine which body is the first. The runtime processes pairs in any order. It computes the same energy if
//! the energy selects each constant by comparing the indices of the two bodies, and multiplies each displacement by the sign of
//! this comparison. Always true: if the bodies come in the order of the loops, the value of the energy does not change.

use super::{
    exchange::Forms,
    partners::{Visited, addend_of_distinct_pair},
};
use crate::graph::{
    Comparison, Element, Graph, Node, NodeId, ParameterId, Part,
    index::{Index, IndexId, LoopId, LoopSet},
    rename::{End, Parameters, Renaming, rename},
};
use std::collections::HashMap;

/// The order of the loops over a pair.
#[derive(Clone, Copy)]
pub(super) struct Order {
    pair: [LoopId; 2],
    /// For each body of a pair, the end of the list at which it has no partner. The last body never has the smaller index.
    pub(super) ends: [Option<End>; 2],
    /// The condition that the indices of the bodies are in the order of the loops.
    holds: NodeId,
    /// One if the condition holds, else minus one.
    sign: NodeId,
}

/// The constants that are chosen by the order.
#[derive(Clone, Copy, PartialEq)]
enum Constants {
    InEntries,
    InConditions,
    InEntriesAndConditions,
    All,
}

impl Constants {
    /// From the fewest to all.
    const CHOICES: [Option<Self>; 5] =
        [None, Some(Self::InEntries), Some(Self::InConditions), Some(Self::InEntriesAndConditions), Some(Self::All)];
}

impl Order {
    /// The order of a pair. `ascending` means that the second body has the larger index.
    pub(super) fn of(graph: &mut Graph, pair: [LoopId; 2], ascending: bool) -> Self {
        let ends = ends(Some(ascending));
        let [first, second] = pair.map(|by| {
            let index = graph.loops.intern(Index::Running(by));
            graph.number_of(index)
        });
        let [less, greater] = if ascending { [first, second] } else { [second, first] };
        let holds = graph.compare(Comparison::Less, less, greater);
        let [plus, minus] = [1.0, -1.0].map(|sign| graph.constant(sign));
        Self { pair, ends, holds, sign: graph.select(holds, plus, minus) }
    }

    /// How a node changes if the bodies are exchanged: `Some(true)` if it changes its sign, `Some(false)` if it stays the same,
    /// `None` if the node does not determine it.
    pub(super) fn exchanged(&self, graph: &Graph, id: NodeId) -> Option<bool> {
        match graph.node(id) {
            _ if id == self.sign => Some(true),
            Node::Select(condition, ..) if condition == self.holds => Some(false),
            _ => None,
        }
    }

    /// Returns an energy that is symmetric in the bodies and equal to `energy` if the bodies are in order.
    pub(super) fn symmetric(
        &self,
        graph: &mut Graph,
        energy: NodeId,
        parameters: &mut dyn Parameters,
    ) -> Option<NodeId> {
        let known = graph.truth(true);
        let energy = rewritten(graph, energy, |_, id| if id == self.holds { Some(known) } else { None });
        let mut choices = None;
        for constants in Constants::CHOICES {
            let chosen = match constants {
                None => energy,
                Some(constants) => {
                    let choices = match &mut choices {
                        Some(choices) => choices,
                        none => none.insert(self.choices(graph, energy, parameters)?),
                    };
                    choose(graph, energy, constants, choices)
                }
            };
            for has_signs in [false, true] {
                let candidate = if has_signs { self.sign_displacements(graph, chosen) } else { chosen };
                let mut forms = Forms::new(self.pair, Some(*self), parameters);
                let [here, there] = [false, true].map(|exchanged| forms.of(graph, candidate, exchanged));
                if here.is_some() && here == there {
                    return Some(candidate);
                }
            }
        }
        None
    }

    /// Maps each constant of one body to the selection that replaces it. A list that only one body of the pair reads may lack the
    /// element at the end where this body has no partner, so the replacement does not read it there.
    fn choices(
        &self,
        graph: &mut Graph,
        energy: NodeId,
        parameters: &mut dyn Parameters,
    ) -> Option<HashMap<NodeId, NodeId>> {
        let mut chosen = HashMap::new();
        let known = graph.len();
        for id in graph.reachable([energy]) {
            let bodies = self.bodies_of(graph.loops_of(id));
            let ([by], Node::Parameter(_) | Node::FromIndex(_)) = (&bodies[..], graph.node(id)) else { continue };
            let at = usize::from(*by == self.pair[1]);
            let other = self.pair[1 - at];
            let renamed = rename(graph, id, Renaming::one(*by, other), parameters)?;
            let mut both = [id, renamed];
            if let Some(end) = self.ends[at].filter(|_| renamed.position() >= known) {
                for (node, by) in both.iter_mut().zip([*by, other]) {
                    *node = without(graph, *node, by, end, parameters)?;
                }
            }
            chosen.insert(id, graph.select(self.holds, both[0], both[1]));
        }
        Some(chosen)
    }

    /// The bodies of the pair whose indices are among these loops.
    fn bodies_of(&self, loops: LoopSet) -> Vec<LoopId> {
        self.pair.into_iter().filter(|by| loops.contains(*by)).collect()
    }

    /// Multiplies displacements by the sign of the order.
    fn sign_displacements(&self, graph: &mut Graph, energy: NodeId) -> NodeId {
        let mut replaced = HashMap::new();
        for id in graph.reachable([energy]) {
            let Node::Coordinate(element @ Element { part: Part::Position, .. }) = graph.node(id) else { continue };
            let [first, second] = self.pair.map(|by| {
                let index = graph.loops.intern(Index::Running(by));
                graph.coordinate(Element { index, ..element })
            });
            for (a, b) in [(first, second), (second, first)] {
                let displacement = graph.sub(a, b);
                let signed = graph.mul(self.sign, displacement);
                replaced.insert(displacement, signed);
            }
        }
        rewritten(graph, energy, |_, id| replaced.get(&id).copied())
    }
}

/// The ends at which the bodies of a pair have no partner, by the order of the loops; none if each pair comes twice.
pub(super) fn ends(ascending: Option<bool>) -> [Option<End>; 2] {
    match ascending {
        Some(true) => [Some(End::Last), Some(End::First)],
        Some(false) => [Some(End::First), Some(End::Last)],
        None => [None; 2],
    }
}

/// A constant of a body that is zero at one end of the list.
fn without(graph: &mut Graph, id: NodeId, by: LoopId, end: End, parameters: &mut dyn Parameters) -> Option<NodeId> {
    let (parameter, is_integer) = match graph.node(id) {
        Node::Parameter(parameter) => (parameter, false),
        Node::FromIndex(index) => match graph.loops.index(index) {
            Index::Parameter(parameter) => (parameter, true),
            _ => return Some(id),
        },
        _ => return None,
    };
    let guarded = parameters.without(graph, parameter, is_integer, by, end)?;
    Some(graph.parameter(guarded))
}

/// Replaces constants of an energy by selections.
fn choose(graph: &mut Graph, energy: NodeId, constants: Constants, chosen: &HashMap<NodeId, NodeId>) -> NodeId {
    match constants {
        Constants::All => rewritten(graph, energy, |_, id| chosen.get(&id).copied()),
        some => rewritten(graph, energy, |graph, id| {
            let of = |graph: &mut Graph, side| rewritten(graph, side, |_, id| chosen.get(&id).copied());
            match graph.node(id) {
                Node::Compare(comparison, a, b) if graph.is_prepared(id) && some != Constants::InEntries => {
                    let [a, b] = [of(graph, a), of(graph, b)];
                    Some(graph.compare(comparison, a, b))
                }
                Node::Entry(table, row, column) if some != Constants::InConditions && !graph.is_symmetric(table) => {
                    let [row, column] = [of(graph, row), of(graph, column)];
                    Some(graph.rebuilt(Node::Entry(table, row, column)))
                }
                _ => None,
            }
        }),
    }
}

/// Replaces conditions on the indices of the bodies of a pair, and on integers computed from them, by conditions on real numbers.
///
/// Parameters of both bodies become entries of tables. Returns `None` if
/// - an integer of both bodies is not a sum, difference or product,
/// - another integer contains a difference, which may be negative for a body without a partner,
/// - a parameter of both bodies depends on more than a value of each.
pub(super) fn with_numbers(
    graph: &mut Graph,
    energy: NodeId,
    pair: [LoopId; 2],
    ends: [Option<End>; 2],
    parameters: &mut dyn Parameters,
) -> Option<NodeId> {
    let mut fits = true;
    let energy = rewritten(graph, energy, |graph, id| {
        let of_pair = |graph: &Graph, index| {
            let loops = graph.loops.of_index(index);
            pair.into_iter().filter(|by| loops.contains(*by)).count()
        };
        // In loops that visit pairs twice, a difference is negative for half of them, and the user's text stops there.
        let is_difference = |graph: &Graph, index| {
            ends[0].is_none() && matches!(graph.loops.index(index), Index::Sub(..)) && of_pair(graph, index) == 2
        };
        let found = match graph.node(id) {
            Node::Select(..) if graph.is_prepared(id) && pair.iter().all(|by| graph.loops_of(id).contains(*by)) => {
                return parameters.choice(graph, id, pair, ends);
            }
            Node::CompareIndex(_, a, b) if is_difference(graph, a) || is_difference(graph, b) => None,
            Node::FromIndex(index) if is_difference(graph, index) => None,
            Node::CompareIndex(comparison, a, b) if of_pair(graph, a) + of_pair(graph, b) > 0 => {
                let [a, b] = [a, b].map(|index| number(graph, index, pair));
                a.zip(b).map(|(a, b)| graph.compare(comparison, a, b))
            }
            Node::FromIndex(index) if of_pair(graph, index) > 0 => number(graph, index, pair),
            Node::Flag(flag) if pair.iter().any(|by| graph.loops.of_parameter(flag).contains(*by)) => {
                parameters.flag(graph, flag, pair, ends)
            }
            Node::Parameter(parameter) if is_of_both(graph, parameter, pair) => {
                parameters.entry(graph, parameter, pair, ends)
            }
            _ => return None,
        };
        fits &= found.is_some();
        found
    });
    fits.then_some(energy)
}

/// Replaces parameters of both bodies of a pair by functions of one number per body, so that a run prepares numbers of bodies
/// instead of numbers of pairs. Energies of bodies with themselves have none, so nothing changes where the loops visit these.
pub(crate) fn with_numbers_of_each(
    graph: &mut Graph,
    energy: NodeId,
    Visited { pair, ascending }: Visited,
    parameters: &mut dyn Parameters,
) -> NodeId {
    let reachable = graph.reachable([energy]);
    let meets_itself = |id: NodeId| match graph.node(id) {
        Node::Sum(other, body) => other == pair[1] && addend_of_distinct_pair(graph, pair, body).is_none(),
        _ => false,
    };
    if ascending.is_none() && reachable.into_iter().any(meets_itself) {
        return energy;
    }
    let ends = ends(ascending);
    rewritten(graph, energy, |graph, id| match graph.node(id) {
        Node::Flag(flag) if is_of_both(graph, flag, pair) => parameters.flag(graph, flag, pair, ends),
        Node::Parameter(parameter) if is_of_both(graph, parameter, pair) => {
            parameters.entry(graph, parameter, pair, ends)
        }
        _ => None,
    })
}

fn is_of_both(graph: &Graph, parameter: ParameterId, pair: [LoopId; 2]) -> bool {
    pair.iter().all(|by| graph.loops.of_parameter(parameter).contains(*by))
}

/// An integer as a real number. Integers inside of it depend on one body of the pair at most, and contain no difference.
fn number(graph: &mut Graph, index: IndexId, pair: [LoopId; 2]) -> Option<NodeId> {
    let loops = graph.loops.of_index(index);
    let both = |graph: &mut Graph, a, b| Some([number(graph, a, pair)?, number(graph, b, pair)?]);
    match graph.loops.index(index) {
        Index::Add(a, b) => both(graph, a, b).map(|[a, b]| graph.add(a, b)),
        Index::Sub(a, b) | Index::Minus(a, b) => both(graph, a, b).map(|[a, b]| graph.sub(a, b)),
        Index::Mul(a, b) => both(graph, a, b).map(|[a, b]| graph.mul(a, b)),
        Index::Typed(_, a) => number(graph, a, pair),
        _ if pair.iter().all(|by| loops.contains(*by)) => None,
        Index::Parameter(_) => Some(graph.number_of(index)),
        _ => is_total(graph, index).then(|| graph.number_of(index)),
    }
}

/// Whether an integer has a value for every body: it reads no list, and no difference in it may be negative.
fn is_total(graph: &Graph, index: IndexId) -> bool {
    match graph.loops.index(index) {
        Index::Parameter(parameter) => graph.loops.of_parameter(parameter).is_empty(),
        Index::Sub(..) => false,
        Index::Div(a, b) | Index::Rem(a, b) => is_total(graph, a) && graph.loops.literal(b).is_some_and(|by| by > 0),
        index => index.operands().is_none_or(|operands| operands.into_iter().all(|a| is_total(graph, a))),
    }
}

/// Rebuilds a node with the replacements that `replaced` returns for nodes inside of it. Replacements are kept as they are.
pub(crate) fn rewritten(
    graph: &mut Graph,
    root: NodeId,
    mut replaced: impl FnMut(&mut Graph, NodeId) -> Option<NodeId>,
) -> NodeId {
    let mut new: HashMap<NodeId, NodeId> = HashMap::new();
    for id in graph.reachable([root]) {
        let node = match replaced(graph, id) {
            Some(node) => node,
            None => {
                let node = graph.node(id);
                let of = |id: NodeId| new.get(&id).copied().unwrap_or(id);
                let is_zero = |graph: &Graph, id| graph.as_constant(of(id)) == Some(0.0);
                if node.children().all(|child| of(child) == child) {
                    id
                } else {
                    match node {
                        Node::Select(condition, a, b) => graph.select(of(condition), of(a), of(b)),
                        Node::And(a, b) => graph.and(of(a), of(b)),
                        Node::Or(a, b) => graph.or(of(a), of(b)),
                        Node::Not(a) => graph.not(of(a)),
                        // A term or a factor may have become zero.
                        Node::Add(a, b) if is_zero(graph, a) || is_zero(graph, b) => graph.add(of(a), of(b)),
                        Node::Mul(a, b) if is_zero(graph, a) || is_zero(graph, b) => graph.mul(of(a), of(b)),
                        Node::Neg(a) if is_zero(graph, a) => graph.neg(of(a)),
                        _ => graph.rebuilt(node.map(of)),
                    }
                }
            }
        };
        new.insert(id, node);
    }
    new[&root]
}
