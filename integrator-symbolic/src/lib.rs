//! The implementation of the macros of `integrator-core` as an ordinary library: it takes tokens and returns tokens.
//!
//! ```text
//! tokens -> Input -> Model -> Graph + gradients -> Program -> tokens        #[hamiltonian]
//! tokens -> Sequence -> Scheme -> tokens                                    composition!
//! ```
//!
//! Each arrow is a module. Errors arise up to the judgement of the model or the proof of a scheme. Of later steps, only
//! code for devices can fail.
//! All functions return for every input, report all mistakes together, and generate the same code for the same input.
//! [`report`], [`declared`] and [`sequence`] return what the macros derive and prove, for tools that show it.
#![forbid(unsafe_code)]

mod differentiate;
mod emit;
mod errors;
mod fragments;
mod graph;
mod judge;
mod layout;
mod limits;
mod lower;
mod model;
mod other_names;
mod pairs;
mod pattern;
mod program;
mod prose;
mod reason;
mod report;
mod scheme;
mod spelling;
mod stencil;
mod syntax;
mod taylor;

pub use emit::{Exported, ExportedConstant};
use errors::Errors;
use fragments::without_groups;
pub use graph::Tally;
pub use layout::Form;
use model::Model;
pub use other_names::named_otherwise;
use proc_macro2::TokenStream;
use quote::quote;
pub use report::{Each, Flow, FlowOfPart, Place, Report, Slower};
pub use scheme::{Proved, ProvedStage, ProvedTable, ProvedViolation};
pub use spelling::nearest;
use syntax::{Compose, Input};

