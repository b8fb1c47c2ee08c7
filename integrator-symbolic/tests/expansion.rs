//! What `#[hamiltonian]` writes, as reviewed text: the user's item is left out, the rest is formatted and stored.

use integrator_symbolic::hamiltonian;

/// The stepper alone.
fn stepper(arguments: &str, item: &str) -> String {
    let (arguments, item) = (arguments.parse().expect("tokens"), item.parse().expect("tokens"));
    let mut file: syn::File = syn::parse2(hamiltonian(arguments, item)).expect("items");
    assert!(matches!(file.items.remove(0), syn::Item::Impl(_)), "the user's item comes first");
    prettyplease::unparse(&file)
}

#[test]
fn pendulum() {
    insta::assert_snapshot!(stepper(
        "compose = Yoshida4",
        "impl Pendulum {
            fn kinetic(&self, p: [f64; 1]) -> f64 { p[0].powi(2) / (2.0 * self.mass * self.length.powi(2)) }
            fn potential(&self, q: [f64; 1]) -> f64 { -self.mass * self.gravity * self.length * q[0].cos() }
        }"
    ));
}

#[test]
fn functions_of_the_flows_are_fast_where_that_is_asked() {
    let item = "impl Rotor {
        fn kinetic(&self, p: [f64; 1]) -> f64 { 0.5 * p[0] * p[0] }
        fn potential(&self, q: [f64; 1]) -> f64 { self.strength.sin() * q[0].cos() + q[0].exp() * q[0].sinh() }
    }";
    let fast = stepper("functions = fast", item);
    for (text, expected) in [
        (".fast_sin()", true),
        (".fast_cos()", true),
        ("self.strength.sin()", true),
        (".fast_exp()", true),
        (".fast_sinh", false),
    ] {
        assert_eq!(fast.contains(text), expected, "{text} in\n{fast}");
    }
    assert_eq!(stepper("functions = precise", item), stepper("", item));
}

/// The generated code is held against the user's functions, which are called as their signatures say.
#[test]
fn the_functions_are_called_as_they_are() {
    let rows = [
        ("&self, q: [f64; 1]", "_time", "self, *q"),
        ("&self, q: ([[f64; 3]; 4]), t: f64", "time", "self, *q, time"),
        ("&self, q: &[f64; 1], _: &f64", "time", "self, q, &time"),
        ("&self, &[x]: &[f64; 1]", "_time", "self, q"),
        ("&self, q: &[f64]", "_time", "self, q"),
        ("&self, q: &mut [[f64; 2]]", "_time", "self, &mut q.clone()"),
        ("&self, q: &Vec<[f64; 3]>", "_time", "self, q"),
        ("&self, q: &&[f64]", "_time", "self, &&q[..]"),
        ("&self, q: &&[f64; 2]", "_time", "self, &q"),
        ("q: [f64; 1]", "_time", "*q"),
    ];
    for (signature, time, arguments) in rows {
        let kind: syn::ImplItemFn = syn::parse_str(&format!("fn f({signature}) {{}}")).expect("a function");
        let of_coordinates = |argument: &syn::FnArg| match argument {
            syn::FnArg::Typed(argument) => Some(quote::quote!(#argument).to_string()),
            syn::FnArg::Receiver(_) => None,
        };
        let own = kind.sig.inputs.iter().find_map(of_coordinates).expect("coordinates");
        let kind = own.split_once(':').expect("a type").1;
        let text = stepper(
            "",
            &format!(
                "impl System {{
                    fn kinetic(&self, p: {kind}) -> f64 {{ 0.0 }}
                    fn potential({signature}) -> f64 {{ 0.0 }}
                }}"
            ),
        );
        let text = text.split_once("fn stated_potential").expect("the call").1;
        let expected =
            format!("(&self, q: &Self::Coords, {time}: f64) -> f64 {{\n            Self::potential({arguments})");
        assert!(text.starts_with(&expected), "{signature}: {text}");
    }
}

#[test]
fn henon_heiles() {
    insta::assert_snapshot!(stepper(
        "",
        "impl HenonHeiles {
            fn kinetic(&self, [px, py]: [f64; 2]) -> f64 { 0.5 * (px * px + py * py) }
            fn potential(&self, [x, y]: [f64; 2]) -> f64 { 0.5 * (x * x + y * y) + x * x * y - y.powi(3) / 3.0 }
        }"
    ));
}

#[test]
fn recurrences_of_a_pendulum() {
    insta::assert_snapshot!(recurrences(
        "impl Pendulum {
            fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] / (2.0 * self.mass) }
            fn potential(&self, q: [f64; 1]) -> f64 { -self.strength * q[0].cos() }
        }"
    ));
}

