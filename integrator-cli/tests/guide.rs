//! What programs print in the guide is what they print, and the guide hangs together.
//!
//! A block below `<!-- output: show FILE.rs -->` is the answer of the program to these arguments; for the word `above`, to
//! a file with the last block of Rust. `.ci/bless guide` writes the blocks.

use std::{
    collections::BTreeSet,
    env, fs,
    path::{Path, PathBuf},
    process::Command,
};

#[path = "../../tests/support/kept.rs"]
mod kept;

use kept::assert_kept;

const MARK: &str = "<!-- output: ";

fn chapters() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/guide/src")
}

fn text(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The names of all chapters, without `.md`.
fn names() -> BTreeSet<String> {
    let files = fs::read_dir(chapters()).expect("the chapters").map(|entry| entry.expect("an entry").path());
    let name = |path: PathBuf| path.file_stem().expect("a name").to_string_lossy().into_owned();
    files.map(name).filter(|name| name != "SUMMARY").collect()
}

/// What the program prints, be it an answer or a message.
fn output(arguments: &str, above: &str) -> String {
    // Quoted arguments are one.
    let mut words = Vec::new();
    for (number, part) in arguments.split('"').enumerate() {
        match number % 2 {
            0 => words.extend(part.split_whitespace().map(str::to_owned)),
            _ => words.push(part.to_owned()),
        }
    }
    let mut folder = chapters().join("../../..");
    if let Some(word) = words.iter_mut().find(|word| *word == "above") {
        folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("guide");
        "src/main.rs".clone_into(word);
        fs::create_dir_all(folder.join("src")).expect("a folder");
        fs::write(folder.join("src/main.rs"), above).expect("a file");
    }
    let output = Command::new(env!("CARGO_BIN_EXE_integrator-cli")).args(words).current_dir(folder).output();
    let output = output.expect("the program runs");
    String::from_utf8([output.stdout, output.stderr].concat()).expect("text")
}

/// The answer without the list of the catalogue, which one chapter shows and no other has to.
fn shortened(output: &str) -> &str {
    output.split("\nThe catalogue,").next().unwrap_or(output)
}

/// A chapter with all outputs as they are today.
fn renewed(chapter: &str) -> String {
    let mut renewed = String::new();
    let (mut rust, mut within) = (String::new(), false);
    let mut lines = chapter.lines();
    while let Some(line) = lines.next() {
        renewed += &format!("{line}\n");
        match line {
            _ if line.starts_with("```rust") => (rust, within) = (String::new(), true),
            "```" => within = false,
            _ if within => rust += &format!("{line}\n"),
            _ => {}
        }
        let Some(arguments) = line.strip_prefix(MARK).and_then(|rest| rest.strip_suffix(" -->")) else { continue };
        let fence = lines.next().unwrap_or_default();
        assert!(fence.starts_with("```"), "a block follows: {line}");
        renewed += &format!("{fence}\n");
        for old in lines.by_ref().take_while(|line| *line != "```") {
            // What makes a block compile is not shown, and stays.
            if old.starts_with("# ") {
                renewed += &format!("{old}\n");
            }
        }
        let output = output(arguments, &rust);
        let output = if arguments == "show examples/pendulum.rs" { &output } else { shortened(&output) };
        renewed += &format!("{}\n```\n", output.trim_end());
    }
    renewed
}

#[test]
fn outputs_in_the_guide_match_the_printed_ones() {
    let mut outputs = 0;
    for name in names() {
        let path = chapters().join(name).with_extension("md");
        let chapter = text(&path);
        outputs += chapter.matches(MARK).count();
        assert_kept(&path, &renewed(&chapter));
    }
    assert!(outputs > 10, "{outputs}");
}

#[test]
fn every_chapter_is_listed_and_tested() {
    let summary = text(&chapters().join("SUMMARY.md"));
    let listed = summary.split("](").skip(1).filter_map(|rest| rest.split(".md)").next());
    assert_eq!(listed.map(str::to_owned).collect::<BTreeSet<_>>(), names());
    let tests = text(&chapters().join("../../../integrator-core/src/guide.rs"));
    let tested = tests.split("chapters!(").skip(1).filter_map(|rest| rest.split(')').next());
    let mut tested: BTreeSet<String> = tested.flat_map(str::split_whitespace).map(str::to_owned).collect();
    // Chapters that draw or use textbook methods are tested where these are.
    for name in ["plot", "reference"] {
        let extra = text(&chapters().join(format!("../../../extras/integrator-{name}/src/lib.rs")));
        tested.extend(
            extra.split("docs/guide/src/").skip(1).filter_map(|rest| rest.split(".md").next()).map(str::to_owned),
        );
    }
    assert_eq!(tested, names());
}

#[test]
fn every_link_leads_somewhere() {
    for name in names() {
        let chapter = text(&chapters().join(&name).with_extension("md"));
        for link in chapter.split("](").skip(1).filter_map(|rest| rest.split([')', '#']).next()) {
            let local = !link.starts_with("http") && !link.is_empty();
            assert!(!local || chapters().join(link).exists(), "{name} links to {link}");
        }
    }
}
