//! Conditions and branches.

use crate::graph::{Comparison, NodeId};
use crate::model::{
    BindingId, Reader, Target,
    code::{assigned::Assigned, escape::Skip},
    control::sides::{Flow, Outcome, has_let},
    parameters::text::place,
    values::value::{Joint, Opaque, Sequence, Value},
};
use quote::ToTokens;
use syn::{BinOp, Expr, ExprIf, Stmt, parse_quote, visit::Visit};

/// The variables that the sides of a branch assign to, and what they were before it.
pub(crate) struct Fork {
    ids: Vec<BindingId>,
    before: Vec<Value>,
    /// What the present loop has added so far.
    sums: Vec<(Target, NodeId)>,
}

/// One side of a branch: its value, what it left of the variables, and what it added to sums.
pub(crate) struct Side {
    outcome: Option<Outcome>,
    left: Vec<Value>,
    added: Vec<(Target, NodeId)>,
}

/// Sides of a branch, each with its condition and its place in the text.
pub(crate) type Sides<'a> = Vec<(Option<NodeId>, Side, &'a dyn ToTokens)>;

impl Fork {
    /// A side that is not taken.
    pub(crate) fn untaken(&self) -> Side {
        Side { outcome: Some(Outcome::of(Value::Unknown)), left: self.before.clone(), added: Vec::new() }
    }
}