/// Expands `#[hamiltonian]`: returns the annotated item and the stepper generated for it.
///
/// If the item has errors, the result contains them as `compile_error!` and a stepper that does not move the state.
pub fn hamiltonian(arguments: TokenStream, item: TokenStream) -> TokenStream {
    let mut errors = Errors::default();
    let stepper = stepper(arguments, item.clone(), &mut errors);
    let item = model::strip(item, &errors.places());
    let errors = errors.into_tokens();
    // Loops in H may use indices, as formulas do, so no lint should suggest iterators.
    let lints = stepper.is_some().then(|| quote!(#[allow(clippy::needless_range_loop, reason = "the language of H")]));
    quote!(#lints #item #stepper #errors)
}

/// Expands `composition!`: returns the declared compositions, with proved orders, or the errors found in them.
///
/// If the input is nested too deeply to be parsed, the result is that error alone.
pub fn composition(declarations: TokenStream) -> TokenStream {
    let mut errors = Errors::default();
    if !limits::check_depth(&declarations, &mut errors) {
        return errors.into_tokens();
    }
    scheme::expand(without_groups(declarations))
}

/// Returns what `#[hamiltonian]` derives from an impl, such as the equations of motion.
///
/// # Errors
/// All mistakes in the arguments and the impl, combined into one error.
pub fn report(arguments: TokenStream, item: TokenStream) -> syn::Result<Report> {
    let mut errors = Errors::default();
    let report = read(arguments, item, &mut errors).and_then(|input| {
        let model = laid_out_model(&input, &mut errors)?;
        if input.gpu.is_some() {
            // Printers add to the graph that they print, so they get one of their own.
            let printed = valid_model(&input, &mut errors)?;
            check_device(&input, emit::stepper(&input, printed).1, &mut errors);
        }
        Some(report::report(&input, model))
    });
    outcome(report, errors)
}

/// Returns the code of a system for programs in other languages, in the C++ of device code.
///
/// # Errors
/// All mistakes in the arguments and the impl, combined into one error; also the reason why a system has no device code.
pub fn exported(arguments: TokenStream, item: TokenStream) -> syn::Result<Exported> {
    let mut errors = Errors::default();
    let exported = read(arguments, item, &mut errors).and_then(|input| {
        let model = laid_out_model(&input, &mut errors)?;
        let Report { system, compose, .. } = report::report(&input, valid_model(&input, &mut errors)?);
        match emit::exported(&input, model) {
            Ok(exported) => Some(Exported { system, compose, ..exported }),
            Err(obstacle) => {
                errors.at(&input.item.self_ty, obstacle);
                None
            }
        }
    });
    outcome(exported, errors)
}

/// Returns the names of the methods of `f64` that a Hamiltonian may apply to coordinates.
pub fn known_functions() -> impl Iterator<Item = &'static str> {
    model::known_functions()
}

/// Returns the names of the functions that device code may call, with the bits of the processor.
pub fn device_functions() -> impl Iterator<Item = &'static str> {
    emit::device_functions()
}

/// Returns a name of the user's as it is spelled in device code, where keywords of C and C++ get an underscore.
pub fn identifier(name: &str) -> String {
    emit::identifier_of(name)
}

/// Returns the proved properties of the compositions that a `composition!` block declares.
///
/// # Errors
/// All mistakes in the block, combined into one error; also a declared order that does not hold.
pub fn declared(declarations: TokenStream) -> syn::Result<Vec<Proved>> {
    let mut errors = Errors::default();
    let found = limits::check_depth(&declarations, &mut errors)
        .then(|| scheme::declared(without_groups(declarations), &mut errors));
    outcome(found, errors)
}

/// Returns the proved properties of a sequence such as `V(1/2) T(1) V(1/2)`.
///
/// # Errors
/// All mistakes in the sequence, combined into one error; also a claimed `order` that does not hold.
pub fn sequence(tokens: TokenStream, order: Option<u32>) -> syn::Result<Proved> {
    let mut errors = Errors::default();
    let shallow = limits::check_depth(&tokens, &mut errors);
    let found = shallow.then(|| scheme::sequence(without_groups(tokens), order, &mut errors)).flatten();
    outcome(found, errors)
}

/// Returns the result, or the errors that were reported.
fn outcome<T>(found: Option<T>, errors: Errors) -> syn::Result<T> {
    match (found, errors.combined()) {
        (Some(found), None) => Ok(found),
        (_, Some(error)) => Err(error),
        (None, None) => Err(syn::Error::new(proc_macro2::Span::call_site(), "nothing was found, and no reason either")),
    }
}

fn stepper(arguments: TokenStream, item: TokenStream, errors: &mut Errors) -> Option<TokenStream> {
    let mut input = read(arguments, item, errors)?;
    if let Some(model) = laid_out_model(&input, errors) {
        let (stepper, obstacle) = emit::stepper(&input, model);
        check_device(&input, obstacle, errors);
        if errors.is_empty() {
            return Some(stepper);
        }
    }
    // A sequence in place may be the mistake. A name is kept, so that rustc checks it against the stub.
    input.compose = input.compose.filter(|compose| matches!(compose, Compose::Named(_)));
    model::stub(&input).map(|model| emit::stepper(&input, model).0)
}

/// The input, unless it is so deep that nothing may recurse over it.
fn read(arguments: TokenStream, item: TokenStream, errors: &mut Errors) -> Option<Input> {
    if !limits::check_depth(&arguments, errors) || !limits::check_depth(&item, errors) {
        return None;
    }
    let mut input = syntax::input(without_groups(arguments), without_groups(item), errors)?;
    model::without_lists(&mut input, errors);
    Some(input)
}

/// The model of an input without mistakes.
fn valid_model(input: &Input, errors: &mut Errors) -> Option<Model> {
    let model = model::model(input, errors);
    if model.is_none() && errors.is_empty() {
        errors
            .at(&input.item.self_ty, "the macro failed on this impl without a reason\nhelp: please report it as a bug");
    }
    let model = judge::judged(input, model?, errors);
    Some(model).filter(|_| errors.is_empty())
}

/// The same, if the kick has the layout that is requested.
fn laid_out_model(input: &Input, errors: &mut Errors) -> Option<Model> {
    let model = valid_model(input, errors)?;
    if input.layout.is_some() {
        judge::check_layout(input, valid_model(input, errors)?, errors);
    }
    Some(model).filter(|_| errors.is_empty())
}

/// Reports why there is no device code, if it is requested.
fn check_device(input: &Input, obstacle: Option<String>, errors: &mut Errors) {
    if let (Some(gpu), Some(obstacle)) = (&input.gpu, obstacle) {
        errors.at_span(gpu.span, obstacle);
    }
}
