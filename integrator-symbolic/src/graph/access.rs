//! Access by indices: whether a value can be read at a place where the user's code does not read it.

use super::{
    Graph, Node, NodeId, Scope,
    index::{DEEPEST, Index, IndexId, Loop, LoopId, LoopSet, Loops},
};

/// Where the reads of a value are in bounds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Access {
    /// Everywhere: its reads are always in bounds.
    #[default]
    Anywhere,
    /// What it reads is there in all iterations of the loops whose indices it reads by, unless these are compared with
    /// a length.
    ByRunning,
    /// What it reads is there where the conditions hold that are around it. Without conditions, every start has it
    /// ([`Graph::least_length`]).
    InBranches,
    /// What it reads is there where something is computed by it: in an iteration of the loops around it, where the
    /// conditions on integers hold that are around it.
    InIterations,
    /// Its indices are computed, and may be out of bounds where a loop further in has no iteration, too.
    WhereWritten,
}

impl Loops {
    /// The access of a coordinate with this index.
    fn access(&self, id: IndexId) -> Access {
        match self.index(id) {
            Index::InPlane(row, site) => self.access(row).max(self.access(site)),
            _ if self.is_guarded(id) => Access::WhereWritten,
            // The bound of such an index was compared with the length when it was read.
            _ if self.has_known_extents() && self.is_of_numbers(id) => Access::Anywhere,
            Index::Running(by) if self.passes_the_end(by) => Access::WhereWritten,
            Index::Running(_) => Access::ByRunning,
            Index::Literal(_) => Access::InBranches,
            Index::Length | Index::Parameter(_) => Access::InIterations,
            // An iteration of a loop over the coordinates has coordinates.
            Index::Rem(place, size)
                if self.is_extent(size)
                    && !self.of_index(place).is_empty()
                    && self.computes(place) == Access::Anywhere =>
            {
                Access::ByRunning
            }
            Index::Rem(..) if self.computes(id) == Access::Anywhere => Access::InIterations,
            _ if self.stays_within(id) => Access::ByRunning,
            _ => Access::WhereWritten,
        }
    }

    /// Whether a loop ends where the coordinates do, or before.
    pub(super) fn ends_within(&self, by: LoopId) -> bool {
        let Some(length) = self.extents().next() else { return false };
        let to = self.get(by).to;
        let is_shorter = matches!(self.index(to), Index::Sub(end, _) | Index::Monus(end, _) if end == length);
        is_shorter || self.is_at_most(to, length, DEEPEST)
    }

    /// Whether an index plus or minus a number has a coordinate in all iterations of its loop, which ends or begins by as
    /// much before the ends of the coordinates.
    fn stays_within(&self, id: IndexId) -> bool {
        let Some([index, by]) = self.index(id).operands() else { return false };
        let (Index::Running(of), Some(by)) = (self.index(index), self.literal(by)) else { return false };
        let Loop { from, to, .. } = self.get(of);
        match self.index(id) {
            Index::Add(..) => self.ends_before(to, by),
            Index::Sub(..) => {
                let begins = self.literal(from).is_some_and(|from| by <= from);
                begins && self.extents().any(|extent| self.is_at_most(to, extent, DEEPEST))
            }
            _ => false,
        }
    }

    /// Whether the end of a loop is at least as far before that of the coordinates.
    fn ends_before(&self, to: IndexId, by: u64) -> bool {
        match self.index(to) {
            Index::Sub(end, less) | Index::Monus(end, less) => {
                self.is_extent(end) && self.literal(less).is_some_and(|less| by <= less)
            }
            Index::Min(a, b) => self.ends_before(a, by) || self.ends_before(b, by),
            // Constants of the user: `0..N` in `[f64; N + 1]`.
            _ => self.extents().any(|extent| {
                let Index::Add(end, more) = self.index(extent) else { return false };
                end == to && self.literal(more).is_some_and(|more| by <= more)
            }),
        }
    }

    /// Whether the last iterations of a loop may have no coordinate, as those of `0..=q.len()`.
    fn passes_the_end(&self, by: LoopId) -> bool {
        let to = self.get(by).to;
        let is_of_extents =
            matches!(self.index(to), Index::Add(a, b) if [a, b].iter().any(|part| self.is_extent(*part)));
        is_of_extents && !self.extents().any(|extent| self.is_at_most(to, extent, DEEPEST))
    }

    /// Whether a loop ends where coordinates or a list of the system do, or before.
    pub(crate) fn is_bounded_by_lists(&self, by: LoopId) -> bool {
        let to = self.get(by).to;
        let is_outer = |id| matches!(self.index(id), Index::Running(outer) if self.is_bounded_by_lists(outer));
        let is_index = match self.index(to) {
            Index::Add(index, one) => self.literal(one) == Some(1) && is_outer(index),
            _ => is_outer(to),
        };
        is_index || self.mentions_lists(to) || self.extents().any(|extent| self.is_at_most(to, extent, DEEPEST))
    }

    /// Whether a comparison may keep an index from being too large; indices of loops are compared to tell bodies apart,
    /// and with a number on their left to leave out the first ones.
    pub(crate) fn bounds_from_above(&self, a: IndexId, b: IndexId) -> bool {
        let is_running = |id| matches!(self.index(id), Index::Running(_));
        !(is_running(b) && (is_running(a) || self.literal(a).is_some()))
    }

    /// Whether an integer is made of numbers, and of indices between numbers, without differences.
    fn is_of_numbers(&self, id: IndexId) -> bool {
        match self.index(id) {
            Index::Literal(_) => true,
            Index::Running(by) => self.is_of_numbers(self.get(by).to),
            Index::Add(a, b) | Index::Mul(a, b) => self.is_of_numbers(a) && self.is_of_numbers(b),
            _ => false,
        }
    }

