//! A canonical form for energies of bodies and of their pairs. It is a sum over bodies of their one-body energy and of
//! the pair energy with each body before, with expanded components of points.
//!
//! The terms of an energy are found by its loops: those over bodies, in any order of nesting, and those over
//! components. Only Jacobi coordinates use this form; other layouts use an energy as written.

mod moving;

use super::{addends, exchange::Forms, over_all};
use crate::graph::{
    Comparison, Element, Graph, Node, NodeId,
    index::{Index, IndexId, Loop, LoopId, LoopSet},
    rename::{Parameters, Place},
};
use moving::{Moving, components};

/// The most terms that are looked at.
const MANY: usize = 256;

/// The canonical form of an energy of this number of bodies; `None` of one that is no sum over bodies and pairs.
pub(crate) fn canonical(
    graph: &mut Graph,
    energy: NodeId,
    length: IndexId,
    parameters: &mut dyn Parameters,
) -> Option<NodeId> {
    let mut terms = Vec::new();
    let one = graph.constant(1.0);
    collect(graph, energy, one, &mut Around::default(), &mut terms)?;
    let bodies = over_all(graph, length);
    let [zero, one] = [0, 1].map(|number| graph.loops.intern(Index::Literal(number)));
    let to = graph.loops.intern(Index::Running(bodies));
    let before = graph.loops.range(Loop { parent: Some(bodies), from: zero, to });
    // Names are those of the loops that these take the place of, or new ones.
    parameters.name_if_new(before, bodies);
    Canonical { length, bodies, before, one, parameters }.sum(graph, &terms)
}

/// What stands around a term.
#[derive(Clone, Default)]
struct Around {
    /// The loops, outermost first.
    loops: Vec<LoopId>,
    /// Conditions on the indices of one or two loops, and whether they hold.
    conditions: Vec<(NodeId, bool)>,
}

/// Collects the terms of `factor` times a node: sums of sums, products of sums, and what stands under conditions on indices.
fn collect(
    graph: &mut Graph,
    id: NodeId,
    factor: NodeId,
    around: &mut Around,
    terms: &mut Vec<(Around, NodeId)>,
) -> Option<()> {
    if terms.len() > MANY {
        return None;
    }
    let is_zero = |graph: &Graph, id| graph.as_constant(id) == Some(0.0);
    if is_zero(graph, id) {
        return Some(());
    }
    if let Some(parts) = addends(graph, id, factor) {
        return parts.into_iter().try_for_each(|(part, factor)| collect(graph, part, factor, around, terms));
    }
    if let Some(parts) = distributed(graph, id) {
        return parts.into_iter().try_for_each(|part| collect(graph, part, factor, around, terms));
    }
    if let Some(sum) = graph.guarded_sum(id) {
        return collect(graph, sum, factor, around, terms);
    }
    match graph.node(id) {
        Node::Sum(by, body) => {
            around.loops.push(by);
            collect(graph, body, factor, around, terms)?;
            around.loops.pop();
        }
        Node::Select(condition, a, b) if is_of_indices(graph, condition) => {
            for (side, holds) in [(a, true), (b, false)] {
                around.conditions.push((condition, holds));
                collect(graph, side, factor, around, terms)?;
                around.conditions.pop();
            }
        }
        _ => {
            let value = graph.mul(factor, id);
            terms.push((around.clone(), value));
        }
    }
    Some(())
}

/// The addends of a product or a quotient of a sum; a product of two sums stays.
fn distributed(graph: &mut Graph, id: NodeId) -> Option<[NodeId; 2]> {
    match graph.node(id) {
        Node::Mul(a, b) => match (graph.node(a), graph.node(b)) {
            (Node::Add(..), Node::Add(..)) => None,
            (Node::Add(x, y), _) => Some([x, y].map(|part| graph.mul(part, b))),
            (_, Node::Add(x, y)) => Some([x, y].map(|part| graph.mul(a, part))),
            _ => None,
        },
        Node::Div(a, b) => match graph.node(a) {
            Node::Add(x, y) => Some([x, y].map(|part| graph.div(part, b))),
            _ => None,
        },
        _ => None,
    }
}

