//! The program as one runs it: what it prints, where, and with which exit code.

mod elements;
mod export;
mod inputs;
mod new;
mod prove;
#[cfg(feature = "long")]
mod repository;
mod show;

use std::{
    fs,
    path::{Path, PathBuf},
    process::Command,
};

/// What a run of the program left behind.
pub(crate) struct Outcome {
    pub(crate) code: Option<i32>,
    pub(crate) stdout: String,
    pub(crate) stderr: String,
}

pub(crate) fn run(arguments: &[&str]) -> Outcome {
    let output = Command::new(env!("CARGO_BIN_EXE_integrator-cli"))
        .args(arguments)
        .current_dir(repository())
        .output()
        .expect("the program runs");
    let [stdout, stderr] = [output.stdout, output.stderr].map(|bytes| String::from_utf8(bytes).expect("text"));
    Outcome { code: output.status.code(), stdout, stderr }
}

/// The answer of a run in which all is well.
pub(crate) fn answer(arguments: &[&str]) -> String {
    let Outcome { code, stdout, stderr } = run(arguments);
    assert_eq!((code, stderr.as_str()), (Some(0), ""), "{arguments:?}");
    stdout
}

/// The answer of a run in which all is well, as JSON.
pub(crate) fn json(arguments: &[&str]) -> serde_json::Value {
    serde_json::from_str(&answer(&[arguments, &["--json"]].concat())).expect("JSON")
}

/// What is said about a wrong input.
pub(crate) fn refusal(arguments: &[&str]) -> String {
    let Outcome { code, stdout, stderr } = run(arguments);
    assert_eq!((code, stdout.as_str()), (Some(1), ""), "{arguments:?}: {stderr}");
    assert!(stderr.starts_with("error: "), "{arguments:?}: {stderr}");
    stderr
}

/// A file that exists for a test.
pub(crate) fn file(name: &str, content: impl AsRef<[u8]>) -> String {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    fs::write(&path, content).expect("a file to write");
    path.to_str().expect("a path of text").to_owned()
}

pub(crate) fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The keys of an object, which are documented in `--help`.
pub(crate) fn keys(value: &serde_json::Value) -> Vec<&str> {
    value.as_object().expect("an object").keys().map(String::as_str).collect()
}

#[test]
fn a_wrong_command_is_usage() {
    for arguments in [
        &[][..],
        &["show"],
        &["shew", "x.rs"],
        &["show", "a.rs", "b.rs"],
        &["prove"],
        &["prove", "Verlet", "--order", "four"],
        &["prove", "Verlet", "--order", "-1"],
        &["prove", "Verlet", "--order", "0"],
        &["show", ""],
        &["expand", "--yaml", "x.rs"],
        &["elements"],
        &["elements", "x.csv", "--frame", "galactic"],
    ] {
        let Outcome { code, stdout, stderr } = run(arguments);
        assert_eq!((code, stdout.as_str()), (Some(2), ""), "{arguments:?}");
        assert!(stderr.contains("--help"), "{arguments:?}: {stderr}");
    }
}

/// Every key is documented where one looks for it.
#[test]
fn help_names_the_keys() {
    let pendulum = "examples/pendulum.rs";
    let show = json(&["show", pendulum]);
    let system = &show["systems"][0];
    let place = &system["kick"]["places"][0];
    let objects = [&show, system, &system["drift"], place, &system["operations"], &system["admissible"][0]];
    documented("show", &objects);
    let expand = json(&["expand", pendulum]);
    documented("expand", &[&expand, &expand["systems"][0]]);
    let bodies = file("for_help.csv", "mass,x,y,vx,vy\n1,0,0,0,0\n1,1,0,0,1\n");
    let elements = json(&["elements", &bodies]);
    documented("elements", &[&elements, &elements["rows"][1]]);
    let prove = json(&["prove", "Euler"]);
    documented("prove", &[&prove, &prove["stages"][0], &prove["error_terms"][0], &prove["violation"]]);
}

fn documented(task: &str, objects: &[&serde_json::Value]) {
    let help = answer(&[task, "--help"]);
    let (_, list) = help.split_once("Keys of --json:").expect("the keys");
    let words: Vec<&str> = list.split(|c: char| !c.is_alphanumeric() && c != '_').collect();
    for key in objects.iter().flat_map(|object| keys(object)) {
        assert!(words.contains(&key), "`{task} --help` leaves out {key}");
    }
}
