//! Diagonal inverse masses, for kinetic energies that are sums of squares.
//!
//! In: the gradient of `T`. Out: the factors of its components, if each is its own momentum times a number. The
//! coefficients of positions then follow from those of momenta without recurrences, and are known one order ahead.

use crate::{
    differentiate::Contribution,
    graph::{Element, Graph, Node, NodeId, Scope},
};

/// The inverse masses of the coordinates, in place of the components of the gradient.
pub(crate) fn inverse_masses(graph: &mut Graph, gradient: &[Contribution]) -> Option<Vec<Contribution>> {
    let of = |contribution: &Contribution| {
        let Contribution { context, element, value } = contribution;
        let is_loop = |around: &Scope| matches!(around, Scope::Loop(_));
        let value = context.iter().all(is_loop).then(|| factor(graph, *value, *element))??;
        Some(Contribution { value, ..contribution.clone() })
    };
    gradient.iter().map(of).collect()
}

/// The factor of a momentum in a value, if this is a multiple of it. Products have their prepared factors at the left.
fn factor(graph: &mut Graph, value: NodeId, of: Element) -> Option<NodeId> {
    match graph.node(value) {
        Node::Coordinate(element) => (element == of).then(|| graph.constant(1.0)),
        Node::Neg(inner) => factor(graph, inner, of).map(|inner| graph.neg(inner)),
        Node::Mul(by, inner) if graph.is_prepared(by) => factor(graph, inner, of).map(|inner| graph.mul(by, inner)),
        Node::Div(inner, by) if graph.is_prepared(by) => factor(graph, inner, of).map(|inner| graph.div(inner, by)),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        differentiate::gradient,
        graph::{Part, index::Index},
    };

    #[test]
    fn a_multiple_of_its_own_momentum_has_an_inverse_mass() {
        let mut graph = Graph::default();
        let index = graph.loops.intern(Index::Literal(0));
        let element = Element { part: Part::Momentum, index, component: None };
        let p = graph.coordinate(element);
        let (square, two) = (graph.power(p, 4), graph.constant(2.0));
        let third = graph.constant(1.0 / 3.0);
        let quadratic = graph.div(square, two);
        let quadratic = graph.mul(third, quadratic);
        let of = |graph: &mut Graph, energy| {
            let gradient = gradient(graph, energy, Part::Momentum);
            inverse_masses(graph, &gradient)
        };
        let found = of(&mut graph, quadratic).expect("an inverse mass");
        assert_eq!(found.len(), 1);
        assert_eq!(graph.as_constant(found[0].value), Some(1.0 / 3.0));
        let quartic = graph.power(p, 8);
        assert_eq!(of(&mut graph, quartic), None);
        let other = graph.loops.intern(Index::Literal(1));
        let other = graph.coordinate(Element { index: other, ..element });
        let product = graph.mul(p, other);
        assert_eq!(of(&mut graph, product), None, "momenta that move each other's positions");
    }
}