/// What a term is of.
#[derive(Clone, Copy)]
enum Of {
    Body,
    Pair,
}

/// Of which bodies or pairs it is.
#[derive(Clone, Copy)]
enum Which {
    All,
    /// The first body, or its pairs.
    First,
    /// The other bodies, or their pairs.
    Later,
}

/// How the second body of a pair comes after or before the first one by the ranges of their loops.
enum Order {
    Before,
    After,
    Any,
}

/// The loops of the form.
struct Canonical<'p> {
    length: IndexId,
    bodies: LoopId,
    before: LoopId,
    /// The number one.
    one: IndexId,
    parameters: &'p mut dyn Parameters,
}

impl Canonical<'_> {
    /// The sum of all terms in the one form.
    fn sum(mut self, graph: &mut Graph, terms: &[(Around, NodeId)]) -> Option<NodeId> {
        let zero = graph.constant(0.0);
        let mut sums = [[zero; 3]; 2];
        for (around, value) in terms {
            let (of, which, values) = self.placed(graph, around, *value)?;
            let sum = &mut sums[of as usize][which as usize];
            *sum = values.into_iter().fold(*sum, |sum, value| graph.add(sum, value));
        }
        let [alone, pairs] = sums;
        let alone = self.of_all(graph, Of::Body, alone)?;
        let pairs = self.of_all(graph, Of::Pair, pairs)?;
        let pairs = graph.sum(self.before, pairs);
        let all = graph.add(alone, pairs);
        Some(graph.sum(self.bodies, all))
    }

    /// The terms of any body, or of any pair: those of the first body, and those of the others, are the same, or each has a factor
    /// that is zero elsewhere.
    fn of_all(&mut self, graph: &mut Graph, of: Of, [all, first, later]: [NodeId; 3]) -> Option<NodeId> {
        let zero = graph.constant(0.0);
        if [first, later] == [zero; 2] {
            return Some(all);
        }
        let (bodies, before) = (self.bodies, self.before);
        let own = match of {
            Of::Body => bodies,
            Of::Pair => before,
        };
        let stays = |by| (by, Place::Loop(by));
        let of_first = vec![stays(bodies), (own, Place::Number(0))];
        let at_first =
            [first, later].map(|value| Moving::new(of_first.clone(), None, self.parameters).value(graph, value));
        let mut forms = Forms::new([bodies, before], None, self.parameters);
        let [Some(a), Some(b)] = at_first.map(|value| forms.of(graph, value?, false)) else { return None };
        if a == b {
            return Some(graph.add(all, later));
        }
        let both = LoopSet::of(bodies).union(LoopSet::of(before));
        let mut behind_first =
            |graph: &mut Graph, value| Moving::behind_first(both, self.parameters).value(graph, value);
        let (first, later) = (behind_first(graph, first)?, behind_first(graph, later)?);
        // The same whichever body of a pair comes first.
        let exchange = vec![(bodies, Place::Loop(before)), (before, Place::Loop(bodies))];
        let exchanged = Moving::new(exchange, None, self.parameters).value(graph, first)?;
        let mut only = |graph: &mut Graph, by, is_first, value| {
            let indicator = self.parameters.indicator(graph, by, is_first)?;
            let indicator = graph.parameter(indicator);
            Some(graph.mul(indicator, value))
        };
        let mut terms = vec![all, only(graph, own, true, first)?];
        let later = only(graph, own, false, later)?;
        match of {
            Of::Body => terms.push(later),
            Of::Pair => terms.extend([only(graph, bodies, true, exchanged)?, only(graph, bodies, false, later)?]),
        }
        Some(terms.into_iter().fold(zero, |sum, term| graph.add(sum, term)))
    }

    /// What a term is of, and its values in the indices of the form, one for each of its components.
    fn placed(&mut self, graph: &mut Graph, around: &Around, value: NodeId) -> Option<(Of, Which, Vec<NodeId>)> {
        let indices = body_indices(graph, value)?;
        let (of_bodies, of_components): (Vec<_>, Vec<_>) =
            around.loops.iter().copied().partition(|by| indices.loops.contains(*by));
        let (on_one, on_two): (Vec<_>, Vec<_>) = around
            .conditions
            .iter()
            .copied()
            .partition(|(condition, _)| graph.loops_of(*condition).iter().count() == 1);
        let own = of_bodies.iter().fold(LoopSet::EMPTY, |set, by| set.union(LoopSet::of(*by)));
        let behind = on_one.into_iter().try_fold(LoopSet::EMPTY, |behind, (condition, holds)| {
            let by = begins_at_one(graph, condition, holds)?;
            by.is_subset(own).then_some(behind.union(by))
        })?;
        let [later, earlier] = [self.bodies, self.before].map(Place::Loop);
        let (of, which, places) = match (&of_bodies[..], &on_two[..]) {
            ([], []) if indices.first => (Of::Body, Which::First, vec![Vec::new()]),
            ([body], []) => {
                let (of, which) = match (self.start_of(graph, *body, behind)?, indices.first) {
                    (0, false) => (Of::Body, Which::All),
                    (_, false) => (Of::Body, Which::Later),
                    (1, true) => (Of::Pair, Which::First),
                    _ => return None,
                };
                (of, which, vec![vec![(*body, later)]])
            }
            ([outer, inner], conditions) if !indices.first => {
                let is_before = vec![(*outer, later), (*inner, earlier)];
                let is_after = vec![(*outer, earlier), (*inner, later)];
                let (order, which) = self.order(graph, *outer, *inner, behind)?;
                let places = match (order, conditions) {
                    (Order::Before, []) => vec![is_before],
                    (Order::After, []) => vec![is_after],
                    (Order::Any, [(condition, holds)]) => {
                        let holds_at = |outer_index: i8, inner_index: i8| {
                            let at = |by| {
                                if by == *outer { Some(outer_index) } else { (by == *inner).then_some(inner_index) }
                            };
                            truth(graph, *condition, &at).map(|truth| truth == *holds)
                        };
                        // Nothing is added for a body with itself.
                        if holds_at(0, 0)? {
                            return None;
                        }
                        let ways = [(holds_at(1, 0)?, is_before), (holds_at(0, 1)?, is_after)];
                        ways.into_iter().filter_map(|(is_added, place)| is_added.then_some(place)).collect()
                    }
                    _ => return None,
                };
                (Of::Pair, which, places)
            }
            _ => return None,
        };
        let first = match (of, which) {
            (Of::Body, Which::First) => Some(self.bodies),
            (Of::Pair, Which::First) => Some(self.before),
            _ => None,
        };
        let places = of_components.into_iter().try_fold(places, |places, by| with_components(graph, &places, by))?;
        let own = LoopSet::of(self.bodies).union(LoopSet::of(self.before));
        let mut moved = |place| Moving::new(place, first, self.parameters).value(graph, value);
        let values = places.into_iter().map(&mut moved).collect::<Option<Vec<_>>>()?;
        values.iter().all(|value| graph.loops_of(*value).is_subset(own)).then_some((of, which, values))
    }

    /// The first body of a loop over all bodies, or over all but the first one.
    fn start_of(&self, graph: &Graph, by: LoopId, behind: LoopSet) -> Option<u64> {
        start(graph, by, behind).filter(|from| *from < 2 && graph.loops.get(by).to == self.length)
    }

    /// How the bodies of a pair are ordered, and which pairs there are.
    fn order(&self, graph: &mut Graph, outer: LoopId, inner: LoopId, behind: LoopSet) -> Option<(Order, Which)> {
        let own = graph.loops.intern(Index::Running(outer));
        let next = graph.loops.intern(Index::Add(own, self.one));
        let (around, partners) = (graph.loops.get(outer), graph.loops.get(inner));
        let from = |which: u64| if which == 0 { Which::All } else { Which::Later };
        let first = start(graph, outer, behind).filter(|first| *first < 2)?;
        let is_whole = around.to == self.length;
        match start(graph, inner, behind) {
            // The first body has none before it.
            Some(start @ (0 | 1)) if is_whole && partners.to == own => Some((Order::Before, from(start))),
            Some(start) if is_whole && partners.to == self.length && start == first => Some((Order::Any, from(start))),
            // The last body has none after it.
            None if partners.from == next
                && partners.to == self.length
                && (is_whole || self.is_last(graph, around.to)) =>
            {
                Some((Order::After, from(first)))
            }
            _ => None,
        }
    }

    /// Whether an index is that of the last body.
    fn is_last(&self, graph: &Graph, index: IndexId) -> bool {
        match (graph.loops.index(index), graph.loops.literal(self.length)) {
            (Index::Monus(a, b) | Index::Sub(a, b) | Index::Minus(a, b), _) => (a, b) == (self.length, self.one),
            (Index::Literal(index), Some(length)) => index + 1 == length,
            _ => false,
        }
    }
}

