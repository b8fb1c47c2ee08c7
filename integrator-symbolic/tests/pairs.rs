//! Which potentials are sums over pairs of bodies, and how their motions are laid out.

use integrator_symbolic::hamiltonian;

/// The loops over pairs of six bodies, or of a slice: a name, what is around the energy of a pair, and what is behind.
const LOOPS: [(&str, &str, &str); 5] = [
    ("before", "for i in 0..N { for j in 0..i {", "} }"),
    ("before, from the second", "for i in 1..N { for j in 0..i {", "} }"),
    ("behind", "for i in 0..N { for j in i + 1..N {", "} }"),
    ("all others", "for i in 0..N { for j in 0..N { if i != j {", "} } }"),
    ("with a field", "for i in 0..N { v += self.field[i] * q[i][0]; for j in 0..i {", "} }"),
];

/// Energies of a pair: a name, the text, and for few and for many bodies whether the motion is one of bodies, and whether
/// action is reaction.
const ENERGIES: [(&str, &str, [Option<bool>; 2]); 27] = [
    ("attraction", "v -= self.g * self.m[i] * self.m[j] / r2.sqrt();", [Some(true); 2]),
    ("a factor on either side", "v -= self.m[i] * self.g / r2.sqrt() * self.m[j];", [Some(true); 2]),
    ("a quotient of parameters", "v -= self.m[i] / self.m[0] * self.m[j] / r2.sqrt();", [Some(true); 2]),
    ("a mean of radii", "v += (r2 - 0.5 * (self.m[i] + self.m[j])).powi(2);", [Some(true); 2]),
    ("a cut-off", "if r2 < self.reach { v += (1.0 / r2).powi(3); }", [Some(true); 2]),
    ("even in the distance", "v += (q[i][0] - q[j][0]).cos() + (q[j][1] - q[i][1]).abs();", [Some(true); 2]),
    ("products of coordinates", "v += q[i][0] * q[j][0] * q[i][1] * q[j][1];", [Some(false); 2]),
    ("odd in the distance", "v += (q[i][0] - q[j][0]).powi(3);", ORDERED),
    ("another parameter of either", "v += self.m[i] * self.k[j] * r2;", ORDERED),
    ("an index as a number", "v += i as f64 * r2;", ORDERED),
    ("neighbours in a chain", "if i - j > 1 { v += r2; }", ORDERED),
    ("an integer of either", "if self.molecule[i] != self.molecule[j] { v += r2; }", ORDERED),
    ("a list of partners", "if self.next[j] == i { v += r2; }", ORDERED),
    ("a condition of one", "if self.kind[i] == 3 { v += r2; }", ORDERED),
    ("a quotient of a difference", "if j == (i - 1) / 2 { v += r2; }", [None; 2]),
    ("a remainder of both", "if (i + j) % 3 == 1 { v += r2; }", [None; 2]),
    ("a parameter of both", "v += self.table[i][j] * r2;", [None; 2]),
    ("a table by type", "v += self.table[self.kind[i]][self.kind[j] as usize] * r2;", ORDERED),
    ("a flat table by type", "v += self.table[self.kind[i] * self.kinds + self.kind[j]] * r2;", ORDERED),
    ("fields of a table", "v += self.kinds[self.atoms[i].kind][self.atoms[j].kind].depth * r2;", ORDERED),
    ("types of both", "if self.kind[i] == 1 && self.kind[j] == 2 { v += r2; }", ORDERED),
    ("a method of a value", "v += self.table[self.kind[i].index()][self.kind[j].index()] * r2;", [None; 2]),
    ("a table by type and index", "v += self.table[self.kind[i]][j] * r2;", [None; 2]),
    ("a table by two types", "v += self.table[self.kind[i]][self.kind[j] + self.charge[j]] * r2;", [None; 2]),
    ("one body twice", "v += q[i][0].powi(2) * q[j][1];", [None; 2]),
    ("a third body", "v += r2 * q[0][0];", [None; 2]),
    ("neighbours in the list", "v += r2 * q[i - j][0];", [None; 2]),
];

/// Bodies that may not be exchanged: pairs of many are put in order, and those that come twice are added up.
const ORDERED: [Option<bool>; 2] = [None, Some(true)];

