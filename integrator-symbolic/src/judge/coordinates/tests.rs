//! Tests of the canonical form of body energies: equal values, and the terms from which Jacobi coordinates are built.

use super::*;
use crate::graph::evaluate::Point;
use std::collections::HashMap;
use syn::{BinOp, Expr, Lit, Member, Stmt, UnOp};

/// Spellings of T: the sum of |p[i]|² / 2m[i].
const KINETIC: &[&str] = &[
    "for i in 0..N { for d in 0..3 { e += p[i][d] * p[i][d] / (2.0 * self.mass[i]); } } e",
    "for d in 0..3 { for i in 0..N { e += p[i][d] * p[i][d] / (2.0 * self.mass[i]); } } e",
    "for d in 0..3 { for i in 0..N { e += p[i][d].powi(2) / self.mass[i] / 2.0; } } e",
    "for i in 0..N { for x in p[i] { e += 0.5 * x * x / self.mass[i]; } } e",
    "for i in 0..N { let s = p[i][0].hypot(p[i][1]).hypot(p[i][2]); e += s * s / (2.0 * self.mass[i]); } e",
    "e += (p[0][0].powi(2) + p[0][1].powi(2) + p[0][2].powi(2)) / (2.0 * self.mass[0]);
     for i in 1..N { for d in 0..3 { e += p[i][d] * p[i][d] / (2.0 * self.mass[i]); } } e",
    "for d in 0..3 { e += 0.5 * p[0][d] * p[0][d] / self.mass[0]; }
     for i in 1..N { for d in 0..3 { e += p[i][d] * p[i][d] / (2.0 * self.mass[i]); } } e",
    "e + (0..3).map(|d| (0..N).map(|i| p[i][d] * p[i][d] / (2.0 * self.mass[i])).sum::<f64>()).sum::<f64>()",
    "e + p.iter().zip(&self.mass).map(|(p, m)| p.iter().map(|x| x * x).sum::<f64>() / (2.0 * m)).sum::<f64>()",
];

/// Spellings of V, with `R` for the distance `r` of the bodies `i` and `j`.
const POTENTIAL: &[&str] = &[
    "for i in 0..N { for j in 0..i { R e -= self.mass[i] * self.mass[j] / r; } } e",
    "for i in 0..N { for j in i + 1..N { R e += -self.mass[i] * self.mass[j] / r; } } e",
    "for i in 0..N - 1 { for j in i + 1..N { R e -= self.mass[i] * self.mass[j] / r; } } e",
    "for i in 0..N { for j in 0..N { if j < i { R e -= self.mass[i] * self.mass[j] / r; } } } e",
    "for i in 0..N { for j in 0..N { if i < j { R e -= self.mass[i] * self.mass[j] / r; } } } e",
    "for i in 0..N { for j in 0..N { if j >= i { continue; } R e -= self.mass[i] * self.mass[j] / r; } } e",
    "for i in 0..N { for j in 0..N { if i != j { R e -= 0.5 * self.mass[i] * self.mass[j] / r; } } } e",
    "for i in 0..N { let mut u = 0.0; for j in 0..i { R u -= self.mass[j] / r; } e += self.mass[i] * u; } e",
    // The first body apart.
    "for i in 1..N { let j = 0; R e -= self.mass[i] * self.mass[j] / r; }
     for i in 1..N { for j in 1..i { R e -= self.mass[i] * self.mass[j] / r; } e += self.k * q[i][0]; } e + self.k * q[0][0]",
    "for i in 1..N { let j = 0; R e -= self.mass[i] * self.mass[j] / r; }
     for i in 1..N { for j in i + 1..N { R e -= self.mass[i] * self.mass[j] / r; } } e",
    "for i in 1..N { let j = 0; R e -= self.mass[i] * self.mass[j] / r; }
     for i in 1..N { for j in 1..N { if i != j { R e -= 0.5 * self.mass[j] * self.mass[i] / r; } } } e",
    "for i in 0..N { if i == 0 { continue; } for j in 0..i { R e -= self.mass[i] * self.mass[j] / r; } } e",
    "for i in 0..N { if i > 0 { let j = 0; R e -= self.mass[i] * self.mass[j] / r; } 
        for j in 1..i { R e -= self.mass[i] * self.mass[j] / r; } } e",
    "for i in 0..N { for j in 0..N { if i == 0 { continue; } if j == 0 { continue; } if i == j { continue; } R e -= 0.5 * self.mass[j] * self.mass[i] / r; } }
     for i in 0..N { if i != 0 { let j = 0; R e -= self.mass[i] * self.mass[j] / r; e += self.k * q[i][0]; } } e",
    // More terms: of all pairs, of the first body with the others, of bodies after it, of it.
    "for i in 0..N { for j in 0..i { R
        e -= self.mass[i] * self.mass[j] / r * (1.0 + 3.0 * (self.mass[i] + self.mass[j]) / (self.k * r)); } } e",
    "for i in 0..N { for j in 0..i { R e -= self.mass[i] * self.mass[j] / r; } }
     for i in 1..N { let j = 0; R e -= 3.0 * self.mass[j].powi(2) * self.mass[i] / (self.k * r * r); } e",
    "for i in 0..N { for j in i + 1..N { R e -= self.mass[i] * self.mass[j] / r; } }
     for i in 1..N { for j in 1..i { R e += self.k * self.mass[i] * self.mass[j] * r; } e += self.k * q[i][1] * q[i][1]; } e",
    "for i in 0..N { for j in i + 1..N { R e -= self.mass[i] * self.mass[j] / r; } } e + self.mass[0] * q[0][2]",
    "for i in 1..N { let j = 0; R e -= self.mass[i] * self.mass[j] / r; } e",
    "for i in 0..N { for j in 0..i { R e -= self.mass[i] * self.mass[j] / r; } }
     for i in 1..N { let j = 0; R e -= self.mass[i - 1] / (r * r); e += q[i][2] * self.mass[i - 1]; } e",
];

