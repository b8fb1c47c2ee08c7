//! How much is written: as much as there are formulas, whatever the number of sites.

use integrator_symbolic::hamiltonian;
use proc_macro2::{TokenStream, TokenTree};

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

/// What is left without digits. Small buffers are arrays and large ones are tables, and up to 64 coordinates no loop is in
/// lanes; that aside, there is no difference.
fn skeleton(sites: u64) -> String {
    let letters = expansion(&lattice(sites)).replace(|character: char| character.is_ascii_digit(), "");
    letters.replace("runtime :: repeated ( , Scalar :: of (.))", "[Scalar :: of (.) ; ]")
}

#[test]
fn a_larger_lattice_has_longer_numbers_alone() {
    let small = skeleton(100);
    assert!(small == skeleton(1_000) && small == skeleton(1_000_000), "{small}");
}

/// A sum whose terms have a variable named like it is none that reads itself, and stays a loop of any length.
#[test]
fn a_name_like_that_of_a_sum_is_another_variable() {
    let sum = |sites: u64| {
        let item = format!(
            "impl System {{
                fn kinetic(&self, p: [f64; 16]) -> f64 {{ p.iter().map(|p| p * p).sum() }}
                fn potential(&self, q: [f64; 16]) -> f64 {{
                    let mut v = 0.0;
                    for i in 0..{sites} {{
                        v += q.iter().map(|v| (v * i as f64).sin()).sum::<f64>().powi(2);
                        for v in q {{ debug_assert!(v.is_finite()); let _ = v * v; }}
                    }}
                    v
                }}
            }}"
        );
        tokens(expansion(&item).parse().expect("tokens"))
    };
    assert_eq!(sum(4), sum(16));
}

/// A pair takes some 900 bytes of tokens in the kick (three differences, a reciprocal cube, six updates), half of that in the
/// field, as much as in the kick in the energy and its part of the derivatives' documentation, and twice that in the Hessian. The logarithmic kick returns the
/// energy, whose pairs it names for the gradient already. Each of 55 prepared constants has a function of some 60 bytes.
#[test]
fn ten_bodies_written_out_stay_below_a_size() {
    let item = ten_bodies();
    let written = expansion(&item).len() - item.len();
    assert!((45_000..216_000).contains(&written), "{written} bytes");
}

