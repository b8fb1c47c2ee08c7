//! Every message about friction.

use crate::{KINETIC, POTENTIAL, Row, check};

/// The annotation, and the functions beside `kinetic` and `potential`.
const ROWS: &[Row] = &[
    ("split = kinetic + potential + friction on #[friction] fn friction(&self, i: usize) -> f64 { self.gamma }", &[]),
    ("split = friction + kinetic + potential on #[friction] fn friction(&self, i: usize, t: f64) -> f64 { t }", &[]),
    (
        " on #[friction] fn drag(&self, _: usize) -> f64 { 1.0 } #[temperature] fn heat(&self, i: usize) -> f64 { 2.0 }",
        &[],
    ),
    ("compose = V(1/2) T(1/2) O(1) T(1/2) V(1/2) on #[friction] fn friction(&self, i: usize) -> f64 { 1.0 }", &[]),
    (
        "split = kinetic + potential on #[friction] fn friction(&self, i: usize) -> f64 { 1.0 }",
        &["2:15 `split` does not name the friction\nhelp: write `split = .. + friction`"],
    ),
    (
        "split = kinetic + potential + friction on fn friction(&self, i: usize) -> f64 { 1.0 }",
        &["1:30 `friction` is a function of an index\nhelp: annotate it with `#[friction]`"],
    ),
    (
        " on #[temperature] fn temperature(&self, i: usize) -> f64 { 1.0 }",
        &[
            "2:18 a temperature requires friction, whose noise it determines\nhelp: add `#[friction] fn friction(&self, i: usize) -> f64`",
        ],
    ),
    (
        " on #[friction] fn friction(&self) -> f64 { 1.0 }",
        &[
            "2:12 `#[friction]` requires a function of the index of a coordinate or a point, and optionally of the time\nhelp: write `fn friction(&self, i: usize) -> f64` or `fn friction(&self, i: usize, t: f64) -> f64`",
        ],
    ),
    (
        " on #[friction] fn friction(&self, q: [f64; 2]) -> f64 { q[0] }",
        &[
            "2:12 `#[friction]` requires a function of the index of a coordinate or a point, and optionally of the time\nhelp: write `fn friction(&self, i: usize) -> f64` or `fn friction(&self, i: usize, t: f64) -> f64`",
        ],
    ),
    (
        " on #[friction] fn friction(&self, i: usize) -> f32 { 1.0 }",
        &[
            "2:12 `#[friction]` requires a function of the index of a coordinate or a point, and optionally of the time\nhelp: write `fn friction(&self, i: usize) -> f64` or `fn friction(&self, i: usize, t: f64) -> f64`",
        ],
    ),
    (" on #[friction(2)] fn friction(&self, i: usize) -> f64 { 1.0 }", &["2:0 `#[friction]` takes no arguments"]),
    (
        " on #[friction] fn one(&self, i: usize) -> f64 { 1.0 } #[friction] fn two(&self, i: usize) -> f64 { 1.0 }",
        &["2:66 `one` is annotated with `#[friction]` already\nhelp: use one function"],
    ),
    (
        "compose = T(1/2) V(1) T(1/2) on #[friction] fn friction(&self, i: usize) -> f64 { 1.0 }",
        &[
            "1:10 this sequence does not apply the friction of the system\nhelp: add `O`, as in `V(1/2) T(1/2) O(1) T(1/2) V(1/2)`",
        ],
    ),
    (
        "compose = T(1/2) V(1) T(1/2) O(1) on ",
        &[
            "1:10 this sequence has friction `O`, and the system has none\nhelp: add `#[friction] fn friction(&self, i: usize) -> f64`, or leave out `O`",
        ],
    ),
    (
        "split = none on #[friction] fn friction(&self, i: usize) -> f64 { 1.0 }",
        &[
            "1:8 `split = none` requires H in one function\nhelp: write `fn hamiltonian(&self, q: [f64; N], p: [f64; N]) -> f64`\nnote: implicit methods integrate `kinetic` and `potential` without `split = none`",
        ],
    ),
    (
        "sensitive(gamma) on #[friction] fn friction(&self, i: usize) -> f64 { self.gamma }",
        &["1:10 `sensitive` does not support friction\nhelp: leave out one of them"],
    ),
    (
        "gpu on #[friction] fn friction(&self, i: usize) -> f64 { 1.0 }",
        &["1:0 `gpu` does not support friction\nhelp: leave out one of them"],
    ),
];

#[test]
fn friction() {
    check(ROWS, |text| {
        let (arguments, functions) = text.split_once(" on ").expect("an annotation and functions");
        (arguments.to_owned(), format!("impl System {{ {KINETIC} {POTENTIAL}\n{functions} }}"))
    });
    // A relativistic energy has no masses.
    let kinetic = "fn kinetic(&self, p: [f64; 2]) -> f64 { (1.0 + p[0] * p[0] + p[1] * p[1]).sqrt() }";
    let bath = "#[friction] fn friction(&self, i: usize) -> f64 { 1.0 }\n#[temperature] fn heat(&self, i: usize) -> f64 { 1.0 }";
    check(
        &[(
            bath,
            &[
                "2:18 a temperature requires T = Σ p²/(2m) with constant masses, but T has the term `sqrt(1 + p[0]^2 + p[1]^2)`\nhelp: leave out `#[temperature]`, or change T",
            ],
        )],
        |bath| (String::new(), format!("impl System {{ {kinetic} {POTENTIAL} {bath} }}")),
    );
}