#[test]
fn recurrences_of_pairs_within_reach() {
    insta::assert_snapshot!(recurrences(
        "impl Cluster {
            fn kinetic(&self, p: &[[f64; 2]]) -> f64 { p.iter().map(|[x, y]| 0.5 * (x * x + y * y)).sum() }
            fn potential(&self, q: &[[f64; 2]]) -> f64 {
                let mut energy = 0.0;
                for i in 0..q.len() {
                    for j in 0..i {
                        let square = (q[i][0] - q[j][0]).powi(2) + (q[i][1] - q[j][1]).powi(2);
                        if square < self.reach { energy += 1.0 / square.powi(3) - (1.0 + square).ln(); }
                    }
                }
                energy
            }
        }"
    ));
}

#[test]
fn recurrences_of_a_chain_between_walls() {
    insta::assert_snapshot!(recurrences(
        "impl Chain {
            fn kinetic(&self, p: [f64; 32]) -> f64 { p.iter().map(|p| p * p / 2.0).sum() }
            fn potential(&self, q: [f64; 32]) -> f64 {
                let mut energy = q[0].powi(4) / 4.0 + q[31].powi(4) / 4.0;
                for i in 1..32 {
                    energy += (q[i] - q[i - 1]).powi(3) / 3.0;
                }
                energy
            }
        }"
    ));
}

/// What is written beside the stepper where Taylor series are asked for.
fn recurrences(item: &str) -> String {
    let text = stepper("taylor", item);
    let (before, after) = text.split_once("    /// The coefficients that recurrences read.").expect("a tape");
    let iterations =
        before.split_once("    /// What an iteration of a loop keeps.").map_or("", |(_, iterations)| iterations);
    assert!(!stepper("", item).contains("Recurrences"), "nothing is written unasked");
    format!("{iterations}{after}")
}

#[test]
fn kepler() {
    insta::assert_snapshot!(stepper(
        "",
        "impl Kepler {
            fn kinetic(&self, p: &[f64; 2]) -> f64 { 0.5 * (p[0] * p[0] + p[1] * p[1]) }
            fn potential(&self, q: &[f64; 2]) -> f64 { -self.mu / (q[0].powi(2) + q[1] * q[1]).sqrt() }
        }"
    ));
}

#[test]
fn outer_solar_system() {
    insta::assert_snapshot!(stepper(
        "compose = Yoshida4",
        "impl Solar {
            fn kinetic(&self, p: &[[f64; 3]; 6]) -> f64 {
                let mut t = 0.0;
                for i in 0..6 {
                    for d in 0..3 { t += p[i][d] * p[i][d] / (2.0 * self.mass[i]); }
                }
                t
            }
            fn potential(&self, q: &[[f64; 3]; 6]) -> f64 {
                let mut v = 0.0;
                for i in 0..6 {
                    for j in 0..i {
                        let mut r2 = 0.0;
                        for d in 0..3 { let dx = q[i][d] - q[j][d]; r2 += dx * dx; }
                        v -= self.gravity * self.mass[i] * self.mass[j] / r2.sqrt();
                    }
                }
                v
            }
        }"
    ));
}

#[test]
fn driven_relativistic_oscillator() {
    insta::assert_snapshot!(stepper(
        "",
        "impl Driven {
            fn kinetic(&self, p: [f64; 1]) -> f64 { (1.0 + p[0] * p[0]).sqrt() }
            fn potential(&self, q: [f64; 1], t: f64) -> f64 {
                q[0].powi(2) / 2.0 - self.amplitude * q[0] * (self.omega * t).cos()
            }
        }"
    ));
}

/// A chain of so many nonlinear springs, with a helper method.
fn chain(length: u32) -> String {
    let text = "impl Chain {
            fn kinetic(&self, p: &[f64; LENGTH]) -> f64 {
                let mut t = 0.0;
                for i in 0..LENGTH { t += 0.5 * p[i] * p[i]; }
                t
            }
            fn potential(&self, q: &[f64; LENGTH]) -> f64 {
                let mut v = self.spring(q[0]) + self.spring(-q[LAST]);
                for i in 0..LAST { v += self.spring(q[i + 1] - q[i]); }
                v
            }
            fn spring(&self, d: f64) -> f64 { 0.5 * d * d + self.alpha / 3.0 * d.powi(3) + self.beta / 4.0 * d.powi(4) }
        }";
    text.replace("LENGTH", &length.to_string()).replace("LAST", &(length - 1).to_string())
}

#[test]
fn chain_with_a_helper() {
    insta::assert_snapshot!(stepper("", &chain(32)));
}

/// Closed rows that lie open one beside the other.
#[test]
fn rotors_on_a_plane() {
    insta::assert_snapshot!(stepper(
        "",
        "impl Rotors {
            fn kinetic(&self, p: &[[f64; 64]]) -> f64 {
                let mut t = 0.0;
                for i in 0..p.len() {
                    for j in 0..64 { t += p[i][j].powi(2) / (2.0 * self.inertia[i][j]); }
                }
                t
            }
            fn potential(&self, q: &[[f64; 64]]) -> f64 {
                let mut v = 0.0;
                for i in 0..q.len() {
                    for j in 0..64 { v -= self.along[j] * (q[i][(j + 1) % 64] - q[i][j]).cos(); }
                }
                for i in 0..q.len() - 1 {
                    for j in 0..64 { v -= self.across[i] * (q[i + 1][j] - q[i][j]).cos(); }
                }
                v
            }
        }"
    ));
}

