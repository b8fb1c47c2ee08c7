//! Rust files of the repository.

use std::{
    fs,
    path::{Path, PathBuf},
};

/// Returns the Rust files in a folder and in the folders in it, with their text.
pub(crate) fn sources(folder: &Path) -> Vec<(PathBuf, String)> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path()) {
        if entry.is_dir() {
            found.extend(sources(&entry));
        } else if entry.extension().is_some_and(|extension| extension == "rs") {
            let text = fs::read_to_string(&entry).expect("text");
            found.push((entry, text));
        }
    }
    found
}
