//! List elements that may be missing: code that checks for them before it reads them.

use proc_macro2::TokenStream;
use quote::{ToTokens, quote};
use syn::{BinOp, Expr, Lit, Path, Stmt};

/// A number that is looked up where its lists have it, and is NaN elsewhere; `None` of a text that reads no lists.
pub(crate) fn looked_up(text: &TokenStream, root: &Path) -> Option<TokenStream> {
    let there = is_there(text, root)?;
    Some(quote!((if #there { #text } else { f64::NAN })))
}

/// The text that [`looked_up`] made another one of.
pub(super) fn unlooked(text: &TokenStream) -> Option<TokenStream> {
    let Ok(Expr::Paren(inner)) = syn::parse2::<Expr>(text.clone()) else { return None };
    let Expr::If(choice) = *inner.expr else { return None };
    let (_, other) = choice.else_branch?;
    let is_looked_up = other.to_token_stream().to_string() == "{ f64 :: NAN }";
    let [Stmt::Expr(number, None)] = &choice.then_branch.stmts[..] else { return None };
    is_looked_up.then(|| number.to_token_stream())
}

/// The condition that the lists in a text have its elements; `None` of a text that reads no lists.
pub(crate) fn is_there(text: &TokenStream, root: &Path) -> Option<TokenStream> {
    let expression = syn::parse2::<Expr>(text.clone()).ok()?;
    let mut found = Vec::new();
    list(&expression, root, &mut found);
    (!found.is_empty()).then(|| quote!(#(#found)&&*))
}

/// Adds what has to hold for the lists in an expression to have its elements, those needed first in front. What a closure
/// or a branch inside of it reads is left to them.
fn list(expression: &Expr, root: &Path, found: &mut Vec<TokenStream>) {
    match expression {
        Expr::Paren(inner) => list(&inner.expr, root, found),
        Expr::Reference(inner) => list(&inner.expr, root, found),
        Expr::Unary(inner) => list(&inner.expr, root, found),
        Expr::Cast(inner) => list(&inner.expr, root, found),
        Expr::Field(inner) => list(&inner.base, root, found),
        Expr::MethodCall(call) => list(&call.receiver, root, found),
        Expr::Binary(binary) if !matches!(binary.op, BinOp::And(_) | BinOp::Or(_)) => {
            list(&binary.left, root, found);
            list(&binary.right, root, found);
        }
        Expr::Index(indexed) => {
            list(&indexed.expr, root, found);
            if is_integer(&indexed.index) {
                list(&indexed.index, root, found);
                differences(&indexed.index, found);
                let (of, at) = (&indexed.expr, &indexed.index);
                found.push(quote!(#root::__private::Elements(&#of).has(#at)));
            }
        }
        _ => {}
    }
}

/// Whether an index is made of integers without a sign, as one into a list is.
fn is_integer(index: &Expr) -> bool {
    match index {
        Expr::Lit(literal) => matches!(literal.lit, Lit::Int(_)),
        Expr::Path(_) | Expr::Field(_) | Expr::Index(_) => true,
        Expr::MethodCall(call) => call.method == "len",
        Expr::Paren(inner) => is_integer(&inner.expr),
        Expr::Binary(binary) => is_integer(&binary.left) && is_integer(&binary.right),
        _ => false,
    }
}

/// Adds that no difference in an index is below zero, and that nothing is divided by zero.
fn differences(index: &Expr, found: &mut Vec<TokenStream>) {
    match index {
        Expr::Paren(inner) => differences(&inner.expr, found),
        Expr::Binary(binary) => {
            differences(&binary.left, found);
            differences(&binary.right, found);
            let (left, right) = (&binary.left, &binary.right);
            match binary.op {
                BinOp::Sub(_) => found.push(quote!((#right) <= (#left))),
                BinOp::Div(_) | BinOp::Rem(_) => found.push(quote!((#right) != 0)),
                _ => {}
            }
        }
        _ => {}
    }
}
