//! Compositions. In: a sequence of drifts and kicks. Out: a proved table of stages.
//!
//! ```text
//! tokens -> Sequence (what was typed) -> Stages (flat, 31 digits) -> Scheme (proved) -> Facts -> tokens
//!        syntax                       lower                       prove, claims      facts    emit
//! ```
//!
//! Each arrow points one way. Errors arise in or before `claims`, and `emit` cannot fail. Always true: [`expand`]
//! returns for every input, equal tokens give equal output, and each declared name is defined in the output, if only by
//! a stub.
//!
//! This module does not depend on Hamiltonians. The other half of the library uses it by [`InPlace`], a sequence in
//! place of the name of a composition.

mod claims;
mod coefficient;
mod conditions;
mod double;
mod emit;
mod facts;
mod friction;
mod friction_code;
mod in_place;
mod inner_errors;
mod leading_error;
mod lower;
mod near_integrable;
mod prove;
mod proved;
mod stability;
mod stages;
mod syntax;
mod table;

use proc_macro2::TokenStream;
use syn::ext::IdentExt;

use self::lower::Known;
pub use self::proved::{Proved, ProvedStage, ProvedTable, ProvedViolation};
pub(crate) use self::{
    in_place::InPlace,
    prove::Class,
    proved::{declared, sequence},
};
use crate::errors::Errors;

/// The declared compositions with their proofs, and after them the errors found.
pub(crate) fn expand(tokens: TokenStream) -> TokenStream {
    let mut errors = Errors::default();
    let mut known = Known::bases();
    let mut names = Vec::new();
    let mut output = TokenStream::new();
    let block = syntax::block(tokens, &mut errors);
    let root = block.root.unwrap_or_else(emit::default_root);
    for declaration in &block.declarations {
        let name = declaration.name.unraw().to_string();
        if names.contains(&name) {
            errors.push(syn::Error::new(declaration.name.span(), format!("`{name}` is declared twice in this block")));
            continue;
        }
        let scheme = claims::check(declaration, &known, &mut errors);
        output.extend(emit::declaration(declaration, &name, scheme.as_ref(), &root));
        known.declare(name.clone(), scheme);
        names.push(name);
    }
    output.extend(errors.into_tokens());
    output
}

#[cfg(test)]
mod tests {
    use proc_macro2::TokenStream;
    use syn::parse::{ParseStream, Parser};

    use super::{lower::Known, prove::Scheme};
    use crate::errors::Errors;

    /// The scheme of a sequence about which nothing is claimed.
    pub(super) fn scheme(text: &str) -> Scheme {
        let mut errors = Errors::default();
        let parser = |input: ParseStream<'_>| {
            let sequence = super::syntax::sequence(input, &TokenStream::new(), &mut errors);
            Ok(sequence.and_then(|sequence| super::lower::lower(&sequence, &Known::bases(), &mut errors)))
        };
        let scheme = parser.parse_str(text).expect("tokens");
        scheme.unwrap_or_else(|| panic!("{text}: {}", errors.into_tokens()))
    }
}
