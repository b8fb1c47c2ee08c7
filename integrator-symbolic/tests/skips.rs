//! What a scene does not need is not in the generated text: a row for each of the points of "what the generator does".

use integrator_symbolic::{composition, hamiltonian};
use proc_macro2::TokenStream;

/// A function of the expansion of a system.
struct Row {
    /// What the generator leaves out, or does instead.
    point: &'static str,
    /// `T` and `V`.
    system: [&'static str; 2],
    /// The function that is looked at.
    function: &'static str,
    /// What stands in it.
    present: &'static [&'static str],
    /// What does not.
    absent: &'static [&'static str],
}

const SQUARES: &str = "fn kinetic(&self, p: [f64; 3]) -> f64 { 0.5 * (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) }";
const LINE: &str = "fn kinetic(&self, p: [f64; 1]) -> f64 { 0.5 * p[0] * p[0] }";
const CHAIN: &str = "fn kinetic(&self, p: [f64; 1000]) -> f64 {
    let mut sum = 0.0;
    for i in 0..1000 { sum += 0.5 * p[i] * p[i]; }
    sum
}";

const ROWS: [Row; 11] = [
    Row {
        point: "a cyclic coordinate has no force",
        system: [SQUARES, "fn potential(&self, q: [f64; 3]) -> f64 { (q[0] - q[2]).cos() }"],
        function: "kick",
        present: &["p [0]", "p [2]"],
        absent: &["p [1]", "q [1]"],
    },
    Row {
        point: "time is not read where H does not",
        system: [LINE, "fn potential(&self, q: [f64; 1]) -> f64 { q[0].cos() }"],
        function: "kick",
        present: &["_time : f64"],
        absent: &["of (time)"],
    },
    Row {
        point: "time is read where H does",
        system: [LINE, "fn potential(&self, q: [f64; 1], t: f64) -> f64 { q[0].cos() * t }"],
        function: "kick",
        present: &["of (time)"],
        absent: &["_time : f64"],
    },
    Row {
        point: "a flow evaluates no energy",
        system: [LINE, "fn potential(&self, q: [f64; 1]) -> f64 { q[0].powi(6) + q[0].cos() }"],
        function: "kick",
        present: &["sin ()"],
        absent: &["cos ()", "potential"],
    },
    Row {
        point: "a square of a parameter is known not to be negative: one division and one root",
        system: [
            SQUARES,
            "fn potential(&self, q: [f64; 3]) -> f64 {
                -1.0 / (q[0].powi(2) + q[1].powi(2) + q[2].powi(2) + self.eps * self.eps).sqrt()
            }",
        ],
        function: "kick",
        present: &["div_pow_3_2"],
        absent: &["sqrt", "/"],
    },
    Row {
        point: "what depends on parameters alone is evaluated once per run",
        system: [LINE, "fn potential(&self, q: [f64; 1]) -> f64 { q[0] * q[0] * self.a.exp() / self.b.powi(3) }"],
        function: "kick",
        present: &["parameters . prepared_0"],
        absent: &["exp", "/", "prepared_1"],
    },
    Row {
        point: "the preparation is the user's own expression",
        system: [LINE, "fn potential(&self, q: [f64; 1]) -> f64 { q[0] * q[0] * self.a.exp() / self.b.powi(3) }"],
        function: "parameters",
        present: &["self . a . exp ()", "self . b . powi (3)"],
        absent: &["motion"],
    },
    Row {
        point: "sine and cosine are one call, shared factors one value, powers products",
        system: [LINE, "fn potential(&self, q: [f64; 1]) -> f64 { q[0].sin() * q[0].cos() + (q[0] + 1.0).powf(-1.5) }"],
        function: "kick",
        present: &["sin_cos ()", "sqrt ()"],
        absent: &["sin ()", " cos ()", "powf"],
    },
    Row {
        point: "a sum stays a loop",
        system: [
            CHAIN,
            "fn potential(&self, q: [f64; 1000]) -> f64 {
                let mut sum = 0.0;
                for i in 0..500 { sum += (q[i + 500] - q[i]).cosh(); }
                sum
            }",
        ],
        function: "kick",
        present: &["for "],
        absent: &["q [7]", "p [7]"],
    },
    Row {
        point: "neighbours are gathered: no buffer of forces, no scattering",
        system: [
            CHAIN,
            "fn potential(&self, q: [f64; 1000]) -> f64 {
                let mut sum = 0.0;
                for i in 0..999 { sum += (q[i + 1] - q[i]).cosh(); }
                sum
            }",
        ],
        function: "kick",
        present: &["motion . kick :: < Self >"],
        absent: &["gradient", "for "],
    },
    Row {
        point: "a side that no lane takes is not computed",
        system: [LINE, "fn potential(&self, q: [f64; 1]) -> f64 { if q[0] < self.cutoff { q[0].exp() } else { 0.0 } }"],
        function: "kick",
        present: &["if condition_0 . any () {", "exp ()"],
        absent: &["ln ()"],
    },
];

