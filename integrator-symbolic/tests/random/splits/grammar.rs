//! Random Hamiltonians in named parts, each with the flow that it should have, and those that just miss one.

use crate::{choice::Choices, judge::Case, value::Value};
use std::rc::Rc;

/// The exact flow that a part has.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) enum Flow {
    Momenta,
    Positions,
    Quadratic,
    Kepler,
    Shear,
    Shifted,
}

pub(crate) const FLOWS: [Flow; 6] =
    [Flow::Momenta, Flow::Positions, Flow::Quadratic, Flow::Kepler, Flow::Shear, Flow::Shifted];

/// A system in parts.
pub(crate) struct Split {
    /// The parts in their order.
    pub(crate) parts: Vec<&'static str>,
    pub(crate) item: String,
    pub(crate) case: Case,
}

/// How many fields there are in lists: one for each body at least.
const BODIES: usize = 6;

struct Writer {
    choices: Choices,
    /// Degrees of freedom, or bodies.
    count: usize,
    /// Coordinates of a body; none for a list of numbers.
    dimension: Option<usize>,
}

/// The system of a seed, whose part `a` has this flow; or has none, where it `misses` it by one term.
pub(crate) fn split(seed: u64, flow: Flow, misses: bool) -> Split {
    let mut writer = Writer { choices: Choices::new(seed), count: 0, dimension: None };
    let choices = &mut writer.choices;
    if flow == Flow::Kepler {
        writer.dimension = Some(2 + choices.below(2));
        writer.count = 1 + choices.below(5);
    } else {
        writer.count = 2 + choices.below(5);
    }
    let (mut terms, rest) = match flow {
        Flow::Momenta => (writer.one_half("p"), writer.one_half("q")),
        Flow::Positions => (writer.one_half("q"), writer.one_half("p")),
        Flow::Quadratic => writer.quadratic(misses),
        Flow::Kepler => writer.kepler(misses),
        Flow::Shear => writer.shear(misses),
        Flow::Shifted => writer.shifted(misses),
    };
    if misses && matches!(flow, Flow::Momenta | Flow::Positions) {
        let i = writer.degree();
        terms.push(format!("(0.3 * q[{i}] * p[{i}]).sin()"));
    }
    writer.written(&terms, &rest)
}

impl Writer {
    fn degree(&mut self) -> usize {
        self.choices.below(self.count)
    }

