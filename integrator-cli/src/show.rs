//! `show`: what is derived of every annotated impl in a file.

use crate::{
    answer::Answer,
    catalogue::{Catalogue, catalogue},
    mistake::Mistake,
    source::{Annotated, Seen, Source},
};
use integrator_symbolic::{Each, Flow, Proved, Report, Slower, Tally, declared, report, sequence};
use proc_macro2::{Span, TokenStream, TokenTree};
use serde_json::{Value, json};
use std::fmt::Write;

/// The columns of what is derived of a system, and how much deeper the rest of a long line is indented.
const COLUMNS: usize = 120;
const CONTINUED: usize = 8;

/// How many columns the list of the catalogue takes.
const WIDTH: usize = 100;

/// An annotated impl without mistakes.
pub(crate) struct System {
    pub(crate) report: Report,
    /// Where it is annotated.
    line: usize,
    /// Its composition, if it is one of the file or of the catalogue, or written in place.
    composition: Option<Proved>,
}

/// The answer for a file.
pub(crate) fn show(source: &Source) -> Result<Answer, Mistake> {
    let catalogue = catalogue();
    let systems = systems(source, &source.seen()?, &catalogue)?;
    let texts = systems.iter().map(|system| text(source, system, &catalogue));
    let text = texts.chain([listed(&catalogue)]).collect::<Vec<_>>().join("\n");
    let systems: Vec<Value> = systems.iter().map(|system| value(system, &catalogue)).collect();
    Ok(Answer { text, json: json!({ "file": source.name, "systems": systems }) })
}

/// What is derived of each annotated impl, or everything that is wrong with all of them.
pub(crate) fn systems(source: &Source, seen: &Seen, catalogue: &Catalogue) -> Result<Vec<System>, Mistake> {
    if seen.systems.is_empty() {
        return Err(Mistake::plain(format!("no impl in {} is annotated with `#[hamiltonian]`", source.name)));
    }
    let (mut found, mut mistakes) = (Vec::new(), Vec::new());
    let own = own_compositions(source, seen).unwrap_or_else(|mistake| {
        mistakes.push(mistake);
        Vec::new()
    });
    for annotated in &seen.systems {
        match system(source, annotated, &own, catalogue) {
            Ok(system) => found.push(system),
            Err(mistake) => mistakes.push(mistake),
        }
    }
    if mistakes.is_empty() { Ok(found) } else { Err(Mistake::joined(mistakes)) }
}

/// The compositions that a file declares, or everything that is wrong with them.
pub(crate) fn own_compositions(source: &Source, seen: &Seen) -> Result<Vec<Proved>, Mistake> {
    let (mut own, mut mistakes) = (Vec::new(), Vec::new());
    for declarations in &seen.declarations {
        match declared(declarations.clone()) {
            Ok(proved) => own.extend(proved),
            Err(error) => mistakes.push(Mistake::of(source, error, Span::call_site())),
        }
    }
    if mistakes.is_empty() { Ok(own) } else { Err(Mistake::joined(mistakes)) }
}

fn system(source: &Source, annotated: &Annotated, own: &[Proved], catalogue: &Catalogue) -> Result<System, Mistake> {
    let Annotated { arguments, item, span } = annotated;
    let report = report(arguments.clone(), item.clone()).map_err(|error| Mistake::of(source, error, *span))?;
    let name = report.compose.rsplit("::").next().unwrap_or_default().trim();
    let named = |proved: &&Proved| proved.name == name;
    // A composition of the file hides one of the catalogue.
    let composition = match own.iter().find(named).or_else(|| catalogue.iter().find(named)) {
        Some(proved) => Some(proved.clone()),
        // A sequence in place; the path of a composition from elsewhere is none.
        None => report.compose.parse().ok().and_then(|tokens| sequence(tokens, None).ok()),
    };
    if let Some(composition) = &composition
        && composition.name == name
        && composition.quadratic_kinetic
        && !report.quadratic_kinetic
    {
        let message =
            format!("H of `{}` is not ½ pᵀ M⁻¹ p + V(q) with a constant M, as `{name}` needs it", report.system);
        return Err(Mistake::at(source, [(place_of(arguments, name).unwrap_or(*span), message)]));
    }
    Ok(System { report, line: span.start().line, composition })
}

/// Where a name stands in the arguments.
fn place_of(arguments: &TokenStream, name: &str) -> Option<Span> {
    arguments.clone().into_iter().find_map(|tree| match tree {
        TokenTree::Ident(ident) if ident == name => Some(ident.span()),
        _ => None,
    })
}

/// The compositions that may integrate a system.
fn admissible<'c>(report: &Report, catalogue: &'c [Proved]) -> Vec<&'c Proved> {
    let is_admissible =
        |composition: &&Proved| !report.whole && (report.quadratic_kinetic || !composition.quadratic_kinetic);
    catalogue.iter().filter(is_admissible).collect()
}

