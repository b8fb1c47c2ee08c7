//! What is derived, for people.

use integrator_symbolic::{Form, declared, hamiltonian, report, sequence};
use proc_macro2::TokenStream;
use std::path::Path;

#[path = "../../../tests/support/kept.rs"]
mod kept;
mod ways;

use kept::assert_kept;

fn tokens(text: &str) -> TokenStream {
    text.parse().expect("tokens")
}

#[test]
fn a_pendulum_is_two_equations_and_few_operations() {
    let pendulum = "impl Pendulum {
        fn kinetic(&self, p: [f64; 1]) -> f64 { p[0].powi(2) / (2.0 * self.mass) }
        fn potential(&self, q: [f64; 1]) -> f64 { -self.torque * q[0].cos() }
    }";
    let report = report(TokenStream::new(), tokens(pendulum)).expect("no mistake");
    assert_eq!(report.equations, ["dq[0]/dt = p[0] / mass", "dp[0]/dt = -torque sin(q[0])"]);
    assert!(report.quadratic_kinetic && report.autonomous);
    // A product in the drift; a sine and a product in the kick.
    assert_eq!((report.operations_written, report.operations_shared), (3, 3));
    assert!(report.to_string().contains("or 3 after common subexpression elimination"));
}

#[test]
fn elements_of_lists_have_no_spaces_in_their_brackets() {
    let system = "impl Chain {
        fn kinetic(&self, p: &[f64]) -> f64 { p.iter().map(|p| 0.5 * p * p).sum() }
        fn potential(&self, q: &[f64]) -> f64 {
            let mut v = 0.0;
            for i in 0..q.len() { v += self.depths[self.kinds[i]] * q[i]; }
            v
        }
    }";
    let equations = report(TokenStream::new(), tokens(system)).expect("no mistake").equations;
    assert!(equations.contains(&"dp[k]/dt = -depths[kinds[k]]   for k in 0..n".to_owned()), "{equations:#?}");
}

#[test]
fn sharing_is_counted() {
    let system = "impl Driven {
        fn kinetic(&self, p: [f64; 2]) -> f64 { (1.0 + p[0] * p[0] + p[1] * p[1]).sqrt() }
        fn potential(&self, q: [f64; 2], t: f64) -> f64 { (q[0] * q[1]).exp() * t }
    }";
    let report = report(TokenStream::new(), tokens(system)).expect("no mistake");
    assert!(!report.quadratic_kinetic && !report.autonomous);
    assert!(report.operations_shared < report.operations_written, "{report}");
}

/// A condition around a loop stands behind the loops, and holds or does not.
#[test]
fn conditions_around_loops_are_shown() {
    let bodies = "impl Bodies {
        fn kinetic(&self, p: &[[f64; 2]]) -> f64 { p.iter().map(|p| 0.5 * (p[0] * p[0] + p[1] * p[1])).sum() }
        fn potential(&self, q: &[[f64; 2]]) -> f64 {
            let mut v = 0.0;
            for i in 0..q.len() {
                if q[i][0] > self.edge { for k in 0..2 { v += 0.5 * q[i][k] * q[i][k]; } } else { v += q[i][0]; }
            }
            v
        }
    }";
    let equations = report(TokenStream::new(), tokens(bodies)).expect("no mistake").equations;
    let expected = [
        "dp[k][k_2]/dt += -q[k][k_2]   for k in 0..n, k_2 in 0..2, if q[k][0] > edge",
        "dp[k][0]/dt += {0 if q[k][0] > edge, else -1}   for k in 0..n",
    ];
    assert!(expected.iter().all(|line| equations.iter().any(|shown| shown == line)), "{equations:#?}");
}

