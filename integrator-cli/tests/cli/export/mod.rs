//! Exported headers: programs that include them, and files that are refused. The feature `long` compares runs.

#[cfg(feature = "long")]
mod corpus;
#[cfg(feature = "long")]
mod functions;
mod guide;
mod refused;
#[cfg(feature = "long")]
mod states;
#[cfg(feature = "long")]
#[allow(dead_code, reason = "shared with the tests of device code, which use all of it")]
#[path = "../../../../tests/device_text/systems.rs"]
mod systems;

use crate::answer;
use std::{
    env, fs,
    path::{Path, PathBuf},
    process::Command,
};

const SYSTEMS: &str = "tests/device_text/systems.rs";

/// The C compiler of this machine.
fn compiler() -> Option<String> {
    let mut known = env::var("CC").ok().into_iter().chain(["cc", "gcc", "clang"].map(str::to_owned));
    let found =
        known.find(|name| Command::new(name).arg("--version").output().is_ok_and(|output| output.status.success()));
    if found.is_none() {
        eprintln!("SKIPPED: no C compiler is installed, so that headers were not compiled");
    }
    found
}

fn compiled(compiler: &str, options: &[&str], source: &Path, program: &Path) {
    let output = Command::new(compiler)
        .args(options)
        .arg(source)
        .arg("-o")
        .arg(program)
        .arg("-lm")
        .output()
        .expect("the compiler runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}

/// A header in C++, and two headers in one file.
#[test]
fn headers_are_cpp_as_well() {
    let found = ["c++", "g++", "clang++"].into_iter().find(|name| Command::new(name).arg("--version").output().is_ok());
    let Some(compiler) = found else {
        eprintln!("SKIPPED: no C++ compiler is installed");
        return;
    };
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("export");
    fs::create_dir_all(&folder).expect("a folder");
    let header = |system: &str, name: &str| {
        let path = folder.join(name);
        let path = path.to_str().expect("text");
        assert_eq!(answer(&["export", "--c", SYSTEMS, "--system", system, "-o", path]), "");
        path.to_owned()
    };
    let [first, second] = [header("Pendulum", "pendulum.h"), header("Planets", "planets.h")];
    let source = folder.join("both.cpp");
    let main =
        format!("#include \"{first}\"\n#include \"{second}\"\n#include \"{first}\"\nint main() {{ return 0; }}\n");
    fs::write(&source, main).expect("a file");
    compiled(compiler, &["-Wall", "-Wextra", "-Werror", "-std=c++17", "-pedantic"], &source, &folder.join("both"));
}
