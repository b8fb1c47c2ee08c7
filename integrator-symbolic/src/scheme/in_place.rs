//! A sequence in place of a composition's name, as in `#[hamiltonian(compose = V(1/2) T(1) V(1/2))]`.
//!
//! In: tokens. Out: a proved sequence, which the caller can check against its Hamiltonian before it requests the code.
//! Always true: an [`InPlace`] is consistent, of order 1 at least, and [`InPlace::emit`] cannot fail.

use proc_macro2::{Delimiter, Ident, TokenStream, TokenTree};
use quote::quote;
use syn::{Expr, Path, Visibility, parse::ParseStream, token};

use super::{
    emit,
    inner_errors::OverInner,
    lower::{Known, lower},
    prove::{Class, Proof, Scheme},
    stages::Letter,
    syntax::{self, Sequence},
};
use crate::errors::Errors;

/// A sequence that was written and proved in place.
pub(crate) struct InPlace {
    sequence: Sequence,
    scheme: Scheme,
}

impl InPlace {
    /// Whether the next tokens are a sequence rather than a path: a name with parentheses after it.
    pub(crate) fn peek(input: ParseStream<'_>) -> bool {
        input.peek(syn::Ident) && input.peek2(token::Paren)
    }

    /// Parses and proves up to a top-level comma, a semicolon or the end. The error holds all that is wrong.
    pub(crate) fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let mut errors = Errors::default();
        let sequence = syntax::sequence(input, &TokenStream::new(), &mut errors);
        let scheme = sequence.as_ref().and_then(|sequence| lower(sequence, &Known::bases(), &mut errors));
        match (sequence, scheme, errors.combined()) {
            (Some(sequence), Some(scheme), None) => Ok(Self { sequence, scheme }),
            (.., Some(error)) => Err(error),
            _ => Err(input.error("expected a sequence")),
        }
    }

    /// The orders for every `T` and for quadratic `T`, the symmetry, and what is violated first.
    pub(crate) fn proof(&self) -> &Proof {
        &self.scheme.proof
    }

    /// Whether it has friction.
    pub(crate) fn has_friction(&self) -> bool {
        self.scheme.stages.has_friction()
    }

    /// The second number of the first kick that has one: it needs a quadratic `T`, whatever the order.
    pub(crate) fn gradient(&self) -> Option<&Expr> {
        self.sequence.gradient()
    }

    /// Whether it does something once and undoes it where the state is shown.
    pub(crate) fn is_processed(&self) -> bool {
        !self.scheme.processor.elements().is_empty()
    }

    /// Whether its order holds where the second part is a symmetric pair.
    pub(crate) fn keeps_pairs(&self) -> bool {
        OverInner::of(&self.scheme).keeps_pairs
    }

    /// Whether the kick that ends a step is one with the kick that begins the next.
    pub(crate) fn merges_kicks(&self) -> bool {
        let elements = self.scheme.stages.elements();
        [elements.first(), elements.last()].iter().all(|end| end.is_some_and(|end| end.letter == Letter::V))
    }

    /// The sequence as typed, for messages about the whole of it.
    pub(crate) fn tokens(&self) -> &TokenStream {
        &self.sequence.tokens
    }

    /// A unit struct `name` that is this composition, for the Hamiltonians of a class; `root` is the runtime crate.
    pub(crate) fn emit(&self, name: &Ident, class: Class, root: &Path) -> TokenStream {
        let mut scheme = self.scheme.clone();
        if class == Class::QuadraticKinetic {
            (scheme.class, scheme.order) = (class, scheme.proof.quadratic.order);
        }
        let definition = emit::definition(&Visibility::Public(Default::default()), name);
        let (implementation, _) = emit::described(name, &self.text(), "", &scheme, root);
        quote!(#definition #implementation)
    }

    /// The text of the sequence, which is also the composition's name: one space after each item, comma and semicolon.
    pub(crate) fn text(&self) -> String {
        fn write(tokens: TokenStream, text: &mut String) {
            for tree in tokens {
                match tree {
                    TokenTree::Group(group) => {
                        let (open, close) = match group.delimiter() {
                            Delimiter::None => ("", ""),
                            _ => ("(", ")"),
                        };
                        text.push_str(open);
                        write(group.stream(), text);
                        text.push_str(close);
                    }
                    TokenTree::Punct(mark) if matches!(mark.as_char(), ',' | ';') => {
                        text.push(mark.as_char());
                        text.push(' ');
                    }
                    TokenTree::Ident(name) => {
                        if text.ends_with(|last: char| last == ')' || last.is_alphanumeric()) {
                            text.push(' ');
                        }
                        text.push_str(&name.to_string());
                    }
                    other => text.push_str(&other.to_string()),
                }
            }
        }
        let mut text = String::new();
        write(self.sequence.tokens.clone(), &mut text);
        text
    }
}

