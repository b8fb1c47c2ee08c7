//! Control flow that leaves an expression: `return`, `?`, and `break` or `continue` of a loop around it.
//!
//! Functions are interpreted from top to bottom, so such an expression must not be used as a value, whatever its type.

use syn::{
    Block, Expr, ExprAsync, ExprBreak, ExprClosure, ExprContinue, ExprForLoop, ExprIf, ExprLoop, ExprReturn, ExprTry,
    ExprWhile, Item, Local, Pat, Stmt,
    visit::{Visit, visit_expr_for_loop, visit_expr_loop, visit_expr_while},
};

/// The first part of an expression that leaves it, if there is one.
pub(crate) fn escape(expression: &Expr) -> Option<Expr> {
    let mut escape = Escape::default();
    escape.visit_expr(expression);
    escape.found
}

/// The first `continue` in the body of a loop that skips more than the rest of the block in which it stands.
pub(crate) fn continue_further_inside(body: &Block) -> Option<Expr> {
    further_inside(&body.stmts, true)
}

/// The same in a list of statements; `ends` is whether the iteration ends after them.
fn further_inside(statements: &[Stmt], ends: bool) -> Option<Expr> {
    let (last, _) = statements.split_last()?;
    statements.iter().find_map(|statement| {
        let ends_here = ends && std::ptr::eq(statement, last);
        if ends && is_skip_unless(statement).is_some() {
            return None;
        }
        if ends && let Some(skip) = Skip::of(statement) {
            return further_inside(skip.before, true);
        }
        match statement {
            Stmt::Expr(expression, _) => of_branches(expression, ends_here),
            Stmt::Local(local) => local.init.as_ref().and_then(|init| {
                let otherwise = init.diverge.as_ref().and_then(|(_, otherwise)| leaving_iteration(otherwise));
                leaving_iteration(&init.expr).or(otherwise)
            }),
            Stmt::Item(_) | Stmt::Macro(_) => None,
        }
    })
}

/// The same in the branches of an expression.
fn of_branches(expression: &Expr, ends: bool) -> Option<Expr> {
    match expression {
        Expr::If(branch) => {
            let otherwise = branch.else_branch.as_ref();
            let first = further_inside(&branch.then_branch.stmts, ends);
            first.or_else(|| otherwise.and_then(|(_, otherwise)| of_branches(otherwise, ends)))
        }
        Expr::Block(inner) => further_inside(&inner.block.stmts, ends),
        Expr::Match(whole) => whole.arms.iter().find_map(|arm| of_branches(&arm.body, ends)),
        other => leaving_iteration(other),
    }
}

/// A `continue` of the loop around an expression.
fn leaving_iteration(expression: &Expr) -> Option<Expr> {
    escape(expression).filter(|found| matches!(found, Expr::Continue(_)))
}

/// Whether a statement may return from the function that it stands in.
pub(crate) fn returns(statement: &Stmt) -> bool {
    let mut returns = Returns(false);
    returns.visit_stmt(statement);
    returns.0
}

struct Returns(bool);

impl Visit<'_> for Returns {
    fn visit_expr_return(&mut self, _: &ExprReturn) {
        self.0 = true;
    }

    fn visit_expr_closure(&mut self, _: &ExprClosure) {}
    fn visit_expr_async(&mut self, _: &ExprAsync) {}
    fn visit_item(&mut self, _: &Item) {}
}

#[derive(Default)]
struct Escape {
    found: Option<Expr>,
    /// How many loops of the expression itself are around what is visited.
    loops: usize,
}

impl Escape {
    fn note(&mut self, expression: Expr) {
        self.found.get_or_insert(expression);
    }
}

impl Visit<'_> for Escape {
    fn visit_expr_return(&mut self, expression: &ExprReturn) {
        self.note(Expr::Return(expression.clone()));
    }

    fn visit_expr_try(&mut self, expression: &ExprTry) {
        self.note(Expr::Try(expression.clone()));
    }

    fn visit_expr_break(&mut self, expression: &ExprBreak) {
        if self.loops == 0 {
            self.note(Expr::Break(expression.clone()));
        }
    }

    fn visit_expr_continue(&mut self, expression: &ExprContinue) {
        if self.loops == 0 {
            self.note(Expr::Continue(expression.clone()));
        }
    }

    fn visit_expr_for_loop(&mut self, expression: &ExprForLoop) {
        self.loops += 1;
        visit_expr_for_loop(self, expression);
        self.loops -= 1;
    }

    fn visit_expr_while(&mut self, expression: &ExprWhile) {
        self.loops += 1;
        visit_expr_while(self, expression);
        self.loops -= 1;
    }

    fn visit_expr_loop(&mut self, expression: &ExprLoop) {
        self.loops += 1;
        visit_expr_loop(self, expression);
        self.loops -= 1;
    }

    // What returns inside of these returns from them.
    fn visit_expr_closure(&mut self, _: &ExprClosure) {}
    fn visit_expr_async(&mut self, _: &ExprAsync) {}
    fn visit_item(&mut self, _: &Item) {}
}

/// A branch that ends an iteration of a loop, `if condition { ...; continue; }`.
pub(crate) struct Skip<'t> {
    pub(crate) branch: &'t ExprIf,
    /// What it does before that.
    pub(crate) before: &'t [Stmt],
}

impl<'t> Skip<'t> {
    /// The skip that a statement is.
    pub(crate) fn of(statement: &'t Stmt) -> Option<Self> {
        let Stmt::Expr(Expr::If(branch), _) = statement else { return None };
        match (&branch.then_branch.stmts[..], &branch.else_branch) {
            ([before @ .., Stmt::Expr(Expr::Continue(skip), _)], None) if skip.label.is_none() => {
                Some(Self { branch, before })
            }
            _ => None,
        }
    }
}

/// `let pattern = value else { continue; };`
pub(crate) fn is_skip_unless(statement: &Stmt) -> Option<(&Pat, &Expr)> {
    let Stmt::Local(Local { pat, init: Some(init), .. }) = statement else { return None };
    let (_, otherwise) = init.diverge.as_ref()?;
    let Expr::Block(otherwise) = &**otherwise else { return None };
    match &otherwise.block.stmts[..] {
        [Stmt::Expr(Expr::Continue(skip), _)] if skip.label.is_none() => Some((pat, &init.expr)),
        _ => None,
    }
}

/// Where `continue` may stand.
pub(crate) const CONTINUE: &str = "`continue` is not supported here\nhelp: wrap the skipped statements in an \
                                   `if`\nnote: it may be the last statement of an `if` without `else`, directly in \
                                   the body of a loop";
