//! Random systems of growing length: a text of twice as many parts is written as at most 2.5 times the code.
//!
//! A part is a few random statements. A system repeats them with other numbers, on the coordinates and variables of the parts
//! before. What is written for them has to grow with the text, in each kind of code that the macro writes.
//! `GROWING_SYSTEMS` asks for more systems, and `GROWING_SYSTEMS_SEED` for others.

#[path = "../random/choice.rs"]
mod choice;
mod grammar;

use choice::seeds;
use grammar::System;
use integrator_symbolic::hamiltonian;
use proc_macro2::{TokenStream, TokenTree};
use std::fmt::Write as _;

/// What the annotation requests, and how many parts the systems have: steppers with their Hessians, recurrences of Taylor's method,
/// derivatives with respect to a parameter, and code for devices, which have room for 64 numbers.
const REQUESTS: [(&str, &[usize]); 4] = [
    ("", &[2, 4, 8, 16, 32]),
    ("taylor", &[2, 4, 8, 16, 32]),
    ("sensitive(strength)", &[2, 4, 8, 16]),
    ("gpu(functions = native)", &[2, 4, 8, 16]),
];

/// A text that is written as more tokens than this is long enough: the next one would take a second.
const LONG: usize = 15_000;

/// Tokens, with those in brackets; text for devices counts by its words.
fn size(code: TokenStream) -> usize {
    let of = |tree| match tree {
        TokenTree::Group(group) => 2 + size(group.stream()),
        TokenTree::Literal(literal) => literal.to_string().split_whitespace().count(),
        _ => 1,
    };
    code.into_iter().map(of).sum()
}

/// How much is written for a text, beside the text; or the errors in it.
fn written(arguments: &str, text: &str) -> Result<usize, String> {
    let item: TokenStream = text.parse().expect("tokens");
    let code = hamiltonian(arguments.parse().expect("tokens"), item.clone());
    let shown = code.to_string();
    match shown.find("compile_error") {
        Some(at) => Err(shown[at..].chars().take(200).collect()),
        None => Ok(size(code) - size(item)),
    }
}

/// What came of many systems.
#[derive(Default)]
struct Tally {
    compared: usize,
    refused: Vec<String>,
    /// The ratio that is largest, and the system.
    largest: (f64, String),
    faults: String,
}

impl Tally {
    /// Compares what is written for texts of growing length.
    fn grow(&mut self, name: &str, arguments: &str, lengths: &[usize], text: impl Fn(usize) -> String) {
        let name = format!("{name} ({arguments})");
        let mut before = None;
        for &length in lengths {
            let size = match written(arguments, &text(length)) {
                Ok(size) => size,
                Err(message) => return self.refused.push(format!("{name}: {message}")),
            };
            let ratio = before.map_or(0.0, |before| size as f64 / before as f64);
            if ratio > self.largest.0 {
                self.largest = (ratio, name.clone());
            }
            if ratio > 2.5 {
                let _ = writeln!(self.faults, "{name}: {before:?} tokens, then {size}\n{}", text(2));
                break;
            }
            if before.is_some() && size > LONG {
                break;
            }
            before = Some(size);
        }
        self.compared += 1;
    }

    fn assert_without_faults(&self) {
        let (ratio, name) = &self.largest;
        println!(
            "{} compared; the largest ratio is {ratio:.2}, of {name}; refused: {:#?}",
            self.compared, self.refused
        );
        assert!(self.faults.is_empty(), "{}", self.faults);
        assert!(self.refused.len() * 4 < self.compared, "{} of {} were refused", self.refused.len(), self.compared);
    }
}

#[test]
fn twice_the_parts_are_at_most_two_and_a_half_times_the_code() {
    let mut tally = Tally::default();
    for seed in seeds(["GROWING_SYSTEMS_SEED", "GROWING_SYSTEMS"], 3) {
        let system = System::drawn(seed);
        for (arguments, lengths) in REQUESTS {
            tally.grow(&format!("system {seed}"), arguments, lengths, |parts| system.of_parts(parts));
        }
    }
    tally.assert_without_faults();
}

/// Code for devices is left out: it has no sums over pairs of more than eight bodies.
#[test]
fn twice_the_bodies_are_at_most_two_and_a_half_times_the_code() {
    let mut tally = Tally::default();
    for seed in 1..3 {
        for (arguments, lengths) in &REQUESTS[..3] {
            tally.grow(&format!("bodies {seed}"), arguments, lengths, |bodies| grammar::bodies(seed, bodies));
        }
    }
    tally.assert_without_faults();
}
