//! Changes of a text that leave it Rust: operators, numbers, bounds, conditions, functions and adaptors.

use crate::{
    bounded::{Arguments, functions_of},
    choice::Choices,
};
use proc_macro2::{Delimiter, Group, Literal, Spacing, TokenStream, TokenTree};
use quote::{format_ident, quote};

/// What a change puts in the place of so many tokens.
type Changed = Option<(usize, TokenStream)>;

/// A kind of change: what stands in the place of so many tokens from a place on, where it applies.
pub(crate) struct Mutation {
    pub(crate) name: &'static str,
    change: fn(&[TokenTree], usize, &mut Choices) -> Changed,
}

pub(crate) const MUTATIONS: &[Mutation] = &[
    Mutation { name: "another operator", change: operator },
    Mutation { name: "another comparison", change: comparison },
    Mutation { name: "another number", change: number },
    Mutation { name: "another integer", change: integer },
    Mutation { name: "another sign of an addend", change: addend },
    Mutation { name: "another condition", change: condition },
    Mutation { name: "a range that is longer by one", change: range },
    Mutation { name: "another function", change: function },
    Mutation { name: "one more adaptor", change: adaptor },
];

fn mark(token: Option<&TokenTree>) -> Option<char> {
    match token {
        Some(TokenTree::Punct(mark)) => Some(mark.as_char()),
        _ => None,
    }
}

fn is_joint(token: &TokenTree) -> bool {
    matches!(token, TokenTree::Punct(mark) if mark.spacing() == Spacing::Joint)
}

/// Whether a token ends an operand.
fn ends_operand(tokens: &[TokenTree], place: usize) -> bool {
    match place.checked_sub(1).map(|before| &tokens[before]) {
        Some(TokenTree::Ident(name)) => name != "in" && name != "return" && name != "if",
        Some(TokenTree::Literal(_)) => true,
        Some(TokenTree::Group(group)) => group.delimiter() != Delimiter::Brace,
        _ => false,
    }
}

fn operator(tokens: &[TokenTree], place: usize, choices: &mut Choices) -> Changed {
    let sign = mark(Some(&tokens[place])).filter(|sign| "+-*/".contains(*sign))?;
    if is_joint(&tokens[place]) || mark(tokens.get(place + 1)) == Some('=') || !ends_operand(tokens, place) {
        return None;
    }
    let other = choices.of(&["+", "-", "*", "/"]);
    if other.starts_with(sign) { None } else { Some((1, other.parse().ok()?)) }
}

fn comparison(tokens: &[TokenTree], place: usize, choices: &mut Choices) -> Changed {
    mark(Some(&tokens[place])).filter(|sign| "<>".contains(*sign))?;
    let is_generic =
        !ends_operand(tokens, place) || mark(place.checked_sub(1).map(|before| &tokens[before])) == Some(':');
    if is_generic || tokens.get(place + 1).is_some_and(|token| token.to_string() == "f64") {
        return None;
    }
    let length = if mark(tokens.get(place + 1)) == Some('=') { 2 } else { 1 };
    Some((length, choices.of(&["<", "<=", ">", ">="]).parse().ok()?))
}

fn literal(token: &TokenTree) -> Option<String> {
    match token {
        TokenTree::Literal(literal) => Some(literal.to_string()),
        _ => None,
    }
}

fn number(tokens: &[TokenTree], place: usize, choices: &mut Choices) -> Changed {
    literal(&tokens[place]).filter(|text| text.contains('.'))?;
    Some((1, choices.of(&["0.0", "1.0", "2.0", "(-1.0)", "0.5", "3.0"]).parse().ok()?))
}

