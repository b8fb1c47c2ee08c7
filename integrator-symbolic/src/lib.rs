//! Everything the macros of `integrator-core` do, as an ordinary library: tokens in, tokens out.
//!
//! ```text
//! tokens -> Input -> Model -> Graph + gradients -> Program -> tokens        #[hamiltonian]
//! tokens -> Sequence -> Scheme -> tokens                                    composition!
//! ```
//!
//! Each arrow is a module; errors end at the model and at the claims of a scheme. Both functions return for every input,
//! report all mistakes at once, and write the same tokens for the same tokens.
#![forbid(unsafe_code)]

mod differentiate;
mod emit;
mod errors;
mod gather;
mod graph;
mod limits;
mod lower;
mod model;
mod pairs;
mod program;
mod report;
mod scheme;
mod syntax;

use errors::Errors;
use proc_macro2::TokenStream;
use quote::quote;
pub use report::{Report, report};
use syntax::{Compose, Input};

/// `#[hamiltonian]`: the annotated item, and behind it the stepper written for it, or the errors found in it
/// and a stepper that stands still.
pub fn hamiltonian(arguments: TokenStream, item: TokenStream) -> TokenStream {
    let mut errors = Errors::default();
    let stepper = stepper(arguments, item.clone(), &mut errors);
    let item = model::stripped(item);
    let errors = errors.into_tokens();
    // Formulas number their bodies, and so may the loops in H: no lint should ask for iterators instead.
    let lints = stepper.is_some().then(|| quote!(#[allow(clippy::needless_range_loop, reason = "the language of H")]));
    quote!(#lints #item #stepper #errors)
}

/// `composition!`: the declared compositions, each proved, or the errors found in them.
pub fn composition(declarations: TokenStream) -> TokenStream {
    scheme::expand(declarations)
}

fn stepper(arguments: TokenStream, item: TokenStream, errors: &mut Errors) -> Option<TokenStream> {
    if !limits::check_depth(&arguments, errors) || !limits::check_depth(&item, errors) {
        return None;
    }
    let mut input = syntax::input(arguments, item, errors)?;
    let model = model::model(&input, errors);
    match &model {
        Some(model) => check_composition(&input, model, errors),
        None if errors.is_empty() => {
            errors.at(&input.item.self_ty, "this impl could not be read, and no reason was found: please report it");
        }
        None => {}
    }
    if errors.is_empty() {
        return model.map(|model| emit::stepper(&input, model));
    }
    // A sequence in place may be what is wrong; a name is held against the stub, so that the type checker speaks too.
    input.compose = input.compose.filter(|compose| matches!(compose, Compose::Named(_)));
    model::stub(&input).map(|model| emit::stepper(&input, model))
}

/// A sequence in place has to fit this very Hamiltonian; a named one is held against it by the type checker.
fn check_composition(input: &Input, model: &model::Model, errors: &mut Errors) {
    if let Some(Compose::InPlace(sequence, span)) = &input.compose
        && let Some(refusal) = emit::refusal(sequence, model)
    {
        match sequence.gradient() {
            Some(gradient) => errors.at(gradient, refusal),
            None => errors.at_span(*span, refusal),
        }
    }
}
