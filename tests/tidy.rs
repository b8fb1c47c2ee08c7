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
