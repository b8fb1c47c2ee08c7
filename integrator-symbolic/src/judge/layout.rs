//! Whether the kick has the layout that the annotation requests.

use crate::{
    errors::Errors,
    layout::{
        Form,
        lost::{of_part, why_not},
    },
    model::{Model, Split},
    reason::Reason,
    spelling::nearest,
    syntax::Input,
};
use proc_macro2::Ident;

/// Reports a requested layout that the kick of a model does not have. Recognition adds to the graph, so it gets a model of its own.
pub(crate) fn check_layout(input: &Input, mut model: Model, errors: &mut Errors) {
    let Some(word) = &input.layout else { return };
    let Some(wanted) = Form::named(&word.to_string()) else { return errors.at(word, unknown(word)) };
    if model.is_mixed() {
        let split = if let Split::Whole = model.split { "none" } else { "symmetric" };
        let message = format!("`split = {split}` has no kick, whose layout could be checked\nhelp: leave out `layout`");
        return errors.at(word, message);
    }
    if !model.is_separable() {
        return check_parts(word, wanted, &mut model, errors);
    }
    let (kick, reason) = why_not(&mut model, wanted);
    if kick.name() != wanted.name() {
        let has = format!("the kick has the layout `{}` instead of `{}`", kick.name(), wanted.name());
        errors.at(word, with_reason(has, reason, Some(kick)));
    }
}

/// The same of parts with names: one of them has to have the layout.
fn check_parts(word: &Ident, wanted: Form, model: &mut Model, errors: &mut Errors) {
    let (mut found, mut reason) = (Vec::new(), None);
    for number in 0..model.parts.len() {
        let name = model.parts[number].name();
        match of_part(model, number) {
            Some((form, _)) if form.name() == wanted.name() => return,
            Some((form, lost)) => {
                found.push(format!("`{name}` is `{}`", form.name()));
                let of_wanted = |reason| reason == Reason::InPart || !wanted.is_of_pairs();
                reason = reason.or(lost.into_iter().map(|lost| lost.reason).find(|reason| of_wanted(*reason)));
            }
            None => found.push(format!("`{name}` has an exact flow of its own")),
        }
    }
    let has = format!("no part of H has the layout `{}`: {}", wanted.name(), found.join(", "));
    errors.at(word, with_reason(has, reason, None));
}

/// The message about a layout that is not the requested one; `kick` is the word that could stand instead.
fn with_reason(has: String, reason: Option<Reason>, kick: Option<Form>) -> String {
    let [reason, instead] = reason.map_or([""; 2], Reason::texts);
    let other = kick.map(|kick| format!("`layout = {}`", kick.name()));
    let instead = [instead.to_owned()].into_iter().filter(|text| !text.is_empty()).chain(other).collect::<Vec<_>>();
    let help = match &instead[..] {
        [] => "leave out `layout`".to_owned(),
        instead => format!("write {}", instead.join(", or ")),
    };
    let note = if reason.is_empty() { String::new() } else { format!("\nnote: {reason}") };
    format!("{has}\nhelp: {help}{note}")
}

fn unknown(word: &Ident) -> String {
    let names = Form::names();
    let near: Vec<_> = nearest(&word.to_string(), &names).iter().map(|name| format!("`layout = {name}`")).collect();
    let like = if near.is_empty() { String::new() } else { format!("\nhelp: write {}", near.join(" or ")) };
    let names: Vec<_> = names.iter().map(|name| format!("`{name}`")).collect();
    format!("unknown layout `{word}`{like}\nnote: the layouts are {}", names.join(", "))
}
