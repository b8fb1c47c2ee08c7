//! The source of `composition!`, unchanged and with its spans.
//!
//! In: tokens. Out: a [`Block`], together with every syntax error. Parsing continues after an error: at the next stage
//! if the error was inside parentheses, otherwise at the next `;`. Nothing is resolved or computed here.

use proc_macro2::{TokenStream, TokenTree};
use quote::ToTokens;
use syn::{
    Attribute, Expr, Ident, LitInt, LitStr, Path, Token, Visibility,
    ext::IdentExt,
    parenthesized,
    parse::{ParseStream, Parser},
    punctuated::Punctuated,
    token,
};

use super::stages::{Letter, Letters};
use crate::errors::Errors;

/// The declarations of one macro call.
#[derive(Default)]
pub(super) struct Block {
    /// The path of the runtime crate, if the block renames it with `crate = path;`.
    pub(super) root: Option<Path>,
    pub(super) declarations: Vec<Declaration>,
}

/// `/// docs pub struct Name: order 4, symmetric = sequence;`
pub(super) struct Declaration {
    pub(super) attributes: Vec<Attribute>,
    pub(super) visibility: Visibility,
    pub(super) name: Ident,
    pub(super) claims: Claims,
    /// Absent if it could not be parsed.
    pub(super) sequence: Option<Sequence>,
}

/// What a declaration says about its sequence.
#[derive(Default)]
pub(super) struct Claims {
    pub(super) order: Option<Order>,
    pub(super) symmetric: Option<Ident>,
    /// Where it was published.
    pub(super) citation: Option<LitStr>,
}

/// `order 4`, or `order (10, 6, 4)` where the second part is small.
pub(super) struct Order {
    /// One, or one for each power of the second part; never none.
    pub(super) literals: Vec<LitInt>,
    /// As typed.
    pub(super) tokens: TokenStream,
}

impl Order {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        if !input.peek(token::Paren) {
            let literal: LitInt = input.parse()?;
            return Ok(Self { tokens: literal.to_token_stream(), literals: vec![literal] });
        }
        let content;
        let parentheses = parenthesized!(content in input);
        let literals = Punctuated::<LitInt, Token![,]>::parse_terminated(&content)?;
        let mut tokens = TokenStream::new();
        parentheses.surround(&mut tokens, |inside| literals.to_tokens(inside));
        if literals.len() < 2 {
            let message = "expected several orders in parentheses\nhelp: write, for example, `order (8, 2)`, one for \
                           each power of the small second part";
            return Err(syn::Error::new_spanned(tokens, message));
        }
        Ok(Self { literals: literals.into_iter().collect(), tokens })
    }
}

/// Items in order of application.
pub(super) struct Sequence {
    pub(super) items: Vec<Item>,
    /// What the stages call the parts, if there are any.
    pub(super) named: Option<Letters>,
    /// As typed; also the span of messages about the whole.
    pub(super) tokens: TokenStream,
}

impl Sequence {
    /// What it calls the two parts, itself or in what its combinators act on.
    pub(super) fn letters(&self) -> Letters {
        let within = self.items.iter().filter_map(|item| match item {
            Item::Combined(combined) => Some(combined),
            _ => None,
        });
        let inner = within.flat_map(Combined::sequences).map(Self::letters);
        self.named.into_iter().chain(inner).find(|letters| *letters == Letters::Parts).unwrap_or_default()
    }

    /// Whether a stage of it, or of what its combinators act on, is friction.
    pub(super) fn has_friction(&self) -> bool {
        self.items.iter().any(|item| match item {
            Item::Stage { letter, .. } => *letter == Letter::O,
            Item::Name(_) => false,
            Item::Combined(combined) => combined.sequences().into_iter().any(Self::has_friction),
        })
    }

    /// The second number of the first kick that has one.
    pub(super) fn gradient(&self) -> Option<&Expr> {
        self.items.iter().find_map(|item| match item {
            Item::Stage { gradient, .. } => gradient.as_deref(),
            Item::Name(_) => None,
            Item::Combined(combined) => combined.sequences().into_iter().find_map(Self::gradient),
        })
    }
}

pub(super) enum Item {
    /// `T(a)`, `V(b)`, `V(b, c)` or `O(c)`.
    Stage { letter: Letter, coefficient: Expr, gradient: Option<Box<Expr>> },
    /// A composition declared earlier.
    Name(Ident),
    /// A combinator and what it acts on.
    Combined(Combined),
}

