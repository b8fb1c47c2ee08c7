//! `split = ..`: the names of the parts of H, and which of them are in parentheses.
//!
//! Parts in parentheses are one part of the composition around them, the second of two. With a number or a composition
//! before them they take inner steps; without, they are a symmetric pair.

use super::misfit;
use proc_macro2::{Span, TokenStream};
use syn::{Expr, Ident, Lit, Path, Token, parenthesized, parse::ParseStream, spanned::Spanned, token::Paren};

/// How H is split.
pub(super) enum Split {
    /// Into parts with names.
    Parts(Parts),
    /// Into H of each of two copies of the state, and a coupling.
    Symmetric(Box<syn::Result<Expr>>),
    /// Not at all.
    Nowhere(Span),
}

/// The parts with names.
#[derive(Default)]
pub(super) struct Parts {
    /// The names, in the order of the annotation.
    pub(super) names: Vec<Ident>,
    /// The parentheses around all parts but the first, if these are a symmetric pair.
    pub(super) paired: Option<Span>,
    /// The parts in parentheses that take inner steps, the outermost first.
    pub(super) nests: Vec<Nest>,
    /// The name after parts in parentheses, which only friction may have.
    pub(super) trailing: Option<Ident>,
}

/// Parts in parentheses that take inner steps. They are the last ones, up to the last name.
#[derive(Clone)]
pub(crate) struct Nest {
    /// The number of names before them.
    pub(crate) first: usize,
    /// The number of inner steps.
    pub(crate) steps: u32,
    /// The inner composition, if it has a name.
    pub(crate) compose: Option<Path>,
}

/// The most parentheses within each other.
const MOST_NESTED: usize = 4;

/// The names of the parts, `symmetric` with its coupling, or `none`.
pub(super) fn split_of(input: ParseStream<'_>, key: Span) -> syn::Result<Split> {
    if input.fork().parse::<Ident>().is_ok_and(|name| name == "symmetric") && !input.peek2(Token![+]) {
        return coupling_of(input).map(|coupling| Split::Symmetric(Box::new(coupling)));
    }
    let here = input.fork();
    if here.parse::<Ident>().is_ok_and(|name| name == "none") && !here.peek(Token![+]) {
        return Ok(Split::Nowhere(input.parse::<Ident>()?.span()));
    }
    let is = "expected the names of functions for the parts of H\nhelp: write, for example, `split = kepler + \
              interaction`";
    if !begins_group(input) && !input.peek(Ident) {
        return Err(misfit(input, key, is));
    }
    let mut parts = Parts::default();
    parts.read(input, is)?;
    if let [alone] = &parts.names[..] {
        let message =
            "a splitting requires at least two parts\nhelp: write, for example, `split = kepler + interaction`";
        return Err(syn::Error::new(alone.span(), message));
    }
    Ok(Split::Parts(parts))
}

const ONE_IN_PARENTHESES: &str = "inner steps require at least two parts in parentheses\nhelp: write, for example, `split = slow + 8 * (bonds + kinetic)`\nnote: \
     the flow of a single part is exact, so that one step of it is as accurate as many";

const NO_NAMES: &str = "expected names of parts of H in the parentheses\nhelp: write, for example, `split = kepler + (jump + \
                        interaction)`";

const NO_NAMES_WITH_INNER_STEPS: &str = "expected names of parts of H in the parentheses\nhelp: write, for example, `split = \
                                         slow + 8 * (bonds + kinetic)`";

const NO_SUM: &str = "H has to be the sum of its parts\nhelp: put the sign into the function of the part";

const FIRST_WITH_INNER_STEPS: &str = "parts that take inner steps have to be the second part of H\nhelp: write, for \
                                      example, `split = slow + 8 * (bonds + kinetic)`";

const FIRST_IN_PARENTHESES: &str = "parts in parentheses have to be the second part of H\nhelp: write, for example, \
                                    `split = kepler + (jump + interaction)`\nnote: a composition treats the second \
                                    part as the small one";

