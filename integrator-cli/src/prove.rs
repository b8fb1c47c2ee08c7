//! `prove`: the proved properties of a typed sequence of stages, or of a composition of the catalogue.

use crate::{answer::Answer, catalogue::catalogue, mistake::Mistake, source::Source};
use integrator_symbolic::{Proved, ProvedStage, named_otherwise, nearest, sequence};
use proc_macro2::{Span, TokenTree};
use serde_json::{Value, json};
use std::fmt::Write;

/// How many error terms people are shown.
const TERMS: usize = 6;

/// The answer for a text; the mistake, if it is not of `order`.
pub(crate) fn prove(text: &str, order: Option<u32>) -> Result<Answer, Mistake> {
    let source = Source { name: "sequence".to_owned(), text: text.to_owned() };
    let tokens = source.tokens()?;
    let trees: Vec<TokenTree> = tokens.clone().into_iter().collect();
    let known = catalogue();
    let named = match &trees[..] {
        [TokenTree::Ident(name)] => known.iter().find(|proved| name == &proved.name),
        _ => None,
    };
    if let Some(proved) = named
        && let Some(order) = order.filter(|order| *order > proved.quadratic_order)
    {
        let failed = proved.violation.as_ref().map(|violation| {
            format!(
                "\nnote: the order condition of the word {} has a residual of {:.1e}",
                violation.word,
                violation.residual.abs()
            )
        });
        let message =
            format!("declared order {order}, but the proof finds order {}{}", proved.order, failed.unwrap_or_default());
        return Err(Mistake::at(&source, trees.first().map(|tree| (tree.span(), message))));
    }
    let proved = match named {
        Some(proved) => proved,
        None => &sequence(tokens, order).map_err(|error| match misspelt(&trees, &known) {
            Some((span, message)) => Mistake::at(&source, [(span, message)]),
            None => Mistake::of(&source, error, Span::call_site()),
        })?,
    };
    Ok(Answer { text: shown(text, proved), json: value(text, proved) })
}

/// What to say of a lone name that is nearly one of the catalogue, and is no other name of one.
fn misspelt(trees: &[TokenTree], known: &[Proved]) -> Option<(Span, String)> {
    let [TokenTree::Ident(name)] = trees else { return None };
    if named_otherwise(&name.to_string()).is_some() {
        return None;
    }
    let names: Vec<String> = known.iter().map(|proved| proved.name.clone()).collect();
    let near: Vec<String> = nearest(&name.to_string(), &names).into_iter().map(|near| format!("`{near}`")).collect();
    let message = format!("unknown composition `{name}`\nhelp: similar names: {}", near.join(", "));
    (!near.is_empty()).then(|| (name.span(), message))
}

