//! Inspects any Hamiltonian from the command line, `show`, `expand` and `prove`, exports it to C, `export`, begins a crate, `new`, and
//! converts orbital elements, `elements`.
//!
//! The answer goes to standard output, messages to standard error. Exit codes: 0 if all is well, 1 if the input is
//! wrong, 2 if the command is.
#![forbid(unsafe_code)]
#![allow(clippy::doc_markdown, reason = "doc comments are the help that the program prints")]

mod answer;
mod catalogue;
mod elements;
mod expand;
mod export;
mod mistake;
mod new;
mod prove;
mod show;
mod source;
mod table;

use clap::{Args, Parser, Subcommand};
use mistake::Mistake;
use source::Source;
use std::{
    fs,
    io::{self, Write},
    path::{Path, PathBuf},
    process::ExitCode,
};

/// Inspects Hamiltonians and compositions without running them, exports them to C, begins new crates, and converts
/// orbital elements
///
/// Exit codes: 0 if all is well, 1 if the input is wrong (messages on standard error), 2 if the
/// command is.
#[derive(Parser)]
#[command(name = "integrator-cli", version, verbatim_doc_comment)]
struct Command {
    #[command(subcommand)]
    task: Task,
}

#[derive(Subcommand)]
enum Task {
    /// What is derived of every `#[hamiltonian]` impl in a file: equations, class, operations, compositions
    ///
    /// The impls are read as the macro reads them, with the same messages; the rest of the file is not
    /// looked at. Operations are those that generated code carries out, once per site, body, pair or
    /// iteration of the loops named beside them, where the conditions on indices beside them hold. Of a
    /// condition on numbers, both sides count. What depends on parameters alone is left out, as it is
    /// computed once per run.
    ///
    /// Keys of --json:
    ///   file, systems
    ///   systems: system, line, parts, equations, separable, quadratic_kinetic, autonomous, drift, kick,
    ///            flows_of_parts (name, form, way, slower), explicit, operations (written, shared, energies,
    ///            together), compose, composition, admissible
    ///   drift, kick: form (plain, lanes, terms, line, plane, volume, row, pairs, lists), others (the form beside pairs),
    ///            places, cost, slower
    ///   slower: than, range, reason, instead
    ///   places: each (iteration, site, body, pair, ordered pair), loops, conditions, additions,
    ///           multiplications, divisions, roots, functions, branches, coordinates
    ///   composition, admissible: name, order, symmetric, forces_per_step, stability_limit
    #[command(verbatim_doc_comment)]
    Show {
        #[command(flatten)]
        file: File,
    },
    /// What `#[hamiltonian]` writes for every annotated impl in a file, formatted
    ///
    /// Keys of --json:
    ///   file, systems
    ///   systems: system, expansion
    #[command(verbatim_doc_comment)]
    Expand {
        #[command(flatten)]
        file: File,
    },
    /// One C99 header with the steps, the energy and the tangent of the systems of a file
    ///
    /// The header needs nothing but the standard library. It has structs for parameters and state, and
    /// for each composition NAME_advance_COMPOSITION, NAME_step_COMPOSITION and NAME_tangent_COMPOSITION.
    /// Systems need code for devices: H in one piece, named parts without such code and slices of
    /// coordinates are refused with the reason.
    #[command(verbatim_doc_comment)]
    Export {
        /// A Rust file with annotated impls and the structs of their parameters
        #[arg(value_name = "FILE.rs")]
        path: PathBuf,
        #[command(flatten)]
        options: export::Options,
    },
    /// A crate with one Hamiltonian, a run, and a test that certifies it
    ///
    /// With --python, the crate is a Python module for maturin, with a script in cells like a notebook.
    #[command(verbatim_doc_comment)]
    New {
        #[command(flatten)]
        options: new::Options,
    },
    /// Order, symmetry, stability limit and error terms of a sequence of stages
    ///
    /// Keys of --json:
    ///   sequence, order, general_order, quadratic_order, generalised_orders, orders_over_inner,
    ///   class (general, quadratic), symmetric, stages and processor (part, coefficient, gradient),
    ///   forces_per_step, gradients_per_step, stability_limit, leading_error,
    ///   error_terms (bracket, factor), violation (word, residual), citation
    #[command(verbatim_doc_comment)]
    Prove {
        /// Stages in the order in which they act, or the name of a composition of the catalogue
        ///
        /// `V(1/2) T(1) V(1/2)`, with all that `composition!` understands, such as `triple_jump(Verlet)`.
        #[arg(verbatim_doc_comment)]
        sequence: String,
        /// The order that is expected: exit code 1 and the first violated condition if it is lower
        #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..))]
        order: Option<u32>,
        /// One JSON object instead of text
        #[arg(long)]
        json: bool,
    },
    /// Orbital elements of the bodies of a table, and back
    ///
    /// The table is comma-separated, with the names of its columns in the first line. Names may have a
    /// unit after an underscore, such as `x_au`. Lines that begin with # are comments. The first body is
    /// the centre. Angles are in radians, unless --degrees is given.
    ///
    ///   body, mass, x, y, z, vx, vy, vz: prints elements
    ///   body, mass, eccentricity, axis or pericentre, inclination, node, argument, and one of
    ///       mean_anomaly, true_anomaly, since_pericentre: prints positions and velocities relative to
    ///       the barycentre
    ///   t, q0_0, ..., p0_0, ..., as `integrator_core::output::csv` writes them: prints elements of each
    ///       body in each sample; requires --masses
    ///
    /// Keys of --json:
    ///   file, rows
    ///   rows: the columns that are printed: t, body, mass, axis, pericentre, eccentricity, inclination,
    ///         node, argument, mean_anomaly; or body, mass, x, y, z, vx, vy, vz
    #[command(verbatim_doc_comment)]
    Elements {
        /// A table of bodies, of elements or of samples
        #[arg(value_name = "TABLE.csv")]
        path: PathBuf,
        #[command(flatten)]
        options: elements::Options,
        /// One JSON object instead of text
        #[arg(long)]
        json: bool,
    },
}

