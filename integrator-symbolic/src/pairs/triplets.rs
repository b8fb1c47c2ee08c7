//! Sums over triplets: terms of a body and two others within a cutoff of it, such as the angles of Stillinger and Weber (1985).
//!
//! In: a term of a body that is a sum over its partners, which contains sums over other partners. Out: the energy of a body and two
//! others, the first with the smaller index, and what is left of the term. Always true: each three bodies with an energy come once, the
//! energy reads displacements only, and is zero unless both others are within the cutoff of the body.

use super::{
    cutoff::{Cutoff, cutoff},
    exchange::Forms,
    order::{rewritten, with_numbers},
    partners::in_order,
    reads_only,
    renamed::renamed,
    terms::addends,
};
use crate::{
    graph::{
        Comparison, Graph, Node, NodeId, Part,
        index::{Index, IndexId, Loop, LoopId},
        rename::{Parameters, Renaming},
    },
    reason::Reason,
};
use std::cmp::Ordering;

/// The energies of triplets.
#[derive(Clone)]
pub(crate) struct Triplets {
    /// The loops over the body in the middle and over both others.
    pub(crate) bodies: [LoopId; 3],
    /// The energy of a triplet.
    pub(crate) energy: NodeId,
    /// The distance from the body in the middle beyond which another body is in no triplet.
    pub(crate) cutoff: Cutoff,
}

/// The bodies that a loop runs over.
#[derive(Clone, Copy, PartialEq)]
enum Range {
    All,
    Before(LoopId),
    After(LoopId),
}

impl Range {
    fn of(graph: &Graph, by: LoopId, length: IndexId) -> Option<Self> {
        let Loop { from, to, .. } = graph.loops.get(by);
        match (graph.loops.index(from), graph.loops.index(to)) {
            (Index::Literal(0), _) if to == length => Some(Self::All),
            (Index::Literal(0), Index::Running(other)) => Some(Self::Before(other)),
            (Index::Add(a, b), _) if to == length && graph.loops.literal(b) == Some(1) => match graph.loops.index(a) {
                Index::Running(other) => Some(Self::After(other)),
                _ => None,
            },
            _ => None,
        }
    }

    /// Whether the body with the index of a loop may be among them.
    fn may_meet(self, other: LoopId) -> bool {
        !matches!(self, Self::Before(bound) | Self::After(bound) if bound == other)
    }
}

/// What loops over triplets are made of.
pub(super) struct Finder<'f> {
    /// The loop over the body in the middle, and over its partners.
    pub(super) by: LoopId,
    pub(super) other: LoopId,
    /// The number of bodies, and of the coordinates of each.
    pub(super) length: IndexId,
    pub(super) dimension: u64,
    pub(super) parameters: &'f mut dyn Parameters,
}

/// The parts of a sum over partners.
#[derive(Default)]
pub(super) struct Parts {
    /// The terms without an inner sum over bodies.
    pairs: Vec<NodeId>,
    /// The loops of the inner sums, each with its term.
    triplets: Vec<(LoopId, NodeId)>,
}

