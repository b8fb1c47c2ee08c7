//! Signs that follow from the source of a parameter: `self.eps * self.eps` is not negative, whatever `eps` is.

use crate::graph::function::Function;
use quote::ToTokens;
use syn::{BinOp, Expr, ExprMethodCall, Lit, Stmt};

/// Whether the number that an expression gives is zero, positive or NaN, whatever the names in it stand for.
pub(crate) fn is_never_negative(expression: &Expr) -> bool {
    match expression {
        Expr::Paren(inner) => is_never_negative(&inner.expr),
        Expr::Cast(cast) => is_never_negative(&cast.expr),
        Expr::Block(block) => match block.block.stmts.last() {
            Some(Stmt::Expr(value, None)) => is_never_negative(value),
            _ => false,
        },
        // A sign in front of a literal is an operator of its own.
        Expr::Lit(literal) => matches!(literal.lit, Lit::Int(_) | Lit::Float(_)),
        Expr::Binary(operation) => {
            let (a, b) = (&*operation.left, &*operation.right);
            let both = || is_never_negative(a) && is_never_negative(b);
            match operation.op {
                BinOp::Mul(_) => same(a, b) || both(),
                BinOp::Add(_) | BinOp::Div(_) => both(),
                _ => false,
            }
        }
        Expr::MethodCall(call) => of_method(call),
        _ => false,
    }
}

/// Whether a method of `f64` gives no negative number.
fn of_method(call: &ExprMethodCall) -> bool {
    let method = call.method.to_string();
    if Function::named(&method).is_some_and(|function| function.row().never_negative) {
        return true;
    }
    match (method.as_str(), call.args.first()) {
        ("sqrt", None) => true,
        // The larger of a number and a literal is no smaller than the literal, also where the number is NaN.
        ("max" | "clamp", Some(bound @ Expr::Lit(_))) => is_never_negative(bound),
        ("min", Some(other)) => is_never_negative(&call.receiver) && is_never_negative(other),
        ("powf", Some(_)) => is_never_negative(&call.receiver),
        ("powi", Some(Expr::Lit(exponent))) => {
            let even = match &exponent.lit {
                Lit::Int(exponent) => exponent.base10_parse::<u32>().is_ok_and(|exponent| exponent % 2 == 0),
                _ => false,
            };
            even || is_never_negative(&call.receiver)
        }
        _ => false,
    }
}

/// Whether two expressions are spelled alike and read nothing but names: a call might give two numbers.
fn same(a: &Expr, b: &Expr) -> bool {
    fn is_place(expression: &Expr) -> bool {
        match expression {
            Expr::Path(_) => true,
            Expr::Field(field) => is_place(&field.base),
            Expr::Index(index) => {
                is_place(&index.expr) && (is_place(&index.index) || matches!(*index.index, Expr::Lit(_)))
            }
            Expr::Paren(inner) => is_place(&inner.expr),
            _ => false,
        }
    }
    is_place(a) && a.to_token_stream().to_string() == b.to_token_stream().to_string()
}

#[cfg(test)]
mod tests {
    use super::is_never_negative;

    #[test]
    fn squares_and_sums_of_them_are_not_negative() {
        for text in [
            "self.eps * self.eps",
            "(self.eps).powi(2)",
            "self.eps.powi(4) + 1.0",
            "self.a.abs() / 2.0",
            "{ let eps = self.eps; eps * eps }",
            "self.table[3] * self.table[3]",
            "self.a.hypot(self.b)",
            "self.a.acos()",
            "self.eps.max(0.0)",
            "self.eps.clamp(0.0, 1.0) * self.eps.exp()",
            "self.a.abs().min(self.b * self.b)",
            "self.a.abs().powf(self.n)",
        ] {
            assert!(is_never_negative(&syn::parse_str(text).expect("an expression")), "{text}");
        }
    }

    #[test]
    fn expressions_that_may_be_negative_are_not_rewritten() {
        for text in [
            "self.eps",
            "-1.0",
            "-self.eps * self.eps",
            "self.eps * self.other",
            "self.eps.powi(3)",
            "self.eps.powi(self.n)",
            "self.next() * self.next()",
            "self.eps * self.eps - 1.0",
            "self.eps.max(self.b)",
            "self.eps.max(self.b * self.b)",
            "self.eps.max(-1.0)",
            "self.eps.min(1.0)",
            "self.eps.powf(2.0)",
            "{ let eps = self.eps; eps }",
        ] {
            assert!(!is_never_negative(&syn::parse_str(text).expect("an expression")), "{text}");
        }
    }
}
