//! What the indices of loops are called changes nothing: with other names, the code that is written is the same up to the
//! names of its own variables.

#[path = "loop_names/mod.rs"]
mod loop_names;
mod systems;

use integrator_symbolic::hamiltonian;
use loop_names::{Numbered, Renamed, Scheme};
use quote::ToTokens;
use syn::visit_mut::VisitMut;
use systems::{System, corpus};

/// The generated code of a system, without the user's own item, with a number for each variable.
fn numbered(system: &System) -> String {
    let text = hamiltonian(system.arguments.clone(), system.item.to_token_stream());
    let mut file: syn::File = syn::parse2(text).expect("items");
    file.items.remove(0);
    assert!(!file.to_token_stream().to_string().contains("compile_error"), "{}", prettyplease::unparse(&file));
    Numbered::default().visit_file_mut(&mut file);
    prettyplease::unparse(&file)
}

/// Systems whose terms move between loops: sums over pairs in all directions, in Jacobi coordinates and without these,
/// with parameters of one index and of two, and with loops over components inside.
fn pairs() -> Vec<System> {
    let loops = [
        "for a in 0..n { for b in 0..a { BODY } }",
        "for a in 1..n { for b in 0..a { BODY } }",
        "for a in 0..n { for b in a + 1..n { BODY } }",
        "for a in 0..n { for b in 0..n { if a != b { BODY } } }",
    ];
    let bodies = [
        "let mut s = 0.0; for d in 0..3 { s += (q[a][d] - q[b][d]).powi(2); } \
         v -= self.gravity * self.mass[a] * self.mass[b] / s.sqrt();",
        "let s: f64 = (0..3).map(|d| (q[a][d] - q[b][d]).powi(2)).sum(); v -= self.mass[a] * self.mass[b] / s.sqrt();",
        "let x = [q[a][0] - q[b][0], q[a][1] - q[b][1], q[a][2] - q[b][2]]; \
         let s = x[0] * x[0] + x[1] * x[1] + x[2] * x[2]; \
         v -= self.mass[a] * self.mass[b] / s.sqrt(); v += self.charge[b] * self.charge[a] / s;",
    ];
    let alone = ["", "for c in 0..n { v += self.mass[c] * self.charge[c] * q[c][2]; }"];
    let kinetic = [
        "let mut t = 0.0; for c in 0..n { for d in 0..3 { t += p[c][d] * p[c][d] / (2.0 * self.mass[c]); } } t",
        "(0..n).map(|c| (0..3).map(|d| p[c][d].powi(2)).sum::<f64>() / (2.0 * self.mass[c])).sum()",
    ];
    let arguments = ["coordinates = jacobi(self.mass), split = kepler + interaction", ""];
    let mut found = Vec::new();
    for ((over, body), alone) in loops.iter().flat_map(|over| bodies.map(|body| (over, body))).zip(alone.iter().cycle())
    {
        for (arguments, kinetic) in arguments.iter().zip(kinetic) {
            let over = over.replace("BODY", body);
            let item = format!(
                "impl S {{
                    fn kinetic(&self, p: &[[f64; 3]]) -> f64 {{ let n = p.len(); {kinetic} }}
                    fn potential(&self, q: &[[f64; 3]]) -> f64 {{
                        let n = q.len(); let mut v = 0.0; {over} {alone} v
                    }}
                }}"
            );
            let item = syn::parse_str(&item).expect("an impl");
            found.push(System { arguments: arguments.parse().expect("tokens"), item });
        }
    }
    found
}

fn are_the_same(systems: Vec<System>) {
    let mut changed = 0;
    for system in systems {
        let expected = numbered(&system);
        for scheme in Scheme::ALL {
            let mut item = system.item.clone();
            let mut renamed = Renamed::new(scheme, &item);
            renamed.visit_item_impl_mut(&mut item);
            changed += usize::from(item.to_token_stream().to_string() != system.item.to_token_stream().to_string());
            let other = System { arguments: system.arguments.clone(), item };
            let found = numbered(&other);
            let difference = found.lines().zip(expected.lines()).find(|(found, expected)| found != expected);
            assert!(
                difference.is_none() && found.len() == expected.len(),
                "{scheme:?}: {difference:?}\n{}",
                prettyplease::unparse(&syn::parse2(other.item.to_token_stream()).expect("an item"))
            );
        }
    }
    assert!(changed > 40, "{changed}");
}

#[test]
fn sums_over_pairs_do_not_depend_on_names() {
    are_the_same(pairs());
}

#[test]
fn the_corpus_does_not_depend_on_names() {
    are_the_same(corpus());
}
