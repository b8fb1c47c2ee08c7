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
        &["1:14 `jacobi` lacks the list of masses, as in `jacobi(self.mass)`"],
    ),
    (
        "coordinates = jacobi(), split = kepler + interaction",
        &["1:14 `jacobi` lacks the list of masses, as in `jacobi(self.mass)`"],
    ),
    (
        "coordinates = heliocentric(self.mass)",
        &[
            "1:14 the coordinates of bodies may be those of Jacobi, made with the list of their masses, as in `coordinates = jacobi(self.mass)`",
        ],
    ),
    ("coordinates = jacobi(self.mass), coordinates = jacobi(self.mass)", &["1:33 `coordinates` is given twice"]),
    (
        "coordinates = jacobi(self.mass)",
        &[
            "1:14 in Jacobi coordinates H has two parts, the Kepler motion of each body and what is left of V: write `split = kepler + interaction`",
        ],
    ),
    (
        "coordinates = jacobi(self.mass), split = interaction + kepler",
        &[
            "1:41 in Jacobi coordinates H has two parts, the Kepler motion of each body and what is left of V: write `split = kepler + interaction`",
        ],
    ),
    (
        "coordinates = jacobi(self.mass), split = kepler + interaction + tides",
        &[
            "1:64 in Jacobi coordinates H has two parts, the Kepler motion of each body and what is left of V: write `split = kepler + interaction`",
        ],
    ),
];

/// Functions without such coordinates.
const FUNCTIONS: &[Row] = &[
    (
        "fn kinetic(&self, p: [f64; 2]) -> f64 { p[0] * p[0] + p[1] * p[1] }\nfn potential(&self, q: [f64; 2]) -> f64 { 1.0 / (q[0] - q[1]).abs() }",
        &[
            "3:13 Jacobi coordinates are made of the positions of bodies, `[[f64; 3]; N]` with a number for 3 and two bodies at least; these are `[f64; 2]`",
        ],
    ),
    (
        "KINETIC fn potential(&self, q: [[f64; 2]; 4]) -> f64 { q[0][0].cos() }",
        &[
            "3:3 V could not be read as a sum over all pairs of bodies, which Jacobi coordinates need: write one loop over `i` and one over `j` in `0..i`, with a term -G m[i] m[j] / |q[i] - q[j]| for each pair; other terms may be of each pair, of each body, or of the first body and each other one",
        ],
    ),
    (
        "KINETIC fn potential(&self, q: [[f64; 2]; 4]) -> f64 { let mut v = 0.0; for i in 0..4 { for j in 0..i { v += (q[i][0] - q[j][0]).powi(2) + (q[i][1] - q[j][1]).powi(2); } } v }",
        &[
            "3:3 no term -G m[i] m[j] / |q[i] - q[j]| of each pair of bodies was found in V, which Jacobi coordinates need for the Kepler part: write it as a term of its own, with the distance as a root of a sum of squares or by `hypot`",
        ],
    ),
    (
        "KINETIC fn potential(&self, q: [[f64; 2]; 4]) -> f64 { let mut v = 0.0; for i in 0..4 { for j in 0..i { v -= self.g / ((q[i][0] - q[j][0]).powi(2) + (q[i][1] - q[j][1]).powi(2) + self.soft).sqrt(); } } v }",
        &[
            "3:171 Kepler's equation solves -G m[i] m[j] / r, and this softens the distance `r` of two bodies: leave it out, or leave out `coordinates` and `split`",
        ],
    ),
    (
        "KINETIC fn potential(&self, q: [[f64; 2]; 4]) -> f64 { let mut v = 0.0; for i in 0..4 { for j in 0..i { v -= self.g / ((q[i][0] - q[j][0]).powi(2) + 2.0 * (q[i][1] - q[j][1]).powi(2)).sqrt(); } } v }",
        &[
            "3:3 no term -G m[i] m[j] / |q[i] - q[j]| of each pair of bodies was found in V, which Jacobi coordinates need for the Kepler part: write it as a term of its own, with the distance as a root of a sum of squares or by `hypot`",
        ],
    ),
    (
        "fn kinetic(&self, p: [[f64; 2]; 4]) -> f64 { (0..4).map(|i| (p[i][0].powi(2) + p[i][1].powi(2) + self.mass[i]).sqrt()).sum() }\nPOTENTIAL",
        &[
            "2:3 T could not be read as Σ |p[i]|² / 2m[i], which Jacobi coordinates need: write a loop over all bodies `i` with all components of `p[i]`",
        ],
    ),
    (
        "KINETIC fn potential(&self, q: [[f64; 2]; 4]) -> f64 { let mut v = 0.0; for i in 0..3 { for j in i + 1..4 { let mut r2 = self.eps * self.eps; for d in 0..2 { r2 += (q[i][d] - q[j][d]).powi(2); } v -= self.mass[i] * self.mass[j] / r2.sqrt(); } } v }",
        &[
            "3:113 Kepler's equation solves -G m[i] m[j] / r, and this softens the distance `r` of two bodies: leave it out, or leave out `coordinates` and `split`",
        ],
    ),
    (
        "KINETIC fn potential(&self, q: [[f64; 2]; 4]) -> f64 { let mut v = 0.0; for i in 0..4 { for j in i..4 { v -= self.g / (q[i][0] - q[j][0]).hypot(q[i][1] - q[j][1]); } } v }",
        &[
            "3:3 V could not be read as a sum over all pairs of bodies, which Jacobi coordinates need: write one loop over `i` and one over `j` in `0..i`, with a term -G m[i] m[j] / |q[i] - q[j]| for each pair; other terms may be of each pair, of each body, or of the first body and each other one",
        ],
    ),
    (
        "KINETIC fn potential(&self, q: [[f64; 2]; 4]) -> f64 { let mut v = 0.0; for i in 0..4 { for j in 0..4 { v -= self.g / (q[i][0] - q[j][0]).hypot(q[i][1] - q[j][1]); } } v }",
        &[
            "3:3 V could not be read as a sum over all pairs of bodies, which Jacobi coordinates need: write one loop over `i` and one over `j` in `0..i`, with a term -G m[i] m[j] / |q[i] - q[j]| for each pair; other terms may be of each pair, of each body, or of the first body and each other one",
        ],
    ),
    (
        "KINETIC fn potential(&self, q: [[f64; 2]; 4]) -> f64 { let mut v = 0.0; for i in 0..4 { for j in 0..i { v -= self.g / (q[i][0] - q[j][0]).hypot(q[i][1] - q[j][1]); } } v + self.g * q[2][0] }",
        &[
            "3:3 V could not be read as a sum over all pairs of bodies, which Jacobi coordinates need: write one loop over `i` and one over `j` in `0..i`, with a term -G m[i] m[j] / |q[i] - q[j]| for each pair; other terms may be of each pair, of each body, or of the first body and each other one",
        ],
    ),
    (
        "KINETIC fn potential(&self, q: [[f64; 2]; 4]) -> f64 { let mut v = 0.0; for i in 0..4 { for j in 0..i { v -= self.g * self.mass[i] / (q[i][0] - q[j][0]).hypot(q[i][1] - q[j][1]); } } v }",
        &[
            "3:3 V could not be read as a sum over all pairs of bodies, which Jacobi coordinates need: write one loop over `i` and one over `j` in `0..i`, with a term -G m[i] m[j] / |q[i] - q[j]| for each pair; other terms may be of each pair, of each body, or of the first body and each other one",
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
