//! `expand`: what `#[hamiltonian]` writes for every annotated impl in a file.

use crate::{
    answer::Answer,
    catalogue::catalogue,
    mistake::Mistake,
    show::systems,
    source::{Annotated, Source},
};
use integrator_symbolic::hamiltonian;
use serde_json::json;
use std::panic::{self, AssertUnwindSafe};

/// The answer for a file.
pub(crate) fn expand(source: &Source) -> Result<Answer, Mistake> {
    let seen = source.seen()?;
    let systems = systems(source, &seen, &catalogue())?;
    let texts: Vec<String> = seen.systems.iter().map(written).collect();
    let each = systems.iter().zip(&texts);
    let values: Vec<_> =
        each.map(|(system, text)| json!({ "system": system.report.system, "expansion": text })).collect();
    Ok(Answer { text: texts.join("\n"), json: json!({ "file": source.name, "systems": values }) })
}

/// The impl and what the macro writes after it, formatted.
fn written(annotated: &Annotated) -> String {
    let tokens = hamiltonian(annotated.arguments.clone(), annotated.item.clone());
    let Ok(file) = syn::parse2(tokens.clone()) else { return tokens.to_string() };
    // The formatter gives up with a panic on syntax that is newer than it is; the user's own functions may have any.
    let hook = panic::take_hook();
    panic::set_hook(Box::new(|_| {}));
    let formatted = panic::catch_unwind(AssertUnwindSafe(|| prettyplease::unparse(&file)));
    panic::set_hook(hook);
    formatted.unwrap_or_else(|_| tokens.to_string())
}
