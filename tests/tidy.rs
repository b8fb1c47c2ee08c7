//! Rules about the repository itself.

use std::{fs, path::Path};

fn rust_files(folder: &Path, found: &mut Vec<(String, String)>) {
    for entry in fs::read_dir(folder).expect("a readable folder").map(|entry| entry.expect("an entry").path()) {
        let name = entry.file_name().expect("a name").to_string_lossy().into_owned();
        if entry.is_dir() && name != "target" && !name.starts_with('.') {
            rust_files(&entry, found);
        } else if name.ends_with(".rs") && !name.ends_with(".expanded.rs") {
            found.push((entry.display().to_string(), fs::read_to_string(&entry).expect("text")));
        }
    }
}

fn repository() -> Vec<(String, String)> {
    let mut found = Vec::new();
    rust_files(Path::new(env!("CARGO_MANIFEST_DIR")), &mut found);
    assert!(found.len() > 5, "the walk must reach the crates");
    found
}

#[test]
fn no_test_is_ignored() {
    let marker = concat!("#[", "ignore");
    for (path, text) in repository() {
        assert!(!text.contains(marker), "{path} ignores a test");
    }
}

#[test]
fn every_allow_has_a_reason() {
    let marker = concat!("#[", "allow(");
    for (path, text) in repository() {
        for (number, line) in text.lines().enumerate().filter(|(_, line)| line.contains(marker)) {
            assert!(line.contains("reason"), "{path}:{}: an allow states its reason", number + 1);
        }
    }
}

/// Words that stood for what has a name in the field, and the names; ARCHITECTURE.md has the words that stay.
const RETIRED: [(&str, &str); 12] = [
    ("abreast", "in lanes, or a vector"),
    ("doorway", "the private API"),
    ("leap", "a correction of durations"),
    ("line of the cache", "a cache line"),
    ("no number, if", "NaN if"),
    ("private door", "the private API"),
    ("spoilt", "not finite"),
    ("turn by turn", "iteration by iteration"),
    ("turns of a loop", "the iterations of a loop"),
    ("twin", "a hand-written stepper"),
    ("twins", "hand-written steppers"),
    ("twofold", "double-double"),
];

/// Whether a text has a word as a whole, in any case.
fn has_word(text: &str, word: &str) -> bool {
    let text = text.to_lowercase();
    let is_inside = |other: Option<char>| other.is_some_and(char::is_alphanumeric);
    text.match_indices(word)
        .any(|(at, _)| !is_inside(text[..at].chars().next_back()) && !is_inside(text[at + word.len()..].chars().next()))
}

#[test]
fn retired_words_stay_retired() {
    let sources = repository().into_iter().filter(|(path, _)| path.contains("/src/"));
    for (path, text) in sources {
        for (number, line) in text.lines().enumerate() {
            if let Some((word, name)) = RETIRED.iter().find(|(word, _)| has_word(line, word)) {
                panic!("{path}:{}: say {name} instead of `{word}`", number + 1);
            }
        }
    }
    assert!(has_word("a Twin of it", "twin") && has_word("turn by turn", "turn by turn"));
    assert!(!has_word("leapfrog, Abreasted", "leap") && !has_word("twinned", "twin"));
}
