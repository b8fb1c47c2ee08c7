//! Random lattices: chains and planes of sites, with terms of single sites and of bonds in loops of several ranges, behind guards
//! at either end.

use super::{Choices, Grammar, System};

/// The most neighbours along a line, and the rows above and below, that a bond spans.
const FARTHEST: i64 = 2;
const FARTHEST_ROW: i64 = 1;

/// The lattice of a seed.
pub(crate) fn lattice(seed: u64) -> System {
    let mut choices = Choices::new(seed);
    let is_plane = choices.percent(30);
    // Shorter lattices of known length are plain loops.
    let (rows, sites) = if is_plane { (3 + choices.below(3), 8 + choices.below(2)) } else { (8 + choices.below(6), 1) };
    let (is_dynamic, dimension) = (choices.percent(40), is_plane.then_some(sites));
    let helpers = Vec::new();
    Grammar { choices, length: rows, dimension, is_dynamic, has_time: false, letter: "q", helpers, count: 0 }
        .of_sums(3, Grammar::loop_over_sites)
}

/// An index in a loop: its name, and how many places the loop leaves out at the beginning and at the end.
struct Running {
    name: &'static str,
    left_out: [i64; 2],
    /// The number of places, as the text says it.
    number: String,
    farthest: i64,
}

impl Grammar {
    fn loop_over_sites(&mut self) -> String {
        let number = if self.is_dynamic { "q.len()".to_owned() } else { self.length.to_string() };
        let rows = self.running("i", number, if self.dimension.is_some() { FARTHEST_ROW } else { FARTHEST });
        let sites = self.dimension.map(|dimension| self.running("j", dimension.to_string(), FARTHEST));
        let indices: Vec<Running> = [Some(rows), sites].into_iter().flatten().collect();
        let mut body = String::new();
        for _ in 0..1 + self.choices.below(3) {
            body += &self.term(&indices);
        }
        indices.iter().rev().fold(body, |body, Running { name, left_out: [first, last], number, .. }| {
            let to = if *last == 0 { number.clone() } else { format!("{number} - {last}") };
            format!("for {name} in {first}..{to} {{ {body} }} ")
        })
    }

    fn running(&mut self, name: &'static str, number: String, farthest: i64) -> Running {
        let left_out = if self.choices.percent(50) { [0, 0] } else { [self.choices.below(3), self.choices.below(2)] };
        Running { name, left_out: left_out.map(|count| count as i64), number, farthest }
    }

    /// A term of a site or of a bond, where its other end is there.
    fn term(&mut self, indices: &[Running]) -> String {
        let here: String = indices.iter().map(|index| format!("[{}]", index.name)).collect();
        let (mut there, mut guards) = (String::new(), Vec::new());
        for index in indices {
            let (text, guard) = self.neighbour(index);
            there += &format!("[{text}]");
            guards.extend(guard);
        }
        let x = if there == here { format!("q{here}") } else { format!("(q{here} - q{there})") };
        let factor = self.choices.of(&["self.pos", "self.k[i]", "0.5", "self.long[i + 1]"]).to_owned();
        let energy = match self.choices.below(5) {
            0 => format!("{factor} * {x} * {x}"),
            1 => format!("{factor} * {x}.powi(4)"),
            2 => format!("{factor} * {x}.cos()"),
            3 => format!("{factor} * ({x} - {x}.powi(3))"),
            _ => format!("{factor} * (0.3 * {x}).exp()"),
        };
        let (term, guard) = (format!("v += {energy};"), guards.join(" && "));
        let other = format!("v += 0.3 * q{here} * q{here};");
        match self.choices.below(4) {
            _ if guards.is_empty() => term,
            0 => format!("if {guard} {{ {term} }} else {{ {other} }} "),
            1 => format!("v += if {guard} {{ {energy} }} else {{ 0.0 }}; "),
            _ => format!("if {guard} {{ {term} }} "),
        }
    }

    /// The index of a neighbour, with a guard where the loop does not keep it inside.
    fn neighbour(
        &mut self,
        Running { name, left_out: [first, last], number, farthest }: &Running,
    ) -> (String, Option<String>) {
        let by = self.choices.below(2 * *farthest as usize + 1) as i64 - farthest;
        let far = by.abs();
        match by {
            0 => (name.to_string(), None),
            1.. if self.choices.percent(20) => (format!("({name} + {far}) % {number}"), None),
            1.. => {
                let guards = [
                    format!("{name} + {far} < {number}"),
                    format!("{name} < {number} - {far}"),
                    format!("{name} + {far} <= {number} - 1"),
                ];
                (format!("{name} + {far}"), (*last < far).then(|| guards[self.choices.below(guards.len())].clone()))
            }
            _ => {
                let mut guards = vec![format!("{name} >= {far}"), format!("{name} > {}", far - 1)];
                guards.extend((far == 1).then(|| format!("{name} != 0")));
                (format!("{name} - {far}"), (*first < far).then(|| guards[self.choices.below(guards.len())].clone()))
            }
        }
    }
}