/// Of repulsion and attraction the lesser power is factored out, whatever the signs and the factors; what is not whole is not.
#[test]
fn two_negative_powers_share_the_lesser_one() {
    let operations = |force: &str| {
        let system = format!(
            "impl S {{
                fn kinetic(&self, p: [f64; 1]) -> f64 {{ 0.5 * p[0] * p[0] }}
                fn potential(&self, q: [f64; 1]) -> f64 {{ let x = q[0]; {force} }}
            }}"
        );
        report(TokenStream::new(), tokens(&system)).expect("no mistake").operations_shared
    };
    // A reciprocal, four products for its sixth and seventh power, a factor, an addition and the product of both.
    for force in ["x.powi(-12) - x.powi(-6)", "self.a * x.powi(-12) - x.powi(-6) * self.b", "-x.powi(-6) - x.powi(-12)"]
    {
        assert_eq!(operations(force), 8, "{force}");
    }
    assert_eq!(operations("x.powi(-12) - x.powf(-5.5)"), 11);
}

#[test]
fn mistakes_have_no_report() {
    let error = report(TokenStream::new(), tokens("impl Nothing {}")).expect_err("two functions are missing");
    assert_eq!(error.into_iter().count(), 2);
}

const KINETIC: &str = "fn kinetic(&self, p: &[f64]) -> f64 { p.iter().map(|p| 0.5 * p * p).sum() }";

/// Holds the constant of the generated code, which emission decides, against the report, which emits nothing.
fn assert_runtime_knows(system: &str) {
    let report = report(TokenStream::new(), tokens(system)).expect("no mistake");
    let expanded = hamiltonian(TokenStream::new(), tokens(system)).to_string();
    let constant = expanded.split_once("const LAYOUT").map(|(_, rest)| rest.split(';').next().unwrap_or_default());
    let names = [&report.drift, &report.kick].map(|flow| flow.form.name());
    match constant {
        None => assert_eq!(names, ["plain"; 2], "{system}"),
        Some(constant) => {
            let quoted: Vec<_> = constant.split('"').skip(1).step_by(2).collect();
            assert_eq!(quoted, names, "{system}");
        }
    }
    let is_listed = matches!(report.kick.form, Form::Lists | Form::ListsInBox | Form::Triplets);
    assert_eq!(expanded.contains("fn is_listed"), is_listed, "{system}");
}