/// The places of a term, once for each component that the index of a loop is.
fn with_components(graph: &Graph, places: &[Vec<(LoopId, Place)>], by: LoopId) -> Option<Vec<Vec<(LoopId, Place)>>> {
    let values = components(graph, by)?;
    let each = |place: &Vec<(LoopId, Place)>| {
        values.clone().map(|value| [&place[..], &[(by, Place::Number(value))]].concat()).collect::<Vec<_>>()
    };
    Some(places.iter().flat_map(each).collect())
}

/// The first index of a loop, which is one at least where conditions leave out the first body.
fn start(graph: &Graph, by: LoopId, behind: LoopSet) -> Option<u64> {
    let from = graph.loops.literal(graph.loops.get(by).from)?;
    Some(if behind.contains(by) { from.max(1) } else { from })
}

/// The loop whose first index a condition leaves out, if it leaves out any; `None` where it leaves out others.
fn begins_at_one(graph: &Graph, condition: NodeId, holds: bool) -> Option<LoopSet> {
    let holds_at = |index| truth(graph, condition, &|_| Some(index)).map(|truth| truth == holds);
    match [holds_at(0)?, holds_at(1)?, holds_at(2)?] {
        [true, true, true] => Some(LoopSet::EMPTY),
        [false, true, true] => Some(graph.loops_of(condition)),
        _ => None,
    }
}

