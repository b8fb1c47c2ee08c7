//! Spellings of one energy of pairs: the generated code of the pairs is the same.

use integrator_symbolic::hamiltonian;

const POINTS: &str = "&[[f64; 3]]";
const OF_POINTS: &str = "let mut t = 0.0; for i in 0..p.len() { for d in 0..3 { t += 0.5 * p[i][d] * p[i][d]; } } t";
const BEFORE: &str = "let mut v = 0.0; for i in 0..q.len() { for j in 0..i {";
const ATTRACTION: &str = "v -= self.m[i] * self.m[j] / (r2 + self.softening).sqrt(); } } v";

/// Squares of distances, as they are written in loops over pairs.
const SQUARES: [&str; 5] = [
    "let r2 = (q[i][0] - q[j][0]).powi(2) + (q[i][1] - q[j][1]).powi(2) + (q[i][2] - q[j][2]).powi(2);",
    "let mut r2 = 0.0; for k in 0..3 { r2 += (q[i][k] - q[j][k]).powi(2); }",
    "let r2: f64 = (0..3).map(|k| (q[i][k] - q[j][k]).powi(2)).sum();",
    "let r2: f64 = q[i].iter().zip(&q[j]).map(|(a, b)| (a - b).powi(2)).sum();",
    "let d = [q[i][0] - q[j][0], q[i][1] - q[j][1], q[i][2] - q[j][2]]; let r2 = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];",
];

/// The generated functions of pairs, or nothing where pairs are not recognised.
fn of_pairs([coordinates, kinetic, potential]: [&str; 3]) -> Option<String> {
    let text = format!(
        "impl Bodies {{ fn kinetic(&self, p: {coordinates}) -> f64 {{ {kinetic} }} \
         fn potential(&self, q: {coordinates}) -> f64 {{ {potential} }} }}"
    );
    let text = hamiltonian(proc_macro2::TokenStream::new(), text.parse().expect("tokens")).to_string();
    assert!(!text.contains("compile_error"), "{potential}: {text}");
    let (_, from) = text.split_once("impl runtime :: ManyBody")?;
    from.split_once("impl runtime :: BodyConstants").map(|(text, _)| text.to_owned())
}

/// Asserts that all potentials have the same code of pairs, and returns it.
fn one_code(coordinates: &str, kinetic: &str, potentials: &[String]) -> String {
    let mut texts = potentials.iter().map(|potential| {
        of_pairs([coordinates, kinetic, potential]).unwrap_or_else(|| panic!("no pairs: {potential}"))
    });
    let first = texts.next().expect("a potential");
    for (text, potential) in texts.zip(&potentials[1..]) {
        assert_eq!(text, first, "{potential}");
    }
    first
}

#[test]
fn distances_have_one_code() {
    let potentials = SQUARES.map(|square| format!("{BEFORE} {square} {ATTRACTION}"));
    let of_points = one_code(POINTS, OF_POINTS, &potentials);
    assert!(of_points.contains("CENTRAL : bool = true"), "{of_points}");
    let kinetic = "p.iter().map(|p| 0.5 * p * p).sum()";
    let flat = format!(
        "let mut v = 0.0; for i in 0..q.len() / 3 {{ for j in 0..i {{ \
         let mut r2 = 0.0; for k in 0..3 {{ r2 += (q[3 * i + k] - q[3 * j + k]).powi(2); }} {ATTRACTION}"
    );
    let flat = one_code("&[f64]", kinetic, &[flat]);
    let pair = |text: &str| text.split_once("fn pair").map(|(_, text)| text.to_owned());
    assert_eq!(pair(&flat), pair(&of_points));
}

/// A number of each component, such as the sides of a box, and a product with a matrix.
#[test]
fn numbers_of_components_have_one_code() {
    let anisotropic = [
        "let mut u = 0.0; for k in 0..3 { u += self.side[k] * (q[i][k] - q[j][k]).powi(2); }",
        "let u = self.side[0] * (q[i][0] - q[j][0]).powi(2) + self.side[1] * (q[i][1] - q[j][1]).powi(2) \
         + self.side[2] * (q[i][2] - q[j][2]).powi(2);",
    ];
    let metric = [
        "let mut u = 0.0; for a in 0..2 { for b in 0..2 { u += self.g[a][b] * (q[i][a] - q[j][a]) * (q[i][b] - q[j][b]); } }",
        "let (x, y) = (q[i][0] - q[j][0], q[i][1] - q[j][1]); \
         let u = (self.g[0][0] * x * x + self.g[0][1] * x * y) + (self.g[1][0] * y * x + self.g[1][1] * y * y);",
    ];
    for squares in [anisotropic, metric] {
        let potentials = squares.map(|square| format!("{BEFORE} {square} v += u.exp(); }} }} v"));
        let text = one_code(POINTS, OF_POINTS, &potentials);
        assert!(!text.contains("for k in") && !text.contains("for a in"), "{text}");
    }
}

