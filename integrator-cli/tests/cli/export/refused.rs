//! What cannot be exported, with the reason, and what of a file is.

use crate::{answer, file, refusal};

const OSCILLATOR: &str = "
pub struct Oscillator { stiffness: f64 }
#[hamiltonian]
impl Oscillator {
    fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] / 2.0 }
    fn potential(&self, q: [f64; 1]) -> f64 { self.stiffness * q[0] * q[0] / 2.0 }
}
";

/// A system of a file, with its kinetic energy and its potential over other parameters.
fn changed(name: &str, from: &str, to: &str) -> String {
    let text = OSCILLATOR.replace(from, to);
    assert_ne!(text, OSCILLATOR, "{from}");
    file(name, text)
}

#[test]
fn reasons_have_a_place() {
    let cases = [
        (
            changed("slices.rs", "[f64; 1]", "&[f64]"),
            "error: `export` does not support slices of coordinates\n --> ",
            "help: write an array such as `[f64; 4]`",
        ),
        (
            changed("elsewhere.rs", "pub struct Oscillator { stiffness: f64 }", ""),
            "error: `struct Oscillator` is declared in another file, or several times in this one\n --> ",
            "#[hamiltonian]",
        ),
        (
            changed("kind.rs", "{ stiffness: f64 }", "{ stiffness: f32 }"),
            "error: `export` does not support fields of the type `f32`\n --> ",
            "pub struct Oscillator { stiffness: f32 }\n  |                                    ^^^\n",
        ),
        (
            changed("method.rs", "self.stiffness", "self.stiffness.to_degrees()"),
            "error: `export` has no C code for the parameter expression `",
            "help: compute it before, and keep it in a field",
        ),
        (
            changed("theirs.rs", "#[hamiltonian]", "#[hamiltonian(compose = elsewhere::Theirs)]"),
            "error: `Theirs` is declared in another file\n --> ",
            "--composition NAME",
        ),
        (
            changed("cosh.rs", "q[0] * q[0] / 2.0", "q[0].cosh()"),
            "error: `export` has no kernel for `sinh`, which H or one of its derivatives calls\n --> ",
            "help: use other functions, such as `exp` and `ln`\n",
        ),
        (
            file(
                "whole.rs",
                "#[hamiltonian(split = none)]\nimpl Product {\n    fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { q[0].sin() * p[0].cos() }\n}",
            ),
            "error: `export` does not support H in one piece, `split = none`\n --> ",
            "2 | impl Product {",
        ),
    ];
    for (path, message, advice) in cases {
        let found = refusal(&["export", "--c", &path]);
        assert!(found.starts_with(message) && found.contains(advice), "{found}");
        assert!(!found.contains("gpu"), "{found}");
    }
}

#[test]
fn inner_steps_are_refused() {
    let found = refusal(&["export", "--c", "tests/device_text/systems.rs", "--system", "Stiff"]);
    assert!(found.starts_with("error: `export` does not support parts that take inner steps\n"), "{found}");
}

#[test]
fn names_are_corrected() {
    let path = file("names.rs", OSCILLATOR);
    let found = refusal(&["export", "--c", &path, "--composition", "Yoshida5"]);
    assert!(
        found.starts_with("error: unknown composition `Yoshida5` of `--composition`\nhelp: similar names: `Yoshida4`"),
        "{found}"
    );
    let found = refusal(&["export", "--c", &path, "--system", "Ocsillator"]);
    assert_eq!(found, "error: unknown system `Ocsillator` of `--system`\nhelp: similar names: `Oscillator`\n");
    let found = refusal(&["export", "--c", &path, "-o", "/no/such/folder/x.h"]);
    assert!(found.starts_with("error: /no/such/folder/x.h cannot be written: "), "{found}");
    let relativistic = changed("relativistic.rs", "p[0] * p[0] / 2.0", "(1.0 + p[0] * p[0]).sqrt()");
    let found = refusal(&["export", "--c", &relativistic, "--composition", "Chin4A"]);
    assert!(found.starts_with("error: `Chin4A` requires H = "), "{found}");
    assert!(answer(&["export", "--c", &relativistic]).contains("/* No tangent: "));
}

/// Both systems of a file, and compositions of its own.
#[test]
fn a_file_may_have_several_systems() {
    let second =
        OSCILLATOR.replace("Oscillator", "TwoWells").replace("#[hamiltonian]", "#[hamiltonian(compose = Mine)]");
    let mine = "composition! { pub struct Mine: order 2, citation \"nobody\" = V(1/2) T(1) V(1/2); }";
    let path = file("several.rs", [OSCILLATOR, &second, mine].concat());
    let found = answer(&["export", "--c", &path]);
    for part in [
        "oscillator_advance_Verlet(",
        "two_wells_advance_Mine(",
        "#ifndef INTEGRATOR_OSCILLATOR_TWO_WELLS_H",
        "nobody */",
    ] {
        assert!(found.contains(part), "lacks {part}");
    }
    let found =
        answer(&["export", "--c", &path, "--system", "TwoWells", "--composition", "Verlet", "--composition", "Chin4A"]);
    assert!(!found.contains("oscillator_") && found.contains("two_wells_step_Chin4A("), "{found}");
    assert!(found.contains("/* No tangent with Chin4A: "), "{found}");
}

/// Constants of modules and of types, and remainders.
#[test]
fn constants_are_those_of_the_type() {
    let constants = "
const PI: f64 = std::f64::consts::PI;
const G: f64 = 2.0 * PI;
impl Other { const K: f64 = 1.0; }
pub struct Other;
";
    let own = OSCILLATOR.replace("impl Oscillator {", "impl Oscillator {\n    const K: f64 = 3.0 * G;");
    let text = [constants, &own.replace("self.stiffness", "Self::K * (self.stiffness % 0.7)")].concat();
    let found = answer(&["export", "--c", &file("constants.rs", &text)]);
    for part in ["(3.0 * (2.0 * 3.141592653589793))", "fmod(parameters->stiffness, 0.7)"] {
        assert!(found.contains(part), "lacks {part}: {found}");
    }
    // A circle, which is no Rust, and two constants in different modules.
    for constants in
        ["const G: f64 = F; const F: f64 = G;", "mod a { const G: f64 = 1.0; } mod b { const G: f64 = 2.0; }"]
    {
        let found = refusal(&[
            "export",
            "--c",
            &file("circle.rs", [constants, &own.replace("self.stiffness", "Self::K")].concat()),
        ]);
        assert!(found.starts_with("error: `export` has no C code for the parameter expression `"), "{found}");
    }
    // Nothing overflows the stack.
    let deep = format!("const D: f64 = {}1.0{};", "(".repeat(5_000), ")".repeat(5_000));
    assert_eq!(answer(&["export", "--c", &file("deep.rs", [&deep, OSCILLATOR].concat())]).matches("#endif").count(), 2);
}
