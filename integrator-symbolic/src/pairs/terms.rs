//! Separates the terms of an energy: terms of pairs of bodies, terms of single bodies, and other terms.

use super::{
    embedded::Embedded,
    exchange::is_symmetric,
    half::Half,
    merged::{in_one_direction, sum},
    order::{ends, with_numbers},
    over_all,
    partners::{Visited, addend_of_distinct_pair, is_before, is_partner},
    reads_only,
    renamed::renamed,
    triplets::{Finder, Triplets},
};
use crate::graph::{
    Graph, Node, NodeId,
    index::{Index, IndexId, LoopId},
    rename::{Parameters, Renaming},
};
use crate::reason::Reason;
use std::collections::HashMap;

/// The addends of an energy, by the loops around them.
pub(super) struct Terms<'p> {
    length: IndexId,
    /// Whether pairs may depend on the order of their bodies. Conditions on indices then become conditions on real numbers.
    are_many: bool,
    parameters: &'p mut dyn Parameters,
    /// The loop over all bodies.
    pub(super) bodies: LoopId,
    /// The conditions around the current term, each with its value in the branch of the term.
    conditions: Vec<(NodeId, bool)>,
    /// Results of `has_partners`.
    partners: HashMap<(LoopId, NodeId), bool>,
    /// The loops over the two bodies of a pair.
    pub(super) pair: Option<[LoopId; 2]>,
    /// Whether the second body of a pair has the larger index; `None` if each pair comes twice.
    pub(super) ascending: Option<bool>,
    /// All loops over the two bodies of a pair.
    pub(super) visited: Vec<Visited>,
    /// The terms of a pair.
    pub(super) pairs: Vec<NodeId>,
    /// The terms of a single body.
    pub(super) alone: Vec<NodeId>,
    /// The terms of a single body that depend on sums over its partners, where there are many bodies.
    pub(super) embedded: Embedded,
    /// The number of coordinates of a body, if sums over triplets are apart from other terms.
    dimension: Option<u64>,
    /// The terms of a body and two others within a cutoff.
    pub(super) triplets: Option<Triplets>,
    /// Why a sum over a body and two others is among other terms.
    pub(super) triplet_obstacle: Option<Reason>,
    /// Other terms.
    pub(super) others: Vec<NodeId>,
    /// Why a sum over partners is among these.
    pub(super) obstacle: Option<Reason>,
}

/// How many of `all` bodies the loops over pairs run over: all, or else a number of the system, which may be smaller.
pub(crate) fn acting(graph: &Graph, energy: NodeId, all: IndexId) -> Result<IndexId, Reason> {
    let found = graph.reachable([energy]).into_iter().filter_map(|id| match graph.node(id) {
        Node::Sum(other, _) => {
            let by = graph.loops.get(other).parent?;
            let [own, to] = [by, other].map(|by| graph.loops.get(by).to);
            let mut counts = [own, to].into_iter().filter(|to| is_number_of_bodies(graph, *to, all));
            counts.find(|to| is_partner(graph, *to, by, other).is_some())
        }
        _ => None,
    });
    let found: Vec<_> = found.collect();
    let reason = if found.is_empty() { Reason::NoPairs } else { Reason::PairCounts };
    the_only(found.into_iter(), all).ok_or(reason)
}

/// How many of `all` bodies the loops of an energy run over.
pub(crate) fn moving(graph: &Graph, energy: NodeId, all: IndexId) -> Option<IndexId> {
    let found = graph.reachable([energy]).into_iter().filter_map(|id| match graph.node(id) {
        Node::Sum(by, _) if graph.loops.get(by).parent.is_none() => Some(graph.loops.get(by).to),
        _ => None,
    });
    the_only(found.filter(|to| is_number_of_bodies(graph, *to, all)), all)
}

fn the_only(found: impl Iterator<Item = IndexId>, all: IndexId) -> Option<IndexId> {
    let found: Vec<_> = found.collect();
    let first = found.first().copied();
    if found.contains(&all) { Some(all) } else { first.filter(|first| found.iter().all(|to| to == first)) }
}

