//! Messages about coordinates of Jacobi.

use crate::{Row, check};

const KINETIC: &str = "fn kinetic(&self, p: [[f64; 2]; 4]) -> f64 { (0..4).map(|i| (p[i][0].powi(2) + p[i][1].powi(2)) \
                       / (2.0 * self.mass[i])).sum() }";

const POTENTIAL: &str = "fn potential(&self, q: [[f64; 2]; 4]) -> f64 { let mut v = 0.0; for i in 0..4 { for j in 0..i { \
                         let [x, y] = [q[i][0] - q[j][0], q[i][1] - q[j][1]]; v -= self.g * self.mass[i] * self.mass[j] \
                         / (x * x + y * y).sqrt(); } } v }";

/// Annotations of bodies that attract each other.
const ANNOTATIONS: &[Row] = &[
    ("coordinates = jacobi(self.mass), split = kepler + interaction", &[]),
    ("split = kepler + interaction, coordinates = jacobi(self.sun.masses()), compose = Chin4A", &[]),
    (
        "coordinates = jacobi, split = kepler + interaction",
        &["1:14 `jacobi` lacks the list of masses\nhelp: write, for example, `jacobi(self.mass)`"],
    ),
    (
        "coordinates = jacobi(), split = kepler + interaction",
        &["1:14 `jacobi` lacks the list of masses\nhelp: write, for example, `jacobi(self.mass)`"],
    ),
    (
        "coordinates = heliocentric(self.mass)",
        &[
            "1:14 these coordinates are not supported\nhelp: write `coordinates = jacobi(self.mass)`, with the list of masses",
        ],
    ),
    ("coordinates = jacobi(self.mass), coordinates = jacobi(self.mass)", &["1:33 `coordinates` is given twice"]),
    (
        "coordinates = jacobi(self.mass)",
        &[
            "1:14 Jacobi coordinates require the parts `kepler` and `interaction`\nhelp: write `split = kepler + interaction`\nnote: these are the Kepler motion of each body and the rest of V",
        ],
    ),
    (
        "coordinates = jacobi(self.mass), split = interaction + kepler",
        &[
            "1:41 Jacobi coordinates require the parts `kepler` and `interaction`\nhelp: write `split = kepler + interaction`\nnote: these are the Kepler motion of each body and the rest of V",
        ],
    ),
    (
        "coordinates = jacobi(self.mass), split = kepler + interaction + tides",
        &[
            "1:64 Jacobi coordinates require the parts `kepler` and `interaction`\nhelp: write `split = kepler + interaction`\nnote: these are the Kepler motion of each body and the rest of V",
        ],
    ),
];

