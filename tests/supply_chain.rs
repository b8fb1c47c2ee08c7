//! What the crates are built from and with: licences, sources, the oldest compiler.

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
    let output = Command::new(env!("CARGO"))
        .args(["metadata", "--format-version", "1", "--locked", "--filter-platform", host])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .expect("cargo runs");
    let metadata: serde_json::Value = serde_json::from_slice(&output.stdout)
        .unwrap_or_else(|error| panic!("{error}: {}", String::from_utf8_lossy(&output.stderr)));
    let packages = metadata["packages"].as_array().expect("a list");
    assert!(packages.len() > 20, "dependencies are listed");
    for package in packages {
        let (name, licence) = (&package["name"], package["license"].as_str().unwrap_or_default());
        assert!(is_allowed(licence, &allowed), "{name} has the licence {licence:?}");
        let source = package["source"].as_str();
        let fine = source.is_none_or(|source| source == "registry+https://github.com/rust-lang/crates.io-index");
        assert!(fine, "{name} comes from {source:?}");
    }
}

/// The oldest compiler is the one that everything is built and tested with, and the README tells it.
#[test]
fn the_oldest_compiler_is_the_one_in_use() {
    let (manifest, toolchain, readme) = (text("Cargo.toml"), text("rust-toolchain.toml"), text("README.md"));
    let quoted = |page: &str, key: &str| {
        let rest = page.split_once(key).unwrap_or_else(|| panic!("no {key}")).1;
        rest.split('"').nth(1).expect("a value").to_owned()
    };
    let oldest = quoted(&manifest, "\nrust-version");
    assert_eq!(quoted(&toolchain, "channel"), format!("{oldest}.0"));
    assert!(readme.contains(&format!("Rust {oldest} or newer")), "the README tells the oldest compiler, {oldest}");
    for member in PUBLISHED {
        assert!(text(&format!("{member}/Cargo.toml")).contains("rust-version.workspace = true"), "{member}");
    }
}

/// What users find on docs.rs shows what every feature brings.
#[test]
fn the_documentation_of_published_crates_has_all_features() {
    for member in PUBLISHED {
        let manifest = text(&format!("{member}/Cargo.toml"));
        assert!(manifest.contains("\n[package.metadata.docs.rs]\nall-features = true\n"), "{member}");
    }
}
