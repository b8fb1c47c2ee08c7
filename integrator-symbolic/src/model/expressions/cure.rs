//! Constructs of other languages, and their equivalents in Rust.

use crate::errors::quoted;
use crate::model::{
    expressions::elementary::is_elementary,
    parameters::text::without_parentheses,
    values::{
        value::{Value, is_list},
        whole::as_number,
    },
};
use proc_macro2::{Ident, TokenStream};
use quote::quote;
use syn::{BinOp, Expr, ExprBinary, ExprCall, ExprLit, ExprUnary, Lit, UnOp};

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

/// Where other languages have their functions of numbers.
const MODULES: [&str; 7] = ["math", "Math", "cmath", "np", "numpy", "std", "f32"];

/// Whether a function is called by its name alone, or by that of a module of another language.
pub(crate) fn is_elsewhere(segments: &[&Ident]) -> bool {
    match segments {
        [_] => true,
        [module, _] => MODULES.iter().any(|name| *module == name),
        _ => false,
    }
}

/// What to write for a call of a name with arguments, the first of which may be its receiver; nothing where that is not known.
/// `is_list` says that the first one is a list.
pub(crate) fn in_rust(name: &str, arguments: &[&Expr], is_list: bool) -> Option<String> {
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
        ("pow" | "power", [exponent]) => return Some(power(first, exponent)),
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
        Expr::Lit(ExprLit { lit: Lit::Int(number), .. }) => format!("{}_f64", as_number(number)),
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

/// A power as Rust writes it.
fn power(base: &Expr, exponent: &Expr) -> String {
    let (base, exponent) = (receiver(base), without_parentheses(exponent));
    match number_of(exponent) {
        Some(number) if is_whole(number) => format!("{base}.powi({number})"),
        _ => format!("{base}.powf({})", written(exponent)),
    }
}

/// What to write for an exponent of `powi` that is no integer.
pub(crate) fn by_powf(exponent: &Expr) -> String {
    let exponent = without_parentheses(exponent);
    let by_powf = format!("`powf({})`", written(exponent));
    match number_of(exponent) {
        Some(number) if is_whole(number) => format!("`powi({number})` or {by_powf}"),
        _ => by_powf,
    }
}

/// A power by an operator of another language, and what Rust writes for it.
pub(crate) struct Power {
    /// The base, the operator and the exponent.
    pub(crate) place: TokenStream,
    pub(crate) message: String,
}

/// The power that an operator is meant for, if it is followed by a number: `a ** 2`, which is `a` times what a number refers to,
/// and `a ^ 2`. The base is the last factor on the left, the exponent the first one on the right.
pub(crate) fn power_by_operator(link: &ExprBinary) -> Option<Power> {
    let (is, exponent) = match (&link.op, &*link.right) {
        (BinOp::Mul(_), Expr::Unary(ExprUnary { op: UnOp::Deref(_), expr, .. })) => ("no operator", &**expr),
        (BinOp::BitXor(_), right) => ("the bitwise exclusive or", leftmost(right)),
        _ => return None,
    };
    number_of(exponent)?;
    Some(power_of(link, is, exponent))
}

/// The power that `a ^ b` is meant for, where it is one of numbers.
pub(crate) fn power_by_exclusive_or(link: &ExprBinary) -> Power {
    power_of(link, "the bitwise exclusive or", leftmost(&link.right))
}

/// What to write for an operator on the bits of integers.
pub(crate) fn bits_by_arithmetic(op: &str) -> String {
    format!(
        "this use of `{op}` on an integer that depends on a loop is not supported\nhelp: use `+`, `-`, `*`, `/` and \
         `%`\nnote: `<< n`, `>> n`, `& (2^n - 1)` and `^ 1` are supported if the right side is a literal and the \
         integer is never negative"
    )
}

/// What to write for an operator between arrays, such as points, or between an array and a number: the same for each component.
pub(crate) fn by_components(op: &BinOp, sides: [&Expr; 2], is_array: [bool; 2], count: Option<u64>) -> String {
    /// How many components are written out.
    const FEW: u64 = 3;

    let op = quoted(op);
    let component = |at: u64| {
        let [left, right] = [0, 1].map(|side| match (is_array[side], sides[side]) {
            (false, number) => written(number),
            (true, array @ (Expr::Binary(_) | Expr::Unary(_))) => format!("({})[{at}]", written(array)),
            (true, array) => format!("{}[{at}]", written(array)),
        });
        format!("{left} {op} {right}")
    };
    let help = match count.filter(|count| *count <= FEW) {
        Some(count) => format!("`[{}]`", (0..count).map(component).collect::<Vec<_>>().join(", ")),
        None => format!("`{}`, and so on", component(0)),
    };
    format!("Rust has no `{op}` for arrays, such as points\nhelp: write the components, {help}")
}

fn power_of(link: &ExprBinary, is: &str, exponent: &Expr) -> Power {
    let (base, op) = (rightmost(&link.left), &link.op);
    let sign = if let BinOp::Mul(_) = op { "**" } else { "^" };
    Power {
        place: quote!(#base #op #exponent),
        message: format!("`{sign}` is {is} in Rust\nhelp: write `{}`", power(base, exponent)),
    }
}

/// The last factor of an expression.
fn rightmost(expression: &Expr) -> &Expr {
    match expression {
        Expr::Binary(ExprBinary { right, .. }) => rightmost(right),
        Expr::Unary(ExprUnary { op: UnOp::Neg(_), expr, .. }) => rightmost(expr),
        other => other,
    }
}

/// The first factor of an expression.
fn leftmost(expression: &Expr) -> &Expr {
    match expression {
        Expr::Binary(ExprBinary { left, .. }) => leftmost(left),
        other => other,
    }
}

/// What to say of a call of a number, which is a product elsewhere, or of a list, whose elements have parentheses elsewhere.
pub(crate) fn no_function(name: &str, value: &Value, call: &ExprCall) -> Option<String> {
    let is_number = matches!(value, Value::Real(_) | Value::Joint(_) | Value::Integer(_));
    let function = written(&call.func);
    let cure = match &call.args.iter().collect::<Vec<_>>()[..] {
        [] => return None,
        indices if is_list(value) => {
            let indices: String = indices.iter().map(|index| format!("[{}]", written(index))).collect();
            format!("{function}{indices}")
        }
        [factor @ Expr::Binary(_)] if is_number => format!("{function} * ({})", written(factor)),
        [Expr::Lit(ExprLit { lit: Lit::Int(factor), .. })] if is_number => {
            format!("{function} * {}", as_number(factor))
        }
        [factor] if is_number => format!("{function} * {}", written(factor)),
        _ => return None,
    };
    Some(format!("{name} is {}, not a function\nhelp: write `{cure}`", value.describe()))
}

/// The value of a literal, with its sign.
fn number_of(expression: &Expr) -> Option<f64> {
    match expression {
        Expr::Lit(ExprLit { lit: Lit::Int(number), .. }) => number.base10_parse().ok(),
        Expr::Lit(ExprLit { lit: Lit::Float(number), .. }) => number.base10_parse().ok(),
        Expr::Unary(ExprUnary { op: UnOp::Neg(_), expr, .. }) => number_of(expr).map(|number| -number),
        Expr::Paren(inner) => number_of(&inner.expr),
        _ => None,
    }
}

fn is_whole(number: f64) -> bool {
    number == number.trunc() && number.abs() < f64::from(1 << 30)
}
