//! What is written in other languages, and what Rust writes in its place.

use super::elementary::is_elementary;
use crate::errors::quoted;
use syn::{Expr, ExprLit, ExprUnary, Lit, UnOp};

/// Functions of numbers by the names that they have elsewhere.
const ELSEWHERE: [(&str, &str); 13] = [
    ("log", "ln"),
    ("fabs", "abs"),
    ("arcsin", "asin"),
    ("arccos", "acos"),
    ("arctan", "atan"),
    ("arctan2", "atan2"),
    ("arcsinh", "asinh"),
    ("arccosh", "acosh"),
    ("arctanh", "atanh"),
    ("fmax", "max"),
    ("fmin", "min"),
    ("sgn", "signum"),
    ("sign", "signum"),
];

/// What to write for a call of a name with arguments, the first of which may be its receiver; nothing where that is not known.
/// `is_list` says that the first one is a list.
pub(super) fn in_rust(name: &str, arguments: &[&Expr], is_list: bool) -> Option<String> {
    let (first, others) = arguments.split_first()?;
    let text = receiver(first);
    let squares = || format!("{text}.iter().map(|x| x * x).sum::<f64>()");
    match (name, others) {
        ("sum" | "product", []) if is_list => return Some(format!("{text}.iter().{name}::<f64>()")),
        ("norm" | "length" | "magnitude", []) if is_list => return Some(format!("{}.sqrt()", squares())),
        ("norm_squared" | "norm2" | "norm_sqr" | "length_squared" | "magnitude_squared", []) if is_list => {
            return Some(squares());
        }
        ("dot" | "inner", [other]) if is_list => {
            let other = receiver(without_reference(other));
            return Some(format!("{text}.iter().zip(&{other}).map(|(a, b)| a * b).sum::<f64>()"));
        }
        ("len", []) if is_list => return Some(format!("{text}.len()")),
        _ if is_list => return None,
        ("norm" | "magnitude", []) => return Some(format!("{text}.abs()")),
        ("square" | "sq" | "sqr" | "squared", []) => return Some(format!("{text}.powi(2)")),
        ("cube" | "cubed", []) => return Some(format!("{text}.powi(3)")),
        ("pow" | "power", [exponent]) => {
            let method = if is_whole(exponent) { "powi" } else { "powf" };
            return Some(format!("{text}.{method}({})", written(exponent)));
        }
        _ => {}
    }
    let known = ELSEWHERE.iter().find(|(elsewhere, _)| *elsewhere == name && (name != "log" || others.is_empty()));
    let method = known.map_or(name, |(_, method)| method);
    let others: Vec<String> = others.iter().map(|other| written(other)).collect();
    is_elementary(method).then(|| format!("{text}.{method}({})", others.join(", ")))
}

/// An expression as the receiver of a method.
fn receiver(expression: &Expr) -> String {
    match expression {
        Expr::Path(_) | Expr::Index(_) | Expr::MethodCall(_) | Expr::Call(_) | Expr::Field(_) | Expr::Paren(_) => {
            written(expression)
        }
        Expr::Reference(inner) => receiver(&inner.expr),
        Expr::Lit(ExprLit { lit: Lit::Float(_), .. }) => format!("{}_f64", written(expression)),
        _ => format!("({})", written(expression)),
    }
}

/// An expression as one would type it.
fn written(expression: &Expr) -> String {
    let mut text = quoted(expression);
    for (tight, loose) in [("]", "] "), (")", ") ")] {
        for sign in ["+", "-", "*", "/"] {
            text = text.replace(&format!("{tight}{sign} "), &format!("{loose}{sign} "));
        }
    }
    match text.strip_prefix("- ") {
        Some(rest) => format!("-{rest}"),
        None => text,
    }
}

fn without_reference(expression: &Expr) -> &Expr {
    match expression {
        Expr::Reference(inner) => without_reference(&inner.expr),
        other => other,
    }
}

fn is_whole(exponent: &Expr) -> bool {
    match exponent {
        Expr::Lit(ExprLit { lit: Lit::Int(_), .. }) => true,
        Expr::Unary(ExprUnary { op: UnOp::Neg(_), expr, .. }) => is_whole(expr),
        Expr::Paren(inner) => is_whole(&inner.expr),
        _ => false,
    }
}