/// Sixteen terms at most are written out.
#[test]
fn long_sums_stay_loops() {
    let sum = |of: u32| {
        format!(
            "{BEFORE} let mut u = 0.0; for a in 0..{of} {{ for b in 0..{of} {{ u += ((q[i][a] - q[j][a]) * (q[i][b] - q[j][b])).cos(); }} }} \
             v += u; }} }} v"
        )
    };
    let kinetic = OF_POINTS.replace("..3", "..5");
    let text = |of| of_pairs(["&[[f64; 5]]", &kinetic, &sum(of)]).expect("pairs");
    assert!(!text(4).contains("for a in"), "{}", text(4));
    assert!(text(5).contains("for a in"), "{}", text(5));
}

/// Squares of images `image` of displacements `x`, within a cutoff.
fn in_box(image: &str) -> String {
    format!(
        "{BEFORE} let mut r2 = 0.0; for k in 0..3 {{ let x = q[i][k] - q[j][k]; let image = {image}; r2 += image * image; }} \
         if r2 < self.cutoff {{ v += 1.0 / r2; }} }} }} v"
    )
}

/// The statements of a text without the numbers in names, in one order: values have the order in which they are first written.
fn statements(text: &str) -> Vec<String> {
    let is_digit = |letter: char| letter.is_ascii_digit();
    let in_names = |statement: &str| statement.split('_').map(|part| part.trim_start_matches(is_digit)).collect();
    let mut statements: Vec<String> = text.split(';').map(in_names).collect();
    statements.sort();
    statements
}

#[test]
fn nearest_images_have_one_code() {
    let among_all = [
        "x - self.side * (x / self.side).round_ties_even()",
        "x - self.side * (x / self.side).round()",
        "x - (x / self.side + 0.5).floor() * self.side",
        "self.side * (x / self.side - 0.5).ceil() - x",
        "(x / self.side - (x / self.side).round()) * self.side",
        "(x + 0.5 * self.side).rem_euclid(self.side) - 0.5 * self.side",
        "((x % self.side) + 1.5 * self.side) % self.side - self.side / 2.0",
        "{ let near = x % self.side; near.abs().min(self.side - near.abs()) }",
    ];
    let beside = [
        "x.abs().min(self.side - x.abs())",
        "if x > 0.5 * self.side { x - self.side } else if x < -0.5 * self.side { x + self.side } else { x }",
        "if x.abs() > self.side / 2.0 { x.abs() - self.side } else { x.abs() }",
        "if x.abs() <= 0.5 * self.side { x } else { x - self.side * x.signum() }",
        "{ let low = if x > 0.5 * self.side { x - self.side } else { x }; if low < -0.5 * self.side { low + self.side } else { low } }",
        "{ let half = self.side / 2.0; let low = if x > half { x - self.side } else { x }; if low < -half { low + self.side } else { low } }",
        "x - self.side * (x / self.side).round().max(-1.0).min(1.0)",
    ];
    for (images, own, other) in
        [(&among_all[..], "round_ties_even", "less (-"), (&beside, "less (-", "round_ties_even")]
    {
        let texts = images.iter().map(|image| of_pairs([POINTS, OF_POINTS, &in_box(image)]).expect("pairs"));
        let texts: Vec<_> = texts.collect();
        let (text, first) = (&texts[0], statements(&texts[0]));
        for (text, image) in texts.iter().zip(images) {
            assert_eq!(statements(text), first, "{image}");
        }
        assert!(text.contains(own) && !text.contains(other) && text.contains("LISTED_FROM"), "{text}");
        // No order of the bodies.
        assert!(!text.contains("NUMBER"), "{text}");
    }
    // Not the nearest ones of all displacements, or of another side.
    let shifted = [
        "x - self.side * (x * self.k).round()",
        "x - self.side * (x * self.k + 0.5).floor()",
        "x - self.side * (x / self.side).round().max(-2.0).min(2.0)",
        "x - self.side * (x / self.side).round().max(-100.0).min(100.0)",
    ];
    for image in shifted {
        let text = of_pairs([POINTS, OF_POINTS, &in_box(image)]).expect("pairs");
        assert!(text.contains("round_ties_even") && !text.contains("NUMBER"), "{text}");
    }
}

