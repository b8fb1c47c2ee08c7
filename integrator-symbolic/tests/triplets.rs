//! Sums over a body and two others within a cutoff: which spellings are recognised, and why others are not.

use integrator_symbolic::{hamiltonian, report};
use proc_macro2::TokenStream;

const KINETIC: &str = "fn kinetic(&self, p: &[[f64; 3]]) -> f64 { p.iter().flatten().map(|p| 0.5 * p * p).sum() }";

/// Distances, and the energy of a triplet.
const BEFORE: &str = "let mut v = 0.0;
    let square = |i: usize, j: usize| (q[i][0] - q[j][0]).powi(2) + (q[i][1] - q[j][1]).powi(2) + (q[i][2] - q[j][2]).powi(2);
    let bend = |i: usize, j: usize, k: usize| {
        let cosine = (q[j][0] - q[i][0]) * (q[k][0] - q[i][0]) + (q[j][1] - q[i][1]) * (q[k][1] - q[i][1]);
        (cosine + self.angle).powi(2) * (self.a - square(i, j)).powi(2) * (self.a - square(i, k)).powi(2)
    };";

fn system(body: &str) -> TokenStream {
    let text = format!("impl S {{ {KINETIC} fn potential(&self, q: &[[f64; 3]]) -> f64 {{ {BEFORE} {body} v }} }}");
    text.parse().expect("tokens")
}

/// The name of the layout of the kick, its cost, and the reasons for which it is not a faster one.
fn kick(body: &str) -> (&'static str, Option<&'static str>, Vec<String>) {
    let kick = report(TokenStream::new(), system(body)).unwrap_or_else(|error| panic!("{body}: {error}")).kick;
    (kick.form.name(), kick.cost, kick.slower.iter().map(ToString::to_string).collect())
}

const WITHIN: &str = "if square(i, j) < self.a && square(i, k) < self.a { v += bend(i, j, k); }";

#[test]
fn every_spelling_is_one_of_triplets() {
    let spellings = [
        format!(
            "for i in 0..q.len() {{ for j in 0..q.len() {{ for k in j + 1..q.len() {{ if i != j && i != k {{ {WITHIN} }} }} }} }}"
        ),
        format!(
            "for i in 0..q.len() {{ for j in 0..q.len() {{ for k in 0..j {{ if i != j && k != i {{ {WITHIN} }} }} }} }}"
        ),
        format!(
            "for i in 0..q.len() {{ for j in 0..q.len() {{ if j == i {{ continue; }} for k in 0..q.len() {{ \
             if k == i || k <= j {{ continue; }} {WITHIN} }} }} }}"
        ),
        "for i in 0..q.len() { for j in 0..q.len() { let a = square(i, j); if j == i || a >= self.a { continue; } \
         for k in j + 1..q.len() { if k != i && square(i, k) < self.a { v += bend(i, j, k); } } } }"
            .to_owned(),
        "for i in 0..q.len() { for j in 0..q.len() { if j != i && square(i, j) < self.a { for k in 0..q.len() { \
         if k != i && k != j && square(i, k) < self.a { v += 0.5 * bend(i, j, k); } } } } }"
            .to_owned(),
        "v = (0..q.len()).map(|i| (0..q.len()).filter(|&j| j != i && square(i, j) < self.a).map(|j| (j + 1..q.len())\
         .filter(|&k| k != i && square(i, k) < self.a).map(|k| bend(i, j, k)).sum::<f64>()).sum::<f64>()).sum();"
            .to_owned(),
    ];
    for spelling in spellings {
        let (name, cost, slower) = kick(&spelling);
        assert_eq!((name, cost), ("triplets", Some("the pairs and triplets within the cutoff")), "{spelling}");
        assert!(slower.is_empty(), "{spelling}: {slower:?}");
        let expanded = hamiltonian(TokenStream::new(), system(&spelling)).to_string();
        // Nothing is left for loops as written.
        assert!(expanded.contains("TRIPLETS : bool = true") && !expanded.contains("OTHER_TERMS"), "{spelling}");
        // Both orders of the two others are one term.
        assert_eq!(expanded.matches("fn triplet <").count(), 1, "{spelling}");
    }
}

/// Terms of pairs in the loops over triplets are pairs, whatever the conditions around both are.
#[test]
fn pairs_beside_triplets_are_no_other_terms() {
    let guards = [
        ("if j == i { continue; } if a >= self.a { continue; }", ""),
        ("if j == i || a >= self.a { continue; }", ""),
        ("if a >= self.a || i == j { continue; }", ""),
        ("if !(j != i && a < self.a) { continue; }", ""),
        ("if j != i && a < self.a {", "}"),
        ("if a < self.a { if i != j {", "} }"),
    ];
    for (guard, end) in guards {
        let spelling = format!(
            "for i in 0..q.len() {{ for j in 0..q.len() {{ let a = square(i, j); {guard} v += (self.a - a).powi(2); \
             for k in j + 1..q.len() {{ if k == i || square(i, k) >= self.a {{ continue; }} v += bend(i, j, k); }} {end} }} }}"
        );
        let (name, cost, slower) = kick(&spelling);
        assert_eq!((name, cost), ("triplets", Some("the pairs and triplets within the cutoff")), "{spelling}");
        assert!(slower.is_empty(), "{spelling}: {slower:?}");
        let expanded = hamiltonian(TokenStream::new(), system(&spelling)).to_string();
        assert!(!expanded.contains("OTHER_TERMS"), "{spelling}");
    }
}

