//! The documents say what is true: the commands are what is run, lists are complete, links lead somewhere.

#[path = "support/figures.rs"]
mod figures;
#[path = "support/kept.rs"]
mod kept;
#[path = "support/sources.rs"]
mod sources;

use kept::assert_kept;
use sources::sources;
use std::{
    fs,
    path::{Path, PathBuf},
};

/// The folders of the crates.
const CRATES: [&str; 10] = [
    "extras/integrator-laboratory",
    "extras/integrator-plot",
    "extras/integrator-reference",
    "integrator-cli",
    "integrator-core",
    "integrator-gpu",
    "integrator-macros",
    "integrator-mpi",
    "integrator-python",
    "integrator-symbolic",
];

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
    let folders = ["", "docs", "docs/contributing", "docs/guide/src"].map(str::to_owned).to_vec();
    let folders = folders.into_iter().chain(CRATES.map(str::to_owned));
    let pages: Vec<PathBuf> = folders.flat_map(|folder| pages_in(&folder)).collect();
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

/// Pages that a visitor reads first are short; details are in `docs`.
#[test]
fn the_first_pages_are_short() {
    for (page, kilobytes) in [("README.md", 6), ("CHANGELOG.md", 6), ("ARCHITECTURE.md", 12)] {
        let length = text(page).len();
        assert!(length <= kilobytes * 1024, "{page} has {length} bytes");
    }
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
    assert!(text("paper.md").contains(&format!("{count} methods of orders 1 to 10 ")), "there are {count}");
}

/// Each feature that the comparison claims has a test or an example; that links lead somewhere is another test.
#[test]
fn every_feature_of_the_comparison_is_shown() {
    let page = text("docs/comparison.md");
    let (_, rows) = page.split_once("\n| feature | shown by |\n|---|---|\n").expect("the table");
    let rows: Vec<&str> = rows.lines().take_while(|line| line.starts_with('|')).collect();
    assert!(rows.len() > 10, "{rows:?}");
    for row in rows {
        let shown = row.split("](../").skip(1);
        let is_shown =
            |path: &str| path.starts_with("examples/") || path.split(')').next().unwrap_or("").contains("tests/");
        assert!(shown.map(is_shown).reduce(|all, one| all && one) == Some(true), "{row}");
    }
}

/// The numbers in front of a word of a page, such as 24 in `24 methods`.
fn counts(page: &str, word: &str) -> Vec<usize> {
    let page = page.split_whitespace().collect::<Vec<_>>().join(" ");
    let word = format!(" {word}");
    let before = page.match_indices(&word).map(|(place, _)| &page[..place]);
    before.filter_map(|text| text.rsplit([' ', '[']).next()?.parse().ok()).collect()
}

#[test]
fn pages_count_the_methods_of_the_laboratory() {
    let source = text("extras/integrator-laboratory/src/rows.rs");
    let table = source.split_once("\nrows! {").and_then(|(_, rest)| rest.split_once("\n}")).expect("the table").0;
    let row = |line: &&str| line.starts_with("    ") && line[4..].starts_with(|first: char| first.is_ascii_uppercase());
    let count = table.lines().filter(row).count();
    for page in ["README.md", "docs/examples.md", "docs/guide/src/reference_methods.md"] {
        let found = counts(&text(page), "methods");
        assert!(
            found.contains(&count) && found.iter().all(|number| *number == count),
            "{page}: {found:?}, not {count}"
        );
    }
}

/// The cookbook lists every Hamiltonian of `examples/cookbook`, in the words of its source.
#[test]
fn the_cookbook_is_complete() {
    let page = text("docs/guide/src/cookbook.md");
    let mut rows = 0;
    for section in page.split("\n## [").skip(1) {
        let file = section.split_once("](../../../").and_then(|(_, rest)| rest.split_once(')')).expect("a file").0;
        let source = text(file);
        for row in section.lines().filter_map(|line| line.strip_prefix("| `")) {
            let (name, rest) = row.split_once("` | ").expect("a name");
            let described = rest.split(" | ").next().expect("a description");
            let (before, _) = source.split_once(&format!("struct {name} ")).unwrap_or_else(|| {
                source.split_once(&format!("struct {name};")).unwrap_or_else(|| panic!("{file} has no `{name}`"))
            });
            let comment = before.lines().rev().skip(1).skip_while(|line| line.starts_with('#'));
            let mut comment: Vec<_> = comment.map_while(|line| line.strip_prefix("/// ")).collect();
            comment.reverse();
            assert_eq!(comment.join(" "), without_links(described), "{file}: `{name}`");
            rows += 1;
        }
    }
    let folder = fs::read_dir(root().join("examples/cookbook")).expect("the cookbook");
    let sources = folder.map(|file| text(file.expect("a file").path()));
    let count: usize = sources.map(|source| source.matches("\n#[hamiltonian").count()).sum();
    assert_eq!((rows, counts(&page, "Hamiltonians")), (count, vec![count]));
}

