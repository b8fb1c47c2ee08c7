//! Inputs that are wrong in every way: a message and exit code 1, never a panic.

use super::{Outcome, file, refusal, repository, run};
use std::fs;

const SYSTEM: &str = "use integrator_core::prelude::*;

struct Magnetic {
    charge: f64,
}

#[hamiltonian]
impl Magnetic {
    fn kinetic(&self, p: [f64; 2], q: [f64; 2]) -> f64 {
\t0.5 * (p[0] - self.charge * q[1]).powi(2) + 0.5 * p[1] * p[1]
    }
    fn potential(&self, q: [f64; 2]) -> f64 {
        q[0] * q[2]
    }
}
";

#[test]
fn mistakes_are_shown_as_the_compiler_shows_them() {
    let path = file("magnetic.rs", SYSTEM);
    let message = refusal(&["show", &path]);
    let expected = format!(
        "error: this term mixes q and p, so H is not separable into T(p) + V(q)
  --> {path}:10:8
   |
10 | \t0.5 * (p[0] - self.charge * q[1]).powi(2) + 0.5 * p[1] * p[1]
   | \t      ^^^^^^^^^^^^^^^^^^^^^^^^^^^
   |
   = help: split H into parts with exact flows, `split = a + b`, which `integrator-cli show` prints for `split = none`
   = help: or keep it in one piece for implicit methods, `split = none`
   = help: or couple two copies of the state, `split = symmetric(omega = 20.0)`
   = help: or change to coordinates in which T depends on p only

error: index 2 is out of bounds for the coordinates `[f64; 2]`
  --> {path}:13:18
   |
13 |         q[0] * q[2]
   |                  ^
   |
   = note: the last index here is 1
"
    );
    assert_eq!(message, expected);
    assert_eq!(refusal(&["expand", &path]), expected, "what cannot be read is not expanded");
    assert_eq!(refusal(&["show", &path, "--json"]), expected);
}

#[test]
fn compositions_are_checked_against_the_system() {
    let relativistic = |compose: &str| {
        format!(
            "#[hamiltonian(compose = {compose})]
impl Relativistic {{
    fn kinetic(&self, p: [f64; 1]) -> f64 {{ (1.0 + p[0] * p[0]).sqrt() }}
    fn potential(&self, q: [f64; 1]) -> f64 {{ -q[0].cos() }}
}}
"
        )
    };
    let path = file("relativistic.rs", relativistic("BlanesMoanSrkn11"));
    let message = refusal(&["show", &path]);
    let expected = format!(
        "error: H of `Relativistic` is not ½ pᵀ M⁻¹ p + V(q) with a constant M, as `BlanesMoanSrkn11` needs it
 --> {path}:1:25
  |
1 | #[hamiltonian(compose = BlanesMoanSrkn11)]
  |                         ^^^^^^^^^^^^^^^^
"
    );
    assert_eq!(message, expected);
    let path = file("relativistic_in_place.rs", relativistic("V(1/6) T(1/2) V(2/3, -1/72) T(1/2) V(1/6)"));
    let message = refusal(&["show", &path]);
    assert!(message.contains("T has the term `sqrt(1 + p[0]^2)`") && message.contains(":1:46\n"), "{message}");
    let own = "composition! { pub struct Mine: order 4 = V(1/6) T(1/2) V(2/3) T(1/2) V(1/6); }\n";
    let path = file("relativistic_own.rs", format!("{own}{}", relativistic("Mine")));
    let message = refusal(&["show", &path]);
    assert!(message.contains("declared order 4, but the proof finds order 2"), "{message}");
    assert!(message.contains("relativistic_own.rs:1:39\n"), "{message}");
}

/// A row: the name of a file, its bytes, and what is said of it.
type Row<'a> = (&'a str, &'a [u8], &'a str);

#[test]
fn a_file_without_an_annotation_is_reported() {
    let deep = "(".repeat(100_000) + &")".repeat(100_000);
    let deep_system = format!("#[hamiltonian]\nimpl Deep {{ fn kinetic(&self) -> f64 {{ {deep} }} }}");
    let rows: &[Row<'_>] = &[
        ("empty.rs", b"", "no impl in"),
        ("bare.rs", b"struct Nothing;\n", "no impl in"),
        ("prose.rs", b"Dear reader, this is no Rust at all.\n", "no impl in"),
        ("comment.rs", b"// #[hamiltonian] impl Nothing {}\n", "no impl in"),
        ("pattern.rs", b"macro_rules! m { ($n:ident) => { #[hamiltonian] impl $n {} } }", "no impl in"),
        ("open.rs", b"#[hamiltonian] impl Open {", "this is not Rust"),
        ("bytes.rs", b"\xff\xfe\x00\x01", "is not a text file"),
        ("null.rs", b"\0\0\0\0", "this is not Rust"),
        ("nothing_behind.rs", b"struct First;\n#[hamiltonian]", "requires an `impl`"),
        ("struct.rs", b"#[hamiltonian] struct First;", "requires an `impl`"),
        ("no_functions.rs", b"#[hamiltonian] impl First {}", "the impl lacks `fn kinetic"),
        ("no_parser.rs", b"#[hamiltonian] impl 3 ? { fn fn }", "error: "),
        ("deep.rs", deep.as_bytes(), "no impl in"),
        ("deep_system.rs", deep_system.as_bytes(), "nested more than 200 levels deep"),
    ];
    for (name, bytes, expected) in rows {
        let path = file(name, bytes);
        for task in ["show", "expand"] {
            let message = refusal(&[task, &path]);
            assert!(message.contains(expected), "{name}: {message}");
        }
    }
    let nothing_behind = refusal(&["show", &file("nothing_behind.rs", "struct First;\n#[hamiltonian]")]);
    assert!(nothing_behind.contains("nothing_behind.rs:2:1\n"), "the place is the annotation: {nothing_behind}");
}

#[test]
fn an_unreadable_file_is_reported() {
    let folder = env!("CARGO_TARGET_TMPDIR");
    for path in [folder, "/nowhere/at/all.rs"] {
        let message = refusal(&["show", path]);
        assert!(message.contains("cannot be read: "), "{message}");
    }
}

/// A file cut off anywhere, and with a character too many.
#[test]
fn damaged_files_end_without_a_panic() {
    let pendulum = fs::read_to_string(repository().join("examples/pendulum.rs")).expect("text");
    let places = (0..pendulum.len()).filter(|at| pendulum.is_char_boundary(*at)).step_by(131);
    for at in places {
        let (before, behind) = pendulum.split_at(at);
        for (name, damaged) in [("cut.rs", before.to_owned()), ("inserted.rs", format!("{before} ] {behind}"))] {
            let Outcome { code, stderr, .. } = run(&["show", &file(name, &damaged)]);
            assert!(matches!(code, Some(0 | 1)), "{name} at {at}: {code:?} {stderr}");
        }
    }
}
