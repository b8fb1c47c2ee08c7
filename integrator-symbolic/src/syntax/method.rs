//! Methods in the annotation: the composition, and `taylor`.

use super::{Compose, InPlace, misfit};
use crate::errors::quoted;
use proc_macro2::{Group, Span, TokenTree};
use quote::quote;
use syn::{Ident, Path, Token, parse::ParseStream, spanned::Spanned, token::Paren};

/// Methods that are made of a composition; others with arguments are made by functions of theirs.
const METHODS: [&str; 3] = ["Logarithmic", "Power", "Paced"];

/// A composition by its name, or a sequence in place of a name.
pub(super) fn compose_of(input: ParseStream<'_>, key: Span) -> syn::Result<Compose> {
    let here = input.fork();
    let is_method = here.call(Path::parse_mod_style).is_ok_and(|name| {
        let is_single = name.get_ident().is_some();
        here.peek(Paren) && (!is_single || METHODS.iter().any(|method| name.is_ident(method)))
    });
    if is_method {
        return Err(method_with_arguments(input)?);
    }
    if InPlace::peek(input) {
        let first = input.span();
        let sequence = InPlace::parse(input)?;
        let span = sequence.tokens().span();
        return Ok(Compose::InPlace(Box::new(sequence), span.join(first).unwrap_or(span)));
    }
    let is_name = input.peek(Ident) || input.peek(Token![::]) || input.peek(Token![crate]);
    if !is_name && !input.peek(Token![self]) && !input.peek(Token![super]) && !input.peek(Token![Self]) {
        return Err(misfit(input, key, "expected the name of a composition or a sequence of stages"));
    }
    Ok(Compose::Named(input.parse()?))
}

/// What to say of a method with arguments in the place of a composition.
fn method_with_arguments(input: ParseStream<'_>) -> syn::Result<syn::Error> {
    let (name, taken) = (input.call(Path::parse_mod_style)?, input.parse::<Group>()?);
    let method = quoted(quote!(#name #taken));
    let message = format!(
        "`compose` does not support `{method}`, a method with arguments\nhelp: pass it to the run, \
         `system.run_with({method}, start, h)`"
    );
    Ok(syn::Error::new_spanned(quote!(#name #taken), message))
}

/// Refuses what stands after `taylor`, which is a tolerance elsewhere.
pub(super) fn without_tolerance(input: ParseStream<'_>) -> syn::Result<()> {
    if !input.peek(Paren) && !input.peek(Token![=]) {
        return Ok(());
    }
    let here = input.fork();
    here.parse::<Option<Token![=]>>()?;
    let place = here.parse::<TokenTree>()?;
    let inner = match &place {
        TokenTree::Group(group) => group.stream(),
        other => other.clone().into(),
    };
    let tolerance = inner.to_string().parse::<f64>().map_or("1e-12".to_owned(), |_| inner.to_string());
    let message = format!(
        "`taylor` takes no tolerance\nhelp: write `taylor` here, and `system.run_with(Taylor::tolerance({tolerance}), \
         start, h)` for a run"
    );
    Err(syn::Error::new(place.span(), message))
}
