//! The programs of the guide's chapter on export, in C and in Fortran.

use super::{compiled, compiler};
use crate::{answer, repository};
use std::{fs, path::PathBuf, process::Command};

/// The blocks of a language.
fn blocks<'c>(chapter: &'c str, language: &str) -> Vec<&'c str> {
    let begin = format!("```{language}\n");
    chapter.split(&begin).skip(1).filter_map(|rest| rest.split("```").next()).collect()
}

fn printed(program: &str, folder: &PathBuf) -> String {
    let output = Command::new(folder.join(program)).current_dir(folder).output().expect("the program runs");
    String::from_utf8(output.stdout).expect("text")
}

#[test]
fn programs_print_what_the_guide_says() {
    let chapter = fs::read_to_string(repository().join("docs/guide/src/c_export.md")).expect("the chapter");
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("guide_in_c");
    fs::create_dir_all(&folder).expect("a folder");
    let path = |name: &str| folder.join(name).to_str().expect("text").to_owned();
    let rust = blocks(&chapter, "rust")[0].replace("\n# ", "\n");
    fs::write(path("main.rs"), rust).expect("a file");
    answer(&["export", "--c", &path("main.rs"), "-o", &path("pendulum.h")]);
    let [main, library] = blocks(&chapter, "c")[..] else { panic!("two programs") };
    for (name, text) in [("main.c", main), ("library.c", library), ("main.f90", blocks(&chapter, "fortran")[0])] {
        fs::write(path(name), text).expect("a file");
    }
    let Some(compiler) = compiler() else { return };
    let strict = ["-Wall", "-Wextra", "-Werror", "-std=c99", "-pedantic", "-O1"];
    compiled(&compiler, &strict, &folder.join("main.c"), &folder.join("main"));
    assert_eq!(printed("main", &folder), blocks(&chapter, "text")[0]);
    compiled(
        &compiler,
        &[&strict[..], &["-fPIC", "-shared"]].concat(),
        &folder.join("library.c"),
        &folder.join("libpendulum.so"),
    );
    if Command::new("gfortran").arg("--version").output().is_err() {
        eprintln!("SKIPPED: gfortran is not installed, so that the program in Fortran was not compiled");
        return;
    }
    let run_path = format!("-Wl,-rpath,{}", folder.display());
    let options = ["-Wall", "-L", folder.to_str().expect("text"), "-lpendulum", &run_path];
    let output = Command::new("gfortran")
        .arg(folder.join("main.f90"))
        .args(options)
        .arg("-o")
        .arg(folder.join("fortran"))
        .output();
    let output = output.expect("gfortran runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let of_c = printed("main", &folder);
    let of_fortran = printed("fortran", &folder);
    for number in of_fortran.split([' ', ',', '\n']).filter(|word| word.contains('.')) {
        assert!(of_c.contains(number.trim_start_matches('-').trim_start_matches('0')), "{of_fortran} and {of_c}");
    }
}