/// A text whose links are replaced by their words.
fn without_links(text: &str) -> String {
    let mut parts = text.split("](");
    let first = parts.next().unwrap_or_default().to_owned();
    let text = parts.fold(first, |text, part| text + part.split_once(')').map_or(part, |(_, rest)| rest));
    text.replace('[', "")
}

#[test]
fn every_example_is_listed() {
    let manifest: toml::Table = text("examples/Cargo.toml").parse().expect("a manifest");
    let page = text("docs/examples.md");
    for example in manifest["example"].as_array().expect("examples") {
        let name = example["name"].as_str().expect("a name");
        let listed = page.contains(&format!("\n| `{name}` |")) || page.contains(&format!("--example {name} "));
        assert!(listed, "docs/examples.md leaves out `{name}`");
    }
}

/// The README says how to depend on the crates; other pages have such a line by path at most, so that no release makes them wrong.
#[test]
fn the_readme_alone_says_how_to_depend() {
    let mut found = 0;
    for page in pages() {
        let (shown, text) = (page.display(), text(&page));
        for line in text.lines().map(|line| line.trim_start_matches(['#', ' '])) {
            let Some((name, value)) = line.split_once(" = ").filter(|(name, _)| name.starts_with("integrator-")) else {
                continue;
            };
            let paths = ["", "extras/"].map(|folder| format!("{{ path = \"../integrator/{folder}{name}\""));
            assert!(paths.iter().any(|path| value.starts_with(path)), "{shown}: {line}");
            found += 1;
        }
        assert!(
            page == Path::new("README.md") || !text.contains("--git"),
            "{shown}: link to the README in place of this"
        );
    }
    assert!(found > 0 && text("README.md").contains("--git"));
}

/// The test command of the README is the one that is run for every change.
#[test]
fn the_test_command_is_the_one_that_is_run() {
    let command = "cargo test --workspace";
    let is_line = |text: String| text.lines().any(|line| line == command);
    assert!(is_line(text("README.md")), "the README has `{command}`");
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
    let manifests = ["Cargo.toml", "benches/Cargo.toml", "tests/long/Cargo.toml"];
    let mut expected = [manifests.map(long_tests).concat(), ["cli", "corpus"].map(str::to_owned).to_vec()].concat();
    expected.sort();
    let script = text(".ci/run");
    let named = script.split_once("long=(").and_then(|(_, rest)| rest.split_once(')')).expect("the list").0;
    assert_eq!(named.split_whitespace().collect::<Vec<_>>(), expected);
    assert!(script.contains("\"${long[@]/#/--test=}\""), "the list is run");
}

#[test]
fn the_public_ci_runs_the_commands_of_the_readme() {
    let (workflow, readme) = (text(".github/workflows/ci.yml"), text("README.md"));
    let commands: Vec<&str> = workflow.lines().filter_map(|line| line.trim_start().strip_prefix("- run: ")).collect();
    assert!(commands.contains(&".ci/run"), "{commands:?}");
    for command in commands.iter().filter(|command| command.starts_with("cargo ")) {
        assert!(readme.lines().any(|line| line == *command), "the README has no `{command}`");
    }
    assert_eq!(commands.iter().filter(|command| command.starts_with("cargo ")).count(), 2);
}

