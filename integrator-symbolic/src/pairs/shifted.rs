//! Displacements of two bodies that are shifted by multiples of the side of a box.
//!
//! Always true: a recognised number is a displacement of two bodies up to its sign and multiples of the side, so it is not shorter than
//! that of the nearest images.

use crate::graph::{Graph, Node, NodeId, index::LoopId};
use std::collections::{HashMap, HashSet};

/// The numbers that may be the side of a box in a node that computes an image of a displacement.
pub(super) fn sides_in(graph: &Graph, node: NodeId, pair: [LoopId; 2]) -> Vec<NodeId> {
    let factors = |id: NodeId| match graph.node(id) {
        Node::Mul(a, b) => vec![id, a, b],
        _ => vec![id],
    };
    let candidates = match graph.node(node) {
        Node::Mul(a, b) => vec![a, b],
        Node::Binary(function, _, divisor) if function.name() == "remainder" => vec![divisor],
        // One of two images, which differ by a multiple of the side.
        Node::Select(_, a, b) | Node::Binary(_, a, b) => {
            let terms = [a, b].into_iter().flat_map(|image| match graph.node(image) {
                Node::Add(a, b) => vec![a, b],
                _ => vec![image],
            });
            terms.flat_map(factors).collect()
        }
        _ => Vec::new(),
    };
    let sides = candidates.into_iter().map(|candidate| graph.without_sign(candidate));
    let is_side = |side: &NodeId| {
        let loops = graph.loops_of(*side);
        let is_zero = graph.as_constant(*side) == Some(0.0);
        graph.is_prepared(*side) && !is_zero && !pair.iter().any(|by| loops.contains(*by))
    };
    sides.filter(is_side).collect()
}

/// Recognises displacements up to their sign and multiples of a side. They are not shorter than that of the nearest images.
pub(super) struct Shifted<'g> {
    graph: &'g Graph,
    side: NodeId,
    /// The displacement, and its opposite.
    both: [NodeId; 2],
    /// Results of `terms`, `is_displacement` and `is_multiple`.
    terms: HashMap<NodeId, Vec<Term>>,
    displacements: HashMap<NodeId, bool>,
    multiples: HashMap<NodeId, bool>,
}

/// A term of a sum, and whether it is subtracted.
type Term = (NodeId, bool);

impl<'g> Shifted<'g> {
    /// The maximum number of terms of a displacement. The number of terms of nested sums grows exponentially.
    const TERMS: usize = 8;

    pub(super) fn new(graph: &'g Graph, side: NodeId, both: [NodeId; 2]) -> Self {
        let (terms, displacements, multiples) = Default::default();
        Self { graph, side, both, terms, displacements, multiples }
    }

    /// Whether a number is the displacement up to its sign and multiples of the side.
    pub(super) fn is_displacement(&mut self, id: NodeId) -> bool {
        if let Some(known) = self.displacements.get(&id) {
            return *known;
        }
        let terms = self.terms(id);
        let found = match terms[..] {
            [(term, _)] => {
                self.both.contains(&term)
                    || match self.graph.node(term) {
                        Node::Unary(function, a) if function.name() == "abs" => self.is_displacement(a),
                        Node::Binary(function, a, b) if function.name() == "min" => {
                            self.is_displacement(a) && self.is_displacement(b)
                        }
                        Node::Select(_, a, b) => self.is_displacement(a) && self.is_displacement(b),
                        _ => false,
                    }
            }
            _ => self.is_difference(&terms),
        };
        self.displacements.insert(id, found);
        found
    }

    /// Whether these terms are the two of the displacement.
    fn is_difference(&self, terms: &[Term]) -> bool {
        let Node::Add(a, b) = self.graph.node(self.graph.without_sign(self.both[0])) else { return false };
        let own = [a, b].map(|term| self.graph.signed(term));
        let alike = |opposite: bool| {
            terms.len() == own.len()
                && own.iter().all(|(negative, term)| terms.contains(&(*term, *negative != opposite)))
        };
        alike(false) || alike(true)
    }

    /// The terms of a sum that are no multiples of the side; opposite ones cancel.
    fn terms(&mut self, id: NodeId) -> Vec<Term> {
        if let Some(known) = self.terms.get(&id) {
            return known.clone();
        }
        let opposite = |terms: Vec<Term>| terms.into_iter().map(|(term, negative)| (term, !negative)).collect();
        let terms = match self.graph.node(id) {
            _ if self.is_multiple(id) => Vec::new(),
            Node::Add(a, b) if !self.both.contains(&id) => {
                let mut terms = self.terms(a);
                for (term, negative) in self.terms(b) {
                    match terms.iter().position(|known| *known == (term, !negative)) {
                        Some(opposite) => drop(terms.swap_remove(opposite)),
                        None => terms.push((term, negative)),
                    }
                }
                terms
            }
            Node::Neg(a) => opposite(self.terms(a)),
            Node::Binary(function, a, b) if function.name() == "remainder" && b == self.side => self.terms(a),
            // One more multiple of the side in one of the branches.
            Node::Select(_, a, b) => {
                let mut sides = [self.terms(a), self.terms(b)];
                sides.iter_mut().for_each(|side| side.sort());
                match sides {
                    [a, b] if a == b => a,
                    _ => vec![(id, false)],
                }
            }
            _ => vec![(id, false)],
        };
        let terms = if terms.len() > Self::TERMS { vec![(id, false)] } else { terms };
        self.terms.insert(id, terms.clone());
        terms
    }

    /// Whether a number is a multiple of the side.
    fn is_multiple(&mut self, id: NodeId) -> bool {
        if let Some(known) = self.multiples.get(&id) {
            return *known;
        }
        let found = match self.graph.node(id) {
            _ if id == self.side => true,
            Node::Constant(_) => self.graph.as_constant(id) == Some(0.0),
            Node::Neg(a) => self.is_multiple(a),
            Node::Unary(function, a) if function.name() == "abs" => self.is_multiple(a),
            Node::Add(a, b) | Node::Select(_, a, b) => self.is_multiple(a) && self.is_multiple(b),
            Node::Mul(a, b) => {
                self.is_multiple(a) && is_integer(self.graph, b) || self.is_multiple(b) && is_integer(self.graph, a)
            }
            _ => false,
        };
        self.multiples.insert(id, found);
        found
    }
}

/// Whether a number is an integer: a sum, a product or an extreme of rounded numbers and of integer constants.
fn is_integer(graph: &Graph, root: NodeId) -> bool {
    let mut open = vec![root];
    let mut seen = HashSet::new();
    while let Some(id) = open.pop() {
        if !seen.insert(id) {
            continue;
        }
        match graph.node(id) {
            Node::Constant(_) if graph.as_constant(id).is_some_and(|number| number.fract() == 0.0) => {}
            Node::Neg(a) => open.push(a),
            Node::Add(a, b) | Node::Mul(a, b) | Node::Select(_, a, b) => open.extend([a, b]),
            Node::Unary(function, _) if ROUNDED.contains(&function.name()) => {}
            Node::Binary(function, a, b) if matches!(function.name(), "max" | "min") => open.extend([a, b]),
            _ => return false,
        }
    }
    true
}

/// The functions whose values are integers.
const ROUNDED: [&str; 6] = ["round", "round_ties_even", "floor", "ceil", "trunc", "signum"];