    /// The access of an integer: a difference may be below zero, and nothing is divided by zero.
    fn computes(&self, id: IndexId) -> Access {
        match self.index(id) {
            Index::Literal(_) | Index::Length | Index::Running(_) | Index::Parameter(_) => Access::Anywhere,
            Index::Add(a, b) | Index::Mul(a, b) | Index::Monus(a, b) | Index::Min(a, b) | Index::InPlane(a, b) => {
                self.computes(a).max(self.computes(b))
            }
            Index::Div(a, b) | Index::Rem(a, b) if self.is_positive(b) => self.computes(a),
            _ => Access::WhereWritten,
        }
    }

    /// Whether an integer is a number, but not zero, or counts coordinates.
    fn is_positive(&self, id: IndexId) -> bool {
        self.literal(id).map_or_else(|| self.is_extent(id), |number| number > 0)
    }
}

impl Graph {
    /// The access of a node, with all that it is computed from.
    pub(crate) fn access(&self, id: NodeId) -> Access {
        self.facts[id.position()].access
    }

    /// The access of a node beside that of its children.
    pub(super) fn own_access(&self, node: Node) -> Access {
        match node {
            Node::Coordinate(element) => {
                // The number of components of a point is known.
                let computed = |index: &IndexId| *index == element.index || self.loops.literal(*index).is_none();
                let indices = self.loops.of_coordinate(element).filter(computed);
                indices.map(|index| self.loops.access(index)).max().unwrap_or_default()
            }
            Node::FromIndex(index) => self.loops.computes(index),
            Node::CompareIndex(_, a, b) => self.loops.computes(a).max(self.loops.computes(b)),
            // A method of the user may read anything.
            Node::External(..) => Access::InIterations,
            _ => Access::Anywhere,
        }
    }

    /// The number of coordinates, points or planes that every start must have: one more than the largest number that is an
    /// index in these nodes. An index under a condition does not count; one in a loop does, even if the loop has no iteration.
    pub(crate) fn least_length(&self, roots: impl IntoIterator<Item = NodeId>) -> u64 {
        let mut open: Vec<NodeId> = roots.into_iter().collect();
        let (mut seen, mut least) = (vec![false; self.len()], 0);
        while let Some(id) = open.pop() {
            if std::mem::replace(&mut seen[id.position()], true) {
                continue;
            }
            match self.node(id) {
                Node::Coordinate(element) => {
                    least = least.max(self.loops.literal(element.index).map_or(0, |index| index.saturating_add(1)));
                }
                Node::Select(condition, ..) | Node::And(condition, _) | Node::Or(condition, _)
                    if self.bears_on(condition, Access::InBranches) =>
                {
                    open.push(condition);
                }
                node => open.extend(node.children()),
            }
        }
        least
    }

    /// Whether something around a place may decide that what a node reads is there.
    pub(crate) fn protects(&self, around: Scope, id: NodeId) -> bool {
        self.protects_reads(around, self.access(id))
    }

    /// The same of a node whose sums have been computed.
    pub(crate) fn protects_beside_sums(&self, around: Scope, id: NodeId) -> bool {
        self.protects_reads(around, self.facts[id.position()].beside_sums)
    }

    fn protects_reads(&self, around: Scope, access: Access) -> bool {
        match (around, access) {
            (_, Access::Anywhere) => false,
            (Scope::Loop(by), access) => access >= Access::InIterations && !self.loops.always_has_iterations(by),
            (Scope::Branch(condition, _), access) => self.bears_on(condition, access),
        }
    }

    /// The loops in all of whose iterations alone a node is read that is not read anywhere, given what its children
    /// say: what stands after a condition that protects it stays there.
    pub(super) fn read_in(&self, node: Node, own: LoopSet) -> LoopSet {
        let is_behind = |child: NodeId| match node {
            Node::Select(condition, ..) if child != condition => self.protects(Scope::Branch(condition, true), child),
            _ => false,
        };
        let of_itself = if self.own_access(node) >= Access::InIterations { own } else { LoopSet::ALL };
        let children = node.children().filter(|child| !is_behind(*child));
        children.fold(of_itself, |all, child| all.intersection(self.facts[child.position()].read_in))
    }

    /// Whether a loop that may be empty keeps something from being read that is the same in all of its iterations.
    pub(crate) fn is_kept_by_iterations(&self, by: LoopId, body: NodeId) -> bool {
        self.protects(Scope::Loop(by), body) && !self.facts[body.position()].read_in.contains(by)
    }

    /// Whether a condition may decide that what is read with an access is there. For what is read by the index of a loop, that is
    /// a condition on integers; for what is read by a number, any condition.
    fn bears_on(&self, condition: NodeId, access: Access) -> bool {
        match self.node(condition) {
            Node::CompareIndex(_, a, b) => access == Access::WhereWritten || self.loops.bounds_from_above(a, b),
            Node::Flag(_) => access >= Access::InBranches,
            Node::And(a, b) | Node::Or(a, b) => self.bears_on(a, access) || self.bears_on(b, access),
            Node::Not(a) => self.bears_on(a, access),
            Node::Compare(_, _, count) => match self.node(count) {
                // The comparison by which a loop tests whether it has iterations.
                Node::Sum(_, body) => self.bears_on(body, access),
                _ => access >= Access::InBranches,
            },
            Node::Select(condition, ..) => self.bears_on(condition, access),
            _ => false,
        }
    }
}
