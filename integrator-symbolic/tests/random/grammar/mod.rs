//! Random systems: Rust text over the language of H, and the parameters and states at which it is looked at.

mod chain;
mod expression;
mod lattice;
mod pairs;
mod statement;
mod triplets;
mod units;

use crate::{
    choice::Choices,
    judge::{Case, System},
    value::{Integer, IntegerType, Value},
};
pub(crate) use lattice::lattice;
pub(crate) use pairs::pairs;
use std::rc::Rc;
pub(crate) use triplets::triplets;
pub(crate) use units::{lattice_in_units, pairs_in_units, system_in_units};

/// Parts of the language that are written or left out.
pub(crate) struct Parts {
    /// What is there only where a condition holds.
    pub(crate) guards: bool,
    /// Integers that may be below zero, or wrap.
    integers: bool,
    /// Ranges and iterators that may end before they begin, or before what they are made of.
    bounds: bool,
}

pub(crate) const PARTS: Parts = Parts { guards: true, integers: true, bounds: true };

/// What a text in the making may name.
#[derive(Clone, Default)]
struct Scope {
    /// Expressions that are numbers.
    numbers: Vec<String>,
    /// Expressions that are indices of coordinates.
    indices: Vec<String>,
    /// Those of them that bounds of loops may depend on.
    bounds: Vec<String>,
    /// Indices of anything, and integers of another type.
    integers: Vec<String>,
    /// Arrays of so many numbers.
    arrays: Vec<(String, usize)>,
    /// Whether there are coordinates to name.
    has_coordinates: bool,
    /// Whether helpers may be called.
    has_helpers: bool,
    /// How many loops are around.
    loops: usize,
}

/// A method that the functions of H call, with the kind of its arguments.
struct Helper {
    name: String,
    signature: Signature,
}

#[derive(Clone, Copy)]
enum Signature {
    Numbers(usize),
    Array,
    Pair,
    Index,
}

/// What makes one system.
struct Grammar {
    choices: Choices,
    /// How many points there are, or in the first case where a start tells.
    length: usize,
    dimension: Option<usize>,
    is_dynamic: bool,
    has_time: bool,
    /// The argument of the function being written.
    letter: &'static str,
    helpers: Vec<Helper>,
    count: usize,
}

/// The system of a seed.
pub(crate) fn system(seed: u64) -> System {
    of_length(seed, true)
}

/// That of a seed whose coordinates are arrays.
pub(crate) fn fixed_system(seed: u64) -> System {
    of_length(seed, false)
}

fn of_length(seed: u64, may_be_dynamic: bool) -> System {
    let mut choices = Choices::new(seed);
    let length = 1 + choices.below(5);
    let dimension = choices.percent(30).then(|| 1 + choices.below(3));
    let (is_dynamic, has_time) = (choices.percent(40) && may_be_dynamic, choices.percent(15));
    let helpers = Vec::new();
    Grammar { choices, length, dimension, is_dynamic, has_time, letter: "q", helpers, count: 0 }.system()
}

impl Grammar {
    fn fresh(&mut self, what: &str) -> String {
        self.count += 1;
        format!("{what}{}", self.count)
    }

