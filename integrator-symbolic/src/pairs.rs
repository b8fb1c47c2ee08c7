//! Pair potentials: their recognition, and the force of one body on another.
//!
//! In: a potential. Out: the gradient of one pair's energy and of the one-body terms, or nothing for another kind of
//! potential. Always true: the energy of a pair is symmetric in its bodies, so an executor may process the pairs in any
//! order and may let either body be the first; a pair reads only the coordinates of its two bodies.

mod attraction;
mod canonical;
mod central;
mod cutoff;
mod exchange;

use crate::{
    differentiate::{Contribution, gradient},
    graph::{
        Comparison, Graph, Node, NodeId, Part,
        index::{Index, IndexId, Loop, LoopId},
        rename::{Parameters, Renaming},
    },
};
pub(crate) use attraction::{attraction, inverse_mass, softening};
pub(crate) use canonical::canonical;
pub(crate) use central::pull;
pub(crate) use cutoff::{Cutoff, cutoff};
use exchange::Forms;

/// A potential of pairs.
pub(crate) struct Pairs {
    /// The loop over all bodies.
    pub(crate) bodies: LoopId,
    /// The loops over the two bodies of a pair.
    pub(crate) pair: [LoopId; 2],
    /// The energy of a pair.
    pub(crate) energy: NodeId,
    /// The gradient of a pair's energy by the coordinates of its first body.
    pub(crate) force: Vec<Contribution>,
    /// Whether the gradient by those of the second body is the same with another sign: action is reaction.
    pub(crate) reciprocal: bool,
    /// The energy of a body alone.
    pub(crate) energy_alone: NodeId,
    /// The gradient of the one-body terms.
    pub(crate) alone: Vec<Contribution>,
}

/// Recognises a potential of pairs among `length` bodies.
pub(crate) fn pairs(
    graph: &mut Graph,
    potential: NodeId,
    length: IndexId,
    parameters: &mut dyn Parameters,
) -> Option<Pairs> {
    let mut terms = Terms { length, pair: None, pairs: Vec::new(), alone: Vec::new() };
    let one = graph.constant(1.0);
    terms.collect(graph, potential, one)?;
    let pair = terms.pair?;
    let bodies = over_all(graph, length);
    let [energy, alone] = [terms.pairs, terms.alone].map(|terms| {
        let zero = graph.constant(0.0);
        terms.into_iter().fold(zero, |sum, term| graph.add(sum, term))
    });
    if !reads_only(graph, energy, &pair, parameters) || !reads_only(graph, alone, &[bodies], parameters) {
        return None;
    }
    let mut forms = Forms::new(pair, parameters);
    if forms.of(graph, energy, false)? != forms.of(graph, energy, true)? {
        return None;
    }
    let gradients = gradient(graph, energy, Part::Position);
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
    Some(Pairs { bodies, pair, energy, force, reciprocal, energy_alone, alone })
}

/// The gradient of a function of positions or of momenta as one-body contributions: without the loop over all bodies,
/// which is around all of them.
pub(crate) fn per_body(
    graph: &mut Graph,
    energy: NodeId,
    length: IndexId,
    part: Part,
    parameters: &mut dyn Parameters,
) -> Option<Vec<Contribution>> {
    let mut terms = Terms { length, pair: None, pairs: Vec::new(), alone: Vec::new() };
    let one = graph.constant(1.0);
    terms.collect(graph, energy, one)?;
    let bodies = over_all(graph, length);
    let zero = graph.constant(0.0);
    let alone = terms.alone.into_iter().fold(zero, |sum, term| graph.add(sum, term));
    let apart = terms.pair.is_none() && reads_only(graph, alone, &[bodies], parameters);
    apart.then(|| gradient(graph, alone, part))
}

/// The loop over all bodies.
fn over_all(graph: &mut Graph, length: IndexId) -> LoopId {
    let from = graph.loops.intern(Index::Literal(0));
    graph.loops.range(Loop { parent: None, from, to: length })
}

/// The addends of an energy, by the loops around them.
struct Terms {
    length: IndexId,
    /// The loops over the two bodies of a pair.
    pair: Option<[LoopId; 2]>,
    /// The addends of a pair.
    pairs: Vec<NodeId>,
    /// The addends of a body.
    alone: Vec<NodeId>,
}

