//! What the crates are built from and with, and what is published: licences, sources, the oldest compiler, packages.

use serde_json::Value;
use std::{fs, path::Path, process::Command};

fn text(path: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(path);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The crates that others depend on.
const PUBLISHED: [&str; 3] = ["integrator-core", "integrator-macros", "integrator-symbolic"];

/// The licences that `deny.toml` allows.
fn allowed() -> Vec<String> {
    let page = text("deny.toml");
    let list = page.split_once("allow = [").and_then(|(_, rest)| rest.split_once(']')).expect("the list").0;
    list.split('"').skip(1).step_by(2).map(str::to_owned).collect()
}

/// Whether a licence expression leaves a choice that is allowed: terms joined by `AND`, each a choice by `OR`, or by
/// `/` as it used to be written.
fn is_allowed(expression: &str, allowed: &[String]) -> bool {
    let one_of = |choice: &str| allowed.iter().any(|allowed| allowed == choice.trim());
    expression.split(" AND ").all(|term| {
        let term = term.trim_matches(['(', ')']);
        term.split(" OR ").flat_map(|choice| choice.split('/')).any(one_of)
    })
}

/// What a command of cargo prints.
fn cargo(arguments: &[&str]) -> String {
    let output = Command::new(env!("CARGO"))
        .args(arguments)
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .expect("cargo runs");
    assert!(output.status.success(), "cargo {arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("text")
}

/// The packages that `cargo metadata` lists of the workspace and of the extras.
fn packages(options: &[&str]) -> [Vec<Value>; 2] {
    ["Cargo.toml", "extras/Cargo.toml"].map(|manifest| {
        let arguments = ["metadata", "--format-version", "1", "--locked", "--manifest-path", manifest];
        let metadata: Value = serde_json::from_str(&cargo(&[&arguments, options].concat())).expect("JSON");
        metadata["packages"].as_array().expect("a list").clone()
    })
}

#[test]
fn expressions_are_read() {
    let allowed = allowed();
    for fine in ["MIT", "MIT/Apache-2.0", "GPL-3.0 OR MIT", "(MIT OR Apache-2.0) AND Unicode-3.0"] {
        assert!(is_allowed(fine, &allowed), "{fine}");
    }
    for wrong in ["", "GPL-3.0", "MIT AND GPL-3.0", "(MIT OR Apache-2.0) AND NCSA", "MITNFA"] {
        assert!(!is_allowed(wrong, &allowed), "{wrong}");
    }
}

#[test]
fn every_package_has_an_allowed_licence_and_comes_from_the_registry() {
    let allowed = allowed();
    // Most of what this machine needs was fetched to build this test.
    let compiler = Command::new("rustc").arg("-vV").output().expect("rustc runs").stdout;
    let compiler = String::from_utf8_lossy(&compiler).into_owned();
    let host = compiler.lines().find_map(|line| line.strip_prefix("host: ")).expect("the host");
    let packages = packages(&["--filter-platform", host]);
    assert!(packages.iter().all(|packages| packages.len() > 20), "dependencies are listed");
    for package in packages.iter().flatten() {
        let (name, licence) = (&package["name"], package["license"].as_str().unwrap_or_default());
        assert!(is_allowed(licence, &allowed), "{name} has the licence {licence:?}");
        let source = package["source"].as_str();
        let fine = source.is_none_or(|source| source == "registry+https://github.com/rust-lang/crates.io-index");
        assert!(fine, "{name} comes from {source:?}");
    }
}

/// The README names the oldest compiler, which is not newer than the compiler that runs the tests.
#[test]
fn the_readme_names_the_oldest_compiler() {
    let (manifest, toolchain, readme) = (text("Cargo.toml"), text("rust-toolchain.toml"), text("README.md"));
    let quoted = |page: &str, key: &str| {
        let rest = page.split_once(key).unwrap_or_else(|| panic!("no {key}")).1;
        rest.split('"').nth(1).expect("a value").to_owned()
    };
    let oldest = quoted(&manifest, "\nrust-version");
    let numbers =
        |version: &str| -> Vec<u32> { version.split('.').map(|part| part.parse().expect("a number")).collect() };
    assert!(numbers(&oldest) <= numbers(&quoted(&toolchain, "channel")));
    assert!(readme.contains(&format!("Rust {oldest} or newer")), "the README names the oldest compiler, {oldest}");
    for member in PUBLISHED {
        assert!(text(&format!("{member}/Cargo.toml")).contains("rust-version.workspace = true"), "{member}");
    }
}

/// The pages on docs.rs have the items of all features and name the feature of each item.
#[test]
fn the_documentation_of_published_crates_has_all_features() {
    for member in PUBLISHED {
        let manifest = text(&format!("{member}/Cargo.toml"));
        let expected = "\n[package.metadata.docs.rs]\nall-features = true\nrustdoc-args = [\"--cfg\", \"docsrs\"]\n";
        assert!(manifest.contains(expected), "{member}");
    }
}

/// A registry asks for a description and a licence, and readers find a crate by the rest. The limits are those of crates.io.
#[test]
fn published_crates_are_described() {
    let packages = packages(&["--no-deps"]).concat();
    let is_published = |package: &&Value| package["publish"].is_null();
    let mut published: Vec<&str> =
        packages.iter().filter(is_published).filter_map(|package| package["name"].as_str()).collect();
    published.sort_unstable();
    assert_eq!(published, PUBLISHED, "every other crate has `publish = false`");
    for package in packages.iter().filter(is_published) {
        let name = package["name"].as_str().expect("a name");
        for key in ["description", "license", "readme", "rust_version"] {
            assert!(package[key].as_str().is_some_and(|value| !value.is_empty()), "{name} has no {key}");
        }
        for key in ["keywords", "categories"] {
            let values = package[key].as_array().expect("a list");
            assert!((1..=5).contains(&values.len()), "{name} has {} {key}", values.len());
            let short = |value: &Value| value.as_str().is_some_and(|value| value.len() <= 20);
            assert!(key == "categories" || values.iter().all(short), "{name}: a keyword has 20 letters at most");
        }
        let about = text(&format!("{name}/README.md"));
        assert!(about.starts_with(&format!("# {name}\n")), "{name}/README.md begins with the name");
    }
}

/// A package has its sources, its README and its licences, and nothing that needs the rest of the repository.
#[test]
fn packages_contain_the_files_they_need() {
    let written = ["Cargo.toml", "Cargo.toml.orig", "Cargo.lock", ".cargo_vcs_info.json"];
    let added = ["README.md", "LICENSE-APACHE", "LICENSE-MIT"];
    for member in PUBLISHED {
        let list = cargo(&["package", "--list", "--allow-dirty", "--offline", "-p", member]);
        let files: Vec<&str> = list.lines().collect();
        for file in added.into_iter().chain(["src/lib.rs"]) {
            assert!(files.contains(&file), "the package of {member} lacks {file}");
        }
        for file in &files {
            let known = file.starts_with("src/") || added.contains(file) || written.contains(file);
            assert!(known, "the package of {member} has {file}");
        }
        for licence in ["LICENSE-APACHE", "LICENSE-MIT"] {
            assert_eq!(text(&format!("{member}/{licence}")), text(licence), "{member}/{licence}");
        }
    }
}
