//! Control flow that leaves an expression: `return`, `?`, and `break` or `continue` of a loop around it.
//!
//! The functions are read from top to bottom, so such an expression must not pass for a value, whatever it is made of.

use syn::{
    Expr, ExprAsync, ExprBreak, ExprClosure, ExprContinue, ExprForLoop, ExprLoop, ExprReturn, ExprTry, ExprWhile, Item,
    Stmt,
    visit::{Visit, visit_expr_for_loop, visit_expr_loop, visit_expr_while},
};

/// The first part of an expression that leaves it, if there is one.
pub(super) fn escape(expression: &Expr) -> Option<Expr> {
    let mut escape = Escape::default();
    escape.visit_expr(expression);
    escape.found
}

/// Whether a statement may return from the function that it stands in.
pub(super) fn returns(statement: &Stmt) -> bool {
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
