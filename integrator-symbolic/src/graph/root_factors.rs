//! Factors of products that are square roots of sums which may be zero. Such a root has an infinite slope at zero. A
//! product that contains it twice does not: `r z r` is `r² z`, and `(r z)²` is the same, without the root.

use super::{Graph, Node, NodeId};

/// How many factors are looked at for those of one root, so that the search takes no longer where factors are shared.
const LOOKED_AT: usize = 64;

impl Graph {
    /// reassociating: (x r^a)(y r^b) == x r^(a+b) y, where `r` is a root that may be zero.
    pub(super) fn with_roots_collected(&mut self, a: NodeId, b: NodeId) -> Option<NodeId> {
        self.collected(a, b, &mut { LOOKED_AT })
    }

    fn collected(&mut self, product: NodeId, other: NodeId, left: &mut usize) -> Option<NodeId> {
        *left = left.checked_sub(1)?;
        match self.node(other) {
            Node::Mul(a, b) => {
                let (product, rest) = match self.collected(product, b, left) {
                    Some(product) => (product, a),
                    None => (self.collected(product, a, left)?, b),
                };
                Some(self.mul(product, rest))
            }
            Node::Div(a, b) => {
                let product = self.collected(product, a, left)?;
                Some(self.div(product, b))
            }
            Node::Neg(a) => {
                let product = self.collected(product, a, left)?;
                Some(self.neg(product))
            }
            _ if self.may_belong_to_root(other) => self.absorbed(product, other, left),
            _ => None,
        }
    }

    /// reassociating: (x r)^n == x^n r^n for whole n from 2 on, where `r` is a root that may be zero.
    pub(super) fn power_of_roots(&mut self, base: NodeId, halves: i32) -> Option<NodeId> {
        let (Node::Mul(a, b) | Node::Div(a, b)) = self.node(base) else { return None };
        if halves < 4 || halves % 2 != 0 || !self.has_root(base, &mut { LOOKED_AT }) {
            return None;
        }
        let is_product = matches!(self.node(base), Node::Mul(..));
        let [a, b] = [a, b].map(|id| self.power(id, halves));
        Some(if is_product { self.mul(a, b) } else { self.div(a, b) })
    }

    /// A product that has taken up a factor into a power of the same root, if it has one.
    fn absorbed(&mut self, product: NodeId, factor: NodeId, left: &mut usize) -> Option<NodeId> {
        *left = left.checked_sub(1)?;
        if let Some(power) = self.power_of_root(product, factor) {
            return Some(power);
        }
        match self.node(product) {
            Node::Mul(a, b) => match self.absorbed(b, factor, left) {
                Some(b) => Some(self.mul(a, b)),
                None => {
                    let a = self.absorbed(a, factor, left)?;
                    Some(self.mul(a, b))
                }
            },
            Node::Div(a, b) => {
                let a = self.absorbed(a, factor, left)?;
                Some(self.div(a, b))
            }
            Node::Neg(a) => {
                let a = self.absorbed(a, factor, left)?;
                Some(self.neg(a))
            }
            _ => None,
        }
    }

    /// The product of two powers of a root that may be zero.
    fn power_of_root(&mut self, a: NodeId, b: NodeId) -> Option<NodeId> {
        if !self.is_root(a) && !self.is_root(b) {
            return None;
        }
        let [(base, first), (other, second)] = [a, b].map(|id| self.radicand(id));
        let base = match (self.is_distance(base), self.is_distance(other)) {
            (false, true) if self.is_square_of(base, other) => base,
            (true, false) if self.is_square_of(other, base) => other,
            (true, true) if base == other => self.power(base, 4),
            (false, false) if base == other => base,
            _ => return None,
        };
        Some(self.power(base, first.checked_add(second).filter(|_| first > 0 && second > 0)?))
    }

    /// Whether a factor is a root that may be zero, or may be what is under one.
    fn may_belong_to_root(&self, id: NodeId) -> bool {
        self.is_root(id) || matches!(self.node(self.radicand(id).0), Node::Add(..) | Node::Sum(..))
    }

    /// Whether a product has a factor that is a root which may be zero.
    fn has_root(&self, id: NodeId, left: &mut usize) -> bool {
        let Some(others) = left.checked_sub(1) else { return false };
        *left = others;
        match self.node(id) {
            Node::Mul(a, b) => self.has_root(b, left) || self.has_root(a, left),
            Node::Neg(a) | Node::Div(a, _) => self.has_root(a, left),
            _ => self.is_root(id),
        }
    }

