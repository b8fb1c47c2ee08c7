//! Messages about parameters that derivatives are taken by.

use crate::{Row, check};

const KINETIC: &str = "fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] / (2.0 * self.mass) }";

/// Annotations, where the potential reads `self.mass`, `self.length` and `self.list`.
const ANNOTATIONS: &[Row] = &[
    ("sensitive(mass, length)", &[]),
    ("sensitive(mass,)", &[]),
    (
        "sensitive",
        &[
            "1:0 `sensitive` requires the names of fields in parentheses\nhelp: write, for example, `sensitive(mass, length)`",
        ],
    ),
    (
        "sensitive()",
        &[
            "1:0 `sensitive` requires the names of fields in parentheses\nhelp: write, for example, `sensitive(mass, length)`",
        ],
    ),
    (
        "sensitive(self.mass)",
        &[
            "1:10 `sensitive` requires the names of fields in parentheses\nhelp: write, for example, `sensitive(mass, length)`",
        ],
    ),
    ("sensitive(mass, mass)", &["1:16 `mass` is named twice"]),
    ("sensitive(mass), sensitive(length)", &["1:17 `sensitive` is given twice"]),
    ("sensitive(weight)", &["1:10 H does not depend on `self.weight`\nhelp: leave it out"]),
    (
        "sensitive(list)",
        &[
            "1:10 `list` has several numbers, and `sensitive` supports single numbers\nhelp: name fields that are one number each",
        ],
    ),
    (
        "sensitive(mass), split = symmetric(omega = 20.0)",
        &[
            "1:10 `split = symmetric` does not support `sensitive`\nhelp: write `split = none` with `compose = GaussLegendre4`, or leave out `sensitive`\nnote: two coupled copies of the state have no tangent map",
        ],
    ),
];

/// What the potential is made of, with `sensitive(length)`.
const BODIES: &[Row] = &[
    ("self.length.powi(2) * self.helped() * q[0].cos()", &[]),
    ("let Self { length, .. } = self; (if *length > 1.0 { *length } else { 1.0 }) * q[0].cos()", &[]),
    ("Self::other(self.length) * q[0].cos()", &[]),
    (
        "(match self.length as u32 { 0 => 1.0, _ => 2.0 }) * q[0].cos()",
        &[
            "2:12 this expression has no derivative with respect to `length`\nnote: supported are arithmetic, methods of `f64`, `let`, `if` and helper methods of this impl",
        ],
    ),
    (
        "f64::from(self.count(self.length as usize)) * q[0].cos()",
        &["2:21 an `f64` cannot be cast here\nnote: energies are computed in `f64`"],
    ),
    (
        "self.elsewhere() * q[0].cos()",
        &[
            "2:5 this call may read `self.length`, and its derivative is not known\nhelp: pass the fields that it needs, or move it into this impl as a helper method",
        ],
    ),
    (
        "outside(self) * q[0].cos()",
        &[
            "2:8 this call may read `self.length`, and its derivative is not known\nhelp: pass the fields that it needs, or move it into this impl as a helper method",
        ],
    ),
    ("self.counted() * q[0].cos() * self.length", &[]),
    (
        "self.length[0] * q[0].cos()",
        &[
            "1:10 `length` has several numbers, and `sensitive` supports single numbers\nhelp: name fields that are one number each",
        ],
    ),
    (
        "q.iter().zip(&self.length).map(|(x, m)| m * x * x).sum()",
        &[
            "1:10 `length` has several numbers, and `sensitive` supports single numbers\nhelp: name fields that are one number each",
        ],
    ),
    (
        "q.iter().zip(self.length.iter()).map(|(x, m)| m * x * x).sum()",
        &[
            "1:10 `length` has several numbers, and `sensitive` supports single numbers\nhelp: name fields that are one number each",
        ],
    ),
    (
        "let mut v = 0.0; for m in &self.length { v += m * q[0]; } v",
        &[
            "1:10 `length` has several numbers, and `sensitive` supports single numbers\nhelp: name fields that are one number each",
        ],
    ),
    (
        "let mut v = 0.0; for m in self.length.iter() { v += m * q[0]; } v",
        &[
            "1:10 `length` has several numbers, and `sensitive` supports single numbers\nhelp: name fields that are one number each",
        ],
    ),
    (
        "let mut v = 0.0; for i in 0..self.length.len() { v += self.length[i] * q[0]; } v",
        &[
            "1:10 `length` has several numbers, and `sensitive` supports single numbers\nhelp: name fields that are one number each",
        ],
    ),
    (
        "let mut v = 0.0; for (i, m) in self.length.iter().enumerate() { v += m * q[i]; } v",
        &[
            "1:10 `length` has several numbers, and `sensitive` supports single numbers\nhelp: name fields that are one number each",
        ],
    ),
    (
        "self.length.iter().sum::<f64>() * q[0]",
        &[
            "1:10 `length` has several numbers, and `sensitive` supports single numbers\nhelp: name fields that are one number each",
        ],
    ),
    (
        "let m = &self.length; m[0] * q[0]",
        &[
            "2:22 `length` has several numbers, and `sensitive` supports single numbers\nhelp: name fields that are one number each",
        ],
    ),
    (
        "let m = self.length[0]; m * q[0]",
        &[
            "1:10 `length` has several numbers, and `sensitive` supports single numbers\nhelp: name fields that are one number each",
        ],
    ),
    (
        "let Self { length, .. } = self; length[0] * q[0]",
        &[
            "2:32 `length` has several numbers, and `sensitive` supports single numbers\nhelp: name fields that are one number each",
        ],
    ),
    (
        "self.length.len() as f64 * q[0]",
        &[
            "1:10 `length` has several numbers, and `sensitive` supports single numbers\nhelp: name fields that are one number each",
        ],
    ),
    (
        "let [a, b] = self.length; a * b * q[0]",
        &[
            "2:4 `length` has several numbers, and `sensitive` supports single numbers\nhelp: name fields that are one number each",
        ],
    ),
    (
        "(0..1).map(|i| self.length[i] * q[i]).sum()",
        &[
            "1:10 `length` has several numbers, and `sensitive` supports single numbers\nhelp: name fields that are one number each",
        ],
    ),
    (
        "let Self { length: [a, b], .. } = self; a * b * q[0]",
        &[
            "2:19 `length` has several numbers, and `sensitive` supports single numbers\nhelp: name fields that are one number each",
        ],
    ),
    (
        "self.length.0 * q[0]",
        &[
            "2:12 `length` has several numbers, and `sensitive` supports single numbers\nhelp: name fields that are one number each",
        ],
    ),
    (
        "self.length.x * q[0]",
        &[
            "2:12 `length` has several numbers, and `sensitive` supports single numbers\nhelp: name fields that are one number each",
        ],
    ),
    (
        "self.length.first().unwrap() * q[0]",
        &[
            "1:10 `length` has several numbers, and `sensitive` supports single numbers\nhelp: name fields that are one number each",
        ],
    ),
    (
        "self.length.get(0).unwrap() * q[0]",
        &[
            "1:10 `length` has several numbers, and `sensitive` supports single numbers\nhelp: name fields that are one number each",
        ],
    ),
    (
        "self.well(q[0]) * self.length",
        &[
            "4:24 the derivatives of `well` with respect to parameters are not known\nhelp: pass what it reads as an argument\nnote: it has a stated derivative, with respect to its arguments only",
            "4:80 the derivatives of `slope` with respect to parameters are not known\nhelp: pass what it reads as an argument\nnote: it has a stated derivative, with respect to its arguments only",
        ],
    ),
];

