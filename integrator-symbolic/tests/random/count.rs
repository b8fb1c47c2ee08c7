//! Counts of the operations that the interpreter carries out, as the report counts them.
//!
//! A fused multiply-add is a multiplication and an addition, here as in the report. So is what adds a product to a coordinate
//! or to its component of the gradient, where the addition is the coordinate that moves. The multiplication of a
//! contribution by the step belongs to that coordinate, as does the loop that applies a whole gradient.

use crate::{
    machine::Machine,
    number::Number,
    value::{Outcome, Value},
};
use quote::ToTokens;
use syn::{BinOp, Expr, ExprAssign, ExprMethodCall, Pat, UnOp};

impl Machine<'_> {
    pub(crate) fn count_operator(&mut self, op: BinOp) {
        match op {
            BinOp::Add(_) | BinOp::Sub(_) => self.done.additions += 1,
            BinOp::Mul(_) => self.done.multiplications += 1,
            BinOp::Div(_) => self.done.divisions += 1,
            BinOp::Rem(_) => self.count_function("remainder"),
            _ => {}
        }
    }

    fn count_function(&mut self, name: &str) {
        *self.done.functions.entry(name.to_owned()).or_default() += 1;
    }

    /// A method of a number.
    pub(crate) fn count_method(&mut self, name: &str) {
        match name {
            "square" | "scale" => self.done.multiplications += 1,
            "square_add" | "square_from" | "scale_add" | "fma" => {
                self.done.multiplications += 1;
                self.done.additions += 1;
            }
            "div_pow_3_2" => {
                self.done.multiplications += 1;
                self.done.roots += 1;
                self.done.divisions += 1;
            }
            "div_sqrt" => {
                self.done.roots += 1;
                self.done.divisions += 1;
            }
            "sqrt" => self.done.roots += 1,
            "sin_cos" => {
                self.count_function("sin");
                self.count_function("cos");
            }
            // It calls `sin_cos`.
            "fast_sin_cos" => {}
            "less" | "less_or_equal" | "equal" | "is_nan" | "is_finite" => {}
            name => self.count_function(name.strip_prefix("fast_").unwrap_or(name)),
        }
    }

    /// A multiplication that was counted; one by the step is not.
    pub(crate) fn count_product(&mut self, factors: [&Expr; 2]) {
        self.done.multiplications -= u64::from(factors.into_iter().any(is_step));
    }

    /// The addition of a product to a coordinate.
    pub(crate) fn count_move(&mut self, call: &ExprMethodCall) {
        let mut arguments = call.args.iter();
        let [a, b] = [arguments.next(), arguments.next()];
        let applies = b.is_some_and(|b| matches!(b, Expr::Unary(unary) if matches!(unary.op, UnOp::Deref(_))));
        if applies {
            return;
        }
        self.done.coordinates += 1;
        self.done.multiplications += u64::from(![a, b].into_iter().flatten().any(is_step));
    }

    /// An addition that was counted, and that is one to the gradient.
    pub(crate) fn count_addition_to_gradient(&mut self) {
        self.done.additions -= 1;
        self.done.coordinates += 1;
    }

    /// `gradient[i] = x.fma(y, gradient[i])`, whose last addition is one to the gradient.
    pub(crate) fn count_assignment(&mut self, assign: &ExprAssign) {
        let [left, right] = [&assign.left, &assign.right].map(|side| side.to_token_stream().to_string());
        if right.contains(&left) {
            self.count_update(&assign.left);
        } else if left.starts_with("gradient") && !self.keeps_results {
            self.done.coordinates += 1;
        }
    }

    /// `let contribution_1 = contribution_1 + value;` of a site, which the runtime adds to a coordinate.
    pub(crate) fn count_contribution(&mut self, pattern: &Pat, value: &Expr) {
        let Pat::Ident(name) = pattern else { return };
        if name.ident.to_string().starts_with("contribution_") {
            let mut first = value;
            while let Expr::Binary(sum) = first {
                first = &sum.left;
            }
            let is_sum = matches!(first, Expr::Path(path) if path.path.is_ident(&name.ident));
            self.done.additions -= u64::from(is_sum);
            self.done.coordinates += 1;
        }
    }

    /// Lets something be done whose operations do not count.
    pub(crate) fn uncounted<T>(&mut self, run: impl FnOnce(&mut Self) -> Outcome<T>) -> Outcome<T> {
        let done = self.done.clone();
        let result = run(self);
        self.done = done;
        result
    }

    /// An addition to what may be the gradient.
    pub(crate) fn count_update(&mut self, place: &Expr) {
        let place = place.to_token_stream().to_string();
        if place.starts_with("gradient") {
            self.count_addition_to_gradient();
        }
    }

    /// A comparison in a flow.
    pub(crate) fn mask(&mut self, op: BinOp, a: &Number, b: &Number) -> Outcome<Value> {
        let holds = self.compared(op, a, b)?;
        Ok(if self.takes_both && !b.is_flag { Value::Torn } else { Value::Mask(holds) })
    }
}

/// Whether an expression is the step, perhaps with a sign.
fn is_step(expression: &Expr) -> bool {
    match expression {
        Expr::Path(path) => path.path.is_ident("step"),
        Expr::Paren(inner) => is_step(&inner.expr),
        Expr::Unary(unary) => matches!(unary.op, UnOp::Neg(_)) && is_step(&unary.expr),
        _ => false,
    }
}