    /// Whether a value is an odd power of a root that may be zero wherever the coordinates are.
    fn is_root(&self, id: NodeId) -> bool {
        let (radicand, halves) = self.radicand(id);
        halves % 2 != 0
            && halves > 0
            && !self.is_prepared(radicand)
            && (self.is_distance(radicand) || self.is_never_negative(radicand) && self.may_be_zero(radicand))
    }

    /// What is under a root, and twice its exponent; a distance stands for the square of itself.
    fn radicand(&self, id: NodeId) -> (NodeId, i32) {
        match self.node(id) {
            Node::Power(base, halves) if !self.is_distance(base) => (base, halves),
            _ if self.is_distance(id) => (id, 1),
            _ => (id, 2),
        }
    }

    fn is_distance(&self, id: NodeId) -> bool {
        matches!(self.node(id), Node::Binary(function, ..) if function.is_distance())
    }

    /// Whether a value is the square of a length, as powers have it.
    fn is_square_of(&self, square: NodeId, length: NodeId) -> bool {
        match (self.node(square), self.node(length)) {
            (Node::Add(a, b), Node::Binary(function, x, y)) if function.is_distance() => {
                let are = |a, b| self.is_square_of(a, x) && self.is_square_of(b, y);
                are(a, b) || are(b, a)
            }
            (Node::Power(base, 4), _) => base == self.without_sign(length),
            (_, Node::Power(base, 1)) => base == square,
            _ => false,
        }
    }

    /// Whether the sum under a root may be zero: no addend is a number or a parameter, which is not zero where others are masked.
    pub(crate) fn may_be_zero(&self, id: NodeId) -> bool {
        !self.is_positive(id) && !self.has_prepared_addend(id)
    }

    fn has_prepared_addend(&self, id: NodeId) -> bool {
        match self.node(id) {
            Node::Add(a, b) => {
                [a, b].into_iter().any(|addend| self.is_prepared(addend) || self.has_prepared_addend(addend))
            }
            _ => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        differentiate::gradient,
        graph::{Element, ParameterId, Part, evaluate::Point, index::Index},
    };

    /// Numbers that look random and are the same everywhere.
    struct Random(u64);

    impl Random {
        fn below(&mut self, count: usize) -> usize {
            self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (self.0 >> 33) as usize % count
        }

        /// A product of values in any order, bracketed in any way, where it is divided or negated now and then.
        fn product(&mut self, graph: &mut Graph, mut factors: Vec<NodeId>) -> NodeId {
            while factors.len() > 1 {
                let [a, b] = [0; 2].map(|_| factors.swap_remove(self.below(factors.len())));
                let product = graph.mul(a, b);
                let three = graph.constant(3.0);
                factors.push(match self.below(6) {
                    0 => graph.div(product, three),
                    1 => graph.neg(product),
                    _ => product,
                });
            }
            factors[0]
        }
    }

    /// A product in which a root stands twice has the slope zero where the root is zero, whatever stands between them.
    #[test]
    fn a_root_that_stands_twice_in_a_product_has_no_infinite_slope() {
        let mut random = Random(1);
        for case in 0..2_000 {
            let mut graph = Graph::default();
            let [x, y] = [0, 1].map(|position| {
                let index = graph.loops.intern(Index::Literal(position));
                graph.coordinate(Element { part: Part::Position, index, component: None })
            });
            let [xx, yy] = [x, y].map(|x| graph.power(x, 4));
            let square = graph.add(xx, yy);
            let root = if case % 2 == 0 { graph.power(square, 1) } else { graph.call_two("hypot", y, x) };
            let cosine = graph.call("cos", x);
            let two = graph.constant(2.0);
            let sum = graph.add(y, two);
            let reciprocal = graph.power(sum, -2);
            let others = [square, graph.parameter(ParameterId(0)), cosine, sum, reciprocal, root, two];
            // A power of a product that has the root once, or a product that has it twice.
            let (mut factors, halves) = match random.below(4) {
                0 => (vec![root], 4),
                1 => (vec![root], 6),
                2 => (vec![root, root], 2),
                _ => (vec![root, square], 2),
            };
            factors.extend((0..random.below(5)).map(|_| others[random.below(others.len())]));
            let product = random.product(&mut graph, factors);
            let product = graph.power(product, halves);
            for contribution in gradient(&mut graph, product, Part::Position) {
                let mut point = Point { parameters: &[1.5], ..Point::new(&[0.0; 2], &[]) };
                let slope = point.value(&graph, contribution.value);
                assert_eq!(slope, 0.0, "case {case}");
            }
        }
    }
}