#[test]
fn flows_have_the_form_that_is_written() {
    let rows = [
        (KINETIC, "for i in 0..q.len() - 1 { v += (q[i + 1] - q[i]).powi(4); }", Form::Line),
        (KINETIC, "for i in 0..q.len() { if i > 0 { v += (q[i] - q[i - 1]).powi(4); } }", Form::Line),
        (
            KINETIC,
            "for i in 0..q.len() { v += if i + 1 == q.len() { q[i].powi(2) } else { (q[i + 1] - q[i]).powi(4) }; }",
            Form::Line,
        ),
        (KINETIC, "for i in 0..q.len() { if i % 2 == 0 { v += q[i].powi(4); } }", Form::Plain),
        (KINETIC, "for i in 0..q.len() { for j in 0..i { v += (q[i] - q[j]).powi(2).exp(); } }", Form::Pairs),
        (
            KINETIC,
            "for i in 0..q.len() { for j in 0..i { let d = q[i] - q[j]; if d.abs() < 1.0 { v += d.powi(2).exp(); } } }",
            Form::Lists,
        ),
        (
            KINETIC,
            "for i in 0..q.len() { for j in 0..i { let d = q[i] - q[j]; if d * d < 1.0 { v += d.powi(2).exp(); } } }",
            Form::Lists,
        ),
        (
            KINETIC,
            "for i in 0..q.len() { for j in 0..i { let mut d = q[i] - q[j]; d -= 9.0 * (d / 9.0).round(); \
             if d * d < 1.0 { v += d.powi(4); } } }",
            Form::ListsInBox,
        ),
        (KINETIC, "for &(a, b) in &self.bonds { v += (q[a] - q[b]).powi(4); }", Form::Terms),
        (
            KINETIC,
            "for (k, &(a, b, c)) in self.angles.iter().enumerate() { v += self.k[k] * (q[a] - q[b]) * (q[b] - q[c]); }",
            Form::Terms,
        ),
        (KINETIC, "for &(a, b) in &self.bonds { v += (q[a + 1] - q[b]).powi(4); }", Form::Plain),
        (KINETIC, "for i in 0..q.len() { for &j in &self.near[i] { v += q[i] * q[j].powi(2); } }", Form::Terms),
        (
            KINETIC,
            "for i in 0..q.len() { for &j in &self.near[i] { if j > i { v += q[i] * q[j].powi(2); } } }",
            Form::Plain,
        ),
        (KINETIC, "for k in 0..4 { v += q[self.held[k]].powi(4); }", Form::Plain),
        (KINETIC, "for i in 0..q.len() { for j in 0..q.len() { v += self.k[i][j] * q[i] * q[j]; } }", Form::Lanes),
        (KINETIC, "v = q[0] * q[1];", Form::Plain),
    ];
    for (kinetic, body, form) in rows {
        let potential = format!("fn potential(&self, q: &[f64]) -> f64 {{ let mut v = 0.0; {body} v }}");
        let system = format!("impl S {{ {kinetic} {potential} }}");
        assert_eq!(report(TokenStream::new(), tokens(&system)).expect("no mistake").kick.form, form, "{body}");
        assert_runtime_knows(&system);
    }
    let row = "impl S {
        fn kinetic(&self, p: [f64; 3]) -> f64 { p.iter().map(|p| 0.5 * p * p).sum() }
        fn potential(&self, q: [f64; 3]) -> f64 {
            let mut v = 0.0;
            for i in 0..3 { for j in 0..i { v += (q[i] - q[j]).powi(2).exp(); } }
            v
        }
    }";
    let plane = "impl S {
        fn kinetic(&self, p: &[[f64; 16]]) -> f64 { 
            let mut t = 0.0;
            for i in 0..p.len() { for j in 0..16 { t += 0.5 * p[i][j] * p[i][j]; } }
            t
        }
        fn potential(&self, q: &[[f64; 16]]) -> f64 {
            let mut v = 0.0;
            for i in 0..q.len() - 1 { for j in 0..16 { v += (q[i + 1][j] - q[i][j]).powi(4); } }
            v
        }
    }";
    let points = |body: &str| {
        format!(
            "impl S {{
                fn kinetic(&self, p: &[[f64; 3]]) -> f64 {{ p.iter().flatten().map(|p| 0.5 * p * p).sum() }}
                fn potential(&self, q: &[[f64; 3]]) -> f64 {{ let mut v = 0.0; {body} v }}
            }}"
        )
    };
    let square = "let r2: f64 = (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum();";
    let bonds = points(&format!("for &(i, j) in &self.bonds {{ {square} v += (r2.sqrt() - 1.0).powi(2); }}"));
    let loops = points("for &(i, j) in &self.bonds { for d in 0..3 { v += (q[i][d] - q[j][d]).powi(4); } }");
    let long = points("for &(i, j) in &self.bonds { for d in 0..5 { v += (self.k[d] * (q[i][0] - q[j][0])).sin(); } }");
    let before =
        points(&format!("for i in 0..q.len() {{ for j in (0..q.len()).take(i) {{ {square} v += (-r2).exp(); }} }}"));
    let systems = [
        (row, Form::Row),
        (plane, Form::Plane),
        (&bonds, Form::Terms),
        (&loops, Form::Terms),
        (&long, Form::Plain),
        (&before, Form::Pairs),
    ];
    for (system, form) in systems {
        let report = report(TokenStream::new(), tokens(system)).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(report.kick.form, form, "{report}");
        assert_runtime_knows(system);
    }
}