fn stepper(length: &str, kind: &str, [open, energy, close]: [&str; 3]) -> String {
    let text = format!(
        "impl Bodies {{
            fn kinetic(&self, p: &{kind}) -> f64 {{
                let mut t = 0.0;
                for i in 0..N {{ for d in 0..3 {{ t += p[i][d] * p[i][d] / (2.0 * self.m[i]); }} }}
                t
            }}
            fn potential(&self, q: &{kind}) -> f64 {{
                let mut v = 0.0;
                {open}
                    let mut r2 = 0.0;
                    for d in 0..3 {{ r2 += (q[i][d] - q[j][d]).powi(2); }}
                    {energy}
                {close}
                v
            }}
        }}"
    );
    // Both names of the length are the argument's own.
    let (kinetic, potential) = text.split_once("fn potential").expect("two functions");
    let (of_p, of_q) = if length == "len" { ("p.len()", "q.len()") } else { (length, length) };
    let text = format!(
        "{}fn potential{}",
        kinetic.replace("..N", &format!("..{of_p}")),
        potential.replace("..N", &format!("..{of_q}"))
    );
    hamiltonian(proc_macro2::TokenStream::new(), text.parse().expect("tokens")).to_string()
}

#[test]
fn pairs_are_found_whatever_their_order() {
    for (order, open, close) in LOOPS {
        for (name, energy, expected) in ENERGIES {
            for (length, kind, layout) in [
                ("6", "[[f64; 3]; 6]", "OneRow"),
                ("9", "[[f64; 3]; 9]", "ManyRows"),
                ("len", "[[f64; 3]]", "ManyRows"),
            ] {
                let text = stepper(length, kind, [open, energy, close]);
                assert!(!text.contains("compile_error"), "{name}, {order}: {text}");
                let found = ["OneRow", "ManyRows", "Plain"]
                    .into_iter()
                    .find(|name| text.contains(&format!("runtime :: {name}")));
                // A difference of indices would be negative for half of the pairs that come twice.
                let is_negative = order == "all others" && energy.contains("i - j");
                let expected = match name {
                    "one body twice" if order == "all others" && length == "len" => Some(false),
                    _ => expected[usize::from(length == "len" && !is_negative)],
                };
                let expected_layout = if expected.is_some() { layout } else { "Plain" };
                assert_eq!(found, Some(expected_layout), "{name}, {order}, {length}");
                // The two energies of an odd one cancel each other.
                let cancels = order == "all others" && name == "odd in the distance";
                let reciprocal = expected.filter(|_| !cancels).map(|is| format!("const RECIPROCAL : bool = {is}"));
                assert!(reciprocal.is_none_or(|reciprocal| text.contains(&reciprocal)), "{name}, {order}, {length}");
            }
        }
    }
}

/// The loops never read the list at the last body, so that it may be too short for it.
#[test]
fn a_list_of_the_lesser_body_alone_is_not_read_for_the_last_one() {
    for (number, of_lesser, of_greater) in [
        ("self . k [", "v += self.k[LESSER] * r2;", "v += self.k[GREATER] * r2;"),
        (
            "self . next [",
            "if self.next[LESSER] == GREATER { v += r2; }",
            "if self.next[GREATER] == LESSER { v += r2; }",
        ),
        ("self . kind [", "if self.kind[LESSER] == 3 { v += r2; }", "if self.kind[GREATER] == 3 { v += r2; }"),
    ] {
        for ((_, open, close), lesser, greater) in [(LOOPS[0], "j", "i"), (LOOPS[2], "i", "j")] {
            for (energy, is_guarded) in [(of_lesser, true), (of_greater, false)] {
                let energy = energy.replace("LESSER", lesser).replace("GREATER", greater);
                let text = stepper("len", "[[f64; 3]]", [open, &energy, close]);
                assert!(text.contains("runtime :: ManyRows") && text.contains(number), "{energy}: {text}");
                assert_eq!(text.contains("+ 1 < length"), is_guarded, "{energy}, {open}: {text}");
            }
        }
    }
}

/// In loops in which each pair comes twice, a body may be its own partner in another sum, of which a table of pairs knows nothing.
#[test]
fn sums_with_bodies_themselves_are_evaluated_as_written() {
    let open = "for i in 0..N { for j in 0..N { if i != j {";
    let close =
        "} } } for i in 0..N { for j in 0..N { v += self.table[self.kind[i]][self.kind[j]] * q[i][0] * q[j][0]; } }";
    let text = stepper("len", "[[f64; 3]]", [open, "v += r2;", close]);
    assert!(!text.contains("compile_error") && !text.contains("ByClass"), "{text}");
}