/// These are images, but not the nearest ones of all displacements or of all sides.
#[test]
fn other_images_are_left_as_they_are() {
    let others = [
        "x - self.side * (x / self.side).trunc()",
        "(x + 0.5 * self.side) % self.side - 0.5 * self.side",
        "(x + 1.5 * self.side) % self.side - 0.5 * self.side",
        "(x + 0.25 * self.side).rem_euclid(self.side) - 0.25 * self.side",
        "if x > 0.5 * self.side { x - self.side } else { x }",
        "if x > self.side { x - self.side } else if x < -self.side { x + self.side } else { x }",
        "if x > 0.5 { x - self.side } else if x < -0.5 { x + self.side } else { x }",
        "{ let near = x.abs().min(self.side - x.abs()); near.abs().min((self.side - near.abs()).abs()) }",
    ];
    for image in others {
        let text = of_pairs([POINTS, OF_POINTS, &in_box(image)]).expect("pairs");
        assert!(!text.contains("round_ties_even"), "{image}: {text}");
    }
}

/// Conditions on the indices `i` and `j` of all bodies, around the energy of a pair.
#[test]
fn conditions_on_indices_have_one_code() {
    const HALVED: &str = "0.5 * self.m[i] * self.m[j] *";
    let loops = |guard: &str, factor: &str, end: &str| {
        format!(
            "let mut v = 0.0; for i in 0..q.len() {{ for j in 0..q.len() {{ \
             let r2: f64 = (0..3).map(|k| (q[i][k] - q[j][k]).powi(2)).sum(); \
             {guard} v += {factor} (self.cutoff - r2).powi(2); {end} }} }} v"
        )
    };
    let within = [
        ("if i != j { if r2 < self.cutoff {", "} }"),
        ("if r2 < self.cutoff { if j != i {", "} }"),
        ("if i != j && r2 < self.cutoff {", "}"),
        ("if r2 < self.cutoff && j != i {", "}"),
        ("if !(i == j || !(r2 < self.cutoff)) {", "}"),
        ("if !(i != j && r2 < self.cutoff) { continue; }", ""),
        ("if j == i || !(r2 < self.cutoff) { continue; }", ""),
        ("let is_left_out = i == j; if is_left_out {} else if r2 < self.cutoff {", "}"),
    ];
    let beyond = [
        ("if i == j { continue; } if r2 >= self.cutoff { continue; }", ""),
        ("if i == j || r2 >= self.cutoff { continue; }", ""),
        ("if self.cutoff <= r2 || j == i { continue; }", ""),
        ("if !(i != j && !(r2 >= self.cutoff)) { continue; }", ""),
    ];
    for guards in [&within[..], &beyond] {
        let potentials: Vec<String> = guards.iter().map(|(guard, end)| loops(guard, HALVED, end)).collect();
        one_code(POINTS, OF_POINTS, &potentials);
    }
    let filtered = |filter: &str| {
        format!(
            "let square = |i: usize, j: usize| (0..3).map(|k| (q[i][k] - q[j][k]).powi(2)).sum::<f64>(); let mut v = 0.0; \
             for i in 0..q.len() {{ for j in (0..q.len()).filter(|&j| {filter}) {{ \
             v += 0.5 * self.m[i] * self.m[j] * (self.cutoff - square(i, j)).powi(2); }} }} v"
        )
    };
    let filters = ["j != i && square(i, j) < self.cutoff", "!(j == i || !(square(i, j) < self.cutoff))"];
    let mut potentials = filters.map(filtered).to_vec();
    potentials.push(loops(within[0].0, HALVED, within[0].1));
    one_code(POINTS, OF_POINTS, &potentials);
    // Each pair once, in loops over all bodies.
    let once = format!(
        "{BEFORE} let r2: f64 = (0..3).map(|k| (q[i][k] - q[j][k]).powi(2)).sum(); \
         if r2 < self.cutoff {{ v += (self.cutoff - r2).powi(2); }} }} }} v"
    );
    let once = of_pairs([POINTS, OF_POINTS, &once]).expect("pairs");
    let halves = [
        ("if j < i { if r2 < self.cutoff {", "} }"),
        ("if j < i && r2 < self.cutoff {", "}"),
        ("if r2 < self.cutoff && i > j {", "}"),
        ("if j >= i || !(r2 < self.cutoff) { continue; }", ""),
        ("if j > i && r2 < self.cutoff {", "}"),
        ("if j <= i || !(r2 < self.cutoff) { continue; }", ""),
    ];
    for (guard, end) in halves {
        let text = of_pairs([POINTS, OF_POINTS, &loops(guard, "", end)]).expect(guard);
        assert_eq!(statements(&text), statements(&once), "{guard}");
    }
    // The order of the bodies may decide what a pair adds.
    let text = of_pairs([
        POINTS,
        OF_POINTS,
        &loops("if j == i || r2 >= self.cutoff { continue; } if j > i { v -= q[i][0]; }", "", ""),
    ]);
    assert_eq!(text, None);
}

