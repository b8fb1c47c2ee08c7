//! Gradients by a reverse sweep over the arena.
//!
//! Comes in: a root and the part to differentiate by. Goes out: contributions to the components of the gradient, each
//! with the loops around it. Always true: the sum of all contributions over all turns of their loops is the gradient;
//! sums are never unrolled; what is zero has no contribution.
//!
//! Inside a sum the adjoint of a node is a value per turn of the loops around it. Where such a value reaches a node
//! that does not depend on the innermost of these loops, it is summed over them first, so that the sweep leaves a loop
//! as soon as it can.

use crate::graph::{Element, Graph, Node, NodeId, Part, index::LoopId};

/// An addend of one component of a gradient (of a family of them, where the component depends on loops).
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Contribution {
    /// The loops around it, outermost first.
    pub(crate) context: Vec<LoopId>,
    /// The coordinate that the component belongs to.
    pub(crate) element: Element,
    pub(crate) value: NodeId,
}

/// The gradient of `root` by the coordinates of `part`, in the order of their ids.
pub(crate) fn gradient(graph: &mut Graph, root: NodeId, part: Part) -> Vec<Contribution> {
    let mut sweep = Sweep { depends: dependence(graph, root, part), adjoints: vec![Vec::new(); root.position() + 1] };
    let one = graph.constant(1.0);
    sweep.push(graph, root, &[], one);
    let mut contributions = Vec::new();
    for id in graph.reachable([root]).into_iter().rev() {
        for (context, adjoint) in std::mem::take(&mut sweep.adjoints[id.position()]) {
            match graph.node(id) {
                Node::Coordinate(element) => contributions.push(Contribution { context, element, value: adjoint }),
                node => sweep.through(graph, id, node, &context, adjoint),
            }
        }
    }
    contributions.reverse();
    contributions
}

/// Which nodes depend on the coordinates of `part`.
fn dependence(graph: &Graph, root: NodeId, part: Part) -> Vec<bool> {
    let mut depends = vec![false; root.position() + 1];
    for id in graph.reachable([root]) {
        let node = graph.node(id);
        let own = matches!(node, Node::Coordinate(element) if element.part == part);
        depends[id.position()] = own || node.children().any(|child| depends[child.position()]);
    }
    depends
}

struct Sweep {
    depends: Vec<bool>,
    /// The adjoints of a node so far, one per context that it is used in.
    adjoints: Vec<Vec<(Vec<LoopId>, NodeId)>>,
}

impl Sweep {
    /// Passes the adjoint of `node` on to its children.
    fn through(&mut self, graph: &mut Graph, id: NodeId, node: Node, context: &[LoopId], adjoint: NodeId) {
        match node {
            Node::Neg(a) => {
                let value = graph.neg(adjoint);
                self.push(graph, a, context, value);
            }
            Node::Add(a, b) => {
                self.push(graph, a, context, adjoint);
                self.push(graph, b, context, adjoint);
            }
            Node::Mul(a, b) => {
                self.push_product(graph, a, context, adjoint, b);
                self.push_product(graph, b, context, adjoint, a);
            }
            Node::Div(a, b) if self.depends[a.position()] => {
                let value = graph.div(adjoint, b);
                self.push(graph, a, context, value);
            }
            Node::Power(a, halves) if self.depends[a.position()] => {
                // d(x^e) = e x^(e-1)
                let lowered = graph.power(a, halves - 2);
                let exponent = graph.constant(f64::from(halves) / 2.0);
                let slope = graph.mul(exponent, lowered);
                self.push_product(graph, a, context, adjoint, slope);
            }
            Node::Unary(function, a) if self.depends[a.position()] => {
                if let Some(slope) = graph.slope(function, a, id) {
                    self.push_product(graph, a, context, adjoint, slope);
                }
            }
            Node::Binary(function, a, b) => {
                let slopes = graph.slopes(function, a, b, id);
                for (child, slope) in [a, b].into_iter().zip(slopes) {
                    if let Some(slope) = slope {
                        self.push_product(graph, child, context, adjoint, slope);
                    }
                }
            }
            Node::Sum(by, body) => {
                let inside: Vec<LoopId> = context.iter().copied().chain([by]).collect();
                self.push(graph, body, &inside, adjoint);
            }
            // Leaves pass nothing on; neither does what does not depend on the part.
            _ => {}
        }
    }

    fn push_product(&mut self, graph: &mut Graph, to: NodeId, context: &[LoopId], adjoint: NodeId, slope: NodeId) {
        if self.depends[to.position()] {
            let value = graph.mul(adjoint, slope);
            self.push(graph, to, context, value);
        }
    }

    /// Adds `value`, one per turn of the loops in `context`, to the adjoint of `to`.
    fn push(&mut self, graph: &mut Graph, to: NodeId, context: &[LoopId], value: NodeId) {
        if !self.depends[to.position()] {
            return;
        }
        let own = graph.loops_of(to);
        let depth = context.iter().rposition(|by| own.contains(*by)).map_or(0, |deepest| deepest + 1);
        let value = context[depth..].iter().rev().fold(value, |value, by| graph.sum(*by, value));
        let adjoints = &mut self.adjoints[to.position()];
        match adjoints.iter_mut().find(|(known, _)| known == &context[..depth]) {
            Some((_, sum)) => *sum = graph.add(*sum, value),
            None => adjoints.push((context[..depth].to_vec(), value)),
        }
    }
}