pub(super) enum Combined {
    /// `triple_jump(base)`
    TripleJump(Sequence),
    /// `suzuki(base)`
    Suzuki(Sequence),
    /// `adjoint(step)`
    Adjoint(Sequence),
    /// `symmetric(sequence)`: the first half, up to and with the middle stage.
    Mirrored(Sequence),
    /// `symmetric(w1, ..., wm; base)`: the first half of the weights, up to and with the middle one.
    Palindrome(Vec<Expr>, Sequence),
    /// `compose(first, second, ...)`, each over an equal part of the step.
    Equal(Vec<Sequence>),
    /// `compose(w1, ..., wm; base)`
    Weighted(Vec<Expr>, Sequence),
    /// `processed(pre; kernel)`: pre once, then steps of the kernel, and the inverse of pre before output.
    Processed(Sequence, Sequence),
}

impl Combined {
    /// What it acts on.
    fn sequences(&self) -> Vec<&Sequence> {
        match self {
            Self::TripleJump(inner) | Self::Suzuki(inner) | Self::Adjoint(inner) | Self::Mirrored(inner) => vec![inner],
            Self::Palindrome(_, inner) | Self::Weighted(_, inner) => vec![inner],
            Self::Equal(steps) => steps.iter().collect(),
            Self::Processed(pre, kernel) => vec![pre, kernel],
        }
    }
}

/// The combinators, as messages list them.
pub(super) const COMBINATORS: &str =
    "`triple_jump(..)`, `suzuki(..)`, `symmetric(..)`, `compose(..)`, `adjoint(..)` and `processed(..)`";

const STAGES: &str = "note: the stages are `T(a)`, `V(b)` and `V(b, c)`, or `A(a)` and `B(b)` of any two parts, and `O(c)` \
                      for friction";

const NO_END: &str = "expected `;` at the end of a declaration";

fn is_combinator(name: &str) -> bool {
    matches!(name, "triple_jump" | "suzuki" | "symmetric" | "compose" | "adjoint" | "processed")
}

/// Parses the input of `composition!`.
pub(super) fn block(tokens: TokenStream, errors: &mut Errors) -> Block {
    let mut block = Block::default();
    let parser = |input: ParseStream<'_>| {
        if input.peek(Token![crate]) && input.peek2(Token![=]) {
            block.root = errors.keep(root(input));
            if block.root.is_none() {
                skip_declaration(input);
            }
        }
        while !input.is_empty() {
            let found = errors.count();
            let header = header(input);
            if let Some(mut declaration) = errors.keep(header) {
                let body = body(input, &mut declaration, errors);
                errors.keep(body);
                block.declarations.push(declaration);
            }
            if errors.count() == found && !input.peek(Token![;]) {
                let sequence = block.declarations.last().and_then(|declaration| declaration.sequence.as_ref());
                errors.push(match sequence {
                    Some(sequence) if input.is_empty() => syn::Error::new_spanned(&sequence.tokens, NO_END),
                    _ => input.error(NO_END),
                });
            }
            skip_declaration(input);
        }
        Ok(())
    };
    let outcome = parser.parse2(tokens);
    errors.keep(outcome);
    block
}

fn root(input: ParseStream<'_>) -> syn::Result<Path> {
    input.parse::<Token![crate]>()?;
    input.parse::<Token![=]>()?;
    let path = input.call(Path::parse_mod_style)?;
    input.parse::<Token![;]>()?;
    Ok(path)
}

fn header(input: ParseStream<'_>) -> syn::Result<Declaration> {
    let attributes = input.call(Attribute::parse_outer)?;
    let visibility = input.parse()?;
    input.parse::<Token![struct]>()?;
    let name = input.parse()?;
    Ok(Declaration { attributes, visibility, name, claims: Claims::default(), sequence: None })
}

fn body(input: ParseStream<'_>, declaration: &mut Declaration, errors: &mut Errors) -> syn::Result<()> {
    if input.peek(Token![:]) {
        input.parse::<Token![:]>()?;
        while !input.peek(Token![=]) {
            claim(input, &mut declaration.claims, errors)?;
            if !input.peek(Token![=]) {
                input.parse::<Token![,]>()?;
            }
        }
    }
    let equals = input.parse::<Token![=]>()?;
    declaration.sequence = sequence(input, &equals, errors);
    Ok(())
}

