//! The degree of an expression as a polynomial in the momenta, which decides the class of `T`.

use super::{Graph, Node, NodeId, Part};

impl Graph {
    /// The degree of a node as a polynomial in the coordinates of some parts, with coefficients of whatever else there
    /// is; `None` where it is none.
    pub(crate) fn degree(&self, root: NodeId, parts: &[Part]) -> Option<u32> {
        self.degrees(root, parts)[root.position()]
    }

    /// The degrees of all nodes up to one, by their positions.
    pub(super) fn degrees(&self, root: NodeId, parts: &[Part]) -> Vec<Option<u32>> {
        let mut degrees: Vec<Option<u32>> = Vec::with_capacity(root.position() + 1);
        for position in 0..=root.position() {
            let of = |id: NodeId| degrees[id.position()];
            let degree = match self.nodes[position] {
                Node::Constant(_)
                | Node::Parameter(_)
                | Node::Time
                | Node::Middle
                | Node::Step
                | Node::FromIndex(_) => Some(0),
                Node::Coordinate(element) => Some(u32::from(parts.contains(&element.part))),
                Node::Neg(a) | Node::Sum(_, a) => of(a),
                Node::Add(a, b) => of(a).zip(of(b)).map(|(a, b)| a.max(b)),
                Node::Mul(a, b) => of(a).zip(of(b)).and_then(|(a, b)| a.checked_add(b)),
                Node::Div(a, b) => of(a).filter(|_| of(b) == Some(0)),
                Node::Power(a, halves) => match of(a) {
                    Some(0) => Some(0),
                    Some(degree) if halves > 0 && halves % 2 == 0 => degree.checked_mul(halves as u32 / 2),
                    _ => None,
                },
                Node::Unary(_, a) | Node::Fold(_, _, a) => of(a).filter(|degree| *degree == 0),
                Node::External(_, arguments) => arguments.iter().all(|argument| of(argument) == Some(0)).then_some(0),
                Node::Binary(_, a, b)
                | Node::Entry(_, a, b)
                | Node::Compare(_, a, b)
                | Node::And(a, b)
                | Node::Or(a, b) => of(a).zip(of(b)).filter(|pair| *pair == (0, 0)).map(|_| 0),
                Node::CompareIndex(..) | Node::Flag(_) => Some(0),
                Node::Not(a) => of(a).filter(|degree| *degree == 0),
                // A choice between polynomials is one where no coordinate decides.
                Node::Select(condition, a, b) => {
                    of(condition).filter(|degree| *degree == 0).and(of(a).zip(of(b))).map(|(a, b)| a.max(b))
                }
            };
            degrees.push(degree);
        }
        degrees
    }

    /// Whether an energy is at most quadratic in the momenta, with masses that depend on parameters alone: each of its terms
    /// is quadratic in all coordinates together, or in the momenta alone, or linear in the momenta.
    pub(crate) fn has_constant_mass(&self, energy: NodeId) -> bool {
        let is_at_most = |parts: &[Part], most| self.degree(energy, parts).is_some_and(|degree| degree <= most);
        let is_quadratic = || is_at_most(&[Part::Position, Part::Momentum], 2) && !self.reads_time(energy);
        if is_at_most(&[Part::Momentum], 1) || is_quadratic() {
            return true;
        }
        match self.node(energy) {
            Node::Add(a, b) => self.has_constant_mass(a) && self.has_constant_mass(b),
            Node::Neg(a) | Node::Sum(_, a) => self.has_constant_mass(a),
            Node::Mul(factor, a) | Node::Mul(a, factor) if self.is_prepared(factor) => self.has_constant_mass(a),
            Node::Div(a, divisor) if self.is_prepared(divisor) => self.has_constant_mass(a),
            _ => false,
        }
    }

    /// Whether a node is a quadratic form of the momenta: a homogeneous polynomial of degree two.
    pub(crate) fn is_form_of_momenta(&self, root: NodeId) -> bool {
        let mut degrees: Vec<Option<u32>> = Vec::with_capacity(root.position() + 1);
        for position in 0..=root.position() {
            let of = |id: NodeId| degrees[id.position()];
            let node = self.nodes[position];
            let degree = match node {
                Node::Coordinate(element) => Some(u32::from(element.part == Part::Momentum)),
                Node::Neg(a) | Node::Sum(_, a) => of(a),
                Node::Add(a, b) => of(a).filter(|degree| of(b) == Some(*degree)),
                Node::Mul(a, b) => of(a).zip(of(b)).and_then(|(a, b)| a.checked_add(b)),
                Node::Div(a, b) => of(a).filter(|_| of(b) == Some(0)),
                Node::Power(a, halves) if halves > 0 && halves % 2 == 0 => {
                    of(a).and_then(|degree| degree.checked_mul(halves as u32 / 2))
                }
                _ => node.children().all(|child| of(child) == Some(0)).then_some(0),
            };
            degrees.push(degree);
        }
        degrees[root.position()] == Some(2)
    }

    /// Whether a node reads the explicit time.
    pub(crate) fn reads_time(&self, root: NodeId) -> bool {
        !self.reading_time([root]).is_empty()
    }

    /// All nodes that roots are made of and that read the explicit time, children first.
    pub(super) fn reading_time(&self, roots: impl IntoIterator<Item = NodeId>) -> Vec<NodeId> {
        let mut reads = vec![false; self.len()];
        let read = self.reachable(roots).into_iter().filter(|id| {
            let node = self.node(*id);
            reads[id.position()] = node == Node::Time || node.children().any(|child| reads[child.position()]);
            reads[id.position()]
        });
        read.collect()
    }
}
