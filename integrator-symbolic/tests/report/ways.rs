//! What is shown of parts: how each moves and why, and the parts with exact flows of an H in one piece.

use crate::{report, tokens};

/// The body of `hamiltonian` for an H in one piece, and what is shown instead.
const WHOLE: [(&str, &[&str]); 7] = [
    // A charge in a uniform field: two gauges, of which one has an exact flow for all that is quadratic.
    (
        "((p[0] + self.b * q[1] / 2.0).powi(2) + (p[1] - self.b * q[0] / 2.0).powi(2)) / 2.0 + q[0].cos()",
        &[
            "explicit instead: `split = quadratic + rest`, of the same function:",
            "  quadratic = (2 p[0] + b q[1])^2 / 8 + (2 p[1] - b q[0])^2 / 8: a matrix exponential, since it is a \
             quadratic form in q and p",
            "  rest = cos(q[0]): a kick, since it depends on q only",
        ],
    ),
    (
        "((p[0] - self.b * q[0] * q[1]).powi(2) + p[1] * p[1]) / 2.0 + q[0].cos() * q[1]",
        &[
            "explicit instead: `split = a + b + c`, one function for each part:",
            "  a = (p[0] - b q[0] q[1])^2 / 2: a shear between two canonical shifts, since it depends on p[i] by p[i] - \
             a(q) only",
            "  b = p[1]^2 / 2: a drift, since it depends on p only",
            "  c = q[1] cos(q[0]): a kick, since it depends on q only",
        ],
    ),
    (
        "q[0].sin() * p[1] + q[1].cos() * p[0] + p[1] * p[1]",
        &[
            "explicit instead: `split = a + b`, one function for each part:",
            "  a = p[1] sin(q[0]) + p[1]^2: a shear, since it depends on no coordinate together with its conjugate",
            "  b = p[0] cos(q[1]): a shear, since it depends on no coordinate together with its conjugate",
        ],
    ),
    // What is quadratic, and what is not.
    (
        "q[0] * p[1] - q[1] * p[0] + (p[1] - q[0] * q[1].powi(2)).powi(4)",
        &[
            "explicit instead: `split = quadratic + rest`, of the same function:",
            "  quadratic = q[0] p[1] - q[1] p[0]: a matrix exponential, since it is a quadratic form in q and p",
            "  rest = (p[1] - q[0] q[1]^2)^4: a shear between two canonical shifts, since it depends on p[i] by p[i] - \
             a(q) only",
        ],
    ),
    (
        "p[0].powi(2) - q[0].cos()",
        &[
            "explicit instead: `split = a + b`, one function for each part:",
            "  a = p[0]^2: a drift, since it depends on p only",
            "  b = -cos(q[0]): a kick, since it depends on q only",
        ],
    ),
    (
        "p[0].powi(2) * (1.0 + q[0].powi(2)) + q[1].cos()",
        &["implicit, since no exact flow is known for the term p[0]^2 (1 + q[0]^2)"],
    ),
    (
        "(p[0] - q[0].tanh() * q[1]).powi(2) + p[1].powi(2)",
        &["implicit, since no exact flow is known for the term (p[0] - q[1] tanh(q[0]))^2"],
    ),
];

#[test]
fn parts_of_an_h_in_one_piece_are_shown() {
    for (body, expected) in WHOLE {
        let item = format!("impl S {{ fn hamiltonian(&self, q: [f64; 2], p: [f64; 2]) -> f64 {{ {body} }} }}");
        let report = report(tokens("split = none"), tokens(&item)).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(report.explicit, expected, "{body}");
        assert!(report.to_string().contains(&expected.join("\n")), "{report}");
    }
}

#[test]
fn the_way_of_each_named_part_is_shown() {
    let item = "impl S {
        fn orbit(&self, [x, y]: [f64; 2], [px, py]: [f64; 2]) -> f64 {
            px * px / 2.0 + py * py / 2.0 - 1.0 / (x * x + y * y).sqrt()
        }
        fn frame(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * p[1] - q[1] * p[0] }
        fn twist(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0].sin() * p[1] }
        fn field(&self, q: [f64; 2], p: [f64; 2]) -> f64 { (p[0] - q[0] * q[1]).cosh() }
        fn well(&self, q: [f64; 2]) -> f64 { q[0].cos() }
    }";
    let split = "split = orbit + frame + twist + field + well";
    let report = report(tokens(split), tokens(item)).unwrap_or_else(|error| panic!("{error}")).to_string();
    for line in [
        "flow of orbit: universal variables, since it is a sum of p²/2m - k/|q| over bodies\n",
        "flow of frame: a matrix exponential, since it is a quadratic form in q and p\n",
        "flow of twist: a shear, since it depends on no coordinate together with its conjugate\n",
        "flow of field: a shear between two canonical shifts, since it depends on p[i] by p[i] - a(q) only\n",
        "flow of well: plain code\n",
    ] {
        assert!(report.contains(line), "lacks {line}{report}");
    }
}