/// A constant numerator or a product of masses: the components of the force share one reciprocal.
#[test]
fn a_pair_divides_once_for_all_coordinates() {
    for numerator in ["-1.0", "self.m[i] * self.m[j]", "-self.g"] {
        let energy = format!("v += {numerator} / r2.sqrt();");
        let text = stepper("len", "[[f64; 3]]", ["for i in 0..N { for j in 0..i {", &energy, "} }"]);
        let pair = text.split("fn pair <").nth(1).and_then(|text| text.split("fn ").next()).expect("a pair");
        assert_eq!(pair.matches("div_pow_3_2").count() + pair.matches(" / ").count(), 1, "{numerator}: {pair}");
    }
}

/// What moves one body by another one's momentum, or all by their mean, needs the plain loops.
#[test]
fn a_kinetic_energy_that_couples_bodies_keeps_the_plain_loops() {
    let coupled = |kinetic: &str| {
        let text = format!(
            "impl Bodies {{
                fn kinetic(&self, p: &[f64; 6]) -> f64 {{ let mut t = 0.0; {kinetic} t }}
                fn potential(&self, q: &[f64; 6]) -> f64 {{
                    let mut v = 0.0;
                    for i in 0..6 {{ for j in 0..i {{ v += (q[i] - q[j]).powi(4); }} }}
                    v
                }}
            }}"
        );
        hamiltonian(proc_macro2::TokenStream::new(), text.parse().expect("tokens")).to_string()
    };
    assert!(coupled("for i in 0..6 { t += p[i].powi(2); }").contains("runtime :: OneRow"));
    assert!(coupled("for i in 1..6 { t += p[i] * p[i - 1]; }").contains("runtime :: Plain"));
    assert!(coupled("for i in 0..5 { t += p[i].powi(2); }").contains("runtime :: Plain"));
    assert!(coupled("for i in 0..6 { for j in 0..i { t += (p[i] - p[j]).powi(2); } }").contains("runtime :: Plain"));
}

/// The square of a distance whose components are an expression of the displacement `x`.
macro_rules! image {
    ($of_x:literal) => {
        concat!("let mut r2 = 0.0; for d in 0..3 { let x = q[i][d] - q[j][d]; let x = ", $of_x, "; r2 += x * x; }")
    };
}