fn text(source: &Source, system: &System, catalogue: &[Proved]) -> String {
    let System { report, line, composition } = system;
    let mut text = format!("{}, {}:{line}\n", report.system, source.name);
    for line in report.to_string().lines() {
        text += &wrapped(&format!("    {line}"));
    }
    if report.whole {
        let _ = writeln!(text, "    method: {}", report.compose);
        text += "    admissible: implicit methods, `GaussLegendre<1>` to `GaussLegendre<8>`\n";
        return text;
    }
    let composition = match composition {
        None => "which is declared elsewhere".to_owned(),
        Some(proved) => in_short(proved, report.separable),
    };
    text += &wrapped(&format!("    composition: {}, {composition}", report.compose));
    let count = admissible(report, catalogue).len();
    let of = if report.quadratic_kinetic { "all" } else { "those for every T" };
    let _ = writeln!(text, "    admissible: {of} of the catalogue, {count} compositions");
    text
}

/// A line, continued with a deeper indent where it is longer than the columns of `show`.
fn wrapped(line: &str) -> String {
    let indent = line.len() - line.trim_start().len();
    let (mut text, mut column) = (" ".repeat(indent), indent);
    // Runs of spaces are kept, so that a formula stays apart from the range after it.
    for word in line[indent..].split_inclusive(' ') {
        let width = word.trim_end().chars().count();
        if column + width > COLUMNS && column > indent {
            text.truncate(text.trim_end().len());
            column = indent + CONTINUED;
            let _ = write!(text, "\n{}", " ".repeat(column));
        }
        text += word;
        column += word.chars().count();
    }
    text.truncate(text.trim_end().len());
    text + "\n"
}

/// The catalogue, a line or a few for each order.
fn listed(catalogue: &[Proved]) -> String {
    let mut text = "The catalogue, with forces per step; * for quadratic T alone\n".to_owned();
    let mut orders: Vec<u32> = catalogue.iter().map(|proved| proved.order).collect();
    orders.dedup();
    for order in orders {
        let mut line = format!("    order {order:>2}:");
        for proved in catalogue.iter().filter(|proved| proved.order == order) {
            let mark = if proved.quadratic_kinetic { "*" } else { "" };
            let entry = format!(" {}{mark} {},", proved.name, proved.force_evaluations);
            if line.len() + entry.len() > WIDTH {
                let _ = writeln!(text, "{line}");
                line = " ".repeat("    order 10:".len());
            }
            line.push_str(&entry);
        }
        let _ = writeln!(text, "{}", line.trim_end_matches(','));
    }
    text
}

/// The facts of a composition that matter for a choice.
fn in_short(proved: &Proved, separable: bool) -> String {
    let symmetric = if proved.symmetric { "symmetric" } else { "not symmetric" };
    let forces = match proved.force_evaluations {
        1 => "1 force".to_owned(),
        many => format!("{many} forces"),
    };
    let facts = format!("order {}, {symmetric}, {forces} per step", proved.order);
    // The limit is that of an oscillator split into T and V.
    if separable { format!("{facts}, stable for h ω < {:.3}", proved.stability_limit) } else { facts }
}

fn value(system: &System, catalogue: &[Proved]) -> Value {
    let System { report, line, composition } = system;
    let short = |proved: &Proved| {
        json!({
            "name": proved.name,
            "order": proved.order,
            "symmetric": proved.symmetric,
            "forces_per_step": proved.force_evaluations,
            "stability_limit": proved.stability_limit,
        })
    };
    json!({
        "system": report.system,
        "line": line,
        "parts": report.parts,
        "equations": report.equations,
        "separable": report.separable,
        "quadratic_kinetic": report.quadratic_kinetic,
        "autonomous": report.autonomous,
        "drift": flow(&report.drift),
        "kick": flow(&report.kick),
        "flows_of_parts": report.flows_of_parts.iter().map(|part| json!({
            "name": part.name,
            "form": part.form.map(|form| form.name()),
            "way": part.way,
            "slower": slower(&part.slower),
        })).collect::<Vec<_>>(),
        "explicit": report.explicit,
        "operations": {
            "written": report.operations_written,
            "shared": report.operations_shared,
            "energies": report.operations_of_energies,
            "together": report.operations_together,
        },
        "compose": report.compose,
        "composition": composition.as_ref().map(short),
        "admissible": admissible(report, catalogue).into_iter().map(short).collect::<Vec<_>>(),
    })
}

fn flow(flow: &Flow) -> Value {
    let places = flow.places.iter().map(|place| {
        let Tally { additions, multiplications, divisions, roots, functions, branches, coordinates } =
            &place.operations;
        json!({
            "each": each(place.each),
            "loops": place.loops,
            "conditions": place.conditions,
            "additions": additions,
            "multiplications": multiplications,
            "divisions": divisions,
            "roots": roots,
            "functions": functions,
            "branches": branches,
            "coordinates": coordinates,
        })
    });
    json!({
        "form": flow.form.name(),
        "others": flow.others.map(|form| form.name()),
        "places": places.collect::<Vec<_>>(),
        "cost": flow.cost,
        "slower": slower(&flow.slower),
    })
}

/// What a function with operations is called for.
fn each(each: Each) -> &'static str {
    match each {
        Each::Iterations => "iteration",
        Each::Sites => "site",
        Each::Bodies => "body",
        Each::Pairs => "pair",
        Each::OrderedPairs => "ordered pair",
    }
}

fn slower(slower: &[Slower]) -> Vec<Value> {
    let values = slower.iter().map(|Slower { than, range, reason, instead }| {
        json!({ "than": than.name(), "range": range, "reason": reason, "instead": instead })
    });
    values.collect()
}