/// Whether an integer is the number of all bodies, a number of the system, or the smaller one of both.
fn is_number_of_bodies(graph: &Graph, to: IndexId, all: IndexId) -> bool {
    let is_parameter = |id| matches!(graph.loops.index(id), Index::Parameter(_)) && graph.loops.of_index(id).is_empty();
    match graph.loops.index(to) {
        Index::Min(a, b) => a == all && is_parameter(b) || b == all && is_parameter(a),
        _ => to == all || is_parameter(to),
    }
}

impl<'p> Terms<'p> {
    pub(super) fn of(
        graph: &mut Graph,
        energy: NodeId,
        length: IndexId,
        (are_many, dimension): (bool, Option<u64>),
        parameters: &'p mut dyn Parameters,
    ) -> Self {
        let (bodies, one) = (over_all(graph, length), graph.constant(1.0));
        let mut terms = Self {
            length,
            are_many,
            parameters,
            bodies,
            conditions: Vec::new(),
            partners: HashMap::new(),
            pair: None,
            ascending: None,
            visited: Vec::new(),
            pairs: Vec::new(),
            alone: Vec::new(),
            embedded: Embedded::default(),
            dimension: dimension.filter(|_| are_many),
            triplets: None,
            triplet_obstacle: None,
            others: Vec::new(),
            obstacle: None,
        };
        terms.collect(graph, energy, one);
        terms
    }

    /// Collects the terms of `factor` times an energy.
    fn collect(&mut self, graph: &mut Graph, id: NodeId, factor: NodeId) {
        if let Node::Sum(by, body) = graph.node(id) {
            let range = graph.loops.get(by);
            // The first body has none before it, so a loop over pairs may leave it out.
            if let (None, Some(first @ (0 | 1))) = (range.parent, graph.loops.literal(range.from))
                && (range.to == self.length || self.is_one_less(graph, range.to))
            {
                let is_short = range.to != self.length;
                return self.collect_of_body(graph, by, (first, is_short), body, factor);
            }
        } else if let Some(parts) = addends(graph, id, factor) {
            return parts.into_iter().for_each(|(term, factor)| self.collect(graph, term, factor));
        }
        let term = graph.mul(factor, id);
        self.others.push(term);
    }

    /// The maximum number of conditions around a sum over partners. The number of branches doubles with each.
    const CONDITIONS: usize = 4;

    /// Collects the terms of the body with the index of `by`, which begins at a number and may leave out the last body.
    fn collect_of_body(&mut self, graph: &mut Graph, by: LoopId, range: (u64, bool), id: NodeId, factor: NodeId) {
        if self.has_partners(graph, by, id) {
            if let Some(parts) = addends(graph, id, factor) {
                return parts
                    .into_iter()
                    .for_each(|(term, factor)| self.collect_of_body(graph, by, range, term, factor));
            }
            if let Node::Select(condition, a, b) = graph.node(id)
                && self.conditions.len() < Self::CONDITIONS
            {
                for (side, holds) in [(a, true), (b, false)] {
                    self.conditions.push((condition, holds));
                    self.collect_of_body(graph, by, range, side, factor);
                    self.conditions.pop();
                }
                return;
            }
        }
        if by == self.bodies
            && let Some(rest) = self.of_triplets(graph, by, id, factor)
        {
            return rest.into_iter().for_each(|rest| self.collect_of_body(graph, by, range, rest, factor));
        }
        if let Some(energy) = self.of_pair(graph, by, range, id, factor) {
            return self.pairs.push(energy);
        }
        let product = graph.mul(factor, id);
        let term = self.where_conditions_hold(graph, product);
        if by == self.bodies && reads_only(graph, term, &[by], self.parameters) {
            return self.alone.push(term);
        }
        let embedded = match by == self.bodies && self.are_many {
            true => self.embedded.push(graph, term, by, self.length, self.parameters),
            false => None,
        };
        if embedded.is_some() {
            return;
        }
        // Terms beside one of densities are apart from it.
        let beside = match self.are_many && self.reads_partners(graph, by, id) {
            true => addends(graph, id, factor),
            false => None,
        };
        if let Some(parts) = beside {
            parts.into_iter().for_each(|(term, factor)| self.collect_of_body(graph, by, range, term, factor));
        } else {
            let sum = graph.sum(by, term);
            self.others.push(sum);
        }
    }