#[cfg(test)]
mod tests {
    use proc_macro2::{Ident, Span};
    use quote::quote;
    use syn::{Token, parse::Parser};

    use super::{Class, InPlace};
    use crate::scheme::emit::default_root;

    fn parse(text: &str) -> syn::Result<InPlace> {
        let parser = |input: syn::parse::ParseStream<'_>| {
            let parsed = InPlace::parse(input);
            input.parse::<Option<Token![,]>>()?;
            input.parse::<proc_macro2::TokenStream>()?;
            parsed
        };
        parser.parse_str(text)
    }

    #[test]
    fn a_sequence_is_distinguished_from_a_path() {
        let peek = |text: &str| {
            let parser = |input: syn::parse::ParseStream<'_>| {
                let found = InPlace::peek(input);
                input.parse::<proc_macro2::TokenStream>()?;
                Ok(found)
            };
            parser.parse_str(text).expect("tokens")
        };
        assert!(peek("V(1/2) T(1) V(1/2), functions = fast"));
        assert!(peek("triple_jump(Verlet)"));
        assert!(!peek("Verlet"));
        assert!(!peek("my::Composition"));
    }

    #[test]
    fn a_sequence_ends_at_a_comma_and_knows_its_orders() {
        let parsed = parse("V(1/6)T(1/2) V( 2/3,-1/72 ) T(1/2)V(1/6), functions = fast").expect("a composition");
        assert_eq!(parsed.text(), "V(1/6) T(1/2) V(2/3, -1/72) T(1/2) V(1/6)");
        assert!(parsed.proof().general.is_none());
        assert_eq!(parsed.proof().quadratic.order, 4);
        assert!(parsed.gradient().is_some());
        let parsed = parse("symmetric(1/(2 - cbrt(2)), _; VelocityVerlet)").expect("a composition");
        assert_eq!(parsed.text(), "symmetric(1/(2-cbrt(2)), _; VelocityVerlet)");
        assert_eq!(parsed.proof().general.map(|verdict| verdict.order), Some(4));
        assert!(parsed.gradient().is_none());
    }

    #[test]
    fn code_is_written_for_the_class_of_the_hamiltonian() {
        let parsed = parse("V(1/2) T(1) V(1/2)").expect("a composition");
        let name = Ident::new("__Compose", Span::call_site());
        for (class, bound) in [(Class::General, quote!(System)), (Class::QuadraticKinetic, quote!(QuadraticKinetic))] {
            let code = parsed.emit(&name, class, &default_root()).to_string();
            let bound = quote!(impl<__System: ::integrator_core::__private::#bound>).to_string();
            assert!(code.contains(&bound), "{code}");
            assert!(code.contains("\"V(1/2) T(1) V(1/2)\""), "{code}");
        }
    }

    #[test]
    fn orders_over_inner_compositions_are_written_where_they_are_no_lower_bounds() {
        let name = Ident::new("__Compose", Span::call_site());
        let constant = quote!(
            const ORDERS_OVER_INNER: [u32; 4] = [4, 4, 4, 4];
        )
        .to_string();
        for (base, class, written) in [
            ("Verlet", Class::General, true),
            ("Verlet", Class::QuadraticKinetic, false),
            ("VelocityVerlet", Class::General, false),
        ] {
            let code =
                parse(&format!("triple_jump({base})")).expect("a composition").emit(&name, class, &default_root());
            let code = code.to_string();
            assert_eq!(code.contains(&constant), written, "{base}");
            assert_eq!(code.contains("ORDERS_OVER_INNER"), written, "{base}");
        }
    }

    #[test]
    fn mistakes_are_errors() {
        for text in ["V(1/2) T(1)", "V(1/2) T(1) V(1/0)", "Verlt(1)", "", "V(1)T(1) +"] {
            assert!(parse(text).is_err(), "{text}");
        }
    }
}
