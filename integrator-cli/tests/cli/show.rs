//! `show` and `expand`: what is derived and what is written.

use super::{answer, file, json, keys};

#[test]
fn a_pendulum_is_two_equations() {
    let found = answer(&["show", "examples/pendulum.rs"]);
    let expected = "Pendulum, examples/pendulum.rs:15
    dq[0]/dt = p[0] / (mass length^2)
    dp[0]/dt = -mass gravity length sin(q[0])
    H: separable; T: quadratic in p, constant masses; time: not read
    drift: plain code
      once: 1 multiplication, 1 coordinate moved
    kick: plain code
      once: 1 multiplication, 1 sin, 1 coordinate moved
    operations of a drift and a kick: 3, or 3 after common subexpression elimination
    operations of the energies: 4, of energies and derivatives together: 7
    composition: Yoshida4, order 4, symmetric, 3 forces per step, stable for h ω < 1.573
    admissible: all of the catalogue, 82 compositions

The catalogue, with forces per step; * for quadratic T alone
    order  1: Euler 1, EulerAdjoint 1
";
    assert!(found.starts_with(expected), "{found}");
    assert!(found.contains(" BlanesMoanSrkn11* 11,") && found.ends_with("SofroniouSpaletta10 35\n"), "{found}");
}

#[test]
fn h_in_one_piece_has_explicit_parts_and_implicit_methods() {
    let path = file(
        "one_piece.rs",
        "#[hamiltonian(split = none)]
impl Products {
    fn hamiltonian(&self, q: [f64; 2], p: [f64; 2]) -> f64 { q[0].sin() * p[1] + q[1].cos() * p[0].powi(2) }
}",
    );
    let found = answer(&["show", &path]);
    let expected = "    explicit instead: `split = a + b`, one function for each part:
      a = p[1] sin(q[0]): a shear, since it depends on no coordinate together with its conjugate
      b = p[0]^2 cos(q[1]): a shear, since it depends on no coordinate together with its conjugate
    operations of the energies: 6
    method: ImplicitMidpoint
    admissible: implicit methods, `GaussLegendre<1>` to `GaussLegendre<8>`
";
    assert!(found.contains(expected), "{found}");
    assert_eq!(json(&["show", &path])["systems"][0]["admissible"], serde_json::json!([]));
}

const SYSTEMS: &str = "
#[hamiltonian]
impl Chain {
    fn kinetic(&self, p: &[f64]) -> f64 { p.iter().map(|p| 0.5 * p * p).sum() }
    fn potential(&self, q: &[f64]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() - 1 {
            energy += (q[i + 1] - q[i]).powi(4);
        }
        energy
    }
}

mod inside {
    #[integrator_core::hamiltonian(compose = V(1/2) T(1) V(1/2), functions = fast)]
    impl Bodies {
        fn kinetic(&self, p: &[[f64; 2]]) -> f64 {
            let mut energy = 0.0;
            for i in 0..p.len() {
                energy += (p[i][0] * p[i][0] + p[i][1] * p[i][1]) / (2.0 * self.masses[i]);
            }
            energy
        }
        fn potential(&self, q: &[[f64; 2]]) -> f64 {
            let mut energy = 0.0;
            for i in 0..q.len() {
                for j in 0..i {
                    let (dx, dy) = (q[i][0] - q[j][0], q[i][1] - q[j][1]);
                    energy -= self.masses[i] * self.masses[j] / (dx * dx + dy * dy).sqrt();
                }
            }
            energy
        }
    }
}

composition! { pub struct Mine: order 2 = V(1/2) T(1) V(1/2); }

#[hamiltonian(compose = Mine)]
impl Driven {
    fn kinetic(&self, p: [f64; 1]) -> f64 { (1.0 + p[0] * p[0]).sqrt() }
    fn potential(&self, q: [f64; 1], t: f64) -> f64 { -q[0].cos() * (1.0 + 0.1 * t.sin()) }
}

