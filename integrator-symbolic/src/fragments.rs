//! Fragments of `macro_rules!`, such as `$width:literal`: invisible groups without delimiters.
//!
//! In: tokens. Out: the same tokens without such groups, so that all readers can recognise literals, types and formulas
//! by their form. If the content binds less strongly than an adjacent operator, it gets parentheses.

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use syn::{BinOp, Expr};

/// The tokens without groups that have no delimiters.
pub(crate) fn without_groups(tokens: TokenStream) -> TokenStream {
    tokens.into_iter().flat_map(opened).collect()
}

fn opened(tree: TokenTree) -> TokenStream {
    let TokenTree::Group(group) = tree else { return tree.into() };
    let inner = without_groups(group.stream());
    let delimiter = match group.delimiter() {
        Delimiter::None if is_one_operand(&inner) => return inner,
        Delimiter::None => Delimiter::Parenthesis,
        delimiter => delimiter,
    };
    let mut opened = Group::new(delimiter, inner);
    opened.set_span(group.span());
    TokenTree::from(opened).into()
}

/// Whether tokens stay together beside any operator, or are no formula: a literal, a path, a type, a statement.
fn is_one_operand(tokens: &TokenStream) -> bool {
    tokens.clone().into_iter().nth(1).is_none()
        || syn::parse2(tokens.clone()).map_or(true, |formula| match formula {
            Expr::Binary(binary) => is_assignment(&binary.op),
            Expr::Cast(_) | Expr::Closure(_) | Expr::If(_) | Expr::Match(_) | Expr::Range(_) | Expr::Reference(_) => {
                false
            }
            Expr::Unary(_) => false,
            _ => true,
        })
}

fn is_assignment(op: &BinOp) -> bool {
    use BinOp::{AddAssign, DivAssign, MulAssign, RemAssign, SubAssign};
    matches!(op, AddAssign(_) | DivAssign(_) | MulAssign(_) | RemAssign(_) | SubAssign(_))
}
