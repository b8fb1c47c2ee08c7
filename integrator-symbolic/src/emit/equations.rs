//! Formulas for people: the equations of motion in the documentation of what is generated.

use crate::{
    differentiate::Contribution,
    graph::{
        Element, Node, NodeId, Part,
        index::{Index, IndexId, LoopId},
    },
    model::Model,
};
use proc_macro2::TokenStream;
use quote::quote;

/// How tightly a formula holds together.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Tie {
    Sum,
    Product,
    Power,
}

/// Writes formulas over the nodes of a model.
pub(super) struct Formulas<'m>(pub(super) &'m Model);

impl Formulas<'_> {
    /// `dq[i]/dt = ...` for every contribution of a gradient; `negative` for forces.
    pub(super) fn motion(&self, gradient: &[Contribution], negative: bool) -> Vec<String> {
        let mut lines: Vec<(String, Vec<String>)> = Vec::new();
        for Contribution { context, element, value } in gradient {
            let (left, own) = self.left(*element);
            let outside: Vec<LoopId> = context.iter().copied().filter(|by| !own.contains(by)).collect();
            let term = self.summed(&outside, self.formula(*value, Tie::Sum));
            match lines.iter_mut().find(|(known, _)| *known == left) {
                Some((_, terms)) => terms.push(term),
                None => lines.push((left, vec![term])),
            }
        }
        lines
            .into_iter()
            .map(|(left, terms)| {
                let right = terms.join(" + ").replace("+ -", "- ");
                match (negative, right.strip_prefix('-')) {
                    (false, _) => format!("{left} = {right}"),
                    (true, Some(flipped)) if terms.len() == 1 && !is_sum(flipped) => format!("{left} = {flipped}"),
                    (true, _) if terms.len() == 1 && !is_sum(&right) => format!("{left} = -{right}"),
                    (true, _) => format!("{left} = -({right})"),
                }
            })
            .collect()
    }

    /// The left side of the equation that a component of a gradient belongs to, and the loops that it names.
    fn left(&self, element: Element) -> (String, Vec<LoopId>) {
        let moved = match element.part {
            Part::Momentum => Part::Position,
            Part::Position => Part::Momentum,
        };
        let loops = self.0.graph.loops.of_element(element).iter().collect();
        (format!("d{}/dt", self.coordinate(Element { part: moved, ..element })), loops)
    }

    fn summed(&self, loops: &[LoopId], term: String) -> String {
        loops.iter().rev().fold(term, |inner, by| format!("{} ({inner})", self.sigma(*by)))
    }

    fn sigma(&self, by: LoopId) -> String {
        let range = self.0.graph.loops.get(by);
        let name = self.0.running.get(&by).map_or_else(String::new, ToString::to_string);
        format!("Σ_{{{name} in {}..{}}}", self.index(range.from), self.index(range.to))
    }

    fn coordinate(&self, element: Element) -> String {
        let letter = match element.part {
            Part::Position => "q",
            Part::Momentum => "p",
        };
        let component = element.component.map(|component| format!("[{}]", self.index(component))).unwrap_or_default();
        format!("{letter}[{}]{component}", self.index(element.index))
    }

    fn index(&self, id: IndexId) -> String {
        let binary = |a, sign, b| format!("({} {sign} {})", self.index(a), self.index(b));
        match self.0.graph.loops.index(id) {
            Index::Literal(value) => value.to_string(),
            Index::Running(by) => self.0.running.get(&by).map_or_else(String::new, ToString::to_string),
            Index::Parameter(parameter) => self.text(parameter.0),
            Index::Add(a, b) => binary(a, '+', b),
            Index::Sub(a, b) => binary(a, '-', b),
            Index::Mul(a, b) => binary(a, '*', b),
            Index::Div(a, b) => binary(a, '/', b),
            Index::Rem(a, b) => binary(a, '%', b),
        }
    }

    /// A parameter as the user wrote it, without the spaces of tokens and without `self`.
    fn text(&self, parameter: u32) -> String {
        readable(&self.0.parameters[parameter as usize].text)
    }

    /// A node as a formula that holds together at least as tightly as `needed`.
    fn formula(&self, id: NodeId, needed: Tie) -> String {
        let (text, tie) = self.tied(id);
        if tie >= needed { text } else { format!("({text})") }
    }

    fn tied(&self, id: NodeId) -> (String, Tie) {
        match self.0.graph.node(id) {
            Node::Constant(bits) => (f64::from_bits(bits).to_string(), Tie::Power),
            Node::Parameter(parameter) => {
                let text = self.text(parameter.0);
                let whole = text.chars().all(|letter| letter.is_alphanumeric() || "_.:[]()".contains(letter));
                (text, if whole { Tie::Power } else { Tie::Sum })
            }
            Node::Coordinate(element) => (self.coordinate(element), Tie::Power),
            Node::Time => ("t".to_owned(), Tie::Power),
            Node::Step => ("h".to_owned(), Tie::Power),
            Node::FromIndex(index) => (self.index(index), Tie::Power),
            Node::Neg(a) => (format!("-{}", self.formula(a, Tie::Product)), Tie::Sum),
            Node::Add(a, b) => {
                let left = self.formula(a, Tie::Sum);
                let text = match self.0.graph.node(b) {
                    Node::Neg(b) => format!("{left} - {}", self.formula(b, Tie::Product)),
                    _ => format!("{left} + {}", self.formula(b, Tie::Sum)),
                };
                (text, Tie::Sum)
            }
            Node::Mul(a, b) => match self.0.graph.node(b) {
                Node::Power(base, -2) => {
                    (format!("{} / {}", self.formula(a, Tie::Product), self.formula(base, Tie::Power)), Tie::Product)
                }
                _ => (format!("{} {}", self.formula(a, Tie::Product), self.formula(b, Tie::Power)), Tie::Product),
            },
            Node::Div(a, b) => {
                (format!("{} / {}", self.formula(a, Tie::Product), self.formula(b, Tie::Power)), Tie::Product)
            }
            Node::Power(a, 1) => (format!("sqrt({})", self.formula(a, Tie::Sum)), Tie::Power),
            Node::Power(a, -2) => (format!("1 / {}", self.formula(a, Tie::Power)), Tie::Product),
            Node::Power(a, halves) if halves % 2 == 0 => {
                (format!("{}^{}", self.formula(a, Tie::Power), halves / 2), Tie::Power)
            }
            Node::Power(a, halves) => (format!("{}^({halves}/2)", self.formula(a, Tie::Power)), Tie::Power),
            Node::Unary(function, a) => (format!("{}({})", function.name(), self.formula(a, Tie::Sum)), Tie::Power),
            Node::Binary(function, a, b) => {
                let (a, b) = (self.formula(a, Tie::Sum), self.formula(b, Tie::Sum));
                (format!("{}({a}, {b})", function.name()), Tie::Power)
            }
            Node::Sum(by, body) => (format!("{} {}", self.sigma(by), self.formula(body, Tie::Product)), Tie::Product),
        }
    }

    /// The summands of a node that are not polynomials of degree two at most in the momenta.
    pub(super) fn not_quadratic(&self, id: NodeId) -> String {
        match self.0.graph.node(id) {
            Node::Add(a, b) => {
                let offends = |id| self.0.graph.degree(id, Part::Momentum).is_none_or(|degree| degree > 2);
                self.not_quadratic(if offends(a) { a } else { b })
            }
            _ => self.formula(id, Tie::Sum),
        }
    }
}

/// Whether a formula has a sum outside of all parentheses.
fn is_sum(text: &str) -> bool {
    let mut depth = 0;
    text.char_indices().any(|(at, letter)| {
        match letter {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth -= 1,
            _ => {}
        }
        depth == 0 && (text[at..].starts_with(" + ") || text[at..].starts_with(" - "))
    })
}

/// Tokens without the spaces between them, and without `self.`.
fn readable(text: &TokenStream) -> String {
    let mut text = text.to_string().replace("self .", "").replace("self.", "");
    for (spaced, tight) in [(" . ", "."), (" :: ", "::"), (" [", "["), (" (", "("), ("( ", "("), (" )", ")"), (" ,", ",")] {
        text = text.replace(spaced, tight);
    }
    for operator in ["+", "-", "*", "/"] {
        text = text.replace(&format!("{operator}("), &format!("{operator} ("));
    }
    text.trim().to_owned()
}

/// The doc comment of a prepared constant: its formula.
pub(super) fn documentation(model: &Model, id: Option<NodeId>) -> TokenStream {
    let Some(id) = id else { return TokenStream::new() };
    let text = format!(" `{}`", Formulas(model).formula(id, Tie::Sum));
    quote!(#[doc = #text])
}