fn claim(input: ParseStream<'_>, claims: &mut Claims, errors: &mut Errors) -> syn::Result<()> {
    let claim = input.call(Ident::parse_any)?;
    let repeated = match claim.to_string().as_str() {
        "order" => claims.order.replace(Order::parse(input)?).is_some(),
        "citation" => claims.citation.replace(input.parse()?).is_some(),
        "symmetric" => claims.symmetric.replace(claim.clone()).is_some(),
        _ => {
            let message = format!(
                "unknown claim `{claim}`\nhelp: the claims are `order 4`, `order (8, 2)`, `symmetric` and `citation \
                 \"..\"`"
            );
            return Err(syn::Error::new(claim.span(), message));
        }
    };
    if repeated {
        errors.push(syn::Error::new(claim.span(), format!("`{claim}` is claimed twice")));
    }
    Ok(())
}

/// Parses up to `;`, `,` or the end. Items with an error inside are left out after it was kept; then nothing goes out.
pub(super) fn sequence(input: ParseStream<'_>, empty: &impl ToTokens, errors: &mut Errors) -> Option<Sequence> {
    let found = errors.count();
    let mut start = input.cursor();
    let (mut items, mut named) = (Vec::new(), None);
    while !(input.is_empty() || input.peek(Token![;]) || input.peek(Token![,])) {
        match item(input, &mut named, errors) {
            Ok(item) => items.extend(item),
            Err(error) => {
                errors.push(error);
                break;
            }
        }
    }
    if errors.count() > found {
        return None;
    }
    if items.is_empty() {
        errors.push(syn::Error::new_spanned(empty, format!("a sequence has at least one stage\n{STAGES}")));
        return None;
    }
    let mut tokens = TokenStream::new();
    while start != input.cursor()
        && let Some((tree, next)) = start.token_tree()
    {
        tokens.extend([tree]);
        start = next;
    }
    Some(Sequence { items, named, tokens })
}

/// One item; `Ok(None)` if all that is wrong is inside its parentheses. An error means that parsing cannot continue here.
fn item(input: ParseStream<'_>, named: &mut Option<Letters>, errors: &mut Errors) -> syn::Result<Option<Item>> {
    let name: Ident = input.parse().map_err(|error| {
        syn::Error::new(error.span(), format!("expected a stage, a combinator or the name of a composition\n{STAGES}"))
    })?;
    let spelled = name.to_string();
    if !input.peek(token::Paren) {
        return match spelled.as_str() {
            "T" | "V" | "O" => Err(syn::Error::new(
                name.span(),
                format!("the stage `{spelled}` lacks its coefficient\nhelp: write, for example, `{spelled}(1/2)`"),
            )),
            _ if is_combinator(&spelled) => Err(syn::Error::new(
                name.span(),
                format!("`{spelled}` lacks its composition\nhelp: write, for example, `{spelled}(Verlet)`"),
            )),
            _ => Ok(Some(Item::Name(name))),
        };
    }
    let content;
    let parentheses = parenthesized!(content in input);
    let item = if let Some((letter, letters)) = Letters::read(&spelled) {
        if let Some(letters) = letters
            && *named.get_or_insert(letters) != letters
        {
            errors.push(syn::Error::new(name.span(), "a sequence cannot mix the stages `T` and `V` with `A` and `B`"));
        }
        errors.keep(stage(letter, &name, &parentheses, &content))
    } else if is_combinator(&spelled) {
        combined(&name, &parentheses, &content, errors).map(Item::Combined)
    } else {
        let message = format!("unknown combinator `{spelled}`\n{STAGES}; the combinators are {COMBINATORS}");
        errors.push(syn::Error::new(name.span(), message));
        None
    };
    // What an error left unread would be reported a second time.
    content.parse::<TokenStream>()?;
    Ok(item)
}

fn stage(letter: Letter, name: &Ident, parentheses: &token::Paren, content: ParseStream<'_>) -> syn::Result<Item> {
    let mut arguments = Punctuated::<Expr, Token![,]>::parse_terminated(content)?.into_iter();
    match (letter, arguments.next(), arguments.next(), arguments.next()) {
        (_, Some(coefficient), None, None) => Ok(Item::Stage { letter, coefficient, gradient: None }),
        (Letter::V, Some(coefficient), Some(gradient), None) => {
            Ok(Item::Stage { letter, coefficient, gradient: Some(Box::new(gradient)) })
        }
        (Letter::T, ..) => {
            Err(at(name, parentheses, &format!("a drift takes one number\nhelp: write, for example, `{name}(1/2)`")))
        }
        (Letter::O, ..) => Err(at(name, parentheses, "friction takes one number\nhelp: write, for example, `O(1)`")),
        (Letter::V, ..) => {
            let message = format!(
                "a kick takes one number or two\nhelp: write, for example, `{name}(1/2)` or `{name}(2/3, -1/72)`"
            );
            Err(at(name, parentheses, &message))
        }
    }
}

