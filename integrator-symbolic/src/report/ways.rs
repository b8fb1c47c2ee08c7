//! How parts move, and why, in words; and the parts with exact flows that H in one piece has.

use crate::{
    graph::{ParameterId, exact::Exact},
    model::{Model, Split, factors_of},
    prose,
};

/// How a part of this form moves, and why.
pub(super) fn way(form: &Exact) -> &'static str {
    match form {
        Exact::OfMomenta => "a drift, since it depends on p only",
        Exact::OfPositions => "a kick, since it depends on q only",
        Exact::Shear => "a shear, since it depends on no coordinate together with its conjugate",
        Exact::Quadratic(_) => "a matrix exponential, since it is a quadratic form in q and p",
        Exact::Shifted(_) => "a shear between two canonical shifts, since it depends on p[i] by p[i] - a(q) only",
        Exact::Kepler(_) => "universal variables, since it is a sum of p²/2m - k/|q| over bodies",
        Exact::Own => "a hand-written flow",
    }
}

/// The parts with exact flows of an H in one piece, or the term that has none; nothing of another H.
pub(super) fn explicit(model: &mut Model) -> Vec<String> {
    if !matches!(model.split, Split::Whole) {
        return Vec::new();
    }
    let Model { graph, parameters, lengths, kinetic, .. } = &mut *model;
    let factors_of = |id: ParameterId| factors_of(parameters, id);
    let found = graph.explicit_parts(*kinetic, lengths, &factors_of);
    match found {
        Ok(parts) => {
            let letters = |count| {
                let letters = ('a'..='z').map(String::from);
                letters.chain((0..).map(|number| format!("part_{number}"))).take(count).collect()
            };
            // The macro sorts the terms of a function itself.
            let (names, how): (Vec<String>, _) = match &parts[..] {
                [(_, Exact::Quadratic(_)), _] => {
                    (["quadratic", "rest"].map(String::from).into(), "of the same function")
                }
                parts => (letters(parts.len()), "one function for each part"),
            };
            let first = format!("explicit instead: `split = {}`, {how}:", names.join(" + "));
            let parts = names.iter().zip(&parts).map(|(name, (energy, form))| {
                let formula = prose::formula(model, *energy);
                format!("  {name} = {formula}: {}", way(form))
            });
            [first].into_iter().chain(parts).collect()
        }
        Err(term) => {
            vec![format!("implicit, since no exact flow is known for the term {}", prose::formula(model, term))]
        }
    }
}
