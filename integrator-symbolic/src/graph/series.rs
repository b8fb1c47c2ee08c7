//! Series that are written out, as loops over tables of numbers.
//!
//! In: energies. Out: the same energies, in which terms that differ in their numbers alone are one loop, as if the user had
//! written it over tables. So generated code does not grow with the number of terms.
//!
//! - A sum first adds its other terms, then the loops in the order of their first terms. A loop adds its terms in the order
//!   in which they are first written.
//! - A series has at least [`FEWEST`] terms. All other sums remain as they are, with the same rounding.
//! - Terms that differ in a factor alone are left to the collection of like terms.
//! - Values that conditions compare do not change.

use super::{
    Graph, Node, NodeId, ParameterId,
    index::{Index, Loop, LoopId, LoopSet},
};
use std::collections::{HashMap, HashSet};

/// The fewest terms of a series. Straight-line code of fewer compiles as fast as a loop.
pub(crate) const FEWEST: usize = 32;

/// The most nodes of a term, counted as often as they occur, and the most tables of a loop.
const LARGEST: usize = 200;
const MOST_TABLES: usize = 64;

/// Makes the parameter whose values in the iterations of a loop are these numbers.
pub(crate) type MakeTable<'t> = &'t mut dyn FnMut(&mut Graph, LoopId, &[f64]) -> ParameterId;

/// A term without its sign and its number, which are `factor`.
struct Term {
    factor: f64,
    rest: NodeId,
}

/// The terms of a loop, each with the number of its addend in the sum.
type Series = Vec<(usize, Term)>;

/// What all terms of a loop have in common: a node of shapes instead of children, and a number for every number.
#[derive(Clone, Copy)]
struct Shape {
    id: NodeId,
    nodes: usize,
    numbers: usize,
}

impl Graph {
    /// The values that `roots` and what they are made of become, but for those in `kept`; empty where there is no series.
    pub(crate) fn with_series_as_loops(
        &mut self,
        roots: &[NodeId],
        kept: &[NodeId],
        table: MakeTable<'_>,
    ) -> HashMap<NodeId, NodeId> {
        let nodes = self.reachable(roots.iter().copied());
        let sums = self.long_sums(&nodes, roots);
        if sums.is_empty() {
            return HashMap::new();
        }
        let mut stays = self.compared(roots.iter().copied());
        stays.extend(self.reachable(kept.iter().copied()));
        let mut shapes = Shapes::default();
        nodes.iter().for_each(|id| shapes.note(self, *id));
        let (mut known, mut changed): (HashMap<NodeId, NodeId>, bool) = (HashMap::new(), false);
        for id in nodes {
            let series = match sums.get(&id) {
                Some(addends) if !stays.contains(&id) => self.series(addends, &mut shapes),
                _ => Vec::new(),
            };
            let new = match series.is_empty() {
                true if stays.contains(&id) || self.node(id).children().all(|child| known[&child] == child) => id,
                true => self.rebuilt(self.node(id).map(|child| known[&child])),
                false => self.with_loops(&sums[&id], &series, &known, &shapes, &mut *table),
            };
            changed |= new != id;
            known.insert(id, new);
        }
        if changed { known } else { HashMap::new() }
    }

    /// The addends of each sum of many terms that is no part of another one, and whether they are subtracted: in the order in
    /// which they are first written.
    fn long_sums(&self, nodes: &[NodeId], roots: &[NodeId]) -> HashMap<NodeId, Vec<(bool, NodeId)>> {
        let mut uses: HashMap<NodeId, usize> = HashMap::new();
        for id in nodes.iter().flat_map(|id| self.node(*id).children()).chain(roots.iter().copied()) {
            *uses.entry(id).or_default() += 1;
        }
        let (mut sums, mut inner) = (HashMap::new(), HashSet::new());
        for sum in nodes.iter().rev().copied() {
            if !matches!(self.node(sum), Node::Add(..)) || self.is_prepared(sum) || inner.contains(&sum) {
                continue;
            }
            let (mut addends, mut open) = (Vec::new(), vec![(false, sum)]);
            while let Some((negative, id)) = open.pop() {
                let is_part = id == sum || uses[&id] == 1;
                match self.node(id) {
                    Node::Add(a, b) if is_part => open.extend([(negative, b), (negative, a)]),
                    Node::Neg(a) if is_part => open.push((!negative, a)),
                    _ => {
                        addends.push((negative, id));
                        continue;
                    }
                }
                inner.insert(id);
            }
            if addends.len() >= FEWEST {
                addends.sort_by_key(|(_, id)| *id);
                sums.insert(sum, addends);
            }
        }
        sums
    }

