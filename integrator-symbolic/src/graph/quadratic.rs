//! Quadratic forms in positions and momenta with coefficients of parameters: their recognition, and the terms of a sum
//! that belong to them.

use super::{
    Graph, Node, NodeId, Part,
    exact::{Exact, Obstacle},
    index::LoopSet,
};
use std::collections::{HashMap, HashSet};

/// The highest degree of a quadratic form.
pub(super) const QUADRATIC: u32 = 2;

/// The parts whose coordinates count.
pub(super) const ALL: [Part; 2] = [Part::Position, Part::Momentum];

/// A quadratic form in all coordinates.
pub(super) fn quadratic(graph: &Graph, energy: NodeId) -> Result<Exact, Obstacle> {
    match graph.degree(energy, &ALL) {
        Some(degree) if degree > QUADRATIC => Err(Obstacle::Degree(degree)),
        Some(_) if graph.reads_time(energy) => Err(Obstacle::Time),
        Some(_) if graph.multiplies_sums(energy) => Err(Obstacle::ProductOfSums),
        Some(_) => Ok(Exact::Quadratic(energy)),
        None => Err(Obstacle::NoPolynomial),
    }
}

impl Graph {
    /// Whether a sum of coordinates over a loop is multiplied by what has an index of the same loop: a second derivative
    /// has two indices, which are those of one loop then.
    fn multiplies_sums(&self, root: NodeId) -> bool {
        self.multiplying_sums(root).contains(&root)
    }

    /// The nodes that have such a product, or are one.
    pub(super) fn multiplying_sums(&self, root: NodeId) -> HashSet<NodeId> {
        let mut summed = vec![LoopSet::EMPTY; root.position() + 1];
        let mut found = HashSet::new();
        for id in self.reachable([root]) {
            let node = self.node(id);
            let mut inside = node.children().fold(LoopSet::EMPTY, |all, child| all.union(summed[child.position()]));
            if let Node::Sum(by, body) = node
                && self.reads_coordinates(body)
            {
                inside = inside.union(LoopSet::of(by));
            }
            summed[id.position()] = inside;
            let meet = |a: NodeId, b: NodeId| {
                let of_b = summed[b.position()].union(self.loops_of(b));
                !summed[a.position()].intersection(of_b).is_empty()
            };
            let multiplies = match node {
                Node::Power(a, _) => !summed[a.position()].is_empty(),
                Node::Mul(a, b) if [a, b].iter().all(|side| self.reads_coordinates(*side)) => meet(a, b) || meet(b, a),
                _ => false,
            };
            if multiplies || node.children().any(|child| found.contains(&child)) {
                found.insert(id);
            }
        }
        found
    }

    /// The terms of a value that are quadratic forms, and the others, those of sums too.
    pub(crate) fn quadratic_and_rest(&mut self, energy: NodeId) -> [NodeId; 2] {
        let (degrees, time) = (self.degrees(energy, &ALL), self.reading_time([energy]));
        let is_quadratic =
            move |id: NodeId| degrees[id.position()].is_some_and(|degree| degree <= QUADRATIC) && !time.contains(&id);
        let sorted = self.sorted(energy, &is_quadratic, &mut HashMap::new());
        self.with_products_of_sums(sorted)
    }

    /// The same with products of sums moved to the others, where the first ones have no flow with them and the others have:
    /// products of positions alone, or of momenta alone.
    fn with_products_of_sums(&mut self, [quadratic, mut rest]: [NodeId; 2]) -> [NodeId; 2] {
        let products = self.multiplying_sums(quadratic);
        if products.is_empty() || self.is_shear(quadratic) {
            return [quadratic, rest];
        }
        let [kept, mut left] = self.sorted(quadratic, &|id| !products.contains(&id), &mut HashMap::new());
        for part in ALL {
            let nodes = self.reachable([left]).into_iter();
            let alone: HashSet<_> = nodes.filter(|id| !self.reads(*id, part.other())).collect();
            let [own, others] = self.sorted(left, &|id| alone.contains(&id), &mut HashMap::new());
            let more = self.add(rest, own);
            if self.is_shear(more) {
                (rest, left) = (more, others);
            }
        }
        [self.add(kept, left), rest]
    }

    /// What a value of degree one is where all coordinates are zero; nothing where it is zero there.
    pub(crate) fn at_origin(&mut self, value: NodeId) -> Option<NodeId> {
        let degrees = self.degrees(value, &ALL);
        let [constant, _] = self.sorted(value, &|id| degrees[id.position()] == Some(0), &mut HashMap::new());
        (self.as_constant(constant) != Some(0.0)).then_some(constant)
    }

