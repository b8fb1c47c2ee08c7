//! Early `return`: the code after a branch that may return is interpreted once, for the case that it has not.

use crate::graph::NodeId;
use crate::model::{
    Reader,
    code::{
        assigned::{Assigned, is_assignment},
        escape::returns,
    },
    control::{
        arm::ArmText,
        branch::Sides,
        sides::{Body, Flow, Outcome, has_let, joined_by_and},
    },
    values::value::Value,
};
use quote::ToTokens;
use std::collections::HashMap;
use syn::{Block, Expr, ExprBlock, ExprIf, ExprLet, Local, Pat, PatTupleStruct, Stmt, parse_quote, visit::Visit};

const IF_LET: &str = "`if let` on coordinates is not supported\nhelp: compare numbers, as in `if r < cutoff`\nnote: \
                      `if let` is supported on values of the system that do not depend on coordinates";

/// The branches of `if ... else if ...`, and what is after the last `else`.
fn chain(first: &ExprIf) -> (Vec<&ExprIf>, Body<'_>) {
    let mut branches = vec![first];
    loop {
        match branches[branches.len() - 1].else_branch.as_ref().map(|(_, otherwise)| &**otherwise) {
            Some(Expr::If(next)) if !has_let(&next.cond) => branches.push(next),
            Some(otherwise) => return (branches, Body::Expression(otherwise)),
            None => return (branches, Body::Nothing),
        }
    }
}

