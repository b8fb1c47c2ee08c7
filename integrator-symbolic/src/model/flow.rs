//! Early `return`: what follows a branch that may return is read where it does not.

use super::{Reader, arm::ArmText, escape::returns, statement::Assigned, value::Value};
use crate::graph::NodeId;
use quote::ToTokens;
use std::collections::HashMap;
use syn::{Block, Expr, ExprIf, ExprLet, Local, Pat, Stmt, visit::Visit};

/// What follows a statement in a function: the rest of its block, and then that of the blocks around it.
pub(super) struct Rest<'a> {
    /// What the value of the statement is bound to.
    pattern: Option<&'a Pat>,
    statements: &'a [Stmt],
    /// How many scopes are around the rest.
    scopes: usize,
    next: Option<&'a Rest<'a>>,
}

/// Where the value of a branch goes.
#[derive(Clone, Copy)]
pub(super) enum Flow<'a> {
    /// To the expression around it.
    Value,
    /// To the rest of the function, or out of it.
    Function(Option<&'a Rest<'a>>),
}

/// One side of a branch.
#[derive(Clone, Copy)]
pub(super) enum Body<'a> {
    Expression(&'a Expr),
    Block(&'a Block),
    Nothing,
}

impl<'a> Body<'a> {
    pub(super) fn visit(self, assigned: &mut Assigned) {
        match self {
            Body::Expression(expression) => assigned.visit_expr(expression),
            Body::Block(block) => assigned.visit_block(block),
            Body::Nothing => {}
        }
    }

    fn otherwise(branch: &'a ExprIf) -> Self {
        branch.else_branch.as_ref().map_or(Body::Nothing, |(_, otherwise)| Body::Expression(otherwise))
    }
}

impl Reader<'_> {
    /// The value that a function returns.
    pub(super) fn returned(&mut self, block: &Block) -> Option<Value> {
        self.scopes.push(HashMap::new());
        let value = self.run(&block.stmts, None);
        self.scopes.pop();
        value
    }

    /// `if condition { ... } else { ... }`, as a value or as a statement.
    pub(super) fn branch(&mut self, branch: &ExprIf, flow: Flow<'_>) -> Option<Value> {
        let (first, second) = (Body::Block(&branch.then_branch), Body::otherwise(branch));
        if let Expr::Let(ExprLet { pat, expr, .. }) = &*branch.cond {
            let Some((matched, integer)) = self.matchable(expr)? else {
                let message = "`if let` is understood on values of the system, which read no coordinates: compare \
                               numbers, as in `if r < cutoff`";
                self.errors.at(&branch.cond, message);
                return None;
            };
            let arms = [
                ArmText { pattern: Some(pat), guard: None, body: first },
                ArmText { pattern: None, guard: None, body: second },
            ];
            return self.first_of(&arms, &matched, integer, &[], flow, branch);
        }
        let condition = self.condition_of(&branch.cond);
        if let (Flow::Value, Some(condition)) = (flow, condition)
            && let Some(chosen) = self.chosen_integer(branch, condition)
        {
            return Some(chosen);
        }
        let mut assigned = Assigned::default();
        assigned.visit_expr_if(branch);
        self.split(
            flow,
            condition,
            assigned,
            &|reader| reader.body(first, flow),
            &|reader| reader.body(second, flow),
            branch,
        )
    }

    /// An integer that a condition on indices or on the system chooses.
    fn chosen_integer(&mut self, branch: &ExprIf, condition: NodeId) -> Option<Value> {
        let [Stmt::Expr(first @ (Expr::Lit(_) | Expr::Binary(_) | Expr::Path(_)), None)] =
            &branch.then_branch.stmts[..]
        else {
            return None;
        };
        let (_, otherwise) = branch.else_branch.as_ref()?;
        // What reads elements is no choice of integers, and would have its mistakes noted twice.
        let whole = self.verbatim(&Expr::If(branch.clone()));
        if whole.is_none() && (reads_elements(first) || reads_elements(otherwise)) {
            return None;
        }
        let (Value::Integer(a), Value::Integer(b)) = (self.expression(first)?, self.expression(otherwise)?) else {
            return None;
        };
        self.wrapped(condition, a, b).map(Value::Integer).or(whole)
    }

    /// Reads both sides of a branch, and what follows them.
    pub(super) fn split(
        &mut self,
        flow: Flow<'_>,
        condition: Option<NodeId>,
        assigned: Assigned,
        first: &dyn Fn(&mut Self) -> Option<Value>,
        second: &dyn Fn(&mut Self) -> Option<Value>,
        place: &dyn ToTokens,
    ) -> Option<Value> {
        let Flow::Function(_) = flow else { return self.choose(condition, assigned, first, second, place) };
        // Behind the branch nothing is left of the function, so that its variables need not be joined.
        let before: Vec<Value> = self.bindings.iter().map(|binding| binding.value.clone()).collect();
        let from_here = |reader: &mut Self, side: &dyn Fn(&mut Self) -> Option<Value>| {
            let value = side(reader);
            for (binding, before) in reader.bindings.iter_mut().zip(&before) {
                binding.value = before.clone();
            }
            value
        };
        let none = Assigned::default();
        self.choose(condition, none, &|reader| from_here(reader, first), &|reader| from_here(reader, second), place)
    }

    /// One side of a branch, and what follows it.
    pub(super) fn body(&mut self, body: Body<'_>, flow: Flow<'_>) -> Option<Value> {
        match (body, flow) {
            (Body::Expression(expression), Flow::Value) => self.statement(expression),
            (Body::Block(block), Flow::Value) => self.block(block),
            (Body::Nothing, Flow::Value) => Some(Value::Unit),
            (Body::Expression(expression), Flow::Function(rest)) => self.leaving(expression, rest),
            (Body::Block(block), Flow::Function(rest)) => {
                self.scopes.push(HashMap::new());
                let value = self.run(&block.stmts, rest);
                self.scopes.pop();
                value
            }
            (Body::Nothing, Flow::Function(rest)) => self.goes_on(Value::Unit, rest),
        }
    }

    /// Statements of a function's own body, and what follows them.
    fn run(&mut self, statements: &[Stmt], rest: Option<&Rest<'_>>) -> Option<Value> {
        let Some(position) = statements.iter().position(returns) else {
            let value = self.statements(statements)?;
            return self.goes_on(value, rest);
        };
        let (before, behind) = (&statements[..position], &statements[position + 1..]);
        self.statements(before)?;
        let next = Rest { pattern: None, statements: behind, scopes: self.scopes.len(), next: rest };
        match &statements[position] {
            Stmt::Expr(expression, None) if behind.is_empty() => self.leaving(expression, rest),
            Stmt::Expr(expression, _) => self.leaving(expression, Some(&next)),
            Stmt::Local(local) => self.leaving_local(local, next),
            _ => None,
        }
    }

    /// `let pattern = value;` and `let pattern = value else { ... };` with a `return` in them.
    fn leaving_local(&mut self, local: &Local, next: Rest<'_>) -> Option<Value> {
        let init = local.init.as_ref()?;
        let Some((_, otherwise)) = &init.diverge else {
            return self.leaving(&init.expr, Some(&Rest { pattern: Some(&local.pat), ..next }));
        };
        let Some((matched, integer)) = self.matchable(&init.expr)? else {
            self.errors.at(local, "`let ... else` is understood on values of the system, which read no coordinates");
            return None;
        };
        // The names of the pattern are known to the rest, which is read in the scope of the arm.
        let rest = Rest { scopes: next.scopes + 1, ..next };
        let arms = [
            ArmText { pattern: Some(&local.pat), guard: None, body: Body::Nothing },
            ArmText { pattern: None, guard: None, body: Body::Expression(otherwise) },
        ];
        self.first_of(&arms, &matched, integer, &[], Flow::Function(Some(&rest)), local)
    }

    /// An expression that may return, and what follows it where it does not.
    fn leaving(&mut self, expression: &Expr, rest: Option<&Rest<'_>>) -> Option<Value> {
        let flow = Flow::Function(rest);
        match expression {
            Expr::Return(left) => match &left.expr {
                Some(value) => self.expression(value),
                None => Some(Value::Unit),
            },
            Expr::Paren(inner) => self.leaving(&inner.expr, rest),
            Expr::Group(inner) => self.leaving(&inner.expr, rest),
            Expr::Block(inner) if inner.label.is_none() => self.body(Body::Block(&inner.block), flow),
            Expr::If(branch) => self.branch(branch, flow),
            Expr::Match(whole) => self.matched(whole, flow),
            _ => {
                let value = self.statement(expression)?;
                self.goes_on(value, rest)
            }
        }
    }

    /// What follows in the function where a branch does not return.
    fn goes_on(&mut self, value: Value, rest: Option<&Rest<'_>>) -> Option<Value> {
        let Some(rest) = rest else { return Some(value) };
        let around = self.scopes.clone();
        self.scopes.truncate(rest.scopes);
        if let Some(pattern) = rest.pattern {
            self.bind(pattern, value);
        }
        let value = self.run(rest.statements, rest.next);
        self.scopes = around;
        value
    }
}

/// Whether an expression reads elements of coordinates or of lists.
fn reads_elements(expression: &Expr) -> bool {
    let mut assigned = Assigned::default();
    assigned.visit_expr(expression);
    !assigned.indexed.is_empty()
}
