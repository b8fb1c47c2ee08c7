//! Hamiltonians with pieces in time: the conditions between pieces are evaluated once per step, at its midpoint.
//!
//! A step that ends at the end of a piece belongs to this piece, including its last kick. A stage of a composition
//! whose time is outside of the step uses the same formula. The order of a method hence holds from piece to piece,
//! which it would not if every stage evaluated the conditions. Other expressions use the time of their stage, as
//! everywhere.

use super::{
    Comparison, Graph, Node, NodeId, Part,
    function::{Function, Rule},
};

impl Graph {
    /// The middle of the step that a flow belongs to.
    pub(crate) fn middle(&mut self) -> NodeId {
        self.intern(Node::Middle)
    }

    /// The same roots, with every choice by time and parameters alone made in the middle of the step. A condition that
    /// reads coordinates stays where it is: only the stage has their values.
    pub(crate) fn with_choices_in_the_middle(&mut self, roots: &[NodeId]) -> Vec<NodeId> {
        let read = self.reading_time(roots.iter().copied());
        if !read.iter().any(|id| self.is_of_time(*id) && chooses(self.node(*id))) {
            return roots.to_vec();
        }
        let mut pieces = Pieces { middle: vec![None; self.len()], chosen: vec![None; self.len()] };
        for id in read {
            self.choose_in_the_middle(&mut pieces, id);
        }
        roots.iter().map(|root| pieces.chosen(*root)).collect()
    }

    /// Whether coordinates have no part in a node.
    fn is_of_time(&self, id: NodeId) -> bool {
        !self.reads(id, Part::Position) && !self.reads(id, Part::Momentum)
    }

    fn choose_in_the_middle(&mut self, pieces: &mut Pieces, id: NodeId) {
        let (node, is_of_time) = (self.node(id), self.is_of_time(id));
        pieces.middle[id.position()] = Some(match node {
            Node::Time => self.middle(),
            _ => self.rebuilt(node.map(|child| pieces.middle(child))),
        });
        pieces.chosen[id.position()] = Some(match node {
            Node::Compare(..) if is_of_time => pieces.middle(id),
            Node::Unary(function, _) if is_of_time && is_level(function) => pieces.middle(id),
            Node::Unary(_, a) if is_of_time && chooses(node) => {
                let (zero, value) = (self.constant(0.0), pieces.chosen(a));
                let (negative, opposite) = (self.compare(Comparison::Less, pieces.middle(a), zero), self.neg(value));
                self.select(negative, opposite, value)
            }
            Node::Binary(function, a, b) if is_of_time && function.name() == "remainder" => {
                let (middle, divisor) = (self.div(pieces.middle(a), pieces.middle(b)), pieces.chosen(b));
                let whole = self.call("trunc", middle);
                let taken = self.mul(whole, divisor);
                self.sub(pieces.chosen(a), taken)
            }
            Node::Binary(function, a, b) if is_of_time && chooses(node) => {
                // Second what does not read the time: it may be NaN, and the other is taken then.
                let [a, b] = if pieces.reads_time(a) { [a, b] } else { [b, a] };
                let second = match function.name() {
                    "min" => self.compare(Comparison::Less, pieces.middle(b), pieces.middle(a)),
                    _ => self.compare(Comparison::Less, pieces.middle(a), pieces.middle(b)),
                };
                self.select(second, pieces.chosen(b), pieces.chosen(a))
            }
            _ => self.rebuilt(node.map(|child| pieces.chosen(child))),
        });
    }
}

/// Nodes that read the time, as they are in the middle of the step, and with choices made there.
struct Pieces {
    middle: Vec<Option<NodeId>>,
    chosen: Vec<Option<NodeId>>,
}

impl Pieces {
    fn reads_time(&self, id: NodeId) -> bool {
        self.middle[id.position()].is_some()
    }
    fn middle(&self, id: NodeId) -> NodeId {
        self.middle[id.position()].unwrap_or(id)
    }
    fn chosen(&self, id: NodeId) -> NodeId {
        self.chosen[id.position()].unwrap_or(id)
    }
}