#[hamiltonian(compose = elsewhere::Theirs)]
impl Free {
    fn hamiltonian(&self, q: [f64; 1], p: [f64; 1]) -> f64 { 1.0 + p[0] * p[0] }
}
";

#[test]
fn forms_loops_and_compositions() {
    let path = file("systems.rs", SYSTEMS);
    let found = answer(&["show", &path]);
    let sections: Vec<&str> = found.split("\n\n").collect();
    let [chain, bodies, driven, free, catalogue] = sections[..] else { panic!("{found}") };
    let rows = [
        (chain, "Chain, "),
        (
            chain,
            "kick: neighbour sums along a line of sites, in SIMD lanes\n      per site: 1 addition, 3 multiplications,",
        ),
        (chain, "composition: Verlet, order 2, symmetric, 1 force per step"),
        (
            bodies,
            "drift: pair sums in tiles of eight bodies by eight\n      per body: 2 multiplications, 2 coordinates moved",
        ),
        (
            bodies,
            "kick: pair sums in tiles of eight bodies by eight\n      per pair: 3 additions, 6 multiplications, 1 division,",
        ),
        (bodies, "      layout = pairs; cost: proportional to all pairs\n"),
        (chain, "      layout = line; cost: proportional to the sites\n"),
        (bodies, "composition: V(1/2) T(1) V(1/2), order 2, symmetric, 1 force per step"),
        (driven, "T: general; time: read"),
        (driven, "once: 1 addition, 2 multiplications, 2 sin, 1 coordinate moved"),
        (driven, "composition: Mine, order 2,"),
        (driven, "admissible: those for every T of the catalogue, 57 compositions"),
        (free, "T = p[0]^2\n    V = 1\n    dq[0]/dt = 2 p[0]"),
        (free, "kick: nothing moves"),
        (free, "composition: elsewhere::Theirs, which is declared elsewhere"),
        (catalogue, "order 10: KahanLi10 33, SofroniouSpaletta10 35"),
    ];
    for (section, line) in rows {
        assert!(section.contains(line), "lacks `{line}`:\n{section}");
    }
}

#[test]
fn json_says_the_same() {
    let path = file("systems_as_json.rs", SYSTEMS);
    let found = json(&["show", &path]);
    assert_eq!(keys(&found), ["file", "systems"]);
    let systems = found["systems"].as_array().expect("a list");
    let names: Vec<_> = systems.iter().map(|system| system["system"].as_str().expect("a name")).collect();
    assert_eq!(names, ["Chain", "Bodies", "Driven", "Free"]);
    let expected = [
        "admissible",
        "autonomous",
        "compose",
        "composition",
        "drift",
        "equations",
        "explicit",
        "flows_of_parts",
        "kick",
        "line",
        "operations",
        "parts",
        "quadratic_kinetic",
        "separable",
        "system",
    ];
    for system in systems {
        assert_eq!(keys(system), expected);
    }
    let pair = &systems[1]["kick"]["places"][0];
    assert_eq!((&pair["each"], &pair["loops"]), (&"pair".into(), &serde_json::json!([])));
    assert_eq!((&pair["additions"], &pair["roots"]), (&3.into(), &1.into()));
    assert_eq!(systems[2]["kick"]["places"][0]["functions"], serde_json::json!({ "sin": 2 }));
    assert_eq!(systems[3]["composition"], serde_json::Value::Null);
    assert_eq!(systems[0]["drift"]["form"], "line");
}

/// Loops in plain code, in a kick and in a part with a name.
const SLOW: &str = "
#[hamiltonian]
impl Alternating {
    fn kinetic(&self, p: &[f64]) -> f64 { p.iter().map(|p| 0.5 * p * p).sum() }
    fn potential(&self, q: &[f64]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() - 1 {
            if i % 2 == 0 { energy += self.stiffness_of_the_left_bond[i] * (q[i + 1] - q[i] - self.length_of_the_bond[i]).powi(4); }
        }
        energy
    }
}

