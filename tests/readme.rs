//! The documents say what is true: the table is what was proved, the commands are what is run, lists are complete.

#[path = "../integrator-core/src/catalogue_list.rs"]
mod catalogue;

use catalogue::for_each_composition;
use integrator_core::{Class, prelude::*};
use std::{fs, path::Path};

const BEGIN: &str = "<!-- compositions: begin -->\n";
const END: &str = "<!-- compositions: end -->";

fn text(path: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(path);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// One row of the table, and what rows are sorted by.
fn row<X: Scheme>(_: X) -> ((u32, usize, &'static str), String) {
    let symmetric = if X::SYMMETRIC { "yes" } else { "no" };
    let kinetic = if X::CLASS == Class::General { "any" } else { "quadratic" };
    let (name, order, forces, limit) = (X::NAME, X::ORDER, X::FORCE_EVALUATIONS, X::STABILITY_LIMIT);
    let row = format!("| `{name}` | {order} | {symmetric} | {kinetic} | {forces} | {limit:.2} |\n");
    ((X::ORDER, X::FORCE_EVALUATIONS, X::NAME), row)
}

/// The table as it has to be: lowest order first, and in each order the cheapest step.
fn table() -> String {
    let mut rows = Vec::new();
    macro_rules! note {
        ($($name:ident)*) => { rows.extend([$(row($name)),*]); };
    }
    for_each_composition!(general: note!);
    for_each_composition!(quadratic: note!);
    rows.sort();
    let head = "| composition | order | symmetric | `T` | forces per step | stable for `h·ω` below |\n\
                |---|---|---|---|---|---|\n";
    rows.into_iter().fold(head.to_owned(), |table, (_, row)| table + &row)
}

/// After a change of the catalogue, `UPDATE_README=1 cargo test -p integrator --test readme` writes the table anew.
#[test]
fn the_table_is_what_was_proved() {
    let readme = text("README.md");
    let (before, rest) = readme.split_once(BEGIN).expect("where the table begins");
    let (shown, after) = rest.split_once(END).expect("where the table ends");
    let table = table();
    if std::env::var_os("UPDATE_README").is_some() {
        let updated = format!("{before}{BEGIN}{table}{END}{after}");
        fs::write(Path::new(env!("CARGO_MANIFEST_DIR")).join("README.md"), updated).expect("a README to write");
    } else {
        assert_eq!(shown, table, "run this test with UPDATE_README=1");
    }
}

/// The command that a reader is told to test with is the one that is run for every change.
#[test]
fn the_test_command_is_the_one_that_is_run() {
    let command = "cargo test --workspace";
    let is_line = |text: String| text.lines().any(|line| line == command);
    assert!(is_line(text("README.md")), "the README tells `{command}`");
    assert!(is_line(text(".ci/run")), ".ci/run runs `{command}`");
}

#[test]
fn the_first_command_names_an_example() {
    assert!(text("README.md").contains("\ncargo run --release --example outer_solar_system\n"));
    assert!(text("examples/outer_solar_system/main.rs").contains("fn main"));
}

/// The user documentation of the macro lists every function that can be differentiated.
#[test]
fn every_elementary_function_is_documented() {
    let (page, source) = (text("integrator-macros/src/lib.rs"), text("integrator-symbolic/src/graph/function.rs"));
    let table = source.split_once("const TABLE").and_then(|(_, rest)| rest.split_once("\n];")).expect("the table").0;
    let rows = ["unary(\"", "binary(\"", "name: \""].iter().flat_map(|row| table.split(row).skip(1));
    let names: Vec<&str> = rows.filter_map(|rest| rest.split('"').next()).collect();
    assert!(names.contains(&"sin") && names.contains(&"hypot"), "the rows are found: {names:?}");
    for name in names {
        assert!(page.contains(&format!("`{name}`")), "the documentation of `#[hamiltonian]` leaves out `{name}`");
    }
}

/// Files that the README and the architecture send a reader to are there.
#[test]
fn every_link_leads_somewhere() {
    for page in ["README.md", "ARCHITECTURE.md", "CHANGELOG.md"] {
        for link in text(page).split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
            let local = !link.starts_with("http") && !link.starts_with('#');
            assert!(!local || Path::new(env!("CARGO_MANIFEST_DIR")).join(link).exists(), "{page} links to {link}");
        }
    }
}