/// Terms beside triplets keep their form.
#[test]
fn other_terms_are_apart_from_triplets() {
    let triplets = format!(
        "for i in 0..q.len() {{ for j in 0..q.len() {{ for k in j + 1..q.len() {{ if i != j && i != k {{ {WITHIN} }} }} }} }}"
    );
    let in_lists =
        "for i in 0..q.len() { for j in 0..i { if square(i, j) < self.b { v += (self.b - square(i, j)).powi(2); } } }";
    let of_all = "for i in 0..q.len() { for j in 0..i { v += 1.0 / square(i, j); } }";
    let bonds = "for &(i, j) in &self.bonds { v += (square(i, j) - 1.0).powi(2); }";
    let rows = [
        (in_lists, Some("the pairs and triplets within the cutoff")),
        (of_all, Some("all pairs and the triplets within the cutoff")),
        (bonds, Some("the pairs and triplets within the cutoff")),
    ];
    for (beside, cost) in rows {
        let (name, found, _) = kick(&format!("{beside} {triplets}"));
        assert_eq!((name, found), ("triplets", cost), "{beside}");
    }
    let kick = report(TokenStream::new(), system(&format!("{bonds} {triplets}"))).expect("no mistake").kick;
    assert_eq!(kick.others.map(integrator_symbolic::Form::name), Some("terms"));
}

#[test]
fn sums_that_are_no_triplets_have_reasons() {
    let pairs = "for i in 0..q.len() { for j in 0..i { if square(i, j) < self.a { v += square(i, j); } } }";
    let three = |inner: &str| {
        format!(
            "{pairs} for i in 0..q.len() {{ for j in 0..q.len() {{ if j != i {{ for k in j + 1..q.len() {{ if k != i {{ {inner} }} }} }} }} }}"
        )
    };
    let rows = [
        (three("v += bend(i, j, k);"), "no condition makes the energy of three bodies zero"),
        (
            three("if square(i, j) < self.a { v += bend(i, j, k); }"),
            "no condition makes the energy of three bodies zero",
        ),
        (three("if square(i, j) < self.a && square(j, k) < self.a { v += bend(i, j, k); }"), "no condition makes"),
        (
            three(&WITHIN.replace("bend(i, j, k)", "bend(i, j, k) * q[i][0]")),
            "the energy of three bodies depends on more than the displacements between them",
        ),
        (
            three(&WITHIN.replace("bend(i, j, k)", "bend(i, j, k) * self.cube[i][j][k]")),
            "the energy of three bodies reads others, or a parameter or condition of all three at once",
        ),
        (
            format!(
                "{pairs} for i in 0..q.len() {{ for j in 0..q.len() {{ for k in j + 1..q.len() {{ if j != i {{ {WITHIN} }} }} }} }}"
            ),
            "the loops over a body and two others include terms in which two of the three are the same body",
        ),
        (
            format!(
                "{pairs} for i in 0..q.len() {{ for j in 0..q.len() {{ if j != i {{ let mut sum = 0.0; for k in 0..q.len() {{ \
                 if k != i && k != j && square(i, k) < self.a {{ sum += square(i, k); }} }} \
                 if square(i, j) < self.a {{ v += square(i, j) / (1.0 + sum); }} }} }} }}"
            ),
            "a sum over two others of a body is inside of a function",
        ),
    ];
    for (body, expected) in rows {
        let (name, _, slower) = kick(&body);
        assert_eq!(name, "lists", "{body}");
        let is_said = |line: &String| line.starts_with(&format!("not `triplets`: {expected}"));
        assert!(slower.iter().any(is_said), "{body}\n{slower:#?}");
    }
}

/// `layout = triplets` refuses sums of pairs alone.
#[test]
fn a_sum_without_triplets_has_no_such_layout() {
    let arguments: TokenStream = "layout = triplets".parse().expect("tokens");
    let pairs = "for i in 0..q.len() { for j in 0..i { if square(i, j) < self.a { v += square(i, j); } } }";
    let expanded = hamiltonian(arguments.clone(), system(pairs)).to_string();
    for said in ["the kick has the layout `lists` instead of `triplets`", "V has no sum over a body and two others"] {
        assert!(expanded.contains(said), "{expanded}");
    }
    let triplets = format!(
        "for i in 0..q.len() {{ for j in 0..q.len() {{ for k in j + 1..q.len() {{ if i != j && i != k {{ {WITHIN} }} }} }} }}"
    );
    let expanded = hamiltonian(arguments, system(&triplets)).to_string();
    assert!(!expanded.contains("compile_error"), "{expanded}");
}