/// Energies of a pair with a distance: a name, what finds the square of the distance, the branch, and what is found of a
/// cutoff: whether there is one, and whether distances are those in a box.
const CUTOFFS: [(&str, &str, &str, Option<bool>); 43] = [
    ("a number", OPEN, "if r2 < 6.25 { v += 1.0 / r2; }", Some(false)),
    ("a parameter", OPEN, "if r2 < self.cutoff * self.cutoff { v += 1.0 / r2; }", Some(false)),
    ("a distance", OPEN, "let r = r2.sqrt(); if r <= self.cutoff { v += (r - self.cutoff).powi(2); }", Some(false)),
    ("the other side", OPEN, "if r2 >= self.cutoff { continue; } v += 1.0 / r2;", Some(false)),
    (
        "the bound first",
        OPEN,
        "if self.cutoff > r2 { v -= self.m[i] * self.m[j] / r2; } else { v += 0.0; }",
        Some(false),
    ),
    ("two conditions", OPEN, "if r2 < self.cutoff && self.k > 0.0 { v += 1.0 / r2; }", Some(false)),
    ("two terms", OPEN, "if r2 < self.cutoff { v += 1.0 / r2; } if r2 < self.cutoff { v += r2.exp(); }", Some(false)),
    ("softened", "let mut r2 = 0.01; for d in 0..3 { r2 += (q[i][d] - q[j][d]).powi(2); }", IF, Some(false)),
    ("the nearest image", BOX, IF, Some(true)),
    (
        "a side along each axis",
        "let mut r2 = 0.0; for d in 0..3 { let mut x = q[i][d] - q[j][d]; x -= self.sides[d] * (x / self.sides[d]).round(); r2 += x * x; }",
        IF,
        Some(true),
    ),
    (
        "one axis without an end",
        "let x = q[i][0] - q[j][0]; let x = x - 9.0 * (x / 9.0).round_ties_even(); let (y, z) = (q[i][1] - q[j][1], q[i][2] - q[j][2]); let r2 = x * x + y * y + z * z;",
        IF,
        Some(true),
    ),
    ("no branch", OPEN, "v += 1.0 / r2;", None),
    ("something beyond it", OPEN, "if r2 < self.cutoff { v += 1.0 / r2; } else { v += 0.1; }", None),
    ("two cutoffs", OPEN, "if r2 < self.cutoff { v += 1.0 / r2; } if r2 < self.k { v += r2.exp(); }", Some(false)),
    (
        "a piece for each range",
        OPEN,
        "if r2 < self.k { v += r2; } else if r2 < self.cutoff { v += r2.exp(); }",
        Some(false),
    ),
    ("a power that is cut", OPEN, "v += (1.0 - r2 / self.cutoff).max(0.0).powi(2);", Some(false)),
    ("a distance that is cut", OPEN, "v += self.k * 0f64.max(self.cutoff - 2.0 * r2.sqrt()).powi(3);", Some(false)),
    ("a cut of what grows", OPEN, "v += (r2 * self.cutoff).max(0.0).powi(2);", None),
    ("a type beside it", OPEN, "if self.kind[i] != self.kind[j] && r2 < self.cutoff { v += 1.0 / r2; }", Some(false)),
    (
        "pieces in different boxes",
        BOX,
        "let x = q[i][0] - q[j][0]; let r = q[i][1] - q[j][1]; let s = x * x + r * r + (q[i][2] - q[j][2]).powi(2); if r2 < self.k { v += r2; } if s < self.k { v += s; }",
        None,
    ),
    ("far away alone", OPEN, "if r2 > self.cutoff { v += 1.0 / r2; }", None),
    ("a cutoff of each pair", OPEN, "if r2 < self.m[i] * self.m[j] { v += 1.0 / r2; }", Some(false)),
    ("two radii", OPEN, "let s = 0.5 * (self.m[i] + self.m[j]); if r2.sqrt() < s { v += s - r2.sqrt(); }", Some(false)),
    (
        "a table of cutoffs",
        BOX,
        "let c = self.table[self.kind[i]][self.kind[j]]; if r2 < c * c { v += 1.0 / r2; }",
        Some(true),
    ),
    ("a cut by radii", OPEN, "v += (1.0 - r2.sqrt() / (self.m[i] + self.m[j])).max(0.0);", Some(false)),
    (
        "a root and a quotient",
        OPEN,
        "if r2 < self.m[i].sqrt() + 1.0 / self.m[j].powi(2) { v += 1.0 / r2; }",
        Some(false),
    ),
    ("an exclusion", OPEN, "if r2 < self.cutoff && !self.excluded[i].contains(&j) { v += 1.0 / r2; }", Some(false)),
    (
        "a list of the other body",
        OPEN,
        "if r2 < self.cutoff && self.bonded[j].contains(&(i as u32)) { v += 1.0 / r2; }",
        Some(false),
    ),
    (
        "a set of pairs",
        BOX,
        "if self.excluded.contains(&(i, j)) { continue; } if r2 < self.cutoff { v += 1.0 / r2; }",
        Some(true),
    ),
    (
        "an exclusion of molecules and of lists",
        OPEN,
        "if self.kind[i] == self.kind[j] || self.excluded[i].contains(&j) { continue; } if r2 < self.cutoff { v += 1.0 / r2; }",
        Some(false),
    ),
    ("a cutoff without bounds", OPEN, "if r2 < 2.0 + (self.m[i] - self.m[j]).sin() { v += 1.0 / r2; }", None),
    ("no distance", "let r2 = (q[i][0] - q[j][0]).powi(2) + (q[i][1] - q[j][1]).powi(2);", IF, None),
    ("any image", image!("x - self.side * (x * self.k).round()"), IF, Some(true)),
    ("the integer part", image!("x - self.side * (x / self.side + 0.5).floor()"), IF, Some(true)),
    ("a remainder", image!("(x + 0.5 * self.side).rem_euclid(self.side) - 0.5 * self.side"), IF, Some(true)),
    ("the shorter way", image!("x.abs().min(self.side - x.abs())"), IF, Some(true)),
    (
        "a branch for each side",
        image!("if x > self.half { x - self.side } else if x < -self.half { x + self.side } else { x }"),
        IF,
        Some(true),
    ),
    ("half a side", image!("x - self.side * (x / self.side).round() * 0.5"), IF, Some(true)),
    ("a side of each pair", image!("x - (self.m[i] - self.m[j]) * (x / (self.m[i] - self.m[j])).round()"), IF, None),
    ("a side by numbers", image!("x - self.k * (i - j) as f64 * (x / (self.k * (i - j) as f64)).round()"), IF, None),
    ("a side of each body", image!("x - self.m[i] * (x / self.m[i]).round()"), IF, None),
    ("an offset", image!("x - self.side"), IF, None),
    ("no multiple of a side", image!("x - self.side * (x / self.side).sin()"), IF, None),
];

