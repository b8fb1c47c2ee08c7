//! Random systems of bodies in pairs: every order of the two loops, distances by components and by loops, weights of one body or of
//! both, cutoffs, boxes, and terms of single bodies between the loops.

use super::{Choices, Grammar, System};

/// The bodies of a seed.
pub(crate) fn pairs(seed: u64) -> System {
    let mut choices = Choices::new(seed);
    let (length, dimension) = (2 + choices.below(6), 1 + choices.below(3));
    let is_dynamic = choices.percent(50);
    let (dimension, helpers) = (Some(dimension), Vec::new());
    Grammar { choices, length, dimension, is_dynamic, has_time: false, letter: "q", helpers, count: 0 }
        .of_sums(2, Grammar::sum_over_pairs)
}

impl Grammar {
    /// Two loops over bodies around a term of each pair, with terms of single bodies beside them.
    fn sum_over_pairs(&mut self) -> String {
        let dimension = self.dimension.unwrap_or(1);
        let n = if self.is_dynamic { "q.len()".to_owned() } else { self.length.to_string() };
        let term = self.term_of_pair(dimension);
        let inner = match self.choices.below(7) {
            0 => format!("for j in 0..i {{ {term} }}"),
            1 => format!("for j in i + 1..{n} {{ {term} }}"),
            2 => format!("for j in 0..{n} {{ if i != j {{ {term} }} }}"),
            3 => format!("for j in 0..{n} {{ if j < i {{ {term} }} }}"),
            4 => format!("for j in 0..{n} {{ if j <= i {{ continue; }} {term} }}"),
            5 => format!("for j in 0..{n} {{ if j == i {{ continue; }} {term} }}"),
            _ => format!("for j in (0..{n}).filter(|j| *j > i) {{ {term} }}"),
        };
        let single = self.choices.of(&["", "", "v += self.k[i] * q[i][0];", "v += 0.5 * q[i][0] * q[i][0];"]);
        match self.choices.below(3) {
            0 => format!("for i in 0..{n} {{ {single} {inner} }} "),
            1 => format!("for i in 0..{n} {{ {inner} {single} }} "),
            _ => format!("for i in 0..{n} {{ {inner} }} "),
        }
    }

    fn term_of_pair(&mut self, dimension: usize) -> String {
        let (mut text, ahead) = (String::new(), self.choices.percent(50));
        let difference =
            |k: &str| if ahead { format!("q[i][{k}] - q[j][{k}]") } else { format!("q[j][{k}] - q[i][{k}]") };
        let in_box = self.choices.percent(20);
        let wrap = |d: &str| if in_box { format!("{d} - 2.5 * ({d} / 2.5).round()") } else { d.to_owned() };
        let start = self.choices.of(&["0.0", "0.0", "self.pos", "self.pos * self.pos"]);
        if self.choices.percent(50) {
            let (d, image) = (difference("k"), wrap("d"));
            text += &format!(
                "let mut r2 = {start}; for k in 0..{dimension} {{ let d = {d}; let d = {image}; r2 += d * d; }} "
            );
        } else {
            let mut squares = Vec::new();
            for k in 0..dimension {
                let name = format!("d{k}");
                text += &format!("let {name} = {}; let {name} = {}; ", difference(&k.to_string()), wrap(&name));
                squares.push(format!("{name} * {name}"));
            }
            let softening = if start == "0.0" { String::new() } else { format!(" + {start}") };
            text += &format!("let r2 = {}{softening}; ", squares.join(" + "));
        }
        let weight = self.choices.of(&[
            "1.0",
            "self.a",
            "self.k[i] * self.k[j]",
            "(self.k[i] + self.k[j])",
            "self.k[i]",
            "self.k[j]",
            "self.long[i] * self.k[j]",
            "self.rows[i][j]",
        ]);
        let energy = match self.choices.below(6) {
            0 => format!("{weight} / r2.sqrt()"),
            1 => format!("{weight} * (-r2).exp()"),
            2 => format!("{weight} * (1.0 / r2 - 2.0 / (r2 * r2))"),
            3 => format!("{weight} * (r2.sqrt() - self.pos).powi(2)"),
            4 => format!("{weight} * r2 * r2"),
            _ => format!("{weight} * (-r2.sqrt()).exp() / r2.sqrt()"),
        };
        let sign = self.choices.of(&["+=", "-="]);
        match self.choices.below(5) {
            0 => text + &format!("if r2 < self.pos {{ v {sign} {energy}; }} "),
            1 => text + &format!("if r2 >= self.pos {{ continue; }} v {sign} {energy}; "),
            2 => text + &format!("v {sign} if r2 < 1.5 {{ {energy} }} else {{ 0.5 * r2 }}; "),
            _ => text + &format!("v {sign} {energy}; "),
        }
    }
}