/// What `show` says of a kick beside its form: the faster layouts that do not apply, each with its loop and its reason.
#[test]
fn slower_kicks_have_reasons_and_fast_ones_have_none() {
    let points = "fn kinetic(&self, p: &[[f64; 3]]) -> f64 { p.iter().flatten().map(|p| 0.5 * p * p).sum() }";
    let pair = |energy: &str| {
        format!(
            "{points} fn potential(&self, q: &[[f64; 3]]) -> f64 {{ let mut v = 0.0; for i in 0..q.len() {{ for j in \
             0..i {{ let r2: f64 = (0..3).map(|d| (q[i][d] - q[j][d]).powi(2)).sum(); {energy} }} }} v }}"
        )
    };
    let numbers =
        |body: &str| format!("{KINETIC} fn potential(&self, q: &[f64]) -> f64 {{ let mut v = 0.0; {body} v }}");
    let rows: [(String, &[&str]); 15] = [
        (pair("v -= 1.0 / r2.sqrt();"), &[]),
        (pair("if r2 < 1.0 { v += (1.0 - r2).powi(2); }"), &[]),
        (numbers("for i in 0..q.len() - 1 { v += (q[i + 1] - q[i]).powi(4); }"), &[]),
        (numbers("for &(a, b) in &self.bonds { v += (q[a] - q[b]).powi(4); }"), &[]),
        (numbers("v = q[0] * q[1];"), &[]),
        (
            numbers("for i in 0..q.len() { for j in 0..q.len() { v += self.k[i][j] * q[i] * q[j]; } }"),
            &[
                "not `pairs`: the energy of a pair reads other bodies, or a parameter or condition of both bodies at once",
            ],
        ),
        (
            pair("if r2 < 1.0 { v += (1.0 - r2).powi(2); } v += r2;"),
            &["not `lists`: a term of a pair is outside of the condition on the distance"],
        ),
        (
            pair("if r2 < 1.0 + self.driven * q[i][0] * q[j][0] { v += r2; }"),
            &["not `lists`: the distance is compared with a number that changes during a run"],
        ),
        (
            pair("v += self.table[i][j] * r2;"),
            &[
                "not `pairs`: the energy of a pair reads other bodies, or a parameter or condition of both bodies at once",
            ],
        ),
        (
            pair("v += self.field[i] * q[i][0] * r2;"),
            &["not `pairs`: the macro cannot prove that exchanging the two bodies of a pair keeps its energy"],
        ),
        (
            numbers("for i in 0..q.len() - 5 { v += (q[i + 5] - q[i]).powi(4); }"),
            &[
                "not `line`: a site acts on another one that is more than 2 sites, 1 row or 1 plane away",
                "not `lanes` over i in 0..n - 5: an iteration adds to the gradient of two coordinates",
            ],
        ),
        (
            numbers("for &(a, b) in &self.bonds { v += (q[a + 1] - q[b]).powi(4); }"),
            &[
                "not `terms` over k in 0..bonds.len(): a term reads a coordinate at an index that is not in the list, such as",
            ],
        ),
        (
            pair("v += (-r2).exp();").replace(
                "let mut v = 0.0;",
                "let mut v = 0.0; for &(i, j) in &self.bonds { for d \
             in 0..5 { v += (self.k[d] * (q[i][0] - q[j][0])).sin(); } }",
            ),
            &["not `terms` over k in 0..bonds.len(): a term has an inner loop that is not written out"],
        ),
        (
            numbers("for i in 0..q.len() { for &j in &self.near[i] { if j > i { v += q[i] * q[j].powi(2); } } }"),
            &["not `terms` over k_2 in 0..near[k].len(): iterations depend on each other, or a branch reads"],
        ),
        (
            "fn kinetic(&self, p: [f64; 20]) -> f64 { p.iter().map(|p| p * p).sum() }
             fn potential(&self, q: [f64; 20]) -> f64 { (0..20).map(|i| (self.k[i] * q[i] * q[0]).sin()).sum() }"
                .to_owned(),
            &["not `lanes` over k in 0..20: there are fewer than 65 coordinates, or their number is not a literal"],
        ),
    ];
    for (functions, expected) in rows {
        let report = report(TokenStream::new(), tokens(&format!("impl S {{ {functions} }}"))).expect("no mistake");
        let slower: Vec<String> = report.kick.slower.iter().map(ToString::to_string).collect();
        let is_said = slower.len() == expected.len() && slower.iter().zip(expected).all(|(a, b)| a.starts_with(b));
        assert!(is_said, "{functions}\n{slower:#?}");
    }
}