/// Functions without such coordinates.
const FUNCTIONS: &[Row] = &[
    (
        "fn kinetic(&self, p: [f64; 2]) -> f64 { p[0] * p[0] + p[1] * p[1] }\nfn potential(&self, q: [f64; 2]) -> f64 { 1.0 / (q[0] - q[1]).abs() }",
        &[
            "3:13 Jacobi coordinates require the positions of at least two bodies, and these are `[f64; 2]`\nhelp: write `[[f64; 3]; N]`, with a literal in place of 3",
        ],
    ),
    (
        "KINETIC fn potential(&self, q: [[f64; 2]; 4]) -> f64 { q[0][0].cos() }",
        &[
            "3:3 Jacobi coordinates require V as a sum over all pairs of bodies\nhelp: write a loop over `i` and one over `j` in `0..i`, with the term `-G m[i] m[j] / |q[i] - q[j]|` of each pair\nnote: further terms may belong to each pair, to each body, or to the first body and each other one",
        ],
    ),
    (
        "KINETIC fn potential(&self, q: [[f64; 2]; 4]) -> f64 { let mut v = 0.0; for i in 0..4 { for j in 0..i { v += (q[i][0] - q[j][0]).powi(2) + (q[i][1] - q[j][1]).powi(2); } } v }",
        &[
            "3:3 Jacobi coordinates require the term `-G m[i] m[j] / |q[i] - q[j]|` of each pair in V\nhelp: write it as a separate term, with the distance as the root of a sum of squares or by `hypot`\nnote: the Kepler part consists of these terms",
        ],
    ),
    (
        "KINETIC fn potential(&self, q: [[f64; 2]; 4]) -> f64 { let mut v = 0.0; for i in 0..4 { for j in 0..i { v -= self.g / ((q[i][0] - q[j][0]).powi(2) + (q[i][1] - q[j][1]).powi(2) + self.soft).sqrt(); } } v }",
        &[
            "3:171 Jacobi coordinates do not support a softened distance of two bodies\nhelp: leave out the softening, or `coordinates` and `split`\nnote: Kepler's equation solves the potential `-G m[i] m[j] / r`",
        ],
    ),
    (
        "KINETIC fn potential(&self, q: [[f64; 2]; 4]) -> f64 { let mut v = 0.0; for i in 0..4 { for j in 0..i { v -= self.g / ((q[i][0] - q[j][0]).powi(2) + 2.0 * (q[i][1] - q[j][1]).powi(2)).sqrt(); } } v }",
        &[
            "3:3 Jacobi coordinates require the term `-G m[i] m[j] / |q[i] - q[j]|` of each pair in V\nhelp: write it as a separate term, with the distance as the root of a sum of squares or by `hypot`\nnote: the Kepler part consists of these terms",
        ],
    ),
    (
        "fn kinetic(&self, p: [[f64; 2]; 4]) -> f64 { (0..4).map(|i| (p[i][0].powi(2) + p[i][1].powi(2) + self.mass[i]).sqrt()).sum() }\nPOTENTIAL",
        &[
            "2:3 Jacobi coordinates require T = Σ |p[i]|² / 2m[i]\nhelp: write a loop over all bodies `i` that sums all components of `p[i]`",
        ],
    ),
    (
        "KINETIC fn potential(&self, q: [[f64; 2]; 4]) -> f64 { let mut v = 0.0; for i in 0..3 { for j in i + 1..4 { let mut r2 = self.eps * self.eps; for d in 0..2 { r2 += (q[i][d] - q[j][d]).powi(2); } v -= self.mass[i] * self.mass[j] / r2.sqrt(); } } v }",
        &[
            "3:113 Jacobi coordinates do not support a softened distance of two bodies\nhelp: leave out the softening, or `coordinates` and `split`\nnote: Kepler's equation solves the potential `-G m[i] m[j] / r`",
        ],
    ),
    (
        "KINETIC fn potential(&self, q: [[f64; 2]; 4]) -> f64 { let mut v = 0.0; for i in 0..4 { for j in i..4 { v -= self.g / (q[i][0] - q[j][0]).hypot(q[i][1] - q[j][1]); } } v }",
        &[
            "3:3 Jacobi coordinates require V as a sum over all pairs of bodies\nhelp: write a loop over `i` and one over `j` in `0..i`, with the term `-G m[i] m[j] / |q[i] - q[j]|` of each pair\nnote: further terms may belong to each pair, to each body, or to the first body and each other one",
        ],
    ),
    (
        "KINETIC fn potential(&self, q: [[f64; 2]; 4]) -> f64 { let mut v = 0.0; for i in 0..4 { for j in 0..4 { v -= self.g / (q[i][0] - q[j][0]).hypot(q[i][1] - q[j][1]); } } v }",
        &[
            "3:3 Jacobi coordinates require V as a sum over all pairs of bodies\nhelp: write a loop over `i` and one over `j` in `0..i`, with the term `-G m[i] m[j] / |q[i] - q[j]|` of each pair\nnote: further terms may belong to each pair, to each body, or to the first body and each other one",
        ],
    ),
    (
        "KINETIC fn potential(&self, q: [[f64; 2]; 4]) -> f64 { let mut v = 0.0; for i in 0..4 { for j in 0..i { v -= self.g / (q[i][0] - q[j][0]).hypot(q[i][1] - q[j][1]); } } v + self.g * q[2][0] }",
        &[
            "3:3 Jacobi coordinates require V as a sum over all pairs of bodies\nhelp: write a loop over `i` and one over `j` in `0..i`, with the term `-G m[i] m[j] / |q[i] - q[j]|` of each pair\nnote: further terms may belong to each pair, to each body, or to the first body and each other one",
        ],
    ),
    (
        "KINETIC fn potential(&self, q: [[f64; 2]; 4]) -> f64 { let mut v = 0.0; for i in 0..4 { for j in 0..i { v -= self.g * self.mass[i] / (q[i][0] - q[j][0]).hypot(q[i][1] - q[j][1]); } } v }",
        &[
            "3:3 Jacobi coordinates require V as a sum over all pairs of bodies\nhelp: write a loop over `i` and one over `j` in `0..i`, with the term `-G m[i] m[j] / |q[i] - q[j]|` of each pair\nnote: further terms may belong to each pair, to each body, or to the first body and each other one",
        ],
    ),
];

#[test]
fn annotations_of_jacobi_coordinates() {
    check(ANNOTATIONS, |text| (text.to_owned(), format!("impl System {{ {KINETIC} {POTENTIAL} }}")));
}

#[test]
fn functions_without_jacobi_coordinates() {
    check(FUNCTIONS, |text| {
        let functions = text.replace("KINETIC ", &format!("{KINETIC}\n")).replace("POTENTIAL", POTENTIAL);
        let arguments = "coordinates = jacobi(self.mass), split = kepler + interaction";
        (arguments.to_owned(), format!("impl System {{\n{functions} }}"))
    });
}