/// Loops over all bodies that add half of the pairs prepare tables by the kinds of bodies, as loops over half of the pairs do.
#[test]
fn tables_under_conditions_on_indices_are_by_kind() {
    for guard in ["j < i", "i > j && r2 < 2.0", "!(j >= i)", "i < j", "j > i && i != j", "i != j"] {
        let energy = "self.depth[self.kind[i]][self.kind[j]] * (self.cutoff - r2).powi(2)";
        let text = format!(
            "impl Bodies {{ fn kinetic(&self, p: {POINTS}) -> f64 {{ {OF_POINTS} }} fn potential(&self, q: {POINTS}) -> f64 {{ \
             let mut v = 0.0; for i in 0..q.len() {{ for j in 0..q.len() {{ \
             let r2: f64 = (0..3).map(|k| (q[i][k] - q[j][k]).powi(2)).sum(); \
             if {guard} {{ if r2 < self.cutoff {{ v += {energy}; }} }} }} }} v }} }}"
        );
        let text = hamiltonian(proc_macro2::TokenStream::new(), text.parse().expect("tokens")).to_string();
        assert!(text.contains("LISTED_FROM") && text.contains("ByClass"), "{guard}: {text}");
        // No number of each pair.
        assert!(!text.contains("SharedTable < runtime :: SharedTable"), "{guard}: {text}");
        // Nothing is shown to people but the user's own text.
        assert!(!text.contains("`if") && !text.contains("\"if"), "{guard}: {text}");
    }
}

/// Loops that add parts of the same pairs look up one entry for each pair, if it depends on one value of each body.
#[test]
fn several_loops_look_up_one_entry() {
    let kinds = "self.depth[self.kind[i]][self.kind[j]]";
    let rows = [
        (&[("0..i", "0.5"), ("i + 1..q.len()", "0.25")][..], kinds, 1),
        (&[("(0..q.len()).filter(|&j| j != i)", "0.5")], kinds, 1),
        (&[("0..i", "0.2"), ("(0..q.len()).filter(|&j| j != i)", "-0.5"), ("i + 1..q.len()", "self.k")], kinds, 1),
        // Two values of each body.
        (&[("(0..q.len()).filter(|&j| j != i)", "0.5")], "self.depth[self.kind[i]][self.type_of[j]]", 2),
    ];
    for (loops, depth, entries) in rows {
        let terms = loops.iter().map(|(range, factor)| {
            format!(
                "for j in {range} {{ let r2: f64 = (0..3).map(|k| (q[i][k] - q[j][k]).powi(2)).sum(); \
                 if r2 < self.cutoff {{ v += {factor} * {depth} * (self.cutoff - r2).powi(2); }} }}"
            )
        });
        let potential = format!("let mut v = 0.0; for i in 0..q.len() {{ {} }} v", terms.collect::<String>());
        let text = of_pairs([POINTS, OF_POINTS, &potential]).expect("pairs");
        let (_, pair) = text.split_once("fn pair").expect("a function of a pair");
        let (pair, _) = pair.split_once("fn interacts").expect("a cutoff");
        assert_eq!(pair.matches(". entry").count(), entries, "{potential}: {pair}");
    }
}