/// A share that no site has is zero.
#[test]
fn bonds_may_lead_to_the_second_next_site_alone() {
    let text = stepper(
        "",
        "impl Second {
            fn kinetic(&self, p: &[f64]) -> f64 { p.iter().map(|p| 0.5 * p * p).sum() }
            fn potential(&self, q: &[f64]) -> f64 { (0..q.len() - 2).map(|i| (q[i + 2] - q[i]).powi(4)).sum() }
        }",
    );
    assert!(text.contains("[share_0, Wide::of(0.0), share_2]"), "{text}");
}

#[test]
fn composition_in_place() {
    insta::assert_snapshot!(stepper(
        "compose = V(1/2) T(1) V(1/2)",
        "impl Oscillator {
            fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] / 2.0 }
            fn potential(&self, q: [f64; 1]) -> f64 { self.stiffness * q[0] * q[0] / 2.0 }
        }"
    ));
}

/// Loops stay loops: the text for a long chain is that for a short one, but for the numbers and their fingerprint, and
/// that small systems keep their buffers on the stack.
#[test]
fn text_does_not_grow_with_the_system() {
    let text = |length: u32| {
        let tokens = hamiltonian(proc_macro2::TokenStream::new(), chain(length).parse().expect("tokens"));
        let text = tokens.to_string();
        let (before, rest) = text.split_once("FINGERPRINT : u64 = ").expect("a fingerprint");
        let (_, after) = rest.split_once(' ').expect("a number");
        format!("{before}{after}").replace(&length.to_string(), "LENGTH").replace(&(length - 1).to_string(), "LAST")
    };
    assert_eq!(text(100_000), text(1_000_000));
    assert!(text(10).len().abs_diff(text(1_000_000).len()) < 100);
}

/// What is prepared for a loop that a potential consists of, with a coordinate for each iteration: the text that
/// evaluates an element of the table, or the number, behind the condition that the function has around it.
const PREPARED: &[(&str, &str)] = &[
    ("if i > 0 { v += self.long[i - 1] * q[i]; }", "if (0) < (i) { self.long[(i - 1)] } else { 0.0 }"),
    ("if i == 0 { continue; } v += self.long[i - 1] * q[i];", "if !((i) == (0)) { self.long[(i - 1)] } else { 0.0 }"),
    (
        "if i < self.short.len() { v += self.short[i] * q[i]; }",
        "if (i < self.short.len()) { self.short[i] } else { 0.0 }",
    ),
    (
        "for j in 0..q.len() { if j > i { v += self.long[j - i] * q[j]; } }",
        "if (i) < (j) { self.long[(j - i)] } else { 0.0 }",
    ),
    (
        "if self.list.is_empty() { v += q[i]; } else { v += self.list[0] * q[i]; }",
        "if !((self.list.is_empty())) { self.list[0] } else { 0.0 }",
    ),
    ("if self.k.is_some() { v += self.k.unwrap() * q[i]; }", "if (self.k.is_some()) { self.k.unwrap() } else { 0.0 }"),
    (
        "if self.k.is_some() && self.k.unwrap() > q[i] { v += q[i]; }",
        "if (self.k.is_some()) { self.k.unwrap() } else { 0.0 }",
    ),
    (
        "v += if self.list.is_empty() { 0.0 } else { self.list[0] } * q[i];",
        "if !((self.list.is_empty())) { (self.list[0]) } else { 0.0 }",
    ),
    // Names of the user's are not those of the generated code.
    (
        "let (m, length) = (q.len(), self.n); v += self.list.iter().map(|x| x + (length - m) as f64).sum::<f64>() * q[i];",
        "let (length, m) = (self.n, length);",
    ),
    // A list that is read by the index as it is has an element for every iteration, whichever iterations add.
    (
        "for j in 0..q.len() { if i != j { v += self.mass[i] * q[j]; } }",
        "mass: runtime::table(length, &|i: usize| self.mass[i])",
    ),
    ("if self.on { v += self.k * q[i]; }", "k: self.k"),
];

#[test]
fn what_is_prepared_is_evaluated_where_the_function_does() {
    let plain = |text: &str| text.split_whitespace().collect::<String>().replace(",)", ")");
    for (body, expected) in PREPARED {
        let item = format!(
            "impl System {{
                fn kinetic(&self, p: &[f64]) -> f64 {{ let mut t = 0.0; for i in 0..p.len() {{ t += p[i] * p[i] / 2.0; }} t }}
                fn potential(&self, q: &[f64]) -> f64 {{ let mut v = 0.0; for i in 0..q.len() {{ {body} }} v }}
            }}"
        );
        let text = plain(&stepper("", &item));
        assert!(text.contains(&plain(expected)), "{body}: {expected}\n{}", stepper("", &item));
    }
}
