//! Which systems are recognised as lattices: chains whose sites are all alike, for Taylor's method, and planes of sites, which
//! splitting steps move in tiles.

use integrator_symbolic::hamiltonian;
use proc_macro2::TokenStream;

/// The potential of a chain of N sites: a name, its text, and whether it is a line for lengths that fill vectors.
const POTENTIALS: [(&str, &str, bool); 18] = [
    ("free ends", "for i in 1..N { v += b(q[i] - q[i - 1]); }", true),
    ("the next site", "for i in 0..N - 1 { v += b(q[i + 1] - q[i]); }", true),
    ("walls", "v += b(q[0]) + b(-q[N - 1]); for i in 1..N { v += b(q[i] - q[i - 1]); }", true),
    ("a wall before the first", "v += b(q[0]); for i in 1..N { v += b(q[i] - q[i - 1]); }", true),
    ("a wall behind the last", "v += b(-q[N - 1]); for i in 1..N { v += b(q[i] - q[i - 1]); }", true),
    ("a ring", "for i in 0..N { v += b(q[(i + 1) % N] - q[i]); }", true),
    ("a ring with a last bond", "v += b(q[0] - q[N - 1]); for i in 1..N { v += b(q[i] - q[i - 1]); }", false),
    ("a field", "for i in 0..N { v += q[i].powi(4); } for i in 1..N { v += b(q[i] - q[i - 1]); }", true),
    ("a field in time", "for i in 0..N { v += t * q[i]; } for i in 1..N { v += b(q[i] - q[i - 1]); }", true),
    ("other walls", "v += q[0].powi(4); for i in 1..N { v += b(q[i] - q[i - 1]); }", false),
    ("a wall that is not at rest", "v += b(q[0] - 1.0); for i in 1..N { v += b(q[i] - q[i - 1]); }", false),
    ("the wrong side", "v += b(-q[0]); for i in 1..N { v += b(q[i] - q[i - 1]); }", false),
    ("two walls at one end", "v += b(q[0]) + b(q[0]); for i in 1..N { v += b(q[i] - q[i - 1]); }", false),
    ("a site that differs", "v += q[3].powi(4); for i in 1..N { v += b(q[i] - q[i - 1]); }", false),
    ("bonds of their own", "for i in 1..N { v += self.k[i] * b(q[i] - q[i - 1]); }", false),
    ("second neighbours", "for i in 2..N { v += b(q[i] - q[i - 2]); }", false),
    ("no neighbours", "for i in 0..N { v += b(q[i]); }", false),
    ("a common function of time", "for i in 1..N { v += t.sin() * b(q[i] - q[i - 1]); }", false),
];

fn is_line(kinetic: &str, potential: &str, [shape, length]: [&str; 2]) -> bool {
    let text = format!(
        "impl Chain {{
            fn kinetic(&self, p: {shape}) -> f64 {{ {kinetic} }}
            fn potential(&self, q: {shape}, t: f64) -> f64 {{
                let b = |r: f64| r * r / 2.0 - self.a * r.powi(3) / 3.0 + r.powi(4) / 4.0;
                let mut v = 0.0;
                {}
                v
            }}
        }}",
        potential.replace('N', length)
    );
    let arguments = "taylor".parse().expect("tokens");
    let text = hamiltonian(arguments, text.parse().expect("tokens")).to_string();
    assert!(!text.contains("compile_error"), "{potential}: {text}");
    text.contains("runtime :: Line <")
}

const SQUARES: &str = "p.iter().map(|p| p * p / 2.0).sum()";

#[test]
fn sites_that_fill_vectors_and_are_alike_are_a_line() {
    for (name, potential, holds) in POTENTIALS {
        assert_eq!(is_line(SQUARES, potential, ["[f64; 16]", "16"]), holds, "{name}");
        assert!(!is_line(SQUARES, potential, ["[f64; 12]", "12"]), "{name}: no whole vectors");
        assert!(!is_line(SQUARES, potential, ["&[f64]", "q.len()"]), "{name}: a list");
    }
}