    fn coefficient(&mut self) -> &'static str {
        self.choices.of(&[
            "1.25",
            "0.4",
            "3.0",
            "self.a",
            "self.b",
            "self.c",
            "self.a * self.b",
            "self.a / self.b",
            "self.a.sqrt()",
            "(1.0 + self.c)",
            "self.b.cos()",
            "self.m[1]",
            "1.0 / self.m[0]",
            "self.a.powi(2)",
        ])
    }

    fn written(mut self, terms: &[String], rest: &[String]) -> Split {
        let shape = match self.dimension {
            Some(dimension) => format!("[[f64; {dimension}]; {}]", self.count),
            None => format!("[f64; {}]", self.count),
        };
        let spins = self.dimension.is_none() && self.choices.percent(40);
        let mut parts = if self.choices.percent(50) { vec!["a", "rest"] } else { vec!["rest", "a"] };
        if spins {
            parts.insert(self.choices.below(3), "spin");
        }
        let function = |name: &str, body: &str| {
            let arguments = ["q", "p"]
                .into_iter()
                .filter(|half| body.contains(&format!("{half}[")) || body.contains(&format!("{half}.iter")));
            let arguments: String = arguments.map(|half| format!(", {half}: {shape}")).collect();
            format!("fn {name}(&self{arguments}) -> f64 {{ {body} }}\n")
        };
        let mut item = function("a", &terms.join(" + ")) + &function("rest", &rest.join(" + "));
        if spins {
            item += &function("spin", "self.w * (q[0] * p[1] - q[1] * p[0])");
        }
        let item = format!("impl System {{ {item} fn square(&self, x: f64) -> f64 {{ x * x }} }}");
        Split { parts, item, case: self.case() }
    }

    fn case(&mut self) -> Case {
        let choices = &mut self.choices;
        let mut number = || Value::plain(choices.between(0.3, 2.0));
        let numbers = ["a", "b", "c", "k", "w"].map(|name| (name.to_owned(), number()));
        let lists = ["m", "mu"].map(|name| (name.to_owned(), Value::list([(); BODIES].map(|()| number()))));
        let fields = Value::Struct(Rc::new(numbers.into_iter().chain(lists).collect()));
        let mut point = || (0..self.dimension.unwrap_or(1)).map(|_| choices.between(0.2, 1.2)).collect();
        let state = [(); 2].map(|()| (0..self.count).map(|_| point()).collect());
        Case { fields, state, is_flat: self.dimension.is_none(), time: 0.0 }
    }

    /// Terms in one half of the coordinates.
    fn one_half(&mut self, half: &str) -> Vec<String> {
        let count = 1 + self.choices.below(3);
        let term = |writer: &mut Self| {
            let ([i, j], c) = ([(); 2].map(|()| writer.degree()), writer.coefficient());
            let function = writer.choices.of(&["cosh()", "sin()", "powi(4)", "powi(2)", "exp()"]);
            match writer.choices.below(3) {
                0 => format!("{c} * {half}[{i}].{function}"),
                1 => format!("(1.0 + {half}[{i}].powi(2) + {c} * {half}[{j}].powi(2)).sqrt()"),
                _ => format!("{half}.iter().map(|x| {c} * x.{function}).sum::<f64>()"),
            }
        };
        (0..count).map(|_| term(self)).collect()
    }

    /// A linear form in some coordinates of both halves.
    fn linear(&mut self) -> String {
        let count = 1 + self.choices.below(4);
        let term = |writer: &mut Self| {
            let (half, i, c) = (writer.choices.of(&["q", "p"]), writer.degree(), writer.coefficient());
            match writer.choices.below(4) {
                0 => format!("{half}[{i}]"),
                1 => format!("{c} * {half}[{i}]"),
                2 => format!("{half}[{i}] / ({c})"),
                _ => format!("-{half}[{i}]"),
            }
        };
        let terms: Vec<_> = (0..count).map(|_| term(self)).collect();
        format!("({})", terms.join(" + "))
    }

    fn quadratic(&mut self, misses: bool) -> (Vec<String>, Vec<String>) {
        let n = self.count;
        let product = |writer: &mut Self| {
            let (a, b, c) = (writer.linear(), writer.linear(), writer.coefficient());
            match writer.choices.below(7) {
                0 => format!("{c} * {a} * {b}"),
                1 => format!("{a}.powi(2)"),
                2 => format!("({c} * {b}) * {a} / 2.0"),
                3 => format!("{{ let u = {a}; let v = {b}; u * v - {c} * v * v }}"),
                4 => format!("self.square({a})"),
                5 => format!("({a} + {b}).powi(2) - {a} * {b}"),
                _ => format!("{a} * {a}"),
            }
        };
        let count = 1 + self.choices.below(3);
        let mut terms: Vec<_> = (0..count).map(|_| format!("({})", product(self))).collect();
        // Both of a pair for certain, so that no term that is added makes a shear of it.
        let (i, j, c) = (self.degree(), self.degree(), self.coefficient());
        terms.push(format!("0.5 * (p[{i}] * p[{i}] + 7.3 * q[{i}] * q[{i}])"));
        let sum = self.choices.below(7);
        terms.extend(match sum {
            0 => Some(format!("(1..{n}).map(|j| {c} * (q[j] - q[j - 1]).powi(2)).sum::<f64>()")),
            1 => Some(format!("q.iter().zip(p.iter()).map(|(x, y)| {c} * x * y).sum::<f64>()")),
            2 => Some(format!(
                "{{ let mut e = 0.0; for i in 0..{n} {{ for j in 0..{n} {{ e += {c} * q[i] * p[j]; }} }} e }}"
            )),
            3 => Some(format!("{{ let s: f64 = (0..{n}).map(|j| {c} * (q[j] - p[j])).sum(); s * s }}")),
            4 => Some(format!(
                "{{ let s: f64 = q.iter().sum(); (0..{n}).map(|j| (q[j] - {c} * s + self.m[j] * p[j]).powi(2)).sum::<f64>() }}"
            )),
            _ => None,
        });
        if misses {
            let more = [
                format!("0.1 * q[{i}] * q[{i}] * p[{i}]"),
                format!("self.a * p[{i}].powi(4) + q[{i}].powi(4)"),
                format!("q[{i}].sin()"),
                format!("(0.3 * p[{i}] + q[{j}]).powi(3)"),
                format!("(1.0 + p[{i}] * p[{i}]).sqrt()"),
                format!("q[{i}].abs()"),
                format!("(0..{n}).map(|j| q[j].powi(3)).sum::<f64>()"),
            ];
            terms.push(more[self.choices.below(more.len())].clone());
        }
        (terms, vec![format!("{c} * q[{i}].powi(3)"), format!("(q[{j}] * {c}).sin()")])
    }

    /// Bodies about a centre each; one of them misses that.
    fn kepler(&mut self, misses: bool) -> (Vec<String>, Vec<String>) {
        let n = self.count;
        let strength =
            self.choices.of(&["self.k", "self.k * self.m[@]", "self.a * self.b * self.m[@]", "self.mu[@]", "1.0"]);
        let miss = misses.then(|| self.choices.below(6));
        let loops = !misses && self.choices.percent(50);
        let terms = if loops {
            vec![format!("(0..{n}).map(|i| {}).sum::<f64>()", self.body("i", &strength.replace('@', "i"), None))]
        } else {
            let bad = self.degree();
            let body = |b: usize| {
                let miss = miss.filter(|_| b == bad);
                format!("({})", self.body(&b.to_string(), &strength.replace('@', &b.to_string()), miss))
            };
            (0..n).map(body).collect()
        };
        (terms, vec![format!("{} * q[{}][0] * q[0][1]", self.coefficient(), n - 1)])
    }

    fn body(&mut self, b: &str, strength: &str, miss: Option<usize>) -> String {
        let dimension = self.dimension.unwrap_or(1);
        let squares = |half: &str, first: &str, count: usize| {
            let squares =
                (0..count).map(|d| format!("{}{half}[{b}][{d}] * {half}[{b}][{d}]", if d == 0 { first } else { "" }));
            format!("({})", squares.collect::<Vec<_>>().join(" + "))
        };
        let p = squares("p", if miss == Some(0) { "1.5 * " } else { "" }, dimension);
        let mut q = squares("q", if miss == Some(1) { "1.5 * " } else { "" }, dimension - usize::from(miss == Some(2)));
        if miss == Some(3) {
            q = format!("({q} + 0.01)");
        }
        let kinetic = match self.choices.below(4) {
            0 => format!("{p} / (2.0 * self.m[{b}])"),
            1 => format!("0.5 * {p} / self.m[{b}]"),
            2 => format!("(0.5 / self.m[{b}]) * {p}"),
            _ => format!("p[{b}].iter().map(|x| x * x).sum::<f64>() / self.m[{b}] / 2.0"),
        };
        // What misses by its masses is written out.
        let kinetic = if miss == Some(0) { format!("{p} / (2.0 * self.m[{b}])") } else { kinetic };
        let potential = match (miss, self.choices.below(5)) {
            (Some(4), _) => format!("{strength} * {q}.powf(-0.6)"),
            (_, 0) => format!("{strength} / {q}.sqrt()"),
            (_, 1) => format!("{strength} * {q}.powf(-0.5)"),
            (_, 2) => format!("{strength} * {q}.sqrt().recip()"),
            (_, 3) => format!("{strength} / {q}.powf(0.5)"),
            _ => format!("{strength} * (1.0 / {q}.sqrt())"),
        };
        let more = if miss == Some(5) { format!(" + 0.1 * q[{b}][0] * p[{b}][1]") } else { String::new() };
        format!("{kinetic} - {potential}{more}")
    }

    /// Linear in the momenta of some degrees of freedom, with coefficients of the others' positions.
    fn shear(&mut self, misses: bool) -> (Vec<String>, Vec<String>) {
        let moved = 1 + self.choices.below(self.count - 1);
        let count = 1 + self.choices.below(4);
        let term = |writer: &mut Self| {
            let read = writer.count - moved;
            let ([x, y], c) = ([(); 2].map(|()| moved + writer.choices.below(read)), writer.coefficient());
            let coefficient = match writer.choices.below(4) {
                0 => format!("q[{x}].sin()"),
                1 => format!("(q[{x}] * q[{x}] + q[{y}] * q[{y}]).sqrt()"),
                2 => format!("(self.a * q[{x}]).exp() * q[{y}]"),
                _ => format!("1.0 / (1.0 + q[{x}] * q[{x}])"),
            };
            format!("p[{}] * {c} * {coefficient}", writer.choices.below(moved))
        };
        let mut terms: Vec<_> = (0..count).map(|_| term(self)).collect();
        terms.push(format!("p[0] * q[{moved}].cos()"));
        if misses {
            let more = [format!("p[0] * q[0].powi(2) * {}", self.coefficient()), format!("(p[{moved}] * q[0]).sin()")];
            terms.push(more[self.choices.below(2)].clone());
        }
        (terms, vec!["q[0].powi(2)".to_owned()])
    }

    /// A function of one kinetic momentum and of positions that do not move.
    fn shifted(&mut self, misses: bool) -> (Vec<String>, Vec<String>) {
        let i = self.degree();
        let j = (i + 1 + self.choices.below(self.count - 1)) % self.count;
        let term = |writer: &mut Self| {
            let c = writer.coefficient();
            match writer.choices.below(7) {
                0 => format!("{c} * q[{i}].powi(3) / (1.0 + q[{j}] * q[{j}])"),
                1 => format!("(self.a * q[{i}] + q[{j}]).sin() * {c}"),
                2 => format!("{c} * (q[{j}] - q[{i}] / {c}).cos()"),
                3 => format!("q[{j}].sin() * (0.3 * q[{i}]).exp()"),
                4 => format!("q[{i}] * (q[{j}] + {c} * q[{i}])"),
                5 => format!("self.square({c} + q[{i}]) * q[{j}]"),
                _ => format!("{c} * q[{j}].sqrt()"),
            }
        };
        let count = 1 + self.choices.below(3);
        let mut potential: Vec<_> = (0..count).map(|_| term(self)).collect();
        // For certain, so that no term that is added makes a shear or a quadratic form of it.
        potential.push(format!("0.2 * q[{i}] * q[{i}] * q[{j}]"));
        let miss = misses.then(|| self.choices.below(4));
        if miss == Some(0) {
            potential.push(format!("q[{i}].tanh()"));
        }
        let (potential, c) = (potential.join(" + "), self.coefficient());
        let kinetic = match self.choices.below(3) {
            0 => format!("p[{i}] - ({potential})"),
            1 => format!("{potential} - p[{i}]"),
            _ => format!("p[{i}] / 2.0 - ({potential}) + q[{j}]"),
        };
        let of = match self.choices.below(4) {
            0 => format!("u * u / (2.0 * {c})"),
            1 => format!("(0.3 * u).cosh() * (1.0 + q[{j}] * q[{j}])"),
            2 => format!("(1.0 + u.powi(2)).sqrt() + {c} * q[{j}].powi(4)"),
            _ => format!("{c} * self.square(u) + u * q[{j}].cos()"),
        };
        let mut terms = vec![format!("({{ let u = {kinetic}; {of} }})")];
        terms.extend(match miss {
            Some(1) => Some(format!("q[{i}].sin()")),
            Some(2) => Some(format!("p[{j}].powi(2)")),
            Some(3) => Some(format!("p[{i}].cosh()")),
            _ => None,
        });
        (terms, vec![format!("{c} * q[{i}].powi(3)")])
    }
}