/// Whether a condition compares the indices of loops, with each other or with the first two numbers, and nothing else.
fn is_of_indices(graph: &Graph, condition: NodeId) -> bool {
    truth(graph, condition, &|_| Some(0)).is_some()
}

/// Whether a condition holds where indices of loops have these values; `None` of one on anything else.
fn truth(graph: &Graph, condition: NodeId, at: &dyn Fn(LoopId) -> Option<i8>) -> Option<bool> {
    match graph.node(condition) {
        Node::Not(inner) => truth(graph, inner, at).map(|truth| !truth),
        Node::CompareIndex(comparison, a, b) => {
            let value = |id| match graph.loops.index(id) {
                Index::Running(by) => at(by),
                Index::Literal(number @ (0 | 1)) => Some(number as i8),
                _ => None,
            };
            let (a, b) = (value(a)?, value(b)?);
            Some(match comparison {
                Comparison::Less => a < b,
                Comparison::LessOrEqual => a <= b,
                Comparison::Equal => a == b,
            })
        }
        _ => None,
    }
}

/// How the coordinates in a value are numbered.
struct BodyIndices {
    /// The loops whose indices are bodies.
    loops: LoopSet,
    /// Whether the first body is read by its number.
    first: bool,
}

/// The indices of bodies in a value; `None` where other bodies are read by their numbers, or by anything but an index.
fn body_indices(graph: &Graph, value: NodeId) -> Option<BodyIndices> {
    let mut found = BodyIndices { loops: LoopSet::EMPTY, first: false };
    for id in graph.reachable([value]) {
        if let Node::Coordinate(Element { index, .. }) = graph.node(id) {
            match graph.loops.index(index) {
                Index::Running(by) => found.loops = found.loops.union(LoopSet::of(by)),
                Index::Literal(0) => found.first = true,
                _ => return None,
            }
        }
    }
    Some(found)
}
