//! Layouts that are requested: each word with a system that has it, and the reason where a system does not.

use crate::{Row, check, errors};

const POINTS: &str = "fn kinetic(&self, p: &[[f64; 3]]) -> f64 { p.iter().flatten().map(|p| 0.5 * p * p).sum() }
fn potential(&self, q: &[[f64; 3]]) -> f64 { let mut v = 0.0; BODY v }";
const NUMBERS: &str = "fn kinetic(&self, p: &[f64]) -> f64 { p.iter().map(|p| 0.5 * p * p).sum() }
fn potential(&self, q: &[f64]) -> f64 { let mut v = 0.0; BODY v }";
const ROWS: &str = "fn kinetic(&self, p: &[[f64; 16]]) -> f64 { p.iter().flatten().map(|p| 0.5 * p * p).sum() }
fn potential(&self, q: &[[f64; 16]]) -> f64 { let mut v = 0.0; BODY v }";
const PLANES: &str =
    "fn kinetic(&self, p: &[[[f64; 16]; 16]]) -> f64 { p.iter().flatten().flatten().map(|p| 0.5 * p * p).sum() }
fn potential(&self, q: &[[[f64; 16]; 16]]) -> f64 { let mut v = 0.0; BODY v }";
const FOUR: &str = "fn kinetic(&self, p: [[f64; 3]; 4]) -> f64 { p.iter().flatten().map(|p| 0.5 * p * p).sum() }
fn potential(&self, q: [[f64; 3]; 4]) -> f64 { let mut v = 0.0; BODY v }";
const MANY: &str = "fn kinetic(&self, p: [[f64; 3]; 100]) -> f64 { p.iter().flatten().map(|p| 0.5 * p * p).sum() }
fn potential(&self, q: [[f64; 3]; 100]) -> f64 { let mut v = 0.0; BODY v }";

/// The functions of an impl; `PAIR` is what the energy of a pair adds, with its squared distance.
fn functions(shape: &str, body: &str) -> String {
    let pair = "for i in 0..q.len() { for j in 0..i { let r2: f64 = (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum(); \
                PAIR } }";
    let shape = match shape {
        "points" => POINTS,
        "rows" => ROWS,
        "planes" => PLANES,
        "four" => FOUR,
        "many" => MANY,
        _ => NUMBERS,
    };
    let body = match body.strip_prefix("pair ") {
        Some(energy) => pair.replace("PAIR", energy),
        None => body.to_owned(),
    };
    shape.replace("BODY", &body)
}

fn impl_of(text: &str) -> (String, String) {
    let (word, rest) = text.split_once(": ").expect("a word");
    let (shape, body) = rest.split_once(": ").expect("a shape and a body");
    (format!("layout = {word}"), format!("impl System {{ {} }}", functions(shape, body)))
}

#[test]
fn every_word_accepts_the_layout_that_it_names() {
    let accepted = [
        "plain: numbers: v = q[0] * q[1];",
        "lanes: numbers: for i in 0..q.len() { for j in 0..q.len() { v += self.k[i][j] * q[i] * q[j]; } }",
        "terms: numbers: for &(a, b) in &self.bonds { v += (q[a] - q[b]).powi(4); }",
        "line: numbers: for i in 0..q.len() - 1 { v += (q[i + 1] - q[i]).powi(4); }",
        "plane: rows: for i in 0..q.len() - 1 { for j in 0..16 { v += (q[i + 1][j] - q[i][j]).powi(4); } }",
        "volume: planes: for i in 0..q.len() - 1 { for j in 0..16 { for k in 0..16 { \
         v += (q[i + 1][j][k] - q[i][j][k]).powi(4); } } }",
        "row: four: pair v += (-r2).exp();",
        "pairs: points: pair v += (-r2).exp();",
        "lists: points: pair if r2 < 1.0 { v += (1.0 - r2).powi(2); }",
        "lists: points: for i in 0..q.len() { for j in 0..i { let r2: f64 = (0..3).map(|d| { let x = q[i][d] - q[j][d]; \
         (x - 9.0 * (x / 9.0).round()).powi(2) }).sum(); if r2 < 1.0 { v += (1.0 - r2).powi(2); } } }",
    ];
    for text in accepted {
        let (arguments, item) = impl_of(text);
        assert_eq!(errors(&arguments, &item), [""; 0], "{text}");
        // Another word is refused, so that the check above can fail.
        let other = if arguments == "layout = plain" { "layout = lists" } else { "layout = plain" };
        assert_eq!(errors(other, &item).len(), 1, "{text}");
    }
}