#[derive(Args)]
struct File {
    /// A Rust file with annotated impls
    #[arg(value_name = "FILE.rs")]
    path: PathBuf,
    /// One JSON object instead of text
    #[arg(long)]
    json: bool,
}

fn main() -> ExitCode {
    let (answer, json) = match Command::parse().task {
        Task::Export { path, options } => {
            let header = Source::read(&path).and_then(|source| export::export(&source, &options));
            return written(header, options.output.as_deref());
        }
        Task::Show { file: File { path, json } } => (Source::read(&path).and_then(|source| show::show(&source)), json),
        Task::Expand { file: File { path, json } } => {
            (Source::read(&path).and_then(|source| expand::expand(&source)), json)
        }
        Task::New { options } => return written(new::new(&options), None),
        Task::Elements { path, options, json } => {
            (Source::read(&path).and_then(|source| elements::elements(&source, &options)), json)
        }
        Task::Prove { sequence, order, json } => (prove::prove(&sequence, order), json),
    };
    match answer {
        Ok(answer) => {
            let text = if json { format!("{:#}\n", answer.json) } else { answer.text };
            // A reader that has seen enough, such as `head`, closes the pipe; that is no mistake.
            let _ = io::stdout().write_all(text.as_bytes());
            ExitCode::SUCCESS
        }
        Err(mistake) => {
            let _ = io::stderr().write_all(mistake.0.as_bytes());
            ExitCode::from(1)
        }
    }
}

/// Writes a text to a file, or to standard output.
fn written(text: Result<String, Mistake>, file: Option<&Path>) -> ExitCode {
    let written = text.and_then(|text| match file {
        None => {
            let _ = io::stdout().write_all(text.as_bytes());
            Ok(())
        }
        Some(file) => fs::write(file, text)
            .map_err(|error| Mistake::plain(format!("{} cannot be written: {error}", file.display()))),
    });
    match written {
        Ok(()) => ExitCode::SUCCESS,
        Err(mistake) => {
            let _ = io::stderr().write_all(mistake.0.as_bytes());
            ExitCode::from(1)
        }
    }
}