/// Manifest, changelog and citation name the same release, and published crates can be found and read.
#[test]
fn the_release_is_named_alike_everywhere() {
    let table = |path: &str| text(path).parse::<toml::Table>().expect("a manifest");
    let manifest = table("Cargo.toml");
    let version = manifest["workspace"]["package"]["version"].as_str().expect("a version").to_owned();
    let changelog = text("CHANGELOG.md");
    let release = changelog.lines().find_map(|line| line.strip_prefix("## [").filter(|line| line.contains("] - ")));
    let (released, date) = release.and_then(|line| line.split_once("] - ")).expect("a release with a date");
    assert_eq!(released, version);
    let citation = text("CITATION.cff");
    for line in [format!("version: {version}"), format!("date-released: {date}")] {
        assert!(citation.lines().any(|known| known == line), "CITATION.cff has no `{line}`");
    }
    for name in ["integrator-core", "integrator-macros", "integrator-symbolic"] {
        let package = &table(&format!("{name}/Cargo.toml"))["package"];
        let described = [package["description"].to_string(), package["keywords"].to_string()].concat().to_lowercase();
        for word in ["symplectic", "hamiltonian", "integrator", "splitting"] {
            assert!(described.contains(word), "{name} is not found by `{word}`: {described}");
        }
        let dependency = &manifest["workspace"]["dependencies"][name];
        assert_eq!(dependency["version"].as_str(), Some(&version[..]), "{name}");
    }
}

#[test]
fn the_first_command_names_an_example() {
    assert!(text("README.md").contains("\ncargo run --release --example outer_solar_system\n"));
    assert!(text("examples/outer_solar_system/main.rs").contains("fn main"));
}

/// The documentation of the macro and that of the language list every function that can be differentiated.
#[test]
fn every_elementary_function_is_documented() {
    let names: Vec<String> =
        integrator_symbolic::known_functions().chain(["%"]).map(|name| format!("`{name}`")).collect();
    let lines: Vec<String> = names.chunks(10).map(|names| names.join(", ")).collect();
    for (page, before, after) in [
        ("integrator-macros/src/hamiltonian.md", "as `f64::sin(x)`:\n  ", ".\n- Helper methods"),
        (
            "docs/language.md",
            "**Methods of `f64`** and operators with a derivative are\n",
            ".\n\n**Rounding functions**",
        ),
    ] {
        let old = text(page);
        let (start, rest) = old.split_once(before).expect("the list of functions");
        let (_, end) = rest.split_once(after).expect("its end");
        let indent = &before[before.rfind('\n').expect("a new line")..];
        assert_kept(&root().join(page), &format!("{start}{before}{}{after}{end}", lines.join(&format!(",{indent}"))));
    }
}

/// Words that the field does not use in this sense, and what it writes.
const NOT_OF_THE_FIELD: [(&str, &str); 20] = [
    ("anew", "again"),
    ("asked for", "requested"),
    ("asks for", "requires"),
    ("carries on", "continues, or integrates"),
    ("carry on", "continue, or integrate"),
    ("further on", "ahead"),
    ("goes on", "continues"),
    ("held against", "compared with"),
    ("leaves the numbers", "diverges"),
    ("looks at", "reads"),
    ("not met", "a ratio"),
    ("side by side", "in lanes, or concurrently"),
    ("so many", "this number of"),
    ("tells of", "reports"),
    ("the finite numbers", "diverges, or is not finite"),
    ("time of its own", "a fictitious time"),
    ("times of their own", "a fictitious time"),
    ("told of", "reported"),
    ("under way", "in progress, or current"),
    ("whoever", "a subject"),
];

/// Words that doc comments and messages of the crates still have, and how often at most. No number here grows.
const STILL_THERE: [(&str, usize); 1] = [("of which", 60)];

/// Whether a text in small letters has a phrase, as whole words.
fn has(text: &str, phrase: &str) -> bool {
    count(text, phrase) > 0
}

/// How often a text in small letters has a phrase, as whole words.
fn count(text: &str, phrase: &str) -> usize {
    let is_letter = |other: Option<char>| other.is_some_and(char::is_alphanumeric);
    let is_whole =
        |at: usize| !is_letter(text[..at].chars().next_back()) && !is_letter(text[at + phrase.len()..].chars().next());
    text.match_indices(phrase).filter(|(at, _)| is_whole(*at)).count()
}

#[test]
fn pages_use_the_words_of_the_field() {
    for page in pages() {
        let text = text(&page);
        let prose = prose(&text).collect::<Vec<_>>().join(" ").to_lowercase();
        if let Some((word, instead)) = NOT_OF_THE_FIELD.iter().find(|(word, _)| has(&prose, word)) {
            panic!("{}: write {instead} in place of `{word}`", page.display());
        }
    }
}

