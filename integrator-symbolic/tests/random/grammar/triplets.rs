//! Random systems of bodies with sums over a body and two others: every order of the three loops, cutoffs inside and outside of the
//! innermost one, boxes, weights of each body, and pairs beside.

use super::{Choices, Grammar, System};

/// The bodies of a seed.
pub(crate) fn triplets(seed: u64) -> System {
    let mut choices = Choices::new(seed);
    let (length, dimension) = (3 + choices.below(4), 1 + choices.below(3));
    let (dimension, helpers) = (Some(dimension), Vec::new());
    Grammar { choices, length, dimension, is_dynamic: true, has_time: false, letter: "q", helpers, count: 0 }
        .of_sums(1, Grammar::sum_over_triplets)
}

impl Grammar {
    /// Three loops over bodies around a term of a body and two others.
    fn sum_over_triplets(&mut self) -> String {
        let dimension = self.dimension.unwrap_or(1);
        let wrap = match self.choices.percent(30) {
            true => "let d = d - 2.5 * (d / 2.5).round(); ",
            false => "",
        };
        let square = |name: &str, [a, b]: [&str; 2]| {
            format!(
                "let mut {name} = 0.0; for d in 0..{dimension} {{ let d = q[{b}][d] - q[{a}][d]; {wrap}{name} += d * d; }} "
            )
        };
        let (first, second, between) = (square("a", ["i", "j"]), square("b", ["i", "k"]), square("c", ["j", "k"]));
        let weight = self.choices.of(&["1.0", "self.a", "self.k[i]", "self.k[j] * self.k[k]", "self.k[k]"]);
        let energy = self.choices.of(&[
            "(self.pos - a) * (self.pos - b)",
            "(self.pos - a).powi(2) * (self.pos - b).powi(2) * (a + b - c)",
            "(-a - b).exp() * c",
        ]);
        let term = format!("{second} {between} if b < self.pos {{ v += {weight} * {energy}; }}");
        let (distinct, factor) = ("if k == i || k == j { continue; } ", "v += 0.5 *");
        let inner = match self.choices.below(5) {
            0 => format!("for k in j + 1..q.len() {{ if k != i {{ {term} }} }}"),
            1 => format!("for k in 0..j {{ if i != k {{ {term} }} }}"),
            2 => format!("for k in 0..q.len() {{ {distinct} {} }}", term.replace("v +=", factor)),
            3 => format!("for k in 0..q.len() {{ if k <= j || k == i {{ continue; }} {term} }}"),
            _ => format!("for k in 0..i {{ if k != j {{ {term} }} }}"),
        };
        let pair = self.choices.of(&["", "", "v += (self.pos - a) * a; "]);
        let others = self.choices.of(&["0..q.len()", "0..q.len()", "0..i", "i + 1..q.len()"]);
        match self.choices.percent(50) {
            true => format!(
                "for i in 0..q.len() {{ for j in {others} {{ if j != i {{ {first} if a < self.pos {{ {pair} {inner} }} }} }} }} "
            ),
            false => format!(
                "for i in 0..q.len() {{ for j in {others} {{ if i == j {{ continue; }} {first} if a >= self.pos {{ continue; }} \
                 {inner} }} }} "
            ),
        }
    }
}
