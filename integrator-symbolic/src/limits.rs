//! Limits on the depth and size of an annotated impl and of compositions. Larger input is an error, since it could
//! overflow the compiler's stack or take minutes.

use crate::errors::Errors;
use proc_macro2::{Delimiter, Span, TokenStream, TokenTree};

/// How deeply brackets, signs and calls may be nested. The parser's own stack ends near 500 nested blocks.
pub(crate) const DEEPEST: usize = 200;

/// How deeply expressions may be nested that are read, those of helper methods inside of their calls. The reader's stack ends
/// near a thousand of them where it is compiled without optimisation.
pub(crate) const NESTED: usize = 500;

/// How many different operations a Hamiltonian may have, sums counted once.
pub(crate) const OPERATIONS: usize = 100_000;

/// How many expressions may be read, those of helper methods as often as they are called.
pub(crate) const READINGS: u32 = 1_000_000;

/// How many operations the energies and their derivatives may have together, loops counted once: rustc takes about a minute for
/// as many.
pub(crate) const COMPILED: usize = 15_000;

/// Notes the place where the nesting goes too deep, if there is one. Works on tokens, before anything recurses.
pub(crate) fn check_depth(tokens: &TokenStream, errors: &mut Errors) -> bool {
    let Some(span) = too_deep(tokens.clone()) else { return true };
    let message = format!("nested more than {DEEPEST} levels deep\nhelp: name inner parts with `let`, or write a loop");
    errors.at_span(span, message);
    false
}

/// Walks the token trees with a stack of its own.
fn too_deep(tokens: TokenStream) -> Option<Span> {
    let mut open = vec![(tokens.into_iter(), Run::default())];
    while let Some((trees, run)) = open.last_mut() {
        let Some(tree) = trees.next() else {
            open.pop();
            continue;
        };
        run.see(&tree);
        if open.len() + open.iter().map(|(_, run)| run.nested()).sum::<usize>() > DEEPEST {
            return Some(tree.span());
        }
        if let TokenTree::Group(group) = tree {
            open.push((group.stream().into_iter(), Run::default()));
        }
    }
    None
}

/// What nests without brackets: signs in front of an expression, calls after one, and arguments of types.
#[derive(Default)]
struct Run {
    signs: usize,
    calls: usize,
    /// `<` among names alone, as in `Option<Option<..`.
    types: usize,
}

impl Run {
    fn see(&mut self, tree: &TokenTree) {
        self.types = match tree {
            TokenTree::Punct(mark) if mark.as_char() == '<' => self.types + 1,
            TokenTree::Punct(mark) if mark.as_char() == ':' => self.types,
            TokenTree::Ident(_) => self.types,
            _ => 0,
        };
        match tree {
            TokenTree::Punct(mark) if mark.as_char() == '.' => self.calls += 1,
            TokenTree::Punct(mark) if matches!(mark.as_char(), '-' | '!' | '*' | '&') => {
                (self.signs, self.calls) = (self.signs + 1, 0);
            }
            TokenTree::Punct(_) => (self.signs, self.calls) = (0, 0),
            TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => (self.signs, self.calls) = (0, 0),
            TokenTree::Ident(_) | TokenTree::Literal(_) | TokenTree::Group(_) => self.signs = 0,
        }
    }

    fn nested(&self) -> usize {
        self.signs + self.calls + self.types
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn passes(text: &str) -> bool {
        let tokens: TokenStream = text.parse().expect("tokens");
        check_depth(&tokens, &mut Errors::default())
    }

    #[test]
    fn depth_is_counted_through_brackets_signs_and_calls() {
        let nested = |open: &str, close: &str, count| format!("{}x{}", open.repeat(count), close.repeat(count));
        for (open, close) in
            [("(", ")"), ("{", "}"), ("[", "]"), ("- ", ""), ("!", ""), ("", ".sin()"), ("std::option::Option<", ">")]
        {
            assert!(passes(&nested(open, close, 100)), "{open}{close}");
            assert!(!passes(&nested(open, close, 300)), "{open}{close}");
        }
    }

    #[test]
    fn length_is_not_depth() {
        let long = vec!["-q[0].cos() * (x - 1.0).powi(2)"; 5000].join(" + ");
        assert!(passes(&long));
        assert!(passes(&vec!["x < 1.0 || x < y"; 5000].join(" && ")));
    }
}