/// What to say of parts after those in parentheses.
pub(super) const NOT_LAST: &str =
    "parts in parentheses have to be the last part of H\nhelp: move the parts that follow into the parentheses";

/// Whether parts in parentheses are next, with what may stand before them.
fn begins_group(input: ParseStream<'_>) -> bool {
    let is_number = input.peek(Lit) && (input.peek2(Token![*]) || input.peek2(Paren));
    if input.peek(Paren) || is_number || input.peek(Token![-]) || input.peek2(Token![*]) {
        return true;
    }
    let here = input.fork();
    here.call(Path::parse_mod_style).is_ok() && here.peek(Paren)
}

impl Parts {
    /// Reads the parts of H, or those in parentheses.
    fn read(&mut self, input: ParseStream<'_>, is: &str) -> syn::Result<()> {
        let first = self.names.len();
        loop {
            if begins_group(input) {
                let (start, known) = (input.span(), self.names.len() - first);
                let has_inner_steps = self.group(input, known)?;
                if known == 0 {
                    let message = if has_inner_steps { FIRST_WITH_INNER_STEPS } else { FIRST_IN_PARENTHESES };
                    return Err(syn::Error::new(start, message));
                }
                if input.peek(Token![*]) {
                    return Err(input.error(
                        "the number of inner steps has to be in front of the parts in parentheses\nhelp: write, for example, \
                         `split = slow + 8 * (bonds + kinetic)`",
                    ));
                }
                if first == 0 && input.peek(Token![+]) && input.peek2(Ident) {
                    let here = input.fork();
                    here.parse::<Token![+]>()?;
                    here.parse::<Ident>()?;
                    if here.is_empty() || here.peek(Token![,]) {
                        input.parse::<Token![+]>()?;
                        self.trailing = Some(input.parse()?);
                        return Ok(());
                    }
                }
                if input.peek(Token![+]) {
                    return Err(input.error(NOT_LAST));
                }
                return Ok(());
            }
            self.names.push(input.parse().map_err(|error: syn::Error| syn::Error::new(error.span(), is))?);
            if input.peek(Token![-]) {
                return Err(input.error(NO_SUM));
            }
            if !input.peek(Token![+]) {
                return Ok(());
            }
            input.parse::<Token![+]>()?;
        }
    }

    /// Reads parts in parentheses, which come after this number of names, and returns whether a number or a composition is
    /// in front of them.
    fn group(&mut self, input: ParseStream<'_>, known: usize) -> syn::Result<bool> {
        let start = input.span();
        let steps = if input.peek(Paren) || names_composition(input) { None } else { Some(factor(input)?) };
        let is_path = input.fork().call(Path::parse_mod_style).is_ok();
        let compose = if is_path { Some(input.call(Path::parse_mod_style)?) } else { None };
        if !input.peek(Paren) {
            let place = compose.map_or(start, |path| path.span());
            return Err(syn::Error::new(place, ONE_IN_PARENTHESES));
        }
        let has_inner_steps = steps.is_some() || compose.is_some();
        let content;
        let span = parenthesized!(content in input).span.join();
        if known == 0 {
            // What is wrong is said at the beginning of the parentheses.
            return content.parse::<TokenStream>().map(|_| has_inner_steps);
        }
        let first = self.names.len();
        if known > 1 {
            return Err(syn::Error::new(
                self.names[first - known + 1].span(),
                "parts in parentheses have to be the second of two parts\nhelp: move this part into the parentheses, or \
                 remove them",
            ));
        }
        let nest = self.nests.len();
        self.nests.push(Nest { first, steps: steps.unwrap_or(1), compose });
        if nest == MOST_NESTED {
            let message = format!(
                "parentheses are nested more than {MOST_NESTED} deep\nhelp: move these parts into the parentheses around them"
            );
            return Err(syn::Error::new(span, message));
        }
        let is = if has_inner_steps { NO_NAMES_WITH_INNER_STEPS } else { NO_NAMES };
        self.read(&content, is)?;
        if !content.is_empty() {
            return Err(content.error(is));
        }
        if self.names.len() < first + 2 {
            let message = match has_inner_steps {
                true => ONE_IN_PARENTHESES,
                false => "parentheses require at least two parts\nhelp: remove the parentheses",
            };
            return Err(syn::Error::new(span, message));
        }
        // Without a number and a composition, alone, they are a symmetric pair.
        if nest == 0 && self.nests.len() == 1 && !has_inner_steps {
            self.nests.clear();
            self.paired = Some(span);
        }
        Ok(has_inner_steps)
    }
}

