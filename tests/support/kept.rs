//! Stored text that a test generates again; included by its path.

use std::{env, fs, path::Path};

/// Compares a text with the content of a file, or writes the file if `.ci/bless` runs the test.
pub(crate) fn assert_kept(file: &Path, text: &str) {
    if env::var_os("BLESS").is_some() {
        return fs::write(file, text).expect("a file to write");
    }
    let kept = fs::read_to_string(file).unwrap_or_default();
    let same = kept.lines().zip(text.lines()).take_while(|(kept, new)| kept == new).count();
    let line = text.lines().nth(same).unwrap_or_default();
    let file = file.display();
    assert!(
        kept == text,
        "{file} is stale from line {} on, where it should be\n{line}\n`.ci/bless` writes it",
        same + 1
    );
}