    /// The terms of a value that are of one kind, and the others.
    fn sorted(
        &mut self,
        id: NodeId,
        is_first: &dyn Fn(NodeId) -> bool,
        known: &mut HashMap<NodeId, [NodeId; 2]>,
    ) -> [NodeId; 2] {
        if let Some(known) = known.get(&id) {
            return *known;
        }
        let zero = self.constant(0.0);
        let sorted = match self.node(id) {
            _ if is_first(id) => [id, zero],
            Node::Add(a, b) => {
                let [a, b] = [a, b].map(|side| self.sorted(side, is_first, known));
                [0, 1].map(|kind| self.add(a[kind], b[kind]))
            }
            Node::Neg(a) => self.sorted(a, is_first, known).map(|terms| self.neg(terms)),
            Node::Mul(factor, a) | Node::Mul(a, factor) if !self.reads_coordinates(factor) => {
                self.sorted(a, is_first, known).map(|terms| self.unless_zero(terms, |graph| graph.mul(factor, terms)))
            }
            Node::Div(a, divisor) if !self.reads_coordinates(divisor) => {
                self.sorted(a, is_first, known).map(|terms| self.unless_zero(terms, |graph| graph.div(terms, divisor)))
            }
            Node::Sum(by, body) => self.sorted(body, is_first, known).map(|terms| self.sum(by, terms)),
            Node::Select(condition, a, b) if !self.reads_coordinates(condition) => {
                let [a, b] = [a, b].map(|side| self.sorted(side, is_first, known));
                [0, 1].map(|kind| self.select(condition, a[kind], b[kind]))
            }
            _ => [zero, id],
        };
        known.insert(id, sorted);
        sorted
    }

    /// Zero, where there are no terms; else what is made of them.
    pub(super) fn unless_zero(&mut self, terms: NodeId, of: impl FnOnce(&mut Self) -> NodeId) -> NodeId {
        if self.as_constant(terms) == Some(0.0) { terms } else { of(self) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::graph::{
        Element, Part,
        index::{Index, Loop},
    };

    /// `q0`, `q1`, `p0`, `p1`.
    fn coordinates(graph: &mut Graph) -> [NodeId; 4] {
        let mut coordinate = |part, index| {
            let index = graph.loops.intern(Index::Literal(index));
            graph.coordinate(Element { part, index, component: None })
        };
        [(Part::Position, 0), (Part::Position, 1), (Part::Momentum, 0), (Part::Momentum, 1)]
            .map(|(part, index)| coordinate(part, index))
    }

    #[test]
    fn forms_are_known_by_the_degree_in_all_coordinates() {
        let mut graph = Graph::default();
        let [x, y, px, _] = coordinates(&mut graph);
        let turning = graph.mul(x, px);
        assert_eq!(quadratic(&graph, turning), Ok(Exact::Quadratic(turning)));
        let cubic = graph.mul(turning, y);
        assert_eq!(quadratic(&graph, cubic), Err(Obstacle::Degree(3)));
        let root = graph.root(turning);
        assert_eq!(quadratic(&graph, root), Err(Obstacle::NoPolynomial));
        let time = graph.time();
        let driven = graph.mul(time, turning);
        assert_eq!(quadratic(&graph, driven), Err(Obstacle::Time));
    }

    #[test]
    fn terms_are_sorted_through_factors_that_read_no_coordinate() {
        let mut graph = Graph::default();
        let [x, y, px, _] = coordinates(&mut graph);
        let (turning, square) = (graph.mul(x, px), graph.mul(y, y));
        let cubic = graph.mul(square, y);
        let terms = graph.add(cubic, turning);
        let two = graph.constant(2.0);
        let doubled = graph.mul(two, terms);
        let all = graph.sub(square, doubled);
        let [quadratic, rest] = graph.quadratic_and_rest(all);
        let (turning, cubic) = (graph.mul(two, turning), graph.mul(two, cubic));
        assert_eq!(quadratic, graph.sub(square, turning));
        assert_eq!(rest, graph.neg(cubic));
    }

    #[test]
    fn squares_of_sums_over_loops_are_with_the_rest_where_that_has_a_flow() {
        let mut graph = Graph::default();
        let bound = |graph: &mut Graph, bound| graph.loops.intern(Index::Literal(bound));
        let (from, to) = (bound(&mut graph, 0), bound(&mut graph, 5));
        let by = graph.loops.range(Loop { parent: None, from, to });
        let index = graph.loops.intern(Index::Running(by));
        let [q, p] = ALL.map(|part| graph.coordinate(Element { part, index, component: None }));
        let [square_q, square_p, quartic] = [(q, 4), (p, 4), (q, 8)].map(|(of, halves)| graph.power(of, halves));
        let energies = graph.add(square_q, square_p);
        let [oscillators, all_q, all_p, quartics] = [energies, q, p, quartic].map(|body| graph.sum(by, body));
        let [square_of_q, square_of_p] = [all_q, all_p].map(|sum| graph.power(sum, 4));
        let mixed = graph.mul(all_q, all_p);
        let mut sorted = |terms: &[NodeId]| {
            let energy = terms.iter().copied().reduce(|sum, term| graph.add(sum, term)).expect("a term");
            let [quadratic, rest] = graph.quadratic_and_rest(energy);
            (quadratic == oscillators, rest == quartics, super::quadratic(&graph, quadratic).is_ok())
        };
        assert_eq!(sorted(&[oscillators, quartics]), (true, true, true));
        assert_eq!(sorted(&[oscillators, square_of_q, quartics]), (true, false, true));
        // The rest reads q, so that it has no flow with these.
        for refused in [square_of_p, mixed] {
            assert_eq!(sorted(&[oscillators, refused, quartics]), (false, true, false));
        }
        // One of q and one of p: the first fits, the second does not.
        assert_eq!(sorted(&[oscillators, square_of_q, square_of_p, quartics]), (false, false, false));
        assert_eq!(sorted(&[oscillators, square_of_p]), (true, false, true));
    }
}