/// The text of a function of the expansion, from its name to the next function.
fn function(expansion: &str, name: &str) -> String {
    let start = format!("fn {name} ");
    let generated = expansion.split("impl runtime :: System for").nth(1).expect("an implementation");
    let text = generated.split(&start).nth(1).unwrap_or_else(|| panic!("no function {name}: {generated}"));
    text.split(" fn ").next().expect("a body").to_owned()
}

#[test]
fn unneeded_code_is_not_generated() {
    for Row { point, system: [kinetic, potential], function: name, present, absent } in ROWS {
        let item = format!("impl Scene {{ {kinetic} {potential} }}").parse().expect("tokens");
        let text = function(&hamiltonian(TokenStream::new(), item).to_string(), name);
        for part in present {
            assert!(text.contains(part), "{point}: `{part}` is missing in {text}");
        }
        for part in absent {
            assert!(!text.contains(part), "{point}: `{part}` is in {text}");
        }
    }
}

/// What softens a distance and cannot be negative, of parameters and of coordinates.
const SOFTENINGS: &[&str] = &[
    "self.eps * self.eps",
    "self.eps.powi(2)",
    "self.eps.powi(2) + self.delta.powi(4)",
    "self.eps.powi(2) * self.delta.abs()",
    "2.0 * self.eps.powi(2) + 0.01",
    "self.eps.abs() + 1.0",
    "self.eps.max(0.0)",
    "self.eps.exp()",
    "self.eps.exp() * self.delta.max(0.0)",
    "self.eps.hypot(self.delta)",
    "q[2].abs() + 1.0",
    "q[2].max(0.0)",
    "q[2].exp() + self.eps.powi(2)",
    "self.eps.powi(2) * q[2].powi(2)",
];

#[test]
fn softened_gravity_takes_one_division_and_one_root() {
    for softening in SOFTENINGS {
        let potential = format!(
            "fn potential(&self, q: [f64; 3]) -> f64 {{
                -self.gm / (q[0].powi(2) + q[1].powi(2) + {softening}).sqrt()
            }}"
        );
        let item = format!("impl Scene {{ {SQUARES} {potential} }}").parse().expect("tokens");
        let text = function(&hamiltonian(TokenStream::new(), item).to_string(), "kick");
        let count = |part: &str| text.matches(part).count();
        let roots = count("div_pow_3_2") + count("div_sqrt") + count("sqrt ()");
        let divisions = count("div_pow_3_2") + count("div_sqrt") + count(" / ");
        assert_eq!((roots, divisions), (1, 1), "{softening}: {text}");
    }
}

/// Stages that meet are one, inside a step and from a step to the next.
#[test]
fn stages_that_meet_are_one() {
    let sequences = [
        ("T(1/2) V(1) T(1/2)", 1),
        ("T(1/4) V(1/2) T(1/4) T(1/4) V(1/2) T(1/4)", 2),
        ("T(1/2) V(1/3) V(2/3) T(1/2)", 1),
    ];
    for (sequence, rows) in sequences {
        let text = composition(format!("pub struct Some = {sequence};").parse().expect("tokens")).to_string();
        let cycle = text.split("cycle : & [").nth(1).and_then(|rest| rest.split("closing").next()).expect("a table");
        assert_eq!(cycle.matches("Stage {").count(), rows, "{sequence}: {text}");
    }
}