    /// Whether a loop ends one body before the last one, which has no partner after it.
    fn is_one_less(&self, graph: &Graph, to: IndexId) -> bool {
        match graph.loops.index(to) {
            Index::Sub(count, one) | Index::Monus(count, one) => {
                count == self.length && graph.loops.literal(one) == Some(1)
            }
            _ => match (graph.loops.literal(to), graph.loops.literal(self.length)) {
                (Some(to), Some(count)) => to + 1 == count,
                _ => false,
            },
        }
    }

    /// A term that is zero unless the conditions around it have the values of its branch.
    fn where_conditions_hold(&self, graph: &mut Graph, term: NodeId) -> NodeId {
        let zero = graph.constant(0.0);
        self.conditions.iter().rev().fold(term, |term, (condition, holds)| match holds {
            true => graph.select(*condition, term, zero),
            false => graph.select(*condition, zero, term),
        })
    }

    /// Returns the energy of a pair if `factor` times the node is a sum over the partners of a body.
    fn of_pair(
        &mut self,
        graph: &mut Graph,
        by: LoopId,
        (first, is_short): (u64, bool),
        id: NodeId,
        factor: NodeId,
    ) -> Option<NodeId> {
        let Node::Sum(other, body) = graph.node(id) else { return None };
        let twice = is_partner(graph, self.length, by, other)?;
        let before = is_before(graph, by, other);
        if first != 0 && (twice || !before) || is_short && (twice || before) {
            return self.refuse(Reason::Unrecognised);
        }
        let (mut pair, mut body, mut ascending) = ([by, other], body, (!twice).then_some(!before));
        if twice {
            body = match addend_of_distinct_pair(graph, pair, body) {
                None if reads_only(graph, body, &pair, self.parameters) => return self.refuse(Reason::PairWithItself),
                None => return self.refuse(Reason::Unrecognised),
                Some(body) => body,
            };
            if let Some(half) = Half::of(graph, pair, body, self.parameters) {
                self.visited.push(Visited { pair, ascending: half.ascending });
                (pair, body, ascending) = ([by, half.before], half.addend, Some(false));
            }
        }
        let (twice, is_known) = (ascending.is_none(), self.pair.is_none_or(|known| known == pair));
        if !is_known && !self.are_many {
            return self.refuse(Reason::PairCounts);
        }
        let once = graph.mul(factor, body);
        let mut energy = self.with_conditions(graph, once, pair, ascending)?;
        // Of few bodies, energies that are not symmetric are no pairs.
        if twice && (!self.are_many || is_symmetric(graph, energy, pair, self.parameters)?) {
            let two = graph.constant(2.0);
            let both = graph.mul(two, once);
            energy = self.with_conditions(graph, both, pair, ascending)?;
        } else if twice {
            let exchanged = renamed(graph, energy, Renaming::exchange(pair), self.parameters)?;
            let both = [energy, exchanged].map(|energy| in_one_direction(graph, energy, pair, self.parameters));
            energy = sum(graph, both, (pair, [None; 2]), self.parameters);
        }
        self.in_known_loops(graph, energy, pair, ascending)
    }

    /// Adds the triplets in a sum over the partners of a body, and returns that sum without them; `None` if it has none, or if
    /// they are no triplets within a cutoff.
    fn of_triplets(&mut self, graph: &mut Graph, by: LoopId, id: NodeId, factor: NodeId) -> Option<Option<NodeId>> {
        let (Node::Sum(other, body), Some(dimension)) = (graph.node(id), self.dimension) else { return None };
        if graph.loops.get(other).parent != Some(by) {
            return None;
        }
        let (length, parameters) = (self.length, &mut *self.parameters);
        let mut finder = Finder { by, other, length, dimension, parameters };
        if !finder.has_inner_sum(graph, body) {
            return None;
        }
        let parts = finder.parts(graph, body);
        let found = parts.ok_or(Reason::TripletSum).and_then(|parts| {
            let triplets = finder.triplets(graph, &parts, &self.conditions, factor)?;
            let all = match self.triplets.clone() {
                Some(known) => known.with(graph, triplets, finder.parameters)?,
                None => triplets,
            };
            Ok((all, finder.rest(graph, &parts)))
        });
        match found {
            Ok((all, rest)) => {
                self.triplets = Some(all);
                Some(rest)
            }
            Err(reason) => {
                self.triplet_obstacle.get_or_insert(reason);
                None
            }
        }
    }