impl Finder<'_> {
    /// The maximum number of conditions around an inner sum. The number of branches doubles with each.
    const CONDITIONS: usize = 8;

    /// Whether a node has a sum over further bodies.
    pub(super) fn has_inner_sum(&self, graph: &Graph, id: NodeId) -> bool {
        graph.reachable([id]).into_iter().any(|id| match graph.node(id) {
            Node::Sum(by, _) => self.is_inner(graph, by),
            _ => false,
        })
    }

    fn is_inner(&self, graph: &Graph, by: LoopId) -> bool {
        graph.loops.get(by).parent == Some(self.other) && Range::of(graph, by, self.length).is_some()
    }

    /// Separates the terms of a sum over partners; `None` if an inner sum is inside of another function.
    pub(super) fn parts(&self, graph: &mut Graph, body: NodeId) -> Option<Parts> {
        let (mut parts, mut around, one) = (Parts::default(), Vec::new(), graph.constant(1.0));
        self.separate(graph, body, one, &mut around, &mut parts)?;
        Some(parts)
    }

    fn separate(
        &self,
        graph: &mut Graph,
        id: NodeId,
        factor: NodeId,
        around: &mut Vec<(NodeId, bool)>,
        parts: &mut Parts,
    ) -> Option<()> {
        if !self.has_inner_sum(graph, id) {
            let term = graph.mul(factor, id);
            let term = under(graph, around, term);
            if graph.as_constant(term) != Some(0.0) {
                parts.pairs.push(term);
            }
            return Some(());
        }
        match graph.node(id) {
            Node::Sum(by, body) if self.is_inner(graph, by) => {
                let term = graph.mul(factor, body);
                parts.triplets.push((by, under(graph, around, term)));
                Some(())
            }
            Node::Select(condition, a, b) if around.len() < Self::CONDITIONS => {
                if self.has_inner_sum(graph, condition) {
                    return None;
                }
                for (side, holds) in [(a, true), (b, false)] {
                    around.push((condition, holds));
                    let separate = self.separate(graph, side, factor, around, parts);
                    around.pop();
                    separate?;
                }
                Some(())
            }
            _ => {
                let all = addends(graph, id, factor)?;
                all.into_iter().try_for_each(|(term, factor)| self.separate(graph, term, factor, around, parts))
            }
        }
    }

    /// The triplets of the inner sums under conditions on the body in the middle.
    pub(super) fn triplets(
        &mut self,
        graph: &mut Graph,
        parts: &Parts,
        conditions: &[(NodeId, bool)],
        factor: NodeId,
    ) -> Result<Triplets, Reason> {
        let mut all: Option<Triplets> = None;
        for (third, term) in &parts.triplets {
            let term = graph.mul(factor, *term);
            let term = under(graph, conditions, term);
            let triplets = self.of_inner(graph, *third, term)?;
            all = Some(match all {
                None => triplets,
                Some(known) => known.with(graph, triplets, self.parameters)?,
            });
        }
        all.ok_or(Reason::Unrecognised)
    }

    /// The sum over partners without the inner sums.
    pub(super) fn rest(&self, graph: &mut Graph, parts: &Parts) -> Option<NodeId> {
        let rest = parts.pairs.iter().copied().reduce(|sum, term| graph.add(sum, term))?;
        Some(graph.sum(self.other, rest))
    }

    /// The triplets of an inner sum.
    fn of_inner(&mut self, graph: &mut Graph, third: LoopId, term: NodeId) -> Result<Triplets, Reason> {
        let [i, j, k] = [self.by, self.other, third];
        let bodies = [i, j, k];
        let [of_j, of_k] = [j, k].map(|by| Range::of(graph, by, self.length));
        let (of_j, of_k) = of_j.zip(of_k).ok_or(Reason::Unrecognised)?;
        let mut energy = term;
        // Loops over those after others that are after a body leave out that body.
        let is_beyond = matches!(
            (of_j, of_k),
            (Range::After(first), Range::After(second)) | (Range::Before(first), Range::Before(second))
                if first == i && second == j
        );
        let of_middle = of_k.may_meet(i) && !is_beyond;
        for (pair, may_meet) in [([i, j], of_j.may_meet(i)), ([i, k], of_middle), ([j, k], of_k.may_meet(j))] {
            if may_meet {
                let itself = in_order(graph, energy, pair, Some(Ordering::Equal));
                if graph.as_constant(itself) != Some(0.0) {
                    return Err(Reason::TripletWithItself);
                }
            }
            energy = in_order(graph, energy, pair, None);
        }
        let zero = graph.constant(0.0);
        for (by, range) in [(j, of_j), (k, of_k)] {
            let [own, middle] = [by, i].map(|by| graph.loops.intern(Index::Running(by)));
            let condition = match range {
                Range::Before(bound) if bound == i => graph.compare_index(Comparison::Less, own, middle),
                Range::After(bound) if bound == i => graph.compare_index(Comparison::Less, middle, own),
                _ => continue,
            };
            energy = graph.select(condition, energy, zero);
        }
        // Loops that visit two others in both orders have two terms for each.
        let [above, below] = [of_k != Range::Before(j), of_k != Range::After(j)];
        let mut terms = Vec::new();
        if above {
            let term = in_order(graph, energy, [j, k], Some(Ordering::Less));
            terms.push(self.of_each(graph, term, bodies)?);
        }
        if below {
            let term = in_order(graph, energy, [j, k], Some(Ordering::Greater));
            let term = self.of_each(graph, term, bodies)?;
            let exchanged = renamed(graph, term, Renaming::exchange([j, k]), self.parameters);
            terms.push(exchanged.ok_or(Reason::TripletReads)?);
        }
        terms.retain(|term| graph.as_constant(*term) != Some(0.0));
        let energy = match terms[..] {
            [a, b] => {
                let mut forms = Forms::new([j, k], None, self.parameters);
                let [form, other] = [a, b].map(|term| forms.of(graph, term, false));
                if form.is_some() && form == other {
                    let two = graph.constant(2.0);
                    graph.mul(two, a)
                } else {
                    graph.add(a, b)
                }
            }
            [one] => one,
            _ => return Err(Reason::Unrecognised),
        };
        if !reads_only(graph, energy, &bodies, self.parameters) || has_sum(graph, energy) {
            return Err(Reason::TripletReads);
        }
        if !reads_displacements(graph, energy, bodies) {
            return Err(Reason::TripletPlaces);
        }
        let mut legs = [j, k].map(|other| {
            let pair = ([i, other], [None; 2]);
            cutoff(graph, energy, pair, i, self.dimension, self.parameters).map_err(|_| Reason::TripletCutoff)
        });
        legs.sort_by_key(Result::is_ok);
        let [first, second] = legs;
        Ok(Triplets { bodies, energy, cutoff: first?.or_larger(graph, second?).ok_or(Reason::CutoffBoxes)? })
    }

    /// The term with numbers of each body and entries of tables in place of other prepared numbers.
    fn of_each(&mut self, graph: &mut Graph, term: NodeId, bodies: [LoopId; 3]) -> Result<NodeId, Reason> {
        let [i, j, k] = bodies;
        let term = rewritten(graph, term, |graph, id| match graph.node(id) {
            Node::Parameter(parameter) => {
                let inner = self.parameters.of_distinct(graph, parameter, bodies);
                (inner != parameter).then(|| graph.parameter(inner))
            }
            _ => None,
        });
        [[i, j], [i, k], [j, k]].into_iter().try_fold(term, |term, pair| {
            with_numbers(graph, term, pair, [None; 2], self.parameters).ok_or(Reason::TripletReads)
        })
    }
}