fn integer(tokens: &[TokenTree], place: usize, choices: &mut Choices) -> Changed {
    let value: u64 = literal(&tokens[place])?.parse().ok()?;
    let before = mark(place.checked_sub(1).map(|before| &tokens[before]));
    // A place of a tuple, or the length of an array.
    let is_range = place > 1 && mark(Some(&tokens[place - 2])) == Some('.');
    if before == Some(';') || before == Some('.') && !is_range {
        return None;
    }
    let value = if choices.percent(50) { value + 1 } else { value.saturating_sub(1) };
    let value = Literal::u64_unsuffixed(value);
    Some((1, quote!(#value)))
}

fn addend(tokens: &[TokenTree], place: usize, _: &mut Choices) -> Changed {
    match (mark(Some(&tokens[place]))?, mark(tokens.get(place + 1))?) {
        ('+', '=') => Some((2, quote!(-=))),
        ('-', '=') => Some((2, quote!(+=))),
        _ => None,
    }
}

/// The condition of a branch, turned around or taken for granted.
fn condition(tokens: &[TokenTree], place: usize, choices: &mut Choices) -> Changed {
    if !matches!(&tokens[place], TokenTree::Ident(name) if name == "if") {
        return None;
    }
    let is_body = |token: &TokenTree| matches!(token, TokenTree::Group(group) if group.delimiter() == Delimiter::Brace);
    let length = tokens[place..].iter().position(is_body)?;
    let condition: TokenStream = tokens[place + 1..place + length].iter().cloned().collect();
    let changed = match choices.below(3) {
        0 => quote!(if !(#condition)),
        1 => quote!(if true),
        _ => quote!(if false),
    };
    Some((length, changed))
}

fn range(tokens: &[TokenTree], place: usize, _: &mut Choices) -> Changed {
    let dots = [place, place + 1].map(|place| mark(tokens.get(place)) == Some('.'));
    let is_open = tokens.get(place + 2).is_none() || mark(tokens.get(place + 2)) == Some('=');
    (dots == [true; 2] && is_joint(&tokens[place]) && !is_open).then(|| (2, quote!(..=)))
}

fn function(tokens: &[TokenTree], place: usize, choices: &mut Choices) -> Changed {
    let TokenTree::Ident(name) = &tokens[place] else { return None };
    // Few that are not defined everywhere, so that most values stay numbers.
    let of_one = [functions_of(Arguments::Any), vec!["abs", "exp", "ln_1p", "recip", "signum", "sqrt", "tan"]].concat();
    let alike: [&[&str]; 4] =
        [&of_one, &["min", "max", "hypot", "atan2"], &["windows", "chunks_exact"], &["skip", "take", "step_by"]];
    let known = alike.into_iter().find(|names| names.iter().any(|known| name == known))?;
    let other = format_ident!("{}", choices.of(known));
    (other != *name).then(|| (1, quote!(#other)))
}

fn adaptor(tokens: &[TokenTree], place: usize, choices: &mut Choices) -> Changed {
    let is_iterator = matches!(&tokens[place], TokenTree::Ident(name) if name == "iter");
    let call = tokens.get(place + 1).filter(|_| is_iterator)?;
    let more = [".rev()", ".skip(1)", ".take(2)", ".step_by(2)", ".skip(1).rev()", ".rev().skip(1)", ".rev().take(2)"];
    let more: TokenStream = choices.of(&more).parse().ok()?;
    Some((2, quote!(iter #call #more)))
}

/// The text of an impl with one change of a kind in its functions, if one applies.
pub(crate) fn mutated(item: &TokenStream, mutation: &Mutation, choices: &mut Choices) -> Option<TokenStream> {
    let place = choices.below(usize::MAX);
    let walk = |left| {
        let mut walk = Walk { mutation, left, seen: 0, choices };
        let changed = walk.bodies(item.clone(), 0);
        (changed, walk.seen)
    };
    let (_, count) = walk(usize::MAX);
    let (changed, _) = walk(place.checked_rem(count)?);
    (changed.to_string() != item.to_string()).then_some(changed)
}

/// A way through a text to the place that is changed.
struct Walk<'m> {
    mutation: &'m Mutation,
    /// How many places are passed by.
    left: usize,
    seen: usize,
    choices: &'m Choices,
}

impl Walk<'_> {
    /// Groups in braces within the braces of an impl are the bodies of its functions.
    fn bodies(&mut self, tokens: TokenStream, depth: usize) -> TokenStream {
        let of = |walk: &mut Self, token| match token {
            TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => {
                let inner = match depth {
                    0 => walk.bodies(group.stream(), 1),
                    _ => walk.within(group.stream()),
                };
                TokenTree::Group(Group::new(Delimiter::Brace, inner))
            }
            other => other,
        };
        tokens.into_iter().map(|token| of(self, token)).collect()
    }

    fn within(&mut self, tokens: TokenStream) -> TokenStream {
        let tokens: Vec<TokenTree> = tokens.into_iter().collect();
        let (mut changed, mut place) = (TokenStream::new(), 0);
        while place < tokens.len() {
            // The same choices lead here when places are counted and when one is changed.
            let found = (self.mutation.change)(&tokens, place, &mut self.choices.clone());
            if let Some((length, new)) = found {
                self.seen += 1;
                if self.left == 0 {
                    self.left = usize::MAX;
                    changed.extend(new);
                    place += length;
                    continue;
                }
                self.left -= 1;
            }
            match &tokens[place] {
                TokenTree::Group(group) => {
                    let inner = self.within(group.stream());
                    changed.extend([TokenTree::Group(Group::new(group.delimiter(), inner))]);
                }
                other => changed.extend([other.clone()]),
            }
            place += 1;
        }
        changed
    }
}