const OPEN: &str = "let mut r2: f64 = 0.0; for d in 0..3 { r2 += (q[i][d] - q[j][d]).powi(2); }";
const BOX: &str = "let mut r2 = 0.0; for d in 0..3 { let x = q[i][d] - q[j][d]; r2 += (x - self.side * (x / self.side).round()).powi(2); }";
const IF: &str = "if r2 < self.cutoff.powi(2) { v += 1.0 / r2; }";

#[test]
fn a_cutoff_is_proved_or_all_pairs_are_summed() {
    for (name, distance, branch, found) in CUTOFFS {
        // The distance that is written around every energy is hidden by this one.
        let text = of_pairs("len", "[[f64; 3]]", distance, branch);
        assert!(!text.contains("compile_error"), "{name}: {text}");
        assert!(text.contains("runtime :: ManyRows"), "{name}: {text}");
        for asked in ["const LISTED_FROM", "fn cutoff <"] {
            assert_eq!(text.contains(asked), found.is_some(), "{name}, {asked}: {text}");
        }
        assert_eq!(text.contains("fn sides <"), found == Some(true), "{name}: {text}");
        assert!(text.contains("fn energy <") && text.contains("motion . potential"), "{name}: {text}");
    }
    // Images that are chosen by conditions are selections: the cutoff alone is a branch of a force.
    let by_branches = image!("if x > self.half { x - self.side } else if x < -self.half { x + self.side } else { x }");
    let by_remainder = image!("(x + 0.5 * self.side).rem_euclid(self.side) - 0.5 * self.side");
    for distance in [by_branches, by_remainder] {
        let text = of_pairs("len", "[[f64; 3]]", distance, IF);
        let pair = text.split("fn pair <").nth(1).and_then(|text| text.split("fn ").next()).expect("a force");
        assert_eq!(pair.matches(". any ()").count(), 1, "{distance}: {pair}");
    }
    // The side is what the displacement is shifted by, not a factor of it.
    let distance = image!("{ let side = 2.0 * self.half; x - side * (x / side).round() }");
    let text = of_pairs("len", "[[f64; 3]]", distance, IF);
    let sides = text.split("fn sides <").nth(1).and_then(|text| text.split('}').next()).expect("sides");
    assert!(text.contains("prepared_") && !sides.contains("half"), "{sides}");
    // A condition that another one guards is not evaluated without it.
    let guarded = "if self.next[i] != j && self.m[self.next[i]] == self.m[j] { continue; }";
    assert!(!of_pairs("len", "[[f64; 3]]", &format!("{guarded} {OPEN}"), IF).contains("LISTED_FROM"));
    let [few, many] = [9, 1500].map(|bodies| of_pairs(&bodies.to_string(), &format!("[[f64; 3]; {bodies}]"), BOX, IF));
    assert!(!few.contains("LISTED_FROM") && many.contains("LISTED_FROM"));
}

fn of_pairs(length: &str, kind: &str, distance: &str, branch: &str) -> String {
    stepper(length, kind, ["for i in 0..N { for j in 0..i {", &format!("{distance} {branch}"), "} }"])
}

/// Energies within a cutoff: a name, the text, and whether the order of the bodies is all that is read of their numbers, which
/// lists know.
const NUMBERS: [(&str, &str, bool); 7] = [
    ("bodies alike", "v += 1.0 / r2;", false),
    ("a table by type", "v += self.table[self.kind[i]][self.kind[j]] / r2;", true),
    ("types of both", "if self.kind[i] == 1 && self.kind[j] == 2 { v += 1.0 / r2; } else { v += r2; }", true),
    ("an odd power", "v += (q[i][0] - q[j][0]).powi(3);", true),
    ("neighbours in a chain", "if i - j > 1 { v += 1.0 / r2; }", false),
    ("a set of pairs", "if !self.bonded.contains(&(i, j)) { v += 1.0 / r2; }", false),
    (
        "joined conditions",
        "if self.kind[i] != self.kind[j] && !self.excluded[i].contains(&j) { v += 1.0 / r2; }",
        false,
    ),
];

