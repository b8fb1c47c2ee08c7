//! Costs of expressions, in arithmetic operations.

use super::{Graph, Node, NodeId};
use std::{
    collections::{BTreeMap, HashMap, HashSet},
    fmt,
};

/// Operations of expressions; the body of a sum counts once, a change of sign not at all.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Cost {
    /// As often as they occur in the formulas.
    pub(crate) written: u64,
    /// Once each, shared ones too.
    pub(crate) shared: u64,
}

/// Numbers of operations by kind; a change of sign does not count, and a fused multiply-add is a multiplication and an addition.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Tally {
    /// Additions and subtractions.
    pub additions: u64,
    /// Multiplications, including those of integer powers.
    pub multiplications: u64,
    /// Divisions by values that are not known before the run; all other divisions count as multiplications.
    pub divisions: u64,
    /// Square roots.
    pub roots: u64,
    /// Elementary functions and methods of the user, by name.
    pub functions: BTreeMap<String, u64>,
    /// Selections of a value in the lanes in which a condition holds.
    pub branches: u64,
    /// Additions to coordinates, or to their components of the gradient. The multiplication by the step belongs to these.
    pub coordinates: u64,
}

impl Tally {
    /// Adds other operations.
    pub(crate) fn add(&mut self, other: Self) {
        self.additions += other.additions;
        self.multiplications += other.multiplications;
        self.divisions += other.divisions;
        self.roots += other.roots;
        for (name, count) in other.functions {
            *self.functions.entry(name).or_default() += count;
        }
        self.branches += other.branches;
        self.coordinates += other.coordinates;
    }
}

impl fmt::Display for Tally {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kinds = [
            (self.additions, "addition", "additions"),
            (self.multiplications, "multiplication", "multiplications"),
            (self.divisions, "division", "divisions"),
            (self.roots, "square root", "square roots"),
        ];
        let counted = |(count, one, many): (u64, &str, &str)| match count {
            0 => None,
            1 => Some(format!("1 {one}")),
            _ => Some(format!("{count} {many}")),
        };
        let functions = self.functions.iter().map(|(name, count)| format!("{count} {name}"));
        let others =
            [(self.branches, "branch", "branches"), (self.coordinates, "coordinate moved", "coordinates moved")];
        let all = kinds.into_iter().filter_map(counted).chain(functions).chain(others.into_iter().filter_map(counted));
        formatter.write_str(&all.collect::<Vec<_>>().join(", "))
    }
}

impl Graph {
    /// The cost of `roots` per evaluation of a flow, without what depends on parameters alone.
    pub(crate) fn cost(&self, roots: &[NodeId]) -> Cost {
        let mut written: HashMap<NodeId, u64> = HashMap::new();
        let mut shared = 0;
        for id in self.reachable(roots.iter().copied()) {
            let total = if self.is_prepared(id) {
                0
            } else {
                let own = u64::from(self.node(id).is_operation());
                shared += own;
                self.node(id).children().map(|child| written[&child]).fold(own, u64::saturating_add)
            };
            written.insert(id, total);
        }
        let written = roots.iter().map(|root| written[root]).fold(0, u64::saturating_add);
        Cost { written, shared }
    }

    /// The operations of `roots` per evaluation of a flow, shared ones once, with those that powers are made of.
    pub(crate) fn operations(&self, roots: impl IntoIterator<Item = NodeId>) -> usize {
        let mut seen = HashSet::new();
        let mut open: Vec<NodeId> = roots.into_iter().collect();
        let mut powers = HashSet::new();
        let mut others = 0;
        while let Some(id) = open.pop() {
            // A table over two loops is only made where the user has one.
            let is_table = self.is_prepared(id) && self.loops_of(id).iter().count() <= 1;
            if is_table || !seen.insert(id) {
                continue;
            }
            match self.node(id) {
                Node::Power(base, halves) => {
                    powers.extend(powers_below(halves.unsigned_abs()).map(|halves| (base, halves)));
                    others += usize::from(halves < 0);
                }
                node => others += usize::from(node.is_operation()),
            }
            open.extend(self.node(id).children());
        }
        powers.len() + others
    }
}

/// The powers that one is the product of, itself among them, by twice their exponents: that of one is read, and others are squares
/// or one factor more; a root is multiplied by what is whole.
fn powers_below(halves: u32) -> impl Iterator<Item = u32> {
    let root = (halves % 2 == 1 && halves > 1).then_some(1);
    let next = |halves: &u32| match halves {
        0..=2 => None,
        odd if odd % 2 == 1 => Some(odd - 1),
        halves if halves % 4 == 0 => Some(halves / 2),
        halves => Some(halves - 2),
    };
    std::iter::successors(Some(halves), next).filter(|halves| *halves != 2).chain(root)
}

impl Node {
    fn is_operation(self) -> bool {
        self.children().next().is_some() && !matches!(self, Node::Neg(_))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::graph::{Element, Part, index::Index};

    #[test]
    fn powers_are_made_of_squares_and_factors() {
        // Roots, then x^1.5, x^2, x^3, x^5, x^8.
        for (halves, products) in [(1, 1), (3, 2), (4, 1), (6, 2), (10, 3), (16, 3)] {
            assert_eq!(powers_below(halves).count(), products, "{halves} halves");
        }
    }

    #[test]
    fn shared_nodes_count_once() {
        let mut graph = Graph::default();
        let index = graph.loops.intern(Index::Literal(0));
        let q = graph.coordinate(Element { part: Part::Position, index, component: None });
        let sine = graph.call("sin", q);
        let square = graph.times(sine, sine);
        let sum = graph.add(square, sine);
        // sin(q) sin(q) + sin(q): three sines, a product and a sum; one sine is enough.
        assert_eq!(graph.cost(&[sum]), Cost { written: 5, shared: 3 });
    }
}
