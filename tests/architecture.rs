//! The invariants of ARCHITECTURE.md that can be read off the sources.

#[path = "support/sources.rs"]
mod sources;

use sources::sources;
use std::{
    fs,
    path::{Path, PathBuf},
};

/// What each module of a crate or of a folder may import from it.
type MayKnow = (&'static str, &'static [(&'static str, &'static [&'static str])]);

/// The modules of `integrator-symbolic`, in the order of the pipeline.
const SYMBOLIC: MayKnow = (
    "integrator-symbolic/src",
    &[
        ("errors", &[]),
        ("limits", &["errors"]),
        ("fragments", &[]),
        ("spelling", &[]),
        ("graph", &[]),
        ("differentiate", &["graph"]),
        ("stencil", &["differentiate", "graph"]),
        ("lower", &["graph"]),
        ("pairs", &["differentiate", "graph"]),
        ("program", &["differentiate", "graph"]),
        ("scheme", &["errors"]),
        ("taylor", &["differentiate", "graph"]),
        ("syntax", &["errors", "scheme"]),
        ("model", &["errors", "graph", "limits", "spelling", "syntax"]),
        ("pattern", &["differentiate", "graph", "lower", "model", "pairs", "program", "stencil"]),
        (
            "emit",
            &[
                "differentiate",
                "stencil",
                "graph",
                "lower",
                "model",
                "pairs",
                "pattern",
                "program",
                "scheme",
                "syntax",
                "taylor",
            ],
        ),
        ("report", &["differentiate", "emit", "errors", "graph", "lower", "model", "pattern", "syntax"]),
    ],
);

/// The folders of `emit`, from the ground up.
const EMIT: MayKnow = (
    "integrator-symbolic/src/emit",
    &[
        ("fingerprint", &[]),
        ("prose", &[]),
        ("printer", &[]),
        ("read_by_methods", &["printer"]),
        ("flow", &["printer", "prose", "read_by_methods"]),
        ("taylor", &["printer"]),
    ],
);

/// The folders of `integrator-core`, from the ground up. `hamiltonian` is the trait that generated code implements: it names what
/// is above it (a composition, a method, a run, the sites of a lattice), since these traits name each other.
const CORE: MayKnow = (
    "integrator-core/src",
    &[
        ("error", &[]),
        ("threads", &[]),
        ("scalar", &[]),
        ("state", &["error", "scalar"]),
        (
            "hamiltonian",
            &["composition", "error", "flow", "layout", "methods", "scalar", "state", "system", "trajectory"],
        ),
        ("system", &["error", "hamiltonian", "scalar", "state", "threads"]),
        ("flow", &["error", "hamiltonian", "scalar", "state", "system"]),
        ("composition", &["hamiltonian", "scalar"]),
        ("layout", &["error", "flow", "hamiltonian", "scalar", "state", "system", "threads"]),
        ("trajectory", &["composition", "error", "hamiltonian", "layout", "scalar", "state", "system"]),
        (
            "ensemble",
            &["composition", "error", "hamiltonian", "layout", "scalar", "state", "system", "threads", "trajectory"],
        ),
        (
            "methods",
            &["composition", "ensemble", "error", "flow", "hamiltonian", "scalar", "state", "system", "trajectory"],
        ),
        ("check", &["composition", "error", "hamiltonian", "methods", "scalar", "state", "system", "trajectory"]),
        (
            "chaos",
            &[
                "check",
                "ensemble",
                "error",
                "hamiltonian",
                "layout",
                "methods",
                "scalar",
                "state",
                "system",
                "threads",
                "trajectory",
            ],
        ),
        ("output", &["error", "state", "trajectory"]),
        ("guide", &[]),
    ],
);

/// The modules that compute and never see a token.
const WITHOUT_TOKENS: [&str; 8] =
    ["graph", "differentiate", "stencil", "lower", "pairs", "program", "pattern", "taylor"];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The files of a module of a crate, without their unit tests.
fn module(source: &str, name: &str) -> Vec<(PathBuf, String)> {
    let source = root().join(source);
    let files = sources(&source).into_iter().filter(|(path, _)| {
        let first = path.strip_prefix(&source).expect("a path below").iter().next().expect("a name");
        first == name || Some(name) == first.to_str().and_then(|first| first.strip_suffix(".rs"))
    });
    let files = files.filter(|(path, _)| !path.iter().any(|folder| folder == "tests"));
    let own = |text: String| text.split("#[cfg(test)]").next().unwrap_or_default().to_owned();
    let files: Vec<_> = files.map(|(path, text)| (path, own(text))).collect();
    assert!(!files.is_empty(), "there is no module {name}");
    files
}

/// The modules of a folder that a text names, as `crate::folder::name` or in groups; of the crate, where there is no folder.
fn imports(text: &str, folder: &str) -> Vec<String> {
    imports_of("crate::", text, folder)
}

/// The same of another crate, named with its colons.
fn imports_of(of: &str, text: &str, folder: &str) -> Vec<String> {
    let code = text.lines().filter(|line| !line.trim_start().starts_with("//"));
    let dense: String = code.flat_map(str::split_whitespace).collect();
    let paths = dense.split(of).skip(1).flat_map(paths);
    let mut found: Vec<_> = paths.filter_map(|path| path.strip_prefix(folder).map(first_name)).collect();
    found.retain(|name| !name.is_empty());
    found.dedup();
    found
}

/// The paths of a group, or the one path, that a text begins with.
fn paths(text: &str) -> Vec<String> {
    let (mut found, mut groups, mut path) = (Vec::new(), Vec::new(), String::new());
    for character in text.chars() {
        match character {
            '{' => groups.push(path.clone()),
            ',' | '}' => {
                found.push(path);
                let Some(group) = groups.last() else { return found };
                path = group.clone();
                if character == '}' {
                    groups.pop();
                }
            }
            ':' | '_' | 'a'..='z' | 'A'..='Z' | '0'..='9' => path.push(character),
            _ => break,
        }
    }
    found.push(path);
    found
}

fn first_name(text: &str) -> String {
    text.chars().take_while(|character| character.is_alphanumeric() || *character == '_').collect()
}

#[test]
fn imports_are_found() {
    let text =
        "use crate::{\n    errors::Errors,\n    graph::{Graph, index::{Index, Loop}},\n};\nlet x: crate::model::Model;";
    assert_eq!(imports(text, ""), ["errors", "graph", "model"]);
    assert_eq!(imports(text, "graph::"), ["Graph", "index"]);
}

/// What the crates outside of this workspace, which it does not compile, take of the core: names that this has.
#[test]
fn the_core_exports_what_crates_outside_of_the_workspace_use() {
    let core = fs::read_to_string(root().join("integrator-core/src/lib.rs")).expect("text");
    let (public, private) = core.split_once("pub mod __private {").expect("the private API");
    let has = |text: &str, name: &str| text.split(|c: char| !c.is_alphanumeric() && c != '_').any(|word| word == name);
    assert!(has(private, "part_of") && !has(private, "parts_of"));
    let mut found = 0;
    for folder in ["integrator-gpu/src", "integrator-mpi/src"] {
        for (path, text) in sources(&root().join(folder)) {
            // Without the names by which they are known there.
            let text: String =
                text.split(" as ").map(|piece| piece.trim_start_matches(char::is_alphanumeric)).collect();
            for (text_of, under) in [(public, ""), (private, "__private::")] {
                for name in imports_of("integrator_core::", &text, under).iter().filter(|name| *name != "__private") {
                    assert!(has(text_of, name), "{}: the core has no `{under}{name}` any more", path.display());
                    found += 1;
                }
            }
        }
    }
    assert!(found > 50, "{found} names");
}

/// Arrows between modules point one way: a module knows what its arrow comes from, never what it leads to.
#[test]
fn modules_import_only_earlier_modules() {
    for (source, modules) in [SYMBOLIC, EMIT, CORE] {
        let folder = source.split_once("/src/").map_or_else(String::new, |(_, folder)| format!("{folder}::"));
        for (name, may_know) in modules {
            for (path, text) in module(source, name) {
                for import in imports(&text, &folder) {
                    let allowed = import == *name || may_know.contains(&import.as_str());
                    assert!(allowed, "{} imports {import}; `{name}` may know {may_know:?}", path.display());
                }
                let unseen = if path.ends_with("mod.rs") { "use super::" } else { "super::super" };
                assert!(folder.is_empty() || !text.contains(unseen), "{}: write `crate::`", path.display());
            }
        }
    }
}

#[test]
fn every_module_has_its_row() {
    for (source, modules) in [SYMBOLIC, EMIT, CORE] {
        for entry in fs::read_dir(root().join(source)).expect("a folder").map(|entry| entry.expect("an entry").path()) {
            let name = entry.file_stem().expect("a name").to_string_lossy().into_owned();
            assert!(
                ["lib", "mod"].contains(&&*name) || modules.iter().any(|(known, _)| *known == name),
                "say what `{name}` may know"
            );
        }
    }
}

#[test]
fn the_middle_of_the_pipeline_sees_no_tokens() {
    for name in WITHOUT_TOKENS {
        for (path, text) in module(SYMBOLIC.0, name) {
            for outside in ["syn::", "proc_macro2", "quote"] {
                assert!(!text.contains(outside), "{} names {outside}", path.display());
            }
        }
    }
}

/// What every user builds, unoptimised, before their own crate.
#[test]
fn the_macros_depend_on_three_crates() {
    let manifest = fs::read_to_string(root().join("integrator-symbolic/Cargo.toml")).expect("a manifest");
    let dependencies = manifest.split("\n[dependencies]\n").nth(1).and_then(|rest| rest.split("\n[").next());
    let mut names: Vec<_> = dependencies
        .expect("a table")
        .lines()
        .filter_map(|line| line.split(['.', ' ']).next())
        .filter(|name| !name.is_empty())
        .collect();
    names.sort_unstable();
    assert_eq!(names, ["proc-macro2", "quote", "syn"]);
}

#[test]
fn only_clones_vectors_a_view_and_workers_are_unsafe() {
    let crates = ["integrator-cli", "integrator-core", "integrator-macros", "integrator-symbolic"];
    let unsafe_code = |line: &str| ["unsafe {", "unsafe fn", "unsafe impl"].iter().any(|form| line.contains(form));
    for (path, text) in crates.iter().flat_map(|name| sources(&root().join(name).join("src"))) {
        let may_be = path.ends_with("instruction_set.rs")
            || path.ends_with("scalar/dual/in_memory.rs")
            || path.ends_with("threads/workers.rs")
            || path.starts_with(root().join("integrator-core/src/scalar/simd/x86"));
        let lines: Vec<_> = text.lines().collect();
        for (number, _) in lines.iter().enumerate().filter(|(_, line)| unsafe_code(line)) {
            assert!(may_be, "{}:{} is unsafe", path.display(), number + 1);
            let reason = lines[..number].iter().rev().take_while(|line| line.trim_start().starts_with("//"));
            assert!(reason.into_iter().any(|line| line.contains("// SAFETY:")), "{}:{}", path.display(), number + 1);
        }
    }
    for (path, text) in sources(&root().join("integrator-core/src/scalar/simd")) {
        let raw = |call: &&str| ["_ptr()", "load", "store"].iter().any(|raw| call.contains(raw));
        let hidden = text.split("instruction!(").skip(1).filter_map(|call| call.split(['\n', ';']).next()).find(raw);
        assert!(hidden.is_none(), "{}: {hidden:?} has a reason of its own", path.display());
    }
    for path in ["integrator-cli/src/main.rs", "integrator-macros/src/lib.rs", "integrator-symbolic/src/lib.rs"] {
        let root = fs::read_to_string(root().join(path)).expect("text");
        assert!(root.contains("\n#![forbid(unsafe_code)]\n"), "{path} forbids unsafe code");
    }
}

/// What a `main` shows that returns an error, and what `expect` shows, is the sentence: no error has a `Debug` of its own.
#[test]
fn every_error_is_debugged_as_it_is_displayed() {
    let files = sources(&root().join("integrator-core/src"));
    let listed: Vec<&str> = files
        .iter()
        .flat_map(|(_, text)| text.split("debug_as_display!(").skip(1))
        .filter_map(|call| call.split(')').next())
        .flat_map(|names| names.split(','))
        .map(str::trim)
        .collect();
    let mut count = 0;
    for (path, text) in &files {
        for (at, _) in text.match_indices("thiserror::Error)]") {
            let derive = text[..at].rsplit("#[derive(").next().expect("a derive");
            let item =
                text[at..].split(['\n', ' ', '<', '{', '(', ';']).skip_while(|word| !["enum", "struct"].contains(word));
            let name = item.skip(1).find(|word| !word.is_empty()).expect("a name");
            assert!(!derive.contains("Debug"), "{}: {name} derives Debug", path.display());
            assert!(listed.contains(&name), "{}: {name} is in no `debug_as_display!`", path.display());
            count += 1;
        }
    }
    assert!(count > 10, "the errors are found: {count}");
}
