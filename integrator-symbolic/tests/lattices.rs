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

/// Loops over flat coordinates as rows of `self.w` sites, and whether these are moved as a plane. `LOOPS` are loops over all sites.
const FLAT_PLANES: [(&str, &str, bool); 24] = [
    (
        "a torus",
        "LOOPS { v += b(q[y * w + (x + 1) % w] - q[y * w + x]) + b(q[(y + 1) % h * w + x] - q[y * w + x]); }",
        true,
    ),
    ("factors exchanged", "LOOPS { v += b(q[x + w * y] - q[w * y + (x + 1) % w]); }", true),
    ("the site before", "LOOPS { v += b(q[y * w + x] - q[y * w + (x + w - 1) % w]); }", true),
    ("open rows", "for y in 0..h { for x in 0..w - 1 { v += b(q[y * w + x + 1] - q[y * w + x]); } }", true),
    (
        "rows from the second site on",
        "for y in 0..h { for x in 1..w { v += b(q[y * w + x] - q[y * w + x - 1]); } }",
        true,
    ),
    (
        "a condition, which is a number of each site",
        "LOOPS { if x + 1 < self.k { v += b(q[y * w + x + 1] - q[y * w + x]); } }",
        false,
    ),
    ("a condition at the end of a row", "LOOPS { if x + 1 < w { v += b(q[y * w + x + 1] - q[y * w + x]); } }", true),
    (
        "choices between the ends of rows and columns",
        "LOOPS {
             let right = if x + 1 == w { q[y * w] } else { q[y * w + x + 1] };
             let below = if y + 1 == h { q[x] } else { q[(y + 1) * w + x] };
             v += b(right - q[y * w + x]) + b(below - q[y * w + x]);",
        true,
    ),
    (
        "open columns",
        "LOOPS { v += b(q[y * w + (x + 1) % w] - q[y * w + x]); }
         for y in 0..h - 1 { for x in 0..w { v += b(q[y * w + w + x] - q[y * w + x]); } }",
        true,
    ),
    (
        "rows counted by the coordinates",
        "for y in 0..q.len() / w { for x in 0..w { v += b(q[y * w + (x + 1) % w] - q[y * w + x]); } }",
        true,
    ),
    ("a method", "LOOPS { v += b(q[self.at(x + 1, y)] - q[self.at(x, y)]); }", true),
    (
        "a sum over all coordinates",
        "for i in 0..q.len() { v += b(q[i]); } LOOPS { v += b(q[y * w + (x + 1) % w] - q[y * w + x]); }",
        true,
    ),
    ("a number of each site", "LOOPS { v += self.k[y * w + x] * b(q[y * w + (x + 1) % w] - q[y * w + x]); }", true),
    (
        "ends by choices between coordinates",
        "let (w, h) = (64, q.len() / 64);
         LOOPS {
             let right = if x + 1 == w { q[y * w] } else { q[y * w + x + 1] };
             let below = if y + 1 < h { q[(y + 1) * w + x] } else { q[x] };
             v += b(right - q[y * w + x]) + b(below - q[y * w + x]);",
        true,
    ),
    (
        "beginnings by choices between coordinates",
        "let (w, h) = (64, q.len() / 64);
         LOOPS {
             let left = if x == 0 { q[y * w + w - 1] } else { q[y * w + x - 1] };
             let above = if y == 0 { q[(h - 1) * w + x] } else { q[(y - 1) * w + x] };
             v += b(left - q[y * w + x]) + b(above - q[y * w + x]);",
        true,
    ),
    (
        "a choice that closes no ring",
        "let (w, h) = (64, q.len() / 64);
         LOOPS { v += b(if x + 1 == w { q[y * w + 1] } else { q[y * w + x + 1] } - q[y * w + x]);",
        false,
    ),
    ("rows that continue in the next one", "LOOPS { v += b(q[(y * w + x + 1) % q.len()] - q[y * w + x]); }", false),
    ("a site after the row", "for y in 0..h - 1 { for x in 0..w { v += b(q[y * w + x + 1] - q[y * w + x]); } }", false),
    ("a site before the row", "for y in 1..h { for x in 0..w { v += b(q[y * w + x - 1] - q[y * w + x]); } }", false),
    ("a third site", "LOOPS { v += b(q[y * w + 2] - q[y * w + x]); }", false),
    ("another width", "LOOPS { v += b(q[y * w + (x + 1) % w] - q[y * h + x]); }", false),
    ("points", "LOOPS { v += b(q[y * w + x]); }", false),
    (
        "a number of each coordinate",
        "for i in 0..q.len() { v += self.k[i] * b(q[i]); } LOOPS { v += b(q[y * w + (x + 1) % w] - q[y * w + x]); }",
        false,
    ),
    ("a site far away", "LOOPS { v += b(q[y * w + (x + 3) % w] - q[y * w + x]); }", false),
];

#[test]
fn flat_coordinates_whose_indices_stay_in_their_rows_are_planes() {
    for (name, potential, holds) in FLAT_PLANES {
        let potential = potential.replace("LOOPS", "for y in 0..h { for x in 0..w").replace("; }\n", "; } }\n");
        let opened = potential.matches('{').count() - potential.matches('}').count();
        let potential = format!("{potential}{}", "}".repeat(opened));
        let text = format!(
            "impl Plane {{
                fn at(&self, x: usize, y: usize) -> usize {{ y * self.w + x % self.w }}
                fn kinetic(&self, p: &[f64]) -> f64 {{ {SQUARES} }}
                fn potential(&self, q: &[f64]) -> f64 {{
                    let b = |r: f64| r * r / 2.0 + r.powi(4) / 4.0;
                    let (w, h) = (self.w, self.h);
                    let mut v = 0.0;
                    {potential}
                    v
                }}
            }}"
        );
        let text = hamiltonian(Default::default(), text.parse().expect("tokens")).to_string();
        assert!(!text.contains("compile_error"), "{name}: {text}");
        assert_eq!(text.contains("FLAT_ROWS"), holds, "{name}");
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

#[test]
fn a_choice_between_coordinates_closes_a_line() {
    for (at_end, holds) in [("q[0]", true), ("q[1]", false)] {
        let right = format!("if i + 1 == q.len() {{ {at_end} }} else {{ q[i + 1] }}");
        let bonds = format!("for i in 0..q.len() {{ let right = {right}; v += (right - q[i]).powi(4); }}");
        assert_eq!(is_lattice(&bonds), holds, "{bonds}");
    }
    let left = "if i == 0 { q[q.len() - 1] } else { q[i - 1] }";
    assert!(is_lattice(&format!("for i in 0..q.len() {{ let left = {left}; v += (left - q[i]).powi(4); }}")));
}
