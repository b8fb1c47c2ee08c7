//! A numerical interpreter of the arena for tests, which shares no code with code generation.

use super::{
    Comparison, Element, Graph, Node, NodeId, ParameterId, Part,
    function::Rule,
    index::{Index, IndexId, LoopId},
};
use std::collections::HashMap;

/// The value of a parameter where the loops' indices are these.
type LookUp<'p> = &'p dyn Fn(ParameterId, &HashMap<LoopId, i64>) -> f64;

/// The values with which expressions are evaluated.
pub(crate) struct Point<'p> {
    pub(crate) q: &'p [f64],
    pub(crate) p: &'p [f64],
    /// The values of parameters, by their ids.
    pub(crate) parameters: &'p [f64],
    /// The values of parameters in iterations of the loops, where they depend on these.
    pub(crate) look_up: Option<LookUp<'p>>,
    /// How many components a point has, where coordinates are points.
    pub(crate) width: usize,
    /// The running indices of the loops around.
    pub(crate) running: HashMap<LoopId, i64>,
    /// Values that were computed before.
    pub(crate) known: HashMap<NodeId, f64>,
}

impl<'p> Point<'p> {
    pub(crate) fn new(q: &'p [f64], p: &'p [f64]) -> Self {
        Self { q, p, parameters: &[], look_up: None, width: 1, running: HashMap::new(), known: HashMap::new() }
    }

    /// All iterations of the loops of `context`, outermost first.
    pub(crate) fn iterations(&mut self, graph: &Graph, context: &[LoopId], body: &mut dyn FnMut(&mut Self)) {
        let Some((by, inner)) = context.split_first() else { return body(self) };
        let range = graph.loops.get(*by);
        // A sum that the loop's body mentions may run over the same range: it has an index of its own.
        let around = self.running.get(by).copied();
        for iteration in self.index(graph, range.from)..self.index(graph, range.to) {
            self.running.insert(*by, iteration);
            self.iterations(graph, inner, body);
        }
        match around {
            Some(iteration) => self.running.insert(*by, iteration),
            None => self.running.remove(by),
        };
    }

    pub(crate) fn index(&self, graph: &Graph, id: IndexId) -> i64 {
        let value = |id| self.index(graph, id);
        match graph.loops.index(id) {
            Index::Literal(value) => value as i64,
            Index::Length => self.q.len() as i64,
            Index::Running(by) => self.running[&by],
            Index::Parameter(id) => self.parameter(id) as i64,
            Index::Add(a, b) => value(a) + value(b),
            Index::Sub(a, b) | Index::Minus(a, b) => value(a) - value(b),
            Index::Mul(a, b) => value(a) * value(b),
            Index::Div(a, b) => value(a) / value(b),
            Index::Rem(a, b) => value(a) % value(b),
            Index::Monus(a, b) => (value(a) - value(b)).max(0),
            Index::Min(a, b) => value(a).min(value(b)),
            Index::Typed(_, a) => value(a),
            Index::Wrapped(kind, a) => kind.wrapped(value(a)),
            Index::InPlane(row, site) => {
                let sites = graph.loops.sites_of_row().expect("rows have a length");
                value(row) * value(sites) + value(site)
            }
        }
    }

    fn parameter(&self, id: ParameterId) -> f64 {
        match self.look_up {
            Some(look_up) => look_up(id, &self.running),
            None => self.parameters[id.0 as usize],
        }
    }

    pub(crate) fn coordinate(&self, graph: &Graph, element: Element) -> f64 {
        let values = match element.part {
            Part::Position => self.q,
            Part::Momentum => self.p,
        };
        let index = self.index(graph, element.index) as usize;
        match element.component {
            Some(component) => values[index * self.width + self.index(graph, component) as usize],
            None => values[index],
        }
    }

    pub(crate) fn value(&mut self, graph: &Graph, id: NodeId) -> f64 {
        if let Some(value) = self.known.get(&id) {
            return *value;
        }
        match graph.node(id) {
            Node::Constant(bits) => f64::from_bits(bits),
            Node::Parameter(id) => self.parameter(id),
            Node::Coordinate(element) => self.coordinate(graph, element),
            Node::Time | Node::Middle | Node::Step => 1.0,
            Node::FromIndex(index) => self.index(graph, index) as f64,
            Node::Neg(a) => -self.value(graph, a),
            Node::Add(a, b) => self.value(graph, a) + self.value(graph, b),
            Node::Mul(a, b) => self.value(graph, a) * self.value(graph, b),
            Node::Div(a, b) => self.value(graph, a) / self.value(graph, b),
            Node::Power(a, halves) => self.value(graph, a).powf(f64::from(halves) / 2.0),
            Node::Unary(function, a) => {
                let a = self.value(graph, a);
                match function.row().rule {
                    Rule::Unary(value, _) => value(a),
                    Rule::Binary(..) => unreachable!("{} takes two arguments", function.name()),
                }
            }
            Node::Binary(function, a, b) => {
                let (a, b) = (self.value(graph, a), self.value(graph, b));
                match function.row().rule {
                    Rule::Binary(value, _) => value(a, b),
                    Rule::Unary(..) => unreachable!("{} takes one argument", function.name()),
                }
            }
            Node::Select(condition, a, b) => {
                let taken = if self.holds(graph, condition) { a } else { b };
                self.value(graph, taken)
            }
            condition if condition.is_condition() => f64::from(self.holds(graph, id)),
            Node::Sum(by, body) => {
                let mut sum = 0.0;
                self.iterations(graph, &[by], &mut |point| sum += point.value(graph, body));
                sum
            }
            Node::Fold(fold, by, body) => {
                let mut whole = fold.beginning();
                self.iterations(graph, &[by], &mut |point| {
                    let item = point.value(graph, body);
                    whole = fold.joined(whole, item);
                });
                whole
            }
            other => unreachable!("{other:?} is a condition"),
        }
    }

    pub(crate) fn holds(&mut self, graph: &Graph, id: NodeId) -> bool {
        if let Some(value) = self.known.get(&id) {
            return *value != 0.0;
        }
        fn compare<T: PartialOrd>(comparison: Comparison, a: T, b: T) -> bool {
            match comparison {
                Comparison::Less => a < b,
                Comparison::LessOrEqual => a <= b,
                Comparison::Equal => a == b,
            }
        }
        match graph.node(id) {
            Node::Compare(comparison, a, b) => compare(comparison, self.value(graph, a), self.value(graph, b)),
            Node::CompareIndex(comparison, a, b) => compare(comparison, self.index(graph, a), self.index(graph, b)),
            Node::Flag(id) => self.parameters[id.0 as usize] != 0.0,
            Node::And(a, b) => self.holds(graph, a) && self.holds(graph, b),
            Node::Or(a, b) => self.holds(graph, a) || self.holds(graph, b),
            Node::Not(a) => !self.holds(graph, a),
            other => unreachable!("{other:?} is a number"),
        }
    }
}
