//! The term of a part that prevents an exact flow.

use super::{
    Graph, Node, NodeId,
    exact::Obstacle,
    quadratic::{ALL, QUADRATIC, quadratic},
    shift::{Unshifted, shifted},
};
use std::collections::HashSet;

impl Graph {
    /// The term that keeps an energy from having an exact flow, if one does: the values that are this term or have it in
    /// them, from the outside inwards. The energy itself is none of them.
    ///
    /// That is what keeps it from being of the last form that was tried; and if several terms do so, what has no exact
    /// flow by itself.
    pub(crate) fn in_the_way(&mut self, energy: NodeId, obstacles: &[Obstacle]) -> Vec<NodeId> {
        let is_form = |obstacle: &&Obstacle| {
            !matches!(obstacle, Obstacle::Shift(Unshifted::Moved(..) | Unshifted::Conjugates(..)))
        };
        let of_form = obstacles.iter().rfind(is_form);
        let of_form = of_form.map(|obstacle| self.around(energy, &self.against(energy, obstacle)));
        match of_form {
            Some(path) if !path.is_empty() => path,
            _ => {
                let terms = self.terms_of(energy);
                let unsolved: HashSet<NodeId> =
                    terms.into_iter().filter(|term| self.is_mixed(*term) && !self.is_solved(*term)).collect();
                self.around(energy, &|term| unsolved.contains(&term))
            }
        }
    }

    /// Whether a term is against an energy being of the form that it is not of.
    fn against<'o>(&'o self, energy: NodeId, obstacle: &'o Obstacle) -> Box<dyn Fn(NodeId) -> bool + 'o> {
        match obstacle {
            Obstacle::Conjugates(..) | Obstacle::Shift(Unshifted::Moved(..) | Unshifted::Conjugates(..)) => {
                Box::new(|_| false)
            }
            Obstacle::Shift(Unshifted::Antiderivative(_, integrand)) => {
                Box::new(|term| self.mentions(term, &[*integrand]))
            }
            Obstacle::Degree(_) | Obstacle::NoPolynomial => {
                let degrees = self.degrees(energy, &ALL);
                Box::new(move |term| degrees[term.position()].is_none_or(|degree| degree > QUADRATIC))
            }
            Obstacle::Time => {
                let time = self.reading_time([energy]);
                Box::new(move |term| time.contains(&term))
            }
            Obstacle::ProductOfSums => {
                let products = self.multiplying_sums(energy);
                Box::new(move |term| products.contains(&term))
            }
            Obstacle::Orbits(_, strays) => Box::new(|term| strays.contains(&term)),
        }
    }

    /// Whether a value of positions and momenta has an exact flow by itself.
    fn is_solved(&mut self, term: NodeId) -> bool {
        self.is_shear(term) || quadratic(self, term).is_ok() || shifted(self, term).is_ok()
    }

    /// The values inside of an energy that all of its terms of one kind are in, from the outside inwards.
    fn around(&self, energy: NodeId, is_meant: &dyn Fn(NodeId) -> bool) -> Vec<NodeId> {
        // Children come before their parents.
        let mut has_some = vec![false; energy.position() + 1];
        for id in self.reachable([energy]) {
            has_some[id.position()] = match self.summands(id) {
                [None, _] => is_meant(id),
                inner => inner.into_iter().flatten().any(|inner| has_some[inner.position()]),
            };
        }
        let mut path = vec![energy];
        while let Some(last) = path.last() {
            let mut inside = self.summands(*last).into_iter().flatten().filter(|inner| has_some[inner.position()]);
            match [inside.next(), inside.next()] {
                [Some(only), None] => path.push(only),
                _ => break,
            }
        }
        path.split_off(1)
    }

    /// The terms that an energy is the sum of, each once.
    fn terms_of(&self, energy: NodeId) -> Vec<NodeId> {
        let (mut open, mut seen, mut terms) = (vec![energy], HashSet::new(), Vec::new());
        while let Some(id) = open.pop() {
            match self.summands(id) {
                _ if !seen.insert(id) => {}
                [None, _] => terms.push(id),
                inner => open.extend(inner.into_iter().flatten()),
            }
        }
        terms
    }

    /// What a value is the sum of, or the one thing that it is a multiple of; nothing of a term.
    fn summands(&self, id: NodeId) -> [Option<NodeId>; 2] {
        match self.node(id) {
            Node::Add(a, b) => [Some(a), Some(b)],
            Node::Select(condition, a, b) if !self.reads_coordinates(condition) => [Some(a), Some(b)],
            Node::Neg(a) | Node::Sum(_, a) => [Some(a), None],
            Node::Mul(factor, a) | Node::Mul(a, factor) if self.is_prepared(factor) => [Some(a), None],
            Node::Div(a, divisor) if self.is_prepared(divisor) => [Some(a), None],
            _ => [None, None],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::graph::{Element, Part, index::Index};

    /// The innermost value that stands in the way of a sum of terms.
    fn innermost(graph: &mut Graph, terms: &[NodeId]) -> Option<NodeId> {
        let energy = terms.iter().copied().reduce(|sum, term| graph.add(sum, term)).expect("a term");
        let extent = graph.loops.intern(Index::Literal(2));
        let obstacles = graph.exact(energy, &[extent], &|_| Vec::new()).expect_err("an obstacle");
        graph.in_the_way(energy, &obstacles).last().copied()
    }

    #[test]
    fn one_term_is_in_the_way_or_none() {
        let mut graph = Graph::default();
        let mut coordinate = |part, index| {
            let index = graph.loops.intern(Index::Literal(index));
            graph.coordinate(Element { part, index, component: None })
        };
        let [x, y] = [0, 1].map(|index| coordinate(Part::Position, index));
        let [px, py] = [0, 1].map(|index| coordinate(Part::Momentum, index));
        let [xx, yy, square_x, square_y] = [x, y, px, py].map(|of| graph.power(of, 4));
        let [quartic, quartic_p] = [x, px].map(|of| graph.power(of, 8));
        let mixed = graph.mul(xx, px);
        // What is no quadratic form, whatever the others are.
        assert_eq!(innermost(&mut graph, &[square_x, xx, quartic]), Some(quartic));
        // Two that are none, of which one has no flow alone.
        assert_eq!(innermost(&mut graph, &[square_x, quartic, mixed]), Some(mixed));
        // Two that have flows, but not together.
        assert_eq!(innermost(&mut graph, &[quartic, quartic_p]), None);
        // A term is not in its own way.
        assert_eq!(innermost(&mut graph, &[mixed]), None);
        // Two in one pair of parentheses.
        let (both, two) = (graph.add(quartic, quartic_p), graph.constant(2.0));
        let doubled = graph.mul(two, both);
        assert_eq!(innermost(&mut graph, &[square_x, xx, doubled]), Some(both));
        // Next to an orbit.
        let distance = graph.add(xx, yy);
        let attraction = graph.power(distance, -1);
        let attraction = graph.neg(attraction);
        assert_eq!(innermost(&mut graph, &[square_x, square_y, attraction, quartic]), Some(quartic));
        let time = graph.time();
        let driven = graph.mul(time, x);
        assert_eq!(innermost(&mut graph, &[square_x, xx, driven]), Some(driven));
    }
}