#[test]
fn lost_layouts_are_explained() {
    check(REASONS, impl_of);
}

#[test]
fn layouts_of_parts_and_of_whole_systems() {
    check(PARTS, |text| {
        let (arguments, functions) = text.split_once(" on ").expect("an annotation and functions");
        (arguments.to_owned(), format!("impl System {{ {functions} }}"))
    });
}

const REASONS: &[Row] = &[
    (
        "lists: points: pair v += (-r2).exp();",
        &[
            "1:9 the kick has the layout `pairs` instead of `lists`\nhelp: write the energy of a pair inside of `if square < self.cutoff.powi(2) { .. }`, or `layout = pairs`\nnote: no condition on the distance of two bodies makes the energy of a pair zero",
        ],
    ),
    (
        "lists: points: pair if r2 + q[i][0] * q[j][0] < 1.0 { v += (-r2).exp(); }",
        &[
            "1:9 the kick has the layout `pairs` instead of `lists`\nhelp: write `square < self.cutoff.powi(2)`, where `square` is the squared distance, or `layout = pairs`\nnote: a condition of a pair compares more than the distance of its bodies",
        ],
    ),
    (
        "lists: points: pair if (q[i][0] - q[j][0]).abs() < 1.0 { v += (-r2).exp(); }",
        &[
            "1:9 the kick has the layout `pairs` instead of `lists`\nhelp: write the sum of squares over all coordinates, or `layout = pairs`\nnote: the condition of a pair does not compare all coordinates of the displacement",
        ],
    ),
    (
        "lists: points: pair if r2 < 1.0 { v += (-r2).exp(); } v += r2;",
        &[
            "1:9 the kick has the layout `pairs` instead of `lists`\nhelp: write all terms of a pair inside of `if square < self.cutoff.powi(2) { .. }`, or `layout = pairs`\nnote: a term of a pair is outside of the condition on the distance",
        ],
    ),
    (
        "lists: points: pair if r2 < (self.field[i] + self.field[j]).exp() { v += (-r2).exp(); }",
        &[
            "1:9 the kick has the layout `pairs` instead of `lists`\nhelp: write a cutoff by sums, products, powers, `max` and `min` of parameters of each body, or `layout = pairs`\nnote: the macro finds no greatest value of the cutoff over all pairs",
        ],
    ),
    (
        "lists: points: pair v += self.table[i][j] * r2;",
        &[
            "1:9 the kick has the layout `lanes` instead of `lists`\nhelp: write a list for each body such as `self.mass[i]`, or a table by type such as `self.table[self.kind[i]][self.kind[j]]`, or `layout = lanes`\nnote: the energy of a pair reads other bodies, or a parameter or condition of both bodies at once",
        ],
    ),
    (
        "lists: points: pair v += q[i][0] * r2;",
        &[
            "1:9 the kick has the layout `lanes` instead of `lists`\nhelp: write an energy of the distance and of parameters of one body each, or `layout = lanes`\nnote: the macro cannot prove that exchanging the two bodies of a pair keeps its energy",
        ],
    ),
    (
        "lists: points: for i in 0..q.len() { v += q[i][0].powi(4); }",
        &[
            "1:9 the kick has the layout `lanes` instead of `lists`\nhelp: write `for i in 0..q.len() { for j in 0..i { .. } }`, or `layout = lanes`\nnote: no addend of V is a sum over the pairs of bodies in two nested loops",
        ],
    ),
    (
        "lists: many: pair if r2 < 1.0 { v += (-r2).exp(); }",
        &[
            "1:9 the kick has the layout `pairs` instead of `lists`\nhelp: write a slice such as `q: &[[f64; 3]]`, or `layout = pairs`\nnote: there are fewer than 384 bodies, by the type of `q`",
        ],
    ),
    (
        "lists: four: pair if r2 < 1.0 { v += (-r2).exp(); }",
        &[
            "1:9 the kick has the layout `row` instead of `lists`\nhelp: write a slice such as `q: &[[f64; 3]]`, or `layout = row`\nnote: there are fewer than 384 bodies, by the type of `q`",
        ],
    ),
    (
        "pairs: points: pair if r2 < 1.0 { v += (-r2).exp(); }",
        &["1:9 the kick has the layout `lists` instead of `pairs`\nhelp: write `layout = lists`"],
    ),
    (
        "pairs: points: for i in 0..q.len() { for j in 0..q.len() { v += (q[i][0] - q[j][0]).exp(); } }",
        &[
            "1:9 the kick has the layout `lanes` instead of `pairs`\nhelp: write `for j in 0..i`, or `if i != j`, or `layout = lanes`\nnote: the loops over `i` and `j` include the pair of a body with itself",
        ],
    ),
    (
        "row: points: pair v += (-r2).exp();",
        &[
            "1:9 the kick has the layout `pairs` instead of `row`\nhelp: write `layout = pairs`\nnote: a row has at most 8 bodies, and their number is in the type of `q`",
        ],
    ),
    (
        "pairs: four: pair v += (-r2).exp();",
        &[
            "1:9 the kick has the layout `row` instead of `pairs`\nhelp: write `layout = row`\nnote: at most 8 bodies are one row",
        ],
    ),
    (
        "plane: numbers: for i in 0..q.len() - 1 { v += (q[i + 1] - q[i]).powi(4); }",
        &[
            "1:9 the kick has the layout `line` instead of `plane`\nhelp: write `q: &[[f64; 64]]` for a plane, or `layout = line`\nnote: `q` has one index, as the sites of a line",
        ],
    ),
    (
        "line: numbers: for i in 0..q.len() - 5 { v += (q[i + 5] - q[i]).powi(4); }",
        &[
            "1:9 the kick has the layout `plain` instead of `line`\nhelp: write `layout = plain`\nnote: a site acts on another one that is more than 2 sites, 1 row or 1 plane away",
        ],
    ),
    (
        "line: numbers: for i in 0..q.len() - 1 { if i % 2 == 0 { v += (q[i + 1] - q[i]).powi(4); } }",
        &[
            "1:9 the kick has the layout `plain` instead of `line`\nhelp: write a condition such as `i + 1 < q.len()`, or a factor from a list such as `self.weight[i]`, or `layout = plain`\nnote: a condition on the index of a site does not select a range of sites",
        ],
    ),
    (
        "line: rows: for i in 0..q.len() - 1 { for j in 0..16 { v += (q[i + 1][j] - q[i][j]).powi(4); } }",
        &[
            "1:9 the kick has the layout `plane` instead of `line`\nhelp: write `q: &[f64]` for a line, or `q: &[[[f64; 64]; 64]]` for a volume, or `layout = plane`\nnote: `q` has two indices, as the sites of a plane",
        ],
    ),
    (
        "line: numbers: for i in 0..self.n { v += (q[i + 1] - q[i]).powi(4); }",
        &[
            "1:9 the kick has the layout `plain` instead of `line`\nhelp: write a range such as `0..q.len() - 1`, or `layout = plain`\nnote: a loop over sites does not begin and end at fixed distances from the ends of `q`",
        ],
    ),
    (
        "terms: numbers: for &(a, b) in &self.bonds { v += (q[a + 1] - q[b]).powi(4); }",
        &[
            "1:9 the kick has the layout `plain` instead of `terms`\nhelp: write a list that contains every index, or `layout = plain`\nnote: a term reads a coordinate at an index that is not in the list, such as `q[a + 1]`",
        ],
    ),
    (
        "terms: numbers: for i in 0..q.len() { v += q[i].powi(4); }",
        &[
            "1:9 the kick has the layout `line` instead of `terms`\nhelp: write `for &(i, j) in &self.bonds { .. }`, or `layout = line`\nnote: V has no loop over a list that names coordinates",
        ],
    ),
    (
        "lanes: numbers: for i in 0..q.len() - 5 { v += (q[i + 5] - q[i]).powi(4); }",
        &[
            "1:9 the kick has the layout `plain` instead of `lanes`\nhelp: write `layout = plain`\nnote: an iteration adds to the gradient of two coordinates",
        ],
    ),
    (
        "lanes: numbers: v += q[0] * q[1];",
        &[
            "1:9 the kick has the layout `plain` instead of `lanes`\nhelp: write `for i in 0..q.len() { .. }`, or `layout = plain`\nnote: V has no innermost loop over coordinates or data",
        ],
    ),
    (
        "plain: numbers: for i in 0..q.len() - 1 { v += (q[i + 1] - q[i]).powi(4); }",
        &["1:9 the kick has the layout `line` instead of `plain`\nhelp: write `layout = line`"],
    ),
    (
        "list: numbers: v += q[0];",
        &[
            "1:9 unknown layout `list`\nhelp: write `layout = lists` or `layout = line`\nnote: the layouts are `plain`, `lanes`, `terms`, `line`, `plane`, `volume`, `row`, `pairs`, `lists`, `triplets`",
        ],
    ),
    (
        "neighbours: numbers: v += q[0];",
        &[
            "1:9 unknown layout `neighbours`\nnote: the layouts are `plain`, `lanes`, `terms`, `line`, `plane`, `volume`, `row`, `pairs`, `lists`, `triplets`",
        ],
    ),
];