    /// The series among the addends of a sum, each with the numbers of its addends and its terms.
    fn series(&mut self, addends: &[(bool, NodeId)], shapes: &mut Shapes) -> Vec<Series> {
        let mut groups: Vec<Series> = Vec::new();
        let mut of_shape: HashMap<NodeId, usize> = HashMap::new();
        for (number, (negative, id)) in addends.iter().enumerate() {
            let (is_negative, value) = self.signed(*id);
            let (factor, Some(rest)) = self.strip(value) else { continue };
            let factor = if *negative == is_negative { factor } else { -factor };
            // Without its number, a product may be a new node.
            shapes.note(self, rest);
            match shapes.known[&rest] {
                Some(shape) if !self.is_prepared(rest) && self.loops_of(rest).is_empty() => {
                    let group = *of_shape.entry(shape.id).or_insert(groups.len());
                    if group == groups.len() {
                        groups.push(Vec::new());
                    }
                    groups[group].push((number, Term { factor, rest }));
                }
                _ => {}
            }
        }
        groups.retain(|terms| terms.len() >= FEWEST && self.makes_a_loop(terms, shapes));
        groups
    }

    /// Whether terms differ, in few enough and finite numbers.
    fn makes_a_loop(&self, terms: &[(usize, Term)], shapes: &Shapes) -> bool {
        let numbers: Vec<_> = terms.iter().map(|(_, term)| shapes.numbers(self, term.rest)).collect();
        let differ = |at: usize| numbers.iter().any(|of_term| of_term[at].to_bits() != numbers[0][at].to_bits());
        let tables = (0..numbers[0].len()).filter(|at| differ(*at)).count();
        let factors = terms.iter().map(|(_, term)| &term.factor);
        (1..MOST_TABLES).contains(&tables) && numbers.iter().flatten().chain(factors).all(|number| number.is_finite())
    }

    /// A sum with loops in place of its series.
    fn with_loops(
        &mut self,
        addends: &[(bool, NodeId)],
        series: &[Series],
        known: &HashMap<NodeId, NodeId>,
        shapes: &Shapes,
        table: MakeTable<'_>,
    ) -> NodeId {
        let (mut sum, mut in_loops) = (self.constant(0.0), HashSet::new());
        let mut loops = Vec::new();
        for terms in series {
            if let Some(value) = self.looped(terms, shapes, &mut *table) {
                in_loops.extend(terms.iter().map(|(number, _)| *number));
                loops.push(value);
            }
        }
        for (number, (negative, id)) in addends.iter().enumerate() {
            if !in_loops.contains(&number) {
                let addend = known[id];
                sum = if *negative { self.sub(sum, addend) } else { self.add(sum, addend) };
            }
        }
        loops.into_iter().fold(sum, |sum, value| self.add(sum, value))
    }

    /// A series as a loop; `None` where there are as many loops as there may be.
    fn looped(&mut self, terms: &[(usize, Term)], shapes: &Shapes, table: MakeTable<'_>) -> Option<NodeId> {
        let [from, to] = [0, terms.len() as u64].map(|bound| self.loops.intern(Index::Literal(bound)));
        let range = Loop { parent: None, from, to };
        if self.loops.count() >= LoopSet::CAPACITY {
            return None;
        }
        let by = self.loops.range(range);
        let mut read = |graph: &mut Graph, numbers: Vec<f64>| match numbers.iter().all(|number| *number == numbers[0]) {
            true => graph.constant(numbers[0]),
            false => {
                let id = table(graph, by, &numbers);
                if numbers.iter().all(|number| *number >= 0.0) {
                    graph.declare_never_negative(id);
                }
                graph.parameter(id)
            }
        };
        let of_terms: Vec<_> = terms.iter().map(|(_, term)| shapes.numbers(self, term.rest)).collect();
        let columns = (0..of_terms[0].len()).map(|at| of_terms.iter().map(|numbers| numbers[at]).collect());
        let columns: Vec<NodeId> = columns.map(|numbers| read(self, numbers)).collect();
        let factor = read(self, terms.iter().map(|(_, term)| term.factor).collect());
        let body = self.with_numbers(terms[0].1.rest, shapes, &mut columns.into_iter());
        let body = self.mul(factor, body);
        Some(self.sum(by, body))
    }

