//! A fingerprint of generated code, independent of its documentation and of the spaces between its tokens.

use proc_macro2::{Literal, TokenStream, TokenTree};

/// FNV-1a over the tokens, as a literal.
pub(super) fn fingerprint(tokens: TokenStream) -> Literal {
    let mut hash = 0xcbf2_9ce4_8422_2325;
    add(tokens, &mut hash);
    Literal::u64_unsuffixed(hash)
}

fn add(tokens: TokenStream, hash: &mut u64) {
    let mut tokens = tokens.into_iter().peekable();
    while let Some(token) = tokens.next() {
        match token {
            TokenTree::Punct(mark) if mark.as_char() == '#' && tokens.peek().is_some_and(is_documentation) => {
                tokens.next();
            }
            TokenTree::Group(group) => {
                text(&format!("{:?}", group.delimiter()), hash);
                add(group.stream(), hash);
                text("end", hash);
            }
            TokenTree::Ident(name) => text(&name.to_string(), hash),
            TokenTree::Punct(mark) => text(mark.as_char().encode_utf8(&mut [0; 4]), hash),
            TokenTree::Literal(literal) => text(&literal.to_string(), hash),
        }
    }
}

/// Whether this is the group of a doc comment, `[doc = ..]`.
fn is_documentation(token: &TokenTree) -> bool {
    let TokenTree::Group(group) = token else { return false };
    matches!(group.stream().into_iter().next(), Some(TokenTree::Ident(name)) if name == "doc")
}

fn text(text: &str, hash: &mut u64) {
    // No text has the last byte in it.
    for byte in text.bytes().chain([0xff]) {
        *hash = (*hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
    }
}

#[cfg(test)]
mod tests {
    use super::fingerprint;
    use proc_macro2::TokenStream;

    #[test]
    fn other_tokens_have_other_fingerprints() {
        let of = |text: &str| fingerprint(text.parse::<TokenStream>().expect("tokens")).to_string();
        assert_eq!(of("a + b (c)"), of("a+b(c)"));
        for other in ["a + bc", "ab + c", "a + b", "a + b [c]", "a + (b c)", "a - b (c)", "b + a (c)", "a + b (c) c"] {
            assert_ne!(of(other), of("a + b (c)"), "{other}");
        }
    }

    #[test]
    fn comments_have_no_fingerprint() {
        let of = |text: &str| fingerprint(text.parse::<TokenStream>().expect("tokens")).to_string();
        let function = "#[inline] fn f() {}";
        assert_eq!(of("/// First.\n#[inline]\n/// Second.\nfn f() {}"), of(function));
        for other in ["fn f() {}", "# fn f() {}", "#[inline] fn doc() {}"] {
            assert_ne!(of(other), of(function), "{other}");
        }
    }
}
