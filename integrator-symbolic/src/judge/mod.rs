//! Checks that a model supports what the annotation requests.
//!
//! In: a model. Out: the model, in Jacobi coordinates if they are requested. Always true: all mistakes are reported;
//! later modules reject no Hamiltonian, except for device code.

mod composition;
pub(crate) mod coordinates;
mod friction;
mod layout;
mod size;

use crate::{
    errors::Errors,
    graph::exact::Exact,
    model::{Model, Split},
    syntax::Input,
};
pub(crate) use layout::check_layout;

/// Returns the model in the requested coordinates, with loops in place of series that are written out, and reports what the
/// annotation requests and the model does not support.
pub(crate) fn judged(input: &Input, mut model: Model, errors: &mut Errors) -> Model {
    coordinates::check_coordinates(input, &mut model, errors);
    composition::check_composition(input, &model, errors);
    friction::check_friction(input, &model, errors);
    check_order(input, &model, errors);
    check_taylor(input, &model, errors);
    check_taylor_of_folds(input, &model, errors);
    check_sensitive(input, &model, errors);
    model.replace_series_by_loops();
    size::check_size(input, &mut model, errors);
    model
}

/// Rejects a claimed order where there is no composition that could have it.
fn check_order(input: &Input, model: &Model, errors: &mut Errors) {
    if let (Some(claim), Split::Whole) = (&input.order, &model.split) {
        let message = "`order` claims the order of a composition, and `split = none` leaves H in one piece\nhelp: leave out `order`";
        errors.at_span(claim.place, message);
    }
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
                part.name()
            );
            errors.at(name, message);
        }
    }
}
