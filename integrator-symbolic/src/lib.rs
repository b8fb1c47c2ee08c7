//! The implementation of the macros of `integrator-core` as an ordinary library: it takes tokens and returns tokens.
//!
//! ```text
//! tokens -> Input -> Model -> Graph + gradients -> Program -> tokens        #[hamiltonian]
//! tokens -> Sequence -> Scheme -> tokens                                    composition!
//! ```
//!
//! Each arrow is a module. Errors arise before or in the model, or before or in the proof of a scheme, and not later.
//! All functions return for every input, report all mistakes together, and generate the same code for the same input.
//! [`report`], [`declared`] and [`sequence`] return what the macros derive and prove, for tools that show it.
#![forbid(unsafe_code)]

mod differentiate;
mod emit;
mod errors;
mod fragments;
mod graph;
mod limits;
mod lower;
mod model;
mod pairs;
mod pattern;
mod program;
mod report;
mod scheme;
mod spelling;
mod stencil;
mod syntax;
mod taylor;

pub use emit::Form;
use errors::Errors;
use fragments::without_groups;
pub use graph::Tally;
use graph::exact::Exact;
use model::{Model, Split};
use proc_macro2::TokenStream;
use quote::quote;
pub use report::{Flow, Place, Report};
pub use scheme::{Proved, ProvedStage, ProvedViolation};
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
        let model = valid_model(&input, &mut errors)?;
        Some(report::report(&input, model))
    });
    outcome(report, errors)
}

/// Returns the names of the methods of `f64` that a Hamiltonian may apply to coordinates.
pub fn known_functions() -> impl Iterator<Item = &'static str> {
    model::known_functions()
}

/// Returns the names of the functions that device code may call, with the bits of the processor.
pub fn device_functions() -> impl Iterator<Item = &'static str> {
    emit::device_functions()
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
    if let Some(model) = valid_model(&input, errors) {
        return Some(emit::stepper(&input, model));
    }
    // A sequence in place may be the mistake. A name is kept, so that rustc checks it against the stub.
    input.compose = input.compose.filter(|compose| matches!(compose, Compose::Named(_)));
    model::stub(&input).map(|model| emit::stepper(&input, model))
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
    let mut model = model::model(input, errors);
    match &mut model {
        Some(model) => {
            check_coordinates(input, model, errors);
            check_composition(input, model, errors);
            check_taylor(input, model, errors);
            check_taylor_of_folds(input, model, errors);
            check_sensitive(input, model, errors);
            if errors.is_empty() {
                check_device(input, errors);
            }
        }
        None if errors.is_empty() => {
            errors.at(
                &input.item.self_ty,
                "the macro failed on this impl without a reason\nhelp: please report it as a bug",
            );
        }
        None => {}
    }
    model.filter(|_| errors.is_empty())
}

/// Rejects loops that join items by another operation than addition, which have no recurrence of Taylor coefficients.
fn check_taylor_of_folds(input: &Input, model: &Model, errors: &mut Errors) {
    let energies = [model.kinetic, model.potential];
    if let (Some(span), Some(fold)) = (input.taylor, model.graph.first_fold(energies)) {
        let message = format!(
            "`taylor` does not support a {} over any number of items\nhelp: write it over at most 16 items whose \
             number is a literal, or leave out `taylor`",
            fold.noun()
        );
        errors.at_span(span, message);
    }
}

/// A method with a stated derivative has only this one, and a series requires derivatives of every order.
fn check_taylor(input: &Input, model: &Model, errors: &mut Errors) {
    if let (Some(span), Some(name)) = (input.taylor, model.externals.first()) {
        let message = format!(
            "`taylor` does not support `{name}`, which has a stated derivative\nhelp: write it in the language of H, \
             or leave out `taylor`\nnote: a Taylor series requires derivatives of every order"
        );
        errors.at_span(span, message);
    }
}