const DISTANCES: &[&str] = &[
    "let mut s = 0.0; for d in 0..3 { let x = q[i][d] - q[j][d]; s += x * x; } let r = s.sqrt();",
    "let r = (q[i][0] - q[j][0]).hypot(q[i][1] - q[j][1]).hypot(q[i][2] - q[j][2]);",
    "let (x, y, z) = (q[j][0] - q[i][0], q[j][1] - q[i][1], q[j][2] - q[i][2]); let r = (x * x + y * y + z * z).sqrt();",
];

fn system(bodies: &str, kinetic: &str, potential: &str) -> String {
    let (shape, p, q) = match bodies {
        "" => ("&[[f64; 3]]".to_owned(), "p.len()", "q.len()"),
        number => (format!("&[[f64; 3]; {number}]"), number, number),
    };
    let (kinetic, potential) = (kinetic.replace('N', p), potential.replace('N', q));
    format!(
        "impl System {{
            fn kinetic(&self, p: {shape}) -> f64 {{ let mut e = 0.0; {kinetic} }}
            fn potential(&self, q: {shape}) -> f64 {{ let mut e = 0.0; {potential} }}
        }}"
    )
}

/// The value of a text: bodies have masses of their own.
fn number(text: &Expr, index: &dyn Fn(&str) -> f64) -> f64 {
    let of = |text: &Expr| number(text, index);
    match text {
        Expr::Paren(inner) => of(&inner.expr),
        Expr::Cast(cast) => of(&cast.expr),
        // It is requested where the functions request it.
        Expr::If(choice) => match &choice.then_branch.stmts[..] {
            [Stmt::Expr(number, _)] => of(number),
            _ => panic!("another choice"),
        },
        Expr::Unary(unary) if matches!(unary.op, UnOp::Neg(_)) => -of(&unary.expr),
        Expr::Binary(binary) => {
            let (a, b) = (of(&binary.left), of(&binary.right));
            match binary.op {
                BinOp::Add(_) => a + b,
                BinOp::Sub(_) => a - b,
                BinOp::Mul(_) => a * b,
                BinOp::Div(_) => a / b,
                BinOp::Eq(_) => f64::from(a == b),
                BinOp::Ne(_) => f64::from(a != b),
                _ => panic!("another operator"),
            }
        }
        Expr::MethodCall(call) if call.method == "powi" => of(&call.receiver).powf(of(&call.args[0])),
        Expr::MethodCall(call) if call.method == "max" => of(&call.receiver).max(of(&call.args[0])),
        Expr::MethodCall(call) if call.method == "len" => 4.0,
        Expr::Lit(literal) => match &literal.lit {
            Lit::Float(number) => number.base10_parse().expect("a number"),
            Lit::Int(number) => number.base10_parse().expect("a number"),
            _ => panic!("another literal"),
        },
        Expr::Index(item) => {
            let index = of(&item.index);
            assert!((0.0..4.0).contains(&index), "a list has no item {index}");
            1.0 + 0.3 * index
        }
        Expr::Field(field) if matches!(&field.member, Member::Named(name) if name == "k") => 0.7,
        Expr::Path(path) => index(&path.path.require_ident().expect("an index").to_string()),
        _ => panic!("another text"),
    }
}