#[test]
fn terms_beside_pairs_have_a_form_of_their_own() {
    let pairs = "for i in 0..q.len() { for j in 0..i { v += (q[i] - q[j]).powi(2).exp(); } }";
    let rows = [
        ("", None),
        ("v += self.offset;", None),
        ("for &(a, b) in &self.bonds { v += (q[a] - q[b]).powi(4); }", Some(Form::Terms)),
        ("for i in 0..q.len() - 1 { v += (q[i + 1] - q[i]).powi(4); }", Some(Form::Plain)),
    ];
    for (beside, form) in rows {
        let item = format!(
            "impl S {{
                fn kinetic(&self, p: &[f64]) -> f64 {{ p.iter().map(|p| 0.5 * p * p).sum() }}
                fn potential(&self, q: &[f64]) -> f64 {{ let mut v = 0.0; {pairs} {beside} v }}
            }}"
        );
        let report = report(TokenStream::new(), tokens(&item)).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!((report.kick.form, report.kick.others), (Form::Pairs, form), "{beside}: {report}");
        assert_eq!(report.to_string().contains("by eight; other terms: "), form.is_some(), "{report}");
    }
}

#[test]
fn operations_are_counted_in_their_loops() {
    let system = "impl Bodies {
        fn kinetic(&self, p: &[f64]) -> f64 {
            let mut v = 0.0;
            for i in 0..p.len() { v += 0.5 * p[i] * p[i]; }
            v
        }
        fn potential(&self, q: &[f64], t: f64) -> f64 {
            let mut v = 0.0;
            for i in 0..q.len() {
                v += t.cos() * q[i].sin();
                for j in 0..i {
                    v += 1.0 / (q[i] - q[j]);
                }
            }
            v
        }
    }";
    let report = report(TokenStream::new(), tokens(system)).expect("no mistake");
    let places: Vec<String> = report.kick.places.iter().map(ToString::to_string).collect();
    // For every pair: a distance, its reciprocal and square, and an addition to each body. For every body: cos q cos t; the runtime
    // calls the function of bodies alone for rows of them, so that cos t is computed for each.
    assert_eq!(
        places,
        [
            "per pair: 1 addition, 2 multiplications, 1 division, 1 branch, 2 coordinates moved",
            "per body: 1 multiplication, 2 cos, 1 coordinate moved"
        ]
    );
}

#[test]
fn compositions_are_proved_by_themselves_and_in_blocks() {
    let verlet = sequence(tokens("T(1/2) V(1) T(1/2)"), Some(2)).expect("order 2");
    assert_eq!((verlet.order, verlet.symmetric, verlet.force_evaluations), (2, true, 1));
    let terms: Vec<_> = verlet.error_terms.iter().map(|(bracket, _)| bracket.as_str()).collect();
    assert_eq!(terms, ["[T, [T, V]]", "[[T, V], V]"]);
    // exp(T/2) exp(V) exp(T/2) = exp(T + V - [T, [T, V]]/24 - [V, [T, V]]/12 + ...)
    for ((_, factor), expected) in verlet.error_terms.iter().zip([-1.0 / 24.0, 1.0 / 12.0]) {
        assert!((factor - expected).abs() < 1e-15, "{factor}");
    }
    let error = sequence(tokens("T(1/2) V(1) T(1/2)"), Some(3)).expect_err("order 2 alone");
    assert!(error.to_string().starts_with("declared order 3, but the proof finds order 2"), "{error}");
    let block = declared(tokens("struct A: order 2 = Verlet; struct B = triple_jump(A);")).expect("two compositions");
    assert_eq!(
        block.iter().map(|proved| (proved.name.as_str(), proved.order)).collect::<Vec<_>>(),
        [("A", 2), ("B", 4)]
    );
    assert!(declared(tokens("struct A: order 3 = Verlet;")).is_err());
}

