//! Lists of lists as nested loops: `flatten` and `flat_map`.
//!
//! A sum over `rows.flatten()` is interpreted as the sum over the rows of the sums over each row. The two loops remain,
//! which is how bodies and lattices are recognised.

use proc_macro2::Ident;
use quote::format_ident;
use syn::{Block, Expr, ExprClosure, ExprForLoop, ExprMethodCall, parse_quote};

/// What may stand between the flattened lists and the end, since it reads one item at a time.
const ITEM_BY_ITEM: [&str; 4] = ["map", "filter", "copied", "cloned"];

/// `lists.flatten().map(f).sum()` as `lists.map(|list| list.iter().map(f).sum()).sum()`.
pub(crate) fn nested_sum(sum: &ExprMethodCall) -> Option<Expr> {
    if sum.method != "sum" {
        return None;
    }
    let Nested { lists, pattern, items } = nested(&sum.receiver)?;
    let inner: Expr = parse_quote!(#items.sum::<f64>());
    Some(parse_quote!(#lists.map(|#pattern| #inner).sum::<f64>()))
}

/// `for x in lists.flatten() { ... }` as `for list in lists { for x in list.iter() { ... } }`.
pub(crate) fn nested_loop(repeat: &ExprForLoop) -> Option<ExprForLoop> {
    let Nested { lists, pattern, items } = nested(&repeat.expr)?;
    let inner = ExprForLoop { expr: Box::new(items), label: None, ..repeat.clone() };
    let body: Block = parse_quote!({ #inner });
    Some(ExprForLoop { pat: Box::new(pattern), expr: Box::new(lists), body, ..repeat.clone() })
}

/// A list of lists, a name for each of them, and what runs over its items.
struct Nested {
    lists: Expr,
    pattern: syn::Pat,
    items: Expr,
}

fn nested(sequence: &Expr) -> Option<Nested> {
    let mut behind = Vec::new();
    let mut at = sequence;
    let flattened = loop {
        match at {
            Expr::Paren(inner) => at = &inner.expr,
            Expr::MethodCall(link) if matches!(link.method.to_string().as_str(), "flatten" | "flat_map") => break link,
            Expr::MethodCall(link) if ITEM_BY_ITEM.contains(&link.method.to_string().as_str()) => {
                behind.push(link);
                at = &link.receiver;
            }
            _ => return None,
        }
    };
    let (pattern, first) = match flattened.args.first() {
        None => {
            let list = name();
            (parse_quote!(#list), parse_quote!(#list.iter()))
        }
        Some(Expr::Closure(ExprClosure { inputs, body, .. })) if inputs.len() == 1 => {
            (inputs[0].clone(), (**body).clone())
        }
        Some(_) => return None,
    };
    let items = behind
        .into_iter()
        .rev()
        .fold(first, |items, link| Expr::MethodCall(ExprMethodCall { receiver: Box::new(items), ..link.clone() }));
    Some(Nested { lists: (*flattened.receiver).clone(), pattern, items })
}

/// A name that no user has.
fn name() -> Ident {
    format_ident!("__list")
}
