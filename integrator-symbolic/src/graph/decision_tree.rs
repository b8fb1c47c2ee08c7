//! Balanced decision trees: for a function of `n` pieces, `log₂ n` conditions find the piece, and branches are nested
//! at most as deep.

use super::{Comparison, Graph, Node, NodeId, access::Access};
use std::collections::HashSet;

/// The number of conditions in a row from which a choice is balanced.
const LONG: usize = 8;

/// A choice between several values: the first one whose condition holds, else the last.
#[derive(Clone)]
struct Cases {
    conditions: Vec<NodeId>,
    /// The values, one more than conditions.
    values: Vec<NodeId>,
}

impl Graph {
    /// Makes long choices of the roots balanced: the first condition is whether one of the first half holds.
    pub(crate) fn balance_choices(&mut self, roots: [NodeId; 2]) -> [NodeId; 2] {
        let reachable = self.reachable(roots);
        let mut uses = vec![0_u32; self.len()];
        for id in reachable.iter().flat_map(|id| self.node(*id).children()).chain(roots) {
            uses[id.position()] += 1;
        }
        let mut inside = vec![false; self.len()];
        let mut long: Vec<Option<Cases>> = vec![None; self.len()];
        for id in reachable.iter().rev().filter(|id| matches!(self.node(**id), Node::Select(..))) {
            if !inside[id.position()] {
                let (cases, inner) = self.cases(*id, &uses);
                if self.may_be_halved(&cases) {
                    inner.iter().for_each(|inner| inside[inner.position()] = true);
                    long[id.position()] = Some(cases);
                }
            }
        }
        if long.iter().all(Option::is_none) {
            return roots;
        }
        let mut same: Vec<NodeId> = (0..self.len() as u32).map(NodeId).collect();
        for id in reachable.into_iter().filter(|id| !inside[id.position()]) {
            let of = |id: NodeId| same[id.position()];
            same[id.position()] = match &long[id.position()] {
                Some(Cases { conditions, values }) => {
                    let [conditions, values] = [conditions, values].map(|ids| ids.iter().map(|id| of(*id)).collect());
                    let cases = Cases { conditions, values };
                    self.first_that_holds(&cases, 0, cases.conditions.len())
                }
                None => self.rebuilt(self.node(id).map(of)),
            };
        }
        roots.map(|root| same[root.position()])
    }

    /// The cases of a choice, with those of the choices that nothing but it uses; and these.
    fn cases(&self, id: NodeId, uses: &[u32]) -> (Cases, Vec<NodeId>) {
        let mut cases = Cases { conditions: Vec::new(), values: Vec::new() };
        let (mut inner, mut last) = (Vec::new(), id);
        while let Node::Select(condition, value, otherwise) = self.node(last)
            && (last == id || uses[last.position()] == 1)
        {
            inner.extend((last != id).then_some(last));
            cases.conditions.push(condition);
            cases.values.push(value);
            last = otherwise;
        }
        cases.values.push(last);
        (cases, inner)
    }

    /// Whether a choice is long, and no condition decides whether another one can be evaluated: the first one has read
    /// all that the others read and that need not be there.
    fn may_be_halved(&self, Cases { conditions, .. }: &Cases) -> bool {
        let (first, others) = match &conditions[..] {
            [first, others @ ..] if others.len() >= LONG => (first, others),
            _ => return false,
        };
        let mut seen = HashSet::new();
        self.reads_where_written(&[*first], &mut seen);
        !self.reads_where_written(others, &mut seen)
    }

    /// Whether nodes that are not `seen` yet read something that need not be there.
    fn reads_where_written(&self, ids: &[NodeId], seen: &mut HashSet<NodeId>) -> bool {
        let (mut open, mut reads) = (ids.to_vec(), false);
        while let Some(id) = open.pop() {
            if self.access(id) != Access::Anywhere && seen.insert(id) {
                reads |= self.own_access(self.node(id)) != Access::Anywhere;
                open.extend(self.node(id).children());
            }
        }
        reads
    }

    /// The choice between the cases of the conditions `from..to` and the one after them.
    fn first_that_holds(&mut self, cases: &Cases, from: usize, to: usize) -> NodeId {
        if from == to {
            return cases.values[from];
        }
        let middle = (from + to) / 2;
        let condition = self.any_of(&cases.conditions, from, middle);
        let first = self.first_that_holds(cases, from, middle);
        let second = self.first_that_holds(cases, middle + 1, to);
        self.rebuilt(Node::Select(condition, first, second))
    }

    /// Whether one of the conditions from `first` to `last` holds, in the order of [`Graph::first_that_holds`].
    fn any_of(&mut self, conditions: &[NodeId], first: usize, last: usize) -> NodeId {
        if first == last {
            return conditions[first];
        }
        let middle = (first + last) / 2;
        let (a, b) = (self.any_of(conditions, first, middle), self.any_of(conditions, middle + 1, last));
        self.or(a, b)
    }

    /// The condition that one of two holds, where both compare the same value with numbers.
    ///
    /// exact: x < a or x < b == x < max(a, b), for a NaN too
    pub(super) fn either_bound(&self, a: NodeId, b: NodeId) -> Option<NodeId> {
        let bounds = |id| match self.node(id) {
            Node::Compare(Comparison::Equal, ..) => None,
            Node::Compare(comparison, left, right) => match self.as_constant(right) {
                Some(bound) => Some((comparison, left, true, bound)),
                None => Some((comparison, right, false, self.as_constant(left)?)),
            },
            _ => None,
        };
        let ((kind, x, is_upper, first), (other, y, is_other_upper, second)) = (bounds(a)?, bounds(b)?);
        let same = kind == other && x == y && is_upper == is_other_upper;
        let a_is_wider = if is_upper { first >= second } else { first <= second };
        let b_is_wider = if is_upper { second >= first } else { second <= first };
        match (same, a_is_wider, b_is_wider) {
            (true, true, _) => Some(a),
            (true, _, true) => Some(b),
            _ => None,
        }
    }
}