    fn system(mut self) -> System {
        let mut methods = String::new();
        for _ in 0..self.choices.below(3) {
            methods += &self.helper();
        }
        let by_reference = self.choices.percent(50);
        let element = self.dimension.map_or("f64".to_owned(), |dimension| format!("[f64; {dimension}]"));
        let coordinates = match (self.is_dynamic, by_reference) {
            (true, _) => format!("&[{element}]"),
            (false, true) => format!("&[{element}; {}]", self.length),
            (false, false) => format!("[{element}; {}]", self.length),
        };
        let potential = self.function();
        self.letter = "p";
        let kinetic = if self.choices.percent(60) { self.quadratic() } else { self.function() };
        let time = if self.has_time { ", t: f64" } else { "" };
        let item = format!(
            "impl System {{
                fn kinetic(&self, p: {coordinates}) -> f64 {{ {kinetic} }}
                fn potential(&self, q: {coordinates}{time}) -> f64 {{ {potential} }}
                {methods}
            }}"
        );
        let cases = (0..2).map(|number| self.case(number)).collect();
        System { item: item.parse().unwrap_or_else(|error| panic!("{error}: {item}")), cases }
    }

    /// A system whose potential is one of these sums, or a few.
    fn of_sums(mut self, most: usize, sum: impl Fn(&mut Self) -> String) -> System {
        let element = self.dimension.map_or("f64".to_owned(), |dimension| format!("[f64; {dimension}]"));
        let coordinates =
            if self.is_dynamic { format!("&[{element}]") } else { format!("[{element}; {}]", self.length) };
        let mut potential = String::new();
        for _ in 0..1 + self.choices.below(most) {
            potential += &sum(&mut self);
        }
        self.letter = "p";
        let kinetic = self.quadratic();
        let item = format!(
            "impl System {{
                fn kinetic(&self, p: {coordinates}) -> f64 {{ {kinetic} }}
                fn potential(&self, q: {coordinates}) -> f64 {{ let mut v = 0.0; {potential} v }}
            }}"
        );
        let cases = (0..2).map(|number| self.case(number)).collect();
        System { item: item.parse().unwrap_or_else(|error| panic!("{error}: {item}")), cases }
    }

    /// The usual kinetic energy.
    fn quadratic(&mut self) -> String {
        let number = |x: &str, mass: &str| format!("{x} * {x} / {mass}");
        match (self.dimension, self.choices.below(3)) {
            (None, 0) => format!("p.iter().map(|x| {}).sum::<f64>()", number("x", "2.0")),
            (None, 1) => format!("p.iter().zip(&self.k).map(|(x, m)| {}).sum::<f64>()", number("x", "(m * m + 1.0)")),
            (None, _) => format!("let mut v = 0.0; for i in 0..p.len() {{ v += {}; }} v", number("p[i]", "self.pos")),
            (Some(d), _) => {
                format!(
                    "let mut v = 0.0; for i in 0..p.len() {{ for d in 0..{d} {{ v += {}; }} }} v",
                    number("p[i][d]", "self.pos")
                )
            }
        }
    }

    /// The body of a part of H.
    fn function(&mut self) -> String {
        let mut scope = Scope { has_coordinates: true, has_helpers: true, ..Scope::default() };
        if self.has_time && self.letter == "q" {
            scope.numbers.push("t".into());
        }
        let mut text = String::new();
        for _ in 0..self.choices.below(4) {
            text += &self.statement(&mut scope, 2);
        }
        let depth = 1 + self.choices.below(3);
        let mut energy = self.number(&scope, depth);
        let lets: Vec<String> = scope.numbers.iter().filter(|name| name.starts_with(['v', 'z'])).cloned().collect();
        for name in lets {
            energy += &format!(" + {name}");
        }
        text + &energy
    }

    fn helper(&mut self) -> String {
        let name = self.fresh("helper");
        let signature = match self.choices.below(6) {
            0 => Signature::Array,
            1 => Signature::Pair,
            2 => Signature::Index,
            count => Signature::Numbers(1 + count % 2),
        };
        let mut scope = Scope { has_helpers: true, ..Scope::default() };
        let (arguments, result) = match signature {
            Signature::Numbers(count) => {
                let names = &["x", "y"][..count];
                scope.numbers.extend(names.iter().map(ToString::to_string));
                (format!("&self, {}", names.map_typed()), "f64")
            }
            Signature::Array => {
                scope.numbers.extend(["x".into(), "y".into()]);
                ("&self, [x, y]: [f64; 2]".to_owned(), "f64")
            }
            Signature::Pair => {
                scope.numbers.push("x".into());
                ("&self, x: f64".to_owned(), "(f64, f64)")
            }
            Signature::Index => {
                scope.integers.push("i".into());
                scope.numbers.push("self.long[i]".into());
                ("&self, i: usize".to_owned(), "f64")
            }
        };
        let mut body = String::new();
        for _ in 0..self.choices.below(2) {
            body += &self.statement(&mut scope, 1);
        }
        let first = self.number(&scope, 2);
        let value = match signature {
            Signature::Pair => format!("({first}, {})", self.number(&scope, 1)),
            _ => first,
        };
        self.helpers.push(Helper { name: name.clone(), signature });
        format!("fn {name}({arguments}) -> {result} {{ {body} {value} }}\n")
    }

    /// Parameters and a state; where a start tells the length, the second case has another one.
    fn case(&mut self, number: usize) -> Case {
        let length = match number {
            0 => self.length,
            _ if self.is_dynamic && PARTS.bounds => self.choices.below(self.length + 3),
            _ if self.is_dynamic => self.length + self.choices.below(3),
            _ => self.length,
        };
        let choices = &mut self.choices;
        let mut list = |count: usize| Value::list((0..count).map(|_| Value::plain(choices.between(-2.0, 2.0))));
        let (k, long, rows) = (list(length), list(length + 2), (0..length).map(|_| list(length)).collect::<Vec<_>>());
        let short_length = self.choices.below(length + 1);
        let choices = &mut self.choices;
        let short = Value::list((0..short_length).map(|_| Value::plain(choices.between(-2.0, 2.0))));
        let mut place = || Value::size(choices.below(length));
        let index = Value::list((0..length).map(|_| place()));
        let count = if length == 0 { 0 } else { 3 };
        let bonds = Value::list((0..count).map(|_| Value::tuple([place(), place()])));
        let springs = Value::list((0..count).map(|_| Value::tuple([place(), place(), Value::plain(0.75)])));
        let int = |value, of| Value::Integer(Integer { value, of: IntegerType::named(of) });
        let kinds = Value::list((0..length).map(|_| int(choices.below(5) as i128 - 2, "i32")));
        let bytes = Value::list((0..length).map(|_| int(choices.below(4) as i128, "u8")));
        let numbers = ["a", "b", "c"].map(|name| (name, Value::plain(choices.between(-2.0, 2.0))));
        let optional = choices.percent(50).then(|| Rc::new(Value::plain(1.25)));
        let others = [
            ("pos", Value::plain(choices.between(0.3, 3.0))),
            ("k", k),
            ("long", long),
            ("short", short),
            ("empty", Value::list([])),
            ("rows", Value::list(rows)),
            ("index", index),
            ("bonds", bonds),
            ("springs", springs),
            ("flag", Value::Bool(choices.percent(50))),
            ("power", int(choices.below(7) as i128 - 2, "i32")),
            ("kinds", kinds),
            ("bytes", bytes),
            ("kmax", int(choices.below(3) as i128, "i32")),
            ("lmax", int(choices.below(3) as i128 + 1, "u8")),
            ("n", int(choices.below(length + 1) as i128, "usize")),
            ("optional", Value::Option(optional)),
        ];
        let fields = numbers.into_iter().chain(others).map(|(name, value)| (name.to_owned(), value)).collect();
        let dimension = self.dimension.unwrap_or(1);
        let mut coordinate = || if choices.percent(3) { 0.0 } else { choices.between(-1.5, 1.5) };
        let state = [(); 2].map(|()| (0..length).map(|_| (0..dimension).map(|_| coordinate()).collect()).collect());
        let is_flat = self.dimension.is_none();
        Case { fields: Value::Struct(Rc::new(fields)), state, is_flat, time: choices.between(-2.0, 2.0) }
    }
}

/// Names as arguments that are numbers.
trait Typed {
    fn map_typed(&self) -> String;
}

impl Typed for [&str] {
    fn map_typed(&self) -> String {
        self.iter().map(|name| format!("{name}: f64")).collect::<Vec<_>>().join(", ")
    }
}