impl Triplets {
    /// Adds the energy of other triplets.
    pub(super) fn with(self, graph: &mut Graph, other: Self, parameters: &mut dyn Parameters) -> Result<Self, Reason> {
        let ([_, j, k], [_, first, second]) = (self.bodies, other.bodies);
        let renaming = Renaming::both([first, second], [j, k]);
        let energy = renamed(graph, other.energy, renaming, parameters).ok_or(Reason::TripletReads)?;
        let energy = graph.add(self.energy, energy);
        let cutoff = self.cutoff.or_larger(graph, other.cutoff).ok_or(Reason::CutoffBoxes)?;
        Ok(Self { energy, cutoff, ..self })
    }
}

/// A term that is zero unless conditions have their values.
fn under(graph: &mut Graph, conditions: &[(NodeId, bool)], term: NodeId) -> NodeId {
    let zero = graph.constant(0.0);
    conditions.iter().rev().fold(term, |term, (condition, holds)| match holds {
        true => graph.select(*condition, term, zero),
        false => graph.select(*condition, zero, term),
    })
}

fn has_sum(graph: &Graph, energy: NodeId) -> bool {
    graph.reachable([energy]).into_iter().any(|id| matches!(graph.node(id), Node::Sum(..) | Node::Fold(..)))
}

/// Whether an energy reads positions as differences of those of two bodies only.
fn reads_displacements(graph: &mut Graph, energy: NodeId, [i, j, k]: [LoopId; 3]) -> bool {
    let mut displacements = Vec::new();
    for id in graph.reachable([energy]) {
        let Node::Coordinate(element) = graph.node(id) else { continue };
        for [a, b] in [[i, j], [i, k], [j, k]] {
            let [a, b] = [a, b].map(|by| {
                let index = graph.loops.intern(Index::Running(by));
                graph.coordinate(crate::graph::Element { index, part: Part::Position, ..element })
            });
            displacements.extend([graph.sub(a, b), graph.sub(b, a)]);
        }
    }
    let (mut open, mut seen) = (vec![energy], vec![false; graph.len()]);
    while let Some(id) = open.pop() {
        if displacements.contains(&id) || std::mem::replace(&mut seen[id.position()], true) {
            continue;
        }
        if matches!(graph.node(id), Node::Coordinate(_)) {
            return false;
        }
        open.extend(graph.node(id).children());
    }
    true
}
