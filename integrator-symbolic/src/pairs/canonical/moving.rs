//! Substitution of indices in values.

use crate::graph::{
    Element, Graph, Node, NodeId, ParameterId,
    index::{Index, Loop, LoopId, LoopSet},
    rename::{Parameters, Place, Renaming, rename},
};
use std::collections::HashMap;

/// The most components that are written out.
const COMPONENTS: u64 = 8;

/// The numbers in a range of components; `None` where these are many, or no numbers.
pub(super) fn components(graph: &Graph, by: LoopId) -> Option<std::ops::Range<u64>> {
    let Loop { from, to, .. } = graph.loops.get(by);
    let (from, to) = (graph.loops.literal(from)?, graph.loops.literal(to)?);
    (to.saturating_sub(from) <= COMPONENTS).then_some(from..to)
}

/// The rewriting of a value: indices are replaced, sums over components are written out, hypotenuses are the roots that they
/// are, signs and conditions on the number of bodies leave the texts of parameters.
pub(super) struct Moving<'m> {
    /// What takes the places of the indices of all loops; the last one counts.
    places: Vec<(LoopId, Place)>,
    /// The loop whose index is that of the first body, where a coordinate has it by its number.
    first: Option<LoopId>,
    /// Loops whose indices begin at one in the texts of parameters, which have no value for the first body.
    behind_first: LoopSet,
    parameters: &'m mut dyn Parameters,
    known: HashMap<NodeId, NodeId>,
}

impl<'m> Moving<'m> {
    pub(super) fn new(places: Vec<(LoopId, Place)>, first: Option<LoopId>, parameters: &'m mut dyn Parameters) -> Self {
        Self { places, first, behind_first: LoopSet::EMPTY, parameters, known: HashMap::new() }
    }

    /// The same of values that have none for the first body, for the sake of a factor that is zero there.
    pub(super) fn behind_first(by: LoopSet, parameters: &'m mut dyn Parameters) -> Self {
        let places = by.iter().map(|by| (by, Place::Loop(by))).collect();
        Self { behind_first: by, ..Self::new(places, None, parameters) }
    }

    /// The rewritten value; `None` of what cannot be.
    pub(super) fn value(&mut self, graph: &mut Graph, id: NodeId) -> Option<NodeId> {
        if let Some(known) = self.known.get(&id) {
            return Some(*known);
        }
        let moved = self.rewritten(graph, id)?;
        self.known.insert(id, moved);
        Some(moved)
    }

    fn rewritten(&mut self, graph: &mut Graph, id: NodeId) -> Option<NodeId> {
        Some(match graph.node(id) {
            Node::Constant(_) | Node::Time | Node::Middle | Node::Step => id,
            Node::Parameter(parameter) => self.parameter(graph, parameter)?,
            Node::Coordinate(element) => self.coordinate(graph, element)?,
            Node::Sum(by, body) => self.written_out(graph, by, body)?,
            Node::Neg(a) => {
                let a = self.value(graph, a)?;
                graph.neg(a)
            }
            Node::Add(a, b) => {
                let [a, b] = self.values(graph, [a, b])?;
                graph.add(a, b)
            }
            Node::Mul(a, b) => {
                let [a, b] = self.values(graph, [a, b])?;
                graph.mul(a, b)
            }
            Node::Div(a, b) => {
                let [a, b] = self.values(graph, [a, b])?;
                graph.div(a, b)
            }
            Node::Power(a, halves) => {
                let a = self.value(graph, a)?;
                graph.power(a, halves)
            }
            Node::Unary(function, a) => {
                let a = self.value(graph, a)?;
                graph.unary(function, a)
            }
            Node::Binary(function, a, b) => {
                let [a, b] = self.values(graph, [a, b])?;
                match function.name() {
                    "hypot" => {
                        let [a, b] = [a, b].map(|side| graph.power(side, 4));
                        let square = graph.add(a, b);
                        graph.power(square, 1)
                    }
                    _ => graph.binary(function, a, b),
                }
            }
            // A number that is chosen once per run, such as that of a list which ends before the bodies do.
            _ if graph.is_prepared(id) && self.behind(graph.loops_of(id)).is_empty() => {
                let renamings = self.renamings(graph.loops_of(id))?;
                renamings.into_iter().try_fold(id, |id, renaming| rename(graph, id, renaming, self.parameters))?
            }
            _ => return None,
        })
    }

    fn values(&mut self, graph: &mut Graph, [a, b]: [NodeId; 2]) -> Option<[NodeId; 2]> {
        Some([self.value(graph, a)?, self.value(graph, b)?])
    }

    fn parameter(&mut self, graph: &mut Graph, id: ParameterId) -> Option<NodeId> {
        let (negative, id) = self.parameters.bare(graph, id);
        let mut renamings = self.renamings(graph.loops.of_parameter(id))?.into_iter();
        let id = renamings.try_fold(id, |id, renaming| self.parameters.rename(graph, id, renaming))?;
        let behind = self.behind(graph.loops.of_parameter(id));
        let id = behind.iter().try_fold(id, |id, by| self.parameters.behind_first(graph, id, by))?;
        let value = graph.parameter(id);
        Some(if negative { graph.neg(value) } else { value })
    }

    fn behind(&self, loops: LoopSet) -> LoopSet {
        loops.intersection(self.behind_first)
    }

    fn coordinate(&mut self, graph: &mut Graph, element: Element) -> Option<NodeId> {
        let renamings = self.renamings(graph.loops.of_element(element))?;
        let mut moved = renamings.into_iter().try_fold(element, |element, by| by.element(graph, element))?;
        if let (Some(first), Some(0)) = (self.first, graph.loops.literal(element.index)) {
            moved.index = graph.loops.intern(Index::Running(first));
        }
        Some(graph.coordinate(moved))
    }

    /// A sum, term by term.
    fn written_out(&mut self, graph: &mut Graph, by: LoopId, body: NodeId) -> Option<NodeId> {
        let mut sum = graph.constant(0.0);
        for value in components(graph, by)? {
            let places = [&self.places[..], &[(by, Place::Number(value))]].concat();
            let term = Moving::new(places, self.first, self.parameters).value(graph, body)?;
            sum = graph.add(sum, term);
        }
        Some(sum)
    }

    /// The replacements for some loops, those by other loops together; `None` where there are more, or where a loop
    /// stays that must not.
    fn renamings(&self, loops: LoopSet) -> Option<Vec<Renaming>> {
        let (mut renamings, mut moved) = (Vec::new(), Vec::new());
        for by in loops.iter() {
            match self.places.iter().rev().find(|(from, _)| *from == by)?.1 {
                Place::Loop(to) => moved.push((by, to)),
                number => renamings.push(Renaming::to(by, number)),
            }
        }
        match moved[..] {
            [] => {}
            [(from, to)] => renamings.push(Renaming::one(from, to)),
            [(a, to_a), (b, to_b)] => renamings.push(Renaming::both([a, b], [to_a, to_b])),
            _ => return None,
        }
        Some(renamings)
    }
}