#[test]
fn positions_of_a_line_follow_momenta_by_an_inverse_mass() {
    let (_, bonds, _) = POTENTIALS[0];
    let kinetic = |energy: &str| format!("let mut t = 0.0; for i in 0..16 {{ t += {energy}; }} t");
    let of = |energy: &str| is_line(&kinetic(energy), bonds, ["[f64; 16]", "16"]);
    assert!(of("p[i] * p[i] / (2.0 * self.m[i])"));
    assert!(!of("(1.0 + p[i] * p[i]).sqrt()"));
}

/// What a kinetic energy of rows and a potential say of the second index: a name, how many of them there are, the potential,
/// and whether they are sites.
const PLANES: [(&str, &str, &str, bool); 8] = [
    ("a field on rows of 40", "40", "(q[i][(j + 1) % W] - q[i][j]).powi(2) + q[i][j].powi(4)", true),
    ("rows of few", "3", "(q[i][(j + 1) % W] - q[i][j]).powi(2)", false),
    ("rows of 40 without bonds along them", "40", "q[i][j].powi(4)", true),
    ("a field on rows of a width of the type", "W", "(q[i][(j + 1) % W] - q[i][j]).powi(2) + q[i][j].powi(4)", true),
    (
        "bonds along and across",
        "W",
        "(q[i][(j + 1) % W] - q[i][j]).powi(4) + (q[(i + 1) % q.len()][j] - q[i][j]).powi(2)",
        true,
    ),
    (
        "the sum of the sites around",
        "40",
        "q[i][j] * (q[(i + 1) % q.len()][j] + q[(i + q.len() - 1) % q.len()][j] + q[i][(j + 1) % W] + q[i][(j + 39) % W])",
        true,
    ),
    ("bonds across alone, as points have them", "W", "(q[(i + 1) % q.len()][j] - q[i][j]).powi(2)", false),
    ("points without bonds", "W", "q[i][j].powi(4)", false),
];

#[test]
fn rows_with_bonds_along_them_are_sites() {
    for (name, width, potential, holds) in PLANES {
        let of_the_type = if width == "W" { "const W: usize" } else { "" };
        let generic = width.trim_matches(|digit: char| digit.is_ascii_digit());
        let text = format!(
            "impl<{of_the_type}> Plane<{generic}> {{
                fn kinetic(&self, p: &[[f64; W]]) -> f64 {{
                    p.iter().map(|row| row.iter().map(|p| p * p / 2.0).sum::<f64>()).sum()
                }}
                fn potential(&self, q: &[[f64; W]]) -> f64 {{
                    let mut v = 0.0;
                    for i in 0..q.len() {{ for j in 0..W {{ v += {potential}; }} }}
                    v
                }}
            }}"
        );
        let text = if width == "W" { text } else { text.replace('W', width) };
        let text = hamiltonian(Default::default(), text.parse().expect("tokens")).to_string();
        assert!(!text.contains("compile_error"), "{name}: {text}");
        assert_eq!(text.contains("STENCIL_RADII"), holds, "{name}");
    }
}

/// Whether sites of a chain of any length are moved as a lattice.
fn is_lattice(potential: &str) -> bool {
    let text = format!(
        "impl Chain {{
            fn kinetic(&self, p: &[f64]) -> f64 {{ {SQUARES} }}
            fn potential(&self, q: &[f64]) -> f64 {{ let mut v = 0.0; {potential} v }}
        }}"
    );
    let text = hamiltonian(TokenStream::new(), text.parse().expect("tokens")).to_string();
    assert!(!text.contains("compile_error"), "{potential}: {text}");
    text.contains("STENCIL_RADII")
}

#[test]
fn a_bond_between_the_ends_of_a_line_closes_it() {
    let line = "for i in 1..q.len() { v += (q[i] - q[i - 1]).powi(4); }";
    assert!(is_lattice(line));
    assert!(is_lattice(&format!("v += (q[0] - q[q.len() - 1]).powi(4); {line}")));
    assert!(is_lattice(&format!("v += (q[1] - q[q.len() - 1]).powi(4); {line}")));
    assert!(!is_lattice(&format!("v += (q[2] - q[q.len() - 1]).powi(4); {line}")), "farther than sites look");
}