#[test]
fn lists_keep_no_numbers_that_pairs_only_compare() {
    for (name, energy, is_order) in NUMBERS {
        let text = of_pairs("len", "[[f64; 3]]", OPEN, &format!("if r2 < self.cutoff {{ {energy} }}"));
        assert!(text.contains("const LISTED_FROM"), "{name}: {text}");
        assert_eq!(text.contains("const NUMBER"), is_order, "{name}: {text}");
    }
}

/// Energies within a cutoff that pairs have under a condition: a name, the text, and how many constants of a body lists read to leave
/// out the other pairs.
const LEFT_OUT: [(&str, &str, u32); 4] = [
    ("molecules", "if self.kind[i] != self.kind[j] { v += 1.0 / r2; }", 1),
    ("a chain", "if i - j > 1 { v += 1.0 / r2; }", 1),
    ("a set of pairs", "if !self.bonded.contains(&(i, j)) { v += 1.0 / r2; }", 1),
    (
        "types and a set",
        "if self.kind[i] == 1 && self.kind[j] == 2 { if self.bonded.contains(&(i, j)) { v += 1.0 / r2; } }",
        2,
    ),
];

#[test]
fn lists_leave_out_pairs_that_never_act() {
    for (name, energy, own) in LEFT_OUT {
        let text = of_pairs("len", "[[f64; 3]]", OPEN, &format!("if r2 < self.cutoff {{ {energy} }}"));
        let left_out = format!(
            "const LEAVES_OUT : :: core :: option :: Option < usize > = :: core :: option :: Option :: Some ({own})"
        );
        assert!(text.contains(&left_out), "{name}: {text}");
        let of =
            |function: &str| text.split(function).nth(1).and_then(|text| text.split("fn ").next()).expect("a function");
        let conditions = [of("fn pair <"), of("fn energy <")].map(|code| code.matches(". any ()").count());
        assert_eq!(conditions, [1, 1], "only the cutoff, {name}: {text}");
    }
    // Another energy elsewhere, other coordinates, and no cutoff.
    for energy in
        ["if self.kind[i] != self.kind[j] { v += 1.0 / r2; } else { v += r2; }", "if q[i][0] < q[j][0] { v += r2; }"]
    {
        let text = of_pairs("len", "[[f64; 3]]", OPEN, &format!("if r2 < self.cutoff {{ {energy} }}"));
        assert!(!text.contains("LEAVES_OUT"), "{energy}: {text}");
    }
    let everywhere = of_pairs("len", "[[f64; 3]]", OPEN, "if self.kind[i] != self.kind[j] { v += 1.0 / r2; }");
    assert!(!everywhere.contains("LEAVES_OUT"), "{everywhere}");
}

/// Loops over bodies whose number is not the length of the coordinates: a name, the coordinates, T, V, and what is found: the
/// number of coordinates of a body, and whether a number of the system says how many act and how many move.
type Counted = (&'static str, &'static str, &'static str, &'static str, Option<(u32, bool, bool)>);

const POINTS: &str = "&[[f64; 3]]";
const FREE: &str = "p.iter().map(|p| 0.5 * p * p).sum()";
const FREE_POINTS: &str = "p.iter().flatten().map(|p| 0.5 * p * p).sum()";

/// A loop over pairs of flat points with the number of bodies `n`.
macro_rules! flat {
    ($n:literal) => {
        flat!($n, "for j in 0..i")
    };
    ($n:literal, $inner:literal) => {
        flat!($n, $inner, "let d = q[3 * i + k] - q[3 * j + k]; r2 += d * d;")
    };
    ($n:literal, $inner:literal, $square:literal) => {
        concat!(
            "let n = ",
            $n,
            "; let mut v = 0.0; for i in 0..n { ",
            $inner,
            " { let mut r2 = self.softening; for k in 0..3 { ",
            $square,
            " } v -= self.m[i] * self.m[j] / r2.sqrt(); } } v"
        )
    };
}

/// The same of points.
macro_rules! points {
    ($outer:literal, $inner:literal) => {
        concat!(
            "let n = self.m.len(); let mut v = 0.0; ",
            $outer,
            " { ",
            $inner,
            " { let mut r2 = self.softening; for k in 0..3 { r2 += (q[i][k] - q[j][k]).powi(2); } ",
            "v -= self.m[i] * self.m[j] / r2.sqrt(); } } v"
        )
    };
}

