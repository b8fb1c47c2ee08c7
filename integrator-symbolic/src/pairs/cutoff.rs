//! Cutoffs: distances beyond which a pair contributes nothing, found in the branches of its energy.
//!
//! Proved property: the energy is a sum in which every term is in a branch `square < c`. Here `square` is at least the squared
//! distance of the two bodies, or of the nearest image in a box, and `c` is at most the square of the cutoff, which is the same
//! for all pairs. The energy and its gradient are hence zero for pairs further apart, for any term.

use super::{
    extremes::Extremes,
    shifted::{Shifted, sides_in},
};
use crate::{
    differentiate::Contribution,
    graph::{
        Comparison, Element, Graph, Node, NodeId, Part, Scope,
        index::{Index, LoopId},
        rename::{End, Parameters},
    },
    reason::Reason,
};
use std::collections::HashMap;

/// The distance beyond which the bodies of a pair do not act on each other.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Cutoff {
    /// The square of the distance.
    pub(crate) square: NodeId,
    /// The sides of the box, in the shape of a gradient by the coordinates of a body; none along an axis without an end.
    pub(crate) sides: Vec<Contribution>,
}

impl Cutoff {
    /// The larger one of two cutoffs; `None` if they are in different boxes.
    pub(super) fn or_larger(self, graph: &mut Graph, other: Self) -> Option<Self> {
        match self.sides == other.sides {
            _ if self == other => Some(self),
            true => Some(Self { square: graph.call_two("max", self.square, other.square), sides: self.sides }),
            false => None,
        }
    }
}

/// The cutoff of the energy of a pair with this number of coordinates each; `bodies` is the loop over all bodies, and `ends`
/// are the ends at which the bodies of a pair have no partner.
pub(crate) fn cutoff(
    graph: &mut Graph,
    energy: NodeId,
    (pair, ends): ([LoopId; 2], [Option<End>; 2]),
    bodies: LoopId,
    dimension: u64,
    parameters: &mut dyn Parameters,
) -> Result<Cutoff, Reason> {
    let extremes = Extremes { pair, ends, parameters, known: HashMap::new() };
    let mut distances = Distances { bodies, dimension, extremes, known: HashMap::new(), obstacle: Reason::NoCutoff };
    distances.of_energy(graph, energy).flatten().ok_or(distances.obstacle)
}

/// What distances are made of.
struct Distances<'p> {
    bodies: LoopId,
    dimension: u64,
    extremes: Extremes<'p>,
    /// Results of `of_energy`: terms may share others.
    known: HashMap<NodeId, Option<Option<Cutoff>>>,
    /// The most specific obstacle so far.
    obstacle: Reason,
}

/// The component of a distance along an axis: a number, or the index of a loop over all axes; and the side of the box.
type Axis = (Option<Index>, Option<NodeId>);