impl Terms {
    /// Collects `factor` times a sum over bodies or pairs, or over several; `None` if something else is in it.
    fn collect(&mut self, graph: &mut Graph, id: NodeId, factor: NodeId) -> Option<()> {
        match graph.node(id) {
            Node::Constant(_) => Some(()),
            Node::Sum(by, body) => {
                let range = graph.loops.get(by);
                if range.parent.is_some() || range.to != self.length {
                    return None;
                }
                match graph.loops.literal(range.from)? {
                    // The first body has none before it, so a loop over pairs may leave it out.
                    first @ (0 | 1) => self.collect_of_body(graph, by, first, body, factor),
                    _ => None,
                }
            }
            _ => {
                for (term, factor) in addends(graph, id, factor)? {
                    self.collect(graph, term, factor)?;
                }
                Some(())
            }
        }
    }

    /// Collects the addends of the body with the index of `by`.
    fn collect_of_body(&mut self, graph: &mut Graph, by: LoopId, first: u64, id: NodeId, factor: NodeId) -> Option<()> {
        if let Node::Sum(other, body) = graph.node(id)
            && let Some(twice) = self.is_partner(graph, by, other)
        {
            let body = if twice { addend_of_distinct_pair(graph, by, other, body)? } else { body };
            if first != 0 && (twice || !self.is_before(graph, by, other)) {
                return None;
            }
            if *self.pair.get_or_insert([by, other]) != [by, other] {
                return None;
            }
            let term = graph.mul(factor, body);
            let two = graph.constant(2.0);
            self.pairs.push(if twice { graph.mul(two, term) } else { term });
            return Some(());
        }
        if let Some(parts) = addends(graph, id, factor).filter(|_| self.has_partners(graph, by, id)) {
            for (term, factor) in parts {
                self.collect_of_body(graph, by, first, term, factor)?;
            }
            return Some(());
        }
        let term = graph.mul(factor, id);
        self.alone.push(term);
        (first == 0).then_some(())
    }

    /// Whether a loop runs over the partners of the body with the index of `by`; `true` if each pair comes twice.
    fn is_partner(&self, graph: &Graph, by: LoopId, other: LoopId) -> Option<bool> {
        let Loop { parent, from, to } = graph.loops.get(other);
        if parent != Some(by) {
            return None;
        }
        if self.is_before(graph, by, other) {
            return Some(false);
        }
        let after = match graph.loops.index(from) {
            Index::Add(a, b) => graph.loops.index(a) == Index::Running(by) && graph.loops.literal(b) == Some(1),
            _ => false,
        };
        let all = graph.loops.literal(from) == Some(0);
        (to == self.length && (after || all)).then_some(all)
    }

    /// Whether a loop runs over the bodies before the one with the index of `by`.
    fn is_before(&self, graph: &Graph, by: LoopId, other: LoopId) -> bool {
        let Loop { from, to, .. } = graph.loops.get(other);
        graph.loops.literal(from) == Some(0) && graph.loops.index(to) == Index::Running(by)
    }

    /// Whether a sum over partners is among the parts of a node.
    fn has_partners(&self, graph: &Graph, by: LoopId, id: NodeId) -> bool {
        match graph.node(id) {
            Node::Sum(other, _) => self.is_partner(graph, by, other).is_some(),
            Node::Neg(a) => self.has_partners(graph, by, a),
            Node::Add(a, b) => self.has_partners(graph, by, a) || self.has_partners(graph, by, b),
            Node::Mul(a, b) if graph.is_prepared(a) => self.has_partners(graph, by, b),
            Node::Div(a, b) if graph.is_prepared(b) => self.has_partners(graph, by, a),
            _ => false,
        }
    }
}

/// The addends of `factor` times a node, each with its own factor; `None` of what is no sum and no multiple.
fn addends(graph: &mut Graph, id: NodeId, factor: NodeId) -> Option<Vec<(NodeId, NodeId)>> {
    Some(match graph.node(id) {
        Node::Add(a, b) => vec![(a, factor), (b, factor)],
        Node::Neg(a) => vec![(a, graph.neg(factor))],
        Node::Mul(a, b) if graph.is_prepared(a) => vec![(b, graph.mul(factor, a))],
        Node::Div(a, b) if graph.is_prepared(b) => vec![(a, graph.div(factor, b))],
        _ => return None,
    })
}

/// The addend where the two indices differ, if nothing is added where they are equal.
fn addend_of_distinct_pair(graph: &Graph, first: LoopId, second: LoopId, body: NodeId) -> Option<NodeId> {
    let Node::Select(condition, same, other) = graph.node(body) else { return None };
    let (condition, same, other) = match graph.node(condition) {
        Node::Not(inner) => (inner, other, same),
        _ => (condition, same, other),
    };
    let Node::CompareIndex(Comparison::Equal, a, b) = graph.node(condition) else { return None };
    let named = [a, b].map(|index| graph.loops.index(index));
    let both = [first, second].map(Index::Running);
    let alike = named == both || named == [both[1], both[0]];
    (alike && graph.as_constant(same) == Some(0.0)).then_some(other)
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
