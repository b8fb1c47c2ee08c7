//! `new`: a crate with one Hamiltonian, a run, and a test that certifies it; with `--python` a Python module.

use crate::mistake::Mistake;
use clap::Args;
use std::{
    fs,
    path::{Path, PathBuf},
};

#[derive(Args)]
pub(crate) struct Options {
    /// The name of the crate, and of its folder
    name: String,
    /// Writes a Python module, for maturin
    #[arg(long)]
    python: bool,
    /// The clone of the repository that the crate depends on; the one that this program was built from by default
    #[arg(long, value_name = "CLONE", conflicts_with = "repository")]
    path: Option<PathBuf>,
    /// The address of the repository that the crate depends on, in place of a clone
    #[arg(long, value_name = "URL")]
    repository: Option<String>,
}

const SYSTEM: &str = include_str!("system.rs.in");

/// Files with their templates.
const PLAIN: [(&str, &str); 4] = [
    ("Cargo.toml", include_str!("Cargo.toml.in")),
    ("README.md", include_str!("README.md.in")),
    (".gitignore", "/target\n"),
    ("src/main.rs", include_str!("main.rs.in")),
];
const PYTHON: [(&str, &str); 7] = [
    ("Cargo.toml", include_str!("python_Cargo.toml.in")),
    ("README.md", include_str!("python_README.md.in")),
    (".gitignore", "/target\n/.venv\n__pycache__/\n*.so\n"),
    ("pyproject.toml", include_str!("pyproject.toml.in")),
    ("src/lib.rs", include_str!("lib.rs.in")),
    ("example.py", include_str!("example.py.in")),
    ("test_MODULE.py", include_str!("test.py.in")),
];

/// Writes the crate into the current folder; returns what to do next.
pub(crate) fn new(options: &Options) -> Result<String, Mistake> {
    let Options { name, python, .. } = options;
    check(name, *python)?;
    let folder = Path::new(name);
    if folder.exists() {
        return Err(Mistake::plain(format!(
            "`{name}` exists in this folder\nhelp: choose another name, or move it away"
        )));
    }
    let (module, files) = (name.replace('-', "_"), if *python { &PYTHON[..] } else { &PLAIN });
    let kind = type_of(&module);
    let derived = if *python { "Clone, Deserialize, Serialize" } else { "Clone" };
    let system = SYSTEM.replace("DERIVED", derived);
    let [core, binding] = ["integrator-core", "integrator-python"].map(|package| dependency(options, package));
    let (core, binding) = (core?, if *python { binding? } else { String::new() });
    let written = |text: &str| {
        let text = text.replace("SYSTEM", &system).replace("CRATE", name).replace("MODULE", &module);
        text.replace("TYPE", &kind).replace("CORE", &core).replace("PYTHON", &binding)
    };
    for (file, template) in files {
        let path = folder.join(written(file));
        let created =
            path.parent().map_or(Ok(()), fs::create_dir_all).and_then(|()| fs::write(&path, written(template)));
        created.map_err(|error| Mistake::plain(format!("{} cannot be written: {error}", path.display())))?;
    }
    Ok(match python {
        false => format!("created {name}; next: cd {name} && cargo run --release && cargo test\n"),
        true => format!("created {name}; next: cd {name} && maturin develop --release && python example.py\n"),
    })
}

/// Names that Cargo refuses, or that would hide a crate that is used.
const TAKEN: [&str; 14] = [
    "alloc",
    "build",
    "core",
    "deps",
    "examples",
    "incremental",
    "integrator_core",
    "integrator_python",
    "numpy",
    "proc_macro",
    "serde",
    "std",
    "test",
    "tests",
];

/// Words of Python that are none of Rust.
const OF_PYTHON: [&str; 17] = [
    "and", "assert", "class", "def", "del", "elif", "except", "finally", "from", "global", "import", "is", "lambda",
    "nonlocal", "not", "or", "with",
];

/// Whether a name is one of a crate, and of a Python module.
fn check(name: &str, python: bool) -> Result<(), Mistake> {
    let is_word = |name: &str| {
        let is_known = TAKEN.contains(&name) || python && OF_PYTHON.contains(&name);
        syn::parse_str::<syn::Ident>(name).is_ok() && !name.starts_with('_') && !is_known
    };
    let plain = |letter: char| letter.is_ascii_alphanumeric() || matches!(letter, '-' | '_');
    let module = name.replace('-', "_");
    if name.chars().all(plain) && is_word(&module) {
        return Ok(());
    }
    let mut other: String =
        name.chars().map(|letter| if plain(letter) { letter.to_ascii_lowercase() } else { '_' }).collect();
    other = other.trim_matches(['_', '-']).to_owned();
    if !is_word(&other.replace('-', "_")) {
        other = format!("my_{other}").trim_end_matches('_').to_owned();
    }
    let message = format!(
        "`{name}` is not a name for a crate\nhelp: letters, digits, `-` and `_` are allowed, for example `{other}`"
    );
    Err(Mistake::plain(message))
}

/// `TwoWells` of `two_wells`, unless the files use that name otherwise.
fn type_of(module: &str) -> String {
    let capital = |word: &str| {
        let mut letters = word.chars();
        letters.next().map(|first| first.to_ascii_uppercase()).into_iter().chain(letters).collect::<String>()
    };
    let name: String = module.split('_').map(capital).collect();
    let texts =
        [SYSTEM, include_str!("main.rs.in"), include_str!("lib.rs.in"), "Clone Vec Box Option Some None String Result"];
    let is_word = |letter: char| letter.is_ascii_alphanumeric() || letter == '_';
    let is_taken = texts.iter().flat_map(|text| text.split(|letter| !is_word(letter))).any(|word| word == name);
    if is_taken { name + "System" } else { name }
}

/// Where a package is, in the words of Cargo.
fn dependency(options: &Options, package: &str) -> Result<String, Mistake> {
    if let Some(address) = &options.repository {
        return Ok(format!("git = {address:?}"));
    }
    let own = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let clone = options.path.as_ref().unwrap_or(&own);
    let folder = clone.join(package).canonicalize().ok().filter(|folder| folder.join("Cargo.toml").exists());
    let folder = folder.ok_or_else(|| {
        let clone = clone.display();
        Mistake::plain(format!(
            "`{clone}` has no `{package}`\nhelp: write `--path CLONE` with a clone of the repository, or `--repository URL`"
        ))
    })?;
    Ok(format!("path = {:?}", folder.display().to_string()))
}