/// Systems of textbooks, with the equations that are printed of them.
const TEXTBOOK: &[(&str, [&str; 2])] = &[
    (
        "pendulum: [f64; 1]",
        ["p[0].powi(2) / (2.0 * self.mass * self.length.powi(2))", "-self.mass * self.g * self.length * q[0].cos()"],
    ),
    ("oscillator: [f64; 1]", ["p[0] * p[0] / 2.0 / self.m", "self.k / 2.0 * q[0] * q[0]"]),
    (
        "Henon-Heiles: [f64; 2]",
        [
            "(p[0] * p[0] + p[1] * p[1]) / 2.0",
            "0.5 * (q[0].powi(2) + q[1].powi(2)) + self.lambda * (q[0].powi(2) * q[1] - q[1].powi(3) / 3.0)",
        ],
    ),
    ("Duffing: [f64; 1]", ["0.5 * p[0] * p[0]", "0.5 * self.alpha * q[0].powi(2) + self.beta / 4.0 * q[0].powi(4)"]),
    ("driven pendulum: [f64; 1], t", ["0.5 * p[0] * p[0]", "-(1.0 + self.a * (self.omega * t).cos()) * q[0].cos()"]),
    ("double well: [f64; 1]", ["0.5 * p[0] * p[0]", "self.height * ((q[0] / self.width).powi(2) - 1.0).powi(2)"]),
    (
        "FPUT: &[f64]",
        [
            "p.iter().map(|p| 0.5 * p * p).sum()",
            "let mut v = 0.0; for i in 0..q.len() - 1 { let d = q[i + 1] - q[i]; v += 0.5 * d * d + self.alpha / 3.0 * d.powi(3) + self.beta / 4.0 * d.powi(4); } v",
        ],
    ),
    ("Toda: &[f64]", ["p.iter().map(|p| 0.5 * p * p).sum()", "q.windows(2).map(|w| (w[0] - w[1]).exp()).sum()"]),
    ("Kepler: [f64; 2]", ["0.5 * (p[0] * p[0] + p[1] * p[1])", "-self.gm / (q[0] * q[0] + q[1] * q[1]).sqrt()"]),
    (
        "softened bodies: &[[f64; 3]]",
        [
            "p.iter().enumerate().map(|(i, p)| (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / (2.0 * self.m[i])).sum()",
            "let mut v = 0.0; for i in 0..q.len() { for j in 0..i { let r2: f64 = (0..3).map(|k| (q[i][k] - q[j][k]).powi(2)).sum(); v -= self.g * self.m[i] * self.m[j] / (r2 + self.eps * self.eps).sqrt(); } } v",
        ],
    ),
    (
        "Lennard-Jones with a cutoff: &[[f64; 2]]",
        [
            "p.iter().map(|p| 0.5 * (p[0] * p[0] + p[1] * p[1])).sum()",
            "let mut v = 0.0; for i in 0..q.len() { for j in 0..i { let (x, y) = (q[i][0] - q[j][0], q[i][1] - q[j][1]); let r2 = x * x + y * y; if r2 < self.cutoff * self.cutoff { let s6 = (self.sigma * self.sigma / r2).powi(3); v += 4.0 * self.epsilon * (s6 * s6 - s6); } } } v",
        ],
    ),
    (
        "nearest image: [f64; 2]",
        [
            "0.5 * (p[0] * p[0] + p[1] * p[1])",
            "let d = q[1] - q[0]; let d = d - self.l * (d / self.l).round(); 0.5 * self.k * d * d",
        ],
    ),
    (
        "phi^4 on a ring: [f64; 16]",
        [
            "p.iter().map(|p| 0.5 * p * p).sum()",
            "let mut v = 0.0; for i in 0..16 { v += 0.5 * (q[(i + 1) % 16] - q[i]).powi(2) + 0.25 * self.lambda * (q[i].powi(2) - 1.0).powi(2); } v",
        ],
    ),
    ("relativistic: [f64; 3]", ["(1.0 + p[0] * p[0] + p[1] * p[1] + p[2] * p[2]).sqrt()", "0.5 * q[0] * q[0]"]),
    (
        "relativistic oscillator: [f64; 1]",
        ["(self.m.powi(2) * self.c.powi(4) + p[0].powi(2) * self.c.powi(2)).sqrt()", "0.5 * self.k * q[0] * q[0]"],
    ),
    (
        "FODO: [f64; 1], t",
        [
            "0.5 * p[0] * p[0]",
            "let s = t % self.cell; let k = if s < self.cell / 2.0 { self.k } else { -self.k }; 0.5 * k * q[0] * q[0]",
        ],
    ),
    (
        "three bodies and angles: [[f64; 2]; 3]",
        [
            "p.iter().map(|p| 0.5 * (p[0] * p[0] + p[1] * p[1])).sum()",
            "let a = [q[1][0] - q[0][0], q[1][1] - q[0][1]]; let b = [q[2][0] - q[0][0], q[2][1] - q[0][1]]; let r = (a[0] * a[0] + a[1] * a[1]).sqrt(); let s = (b[0] * b[0] + b[1] * b[1]).sqrt(); let c = (a[0] * b[0] + a[1] * b[1]) / (r * s); self.lambda * (c + 1.0 / 3.0).powi(2) * (self.gamma / (r - self.a) + self.gamma / (s - self.a)).exp()",
        ],
    ),
    (
        "a layer: [f64; 2]",
        [
            "0.5 * (p[0] * p[0] + p[1] * p[1])",
            "let mut v = 0.0; for k in 0..8 { v += self.out[k] * (self.w[k] * q[0] + self.u[k] * q[1] + self.b[k]).tanh(); } v",
        ],
    ),
    (
        "Morse: [f64; 1]",
        ["p[0] * p[0] / (2.0 * self.mu)", "self.d * (1.0 - (-self.a * (q[0] - self.r0)).exp()).powi(2)"],
    ),
    (
        "a table: [f64; 1]",
        ["0.5 * p[0] * p[0]", "let x = q[0]; if x < 1.0 { 0.5 * x * x } else if x < 2.0 { x - 0.5 } else { 1.5 }"],
    ),
    (
        "a walled box: [f64; 1]",
        [
            "0.5 * p[0] * p[0]",
            "let mut v = 0.0; if q[0] > self.wall { v += 0.5 * self.k * (q[0] - self.wall).powi(2); } v + q[0].abs()",
        ],
    ),
    (
        "double pendulum without gravity: [f64; 2]",
        [
            "(self.m2 * self.l2.powi(2) * p[0].powi(2) + (self.m1 + self.m2) * self.l1.powi(2) * p[1].powi(2)) / 2.0",
            "-(self.m1 + self.m2) * self.g * self.l1 * q[0].cos() - self.m2 * self.g * self.l2 * q[1].cos()",
        ],
    ),
    (
        "standard map: [f64; 1]",
        [
            "0.5 * p[0].powi(2)",
            "self.k / (2.0 * std::f64::consts::PI).powi(2) * (2.0 * std::f64::consts::PI * q[0]).cos()",
        ],
    ),
    (
        "Coulomb and a magnetic bottle: [f64; 3]",
        [
            "0.5 * (p[0] * p[0] + p[1] * p[1] + p[2] * p[2])",
            "1.0 / (q[0].powi(2) + q[1].powi(2) + q[2].powi(2)).sqrt() + 0.5 * self.b.powi(2) * (q[0].powi(2) + q[1].powi(2))",
        ],
    ),
    (
        "rotors: [f64; 8]",
        [
            "p.iter().map(|p| p * p / 2.0).sum()",
            "let mut v = 0.0; for i in 0..8 { for j in 0..8 { v += 1.0 - (q[i] - q[j]).cos(); } } v * self.epsilon / (2.0 * 8.0)",
        ],
    ),
];