impl Distances<'_> {
    /// The cutoff of an energy, `None` inside if it is zero everywhere; `None` if some of it has no cutoff.
    fn of_energy(&mut self, graph: &mut Graph, id: NodeId) -> Option<Option<Cutoff>> {
        if let Some(known) = self.known.get(&id) {
            return known.clone();
        }
        let found = self.of_operation(graph, id);
        self.known.insert(id, found.clone());
        found
    }

    fn of_operation(&mut self, graph: &mut Graph, id: NodeId) -> Option<Option<Cutoff>> {
        match graph.node(id) {
            Node::Constant(_) => (graph.as_constant(id) == Some(0.0)).then_some(None),
            Node::Neg(a) => self.of_energy(graph, a),
            Node::Power(a, 1..) => self.of_energy(graph, a),
            Node::Mul(a, b) => match self.of_energy(graph, a) {
                None => self.of_energy(graph, b),
                found => found,
            },
            // Zero times what is prepared is zero: prepared constants are finite.
            Node::Div(a, b) if graph.is_prepared(b) => self.of_energy(graph, a),
            Node::Add(a, b) => {
                // Both, so that an obstacle of the second one is noted.
                let [a, b] = [a, b].map(|term| self.of_energy(graph, term));
                self.larger(graph, [a?, b?])
            }
            Node::Select(condition, a, b) => {
                let mut both = [None, None];
                for ((side, holds), cutoff) in [(a, true), (b, false)].into_iter().zip(&mut both) {
                    // Zero, or beyond the condition, or beyond a cutoff of its own.
                    let known = self.obstacle;
                    *cutoff = match graph.as_constant(side) {
                        Some(0.0) => None,
                        _ => match self.of_condition(graph, condition, holds) {
                            Some(cutoff) => {
                                // Another condition beside it is no obstacle, but another term may be one.
                                self.obstacle = known.max(Reason::CutoffOfTerm);
                                Some(cutoff)
                            }
                            None => self.of_energy(graph, side)?,
                        },
                    };
                }
                self.larger(graph, both)
            }
            Node::Binary(function, a, b) if function.name() == "max" => {
                match [a, b].map(|side| graph.as_constant(side)) {
                    [_, Some(0.0)] => Some(Some(self.of_positive(graph, a)?)),
                    [Some(0.0), _] => Some(Some(self.of_positive(graph, b)?)),
                    _ => None,
                }
            }
            _ => None,
        }
    }

    /// The larger one of two cutoffs in the same box.
    fn larger(&mut self, graph: &mut Graph, both: [Option<Cutoff>; 2]) -> Option<Option<Cutoff>> {
        Some(match both {
            [Some(a), Some(b)] => match a.or_larger(graph, b) {
                None => return self.refuse(Reason::CutoffBoxes),
                larger => larger,
            },
            [a, b] => a.or(b),
        })
    }

    /// The cutoff beyond which a number is not positive: a constant less a multiple of a distance, or of its square.
    fn of_positive(&mut self, graph: &mut Graph, id: NodeId) -> Option<Cutoff> {
        let Node::Add(a, b) = graph.node(id) else { return None };
        let (constant, term) = match [a, b].map(|term| graph.is_prepared(term)) {
            [true, false] => (a, b),
            [false, true] => (b, a),
            _ => return None,
        };
        let (mut distance, mut factor) = (graph.neg(term), graph.constant(1.0));
        loop {
            (distance, factor) = match graph.node(distance) {
                Node::Neg(a) => (a, graph.neg(factor)),
                Node::Mul(a, b) if graph.is_prepared(a) => (b, graph.mul(factor, a)),
                Node::Mul(a, b) if graph.is_prepared(b) => (a, graph.mul(factor, b)),
                Node::Div(a, b) if graph.is_prepared(b) => (a, graph.div(factor, b)),
                _ => break,
            }
        }
        let (bound, zero) = (graph.div(constant, factor), graph.constant(0.0));
        let Cutoff { square, sides } = self.of_bound(graph, distance, bound)?;
        // With another sign, it grows with the distance.
        let Some([least, _]) = self.extremes.of(graph, factor) else { return self.refuse(Reason::CutoffOfPair) };
        let (falls, everywhere) = (graph.compare(Comparison::Less, zero, least), graph.constant(f64::INFINITY));
        Some(Cutoff { square: graph.select(falls, square, everywhere), sides })
    }

    /// The cutoff of a branch that is taken if a condition is true, or if it is false.
    fn of_condition(&mut self, graph: &mut Graph, condition: NodeId, holds: bool) -> Option<Cutoff> {
        match (graph.node(condition), holds) {
            (Node::Not(inner), _) => self.of_condition(graph, inner, !holds),
            (Node::And(a, b), true) | (Node::Or(a, b), false) => {
                self.of_condition(graph, a, holds).or_else(|| self.of_condition(graph, b, holds))
            }
            (Node::Compare(Comparison::Less | Comparison::LessOrEqual, a, b), true) => self.of_bound(graph, a, b),
            // The condition is false for a bound that is not a number.
            (Node::Compare(Comparison::Less | Comparison::LessOrEqual, a, b), false) => {
                match Extremes::may_be_nan(graph, a) {
                    true => self.refuse(Reason::CutoffOfPair),
                    false => self.of_bound(graph, b, a),
                }
            }
            _ => None,
        }
    }

    /// Notes an obstacle, unless a more specific one is known.
    fn refuse<T>(&mut self, reason: Reason) -> Option<T> {
        self.obstacle = self.obstacle.max(reason);
        None
    }

    /// The cutoff of pairs whose distance, or its square, is at most a bound.
    fn of_bound(&mut self, graph: &mut Graph, distance: NodeId, bound: NodeId) -> Option<Cutoff> {
        // A condition on parameters alone is none on the distance.
        if graph.is_prepared(distance) {
            return None;
        }
        if !graph.is_prepared(bound) {
            let square = if let Node::Power(square, 1) = graph.node(distance) { square } else { distance };
            let is_distance = self.axes(graph, square, &mut Vec::new()).is_some();
            return self.refuse(if is_distance { Reason::CutoffMoves } else { Reason::CutoffReads });
        }
        let Some([_, bound]) = self.extremes.of(graph, bound) else { return self.refuse(Reason::CutoffOfPair) };
        let mut axes = Vec::new();
        let square = match graph.node(distance) {
            Node::Power(square, 1) => self.axes(graph, square, &mut axes).map(|()| graph.mul(bound, bound)),
            Node::Unary(function, along) if function.name() == "abs" => {
                self.axis(graph, along, &mut axes).map(|()| graph.mul(bound, bound))
            }
            _ => self.axes(graph, distance, &mut axes).map(|()| bound),
        };
        let Some(square) = square else { return self.refuse(Reason::CutoffReads) };
        let whole = match &axes[..] {
            [(None | Some(Index::Running(_)), _)] => true,
            axes => {
                let has = |axis| axes.iter().any(|(component, _)| *component == Some(Index::Literal(axis)));
                axes.len() as u64 == self.dimension && (0..self.dimension).all(has)
            }
        };
        if !whole {
            return self.refuse(Reason::CutoffAxes);
        }
        let sides = axes.into_iter().filter_map(|(component, side)| Some(self.side(graph, component, side?)));
        Some(Cutoff { square, sides: sides.collect() })
    }

    /// The side of a box in the shape of a component of a gradient.
    fn side(&self, graph: &mut Graph, component: Option<Index>, value: NodeId) -> Contribution {
        let context = match component {
            Some(Index::Running(by)) => vec![Scope::Loop(by)],
            _ => Vec::new(),
        };
        let index = graph.loops.intern(Index::Running(self.bodies));
        let component = component.map(|component| graph.loops.intern(component));
        Contribution { context, element: Element { part: Part::Position, index, component }, value }
    }

    /// The axes whose squares are added up in the square of a distance, where nothing else is but what makes it larger.
    fn axes(&self, graph: &mut Graph, id: NodeId, axes: &mut Vec<Axis>) -> Option<()> {
        match graph.node(id) {
            Node::Add(a, b) => {
                self.axes(graph, a, axes)?;
                self.axes(graph, b, axes)
            }
            Node::Constant(_) => (graph.as_constant(id)? >= 0.0).then_some(()),
            Node::Sum(by, body) => {
                let range = graph.loops.get(by);
                let [from, to] = [range.from, range.to].map(|bound| graph.loops.literal(bound));
                if from != Some(0) || to != Some(self.dimension) {
                    return None;
                }
                let first = axes.len();
                self.axes(graph, body, axes)?;
                let own = axes.get(first..)?;
                (own.len() == 1 && own[0].0 == Some(Index::Running(by))).then_some(())
            }
            Node::Power(x, 4) => self.axis(graph, x, axes),
            Node::Mul(x, y) if x == y => self.axis(graph, x, axes),
            _ => None,
        }
    }

    /// The axis along which a number is the displacement of the bodies, or that of the nearest images.
    fn axis(&self, graph: &mut Graph, id: NodeId, axes: &mut Vec<Axis>) -> Option<()> {
        let reachable = graph.reachable([id]);
        let component = reachable.iter().find_map(|node| match graph.node(*node) {
            Node::Coordinate(element) => Some(element.component),
            _ => None,
        })?;
        let [first, second] = self.extremes.pair.map(|by| {
            let index = graph.loops.intern(Index::Running(by));
            graph.coordinate(Element { part: Part::Position, index, component })
        });
        let both = [graph.sub(first, second), graph.sub(second, first)];
        let axis = component.map(|component| graph.loops.index(component));
        if both.contains(&id) {
            axes.push((axis, None));
            return Some(());
        }
        // The multiple of a side that is added last contains the side itself, which is known before it.
        let mut sides: Vec<NodeId> =
            reachable.into_iter().flat_map(|node| sides_in(graph, node, self.extremes.pair)).collect();
        sides.sort();
        sides.dedup();
        let side = sides.into_iter().rev().find(|side| Shifted::new(graph, *side, both).is_displacement(id))?;
        axes.push((axis, Some(side)));
        Some(())
    }
}