    /// A term with other values in place of its numbers.
    fn with_numbers(&mut self, id: NodeId, shapes: &Shapes, numbers: &mut impl Iterator<Item = NodeId>) -> NodeId {
        if shapes.known[&id].is_none_or(|shape| shape.numbers == 0) {
            return id;
        }
        let node = self.node(id);
        let mut children = Vec::new();
        for (factor, child) in shapes.operands(self, node) {
            let factor = factor.and_then(|_| numbers.next());
            let child = self.with_numbers(child, shapes, numbers);
            children.push(factor.map_or(child, |factor| self.mul(factor, child)));
        }
        match (node, &children[..]) {
            (Node::Constant(_), _) => numbers.next().unwrap_or(id),
            (Node::Neg(_), [a]) => self.neg(*a),
            (Node::Add(..), [a, b]) => self.add(*a, *b),
            (Node::Mul(..), [a, b]) => self.mul(*a, *b),
            (Node::Div(..), [a, b]) => self.div(*a, *b),
            (Node::Power(_, halves), [a]) => self.power(*a, halves),
            (Node::Unary(function, _), [a]) => self.unary(function, *a),
            (Node::Binary(function, ..), [a, b]) => self.binary(function, *a, *b),
            _ => id,
        }
    }

    /// A value as a number times another one; `1` and the value itself where it has no number.
    fn factored(&self, id: NodeId) -> (f64, NodeId) {
        let (is_negative, value) = self.signed(id);
        let (factor, rest) = match self.node(value) {
            Node::Mul(a, b) => self.as_constant(a).map_or((1.0, value), |factor| (factor, b)),
            _ => (1.0, value),
        };
        (if is_negative { -factor } else { factor }, rest)
    }
}

/// The shapes of nodes; `None` of those that no loop has in its body.
#[derive(Default)]
struct Shapes {
    known: HashMap<NodeId, Option<Shape>>,
    ids: HashMap<Node, NodeId>,
}

impl Shapes {
    /// Notes a node, and its children if they are new.
    fn note(&mut self, graph: &Graph, id: NodeId) {
        if !self.known.contains_key(&id) {
            graph.node(id).children().for_each(|child| self.note(graph, child));
            let shape = self.of(graph, graph.node(id));
            self.known.insert(id, shape);
        }
    }

    fn of(&mut self, graph: &Graph, node: Node) -> Option<Shape> {
        let is_term = matches!(
            node,
            Node::Constant(_)
                | Node::Parameter(_)
                | Node::Coordinate(_)
                | Node::Time
                | Node::Neg(_)
                | Node::Add(..)
                | Node::Mul(..)
                | Node::Div(..)
                | Node::Power(..)
                | Node::Unary(..)
                | Node::Binary(..)
        );
        if !is_term || node.children().any(|child| self.known[&child].is_none()) {
            return None;
        }
        let (mut nodes, mut numbers, mut shapes) =
            (1_usize, usize::from(matches!(node, Node::Constant(_))), Vec::new());
        for (factor, child) in self.operands(graph, node) {
            let shape = self.known[&child]?;
            nodes = nodes.saturating_add(shape.nodes).saturating_add(usize::from(factor.is_some()));
            numbers += shape.numbers + usize::from(factor.is_some());
            shapes.push(shape.id);
        }
        let key = match (node, &shapes[..]) {
            (Node::Constant(_), _) => Node::Constant(0),
            (Node::Add(..), [a, b]) => Node::Add(*a, *b),
            (Node::Mul(..), [a, b]) => Node::Mul(*a, *b),
            (Node::Unary(function, _), [a]) => Node::Unary(function, *a),
            _ => node.map(|child| self.known[&child].map_or(child, |shape| shape.id)),
        };
        let free = NodeId(self.ids.len() as u32);
        let id = *self.ids.entry(key).or_insert(free);
        (nodes <= LARGEST).then_some(Shape { id, nodes, numbers })
    }

    /// What a node is computed from. Addends and arguments of functions have a factor, so that `x`, `2 x` and `-x` have one
    /// shape. Operands that may be exchanged have the order of their shapes.
    fn operands(&self, graph: &Graph, node: Node) -> Vec<(Option<f64>, NodeId)> {
        let has_factors = matches!(node, Node::Add(..) | Node::Unary(..));
        let operand = |id| match graph.factored(id) {
            (factor, rest) if has_factors && graph.as_constant(id).is_none() => (Some(factor), rest),
            _ => (None, id),
        };
        let mut operands: Vec<_> = node.children().map(operand).collect();
        if matches!(node, Node::Add(..) | Node::Mul(..)) {
            operands.sort_by_key(|(_, id)| self.known[id].map(|shape| shape.id));
        }
        operands
    }

    /// The numbers of a term.
    fn numbers(&self, graph: &Graph, term: NodeId) -> Vec<f64> {
        let mut numbers = Vec::new();
        self.add_numbers(graph, term, &mut numbers);
        numbers
    }

    fn add_numbers(&self, graph: &Graph, id: NodeId, numbers: &mut Vec<f64>) {
        numbers.extend(graph.as_constant(id));
        for (factor, child) in self.operands(graph, graph.node(id)) {
            numbers.extend(factor);
            self.add_numbers(graph, child, numbers);
        }
    }
}

#[cfg(test)]
mod tests;