/// Rejects derivatives by parameters that exact flows solve with, instead of reading them.
fn check_sensitive(input: &Input, model: &Model, errors: &mut Errors) {
    let Some(first) = input.sensitive.first() else { return };
    if let Some(coordinates) = &input.coordinates {
        let message = "Jacobi coordinates do not support `sensitive`\nhelp: leave out `coordinates` and `split`, or \
                       `sensitive`\nnote: the coordinates depend on the masses";
        errors.at(&coordinates.name, message);
    }
    if input.coupling.is_some() {
        let message = "`split = symmetric` does not support `sensitive`\nhelp: write `split = none` with `compose = \
                       GaussLegendre4`, or leave out `sensitive`\nnote: two coupled copies of the state have no \
                       tangent map";
        errors.at(first, message);
    }
    for (name, parameter) in input.sensitive.iter().zip(&model.sensitive) {
        let part = model.parts.iter().find(|part| {
            matches!(part.form, Exact::Quadratic(_) | Exact::Kepler(_))
                && model.graph.reads_parameter(part.energy, *parameter)
        });
        if let Some(part) = part {
            let message = format!(
                "the exact flow of `{}` has no derivative with respect to `self.{name}`\nhelp: split H into T(p) and \
                 V(q), or write `split = none`",
                part.name
            );
            errors.at(name, message);
        }
    }
}

/// Reports why there is no device code, if it is requested. This prints a second model, since a printer adds to its
/// graph.
fn check_device(input: &Input, errors: &mut Errors) {
    let Some(gpu) = &input.gpu else { return };
    let Some(mut model) = model::model(input, &mut Errors::default()) else { return };
    check_coordinates(input, &mut model, &mut Errors::default());
    if let Some(obstacle) = emit::no_device_text(input, gpu, model) {
        errors.at_span(gpu.span, obstacle);
    }
}

/// The coordinates of the motion have to fit the Hamiltonian.
fn check_coordinates(input: &Input, model: &mut Model, errors: &mut Errors) {
    let Some(coordinates) = &input.coordinates else { return };
    let named = input.split.iter().zip(emit::KEPLER_PARTS).find(|(name, part)| name != part).map(|(name, _)| name);
    if named.is_some() || input.split.len() != emit::KEPLER_PARTS.len() {
        let wrong = named.or(input.split.get(2)).unwrap_or(&coordinates.name);
        let message = "Jacobi coordinates require the parts `kepler` and `interaction`\nhelp: write `split = kepler + \
                       interaction`\nnote: these are the Kepler motion of each body and the rest of V";
        errors.at(wrong, message);
        return;
    }
    let function = |name: &str| input.function(name).or_else(|| input.function("hamiltonian"));
    match emit::judged(coordinates, model, &emit::Names::new(input)) {
        Ok(jacobi) => model.split = Split::Jacobi(jacobi),
        Err(emit::Obstacle::Shape(message)) => {
            if let Some(function) = function("potential") {
                errors.at(&function.sig.inputs, message);
            }
        }
        Err(emit::Obstacle::Kinetic(message)) => {
            if let Some(function) = function("kinetic") {
                errors.at(&function.sig.ident, message);
            }
        }
        Err(emit::Obstacle::Potential(message)) => {
            if let Some(function) = function("potential") {
                errors.at(&function.sig.ident, message);
            }
        }
        Err(emit::Obstacle::Softening(softening)) => {
            let message = "Jacobi coordinates do not support a softened distance of two bodies\nhelp: leave out the \
                           softening, or `coordinates` and `split`\nnote: Kepler's equation solves the potential `-G \
                           m[i] m[j] / r`";
            match (model.place_of(softening), function("potential")) {
                (Some(place), _) => errors.at(place, message),
                (None, Some(function)) => errors.at(&function.sig.ident, message),
                (None, None) => {}
            }
        }
    }
}

/// Checks a sequence in place against this Hamiltonian; rustc checks a named one.
fn check_composition(input: &Input, model: &Model, errors: &mut Errors) {
    if let Some(Compose::InPlace(sequence, span)) = &input.compose
        && let Some(refusal) = emit::refusal(sequence, model)
    {
        match sequence.gradient() {
            Some(gradient) => errors.at(gradient, refusal),
            None => errors.at_span(*span, refusal),
        }
    }
}