fn combined(
    name: &Ident,
    parentheses: &token::Paren,
    content: ParseStream<'_>,
    errors: &mut Errors,
) -> Option<Combined> {
    let spelled = name.to_string();
    let weights = match (has_semicolon(content), spelled.as_str()) {
        (true, "symmetric" | "compose") => {
            let weights = weights(content);
            Some(errors.keep(weights)?)
        }
        _ => None,
    };
    let found = errors.count();
    let mut sequences = Vec::new();
    loop {
        sequences.extend(sequence(content, name, errors));
        if errors.count() > found {
            return None;
        }
        let separator = if spelled == "processed" {
            content.parse::<Option<Token![;]>>().map(|found| found.is_some())
        } else {
            content.parse::<Option<Token![,]>>().map(|found| found.is_some())
        };
        if !separator.unwrap_or(false) || content.is_empty() {
            break;
        }
    }
    if !content.is_empty() {
        errors.push(content.error("unexpected here"));
        return None;
    }
    let several = sequences.len() > 2;
    let mut sequences = sequences.into_iter();
    let combined = match (spelled.as_str(), weights, sequences.next(), sequences.next()) {
        ("triple_jump", None, Some(base), None) => Combined::TripleJump(base),
        ("suzuki", None, Some(base), None) => Combined::Suzuki(base),
        ("adjoint", None, Some(step), None) => Combined::Adjoint(step),
        ("symmetric", None, Some(half), None) => Combined::Mirrored(half),
        ("symmetric", Some(weights), Some(base), None) => Combined::Palindrome(weights, base),
        ("compose", Some(weights), Some(base), None) => Combined::Weighted(weights, base),
        ("compose", None, Some(first), Some(second)) => {
            Combined::Equal([first, second].into_iter().chain(sequences).collect())
        }
        ("processed", None, Some(pre), Some(kernel)) if !several => Combined::Processed(pre, kernel),
        ("processed", ..) => {
            errors.push(at(name, parentheses, "`processed` takes two sequences\nhelp: write `processed(pre; kernel)`"));
            return None;
        }
        ("compose", ..) => {
            let message = "`compose` takes compositions, or weights and a base\nhelp: write `compose(A, B, ..)` for \
                           equal parts of the step, or `compose(w1, w2, ..; Base)` for weighted ones";
            errors.push(at(name, parentheses, message));
            return None;
        }
        _ => {
            errors.push(at(name, parentheses, &format!("`{spelled}` takes one composition")));
            return None;
        }
    };
    Some(combined)
}

fn weights(content: ParseStream<'_>) -> syn::Result<Vec<Expr>> {
    let mut weights = Vec::new();
    while !content.peek(Token![;]) {
        weights.push(content.parse()?);
        if !content.peek(Token![;]) {
            content.parse::<Token![,]>()?;
        }
    }
    let semicolon = content.parse::<Token![;]>()?;
    if weights.is_empty() {
        return Err(syn::Error::new_spanned(semicolon, "expected weights before the `;`"));
    }
    Ok(weights)
}

fn has_semicolon(content: ParseStream<'_>) -> bool {
    let mut rest = content.cursor();
    while let Some((tree, next)) = rest.token_tree() {
        if matches!(tree, TokenTree::Punct(mark) if mark.as_char() == ';') {
            return true;
        }
        rest = next;
    }
    false
}

/// An error on a name and the parentheses after it.
fn at(name: &Ident, parentheses: &token::Paren, message: &str) -> syn::Error {
    let mut tokens = name.to_token_stream();
    parentheses.surround(&mut tokens, |_| {});
    syn::Error::new_spanned(tokens, message)
}

fn skip_declaration(input: ParseStream<'_>) {
    let _ = input.step(|cursor| {
        let mut rest = *cursor;
        while let Some((tree, next)) = rest.token_tree() {
            rest = next;
            if matches!(tree, TokenTree::Punct(mark) if mark.as_char() == ';') {
                break;
            }
        }
        Ok(((), rest))
    });
}
