//! How much is written: as much as there are formulas, whatever the number of sites.

use integrator_symbolic::hamiltonian;
use proc_macro2::TokenStream;

fn expansion(item: &str) -> String {
    let expansion = hamiltonian(TokenStream::new(), item.parse().expect("tokens")).to_string();
    assert!(!expansion.contains("compile_error"), "{expansion}");
    expansion
}

/// Springs with a nonlinear term along a chain, and what holds each site.
fn lattice(sites: u64) -> String {
    let bonds = sites - 1;
    format!(
        "impl Lattice {{
            fn kinetic(&self, p: &[f64; {sites}]) -> f64 {{
                let mut sum = 0.0;
                for i in 0..{sites} {{ sum += p[i] * p[i] / (2.0 * self.mass[i]); }}
                sum
            }}
            fn potential(&self, q: &[f64; {sites}]) -> f64 {{
                let mut sum = 0.0;
                for i in 0..{bonds} {{ sum += (q[i + 1] - q[i]).powi(2) / 2.0 + self.alpha * (q[i + 1] - q[i]).powi(3); }}
                sum + q.iter().map(|q| 1.0 - q.cos()).sum::<f64>()
            }}
        }}"
    )
}

/// Every pair of ten bodies in space, written out: 45 pairs, 30 coordinates.
fn ten_bodies() -> String {
    let names: Vec<[String; 3]> = (0..10).map(|i| ["x", "y", "z"].map(|axis| format!("{axis}{i}"))).collect();
    let pattern = |letter: &str| {
        let bodies: Vec<String> = names.iter().map(|body| format!("[{}]", body.join(", "))).collect();
        format!("[{}]: [[f64; 3]; {letter}]", bodies.join(", "))
    };
    let kinetic: Vec<String> = (0..10)
        .map(|i| {
            let [x, y, z] = &names[i];
            format!("({x} * {x} + {y} * {y} + {z} * {z}) / (2.0 * self.mass[{i}])")
        })
        .collect();
    let pairs = (0..10).flat_map(|i| (0..i).map(move |j| (i, j)));
    let potential: Vec<String> = pairs
        .map(|(i, j)| {
            let apart: Vec<String> =
                names[i].iter().zip(&names[j]).map(|(a, b)| format!("({a} - {b}).powi(2)")).collect();
            format!("- self.mass[{i}] * self.mass[{j}] / ({}).sqrt()", apart.join(" + "))
        })
        .collect();
    format!(
        "impl TenBodies {{
            fn kinetic(&self, {}) -> f64 {{ {} }}
            fn potential(&self, {}) -> f64 {{ 0.0 {} }}
        }}",
        pattern("10"),
        kinetic.join(" + "),
        pattern("10"),
        potential.join(" ")
    )
}

/// What is left without digits. Small buffers are arrays and large ones are tables; that aside, there is no difference.
fn skeleton(sites: u64) -> String {
    let letters = expansion(&lattice(sites)).replace(|character: char| character.is_ascii_digit(), "");
    letters.replace("runtime :: table ( , | _ | Scalar :: of (.))", "[Scalar :: of (.) ; ]")
}

#[test]
fn a_larger_lattice_has_longer_numbers_alone() {
    let small = skeleton(10);
    assert!(small == skeleton(1_000) && small == skeleton(1_000_000), "{small}");
}

/// A pair takes some 900 bytes of tokens in the kick (three differences, a reciprocal cube, six updates), as much in the
/// energy and its part of the derivatives' documentation, and twice that in the Hessian.
#[test]
fn ten_bodies_written_out_stay_below_a_size() {
    let item = ten_bodies();
    let written = expansion(&item).len() - item.len();
    assert!((45_000..180_000).contains(&written), "{written} bytes");
}

/// Statements that follow each other, each behind a condition on coordinates of its own.
const BRANCHES: &[(&str, &str)] = &[
    ("walls", "if q[0] > self.wall[I] { v += 0.5 * (q[0] - self.wall[I]).powi(2); }"),
    ("walls on both sides", "if q[0] > self.wall[I] { v += q[0].exp(); } else { v -= q[1].exp(); }"),
    ("products", "if q[0] > self.wall[I] { v *= q[1].cosh(); }"),
    ("variables", "let v = if q[0] > self.wall[I] { v.sin() } else { v * 1.5 + q[1] };"),
    ("roots", "if v > self.wall[I] { v = (v + self.wall[I]).sqrt(); }"),
    ("kinks", "v = v.max(self.wall[I] * q[0]).sqrt();"),
];

#[test]
fn branches_that_follow_each_other_add_up() {
    for (name, statement) in BRANCHES {
        let length = |count: usize| {
            let statements = (0..count).map(|at| statement.replace('I', &at.to_string())).collect::<String>();
            let item = format!(
                "impl Branches {{
                    fn kinetic(&self, p: [f64; 2]) -> f64 {{ (p[0] * p[0] + p[1] * p[1]) / 2.0 }}
                    fn potential(&self, q: [f64; 2]) -> f64 {{ let mut v = q[0] * q[1] + 3.0; {statements} v }}
                }}"
            );
            expansion(&item).len()
        };
        // Were everything written for both sides of each, four more would cost sixteen times what the last four did. What
        // is nested in itself has second derivatives between all of its levels, whose number grows with the square.
        let [four, eight, twelve] = [4, 8, 12].map(length);
        let (first, second) = (eight - four, twelve - eight);
        assert!(second < 3 * first, "{name}: {four}, {eight}, {twelve}");
    }
}
