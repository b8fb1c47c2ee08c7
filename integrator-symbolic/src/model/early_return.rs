//! Early `return`: what follows a branch that may return is read once, where it has not.

use super::{Reader, arm::ArmText, branch::Sides, escape::returns, statement::Assigned, value::Value};
use crate::graph::{Graph, NodeId};
use quote::ToTokens;
use std::collections::HashMap;
use syn::{Block, Expr, ExprBlock, ExprIf, ExprLet, Local, Pat, Stmt, visit::Visit};

/// Where a branch stands.
#[derive(Clone, Copy)]
pub(super) enum Flow {
    /// In an expression, out of which nothing returns.
    Value,
    /// In the body of a function, which its sides may return from.
    Function,
}

/// What a part of a function gives: its value, unless it returned before.
pub(super) struct Outcome {
    pub(super) value: Value,
    /// What was returned: the first value whose condition holds.
    pub(super) returned: Vec<(NodeId, Value)>,
}

impl Outcome {
    /// A value, where nothing returns.
    pub(super) fn of(value: Value) -> Self {
        Self { value, returned: Vec::new() }
    }

    /// Whether it returns in any case.
    pub(super) fn leaves(&self, graph: &Graph) -> bool {
        self.returned.last().is_some_and(|(condition, _)| graph.as_truth(*condition) == Some(true))
    }
}