/// Parts of which some are solved.
const PARTS: &[Row] = &[
    (
        "fn hamiltonian(&self, [q]: [f64; 1], [p]: [f64; 1]) -> f64 { (p * p + self.length * q * q) / 2.0 + q * q * q }",
        &[
            "1:36 the exact flow of `quadratic` has no derivative with respect to `self.length`\nhelp: split H into T(p) and V(q), or write `split = none`",
        ],
    ),
    (
        "fn hamiltonian(&self, [q]: [f64; 1], [p]: [f64; 1]) -> f64 { (p * p + q * q) / 2.0 + self.length * q * q * q }",
        &[],
    ),
];

#[test]
fn annotations_with_parameters() {
    check(ANNOTATIONS, |text| {
        let functions = match text.contains("split") {
            true => "fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { p[0] * p[0] * q[0] * q[0] / self.mass }"
                .to_owned(),
            false => format!(
                "{KINETIC} fn potential(&self, q: [f64; 1]) -> f64 {{ self.length * self.list[1] * q[0].cos() }}"
            ),
        };
        (text.to_owned(), format!("impl System {{\n{functions}\n}}"))
    });
}

/// The potential begins on line 2.
#[test]
fn values_computed_from_parameters() {
    check(BODIES, |text| {
        let item = format!(
            "impl System {{ {KINETIC} fn potential(&self, q: [f64; 1]) -> f64 {{\n{text}\n}} \
             fn helped(&self) -> f64 {{ 1.0 / self.length }} fn other(x: f64) -> f64 {{ x * x }} \
             fn counted(&self) -> f64 {{ self.list.iter().sum::<f64>() }}\n\
             #[derivative(slope)] fn well(&self, x: f64) -> f64 {{ self.length * x.cos() }} \
             fn slope(&self, x: f64) -> f64 {{ -self.length * x.sin() }} }}"
        );
        ("sensitive(length)".to_owned(), item)
    });
}

#[test]
fn parts_with_parameters() {
    check(PARTS, |text| {
        ("split = quadratic + rest, sensitive(length)".to_owned(), format!("impl System {{\n{text}\n}}"))
    });
    let functions = "fn kinetic(&self, p: [[f64; 2]; 4]) -> f64 { (0..4).map(|i| (p[i][0].powi(2) + p[i][1].powi(2)) \
                     / (2.0 * self.mass[i])).sum() } fn potential(&self, q: [[f64; 2]; 4]) -> f64 { let mut v = 0.0; \
                     for i in 0..4 { for j in 0..i { let [x, y] = [q[i][0] - q[j][0], q[i][1] - q[j][1]]; v -= self.g * \
                     self.mass[i] * self.mass[j] / (x * x + y * y).sqrt(); } } v }";
    check(
        &[(
            "coordinates = jacobi(self.mass), split = kepler + interaction, sensitive(g)",
            &[
                "1:14 Jacobi coordinates do not support `sensitive`\nhelp: leave out `coordinates` and `split`, or `sensitive`\nnote: the coordinates depend on the masses",
            ],
        )],
        |text| (text.to_owned(), format!("impl System {{\n{functions}\n}}")),
    );
}
