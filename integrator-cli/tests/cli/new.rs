//! Crates that `new` writes.

use crate::repository;
use std::{
    fs,
    path::{Path, PathBuf},
    process::Command,
};

/// An empty folder for a test.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder");
    folder
}

/// The exit code of `new` in a folder, and what it prints.
fn new(folder: &Path, arguments: &[&str]) -> (Option<i32>, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_integrator-cli"));
    let output = command.arg("new").args(arguments).current_dir(folder).output().expect("the program runs");
    (output.status.code(), String::from_utf8([output.stdout, output.stderr].concat()).expect("text"))
}

/// A clone as far as `new` sees one, which has a package for Python.
fn clone_with_python(folder: &Path) -> String {
    for package in ["integrator-core", "integrator-python"] {
        fs::create_dir_all(folder.join("clone").join(package)).expect("a folder");
        fs::write(folder.join("clone").join(package).join("Cargo.toml"), "").expect("a file");
    }
    folder.join("clone").to_str().expect("text").to_owned()
}

#[test]
fn a_crate_is_complete() {
    let folder = folder("new_crate");
    let (code, found) = new(&folder, &["two-wells"]);
    assert_eq!((code, &found[..24]), (Some(0), "created two-wells; next:"), "{found}");
    let text = |name: &str| fs::read_to_string(folder.join("two-wells").join(name)).expect("a file");
    let core = repository().join("integrator-core").canonicalize().expect("a folder");
    assert!(text("Cargo.toml").contains(&format!("integrator-core = {{ path = {:?} }}", core.display().to_string())));
    assert!(
        text("src/main.rs").contains("\nimpl TwoWells {\n") && text("src/main.rs").contains("fn steps_are_certified()")
    );
    assert!(text("README.md").starts_with("# two-wells\n") && text(".gitignore") == "/target\n");
    let (code, found) = new(&folder, &["two-wells"]);
    assert_eq!((code, found.lines().next()), (Some(1), Some("error: `two-wells` exists in this folder")));
    let (_, _) = new(&folder, &["remote", "--repository", "https://example.org/integrator"]);
    let manifest = fs::read_to_string(folder.join("remote/Cargo.toml")).expect("a file");
    assert!(manifest.contains("integrator-core = { git = \"https://example.org/integrator\" }"), "{manifest}");
}

#[test]
fn a_python_module_is_complete() {
    let folder = folder("new_module");
    let clone = clone_with_python(&folder);
    let (code, found) = new(&folder, &["my-galaxy", "--python", "--path", &clone]);
    assert!(code == Some(0) && found.contains("maturin develop --release"), "{found}");
    let text = |name: &str| fs::read_to_string(folder.join("my-galaxy").join(name)).expect("a file");
    let library = text("src/lib.rs");
    assert!(
        library.contains("    my_galaxy: MyGalaxy\n") && library.contains("#[derive(Clone, Deserialize, Serialize)]")
    );
    assert!(text("Cargo.toml").contains("\nname = \"my_galaxy\"\ncrate-type = [\"cdylib\"]\n"));
    assert!(text("pyproject.toml").contains("build-backend = \"maturin\""));
    for script in ["example.py", "test_my_galaxy.py"] {
        assert!(
            text(script).contains("import my_galaxy\n") && text(script).contains("my_galaxy.MyGalaxy("),
            "{script}"
        );
    }
    // No placeholder is left.
    for file in ["Cargo.toml", "README.md", "pyproject.toml", "src/lib.rs", "example.py", "test_my_galaxy.py"] {
        let text = text(file);
        assert!(
            !["CRATE", "MODULE", "TYPE", "CORE", "SYSTEM", "DERIVED"].iter().any(|word| text.contains(word)),
            "{file}: {text}"
        );
    }
}

#[test]
fn names_are_checked() {
    let folder = folder("new_names");
    let cases = [
        (&["2wells"][..], "my_2wells"),
        (&["a b"], "a_b"),
        (&["fn"], "my_fn"),
        (&["test"], "my_test"),
        (&["Größe"], "gr__e"),
        (&["../x"], "x"),
        (&["import", "--python"], "my_import"),
    ];
    for (arguments, instead) in cases {
        let (code, found) = new(&folder, arguments);
        let name = arguments[0];
        let expected = format!(
            "error: `{name}` is not a name for a crate\nhelp: letters, digits, `-` and `_` are allowed, for example `{instead}`\n"
        );
        assert_eq!((code, found), (Some(1), expected));
    }
    // A type of the prelude stays what it is.
    new(&folder, &["phase"]);
    let main = fs::read_to_string(folder.join("phase/src/main.rs")).expect("a file");
    assert!(main.contains("struct PhaseSystem {") && main.contains("Phase::new("), "{main}");
    let (code, found) = new(&folder, &["lost", "--path", "nowhere"]);
    assert_eq!((code, found.lines().next()), (Some(1), Some("error: `nowhere` has no `integrator-core`")));
    assert!(!folder.join("lost").exists(), "nothing is written");
}

/// A crate compiles, runs, and its test passes.
#[cfg(feature = "long")]
#[test]
fn a_crate_certifies_its_steps() {
    let folder = folder("new_long");
    new(&folder, &["phase"]);
    let path = folder.join("phase");
    // The versions that are downloaded.
    fs::copy(repository().join("Cargo.lock"), path.join("Cargo.lock")).expect("a file");
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).join("target_of_new");
    for (arguments, expected) in [("test", "test tests::steps_are_certified ... ok"), ("run", "change of the energy: ")]
    {
        let mut cargo = Command::new(env!("CARGO"));
        let output = cargo
            .arg(arguments)
            .arg("--offline")
            .current_dir(&path)
            .env("CARGO_TARGET_DIR", &target)
            .output()
            .expect("cargo");
        let text = String::from_utf8_lossy(&[output.stdout, output.stderr].concat()).into_owned();
        assert!(output.status.success() && text.contains(expected) && !text.contains("warning"), "{text}");
    }
}