impl Reader<'_> {
    /// A value as a condition.
    pub(crate) fn condition(&mut self, value: &Value) -> Option<NodeId> {
        match value {
            Value::Condition(node) => Some(*node),
            Value::Opaque(Opaque { text, loops }) => {
                let parameter = self.parameter(place(text.clone()), "condition", *loops);
                Some(self.graph.flag(parameter))
            }
            _ => None,
        }
    }

    /// An expression that has to be a condition.
    pub(crate) fn condition_of(&mut self, expression: &Expr) -> Option<NodeId> {
        let value = self.expression(expression)?;
        let condition = self.condition(&value);
        if condition.is_none() {
            self.errors.at(expression, format!("expected a condition, found {}", value.describe()));
        }
        condition
    }

    /// `left < right` and its like, `left && right`, `left || right`.
    pub(crate) fn compared(
        &mut self,
        op: &BinOp,
        left: &Value,
        right: &Value,
        places: (&Expr, &Expr),
    ) -> Option<Value> {
        if let BinOp::And(_) | BinOp::Or(_) = op {
            let (a, both) = (self.condition(left), matches!(op, BinOp::And(_)));
            let b = self.under(a, both, |reader| reader.condition(right));
            let (Some(a), Some(b)) = (a, b) else {
                self.errors.at(places.0, "expected conditions on both sides of `&&` and `||`");
                return None;
            };
            return Some(Value::Condition(if both { self.graph.and(a, b) } else { self.graph.or(a, b) }));
        }
        let (comparison, swapped, negated) = match op {
            BinOp::Lt(_) => (Comparison::Less, false, false),
            BinOp::Gt(_) => (Comparison::Less, true, false),
            BinOp::Le(_) => (Comparison::LessOrEqual, false, false),
            BinOp::Ge(_) => (Comparison::LessOrEqual, true, false),
            BinOp::Eq(_) => (Comparison::Equal, false, false),
            _ => (Comparison::Equal, false, true),
        };
        let integers = matches!(left, Value::Integer(_)) || matches!(right, Value::Integer(_));
        let condition = if integers && let (Some(a), Some(b)) = (self.integer(left), self.integer(right)) {
            let (a, b) = if swapped { (b, a) } else { (a, b) };
            self.graph.compare_index(comparison, a, b)
        } else {
            let (a, b) = (self.number(left, places.0), self.number(right, places.1));
            let (a, b) = (a?, b?);
            let (a, b) = if swapped { (b, a) } else { (a, b) };
            self.graph.compare(comparison, a, b)
        };
        Some(Value::Condition(if negated { self.graph.not(condition) } else { condition }))
    }

    /// `if condition { ...; continue; }` and the statements after it, which happen where the condition does not hold.
    pub(crate) fn skipped(&mut self, Skip { branch, before }: Skip<'_>, rest: &[Stmt]) -> Option<Value> {
        if has_let(&branch.cond) {
            let then_branch = parse_quote!({ #(#before)* });
            let otherwise: Expr = parse_quote!({ #(#rest)* });
            let otherwise = Some((Default::default(), Box::new(otherwise)));
            let whole = ExprIf { then_branch, else_branch: otherwise, ..branch.clone() };
            return self.branch(&whole, Flow::Value).map(|outcome| outcome.value);
        }
        let condition = self.condition_of(&branch.cond).map(|condition| self.graph.not(condition));
        let mut assigned = Assigned::default();
        before.iter().chain(rest).for_each(|statement| assigned.visit_stmt(statement));
        let (first, second) = (|reader: &mut Self| reader.statements(rest), |reader: &mut Self| reader.inner(before));
        self.choose(condition, assigned, &first, &second, branch)
    }

    /// Reads both sides of a branch from the same state and joins what they leave.
    pub(crate) fn choose(
        &mut self,
        condition: Option<NodeId>,
        assigned: Assigned,
        first: &dyn Fn(&mut Self) -> Option<Value>,
        second: &dyn Fn(&mut Self) -> Option<Value>,
        place: &dyn ToTokens,
    ) -> Option<Value> {
        let fork = self.fork(&assigned);
        let first = self.side(&fork, condition, true, |reader| first(reader).map(Outcome::of));
        let second = self.side(&fork, condition, false, |reader| second(reader).map(Outcome::of));
        self.joined(fork, vec![(condition, first, place)], second).map(|outcome| outcome.value)
    }

    /// The state that all sides of a branch are read from.
    pub(crate) fn fork(&mut self, assigned: &Assigned) -> Fork {
        let mut ids: Vec<BindingId> = assigned.names.iter().filter_map(|name| self.lookup(name)).collect();
        // Several sides may assign to one variable: it is put back once, and joined once.
        ids.sort_unstable();
        ids.dedup();
        let before = ids.iter().map(|id| self.bindings[id.0].value.clone()).collect();
        let sums = self.frames.last_mut().map(|frame| std::mem::take(&mut frame.sums)).unwrap_or_default();
        Fork { ids, before, sums }
    }

    /// Reads one side of a branch, and goes back to where the branch began. A side that is known not to be taken, as
    /// `if n >= 1` is in the iteration 0 of a loop that is written out, is not read: it may compute what is not there.
    pub(crate) fn side(
        &mut self,
        fork: &Fork,
        condition: Option<NodeId>,
        holds: bool,
        read: impl FnOnce(&mut Self) -> Option<Outcome>,
    ) -> Side {
        if self.is_known(condition, !holds) {
            return fork.untaken();
        }
        let outcome = self.under(condition, holds, read);
        let states = fork.ids.iter().zip(&fork.before);
        let left =
            states.map(|(id, before)| std::mem::replace(&mut self.bindings[id.0].value, before.clone())).collect();
        let added = self.frames.last_mut().map(|frame| std::mem::take(&mut frame.sums)).unwrap_or_default();
        Side { outcome, left, added }
    }

    /// Whether a condition is known to hold, or known not to.
    pub(crate) fn is_known(&self, condition: Option<NodeId>, holds: bool) -> bool {
        condition.is_some_and(|condition| self.graph.as_truth(condition) == Some(holds))
    }

    /// What is known after a branch: of its sides, the first one whose condition holds was taken, else the last.
    pub(crate) fn joined(&mut self, fork: Fork, sides: Sides<'_>, last: Side) -> Option<Outcome> {
        let depth = self.conditions.len();
        sides.iter().filter_map(|(condition, ..)| *condition).for_each(|condition| self.past(condition));
        let mut behind = Some(last);
        for (condition, side, place) in sides.into_iter().rev() {
            if condition.is_some() {
                self.conditions.pop();
            }
            let of_two = |second| self.of_two(&fork, condition?, side, second, place);
            behind = behind.and_then(of_two);
        }
        self.conditions.truncate(depth);
        if let Some(frame) = self.frames.last_mut() {
            frame.sums = fork.sums;
        }
        let Side { outcome, left, added } = behind?;
        for (id, value) in fork.ids.iter().zip(left) {
            self.bindings[id.0].value = value;
        }
        for (target, value) in added {
            self.add_to_frame(target, value);
        }
        outcome
    }

    /// The first side where the condition holds, else the second.
    fn of_two(
        &mut self,
        fork: &Fork,
        condition: NodeId,
        first: Side,
        second: Side,
        place: &dyn ToTokens,
    ) -> Option<Side> {
        match self.graph.as_truth(condition) {
            Some(true) => return Some(first),
            Some(false) => return Some(second),
            None => {}
        }
        let [first_leaves, second_leaves] = [&first, &second].map(|side| self.leaves(side));
        let states = first.left.into_iter().zip(second.left);
        let left = match (first_leaves, second_leaves) {
            (true, _) => states.map(|(_, second)| second).collect(),
            (_, true) => states.map(|(first, _)| first).collect(),
            _ => {
                let number = |value: &Value| match value {
                    Value::Real(number) | Value::Joint(Joint { number, .. }) => Some(*number),
                    _ => None,
                };
                let states = states.zip(fork.ids.iter().zip(&fork.before));
                let states = states.map(|((a, b), (id, before))| match [before, &a, &b].map(number) {
                    [Some(before), Some(a), Some(b)] => {
                        Some(Value::Real(self.graph.select_addends(condition, before, [a, b])))
                    }
                    _ => match self.declared_literal(&Target { id: *id, at: Vec::new() }) {
                        Some(literal) => self.either(condition, a, b, &literal),
                        None => self.either(condition, a, b, place),
                    },
                });
                states.collect::<Option<_>>()?
            }
        };
        let zero = self.graph.constant(0.0);
        let mut added: Vec<(Target, NodeId)> = Vec::new();
        for (target, a) in &first.added {
            let b = second.added.iter().find(|(known, _)| known == target).map_or(zero, |(_, b)| *b);
            added.push((target.clone(), self.graph.select(condition, *a, b)));
        }
        for (target, b) in
            second.added.iter().filter(|(target, _)| !first.added.iter().any(|(known, _)| known == target))
        {
            added.push((target.clone(), self.graph.select(condition, zero, *b)));
        }
        let outcome = self.outcome_of_two(condition, first.outcome?, second.outcome?, place)?;
        Some(Side { outcome: Some(outcome), left, added })
    }

    /// The value of the side that is taken, and what it may have returned before.
    fn outcome_of_two(
        &mut self,
        condition: NodeId,
        first: Outcome,
        second: Outcome,
        place: &dyn ToTokens,
    ) -> Option<Outcome> {
        let otherwise = self.graph.not(condition);
        let (first_leaves, second_leaves) = (first.leaves(&self.graph), second.leaves(&self.graph));
        if first_leaves && second_leaves {
            let [a, b] = [(first, true), (second, false)]
                .map(|(side, holds)| self.under(Some(condition), holds, |reader| reader.settled_outcome(side, place)));
            let value = self.either(condition, a?, b?, place)?;
            let always = self.graph.truth(true);
            return Some(Outcome { value: Value::Unit, returned: vec![(always, value)] });
        }
        if first_leaves || second_leaves {
            let (leaving, falling, taken) =
                if first_leaves { (first, second, condition) } else { (second, first, otherwise) };
            let value = self.under(Some(taken), true, |reader| reader.settled_outcome(leaving, place))?;
            let returned = [(taken, value)].into_iter().chain(falling.returned).collect();
            return Some(Outcome { value: falling.value, returned });
        }
        let mut returned = Vec::new();
        for (side, taken) in [(first.returned, condition), (second.returned, otherwise)] {
            for (inner, value) in side {
                returned.push((self.graph.and(taken, inner), value));
            }
        }
        Some(Outcome { value: self.either(condition, first.value, second.value, place)?, returned })
    }

    /// Whether nothing after a side is reached from it.
    fn leaves(&self, side: &Side) -> bool {
        side.outcome.as_ref().is_some_and(|outcome| outcome.leaves(&self.graph))
    }

    /// The first value where the condition holds, else the second.
    pub(crate) fn either(&mut self, condition: NodeId, a: Value, b: Value, place: &dyn ToTokens) -> Option<Value> {
        match (a, b) {
            (Value::Unit, Value::Unit) => Some(Value::Unit),
            (Value::Accumulating, Value::Accumulating) => Some(Value::Accumulating),
            (Value::Unknown, _) | (_, Value::Unknown) => None,
            (Value::Integer(a), Value::Integer(b)) if a == b => Some(Value::Integer(a)),
            (Value::Condition(a), Value::Condition(b)) => Some(Value::Condition(self.graph.select(condition, a, b))),
            (Value::Array(a), Value::Array(b)) if a.len() == b.len() => {
                let parts = a.into_iter().zip(b).map(|(a, b)| self.either(condition, a, b, place));
                Some(Value::Array(parts.collect::<Option<_>>()?))
            }
            (Value::View(a), Value::View(b)) if a == b => Some(Value::View(a)),
            (Value::Tuple(a), Value::Tuple(b)) if a.len() == b.len() => {
                let parts = a.into_iter().zip(b).map(|(a, b)| self.either(condition, a, b, place));
                Some(Value::Tuple(parts.collect::<Option<_>>()?))
            }
            (a, b) => {
                if let Some(list) = self.either_list(condition, [&a, &b], place) {
                    return Some(Value::List(list));
                }
                if let Some(coordinate) = self.coordinate_of_ring(condition, &a, &b) {
                    return Some(Value::Real(coordinate));
                }
                if [&a, &b].iter().any(|value| matches!(value, Value::Integer(_)))
                    && let Some(own) = self.own_choice(condition, &a, &b)
                {
                    return Some(Value::Opaque(own));
                }
                self.either_number(condition, [&a, &b], place)
            }
        }
    }

    /// The list of the choices between items of two lists with the same range, or `None` for other values.
    fn either_list(&mut self, condition: NodeId, [a, b]: [&Value; 2], place: &dyn ToTokens) -> Option<Sequence> {
        let is_list = |value: &Value| matches!(value, Value::List(_) | Value::Array(_) | Value::View(_));
        if !is_list(a) || !is_list(b) {
            return None;
        }
        let (a, b) = self.as_list(a).zip(self.as_list(b))?;
        if (a.from, a.to) != (b.from, b.to) {
            return None;
        }
        let place = place.to_token_stream();
        Some(Sequence::new(a.from, a.to, move |reader, index| {
            let [a, b] = [(&a, true), (&b, false)]
                .map(|(list, holds)| reader.under(Some(condition), holds, |reader| reader.item_of(list, index)));
            reader.either(condition, a?.value, b?.value, &place)
        }))
    }

    /// The first number where the condition holds, else the second.
    fn either_number(&mut self, condition: NodeId, [a, b]: [&Value; 2], place: &dyn ToTokens) -> Option<Value> {
        let numbers = [(a, true), (b, false)]
            .map(|(value, holds)| self.under(Some(condition), holds, |reader| reader.real(value)));
        if let [Some(first), Some(second)] = numbers {
            let own = self.own_choice(condition, a, b);
            return Some(Self::joint(self.graph.select(condition, first, second), own));
        }
        if !self.notes_whole_branch([a, b], numbers, place) {
            let message = format!(
                "the branches have the values {} and {}\nhelp: give a number in both branches",
                a.describe(),
                b.describe()
            );
            self.errors.at(place.to_token_stream(), message);
        }
        None
    }
}