#[hamiltonian(split = oscillator + pairs)]
impl Coupled {
    fn oscillator(&self, q: [f64; 12], p: [f64; 12]) -> f64 {
        p.iter().map(|p| p * p).sum::<f64>() + q.iter().map(|q| q * q).sum::<f64>()
    }
    fn pairs(&self, q: [f64; 12]) -> f64 {
        let mut energy = 0.0;
        for i in 0..12 { for j in 0..i { energy += (q[i] - q[j]).cos(); } }
        energy
    }
}

#[hamiltonian(split = pairs + 8 * (bonds + kinetic))]
impl Nested {
    fn pairs(&self, q: &[f64]) -> f64 {
        let mut energy = 0.0;
        for i in 0..q.len() { for j in 0..i { energy += (q[i] - q[j]).cos(); } }
        energy
    }
    fn bonds(&self, q: &[f64]) -> f64 { (1..q.len()).map(|i| (q[i] - q[i - 1]).powi(2)).sum() }
    fn kinetic(&self, p: &[f64]) -> f64 { p.iter().map(|p| 0.5 * p * p).sum() }
}
";

#[test]
fn slow_loops_have_a_reason() {
    let path = file("slow.rs", SLOW);
    let found = answer(&["show", &path]);
    let lines = [
        "    kick: plain code\n",
        "\n      not `line`: a condition on the index of a site does not select a range of sites; write a condition such as",
        "\n    flow of oscillator: a matrix exponential, since it is a quadratic form in q and p\n    flow of pairs: plain code\n",
        "\n      not `pairs`: a part that `split` names is summed as written if there are fewer than 33 numbers in `q`; write",
        "\n    H = pairs + 8 * Verlet(bonds + kinetic)\n",
        "\n    flow of pairs: pair sums in tiles of eight bodies by eight\n",
    ];
    for line in lines {
        assert!(found.contains(line), "lacks `{line}`:\n{found}");
    }
    let found = json(&["show", &path]);
    let slower = &found["systems"][0]["kick"]["slower"][0];
    assert_eq!((&slower["than"], &slower["range"]), (&"line".into(), &serde_json::Value::Null));
    assert_eq!(found["systems"][1]["flows_of_parts"][0]["form"], serde_json::Value::Null);
    assert_eq!(found["systems"][1]["flows_of_parts"][1]["slower"][0]["than"], "pairs");
}

/// No line has more than 120 columns, and lines that are joined again have the words of the formula.
#[test]
fn long_formulas_are_wrapped() {
    let found = answer(&["show", &file("wrapped.rs", SLOW)]);
    assert!(found.lines().all(|line| line.chars().count() <= 120), "{found}");
    let equation = "    dp[i]/dt += {4 stiffness_of_the_left_bond[i] (q[i + 1] - q[i] - length_of_the_bond[i])^3 if i % 2 == 0, else 0}";
    let joined = found.replace("\n            ", " ");
    assert!(found.contains("\n            ") && joined.contains(equation), "{found}");
}

#[test]
fn an_expansion_is_rust() {
    let path = file("systems_to_expand.rs", SYSTEMS);
    let found = answer(&["expand", &path]);
    assert_eq!(found.matches("impl runtime::Hamiltonian for ").count(), 4, "{found}");
    let parsed = syn::parse_file(&found).expect("Rust");
    assert_eq!(prettyplease::unparse(&parsed), found.replace("\n\n", "\n"), "formatted");
    let values = json(&["expand", &path]);
    assert_eq!(keys(&values), ["file", "systems"]);
    let joined: Vec<&str> = values["systems"]
        .as_array()
        .expect("a list")
        .iter()
        .map(|system| system["expansion"].as_str().expect("text"))
        .collect();
    assert_eq!(joined.join("\n"), found);
}
