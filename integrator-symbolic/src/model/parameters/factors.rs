//! Factors of the user's parameter expressions, by their tokens.

use proc_macro2::{TokenStream, TokenTree};

/// The factors of a product, each with its exponent; anything else as it is.
pub(crate) fn factors(text: TokenStream) -> Vec<(TokenStream, i32)> {
    let mut factors = Vec::new();
    match split(text.clone(), 1, &mut factors) {
        true => factors,
        false => vec![(text, 1)],
    }
}

/// Collects the factors of a product; `false` if the text is something else.
fn split(text: TokenStream, exponent: i32, factors: &mut Vec<(TokenStream, i32)>) -> bool {
    let mut factor: Vec<TokenTree> = Vec::new();
    let mut sign = exponent;
    for token in text {
        match &token {
            TokenTree::Punct(mark) if matches!(mark.as_char(), '*' | '/') => {
                if !close(std::mem::take(&mut factor), sign, factors) {
                    return false;
                }
                sign = if mark.as_char() == '/' { -exponent } else { exponent };
            }
            TokenTree::Punct(mark) if !matches!(mark.as_char(), '.' | ':') => return false,
            TokenTree::Ident(name) if name == "as" => return false,
            _ => factor.push(token),
        }
    }
    close(factor, sign, factors)
}

/// Collects one factor, or those of a product in parentheses.
fn close(factor: Vec<TokenTree>, exponent: i32, factors: &mut Vec<(TokenStream, i32)>) -> bool {
    if let [TokenTree::Group(group)] = &factor[..] {
        let known = factors.len();
        if split(group.stream(), exponent, factors) {
            return true;
        }
        factors.truncate(known);
    }
    let is_some = !factor.is_empty();
    factors.push((factor.into_iter().collect(), exponent));
    is_some
}