fn shown(text: &str, proved: &Proved) -> String {
    let order = match proved.general_order {
        None => format!("{} for T = ½ pᵀ M⁻¹ p; the step is defined for no other T", proved.quadratic_order),
        Some(general) if general == proved.quadratic_order => format!("{general} for every T(p)"),
        Some(general) => format!("{general} for every T(p), {} for T = ½ pᵀ M⁻¹ p", proved.quadratic_order),
    };
    let class = if proved.quadratic_kinetic { "T = ½ pᵀ M⁻¹ p alone" } else { "every T(p)" };
    let gradients = match proved.gradient_evaluations {
        0 => String::new(),
        some => format!(", {some} with its gradient"),
    };
    let mut shown = format!("{}\n", text.trim());
    let mut row = |name: &str, value: &str| {
        let _ = writeln!(shown, "    {name:<16} {value}");
    };
    row("order", &order);
    if let [_, _, ..] = proved.generalised_orders[..] {
        let orders: Vec<String> = proved.generalised_orders.iter().map(u32::to_string).collect();
        row("small second", &format!("({}) where the part of the kicks is small", orders.join(", ")));
    }
    if let Some(orders) = proved.orders_over_inner {
        row("inner steps", &over_inner(proved.order, orders));
        if proved.generalised_orders.len() > 1 {
            row("", "errors of at most ε^(r+1) h^r for H = A + ε B and an inner order r");
        }
    }
    row("symmetric", if proved.symmetric { "yes" } else { "no" });
    row("class", class);
    row("stages", &stages(&proved.stages));
    if !proved.processor.is_empty() {
        row("processor", &stages(&proved.processor));
    }
    row("forces per step", &format!("{}{gradients}", proved.force_evaluations));
    row("stable", &format!("h ω < {:.6}", proved.stability_limit));
    if let Some(violation) = &proved.violation {
        row(
            "residual",
            &format!("{:.1e} in the order condition of the word {}", violation.residual.abs(), violation.word),
        );
    }
    if let Some(norm) = proved.leading_error {
        row("leading error", &format!("{norm:.6e} h^{}, the norm of", proved.order + 1));
    }
    let mut terms: Vec<_> = proved.error_terms.iter().filter(|(_, factor)| factor.abs() > 1e-25).collect();
    terms.sort_by(|a, b| b.1.abs().total_cmp(&a.1.abs()));
    for (bracket, factor) in terms.iter().take(TERMS) {
        row("", &format!("{factor:+.6e} {bracket}"));
    }
    if terms.len() > TERMS {
        row("", &format!("and {} smaller terms", terms.len() - TERMS));
    }
    if !proved.citation.is_empty() {
        row("source", &proved.citation);
    }
    shown
}

/// The orders over symmetric inner compositions of order 2, 4, 6 and 8, up to the first that is the order itself.
fn over_inner(order: u32, orders: [u32; 4]) -> String {
    if orders[0] == order {
        return format!("order {order} if any symmetric composition integrates the second part");
    }
    let first = orders[0];
    let mut entries = vec![format!("order {first} if a symmetric composition of order 2 integrates the second part")];
    for (found, inner) in orders.into_iter().zip([2, 4, 6, 8]).skip(1) {
        if found == order {
            entries.push(format!("{found} if of order {inner} or higher"));
            break;
        }
        entries.push(format!("{found} if of order {inner}"));
    }
    entries.join(", ")
}

/// Stages as they are typed, with coefficients as decimals.
fn stages(stages: &[ProvedStage]) -> String {
    let stage = |stage: &ProvedStage| match stage.gradient {
        0.0 => format!("{}({})", stage.letter, stage.coefficient),
        gradient => format!("{}({}, {gradient})", stage.letter, stage.coefficient),
    };
    stages.iter().map(stage).collect::<Vec<_>>().join(" ")
}

fn value(text: &str, proved: &Proved) -> Value {
    let stages = |stages: &[ProvedStage]| -> Vec<Value> {
        let stage = |stage: &ProvedStage| {
            json!({
                "part": stage.letter.to_string(),
                "coefficient": stage.coefficient,
                "gradient": stage.gradient,
            })
        };
        stages.iter().map(stage).collect()
    };
    let terms: Vec<_> =
        proved.error_terms.iter().map(|(bracket, factor)| json!({ "bracket": bracket, "factor": factor })).collect();
    let violation = proved.violation.as_ref();
    json!({
        "sequence": text.trim(),
        "order": proved.order,
        "general_order": proved.general_order,
        "generalised_orders": proved.generalised_orders,
        "quadratic_order": proved.quadratic_order,
        "orders_over_inner": proved.orders_over_inner,
        "class": if proved.quadratic_kinetic { "quadratic" } else { "general" },
        "symmetric": proved.symmetric,
        "stages": stages(&proved.stages),
        "processor": stages(&proved.processor),
        "forces_per_step": proved.force_evaluations,
        "gradients_per_step": proved.gradient_evaluations,
        "stability_limit": proved.stability_limit,
        "leading_error": proved.leading_error,
        "error_terms": terms,
        "violation": violation.map(|violation| json!({ "word": violation.word, "residual": violation.residual })),
        "citation": proved.citation,
    })
}
