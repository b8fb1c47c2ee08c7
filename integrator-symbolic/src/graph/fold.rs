//! Products and maxima over a loop.

use super::{Comparison, Graph, Node, NodeId, index::LoopId};

/// How the items of a loop are joined, if not by adding them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Fold {
    Product,
    Largest,
}

impl Fold {
    /// What it begins with, and is where there are no items.
    pub(crate) fn beginning(self) -> f64 {
        match self {
            Fold::Product => 1.0,
            Fold::Largest => f64::NEG_INFINITY,
        }
    }

    /// What it is with one more item.
    #[cfg(test)]
    pub(crate) fn joined(self, so_far: f64, item: f64) -> f64 {
        match self {
            Fold::Product => so_far * item,
            Fold::Largest => so_far.max(item),
        }
    }

    /// What it is, in words.
    pub(crate) fn noun(self) -> &'static str {
        match self {
            Fold::Product => "product",
            Fold::Largest => "maximum",
        }
    }

    /// What a variable that holds it is called.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Fold::Product => "product",
            Fold::Largest => "largest",
        }
    }
}

/// The derivative of a fold by the item of an iteration, a factor where a condition holds, and zero elsewhere.
pub(crate) struct FoldSlope {
    pub(crate) condition: Option<NodeId>,
    pub(crate) value: NodeId,
}

impl Graph {
    /// The items of a loop, joined.
    pub(crate) fn fold(&mut self, fold: Fold, by: LoopId, item: NodeId) -> NodeId {
        let range = self.loops.get(by);
        let iterations = self.loops.span(range.from, range.to);
        if self.loops.literal(iterations) == Some(0) || self.as_constant(item) == Some(fold.beginning()) {
            return self.constant(fold.beginning());
        }
        self.intern(Node::Fold(fold, by, item))
    }

    /// The derivative of a fold by the item of an iteration.
    ///
    /// Of a product that is the product of all others: the whole one divided by the item, or where items are zero the product
    /// of those that are not, if the item is the only zero. The largest one moves with the item that it is; with several
    /// that are as large, by the mean of what these do, so that equal ones count once.
    pub(crate) fn fold_slope(&mut self, fold: Fold, by: LoopId, item: NodeId, whole: NodeId) -> FoldSlope {
        let [zero, one] = [0.0, 1.0].map(|number| self.constant(number));
        match fold {
            Fold::Largest => {
                let is_largest = self.compare(Comparison::Equal, item, whole);
                let counted = self.select(is_largest, one, zero);
                let count = self.sum(by, counted);
                FoldSlope { condition: Some(is_largest), value: self.div(one, count) }
            }
            Fold::Product => {
                let is_zero = self.compare(Comparison::Equal, item, zero);
                let (counted, others) = (self.select(is_zero, one, zero), self.select(is_zero, one, item));
                let (zeros, others) = (self.sum(by, counted), self.fold(fold, by, others));
                let [none, alone] = [zero, one].map(|count| self.compare(Comparison::Equal, zeros, count));
                let quotient = self.div(whole, item);
                let is_alone = self.and(alone, is_zero);
                let of_zero = self.select(is_alone, others, zero);
                FoldSlope { condition: None, value: self.select(none, quotient, of_zero) }
            }
        }
    }

    /// The name of the first fold in some values.
    pub(crate) fn first_fold(&self, roots: impl IntoIterator<Item = NodeId>) -> Option<Fold> {
        self.reachable(roots).into_iter().find_map(|id| match self.node(id) {
            Node::Fold(fold, ..) => Some(fold),
            _ => None,
        })
    }

    /// The item that a step of a loop multiplies what it has so far by, if that is all it does.
    pub(crate) fn multiplied_to(&mut self, so_far: NodeId, next: NodeId) -> Option<NodeId> {
        if let Node::Select(condition, a, b) = self.node(next)
            && !self.mentions(condition, &[so_far])
        {
            let (a, b) = (self.multiplied_to(so_far, a)?, self.multiplied_to(so_far, b)?);
            return Some(self.select(condition, a, b));
        }
        let (factor, addend) = self.linear_in(so_far, next)?;
        (self.as_constant(addend) == Some(0.0)).then_some(factor)
    }

    /// The item that a step of a loop compares with the largest one so far, or the smallest, if that is all it does:
    /// `largest.max(x)`, or `x` where it is larger. Several items, one after the other, are the largest one of them.
    pub(crate) fn compared_to(&mut self, so_far: NodeId, next: NodeId, is_largest: bool) -> Option<NodeId> {
        let name = if is_largest { "max" } else { "min" };
        let (a, b) = match self.node(next) {
            Node::Binary(function, a, b) if function.name() == name => (a, b),
            Node::Select(condition, taken, left) => {
                let Node::Compare(Comparison::Less | Comparison::LessOrEqual, low, high) = self.node(condition) else {
                    return None;
                };
                // The one that is taken where the condition holds is the higher one of a largest.
                let sides = if is_largest { (high, low) } else { (low, high) };
                if (taken, left) != sides {
                    return None;
                }
                sides
            }
            _ => return None,
        };
        let (before, item) = match [a, b].map(|side| self.mentions(side, &[so_far])) {
            [true, false] => (a, b),
            [false, true] => (b, a),
            _ => return None,
        };
        if before == so_far {
            return Some(item);
        }
        let earlier = self.compared_to(so_far, before, is_largest)?;
        Some(self.call_two(name, earlier, item))
    }
}