/// One side of a branch.
#[derive(Clone, Copy)]
pub(super) enum Body<'a> {
    Expression(&'a Expr),
    Block(&'a Block),
    /// The rest of a block, in its scope.
    Statements(&'a [Stmt]),
    Nothing,
}

impl<'a> Body<'a> {
    pub(super) fn visit(self, assigned: &mut Assigned) {
        match self {
            Body::Expression(expression) => assigned.visit_expr(expression),
            Body::Block(block) => assigned.visit_block(block),
            Body::Statements(statements) => statements.iter().for_each(|statement| assigned.visit_stmt(statement)),
            Body::Nothing => {}
        }
    }
}

/// The branches of `if ... else if ...`, and what is behind the last `else`.
fn chain(first: &ExprIf) -> (Vec<&ExprIf>, Body<'_>) {
    let mut branches = vec![first];
    loop {
        match branches[branches.len() - 1].else_branch.as_ref().map(|(_, otherwise)| &**otherwise) {
            Some(Expr::If(next)) if !matches!(*next.cond, Expr::Let(_)) => branches.push(next),
            Some(otherwise) => return (branches, Body::Expression(otherwise)),
            None => return (branches, Body::Nothing),
        }
    }
}

impl Reader<'_> {
    /// The value that a function returns.
    pub(super) fn returned(&mut self, block: &Block) -> Option<Value> {
        let outcome = self.body(Body::Block(block), Flow::Function)?;
        self.settled_outcome(outcome, block)
    }

    /// The value that a function has where a part of it ends.
    pub(super) fn settled_outcome(&mut self, outcome: Outcome, place: &dyn ToTokens) -> Option<Value> {
        let leaves = outcome.leaves(&self.graph);
        let Outcome { value, mut returned } = outcome;
        let last = if leaves { returned.pop().map(|(_, value)| value)? } else { value };
        let depth = self.conditions.len();
        returned.iter().for_each(|(condition, _)| self.past(*condition));
        let value = returned.into_iter().rev().try_fold(last, |behind, (condition, value)| {
            self.conditions.pop();
            self.either(condition, value, behind, place)
        });
        self.conditions.truncate(depth);
        value
    }

    /// `if condition { ... } else { ... }`, as a value or as a statement.
    pub(super) fn branch(&mut self, branch: &ExprIf, flow: Flow) -> Option<Outcome> {
        if let Expr::Let(ExprLet { pat, expr, .. }) = &*branch.cond {
            let Some((matched, integer)) = self.matchable(expr)? else {
                let message = "`if let` is understood on values of the system, which read no coordinates: compare \
                               numbers, as in `if r < cutoff`";
                self.errors.at(&branch.cond, message);
                return None;
            };
            let otherwise = branch.else_branch.as_ref().map_or(Body::Nothing, |(_, body)| Body::Expression(body));
            let arms = [
                ArmText { pattern: Some(pat), guard: None, body: Body::Block(&branch.then_branch) },
                ArmText { pattern: None, guard: None, body: otherwise },
            ];
            return self.first_of(&arms, &matched, integer, flow, branch);
        }
        let (branches, last) = chain(branch);
        let mut condition = self.condition_of(&branch.cond);
        if let (Flow::Value, Some(condition)) = (flow, condition)
            && let Some(chosen) = self.chosen_integer(branch, condition)
        {
            return Some(Outcome::of(chosen));
        }
        let mut assigned = Assigned::default();
        assigned.visit_expr_if(branch);
        let fork = self.fork(&assigned);
        let depth = self.conditions.len();
        let mut sides: Sides<'_> = Vec::new();
        for (at, branch) in branches.iter().enumerate() {
            if at > 0 {
                condition = self.condition_of(&branch.cond);
            }
            let body = Body::Block(&branch.then_branch);
            let side = self.side(&fork, condition, true, |reader| reader.body(body, flow));
            sides.push((condition, side, *branch));
            condition.into_iter().for_each(|condition| self.past(condition));
        }
        let last = self.side(&fork, None, true, |reader| reader.body(last, flow));
        self.conditions.truncate(depth);
        self.joined(fork, sides, last)
    }

    /// An integer that a condition on indices or on the system chooses.
    fn chosen_integer(&mut self, branch: &ExprIf, condition: NodeId) -> Option<Value> {
        let [Stmt::Expr(first @ (Expr::Lit(_) | Expr::Binary(_) | Expr::Path(_)), None)] =
            &branch.then_branch.stmts[..]
        else {
            return None;
        };
        let (_, otherwise) = branch.else_branch.as_ref()?;
        let Expr::Block(ExprBlock { block: Block { stmts, .. }, .. }) = &**otherwise else { return None };
        let [Stmt::Expr(Expr::Lit(_) | Expr::Binary(_) | Expr::Path(_), None)] = &stmts[..] else { return None };
        // What reads elements is no choice of integers, and would have its mistakes noted twice.
        let whole = self.verbatim(&Expr::If(branch.clone()));
        if whole.is_none() && (reads_elements(first) || reads_elements(otherwise)) {
            return None;
        }
        let Value::Integer(a) = self.expression(first)? else { return None };
        let Value::Integer(b) = self.expression(otherwise)? else { return None };
        self.wrapped(condition, a, b).map(Value::Integer).or(whole)
    }

    /// One side of a branch, or a whole function.
    pub(super) fn body(&mut self, body: Body<'_>, flow: Flow) -> Option<Outcome> {
        match (body, flow) {
            (Body::Expression(expression), Flow::Value) => self.statement(expression).map(Outcome::of),
            (Body::Expression(expression), Flow::Function) => self.leaving(expression),
            (Body::Nothing, _) => Some(Outcome::of(Value::Unit)),
            (Body::Statements(statements), _) => self.run(statements),
            (Body::Block(block), _) => {
                self.scopes.push(HashMap::new());
                let outcome = match flow {
                    Flow::Value => self.statements(&block.stmts).map(Outcome::of),
                    Flow::Function => self.run(&block.stmts),
                };
                self.scopes.pop();
                outcome
            }
        }
    }

    /// Statements of a function's own body. What is behind one that may return is read where it did not.
    fn run(&mut self, statements: &[Stmt]) -> Option<Outcome> {
        let depth = self.conditions.len();
        let outcome = self.run_on(statements);
        self.conditions.truncate(depth);
        outcome
    }

    fn run_on(&mut self, statements: &[Stmt]) -> Option<Outcome> {
        let mut whole = Outcome::of(Value::Unit);
        let mut rest = statements;
        while let Some(position) = rest.iter().position(returns) {
            self.statements(&rest[..position])?;
            let statement = &rest[position];
            rest = &rest[position + 1..];
            let outcome = match statement {
                Stmt::Local(Local { pat, init: Some(init), .. }) => match &init.diverge {
                    Some((_, otherwise)) => {
                        let outcome = self.let_else(pat, &init.expr, otherwise, rest, statement);
                        rest = &[];
                        outcome?
                    }
                    None => {
                        let Outcome { value, returned } = self.leaving(&init.expr)?;
                        self.bind(pat, value);
                        Outcome { value: Value::Unit, returned }
                    }
                },
                Stmt::Expr(expression, semicolon) => {
                    let Outcome { value, returned } = self.leaving(expression)?;
                    let value = if semicolon.is_none() { value } else { Value::Unit };
                    Outcome { value, returned }
                }
                _ => return None,
            };
            let leaves = outcome.leaves(&self.graph);
            outcome.returned.iter().for_each(|(condition, _)| self.past(*condition));
            whole.returned.extend(outcome.returned);
            whole.value = outcome.value;
            if leaves || rest.is_empty() {
                return Some(whole);
            }
        }
        whole.value = self.statements(rest)?;
        Some(whole)
    }

    /// `let pattern = value else { return ... };` and what is behind it, which knows the names of the pattern.
    fn let_else(
        &mut self,
        pattern: &Pat,
        value: &Expr,
        otherwise: &Expr,
        rest: &[Stmt],
        place: &Stmt,
    ) -> Option<Outcome> {
        let Some((matched, integer)) = self.matchable(value)? else {
            self.errors.at(place, "`let ... else` is understood on values of the system, which read no coordinates");
            return None;
        };
        let arms = [
            ArmText { pattern: Some(pattern), guard: None, body: Body::Statements(rest) },
            ArmText { pattern: None, guard: None, body: Body::Expression(otherwise) },
        ];
        self.first_of(&arms, &matched, integer, Flow::Function, place)
    }

    /// An expression of a function's own body, which may return.
    fn leaving(&mut self, expression: &Expr) -> Option<Outcome> {
        match expression {
            Expr::Return(left) => {
                let value = match &left.expr {
                    Some(value) => self.expression(value)?,
                    None => Value::Unit,
                };
                let always = self.graph.truth(true);
                Some(Outcome { value: Value::Unit, returned: vec![(always, value)] })
            }
            Expr::Paren(inner) => self.leaving(&inner.expr),
            Expr::Block(inner) if inner.label.is_none() => self.body(Body::Block(&inner.block), Flow::Function),
            Expr::If(branch) => self.branch(branch, Flow::Function),
            Expr::Match(whole) => self.matched(whole, Flow::Function),
            _ => self.statement(expression).map(Outcome::of),
        }
    }
}

/// Whether an expression reads elements of coordinates or of lists.
fn reads_elements(expression: &Expr) -> bool {
    let mut assigned = Assigned::default();
    assigned.visit_expr(expression);
    !assigned.indexed.is_empty()
}
