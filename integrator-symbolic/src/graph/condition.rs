//! Conditions, and the choice between two values.

use super::{
    Comparison, Graph, Node, NodeId, ParameterId, Scope,
    function::HUGE,
    index::{Index, IndexId, Loop, LoopId},
};
use std::collections::HashSet;

impl Graph {
    /// A condition that always holds, or never.
    pub(crate) fn truth(&mut self, holds: bool) -> NodeId {
        let zero = self.loops.intern(Index::Literal(0));
        let always = self.intern(Node::CompareIndex(Comparison::Equal, zero, zero));
        if holds { always } else { self.intern(Node::Not(always)) }
    }

    /// Whether a condition is one of [`Graph::truth`].
    pub(crate) fn as_truth(&self, condition: NodeId) -> Option<bool> {
        match self.node(condition) {
            Node::CompareIndex(Comparison::Equal, a, b) if a == b => Some(true),
            Node::Not(inner) => self.as_truth(inner).map(|holds| !holds),
            _ => None,
        }
    }

    /// `a < b`, `a <= b` or `a == b`.
    pub(crate) fn compare(&mut self, comparison: Comparison, a: NodeId, b: NodeId) -> NodeId {
        match (self.as_constant(a), self.as_constant(b)) {
            (Some(a), Some(b)) => self.truth(match comparison {
                Comparison::Less => a < b,
                Comparison::LessOrEqual => a <= b,
                Comparison::Equal => a == b,
            }),
            _ => self.intern(Node::Compare(comparison, a, b)),
        }
    }

    /// The same for integers.
    pub(crate) fn compare_index(&mut self, comparison: Comparison, a: IndexId, b: IndexId) -> NodeId {
        let [a, b] = [a, b].map(|index| self.loops.plain(index));
        match (self.loops.signed_literal(a), self.loops.signed_literal(b)) {
            (Some(a), Some(b)) => self.truth(match comparison {
                Comparison::Less => a < b,
                Comparison::LessOrEqual => a <= b,
                Comparison::Equal => a == b,
            }),
            // i < i never holds, i <= i and i == i do.
            _ if a == b => self.truth(comparison != Comparison::Less),
            _ => self.intern(Node::CompareIndex(comparison, a, b)),
        }
    }

    /// A condition of parameters alone.
    pub(crate) fn flag(&mut self, id: ParameterId) -> NodeId {
        self.intern(Node::Flag(id))
    }

    /// Whether a value changes continuously along a motion: it reads coordinates or the time, and not by conditions alone.
    pub(crate) fn moves(&self, id: NodeId) -> bool {
        let mut seen = HashSet::new();
        let mut open = vec![id];
        while let Some(id) = open.pop() {
            let node = self.node(id);
            if self.is_prepared(id) || node.is_condition() || !seen.insert(id) {
                continue;
            }
            if node.is_read() {
                return true;
            }
            open.extend(node.children());
        }
        false
    }

    /// Whether a comparison may change along a motion.
    pub(crate) fn is_edge_of_motion(&self, id: NodeId) -> bool {
        match self.node(id) {
            // A value that is about to overflow has no edge there.
            Node::Compare(Comparison::Less, a, _) if self.is_huge(a) => false,
            Node::Compare(_, a, b) => self.moves(a) || self.moves(b),
            _ => false,
        }
    }

    /// Whether a node is the bound of divisors.
    pub(crate) fn is_huge(&self, id: NodeId) -> bool {
        self.as_constant(id) == Some(HUGE)
    }

    /// A product that falls to zero while its divisor grows, and zero where this is so large that it soon overflows.
    pub(crate) fn zero_beyond(&mut self, divisor: NodeId, product: NodeId) -> NodeId {
        let (huge, zero) = (self.constant(HUGE), self.constant(0.0));
        let is_far = self.compare(Comparison::Less, huge, divisor);
        self.select(is_far, zero, product)
    }

    /// exact: !!c == c
    pub(crate) fn not(&mut self, condition: NodeId) -> NodeId {
        match (self.as_truth(condition), self.node(condition)) {
            (Some(holds), _) => self.truth(!holds),
            (None, Node::Not(inner)) => inner,
            _ => self.intern(Node::Not(condition)),
        }
    }

