//! Hamiltonians that rustc would compile for minutes, which the macro rejects before it differentiates them.

use crate::{errors, tokens};
use integrator_symbolic::report;

/// Helper methods that each call the next one twice, called by `f`, which has `q` and `p`.
fn item(levels: usize, functions: &str) -> String {
    let helpers = (1..=levels).map(|level| {
        let last = level - 1;
        format!("fn h{level}(&self, x: f64) -> f64 {{ self.h{last}(x + 0.{level}) * self.h{last}(0.9 * x) }} ")
    });
    let helpers: String = helpers.collect();
    format!("impl System {{ fn h0(&self, x: f64) -> f64 {{ x.sin() + 0.1 * x * x }} {helpers}{functions} }}")
}

#[test]
fn too_many_operations_are_an_error_at_the_largest_function() {
    // The line has the helper methods in front of the functions.
    let functions = [
        (
            "",
            "kinetic",
            "fn potential(&self, q: [f64; 1]) -> f64 { self.h2(q[0]) } fn kinetic(&self, p: [f64; 1]) -> f64 { self.hN(p[0]) }",
        ),
        (
            "",
            "potential",
            "fn kinetic(&self, p: [f64; 1]) -> f64 { self.h2(p[0]) } fn potential(&self, q: [f64; 1]) -> f64 { self.hN(q[0]) }",
        ),
        ("", "hamiltonian", "fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { p[0] * p[0] + self.hN(q[0]) }"),
        (
            "split = none, compose = GaussLegendre4",
            "hamiltonian",
            "fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { self.hN(q[0] * p[0]) }",
        ),
        (
            "split = a + b + c",
            "c",
            "fn a(&self, p: [f64; 1]) -> f64 { p[0] * p[0] } fn b(&self, q: [f64; 1]) -> f64 { q[0] } fn c(&self, p: [f64; 1]) -> f64 { self.hN(p[0]) }",
        ),
    ];
    for (arguments, name, text) in functions {
        let of = |levels: usize| item(levels, &text.replace('N', &levels.to_string()));
        let large = of(11);
        let found = errors(arguments, &large);
        let column = large.find(&format!("fn {name}(")).expect("a function") + 3;
        let start = format!("1:{column} H and its derivatives have more than 15000 operations, here about ");
        assert!(found.len() == 1 && found[0].starts_with(&start), "{found:#?}");
        assert!(found[0].contains("help: write terms") && found[0].contains("`#[derivative(slope)]`"), "{found:#?}");
        // A quarter of them compile.
        assert!(report(tokens(arguments), tokens(&of(9))).is_ok(), "{arguments} {name}");
    }
}

/// The energy alone has enough operations where its gradient, which takes seconds, would have too many.
#[test]
fn more_levels_are_rejected_as_fast() {
    for levels in [13, 16, 40] {
        let text = format!(
            "fn kinetic(&self, p: [f64; 1]) -> f64 {{ p[0] * p[0] }} fn potential(&self, q: [f64; 1]) -> f64 {{ self.h{levels}(q[0]) }}"
        );
        let found = errors("", &item(levels, &text));
        assert!(found.len() == 1 && found[0].contains(" operations"), "{found:#?}");
    }
}