#[test]
fn energies_in_their_one_form_have_the_same_values() {
    let kinetic = KINETIC.iter().map(|kinetic| [*kinetic, POTENTIAL[0]]);
    for [kinetic, potential] in kinetic.chain(POTENTIAL.iter().map(|potential| [KINETIC[0], *potential])) {
        let item = system("4", kinetic, &potential.replace('R', DISTANCES[0]));
        let mut model = crate::model::of_text(&item);
        let Model { graph, parameters, running, lengths, kinetic, potential, root, .. } = &mut model;
        let mut texts = Texts::new(parameters, running, root);
        let forms = [*kinetic, *potential]
            .map(|energy| [energy, canonical(graph, energy, lengths[0], &mut texts).expect("a sum over bodies")]);
        let texts: Vec<Expr> =
            parameters.iter().map(|one| syn::parse2(one.text.clone()).expect("an expression")).collect();
        let look_up = |id: ParameterId, running: &HashMap<LoopId, i64>| {
            let index = |name: &str| {
                let position: usize = name.trim_start_matches("__index_of_loop_").parse().expect("a loop");
                let found = running.iter().find(|(by, _)| by.position() == position);
                *found.expect("a loop around the parameter").1 as f64
            };
            number(&texts[id.0 as usize], &index)
        };
        let q: [f64; 12] = std::array::from_fn(|k| (1.0 + 1.7 * k as f64).sin() * (k + 1) as f64);
        let p: [f64; 12] = std::array::from_fn(|k| (0.3 + 2.1 * k as f64).cos());
        for [energy, form] in forms {
            let value = |id| Point { look_up: Some(&look_up), width: 3, ..Point::new(&q, &p) }.value(&model.graph, id);
            let (expected, found) = (value(energy), value(form));
            // Some dozen terms of the size of their sum.
            assert!((found - expected).abs() < 1e-13 * expected.abs(), "{item}: {found} for {expected}");
        }
    }
}

#[test]
fn all_spellings_move_in_jacobi_coordinates() {
    for bodies in ["", "3", "4"] {
        let kinetic = KINETIC.iter().map(|kinetic| [*kinetic, POTENTIAL[0], DISTANCES[0]]);
        let potential = POTENTIAL.iter().map(|potential| [KINETIC[0], *potential, DISTANCES[0]]);
        let distances = DISTANCES.iter().map(|distance| [KINETIC[1], POTENTIAL[3], *distance]);
        for [kinetic, potential, distance] in kinetic.chain(potential).chain(distances) {
            let item = system(bodies, kinetic, &potential.replace('R', distance));
            let arguments = "coordinates = jacobi(self.mass), split = kepler + interaction";
            let (input, mut model) = crate::model::with_input(arguments, &item);
            let coordinates = input.coordinates.as_ref().expect("coordinates");
            assert!(jacobi(coordinates, &mut model, &Names::new(&input)).is_ok(), "{item}");
        }
    }
}