    pub(crate) fn and(&mut self, a: NodeId, b: NodeId) -> NodeId {
        match (self.as_truth(a), self.as_truth(b)) {
            (Some(true), _) => b,
            (_, Some(true)) => a,
            (Some(false), _) | (_, Some(false)) => self.truth(false),
            _ if a == b => a,
            _ => self.intern(Node::And(a, b)),
        }
    }

    pub(crate) fn or(&mut self, a: NodeId, b: NodeId) -> NodeId {
        match (self.as_truth(a), self.as_truth(b)) {
            (Some(false), _) => b,
            (_, Some(false)) => a,
            (Some(true), _) | (_, Some(true)) => self.truth(true),
            _ if a == b => a,
            _ => match self.either_bound(a, b) {
                Some(wider) => wider,
                None => self.intern(Node::Or(a, b)),
            },
        }
    }

    /// The same condition as a choice between numbers, if it has terms that are only evaluated where others hold: branches are
    /// taken one after the other, but conditions evaluated as a whole.
    pub(crate) fn in_order(&mut self, condition: NodeId) -> NodeId {
        if !self.is_ordered(condition) {
            return condition;
        }
        let [zero, one] = [0.0, 1.0].map(|number| self.constant(number));
        let chosen = self.select(condition, one, zero);
        self.compare(Comparison::Less, zero, chosen)
    }

    /// The condition that the loops and conditions `around` a use of a node are entered: that its loops have an
    /// iteration in which its conditions hold.
    pub(crate) fn happens(&mut self, around: &[Scope], id: NodeId) -> NodeId {
        let always = self.truth(true);
        around.iter().rev().fold(always, |inner, around| match *around {
            Scope::Branch(condition, true) => self.and(condition, inner),
            Scope::Branch(condition, false) => {
                let otherwise = self.not(condition);
                self.and(otherwise, inner)
            }
            Scope::Loop(by) if self.loops_of(inner).contains(by) => {
                let [zero, one] = [0.0, 1.0].map(|number| self.constant(number));
                let counted = self.select(inner, one, zero);
                let count = self.sum(by, counted);
                self.compare(Comparison::Less, zero, count)
            }
            Scope::Loop(by) => {
                let iterations = self.has_iterations(by, id);
                self.and(iterations, inner)
            }
        })
    }

    /// Whether a condition tests if a loop has an iteration, as [`Graph::happens`] does.
    pub(crate) fn asks_for_iterations(&self, condition: NodeId, by: LoopId) -> bool {
        let is_one = |id| self.as_constant(id) == Some(1.0);
        match self.node(condition) {
            Node::And(a, b) => self.asks_for_iterations(a, by) || self.asks_for_iterations(b, by),
            Node::Compare(Comparison::Less, _, count) => match self.node(count) {
                Node::Sum(counted, body) if counted == by => {
                    matches!(self.node(body), Node::Select(_, a, b) if is_one(a) || is_one(b))
                }
                _ => false,
            },
            Node::CompareIndex(Comparison::Less, _, end) => {
                let to = self.loops.get(by).to;
                to == end || matches!(self.loops.index(to), Index::Sub(to, _) if to == end)
            }
            _ => false,
        }
    }

    /// The sum that a node is where the loop of the sum has an iteration, if the node is zero elsewhere.
    pub(crate) fn guarded_sum(&mut self, id: NodeId) -> Option<NodeId> {
        let Node::Select(condition, sum, zero) = self.node(id) else { return None };
        let Node::Sum(by, _) = self.node(sum) else { return None };
        (self.as_constant(zero) == Some(0.0) && self.begins_before_end(by) == condition).then_some(sum)
    }

    /// The condition that a loop around a node has an iteration. Without coordinates there is nothing to compute, so
    /// that a loop over them has this condition only where the node could not be read without.
    pub(super) fn has_iterations(&mut self, by: LoopId, id: NodeId) -> NodeId {
        if self.loops.has_iterations(by) && !self.protects(Scope::Loop(by), id) {
            return self.truth(true);
        }
        self.begins_before_end(by)
    }

    /// The condition that a loop begins before its end.
    fn begins_before_end(&mut self, by: LoopId) -> NodeId {
        let Loop { from, to, .. } = self.loops.get(by);
        // Integers do not go below zero: a < b - c is written as a + c < b.
        let (from, to) = match self.loops.index(to) {
            Index::Sub(to, less) => (self.loops.intern(Index::Add(from, less)), to),
            _ => (from, to),
        };
        self.compare_index(Comparison::Less, from, to)
    }

