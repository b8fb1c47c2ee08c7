//! Friction: whether the splitting, the mass matrix and the other arguments support it.

use crate::{
    errors::Errors,
    model::{Model, Split},
    prose::Formulas,
    syntax::{Compose, Friction, Input},
};

/// Checks friction, or a sequence with friction where there is none.
pub(super) fn check_friction(input: &Input, model: &Model, errors: &mut Errors) {
    let in_place = match &input.compose {
        Some(Compose::InPlace(sequence, span)) => Some((sequence.has_friction(), *span)),
        _ => None,
    };
    let Some(Friction { rate, temperature }) = &input.friction else {
        if let Some((true, span)) = in_place {
            let message = "this sequence has friction `O`, and the system has none\nhelp: add `#[friction] fn friction(&self, \
                           i: usize) -> f64`, or leave out `O`";
            errors.at_span(span, message);
        }
        return;
    };
    if let Some((false, span)) = in_place {
        let message = "this sequence does not apply the friction of the system\nhelp: add `O`, as in `V(1/2) T(1/2) O(1) T(1/2) \
                       V(1/2)`";
        errors.at_span(span, message);
    }
    let supported = match model.split {
        Split::Energies | Split::Nested => true,
        Split::Parts => model.parts.len() == 2,
        Split::Jacobi(_) | Split::Pair | Split::Copies(_) | Split::Whole => false,
    };
    if !supported {
        let message = "friction requires H = T(p) + V(q), two parts with exact flows, or inner steps\nhelp: write `split = \
                       kinetic + potential + friction`";
        errors.at(&rate.name, message);
    }
    if let Some(by) = input.sensitive.first() {
        errors.at(by, "`sensitive` does not support friction\nhelp: leave out one of them");
    }
    if let Some(gpu) = &input.gpu {
        errors.at_span(gpu.span, "`gpu` does not support friction\nhelp: leave out one of them");
    }
    // Masses of other parts are checked at the start of a run.
    let has_constant_mass = model.quadratic || !matches!(model.split, Split::Energies);
    if let Some(temperature) = temperature.as_ref().filter(|_| supported && !has_constant_mass) {
        let term = Formulas::of(model).not_quadratic(model.kinetic);
        let message = format!(
            "a temperature requires T = Σ p²/(2m) with constant masses, but T has the term `{term}`\nhelp: leave out \
             `#[temperature]`, or change T"
        );
        errors.at(&temperature.name, message);
    }
}