/// Whether the name of a composition is next.
fn names_composition(input: ParseStream<'_>) -> bool {
    !input.peek(Lit) && !input.peek(Token![-]) && !input.peek2(Token![*])
}

/// The number of inner steps, and the sign behind it.
fn factor(input: ParseStream<'_>) -> syn::Result<u32> {
    let place = input.span();
    let wrong = |what: String| {
        let advice = "write, for example, `split = slow + 8 * (bonds + kinetic)`";
        Err(syn::Error::new(place, format!("{what}\nhelp: {advice}")))
    };
    if input.peek(Token![-]) && !input.peek2(Lit) {
        return Err(input.error(NO_SUM));
    }
    if input.peek(Token![-]) {
        return wrong("the number of inner steps has to be positive".to_owned());
    }
    if let Ok(name) = input.fork().parse::<Ident>() {
        return Err(syn::Error::new(
            name.span(),
            format!(
                "the number of inner steps has to be an integer literal, not `{name}`\nhelp: choose the number at run time \
                 with `system.run_with(Verlet.nested({name}), start, h)`"
            ),
        ));
    }
    let steps = match input.parse::<Lit>()? {
        Lit::Int(number) => match number.base10_parse::<u32>() {
            Ok(0) => return wrong("the number of inner steps has to be positive".to_owned()),
            Ok(steps) => steps,
            Err(_) => return wrong(format!("the number of inner steps has to be at most {}", u32::MAX)),
        },
        _ => return wrong("the number of inner steps has to be an integer".to_owned()),
    };
    if !input.peek(Token![*]) {
        return wrong("expected `*` between the number of inner steps and the parts in parentheses".to_owned());
    }
    input.parse::<Token![*]>()?;
    Ok(steps)
}

/// The coupling of `symmetric(omega = 20.0)`, or what is wrong with it.
fn coupling_of(input: ParseStream<'_>) -> syn::Result<syn::Result<Expr>> {
    let name: Ident = input.parse()?;
    if !input.peek(Paren) {
        return Ok(Err(syn::Error::new(name.span(), UNCOUPLED)));
    }
    let content;
    parenthesized!(content in input);
    let coupling = stated_coupling(&content);
    content.parse::<TokenStream>()?;
    Ok(coupling)
}

const UNCOUPLED: &str = "`split = symmetric` lacks its coupling\nhelp: write, for example, `split = symmetric(omega = \
                         20.0)`\nnote: omega is one to several times the largest angular frequency of the system";

/// The number after `omega =`.
fn stated_coupling(content: ParseStream<'_>) -> syn::Result<Expr> {
    let uncoupled = |error: syn::Error| syn::Error::new(error.span(), UNCOUPLED);
    let key: Ident = content.parse().map_err(uncoupled)?;
    if key != "omega" {
        return Err(syn::Error::new(key.span(), UNCOUPLED));
    }
    content.parse::<Token![=]>().map_err(uncoupled)?;
    let coupling = content.parse()?;
    match content.is_empty() {
        true => Ok(coupling),
        false => {
            Err(content.error("the coupling has to be one number\nhelp: write, for example, `symmetric(omega = 20.0)`"))
        }
    }
}
