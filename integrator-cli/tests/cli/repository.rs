//! Every annotated file of the repository has an answer.

use crate::{Outcome, repository, run};
use std::{fs, path::Path, thread};

/// Annotated files of the repository, those with mistakes on purpose too; its folders side by side.
#[test]
fn the_files_of_the_repository_are_shown_or_refused() {
    let folders = ["examples", "tests/long/tests/corpus", "tests/hygiene", "tests/language", "tests/ui/cases"];
    thread::scope(|scope| {
        for folder in folders {
            scope.spawn(move || {
                let mut found = Vec::new();
                annotated(&repository().join(folder), &mut found);
                assert!(found.len() > 1, "{folder}: {}", found.len());
                for path in found {
                    let Outcome { code, stderr, .. } = run(&["show", &path]);
                    assert!(matches!(code, Some(0 | 1)), "{path}: {code:?} {stderr}");
                    assert_eq!(code == Some(1), stderr.starts_with("error: "), "{path}: {stderr}");
                }
            });
        }
    });
}

fn annotated(folder: &Path, found: &mut Vec<String>) {
    for path in fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path()) {
        if path.is_dir() {
            annotated(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "rs")
            && fs::read_to_string(&path).expect("text").contains("#[hamiltonian")
        {
            found.push(path.to_str().expect("a path of text").to_owned());
        }
    }
}