    /// The energy of a pair where the conditions around it hold, by numbers of each body.
    fn with_conditions(
        &mut self,
        graph: &mut Graph,
        energy: NodeId,
        pair: [LoopId; 2],
        ascending: Option<bool>,
    ) -> Option<NodeId> {
        let mut energy = self.where_conditions_hold(graph, energy);
        if self.are_many {
            let Some(written) = with_numbers(graph, energy, pair, ends(ascending), self.parameters) else {
                return self.refuse(Reason::PairReads);
            };
            energy = written;
        }
        if !reads_only(graph, energy, &pair, self.parameters) {
            let is_method = |id: NodeId| matches!(graph.node(id), Node::External(..));
            let calls = graph.reachable([energy]).into_iter().any(is_method);
            return self.refuse(if calls { Reason::Method } else { Reason::PairReads });
        }
        Some(energy)
    }

    /// The energy of a pair in the loops of those before, which may visit pairs in another order. Loops that visit each pair once
    /// take the place of loops that visit it twice.
    fn in_known_loops(
        &mut self,
        graph: &mut Graph,
        energy: NodeId,
        pair: [LoopId; 2],
        ascending: Option<bool>,
    ) -> Option<NodeId> {
        let known = self.pair.filter(|known| *known != pair);
        let energy = match (known, self.ascending, ascending) {
            (None, ..) => energy,
            (Some(known), None, _) => {
                let renaming = Renaming::both(known, pair);
                for energy in &mut self.pairs {
                    *energy = renamed(graph, *energy, renaming, self.parameters)?;
                }
                energy
            }
            (Some(known), Some(order), _) => {
                let [first, second] = known;
                let to = if ascending.is_none_or(|own| own == order) { known } else { [second, first] };
                renamed(graph, energy, Renaming::both(pair, to), self.parameters)?
            }
        };
        if known.is_none() || self.ascending.is_none() {
            (self.pair, self.ascending) = (Some(pair), ascending);
        }
        let visited = Visited { pair, ascending };
        if !self.visited.contains(&visited) {
            self.visited.push(visited);
        }
        Some(energy)
    }

    /// Whether a node reads a sum over partners.
    fn reads_partners(&self, graph: &Graph, by: LoopId, id: NodeId) -> bool {
        let is_over_partners = |id: NodeId| match graph.node(id) {
            Node::Sum(other, _) => is_partner(graph, self.length, by, other).is_some(),
            _ => false,
        };
        graph.reachable([id]).into_iter().any(is_over_partners)
    }

    /// Notes the first obstacle.
    fn refuse(&mut self, reason: Reason) -> Option<NodeId> {
        self.obstacle.get_or_insert(reason);
        None
    }

    /// Whether a sum over partners is among the parts of a node.
    fn has_partners(&mut self, graph: &Graph, by: LoopId, id: NodeId) -> bool {
        if let Some(known) = self.partners.get(&(by, id)) {
            return *known;
        }
        let found = match graph.node(id) {
            Node::Sum(other, _) => is_partner(graph, self.length, by, other).is_some(),
            Node::Neg(a) => self.has_partners(graph, by, a),
            Node::Add(a, b) => self.has_partners(graph, by, a) || self.has_partners(graph, by, b),
            Node::Mul(a, b) if graph.is_prepared(a) => self.has_partners(graph, by, b),
            Node::Div(a, b) if graph.is_prepared(b) => self.has_partners(graph, by, a),
            Node::Select(condition, a, b) if self.are_many && graph.is_prepared(condition) => {
                self.has_partners(graph, by, a) || self.has_partners(graph, by, b)
            }
            _ => false,
        };
        self.partners.insert((by, id), found);
        found
    }
}

/// The addends of `factor` times a node, each with its own factor; `None` if the node is neither a sum nor a multiple.
pub(super) fn addends(graph: &mut Graph, id: NodeId, factor: NodeId) -> Option<Vec<(NodeId, NodeId)>> {
    Some(match graph.node(id) {
        Node::Add(a, b) => vec![(a, factor), (b, factor)],
        Node::Neg(a) => vec![(a, graph.neg(factor))],
        Node::Mul(a, b) if graph.is_prepared(a) => vec![(b, graph.mul(factor, a))],
        Node::Div(a, b) if graph.is_prepared(b) => vec![(a, graph.div(factor, b))],
        _ => return None,
    })
}