#[test]
fn it_is_shown_which_terms_are_quadratic() {
    let item = "impl System {
        fn hamiltonian(&self, q: [f64; 3], p: [f64; 3]) -> f64 {
            let mut energy = self.rate * (q[0] * p[1] - q[1] * p[0]);
            for i in 0..3 {
                energy += 0.5 * p[i] * p[i] + self.stiffness * (q[i] * q[i] + q[i].powi(4));
            }
            energy
        }
    }";
    let report = report(tokens("split = quadratic + rest"), tokens(item)).expect("a report");
    assert_eq!(
        report.parts,
        [
            "quadratic = rate (q[0] p[1] - q[1] p[0]) + Σ_{i in 0..3} (p[i]^2 / 2 + stiffness q[i]^2)",
            "rest = Σ_{i in 0..3} stiffness q[i]^4"
        ]
    );
}

#[test]
fn equations_match_hand_written_ones() {
    let mut text = String::new();
    for (name, [kinetic, potential]) in TEXTBOOK {
        let (title, shape) = name.split_once(": ").expect("a shape");
        let (shape, time) = shape.split_once(", ").map_or((shape, ""), |(shape, _)| (shape, ", t: f64"));
        let item = format!(
            "impl System {{
                fn kinetic(&self, p: {shape}) -> f64 {{ {kinetic} }}
                fn potential(&self, q: {shape}{time}) -> f64 {{ {potential} }}
            }}"
        );
        let report = report(TokenStream::new(), tokens(&item)).unwrap_or_else(|mistake| panic!("{name}: {mistake}"));
        text += &format!("{title}\n    {}\n\n", report.equations.join("\n    "));
    }
    assert_kept(&Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/report/equations.txt"), &text);
}

