//! Sequences in the annotation: whether they have their order with the parts of this Hamiltonian.

use crate::{
    errors::Errors,
    model::{Model, Split},
    prose::Formulas,
    scheme::InPlace,
    syntax::{Compose, Input},
};

/// Checks a sequence in place against this Hamiltonian; rustc checks a named one.
pub(super) fn check_composition(input: &Input, model: &Model, errors: &mut Errors) {
    if let Some(Compose::InPlace(sequence, span)) = &input.compose
        && let Some(refusal) = refusal(sequence, model)
    {
        match sequence.gradient() {
            Some(gradient) => errors.at(gradient, refusal),
            None => errors.at_span(*span, refusal),
        }
    }
}

/// What in a sequence requests a quadratic `T` that this Hamiltonian does not have: the message for it.
fn refusal(sequence: &InPlace, model: &Model) -> Option<String> {
    match model.split {
        Split::Pair => return refusal_of_pairs(sequence),
        Split::Nested => return refusal_of_nests(sequence),
        _ => {}
    }
    if model.flows() > 2 {
        return refusal_of_many_parts(sequence);
    }
    if model.quadratic {
        return None;
    }
    let term = Formulas::of(model).not_quadratic(model.kinetic);
    let proof = sequence.proof();
    match proof.general {
        None => Some(format!(
            "a force-gradient kick requires T = ½ pᵀ M⁻¹ p, but T has the term `{term}`\nhelp: use only kicks `V(b)`"
        )),
        Some(general) if general.order < proof.quadratic.order => Some(format!(
            "this sequence has order {} only if T is quadratic in p with constant masses, but T has the term \
             `{term}`\nhelp: use a composition for general T, such as `Yoshida4`\nnote: for this T the order of the \
             sequence is {}",
            proof.quadratic.order, general.order
        )),
        Some(_) => None,
    }
}

/// The same where there are more than two parts.
fn refusal_of_many_parts(sequence: &InPlace) -> Option<String> {
    let proof = sequence.proof();
    let without = "use a composition of general class without a processor, such as `Yoshida4`";
    match proof.general {
        _ if sequence.is_processed() => Some(format!("a processor supports exactly two parts of H\nhelp: {without}")),
        None => Some(format!("a force-gradient kick requires H = ½ pᵀ M⁻¹ p + V(q), in two parts\nhelp: {without}")),
        Some(general) if general.order < proof.quadratic.order => Some(format!(
            "this sequence has order {} only for H = ½ pᵀ M⁻¹ p + V(q), and order {} for other parts\nhelp: {without}",
            proof.quadratic.order, general.order
        )),
        Some(_) => None,
    }
}

/// The same where the last part takes inner steps.
fn refusal_of_nests(sequence: &InPlace) -> Option<String> {
    let such = "help: use a composition such as `Verlet`, `Yoshida4` or `Aba864`";
    match sequence.proof().general {
        None => Some(format!("a force-gradient kick requires H = ½ pᵀ M⁻¹ p + V(q), without inner steps\n{such}")),
        Some(_) if sequence.is_processed() => Some(format!("a processor does not support inner steps\n{such}")),
        Some(_) => None,
    }
}

/// The same where the last part is a pair of parts.
fn refusal_of_pairs(sequence: &InPlace) -> Option<String> {
    let such = "help: use a composition such as `Abah1064`, `Verlet` or `Yoshida4`";
    match sequence.proof().general {
        None => Some(format!(
            "a force-gradient kick requires H = ½ pᵀ M⁻¹ p + V(q), without a pair of parts in parentheses\n{such}"
        )),
        Some(_) if sequence.merges_kicks() => Some(
            "this sequence begins and ends with a kick, which a pair of parts in parentheses does not support\nhelp: \
             begin with a drift\nnote: two kicks in a row do not merge into one if the kicked part is a pair of parts"
                .to_owned(),
        ),
        Some(general) if !sequence.keeps_pairs() => Some(format!(
            "this sequence does not have order {} with a pair of parts in parentheses\n{such}\nnote: such a pair has \
             an error in the third power of each kick, and these errors do not cancel here",
            general.order
        )),
        Some(_) => None,
    }
}