const PARTS: &[Row] = &[
    ("layout = lists, split = none on fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { q[0] * p[0] }", &["1:9 `split = none` has no kick, whose layout could be checked\nhelp: leave out `layout`"]),
    (
        "layout = line, split = symmetric(omega = 1.0) on fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { (q[0] * p[0]).exp() }",
        &["1:9 `split = symmetric` has no kick, whose layout could be checked\nhelp: leave out `layout`"],
    ),
    ("layout = on fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0] }", &["1:0 this argument lacks its value\nnote: the arguments are `compose = Yoshida4`, `compose = V(1/2) T(1) V(1/2)`, `order = 4`, `split = a + b`, `coordinates = jacobi(self.mass)`, `functions = fast`, `layout = lists`, `taylor`, `sensitive(mass, length)`, `gpu` and `crate = path::to::integrator_core`"]),
    ("layout = 3 on fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0] }", &["1:9 expected the name of a layout\nhelp: write, for example, `layout = lists`\nnote: the arguments are `compose = Yoshida4`, `compose = V(1/2) T(1) V(1/2)`, `order = 4`, `split = a + b`, `coordinates = jacobi(self.mass)`, `functions = fast`, `layout = lists`, `taylor`, `sensitive(mass, length)`, `gpu` and `crate = path::to::integrator_core`"]),
    (
        "layout = plain, layout = plain on fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn potential(&self, q: [f64; 1]) -> f64 { q[0] }",
        &["1:16 `layout` is given twice"],
    ),
    (
        "split = oscillator + pairs, layout = pairs on fn oscillator(&self, q: [f64; 12], p: [f64; 12]) -> f64 { p.iter().map(|p| p * p).sum::<f64>() + q.iter().map(|q| q * q).sum::<f64>() }
        fn pairs(&self, q: [f64; 12]) -> f64 { let mut v = 0.0; for i in 0..12 { for j in 0..i { v += (q[i] - q[j]).cos(); } } v }",
        &["1:37 no part of H has the layout `pairs`: `oscillator` has an exact flow of its own, `pairs` is `plain`\nhelp: write `kinetic` and `potential` without `split`\nnote: a part that `split` names is summed as written if there are fewer than 33 numbers in `q`"],
    ),
    (
        "split = oscillator + pairs, layout = lanes on fn oscillator(&self, q: &[f64], p: &[f64]) -> f64 { p.iter().map(|p| p * p).sum::<f64>() + q.iter().map(|q| q * q).sum::<f64>() }
        fn pairs(&self, q: &[f64]) -> f64 { let mut v = 0.0; for i in 0..q.len() { for j in 0..i { v += (q[i] - q[j]).cos(); } } v }",
        &["1:37 no part of H has the layout `lanes`: `oscillator` has an exact flow of its own, `pairs` is `pairs`\nhelp: write the energy of a pair inside of `if square < self.cutoff.powi(2) { .. }`\nnote: no condition on the distance of two bodies makes the energy of a pair zero"],
    ),
];

/// Terms that share others are searched once, not once for each path.
#[test]
fn a_cutoff_is_found_among_terms_that_share_others() {
    let shared: String = (1..60).map(|k| format!("let u = u * r2 + u * {k}.5 + self.c; ")).collect();
    let body = format!("pair let u = r2; {shared} v += u; if r2 < 1.0 {{ v += u; }}");
    let item = format!("impl System {{ {} }}", functions("points", &body));
    let found = errors("layout = lists", &item);
    assert!(found.len() == 1 && found[0].contains("a term of a pair is outside of the condition"), "{found:?}");
}
