//! The documents say what is true: the commands are what is run, lists are complete, links lead somewhere.

use std::{
    fs,
    path::{Path, PathBuf},
};

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn text(path: impl AsRef<Path>) -> String {
    let path = root().join(path);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The pages in a folder, relative to the root, without those of folders in it.
fn pages_in(folder: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(root().join(folder)).expect("a folder of pages");
    let names = entries.map(|entry| Path::new(folder).join(entry.expect("an entry").file_name()));
    names.filter(|path| path.extension().is_some_and(|extension| extension == "md")).collect()
}

/// Every document that is written for readers.
fn pages() -> Vec<PathBuf> {
    let pages = ["", "docs", "docs/guide/src", "integrator-core", "integrator-macros", "integrator-symbolic"]
        .map(pages_in)
        .concat();
    assert!(pages.len() > 20, "the pages are found: {pages:?}");
    pages
}

/// The lines of a page outside of its blocks of code.
fn prose(page: &str) -> impl Iterator<Item = &str> {
    let mut code = false;
    page.lines().filter(move |line| {
        let fence = line.starts_with("```");
        code ^= fence;
        !code && !fence
    })
}

/// A heading as links name it: in small letters, words joined by hyphens, without other punctuation.
fn anchor(heading: &str) -> String {
    let kept = heading.trim_start_matches('#').trim().to_lowercase();
    let kept = kept.chars().filter(|letter| letter.is_alphanumeric() || [' ', '-', '_'].contains(letter));
    kept.map(|letter| if letter == ' ' { '-' } else { letter }).collect()
}

/// Two screens: what is longer has a page of its own in `docs`.
#[test]
fn the_readme_is_short() {
    let length = text("README.md").len();
    assert!(length <= 10 * 1024, "README.md has {length} bytes");
}

#[test]
fn the_readme_counts_the_catalogue() {
    let page = text("docs/compositions.md");
    let rows = ["facts", "near_integrable"].map(|table| {
        let (_, rows) = page.split_once(&format!("<!-- {table}: begin -->")).expect("where the table begins");
        let (rows, _) = rows.split_once(&format!("<!-- {table}: end -->")).expect("where the table ends");
        rows.lines().filter(|line| line.starts_with("| `")).count()
    });
    let count: usize = rows.iter().sum();
    assert!(text("README.md").contains(&format!("{count} compositions of orders 1 to 10,")), "there are {count}");
}

/// Times and rates that the README names are those of the page that the benches write.
#[test]
fn the_readme_quotes_what_was_measured() {
    let numbers = |row: &str| row.split_whitespace().filter_map(|word| word.parse().ok()).collect::<Vec<f64>>();
    let row_of = |page: &str, row: &str| {
        let line = page.lines().find_map(|line| line.strip_prefix(row)).unwrap_or_else(|| panic!("no row {row:?}"));
        numbers(&line.replace("·10⁹", ""))
    };
    let page = text("docs/performance.md");
    let measured = |row| row_of(&page, row);
    let step = measured("pendulum                 verlet");
    let ensemble = measured("pendulum                 trajectory-steps/s");
    let chain = measured("fput_1e7                 site-steps/s");
    let solar = measured("solar_energy_1e-8");
    let readme = text("README.md");
    for (row, expected) in [
        ("| a pendulum, per force evaluation |", [step[0], step[3]]),
        ("| an ensemble of pendulums |", [ensemble[0] / 1e9, ensemble[2]]),
        ("| a chain of 10⁷ sites |", [chain[0] / 1e9, chain[0] / chain[1]]),
        ("| the outer solar system, to an energy error of 10⁻⁸ |", [solar[0], solar[1]]),
    ] {
        let quoted = row_of(&readme, row);
        // Two digits are off by half a unit of the second, a twentieth of the number at most.
        let near = |(quoted, expected): (&f64, f64)| (quoted / expected - 1.0).abs() <= 0.05;
        assert!(quoted.iter().zip(expected).all(near), "{row} {quoted:?} for {expected:?}");
        assert_eq!(quoted.len(), 2, "{row} {quoted:?}");
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

/// The names of the tests of a manifest that want the feature `long`.
fn long_tests(manifest: &str) -> Vec<String> {
    let manifest: toml::Table = text(manifest).parse().expect("a manifest");
    let tests = manifest["test"].as_array().expect("tests");
    let long = tests.iter().filter(|test| test.get("required-features").is_some());
    long.map(|test| test["name"].as_str().expect("a name").to_owned()).collect()
}

/// What the command of the README leaves out is run for every change.
#[test]
fn the_tests_that_take_longest_are_run_as_well() {
    let mut expected =
        [long_tests("Cargo.toml"), long_tests("tests/long/Cargo.toml"), ["cli", "corpus"].map(str::to_owned).to_vec()]
            .concat();
    expected.sort();
    let script = text(".ci/run");
    let named = script.split_once("long=(").and_then(|(_, rest)| rest.split_once(')')).expect("the list").0;
    assert_eq!(named.split_whitespace().collect::<Vec<_>>(), expected);
    assert!(script.contains("\"${long[@]/#/--test=}\""), "the list is run");
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

/// Links to files and to headings of them, of all documents.
#[test]
fn every_link_leads_somewhere() {
    let mut local = 0;
    for page in pages() {
        let shown = page.display();
        let folder = page.parent().expect("a folder");
        let page_text = text(&page);
        let links = prose(&page_text).flat_map(|line| line.split("](").skip(1));
        for link in links.filter_map(|rest| rest.split(')').next()).filter(|link| !link.starts_with("http")) {
            let (file, heading) = link.split_once('#').unwrap_or((link, ""));
            let target = if file.is_empty() { page.clone() } else { folder.join(file) };
            assert!(root().join(&target).exists(), "{shown} links to {link}");
            let headed = || prose(&text(&target)).any(|line| line.starts_with('#') && anchor(line) == heading);
            assert!(heading.is_empty() || headed(), "{shown} links to {link}, and there is no such heading");
            local += 1;
        }
    }
    assert!(local > 50, "the links are found: {local}");
}

/// Every page with programs is among the documentation tests of a library: of `integrator-core`, or of `integrator-plot` where
/// they draw. Those of the guide are held to their list in `integrator-cli/tests/guide.rs`.
#[test]
fn every_program_of_a_page_is_run() {
    let libraries = ["integrator-core", "integrator-plot"].map(|folder| text(format!("{folder}/src/lib.rs")));
    for page in ["", "docs"].map(pages_in).concat() {
        if text(&page).contains("\nuse integrator_core::") {
            let included = format!("include_str!(\"../../{}\")", page.display());
            assert!(libraries.iter().any(|library| library.contains(&included)), "no library has {included}");
        }
    }
}