/// The doc comments and the texts in quotation marks of a source, in small letters and with single spaces.
fn shown(source: &str) -> String {
    let (mut shown, mut quoted) = (String::new(), false);
    for line in source.lines().map(str::trim) {
        let comment = (!quoted).then(|| line.strip_prefix("//")).flatten();
        if let Some(comment) = comment {
            let doc = comment.strip_prefix(['/', '!']).unwrap_or_default();
            shown += doc.trim();
            shown.push(' ');
            continue;
        }
        let line = line.replace("\\\\", "").replace("\\\"", "").replace("'\"'", "");
        for (number, piece) in line.split('"').enumerate() {
            quoted ^= number > 0;
            if quoted {
                shown += piece.trim_end_matches('\\').trim_start();
            }
        }
        shown.push(' ');
    }
    shown.to_lowercase().split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn messages_and_doc_comments_use_the_words_of_the_field() {
    let is_test = |path: &Path| path.iter().any(|part| Path::new(part).file_stem().is_some_and(|stem| stem == "tests"));
    let mut texts: Vec<(PathBuf, String)> = Vec::new();
    for name in CRATES {
        let folder = root().join(name).join("src");
        let own = sources(&folder).into_iter().filter(|(path, _)| !path.strip_prefix(&folder).is_ok_and(is_test));
        texts.extend(own.map(|(path, text)| (path, shown(&text))));
    }
    assert!(texts.len() > 300, "the sources are found: {}", texts.len());
    for (path, text) in &texts {
        if let Some((word, instead)) = NOT_OF_THE_FIELD.iter().find(|(word, _)| has(text, word)) {
            panic!("{}: write {instead} in place of `{word}`", path.display());
        }
    }
    for (word, most) in STILL_THERE {
        let found: usize = texts.iter().map(|(_, text)| count(text, word)).sum();
        assert!(
            found <= most,
            "`{word}` is written {found} times: write it in plain words, as the other {most} will be"
        );
    }
}

/// The check finds a word in a doc comment and in a message over several lines, and none in code or other comments.
#[test]
fn words_are_found_where_they_are_shown() {
    let found = |source: &str| NOT_OF_THE_FIELD.iter().filter(|(word, _)| has(&shown(source), word)).count();
    assert_eq!(found("/// A run that goes on.\nfn f() {}"), 1);
    assert_eq!(found("//! Members side\n//! by side.\n"), 1);
    assert_eq!(found("let x = 'a'; error(\"it \\\n    looks \\\n    at \\\"this\\\"\");"), 1);
    assert_eq!(found("// Whoever reads code.\nlet anew = told(of); // goes on\n"), 0);
    assert_eq!(found("let quote = '\"'; anew(); let text = \"whoever\";"), 1);
    assert_eq!(found("/// The lines of a manewver."), 0);
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

/// Each picture is on a page, and has the title that the code gives it.
#[test]
fn pictures_are_shown_and_have_the_titles_of_the_code() {
    let mut code = text("docs/guide/src/first_hamiltonian.md");
    for folder in ["benches", "examples", "integrator-gpu/tests", "extras/integrator-laboratory/src"] {
        code.extend(sources(&root().join(folder)).into_iter().map(|(_, text)| text));
    }
    let pages: String = pages().iter().map(text).collect();
    for entry in fs::read_dir(root().join("docs/pictures")).expect("pictures") {
        let path = entry.expect("an entry").path();
        let name = path.file_name().expect("a name").to_string_lossy();
        assert!(pages.contains(&format!("pictures/{name}")), "no page shows {name}");
        if path.extension().is_some_and(|extension| extension == "svg") {
            let svg = text(&path);
            let title = svg.lines().find(|line| line.contains("font-weight=\"bold\">")).expect("a title");
            let title = title.split_once("\">").and_then(|(_, rest)| rest.strip_suffix("</text>")).expect("a title");
            // The laboratory adds the name of the system.
            let general = title.rsplit_once(": ").map_or(String::new(), |(general, _)| format!("{general}: {{}}\""));
            let is_known = code.contains(title) || !general.is_empty() && code.contains(&general);
            assert!(is_known, "{name} is drawn again with another title than {title:?}");
        }
    }
}

/// Every page with programs is among the documentation tests of a library: of `integrator-core`, or of `integrator-plot` where
/// they draw. Those of the guide are held to their list in `integrator-cli/tests/guide.rs`.
#[test]
fn every_program_of_a_page_is_run() {
    let libraries = ["integrator-core", "extras/integrator-plot"].map(|folder| text(format!("{folder}/src/lib.rs")));
    for page in ["", "docs", "docs/contributing"].map(pages_in).concat() {
        if text(&page).contains("\nuse integrator_core::") {
            let included = format!("../{}\")", page.display());
            assert!(libraries.iter().any(|library| library.contains(&included)), "no library has {included}");
        }
    }
}