/// Systems that grow along one axis of the language: what is in front, what is there once for each number `I` (`N` is
/// the next one), what joins these, and what is behind. Beside `self`, `q` is known, of as many coordinates as there
/// are parts.
const AXES: &[(&str, [&str; 4])] = &[
    ("terms", ["", "I.5 * q[0].sin() * (q[1] - I.25).powi(2)", " + ", ""]),
    ("factors", ["", "(q[0] - I.5).sin()", " * ", ""]),
    ("coordinates", ["", "q[I].sin() * q[(I + 1) % 2]", " + ", ""]),
    ("parameters", ["", "self.k[I] * (self.k[I] * q[0]).sin() * q[1]", " + ", ""]),
    ("powers", ["", "q[0].powi(I) / q[1].powi(N)", " + ", ""]),
    ("variables", ["let x_0 = q[0] * q[1];", "let x_N = x_I * q[1].sin() + x_I;", "", "x_N"]),
    (
        "variables of two",
        ["let (x_0, y_0) = (q[0], q[1]);", "let (x_N, y_N) = (x_I.sin() * y_I, x_I + y_I);", "", "x_N * y_N"],
    ),
    ("arrays", ["let mut a = [q[0], q[1]];", "a[0] = a[1] * I.5 + a[0].sin();", "", "a[0]"]),
    ("closures", ["let f = |x: f64| x.sin() * q[1];", "f(I.5 * q[0])", " + ", ""]),
    ("loops", ["let mut v = 0.0;", "for i in 0..3 { v += (I.5 * q[i]).sin(); }", "", "v"]),
    ("loops in loops", ["", "(0..3).map(|i_I| q[i_I].sin() * ", "", "1.0"]),
    ("roots", ["let v = q[0];", "let v = (v * q[1] + I.5).sqrt();", "", "v"]),
    ("kinks", ["let v = q[0];", "let v = v.max(I.5 * q[1]).sqrt();", "", "v"]),
    ("walls", ["let mut v = q[1];", "if q[0] > self.wall[I] { v += 0.5 * (q[0] - self.wall[I]).powi(2); }", "", "v"]),
    (
        "walls on both sides",
        ["let mut v = q[1];", "if q[0] > self.wall[I] { v += q[0].exp(); } else { v -= q[1].exp(); }", "", "v"],
    ),
    ("products by branches", ["let mut v = q[1];", "if q[0] > self.wall[I] { v *= q[1].cosh(); }", "", "v"]),
    (
        "choices of the last",
        ["let v = q[1];", "let v = if q[0] > self.wall[I] { v.sin() } else { v * 1.5 + q[1] };", "", "v"],
    ),
    ("branches on the last", ["let mut v = q[1];", "if v > I.5 { v = v.sin(); } else { v = v * q[1]; }", "", "v"]),
    (
        "branches on parameters",
        ["let mut v = q[1];", "if self.w > I.5 { v = v.sin(); } else { v = v * q[1]; }", "", "v"],
    ),
    (
        "two variables",
        [
            "let (mut v, mut u) = (q[0], q[1]);",
            "if v > u + I.5 { v = v.sin(); u = u + v; } else { v = v * u; u = u.cos(); }",
            "",
            "v * u",
        ],
    ),
    ("pieces", ["", "if q[0] < I.5 { I.25 * q[0] * q[0] }", " else ", " else { q[1] * q[1] }"]),
    ("numbers of pieces", ["let x = q[0]; q[1] * ", "if x < I.5 { I.25 }", " else ", " else { 1.0 }"]),
    (
        "pieces of anything",
        ["", "if q[0] * q[0] < I.5 + q[1] { (I.25 * q[0]).sin() }", " else ", " else { q[1] * q[1] }"],
    ),
    ("pieces that return", ["", "if q[0] < I.5 { return I.25 * q[0] * q[0]; }", "", "q[1] * q[1]"]),
    (
        "pieces that may return",
        ["let mut v = q[1];", "if q[0] < I.5 { if q[1] < I.5 { return I.25 * v; } v += I.5 * q[0].sin(); }", "", "v"],
    ),
    ("pieces that replace", ["let mut v = q[1];", "if q[0] > I.5 { v = I.25 * q[0] * q[0]; }", "", "v"]),
    ("pieces in pieces", ["", "if q[0] > I.5 { I.25 * q[1] * q[0] } else {", "", "q[1]"]),
    ("arms", ["match self.kind {", "I => I.5 * q[0].sin(),", "", "_ => q[1].cos() }"]),
    ("conditions", ["if ", "q[0] > -I.5", " && ", "{ q[0].sin() } else { q[1] * q[1] }"]),
    (
        "iterations that are left",
        ["let mut v = 0.0; for i in 0..3 {", "if q[i] > I.5 { continue; } v += I.5 * q[i] * q[i];", "", "} v"],
    ),
];

/// A system that is `count` long along an axis.
fn along([front, part, joint, end]: [&str; 4], count: usize) -> String {
    let of = |text: &str, at: usize| text.replace('N', &(at + 1).to_string()).replace('I', &at.to_string());
    let parts: Vec<String> = (0..count).map(|at| of(part, at)).collect();
    // What the parts leave open is closed behind them.
    let closing = match part {
        _ if part.ends_with('{') => "}",
        _ if part.ends_with("* ") => ").sum::<f64>()",
        _ => "",
    };
    let (parts, end, closed) = (parts.join(joint), of(end, count - 1), closing.repeat(count));
    let coordinates = count.max(3);
    format!(
        "impl Growing {{
            fn kinetic(&self, p: [f64; {coordinates}]) -> f64 {{ p[0] * p[0] / 2.0 }}
            fn potential(&self, q: [f64; {coordinates}]) -> f64 {{ {front} {parts} {end} {closed} }}
        }}"
    )
}

/// How many tokens there are, with those in brackets.
fn tokens(text: TokenStream) -> usize {
    let of = |tree| match tree {
        TokenTree::Group(group) => 2 + tokens(group.stream()),
        _ => 1,
    };
    text.into_iter().map(of).sum()
}

#[test]
fn generated_code_grows_linearly_with_the_source() {
    let mut faster = Vec::new();
    for (name, axis) in AXES {
        let [once, twice] = [12, 24].map(|count| {
            let item: TokenStream = along(*axis, count).parse().expect("tokens");
            let (read, written) = (tokens(item.clone()), hamiltonian(TokenStream::new(), item));
            assert!(!written.to_string().contains("compile_error"), "{name}: {written}");
            tokens(written) - read
        });
        // Twice as many parts, and a tenth for what is asked once more where conditions are halved.
        if 10 * twice > 22 * once {
            faster.push(format!("{name}: {once} and {twice} tokens"));
        }
    }
    assert_eq!(faster, [""; 0]);
}

/// A table of 120 lines may be written as pieces that follow each other; `PIECES` asks for longer ones. One test per kind, so that
/// they run concurrently.
mod as_many_pieces_as_a_table_has_lines {
    use super::{AXES, TokenStream, along, hamiltonian};
    use std::env;

