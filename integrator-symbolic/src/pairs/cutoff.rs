//! Cutoffs: distances beyond which a pair contributes nothing, found in the branches of its energy.
//!
//! Proved property: the energy is a sum in which every term is in a branch `square < c`. Here `c` is the same for all
//! pairs, and `square` is at least the squared distance of the two bodies, or of the nearest image in a box. The energy
//! and its gradient are hence zero for pairs further apart, for any term.

use crate::{
    differentiate::Contribution,
    graph::{
        Comparison, Element, Graph, Node, NodeId, Part, Scope,
        index::{Index, LoopId},
    },
};

/// The distance beyond which the bodies of a pair do not act on each other.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Cutoff {
    /// The square of the distance.
    pub(crate) square: NodeId,
    /// The sides of the box, in the shape of a gradient by the coordinates of a body; none along an axis without an end.
    pub(crate) sides: Vec<Contribution>,
}

/// The cutoff of the energy of a pair with this number of coordinates each; `bodies` is the loop over all bodies.
pub(crate) fn cutoff(
    graph: &mut Graph,
    energy: NodeId,
    pair: [LoopId; 2],
    bodies: LoopId,
    dimension: u64,
) -> Option<Cutoff> {
    Distances { pair, bodies, dimension }.of_energy(graph, energy)?
}

/// What distances are made of.
struct Distances {
    pair: [LoopId; 2],
    bodies: LoopId,
    dimension: u64,
}

/// The component of a distance along an axis: a number, or the index of a loop over all axes; and the side of the box.
type Axis = (Option<Index>, Option<NodeId>);

impl Distances {
    /// The cutoff of an energy, `None` inside if it is zero everywhere; `None` if some of it has no cutoff, or another one.
    fn of_energy(&self, graph: &mut Graph, id: NodeId) -> Option<Option<Cutoff>> {
        match graph.node(id) {
            Node::Constant(_) => (graph.as_constant(id) == Some(0.0)).then_some(None),
            Node::Neg(a) => self.of_energy(graph, a),
            // Zero times what is prepared is zero: prepared constants are finite.
            Node::Mul(a, b) if graph.is_prepared(a) => self.of_energy(graph, b),
            Node::Div(a, b) if graph.is_prepared(b) => self.of_energy(graph, a),
            Node::Add(a, b) => match (self.of_energy(graph, a)?, self.of_energy(graph, b)?) {
                (Some(a), Some(b)) => (a == b).then_some(Some(a)),
                (a, b) => Some(a.or(b)),
            },
            Node::Select(condition, a, b) => {
                let [nothing_here, nothing_there] = [a, b].map(|side| graph.as_constant(side) == Some(0.0));
                let found = match (nothing_here, nothing_there) {
                    (false, true) => self.of_condition(graph, condition, true),
                    (true, false) => self.of_condition(graph, condition, false),
                    _ => None,
                };
                match found {
                    Some(cutoff) => Some(Some(cutoff)),
                    // What either side does is beyond its own cutoff.
                    None => match (self.of_energy(graph, a)?, self.of_energy(graph, b)?) {
                        (Some(a), Some(b)) => (a == b).then_some(Some(a)),
                        (a, b) => Some(a.or(b)),
                    },
                }
            }
            _ => None,
        }
    }

    /// The cutoff of what is there where a condition holds, or where it does not.
    fn of_condition(&self, graph: &mut Graph, condition: NodeId, holds: bool) -> Option<Cutoff> {
        match (graph.node(condition), holds) {
            (Node::Not(inner), _) => self.of_condition(graph, inner, !holds),
            (Node::And(a, b), true) | (Node::Or(a, b), false) => {
                self.of_condition(graph, a, holds).or_else(|| self.of_condition(graph, b, holds))
            }
            (Node::Compare(Comparison::Less | Comparison::LessOrEqual, a, b), true) => self.of_bound(graph, a, b),
            (Node::Compare(Comparison::Less | Comparison::LessOrEqual, a, b), false) => self.of_bound(graph, b, a),
            _ => None,
        }
    }

    /// The cutoff of pairs whose distance, or its square, is at most a bound.
    fn of_bound(&self, graph: &mut Graph, distance: NodeId, bound: NodeId) -> Option<Cutoff> {
        if !graph.is_prepared(bound) || graph.loops_of(bound).iter().next().is_some() {
            return None;
        }
        let mut axes = Vec::new();
        let square = match graph.node(distance) {
            Node::Power(square, 1) => {
                self.axes(graph, square, &mut axes)?;
                graph.mul(bound, bound)
            }
            Node::Unary(function, along) if function.name() == "abs" => {
                self.axis(graph, along, &mut axes)?;
                graph.mul(bound, bound)
            }
            _ => {
                self.axes(graph, distance, &mut axes)?;
                bound
            }
        };
        let whole = match &axes[..] {
            [(None | Some(Index::Running(_)), _)] => true,
            axes => {
                let has = |axis| axes.iter().any(|(component, _)| *component == Some(Index::Literal(axis)));
                axes.len() as u64 == self.dimension && (0..self.dimension).all(has)
            }
        };
        if !whole {
            return None;
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
        let [first, second] = self.pair.map(|by| {
            let index = graph.loops.intern(Index::Running(by));
            graph.coordinate(Element { part: Part::Position, index, component })
        });
        let both = [graph.sub(first, second), graph.sub(second, first)];
        let axis = component.map(|component| graph.loops.index(component));
        if both.contains(&id) {
            axes.push((axis, None));
            return Some(());
        }
        let mut sides = Vec::new();
        for node in reachable {
            if let Node::Mul(a, b) = graph.node(node) {
                sides.extend([a, b].into_iter().filter(|factor| graph.is_prepared(*factor)));
            }
        }
        let side = sides.into_iter().find(|side| {
            let opposite = graph.neg(*side);
            [*side, opposite].iter().any(|side| both.iter().any(|by| is_nearest_image(graph, id, *by, *side)))
        })?;
        axes.push((axis, Some(side)));
        Some(())
    }
}

/// Whether a number is a displacement less the nearest multiple of a side.
fn is_nearest_image(graph: &mut Graph, id: NodeId, displacement: NodeId, side: NodeId) -> bool {
    let sides = graph.div(displacement, side);
    ["round", "round_ties_even"].into_iter().any(|rounding| {
        let whole = graph.call(rounding, sides);
        let multiple = graph.mul(side, whole);
        graph.sub(displacement, multiple) == id
    })
}
