//! The invariants of ARCHITECTURE.md that can be read off the sources.

#[path = "support/imports.rs"]
mod imports;
#[path = "support/sources.rs"]
mod sources;

use imports::{Module, circles, imports, paths};
use sources::sources;
use std::{
    fs,
    path::{Path, PathBuf},
};

/// What each module of a crate or of a folder may import from it: modules of earlier rows.
type MayKnow = (&'static str, &'static [(&'static str, &'static [&'static str])]);

/// The modules of `integrator-symbolic`, in the order of the pipeline.
const SYMBOLIC: MayKnow = (
    "integrator-symbolic/src",
    &[
        ("errors", &[]),
        ("limits", &["errors"]),
        ("fragments", &[]),
        ("other_names", &[]),
        ("reason", &[]),
        ("spelling", &[]),
        ("graph", &[]),
        ("differentiate", &["graph"]),
        ("stencil", &["differentiate", "graph", "reason"]),
        ("lower", &["graph"]),
        ("pairs", &["differentiate", "graph", "reason"]),
        ("program", &["differentiate", "graph", "reason"]),
        ("scheme", &["errors", "other_names"]),
        ("taylor", &["differentiate", "graph"]),
        ("syntax", &["errors", "scheme"]),
        ("model", &["errors", "graph", "limits", "spelling", "syntax"]),
        ("pattern", &["differentiate", "graph", "lower", "model", "pairs", "program", "reason", "stencil"]),
        ("layout", &["differentiate", "graph", "model", "pairs", "pattern", "program", "reason", "stencil"]),
        ("prose", &["differentiate", "graph", "model", "program"]),
        (
            "judge",
            &[
                "differentiate",
                "errors",
                "graph",
                "layout",
                "limits",
                "model",
                "pairs",
                "pattern",
                "prose",
                "reason",
                "scheme",
                "spelling",
                "syntax",
            ],
        ),
        (
            "emit",
            &[
                "differentiate",
                "stencil",
                "graph",
                "judge",
                "layout",
                "lower",
                "model",
                "other_names",
                "pairs",
                "pattern",
                "program",
                "prose",
                "scheme",
                "syntax",
                "taylor",
            ],
        ),
        (
            "report",
            &["differentiate", "graph", "layout", "lower", "model", "pattern", "program", "prose", "stencil", "syntax"],
        ),
    ],
);

/// The folders of `model`, from the ground up. Methods of `Reader` call each other across them.
const MODEL: MayKnow = (
    "integrator-symbolic/src/model",
    &[
        ("code", &[]),
        ("parameters", &[]),
        ("values", &["code", "parameters"]),
        ("loops", &["code", "parameters", "values"]),
        ("control", &["code", "loops", "parameters", "values"]),
        ("expressions", &["code", "control", "loops", "parameters", "values"]),
        ("system", &["code", "expressions", "loops", "parameters", "values"]),
    ],
);

/// The folders of `emit`, from the ground up.
const EMIT: MayKnow = (
    "integrator-symbolic/src/emit",
    &[
        ("fingerprint", &[]),
        ("other_name", &[]),
        ("printer", &[]),
        ("read_by_methods", &["printer"]),
        ("flow", &["printer", "read_by_methods"]),
        ("order", &["flow"]),
        ("taylor", &["printer"]),
    ],
);

/// The folders of `integrator-core`, from the ground up.
const CORE: MayKnow = (
    "integrator-core/src",
    &[
        ("error", &[]),
        ("threads", &[]),
        ("scalar", &[]),
        ("state", &["error", "scalar"]),
        ("system", &["error", "scalar", "state", "threads"]),
        ("flow", &["error", "scalar", "state", "system"]),
        ("composition", &["scalar", "state", "system"]),
        ("layout", &["error", "flow", "scalar", "state", "system", "threads"]),
        ("trajectory", &["composition", "error", "layout", "scalar", "state", "system"]),
        ("ensemble", &["composition", "error", "layout", "scalar", "state", "system", "threads", "trajectory"]),
        (
            "methods",
            &[
                "composition",
                "ensemble",
                "error",
                "flow",
                "layout",
                "scalar",
                "state",
                "system",
                "threads",
                "trajectory",
            ],
        ),
        ("hamiltonian", &["composition", "error", "methods", "state", "system", "trajectory"]),
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
        ("orbit", &["error", "flow", "scalar", "state"]),
        ("guide", &[]),
    ],
);

/// The files and folders of `check`.
const CHECK: MayKnow = (
    "integrator-core/src/check",
    &[
        ("error", &[]),
        ("start", &[]),
        ("flow", &[]),
        ("modified", &[]),
        ("statistics", &["start"]),
        ("oracle", &["flow", "start", "statistics"]),
        ("property", &["flow", "modified", "oracle", "start", "statistics"]),
        ("certificate", &["property"]),
        ("choose", &["oracle", "property", "start", "statistics"]),
        ("measurable", &["oracle", "property", "start", "statistics"]),
        ("equilibrium", &[]),
        ("configurational", &[]),
        ("shortfall", &["certificate", "error", "property"]),
        ("certify", &["certificate", "measurable", "oracle", "property", "shortfall", "start", "statistics"]),
    ],
);

/// The folders of `layout`.
const LAYOUT: MayKnow = (
    "integrator-core/src/layout",
    &[("lists", &[]), ("loops", &[]), ("products", &["loops"]), ("lattice", &["loops"]), ("bodies", &["lattice"])],
);

/// The folders of `methods`.
const METHODS: MayKnow = (
    "integrator-core/src/methods",
    &[("friction", &[]), ("pace", &[]), ("implicit", &["pace"]), ("inner_steps", &[]), ("taylor", &[])],
);

/// All of them.
const ORDERS: [MayKnow; 7] = [SYMBOLIC, MODEL, EMIT, CORE, CHECK, LAYOUT, METHODS];

/// The circles of more than three files: where they are, and how many files they have. None may grow, and no new one may arise.
const LARGE_CIRCLES: [(&str, &str, usize); 2] =
    [("integrator-core/src", "scalar", 9), ("integrator-core/src", "trajectory", 13)];

/// The modules that compute and never see a token.
const WITHOUT_TOKENS: [&str; 10] =
    ["graph", "differentiate", "stencil", "lower", "pairs", "program", "pattern", "layout", "reason", "taylor"];

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

#[test]
fn imports_are_found() {
    let text = "use crate::{\n    errors::Errors,\n    graph::{Graph, index::{Index as I, Loop}},\n};\nuse super::b::C;\nlet x: crate::model::Model;";
    let found: Vec<_> = paths(text, &["a".to_owned(), "own".to_owned()]).iter().map(|path| path.join("::")).collect();
    assert_eq!(
        found,
        ["errors::Errors", "graph::Graph", "graph::index::Index", "graph::index::Loop", "model::Model", "a::b::C"]
    );
}

/// What `integrator-gpu`, `integrator-mpi` and `integrator-python`, which no command at the root compiles, take of the core: names that this has.
#[test]
fn the_core_exports_what_crates_outside_of_the_workspace_use() {
    let core = fs::read_to_string(root().join("integrator-core/src/lib.rs")).expect("text");
    let (public, private) = core.split_once("pub mod __private {").expect("the private API");
    let has = |text: &str, name: &str| text.split(|c: char| !c.is_alphanumeric() && c != '_').any(|word| word == name);
    assert!(has(private, "part_of") && !has(private, "parts_of"));
    let mut found = 0;
    for folder in ["integrator-gpu/src", "integrator-mpi/src", "integrator-python/src"] {
        for (path, text) in sources(&root().join(folder)) {
            // Without the names by which they are known there.
            let text: String =
                text.split(" as ").map(|piece| piece.trim_start_matches(char::is_alphanumeric)).collect();
            for (text_of, under) in [(public, ""), (private, "__private::")] {
                for name in taken(&text, under).iter().filter(|name| *name != "__private") {
                    assert!(has(text_of, name), "{}: the core has no `{under}{name}` any more", path.display());
                    found += 1;
                }
            }
        }
    }
    assert!(found > 50, "{found} names");
}

/// The names that a crate takes of the core, or of a module of it.
fn taken(text: &str, under: &str) -> Vec<String> {
    let text = text.replace("crate::", "own::").replace("super::", "own::").replace("integrator_core::", "crate::");
    let paths = paths(&text, &[]).into_iter().map(|path| path.join("::"));
    let first = |path: &str| path.split("::").next().unwrap_or_default().to_owned();
    let names = paths.filter_map(|path| path.strip_prefix(under).map(first));
    names.filter(|name| !name.is_empty()).collect()
}

/// Arrows between modules point one way: a module knows what its arrow comes from, never what it leads to.
#[test]
fn modules_import_only_earlier_modules() {
    for (source, modules) in ORDERS {
        let (source, folder) =
            source.split_once("/src/").map_or((source, None), |(name, folder)| (name, Some(folder.to_owned())));
        let source = root().join(source.trim_end_matches("/src")).join("src");
        let inside = |module: &Module| {
            let below = folder.as_ref().map_or(Some(&module[..]), |folder| module.strip_prefix(&[folder.clone()][..]));
            below.and_then(|path| path.first().cloned())
        };
        let all = imports(&source);
        for (at, (name, may_know)) in modules.iter().enumerate() {
            let later = may_know.iter().find(|known| !modules[..at].iter().any(|(earlier, _)| earlier == *known));
            assert_eq!(later, None, "`{name}` may know earlier rows only");
            for (module, named) in all.iter().filter(|(module, _)| inside(module).as_deref() == Some(name)) {
                for import in named.iter().filter_map(inside) {
                    let allowed = import == *name || may_know.contains(&import.as_str());
                    assert!(allowed, "{} imports {import}; `{name}` may know {may_know:?}", module.join("::"));
                }
            }
        }
    }
}

#[test]
fn circles_of_imports_are_small() {
    let mut large = Vec::new();
    for (source, _) in [SYMBOLIC, CORE] {
        for circle in circles(&imports(&root().join(source))) {
            let text = circle.iter().map(|module| module.join("::")).collect::<Vec<_>>();
            let folder = &circle[0][0];
            assert!(circle.iter().all(|module| module[0] == *folder), "a circle of several folders: {text:?}");
            if circle.len() > 3 {
                large.push((source, folder.clone(), circle.len(), text));
            }
        }
    }
    let found: Vec<_> = large.iter().map(|(source, folder, size, _)| (*source, folder.as_str(), *size)).collect();
    assert_eq!(found, LARGE_CIRCLES, "{large:#?}");
}

#[test]
fn every_module_has_its_row() {
    for (source, modules) in ORDERS {
        for entry in fs::read_dir(root().join(source)).expect("a folder").map(|entry| entry.expect("an entry").path()) {
            let name = entry.file_stem().expect("a name").to_string_lossy().into_owned();
            assert!(
                ["lib", "mod"].contains(&&*name) || modules.iter().any(|(known, _)| *known == name),
                "say what `{name}` may know"
            );
        }
        for (known, _) in modules {
            let path = root().join(source).join(known);
            assert!(path.is_dir() || path.with_extension("rs").is_file(), "`{known}` has a row and no file");
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
fn only_clones_vectors_views_and_workers_are_unsafe() {
    let crates = ["integrator-cli", "integrator-core", "integrator-macros", "integrator-symbolic"];
    let unsafe_code = |line: &str| ["unsafe {", "unsafe fn", "unsafe impl"].iter().any(|form| line.contains(form));
    for (path, text) in crates.iter().flat_map(|name| sources(&root().join(name).join("src"))) {
        let may_be = path.ends_with("instruction_set.rs")
            || path.ends_with("scalar/dual/in_memory.rs")
            || path.ends_with("system/shared_table.rs")
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