const COUNTED: [Counted; 35] = [
    ("flat", "&[f64]", FREE, flat!("q.len() / 3"), Some((3, false, false))),
    ("flat, partners behind", "&[f64]", FREE, flat!("q.len() / 3", "for j in i + 1..n"), Some((3, false, false))),
    (
        "flat, all others",
        "&[f64]",
        FREE,
        "let n = q.len() / 3; let mut v = 0.0; for i in 0..n { for j in 0..n { if i != j { \
         v += 0.5 * self.m[i] * self.m[j] * (q[3 * i] - q[3 * j]).cos(); } } } v",
        Some((3, false, false)),
    ),
    ("a flat array", "[f64; 300]", FREE, flat!("100"), Some((3, false, false))),
    ("a short flat array", "[f64; 18]", FREE, flat!("6"), None),
    ("a number of flat bodies", "&[f64]", FREE, flat!("self.n"), Some((3, true, false))),
    ("a list of flat bodies", "&[f64]", FREE, flat!("self.m.len()"), Some((3, true, false))),
    (
        "the factor behind",
        "&[f64]",
        FREE,
        flat!("q.len() / 3", "for j in 0..i", "r2 += (q[i * 3 + k] - q[k + 3 * j]).powi(2);"),
        Some((3, false, false)),
    ),
    (
        "masses in T",
        "&[f64]",
        "let mut t = 0.0; for i in 0..self.m.len() { for k in 0..3 { t += p[3 * i + k].powi(2) / (2.0 * self.m[i]); } } t",
        flat!("q.len() / 3"),
        Some((3, false, true)),
    ),
    (
        "chunks",
        "&[f64]",
        FREE,
        "let mut v = 0.0; for (i, a) in q.chunks_exact(2).enumerate() { for b in q.chunks_exact(2).take(i) { \
         v -= 1.0 / ((a[0] - b[0]).powi(2) + (a[1] - b[1]).powi(2) + self.softening).sqrt(); } } v",
        Some((2, false, false)),
    ),
    (
        "a term of all coordinates",
        "&[f64]",
        FREE,
        concat!("q.iter().map(|q| self.k * q * q).sum::<f64>() + { ", flat!("q.len() / 3"), " }"),
        Some((3, false, false)),
    ),
    (
        "masses by the index of a coordinate",
        "&[f64]",
        "let mut t = 0.0; for k in 0..p.len() { t += p[k].powi(2) / (2.0 * self.m[k / 3]); } t",
        flat!("q.len() / 3"),
        Some((3, false, false)),
    ),
    (
        "a number by the index of a coordinate",
        "&[f64]",
        "let mut t = 0.0; for k in 0..p.len() { t += p[k].powi(2) / self.m[k]; } t",
        flat!("q.len() / 3"),
        None,
    ),
    (
        "a component beyond the point",
        "&[f64]",
        FREE,
        flat!("q.len() / 3", "for j in 0..i", "r2 += (q[3 * i + k] - q[3 * j + 3]).powi(2);"),
        None,
    ),
    (
        "another factor",
        "&[f64]",
        FREE,
        flat!("q.len() / 3", "for j in 0..i", "r2 += (q[3 * i + k] - q[2 * j + k]).powi(2);"),
        None,
    ),
    ("points", POINTS, FREE_POINTS, points!("for i in 0..n", "for j in 0..i"), Some((3, true, false))),
    ("partners behind", POINTS, FREE_POINTS, points!("for i in 0..n", "for j in i + 1..n"), Some((3, true, false))),
    ("not the last", POINTS, FREE_POINTS, points!("for i in 0..n - 1", "for j in i + 1..n"), Some((3, true, false))),
    (
        "not the last, all others",
        POINTS,
        FREE_POINTS,
        "let n = q.len(); let mut v = 0.0; for i in 0..n - 1 { for j in 0..n { if i != j { v += (q[i][0] - q[j][0]).cos(); } } } v",
        None,
    ),
    ("not the last, before", POINTS, FREE_POINTS, points!("for i in 0..n - 1", "for j in 0..i"), None),
    ("a flat array and one more", "[f64; 301]", FREE, flat!("100"), None),
    ("a number after all bodies", "&[f64]", FREE, concat!("self.k * q[3 * self.n] + { ", flat!("self.n"), " }"), None),
    (
        "a condition on flat bodies",
        "&[f64]",
        FREE,
        concat!("let n = q.len() / 3; if n > 2 { ", flat!("q.len() / 3"), " } else { 0.0 }"),
        None,
    ),
    (
        "a sentinel",
        POINTS,
        FREE_POINTS,
        "let mut v = 0.0; for i in 0..self.n { if self.kind[i] < 0 { continue; } for j in 0..i { if self.kind[j] < 0 { continue; } v += self.table[self.kind[i] as usize][self.kind[j] as usize] * self.m[i] * (q[i][0] - q[j][0]).cos(); } } v",
        None,
    ),
    ("not the last two", POINTS, FREE_POINTS, points!("for i in 0..n - 2", "for j in i + 1..n"), None),
    ("not the last partner", POINTS, FREE_POINTS, points!("for i in 0..n - 1", "for j in i + 1..n - 1"), None),
    (
        "not the last point",
        POINTS,
        FREE_POINTS,
        points!("for i in 0..q.len() - 1", "for j in i + 1..q.len()"),
        Some((3, false, false)),
    ),
    ("two numbers", POINTS, FREE_POINTS, points!("for i in 0..n", "for j in 0..self.n"), None),
    ("the first of the others", POINTS, FREE_POINTS, points!("for i in n..q.len()", "for j in 0..n"), None),
    (
        "zipped",
        POINTS,
        "p.iter().zip(&self.m).map(|(p, m)| (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / m).sum()",
        "let mut v = 0.0; for (i, (a, m)) in q.iter().zip(&self.m).enumerate() { for (b, n) in q.iter().zip(&self.m).take(i) { \
         v -= m * n / ((0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>() + self.softening).sqrt(); } } v",
        Some((3, true, false)),
    ),
    (
        "numbers alone",
        "&[f64]",
        FREE,
        "let mut v = 0.0; for i in 0..self.n { for j in 0..i { v += (q[i] - q[j]).cos(); } } v",
        Some((1, true, false)),
    ),
    (
        "a product with a table",
        POINTS,
        FREE_POINTS,
        "let mut v = 0.0; for i in 0..self.n { for j in 0..i { if self.molecule[i] != self.molecule[j] { \
         v += self.table[self.kind[i]][self.kind[j]] * self.m[i] * self.m[j] * (q[i][0] - q[j][0]).cos(); } } } v",
        Some((3, true, false)),
    ),
    (
        "a product with a table of bodies",
        POINTS,
        FREE_POINTS,
        "let mut v = 0.0; for i in 0..self.n { for j in 0..i { v += self.table[i][j] * self.m[i] * (q[i][0] - q[j][0]).cos(); } } v",
        None,
    ),
    (
        "a number of a member",
        POINTS,
        FREE_POINTS,
        "let n = self.count as usize; let mut v = 0.0; for i in 0..n { for j in 0..i { v += (q[i][0] - q[j][0]).cos(); } } v",
        Some((3, true, false)),
    ),
    (
        "twice as many",
        POINTS,
        FREE_POINTS,
        "let mut v = 0.0; for i in 0..2 * self.n { for j in 0..i { v += (q[i][0] - q[j][0]).cos(); } } v",
        None,
    ),
];

#[test]
fn bodies_are_counted_by_the_loops() {
    for (name, coordinates, kinetic, potential, found) in COUNTED {
        let text = format!(
            "impl Bodies {{ fn kinetic(&self, p: {coordinates}) -> f64 {{ {kinetic} }} \
             fn potential(&self, q: {coordinates}) -> f64 {{ {potential} }} }}"
        );
        let text = hamiltonian(proc_macro2::TokenStream::new(), text.parse().expect("tokens")).to_string();
        assert!(!text.contains("compile_error"), "{name}: {text}");
        let dimension = text.split_once("runtime :: ManyBody < ").map(|(_, text)| text[..1].parse().expect("a digit"));
        let counts =
            dimension.map(|dimension: u32| (dimension, text.contains("fn acting"), text.contains("fn moving")));
        assert_eq!(counts, found, "{name}: {text}");
        let is_flat = found.is_some_and(|(dimension, ..)| dimension > 1 && coordinates.contains("[f64]"));
        assert_eq!(text.contains("are_points"), is_flat, "{name}: {text}");
    }
}
