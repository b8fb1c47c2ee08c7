//! Source of the user that is moved to a place where it is evaluated once per run.

use proc_macro2::{Delimiter, Group, Ident, Span, TokenStream, TokenTree};
use quote::{ToTokens, quote};
use syn::{Expr, ExprReference, ItemUse, UseTree};

/// The text of variables that an expression mentions, declared in front of it, so that it can stand alone. All are declared
/// together: what one stands for may mention a name of the generated code that another one has.
pub(crate) fn with_variables(text: TokenStream, variables: &[(Ident, TokenStream)]) -> TokenStream {
    match variables {
        [] => text,
        [(name, value)] => quote!({ let #name = #value; #text }),
        _ => {
            let (names, values): (Vec<_>, Vec<_>) = variables.iter().map(|(name, value)| (name, value)).unzip();
            quote!({ let (#(#names),*) = (#(#values),*); #text })
        }
    }
}

/// `list[at]`, where a panic is located: in the user's own brackets.
pub(crate) fn element(list: TokenStream, at: TokenStream, brackets: Span) -> TokenStream {
    let mut index = Group::new(Delimiter::Bracket, at);
    index.set_span(brackets);
    quote!(#list #index)
}

/// `(text)`, located where the text begins. They stay parentheses of the macro's, about which no lint speaks to the user.
pub(crate) fn in_parentheses(text: TokenStream) -> TokenStream {
    let place = text.clone().into_iter().next().map_or_else(Span::call_site, |token| token.span());
    let mut group = Group::new(Delimiter::Parenthesis, text);
    group.set_span(Span::call_site().located_at(place));
    group.to_token_stream()
}

/// What parentheses contain, or the group that a macro made of an argument.
pub(crate) fn without_parentheses(expression: &Expr) -> &Expr {
    match expression {
        Expr::Paren(inner) => without_parentheses(&inner.expr),
        Expr::Group(inner) => without_parentheses(&inner.expr),
        other => other,
    }
}

/// A reference to what a text stands for.
pub(crate) fn reference_to(text: &TokenStream) -> TokenStream {
    match syn::parse2(quote!(&#text)) {
        Ok(Expr::Reference(_)) => quote!((&#text)),
        _ => quote!((&(#text))),
    }
}

/// Whether an expression is a reference written as such.
pub(crate) fn is_reference(expression: &Expr) -> bool {
    match expression {
        Expr::Paren(inner) => is_reference(&inner.expr),
        Expr::Reference(_) => true,
        _ => false,
    }
}

/// What a text refers to, if it is a reference written as such.
pub(crate) fn referent(text: &TokenStream) -> Option<TokenStream> {
    let mut tokens = text.clone().into_iter();
    match (tokens.next(), tokens.next()) {
        (Some(TokenTree::Group(group)), None) if group.delimiter() == Delimiter::Parenthesis => {
            referent(&group.stream())
        }
        (Some(TokenTree::Punct(mark)), Some(_)) if mark.as_char() == '&' => match syn::parse2(text.clone()) {
            Ok(Expr::Reference(ExprReference { mutability: None, expr, .. })) => Some(match *expr {
                Expr::Unary(_) => operand(expr.to_token_stream()),
                _ => expr.to_token_stream(),
            }),
            _ => None,
        },
        _ => None,
    }
}

/// What a text refers to, by way of any number of references, or the text itself: what arithmetic, fields, indices and
/// methods see of it.
pub(crate) fn place(text: TokenStream) -> TokenStream {
    std::iter::successors(Some(text.clone()), referent).last().unwrap_or(text)
}

/// Whether a text is an item of a list, or a part of one.
pub(crate) fn mentions_item(text: &TokenStream) -> bool {
    text.clone().into_iter().any(|token| match token {
        TokenTree::Group(group) if group.delimiter() == Delimiter::Bracket => true,
        TokenTree::Group(group) => mentions_item(&group.stream()),
        _ => false,
    })
}

/// Text that means the same outside the function that it comes from: it brings what the function imports, and its `self`
/// is that of the function it is moved to, also where a macro of the user gave it another hygiene.
pub(crate) fn standing_alone(text: TokenStream, uses: &[ItemUse]) -> TokenStream {
    let mut names = Vec::new();
    identifiers(text.clone(), &mut names);
    let text = with_own_self(text);
    let used: Vec<&ItemUse> = uses.iter().filter(|item| imports(&item.tree, &names)).collect();
    if used.is_empty() {
        return text;
    }
    quote!({ #(#[allow(unused_imports, reason = "imports are moved as a whole")] #used)* #text })
}

/// Whether an import brings one of these names, as far as can be told.
fn imports(tree: &UseTree, names: &[Ident]) -> bool {
    match tree {
        UseTree::Path(path) => imports(&path.tree, names),
        UseTree::Name(name) => names.contains(&name.ident),
        UseTree::Rename(name) => names.contains(&name.rename),
        UseTree::Glob(_) => true,
        UseTree::Group(group) => group.items.iter().any(|tree| imports(tree, names)),
    }
}

/// Text whose `self` is that of the function it is moved to.
pub(crate) fn with_own_self(text: TokenStream) -> TokenStream {
    let own = |tree| match tree {
        TokenTree::Ident(name) if name == "self" => {
            Ident::new("self", name.span().resolved_at(Span::call_site())).into()
        }
        TokenTree::Group(group) => {
            let mut own = Group::new(group.delimiter(), with_own_self(group.stream()));
            own.set_span(group.span());
            own.into()
        }
        other => other,
    };
    text.into_iter().map(own).collect()
}

/// Every identifier of a text that could be a variable, once: no field or method, but the bound of a range.
pub(crate) fn identifiers(text: TokenStream, found: &mut Vec<Ident>) {
    let (mut after_dot, mut dots) = (false, 0);
    for token in text {
        match &token {
            TokenTree::Ident(name) if !after_dot && !found.contains(name) && name != "self" => found.push(name.clone()),
            TokenTree::Group(group) => identifiers(group.stream(), found),
            _ => {}
        }
        dots = if matches!(&token, TokenTree::Punct(mark) if mark.as_char() == '.') { dots + 1 } else { 0 };
        after_dot = dots == 1;
    }
}

/// Text without parentheses around all of it, as those of the value of a variable.
pub(crate) fn bare(text: TokenStream) -> TokenStream {
    let mut tokens = text.clone().into_iter();
    match (tokens.next(), tokens.next()) {
        (Some(TokenTree::Group(group)), None) if group.delimiter() == Delimiter::Parenthesis => bare(group.stream()),
        _ => text,
    }
}

/// Text that stands for one operand wherever it is put.
pub(crate) fn operand(text: TokenStream) -> TokenStream {
    let mut tokens = text.clone().into_iter();
    match (tokens.next(), tokens.next()) {
        (Some(_), Some(_)) => in_parentheses(text),
        _ => text,
    }
}