/// Whether a node changes from one formula to another somewhere.
fn chooses(node: Node) -> bool {
    match node {
        Node::Compare(..) => true,
        Node::Unary(function, _) => is_level(function) || function.name() == "abs",
        Node::Binary(function, ..) => function.row().chooses.is_some() || function.name() == "remainder",
        _ => false,
    }
}

/// Whether a function is constant but where it jumps.
fn is_level(function: Function) -> bool {
    matches!(function.row().rule, Rule::Unary(_, None))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::graph::{Element, index::Index};

    type Build = fn(&mut Graph, [NodeId; 3]) -> NodeId;
    type Decided = fn(&mut Graph, Read) -> NodeId;

    /// What is built of the time, a coordinate and a number on the left becomes the very node on the right.
    const DECIDED: &[(&str, Build, Decided)] = &[
        (
            "t < a",
            |g, [t, _, a]| g.compare(Comparison::Less, t, a),
            |g, Read { middle, a, .. }| g.compare(Comparison::Less, middle, a),
        ),
        (
            "t if t < a, else q",
            |g, [t, q, a]| {
                let condition = g.compare(Comparison::Less, t, a);
                g.select(condition, t, q)
            },
            |g, Read { t, middle, q, a }| {
                let condition = g.compare(Comparison::Less, middle, a);
                g.select(condition, t, q)
            },
        ),
        (
            "q < t",
            |g, [t, q, _]| g.compare(Comparison::Less, q, t),
            |g, Read { t, q, .. }| g.compare(Comparison::Less, q, t),
        ),
        (
            "max(t, a)",
            |g, [t, _, a]| g.call_two("max", t, a),
            |g, Read { t, middle, a, .. }| {
                let second = g.compare(Comparison::Less, middle, a);
                g.select(second, a, t)
            },
        ),
        (
            "min(a, t)",
            |g, [t, _, a]| g.call_two("min", a, t),
            |g, Read { t, middle, a, .. }| {
                let second = g.compare(Comparison::Less, a, middle);
                g.select(second, a, t)
            },
        ),
        (
            "|t|",
            |g, [t, ..]| g.call("abs", t),
            |g, Read { t, middle, .. }| {
                let (zero, opposite) = (g.constant(0.0), g.neg(t));
                let negative = g.compare(Comparison::Less, middle, zero);
                g.select(negative, opposite, t)
            },
        ),
        (
            "t % a",
            |g, [t, _, a]| g.call_two("remainder", t, a),
            |g, Read { t, middle, a, .. }| {
                let quotient = g.div(middle, a);
                let whole = g.call("trunc", quotient);
                let taken = g.mul(whole, a);
                g.sub(t, taken)
            },
        ),
        ("floor(t)", |g, [t, ..]| g.call("floor", t), |g, Read { middle, .. }| g.call("floor", middle)),
        ("signum(t)", |g, [t, ..]| g.call("signum", t), |g, Read { middle, .. }| g.call("signum", middle)),
        ("sin(t)", |g, [t, ..]| g.call("sin", t), |g, Read { t, .. }| g.call("sin", t)),
        ("max(q, t)", |g, [t, q, _]| g.call_two("max", q, t), |g, Read { t, q, .. }| g.call_two("max", q, t)),
    ];

    struct Read {
        t: NodeId,
        middle: NodeId,
        q: NodeId,
        a: NodeId,
    }

    #[test]
    fn choices_of_the_time_alone_are_made_in_the_middle_of_the_step() {
        for (name, build, decided) in DECIDED {
            let mut graph = Graph::default();
            let index = graph.loops.intern(Index::Literal(0));
            let q = graph.coordinate(Element { part: Part::Position, index, component: None });
            let (t, a) = (graph.time(), graph.constant(0.5));
            let root = build(&mut graph, [t, q, a]);
            let before = graph.len();
            let chosen = graph.with_choices_in_the_middle(&[root, q]);
            let (found, same) = (chosen[0], chosen[1]);
            assert_eq!(same, q, "{name}");
            let grew = graph.len() > before;
            let middle = graph.middle();
            let expected = decided(&mut graph, Read { t, middle, q, a });
            assert_eq!(found, expected, "{name}: {:?} and {:?}", graph.node(found), graph.node(expected));
            assert_eq!(grew, found != root, "{name}: what has no pieces adds no nodes");
        }
    }
}