    fn are_taken(name: &str) {
        let axis = AXES.iter().find(|(known, _)| *known == name).expect("an axis").1;
        let pieces = env::var("PIECES").ok().and_then(|text| text.parse().ok()).unwrap_or(120);
        let item: TokenStream = along(axis, pieces).parse().expect("tokens");
        let written = hamiltonian(TokenStream::new(), item).to_string();
        assert!(!written.contains("compile_error"), "{name}");
    }

    #[test]
    fn that_add() {
        are_taken("pieces");
    }
    #[test]
    fn that_return() {
        are_taken("pieces that return");
    }
    #[test]
    fn that_replace() {
        are_taken("pieces that replace");
    }
}

/// Forces of a bar that rotates in a halo: one condition in so many subexpressions.
fn bar(terms: usize) -> String {
    let kinds = [
        |i| format!("(w * {i}.5 + x).sin()"),
        |i| format!("(w + y * {i}.5).exp()"),
        |i| format!("(w * w + {i}.1 + x * x).sqrt()"),
        |i| format!("w * x * y / ({i}.2 + w * w)"),
    ];
    let sum: Vec<String> = (1..terms + 1).map(|i| kinds[i % 4](i)).collect();
    format!(
        "impl Bar {{
            fn kinetic(&self, p: [f64; 2]) -> f64 {{ p.iter().map(|p| p * p / 2.0).sum() }}
            fn potential(&self, q: [f64; 2], t: f64) -> f64 {{
                let (s, c) = (self.speed * t).sin_cos();
                let (x, y) = (c * q[0] + s * q[1], c * q[1] - s * q[0]);
                let r = (x * x + y * y + 0.01).sqrt();
                let w = if r < self.a {{ r * r }} else {{ self.a / r }};
                {}
            }}
        }}",
        sum.join(" + ")
    )
}

/// Expands with Taylor's recurrences, and returns how many fused products an order has, and whether orders are compiled one by one.
fn recurrences(item: &str) -> (usize, bool) {
    let text = hamiltonian("taylor".parse().expect("tokens"), item.parse().expect("tokens")).to_string();
    assert!(!text.contains("compile_error"), "{text}");
    let order = &text[text.find("fn order <").expect("recurrences")..];
    let order = &order[..order.find("] impl ").unwrap_or(order.len())];
    (order.matches(". fma (").count(), text.contains("const ROLLED : bool = false"))
}

/// Orders are compiled one by one where that is little code: with 28 of them, and sums of up to 14 lines, each product of an
/// order is compiled some 200 times.
#[test]
fn orders_are_unrolled_while_they_are_short() {
    let mut systems: Vec<String> = (0..7).map(|exponent| bar(1 << exponent)).collect();
    systems.push(ten_bodies());
    for degree in (2..40).step_by(4) {
        let terms: Vec<String> = (2..degree).map(|i| format!("(q[0] * {i}.0 + q[1]).powi({i})")).collect();
        systems.push(format!(
            "impl Polynomial {{
                fn kinetic(&self, p: [f64; 2]) -> f64 {{ p[0] * p[0] + p[1] * p[1] }}
                fn potential(&self, q: [f64; 2]) -> f64 {{ q[0] * q[0] {} }}
            }}",
            terms.iter().map(|term| format!("+ {term}")).collect::<String>()
        ));
    }
    let (mut unrolled, mut longest) = (0, 0);
    for system in &systems {
        let (products, is_unrolled) = recurrences(system);
        // Ten thousand operations are 50 products of orders; a line has two, and as many come after the sums.
        assert!(!is_unrolled || products < 400, "{products} products in\n{system}");
        unrolled += usize::from(is_unrolled);
        longest = longest.max(products);
    }
    assert!(unrolled > 1 && unrolled < systems.len() - 1, "{unrolled} of {}", systems.len());
    assert!(longest > 500, "{longest}");
}

/// Equations that fill more than a page are left out of the code.
#[test]
fn short_equations_are_stated() {
    let potential = |terms: u64| {
        let terms: Vec<String> = (0..terms).map(|i| format!("self.depth_{i} * (self.rate_{i} * q[0]).cos()")).collect();
        format!(
            "impl Wells {{
                fn kinetic(&self, p: [f64; 1]) -> f64 {{ 0.5 * p[0] * p[0] }}
                fn potential(&self, q: [f64; 1]) -> f64 {{ {} }}
            }}",
            terms.join(" + ")
        )
    };
    assert!(expansion(&potential(2)).contains("\"V = depth_0 cos(rate_0 q[0]) + depth_1 cos(rate_1 q[0])\""));
    assert!(!expansion(&potential(30)).contains("EQUATIONS"));
}
