//! Every message about parts that take inner steps.

use crate::{Row, check};

/// The annotation. The functions are `slow` and `bonds` of positions, `twist` of one coordinate of each conjugate pair, and
/// `kinetic` of momenta.
const ROWS: &[Row] = &[
    ("split = slow + 8 * (bonds + kinetic)", &[]),
    ("split = slow + 4 * BlanesMoan4(bonds + kinetic), compose = Aba864", &[]),
    ("split = slow + Yoshida4(bonds + kinetic)", &[]),
    ("split = slow + 2 * (bonds + 8 * my::Composition(twist + kinetic))", &[]),
    ("split = slow + 8 * (bonds + kinetic), compose = symmetric(1/(2 - cbrt(2)), _; Verlet)", &[]),
    ("split = slow + 8 * (bonds + kinetic), compose = T(1/2) V(1) T(1/2)", &[]),
    ("split = slow + 8 * (bonds + kinetic), order = 2", &[]),
    (
        "split = slow + 0 * (bonds + kinetic)",
        &[
            "1:15 the number of inner steps has to be positive\nhelp: write, for example, `split = slow + 8 * (bonds + kinetic)`",
        ],
    ),
    (
        "split = slow + -2 * (bonds + kinetic)",
        &[
            "1:15 the number of inner steps has to be positive\nhelp: write, for example, `split = slow + 8 * (bonds + kinetic)`",
        ],
    ),
    (
        "split = slow - 2 * (bonds + kinetic)",
        &["1:13 H has to be the sum of its parts\nhelp: put the sign into the function of the part"],
    ),
    (
        "split = slow + -bonds",
        &["1:15 H has to be the sum of its parts\nhelp: put the sign into the function of the part"],
    ),
    (
        "split = slow + 2.5 * (bonds + kinetic)",
        &[
            "1:15 the number of inner steps has to be an integer\nhelp: write, for example, `split = slow + 8 * (bonds + kinetic)`",
        ],
    ),
    (
        "split = slow + 5000000000 * (bonds + kinetic)",
        &[
            "1:15 the number of inner steps has to be at most 4294967295\nhelp: write, for example, `split = slow + 8 * (bonds + kinetic)`",
        ],
    ),
    (
        "split = slow + \"8\" * (bonds + kinetic)",
        &[
            "1:15 the number of inner steps has to be an integer\nhelp: write, for example, `split = slow + 8 * (bonds + kinetic)`",
        ],
    ),
    ("split = slow + 8u64 * (bonds + kinetic)", &[]),
    (
        "split = slow + steps * (bonds + kinetic)",
        &[
            "1:15 the number of inner steps has to be an integer literal, not `steps`\nhelp: choose the number at run time with `system.run_with(Verlet.nested(steps), start, h)`",
        ],
    ),
    (
        "split = slow + 8 (bonds + kinetic)",
        &[
            "1:15 expected `*` between the number of inner steps and the parts in parentheses\nhelp: write, for example, `split = slow + 8 * (bonds + kinetic)`",
        ],
    ),
    (
        "split = slow + (bonds + kinetic) * 8",
        &[
            "1:33 the number of inner steps has to be in front of the parts in parentheses\nhelp: write, for example, `split = slow + 8 * (bonds + kinetic)`",
        ],
    ),
    (
        "split = slow + 8 * bonds",
        &[
            "1:19 inner steps require at least two parts in parentheses\nhelp: write, for example, `split = slow + 8 * (bonds + kinetic)`\nnote: the flow of a single part is exact, so that one step of it is as accurate as many",
        ],
    ),
    (
        "split = slow + 8 * bonds + kinetic",
        &[
            "1:19 inner steps require at least two parts in parentheses\nhelp: write, for example, `split = slow + 8 * (bonds + kinetic)`\nnote: the flow of a single part is exact, so that one step of it is as accurate as many",
        ],
    ),
    (
        "split = slow + 8 * BlanesMoan4",
        &[
            "1:19 inner steps require at least two parts in parentheses\nhelp: write, for example, `split = slow + 8 * (bonds + kinetic)`\nnote: the flow of a single part is exact, so that one step of it is as accurate as many",
        ],
    ),
    (
        "split = slow + 8 *",
        &[
            "1:15 inner steps require at least two parts in parentheses\nhelp: write, for example, `split = slow + 8 * (bonds + kinetic)`\nnote: the flow of a single part is exact, so that one step of it is as accurate as many",
        ],
    ),
    (
        "split = slow + 8",
        &[
            "1:15 expected the names of functions for the parts of H\nhelp: write, for example, `split = kepler + interaction`",
        ],
    ),
    (
        "split = slow + 8 * ()",
        &[
            "1:20 expected names of parts of H in the parentheses\nhelp: write, for example, `split = slow + 8 * (bonds + kinetic)`",
        ],
    ),
    (
        "split = slow + 8 * (kinetic)",
        &[
            "1:19 inner steps require at least two parts in parentheses\nhelp: write, for example, `split = slow + 8 * (bonds + kinetic)`\nnote: the flow of a single part is exact, so that one step of it is as accurate as many",
        ],
    ),
    ("split = slow + 8 * (bonds + kinetic + bonds)", &["1:38 the part `bonds` is named twice"]),
    ("split = slow + 8 * (slow + kinetic)", &["1:20 the part `slow` is named twice"]),
    (
        "split = slow + 8 * (bonds + lost)",
        &["1:28 the impl lacks `fn lost(&self, q: [f64; N], p: [f64; N]) -> f64`, which `split` names"],
    ),
    (
        "split = slow + 8 * (bonds + 3)",
        &[
            "1:28 expected names of parts of H in the parentheses\nhelp: write, for example, `split = slow + 8 * (bonds + kinetic)`",
        ],
    ),
    ("split = slow + 2 * (bonds + (twist + kinetic))", &[]),
    ("split = slow + (bonds + 2 * (twist + kinetic))", &[]),
    (
        "split = slow + 2 * (a + 2 * (b + 2 * (c + 2 * (d + 2 * (bonds + kinetic)))))",
        &["1:55 parentheses are nested more than 4 deep\nhelp: move these parts into the parentheses around them"],
    ),
    (
        "split = 8 * (bonds + kinetic) + slow",
        &[
            "1:8 parts that take inner steps have to be the second part of H\nhelp: write, for example, `split = slow + 8 * (bonds + kinetic)`",
        ],
    ),
    (
        "split = 8 * (bonds + kinetic)",
        &[
            "1:8 parts that take inner steps have to be the second part of H\nhelp: write, for example, `split = slow + 8 * (bonds + kinetic)`",
        ],
    ),
    (
        "split = Yoshida4(bonds + kinetic) + slow",
        &[
            "1:8 parts that take inner steps have to be the second part of H\nhelp: write, for example, `split = slow + 8 * (bonds + kinetic)`",
        ],
    ),
    (
        "split = slow + 8 * (bonds + kinetic) + twist",
        &[
            "1:39 parts in parentheses have to be the last part of H\nhelp: move the parts that follow into the parentheses",
        ],
    ),
    (
        "split = slow + bonds + 8 * (twist + kinetic)",
        &[
            "1:15 parts in parentheses have to be the second of two parts\nhelp: move this part into the parentheses, or remove them",
        ],
    ),
    (
        "split = slow + 2 * (bonds + twist + 8 * (kinetic + kinetic))",
        &[
            "1:28 parts in parentheses have to be the second of two parts\nhelp: move this part into the parentheses, or remove them",
        ],
    ),
    (
        "split = slow + 8 * (bonds + kinetic), compose = symmetric(V(1/6) T(1/2) V(2/3, -1/72) T(_) V(_))",
        &[
            "1:79 a force-gradient kick requires H = ½ pᵀ M⁻¹ p + V(q), without inner steps\nhelp: use a composition such as `Verlet`, `Yoshida4` or `Aba864`",
        ],
    ),
    (
        "split = slow + 8 * V(1/2)(bonds + kinetic)",
        &[
            "1:21 expected names of parts of H in the parentheses\nhelp: write, for example, `split = slow + 8 * (bonds + kinetic)`",
        ],
    ),
    (
        "split = slow + 8 * (bonds + kinetic), compose = processed(T(1/10) V(1/7); Verlet)",
        &[
            "1:48 a processor does not support inner steps\nhelp: use a composition such as `Verlet`, `Yoshida4` or `Aba864`",
        ],
    ),
];

#[test]
fn inner_steps() {
    check(ROWS, |arguments| {
        let functions = "fn slow(&self, q: [f64; 2]) -> f64 { q[0].cos() } \
                         fn bonds(&self, q: [f64; 2]) -> f64 { 50.0 * q[0] * q[0] + q[1].powi(4) } \
                         fn twist(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0] * q[0] * p[1] } \
                         fn kinetic(&self, p: [f64; 2]) -> f64 { 0.5 * (p[0] * p[0] + p[1] * p[1]) }";
        let used = |name: &str| arguments.contains(name);
        let functions =
            functions.split("fn ").skip(1).filter(|function| used(function.split('(').next().unwrap_or_default()));
        let functions: String = functions.map(|function| format!("fn {function}")).collect();
        (arguments.to_owned(), format!("impl System {{\n{functions} }}"))
    });
}