    /// The same where both sides may have added to a value from before the condition: then the addends are chosen and
    /// not the sums, so that the value from before is written once however many conditions follow each other.
    ///
    /// exact, but for the sign of zero: s + a where c holds, else s + b == s + (a where c holds, else b)
    pub(crate) fn select_addends(&mut self, condition: NodeId, before: NodeId, sides: [NodeId; 2]) -> NodeId {
        let zero = self.constant(0.0);
        let [Some(first), Some(second)] = sides.map(|side| self.addends(side, before)) else {
            return self.select(condition, sides[0], sides[1]);
        };
        let of = |addends: &[NodeId], at: usize| addends.get(at).copied().unwrap_or(zero);
        (0..first.len().max(second.len())).fold(before, |sum, at| {
            let addend = self.select(condition, of(&first, at), of(&second, at));
            self.add(sum, addend)
        })
    }

    /// The addends between a value and a sum that begins with it, in order.
    fn addends(&mut self, sum: NodeId, value: NodeId) -> Option<Vec<NodeId>> {
        let mut addends = Vec::new();
        let mut rest = sum;
        while rest != value {
            let Node::Add(a, b) = self.node(rest) else { return None };
            let [in_a, in_b] = [a, b].map(|part| self.is_summed_in(value, part));
            let addend = match (in_a, in_b) {
                (true, false) => b,
                (false, true) => a,
                _ => return None,
            };
            rest = if in_a { a } else { b };
            addends.push(addend);
        }
        addends.reverse();
        Some(addends)
    }

    /// Whether a value is among the addends of a sum.
    fn is_summed_in(&self, value: NodeId, sum: NodeId) -> bool {
        let mut open = vec![sum];
        while let Some(id) = open.pop() {
            match self.node(id) {
                _ if id == value => return true,
                // Children have smaller ids.
                Node::Add(a, b) if id > value => open.extend([a, b]),
                _ => {}
            }
        }
        false
    }

    /// `a` where the condition holds, else `b`. Both may be conditions.
    pub(crate) fn select(&mut self, condition: NodeId, a: NodeId, b: NodeId) -> NodeId {
        match (self.as_truth(condition), self.node(condition)) {
            _ if a == b => a,
            (Some(true), _) => a,
            (Some(false), _) => b,
            _ if self.node(a).is_condition() => {
                let (otherwise, first) = (self.not(condition), self.and(condition, a));
                let second = self.and(otherwise, b);
                self.or(first, second)
            }
            // exact: choosing the other way round
            (None, Node::Not(inner)) => self.select(inner, b, a),
            // exact: the second of two conditions is evaluated where the first one holds
            (None, Node::And(first, second)) if self.is_ordered(condition) => {
                let inner = self.select(second, a, b);
                self.select(first, inner, b)
            }
            (None, Node::Or(first, second)) if self.is_ordered(condition) => {
                let inner = self.select(second, a, b);
                self.select(first, a, inner)
            }
            _ => match self.shifted(condition, [a, b]) {
                Some(number) => self.select_addends(condition, number, [a, b]),
                None => self.intern(Node::Select(condition, a, b)),
            },
        }
    }

    /// The number that both of two values are shifts of, as the images in a periodic box: by numbers that depend on parameters
    /// alone, where the condition depends on coordinates.
    fn shifted(&self, condition: NodeId, values: [NodeId; 2]) -> Option<NodeId> {
        if self.is_prepared(condition) || values.iter().any(|value| self.is_prepared(*value)) {
            return None;
        }
        let number = |value: NodeId, holds: bool| {
            let Node::Add(a, b) = self.node(value) else { return None };
            let is_shift = |shift| self.is_shift(shift) && self.is_harmless(shift, &[Scope::Branch(condition, holds)]);
            [(a, b), (b, a)].into_iter().find_map(|(number, shift)| is_shift(shift).then_some(number))
        };
        match [number(values[0], true), number(values[1], false)] {
            [Some(a), Some(b)] if a == b => Some(a),
            [Some(a), _] if a == values[1] => Some(a),
            [_, Some(b)] if b == values[0] => Some(b),
            _ => None,
        }
    }

    /// Whether a value depends on parameters alone, or is one of two such shifts.
    fn is_shift(&self, value: NodeId) -> bool {
        match self.node(value) {
            Node::Select(_, a, b) => self.is_prepared(a) && self.is_prepared(b),
            _ => self.is_prepared(value),
        }
    }
}