/// Long systems: what follows each other, with `I` for its number.
const LONG: &[(&str, &str)] = &[
    ("terms", "v += (I.5 * q[0]).sin() * (q[1] - I.25).powi(I);"),
    ("nested", "v = (v * q[1] + I.5).sin();"),
    ("pieces", "if q[0] * q[1] > I.5 { v = (I.25 * q[0]).exp(); }"),
    ("roots", "v += 1.0 / (q[0] * q[0] + (q[1] - I.5).powi(I)).sqrt();"),
];

/// A series is shown as a sum, with the first numbers and the last one of each table; an index of a loop is called apart from
/// the names in texts.
#[test]
fn series_are_shown_as_sums() {
    let terms: String = (2..=33).map(|k| format!("- 0.{k}5 * ({k}.0 * q[0] - {k}.5).exp()")).collect();
    let item = format!(
        "impl Series {{
            fn kinetic(&self, p: [f64; 1]) -> f64 {{ p[0] * p[0] / 2.0 }}
            fn potential(&self, q: [f64; 1]) -> f64 {{ self.k * q[0] {terms} }}
        }}"
    );
    let equations = report(TokenStream::new(), tokens(&item)).expect("no mistake").equations;
    let force = "dp[0]/dt = -Σ_{k_2 in 0..32} exp(q[0] ([2.0, 3.0, .., 33.0][k_2]) + [-2.5, -3.5, .., -33.5][k_2]) \
                 ([2.0, 3.0, .., 33.0][k_2]) ([-0.25, -0.35, .., -0.335][k_2]) - k";
    assert_eq!(equations, ["dq[0]/dt = p[0]", force]);
}

#[test]
fn every_system_is_shown_whole_in_lines_that_can_be_read() {
    for (name, statement) in LONG {
        let statements: String = (0..60).map(|at| statement.replace('I', &at.to_string())).collect();
        let item = format!(
            "impl Long {{
                fn kinetic(&self, p: [f64; 2]) -> f64 {{ p[0] * p[0] }}
                fn potential(&self, q: [f64; 2]) -> f64 {{ let mut v = q[0]; {statements} v }}
            }}"
        );
        let equations = report(TokenStream::new(), tokens(&item)).expect("no mistake").equations;
        let mut defined: Vec<&str> = Vec::new();
        for line in &equations {
            assert!(line.len() < 400, "{name}: {line}");
            if let Some(definition) = line.strip_prefix("where ") {
                let (own, value) = definition.split_once(" = ").expect("a definition");
                let words = value.split(|letter: char| !letter.is_alphanumeric());
                for word in words.filter(|word| word.starts_with('u') && word.len() > 1) {
                    assert!(defined.contains(&word), "{name}: {word} in {line}");
                }
                defined.push(own);
            }
        }
        assert!(defined.len() > 10, "{name}: {equations:#?}");
    }
}
