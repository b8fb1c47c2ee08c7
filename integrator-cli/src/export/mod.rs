//! `export --c`: systems of a file as one C99 header.
//!
//! In: annotated impls with device code, and compositions. Out: a header without dependencies. Flows and elementary functions are
//! those of devices, translated by `lines`; a machine with fused multiply-add gets the bits of the Rust run.

mod functions;
mod header;
mod items;
mod lines;
mod parameters;

use crate::{
    catalogue::{Catalogue, catalogue},
    mistake::Mistake,
    show::own_compositions,
    source::{Annotated, Source},
};
use clap::Args;
use header::{Composed, section};
use integrator_symbolic::{Exported, Proved, exported, nearest, sequence};
use items::Items;
use proc_macro2::Span;
use std::{fmt::Write, path::PathBuf};

#[derive(Args)]
pub(crate) struct Options {
    /// Writes C99: a header that needs nothing but the standard library
    #[arg(long, required = true)]
    c: bool,
    /// A composition of the catalogue or of the file; the one of the annotation if there is none
    #[arg(long = "composition", value_name = "NAME")]
    compositions: Vec<String>,
    /// The system to export; all of the file if there is none
    #[arg(long, value_name = "NAME")]
    system: Option<String>,
    /// The file to write; standard output if there is none
    #[arg(short, long, value_name = "FILE.h")]
    pub(crate) output: Option<PathBuf>,
}

/// The compositions of the file, which hide those of the catalogue, and these.
struct Known<'k> {
    own: &'k [Proved],
    catalogue: &'k Catalogue,
}

impl Known<'_> {
    fn all(&self) -> impl Iterator<Item = &Proved> {
        self.own.iter().chain(self.catalogue.iter())
    }

    fn find(&self, name: &str) -> Option<&Proved> {
        self.own
            .iter()
            .find(|proved| proved.name == name)
            .or_else(|| self.catalogue.iter().find(|proved| proved.name == name))
    }
}

/// The header of the systems of a file.
pub(crate) fn export(source: &Source, options: &Options) -> Result<String, Mistake> {
    let seen = source.seen()?;
    if seen.systems.is_empty() {
        return Err(Mistake::plain(format!("no impl in {} is annotated with `#[hamiltonian]`", source.name)));
    }
    let (own, catalogue) = (own_compositions(source, &seen)?, catalogue());
    let known = Known { own: &own, catalogue: &catalogue };
    let items = Items::of(source.tokens()?);
    let named = |annotated: &&Annotated| match &options.system {
        Some(name) => annotated.system() == *name,
        None => true,
    };
    let chosen: Vec<&Annotated> = seen.systems.iter().filter(named).collect();
    if let ([], Some(name)) = (&chosen[..], &options.system) {
        let names: Vec<String> = seen.systems.iter().map(Annotated::system).collect();
        return Err(unknown("--system", "system", name, &names));
    }
    let (mut sections, mut names, mut mistakes) = (Vec::new(), Vec::new(), Vec::new());
    for annotated in chosen {
        match system(source, annotated, &options.compositions, &known, &items) {
            Ok((name, _)) if names.contains(&name) => {
                let message = format!("two systems have the name `{name}` in C\nhelp: rename one of them");
                mistakes.push(Mistake::at(source, [(annotated.span, message)]));
            }
            Ok((name, text)) => {
                names.push(name);
                sections.push(text);
            }
            Err(mistake) => mistakes.push(mistake),
        }
    }
    match mistakes.is_empty() {
        true => Ok(header::header(source, &names, &sections.concat())),
        false => Err(Mistake::joined(mistakes)),
    }
}

/// The name of a system in C, and its section of the header.
fn system(
    source: &Source,
    annotated: &Annotated,
    compositions: &[String],
    known: &Known<'_>,
    items: &Items,
) -> Result<(String, String), Mistake> {
    let Annotated { arguments, item, span } = annotated;
    let exported = exported(arguments.clone(), item.clone()).map_err(|error| Mistake::of(source, error, *span))?;
    let found: Vec<Composed> = match compositions {
        [] => vec![annotated_composition(source, *span, &exported, known)?],
        names => {
            let different = names.iter().enumerate().filter(|(number, name)| !names[..*number].contains(name));
            different.map(|(_, name)| composition(name, known)).collect::<Result<_, _>>()?
        }
    };
    if let Some(Composed { name, .. }) =
        found.iter().find(|found| found.proved.quadratic_kinetic && !exported.quadratic_kinetic)
    {
        let message = format!(
            "`{name}` requires H = ½ pᵀ M⁻¹ p + V(q) with a constant M, and H of `{}` is not of this form\nhelp: choose \
             one of the compositions that `show` lists without *",
            exported.system
        );
        return Err(Mistake::at(source, [(*span, message)]));
    }
    section(source, &exported, &found, items).map_err(|(place, message)| {
        let place = if place.byte_range() == (0..0) { *span } else { place };
        Mistake::at(source, [(place, message)])
    })
}

/// The composition of an annotation: a name, or a sequence in place.
fn annotated_composition(
    source: &Source,
    span: Span,
    exported: &Exported,
    known: &Known<'_>,
) -> Result<Composed, Mistake> {
    let name = exported.compose.rsplit("::").next().unwrap_or_default().trim();
    if let Some(proved) = known.find(name) {
        return Ok(Composed { name: name.to_owned(), proved: proved.clone() });
    }
    let proved = exported.compose.parse().ok().and_then(|tokens| sequence(tokens, None).ok());
    proved.map(|proved| Composed { name: "composed".to_owned(), proved }).ok_or_else(|| {
        let message = format!(
            "`{name}` is declared in another file\nhelp: choose a composition of the catalogue by `--composition NAME`"
        );
        Mistake::at(source, [(span, message)])
    })
}

/// A composition that the command names.
fn composition(name: &str, known: &Known<'_>) -> Result<Composed, Mistake> {
    match known.find(name) {
        Some(proved) => Ok(Composed { name: name.to_owned(), proved: proved.clone() }),
        None => {
            let names: Vec<String> = known.all().map(|proved| proved.name.clone()).collect();
            Err(unknown("--composition", "composition", name, &names))
        }
    }
}

fn unknown(option: &str, what: &str, name: &str, known: &[String]) -> Mistake {
    let near: Vec<String> = nearest(name, known).into_iter().map(|near| format!("`{near}`")).collect();
    let mut message = format!("unknown {what} `{name}` of `{option}`");
    let _ = match (near.is_empty(), what) {
        (false, _) => write!(message, "\nhelp: similar names: {}", near.join(", ")),
        (true, "system") => write!(message, "\nhelp: the file has {}", known.join(", ")),
        (true, _) => write!(message, "\nhelp: `show` lists the catalogue"),
    };
    Mistake::plain(message)
}
