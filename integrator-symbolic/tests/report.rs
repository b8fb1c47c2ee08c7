//! What is derived, for people.

use integrator_symbolic::{Form, Place, declared, report, sequence};
use proc_macro2::TokenStream;

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
    assert_eq!(report.equations, ["dq[0]/dt = 2 / (2.0 * mass) p[0]", "dp[0]/dt = (-torque) sin(q[0])"]);
    assert!(report.quadratic_kinetic && report.autonomous);
    // A product in the drift; a sine and a product in the kick.
    assert_eq!((report.operations_written, report.operations_shared), (3, 3));
    assert!(report.to_string().contains("3 with what is shared computed once"));
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

#[test]
fn mistakes_have_no_report() {
    let error = report(TokenStream::new(), tokens("impl Nothing {}")).expect_err("two functions are missing");
    assert_eq!(error.into_iter().count(), 2);
}

const KINETIC: &str = "fn kinetic(&self, p: &[f64]) -> f64 { p.iter().map(|p| 0.5 * p * p).sum() }";

#[test]
fn flows_have_the_form_that_is_written() {
    let rows = [
        (KINETIC, "for i in 0..q.len() - 1 { v += (q[i + 1] - q[i]).powi(4); }", Form::Line),
        (KINETIC, "for i in 0..q.len() { for j in 0..i { v += (q[i] - q[j]).powi(2).exp(); } }", Form::Tiles),
        (KINETIC, "v = q[0] * q[1];", Form::Plain),
    ];
    for (kinetic, body, form) in rows {
        let potential = format!("fn potential(&self, q: &[f64]) -> f64 {{ let mut v = 0.0; {body} v }}");
        let report = report(TokenStream::new(), tokens(&format!("impl S {{ {kinetic} {potential} }}")));
        assert_eq!(report.expect("no mistake").kick.form, form, "{body}");
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
    for (system, form) in [(row, Form::Row), (plane, Form::Plane)] {
        let report = report(TokenStream::new(), tokens(system)).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(report.kick.form, form, "{report}");
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
    let places: Vec<String> = report
        .kick
        .places
        .iter()
        .map(|Place { loops, operations }| format!("{}: {operations}", loops.join(", ")))
        .collect();
    // Once: the cosine of the time. For every body: its slope, cos q cos t, and what the pairs do to it added to that. For
    // every pair: a distance, its square, the reciprocal, and an addition to the sum.
    assert_eq!(
        places,
        [
            ": 1 cos",
            "i in 0..n: 1 addition, 1 multiplication, 1 cos, 1 coordinate moved",
            "i in 0..n, j in 0..i: 2 additions, 1 multiplication, 1 division, 1 coordinate moved"
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