impl Reader<'_> {
    /// The value that a function returns.
    pub(crate) fn returned(&mut self, block: &Block) -> Option<Value> {
        let outcome = self.body(Body::Block(block), Flow::Function)?;
        self.settled_outcome(outcome, block)
    }

    /// The value that a function has where a part of it ends.
    pub(crate) fn settled_outcome(&mut self, outcome: Outcome, place: &dyn ToTokens) -> Option<Value> {
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
    pub(crate) fn branch(&mut self, branch: &ExprIf, flow: Flow) -> Option<Outcome> {
        if let Expr::Let(ExprLet { pat, expr, .. }) = &*branch.cond {
            return self.if_let(pat, expr, branch, flow);
        }
        if has_let(&branch.cond) {
            return self.let_chain(branch, flow);
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
            if self.is_known(condition, true) {
                break;
            }
        }
        let last = match self.is_known(condition, true) {
            true => fork.untaken(),
            false => self.side(&fork, None, true, |reader| reader.body(last, flow)),
        };
        self.conditions.truncate(depth);
        self.joined(fork, sides, last)
    }

    /// One side where a pattern fits, the other one elsewhere.
    fn if_let(&mut self, pattern: &Pat, value: &Expr, branch: &ExprIf, flow: Flow) -> Option<Outcome> {
        let otherwise = branch.else_branch.as_ref().map_or(Body::Nothing, |(_, body)| Body::Expression(body));
        let fits = Body::Block(&branch.then_branch);
        let Some((matched, integer)) = self.matchable(value)? else {
            if let Some(inside) = where_there(pattern, value, branch) {
                return self.branch(&inside, flow);
            }
            self.scopes.push(HashMap::new());
            let fitting = self.fits_length(pattern, value);
            let taken = fitting.flatten().map(|is_fitting| if is_fitting { fits } else { otherwise });
            let outcome = taken.and_then(|body| self.body(body, flow));
            self.scopes.pop();
            if fitting == Some(None) {
                self.errors.at(&branch.cond, IF_LET);
            }
            return outcome;
        };
        let arms = [
            ArmText { pattern: Some(pattern), guard: None, body: fits },
            ArmText { pattern: None, guard: None, body: otherwise },
        ];
        self.first_of(&arms, &matched, integer, flow, branch)
    }

    /// `if a && let Some(x) = y && b { ... } else { ... }`: the conditions after a pattern know its names, and are
    /// tested where it fits alone.
    fn let_chain(&mut self, branch: &ExprIf, flow: Flow) -> Option<Outcome> {
        let mut conditions = Vec::new();
        joined_by_and(&branch.cond, &mut conditions);
        let mut assigned = Assigned::default();
        assigned.visit_expr_if(branch);
        let fork = self.fork(&assigned);
        let (depth, opened) = (self.conditions.len(), self.arms.len());
        let body = Body::Block(&branch.then_branch);
        let (condition, side) = self.where_all_hold(&conditions, &mut |reader| {
            let arms = reader.arms.len() - opened;
            reader.side(&fork, None, true, |reader| reader.settled_body(body, flow, arms))
        })?;
        self.past(condition);
        let otherwise = branch.else_branch.as_ref().map_or(Body::Nothing, |(_, body)| Body::Expression(body));
        let last = self.side(&fork, None, true, |reader| reader.body(otherwise, flow));
        self.conditions.truncate(depth);
        self.joined(fork, vec![(Some(condition), side, branch)], last)
    }

    /// Reads something where all conditions hold, and says whether they do.
    fn where_all_hold<T>(&mut self, conditions: &[&Expr], read: &mut dyn FnMut(&mut Self) -> T) -> Option<(NodeId, T)> {
        let Some((first, rest)) = conditions.split_first() else { return Some((self.graph.truth(true), read(self))) };
        let (holds, (behind, value)) = match first {
            Expr::Let(ExprLet { pat, expr, .. }) => {
                let Some((matched, integer)) = self.matchable(expr)? else {
                    self.errors.at(first, IF_LET);
                    return None;
                };
                let arm = self.arm(pat, matched, Vec::new());
                let fits = self.fits(&arm, integer, pat);
                let inside = |reader: &mut Self| reader.in_arm(arm, |reader| reader.where_all_hold(rest, read));
                (fits, self.under(Some(fits), true, inside)?)
            }
            first => {
                let holds = self.condition_of(first)?;
                (holds, self.under(Some(holds), true, |reader| reader.where_all_hold(rest, read))?)
            }
        };
        Some((self.graph.and(holds, behind), value))
    }

    /// An integer that a condition on indices or on the system chooses.
    fn chosen_integer(&mut self, branch: &ExprIf, condition: NodeId) -> Option<Value> {
        let first = formula(&branch.then_branch)?;
        let (_, otherwise) = branch.else_branch.as_ref()?;
        let Expr::Block(ExprBlock { block, .. }) = &**otherwise else { return None };
        formula(block)?;
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
    pub(crate) fn body(&mut self, body: Body<'_>, flow: Flow) -> Option<Outcome> {
        match (body, flow) {
            (Body::Expression(expression), Flow::Value) => self.statement(expression).map(Outcome::of),
            (Body::Expression(expression), Flow::Function) => self.leaving(expression),
            (Body::Nothing, _) => Some(Outcome::of(Value::Unit)),
            (Body::Statements(statements), Flow::Value) => self.statements(statements).map(Outcome::of),
            (Body::Statements(statements), Flow::Function) => self.run(statements),
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

    /// Statements of a function's own body. What is after one that may return is read where it did not.
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
                        let otherwise = Body::Expression(otherwise);
                        let outcome = self.let_else(pat, &init.expr, otherwise, rest, Flow::Function, statement);
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

    /// `let pattern = value else { ... };`, which leaves here, and what is after it, which knows the names of the
    /// pattern.
    pub(crate) fn let_else(
        &mut self,
        pattern: &Pat,
        value: &Expr,
        otherwise: Body<'_>,
        rest: &[Stmt],
        flow: Flow,
        place: &Stmt,
    ) -> Option<Outcome> {
        let Some((matched, integer)) = self.matchable(value)? else {
            if let Some(fits) = self.fits_length(pattern, value)? {
                return self.body(if fits { Body::Statements(rest) } else { otherwise }, flow);
            }
            self.errors.at(
                place,
                "`let ... else` on coordinates is not supported\nnote: it is supported on values of \
                                   the system that do not depend on coordinates",
            );
            return None;
        };
        let arms = [
            ArmText { pattern: Some(pattern), guard: None, body: Body::Statements(rest) },
            ArmText { pattern: None, guard: None, body: otherwise },
        ];
        self.first_of(&arms, &matched, integer, flow, place)
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

/// `if let Some(x) = q.get(i) { ... }` over coordinates as a branch by the index.
pub(crate) fn where_there(pattern: &Pat, value: &Expr, branch: &ExprIf) -> Option<ExprIf> {
    let Pat::TupleStruct(PatTupleStruct { path, elems, .. }) = pattern else { return None };
    let mut value = value;
    let got = loop {
        let Expr::MethodCall(call) = value else { return None };
        match (call.method.to_string().as_str(), call.args.len()) {
            ("copied" | "cloned", 0) => value = &call.receiver,
            ("get", 1) | ("first" | "last", 0) => break call,
            _ => return None,
        }
    };
    let (true, 1) = (path.is_ident("Some"), elems.len()) else { return None };
    let (item, list, body) = (&elems[0], &got.receiver, &branch.then_branch);
    let at: Expr = match got.method.to_string().as_str() {
        "first" => parse_quote!(0),
        "last" => parse_quote!(#list.len() - 1),
        _ => got.args[0].clone(),
    };
    Some(ExprIf {
        cond: if got.method == "get" { parse_quote!(#at < #list.len()) } else { parse_quote!(0 < #list.len()) },
        then_branch: parse_quote!({ let #item = &#list[#at]; #body }),
        ..branch.clone()
    })
}

/// What a block is, if it may be the formula of an integer.
fn formula(block: &Block) -> Option<&Expr> {
    match &block.stmts[..] {
        [Stmt::Expr(Expr::Binary(binary), None)] if is_assignment(&binary.op) => None,
        [Stmt::Expr(formula @ (Expr::Lit(_) | Expr::Binary(_) | Expr::Path(_)), None)] => Some(formula),
        _ => None,
    }
}

/// Whether an expression reads elements of coordinates or of lists.
fn reads_elements(expression: &Expr) -> bool {
    let mut assigned = Assigned::default();
    assigned.visit_expr(expression);
    !assigned.indexed.is_empty()
}
