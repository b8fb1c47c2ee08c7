//! Every system of the corpus is exported as C without warnings, or refused with a place.

use super::compiler;
use crate::{Outcome, json, repository, run};
use std::{
    fs,
    path::{Path, PathBuf},
    process::Command,
};

#[test]
fn headers_of_the_corpus_compile() {
    let Some(compiler) = compiler() else { return };
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("export");
    fs::create_dir_all(&folder).expect("a folder");
    let source = folder.join("corpus.c");
    let (mut compiled, mut refused) = (0, 0);
    for path in fs::read_dir(repository().join("tests/long/tests/corpus")).expect("a folder") {
        let path = path.expect("an entry").path().to_str().expect("a path of text").to_owned();
        if !fs::read_to_string(&path).is_ok_and(|text| text.contains("#[hamiltonian")) {
            continue;
        }
        for system in json(&["show", &path])["systems"].as_array().expect("a list") {
            let system = system["system"].as_str().expect("a name").split([' ', '<']).next().unwrap_or_default();
            let Outcome { code, stdout, stderr } = run(&["export", "--c", &path, "--system", system]);
            if code == Some(0) {
                check(&compiler, &source, &stdout, &format!("{path}: {system}"));
                compiled += 1;
            } else {
                assert!(
                    code == Some(1) && stderr.starts_with("error: ") && stderr.contains(" --> "),
                    "{path}: {stderr}"
                );
                assert!(!stderr.contains("gpu") && !stderr.contains(" device"), "{path}: {stderr}");
                refused += 1;
            }
        }
    }
    assert!(compiled > 30 && refused > 10, "{compiled} and {refused}");
}

fn check(compiler: &str, source: &Path, header: &str, name: &str) {
    fs::write(source, format!("{header}\nint main(void) {{ return 0; }}\n")).expect("a file");
    let mut command = Command::new(compiler);
    let options = ["-Wall", "-Wextra", "-Werror", "-std=c99", "-pedantic", "-fsyntax-only"];
    let output = command.args(options).arg(source).output().expect("the compiler runs");
    assert!(output.status.success(), "{name}: {}", String::from_utf8_lossy(&output.stderr));
}
