//! Formulas for people: the equations of motion in the documentation of what is generated.

use super::is_direct;
use crate::{
    differentiate::{Contribution, folded},
    graph::{
        Comparison, Element, Node, NodeId, Part,
        index::{Index, IndexId, LoopId, LoopSet},
    },
    model::Model,
};
use proc_macro2::TokenStream;
use quote::quote;
use std::collections::HashMap;

/// The equations of motion, one line each.
pub(crate) fn equations(model: &mut Model, kinetic: &[Contribution], potential: &[Contribution]) -> Vec<String> {
    let [kinetic, potential] = [kinetic, potential].map(|gradient| folded(&mut model.graph, gradient));
    let (drift, kick) = (is_direct(model, &kinetic), is_direct(model, &potential));
    let formulas = Formulas(model);
    formulas.motion(&kinetic, false, drift).into_iter().chain(formulas.motion(&potential, true, kick)).collect()
}

/// Loops as `i in 0..n`.
pub(crate) fn ranges(model: &Model, loops: LoopSet) -> Vec<String> {
    loops.iter().map(|by| Formulas(model).range(by)).collect()
}

/// The equations of motion as the documentation of the implementation.
pub(super) fn documented_motion(
    model: &mut Model,
    kinetic: &[Contribution],
    potential: &[Contribution],
) -> TokenStream {
    let lines: Vec<String> = equations(model, kinetic, potential).iter().map(|line| format!(" {line}")).collect();
    let class = if model.quadratic {
        " `T` is quadratic in the momenta, with a constant mass matrix."
    } else {
        " `T` is not quadratic in the momenta with a constant mass matrix."
    };
    quote! {
        /// The equations of motion, derived from `kinetic` and `potential`:
        ///
        /// ```text
        #(#[doc = #lines])*
        /// ```
        ///
        #[doc = #class]
    }
}

/// How many operations a formula may show.
const LONG: u64 = 400;

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
    /// `dq[i]/dt = ...` for every component of a gradient, `+= ...` for its terms where it has several; `force` for
    /// minus the gradient.
    pub(super) fn motion(&self, gradient: &[Contribution], force: bool, whole: bool) -> Vec<String> {
        let line = |contribution: &Contribution| {
            let Contribution { element, value, .. } = contribution;
            let left = self.left(*element);
            let places: Vec<String> = contribution.loops().map(|by| self.range(by)).collect();
            let right = self.shown(*value);
            let right = match right.strip_prefix('-') {
                _ if !force => right,
                Some(flipped) if is_grouped(flipped) => flipped[1..flipped.len() - 1].to_owned(),
                Some(flipped) if !is_sum(flipped) => flipped.to_owned(),
                None if !is_sum(&right) => format!("-{right}"),
                _ => format!("-({right})"),
            };
            let sign = if whole { "=" } else { "+=" };
            let places = if places.is_empty() { String::new() } else { format!("   for {}", places.join(", ")) };
            format!("{left} {sign} {right}{places}")
        };
        gradient.iter().map(line).collect()
    }

    /// A formula, or that it is too long.
    fn shown(&self, id: NodeId) -> String {
        self.short(id).unwrap_or_else(|| "(too long to be shown)".to_owned())
    }

    /// A formula, if it is short enough for people.
    pub(super) fn short(&self, id: NodeId) -> Option<String> {
        (self.size(id) <= LONG).then(|| self.formula(id, Tie::Sum))
    }

    /// How many operations a formula shows, shared ones as often as they occur.
    fn size(&self, id: NodeId) -> u64 {
        let mut sizes: HashMap<NodeId, u64> = HashMap::new();
        for part in self.0.graph.reachable([id]) {
            let children = self.0.graph.node(part).children().map(|child| sizes[&child]);
            let size = children.fold(1, u64::saturating_add);
            sizes.insert(part, size);
        }
        sizes[&id]
    }

    /// The left side of the equation that a component of a gradient belongs to.
    fn left(&self, element: Element) -> String {
        format!("d{}/dt", self.coordinate(element.partner()))
    }

    fn sigma(&self, by: LoopId) -> String {
        format!("Σ_{{{}}}", self.range(by))
    }

    /// A loop as `i in 0..n`.
    pub(super) fn range(&self, by: LoopId) -> String {
        let range = self.0.graph.loops.get(by);
        let name = self.0.running.get(&by).map_or_else(String::new, ToString::to_string);
        format!("{name} in {}..{}", self.index(range.from), self.index(range.to))
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
        let inner = |id| match self.0.graph.loops.index(id) {
            Index::Literal(_) | Index::Running(_) | Index::Length | Index::Parameter(_) => self.index(id),
            _ => format!("({})", self.index(id)),
        };
        let binary = |a, sign, b| format!("{} {sign} {}", inner(a), inner(b));
        match self.0.graph.loops.index(id) {
            Index::Literal(value) => value.to_string(),
            Index::Length => "n".to_owned(),
            Index::Running(by) => self.0.running.get(&by).map_or_else(String::new, ToString::to_string),
            Index::Parameter(parameter) => self.text(parameter.0),
            Index::Add(a, b) => binary(a, '+', b),
            Index::Sub(a, b) => binary(a, '-', b),
            Index::Mul(a, b) => binary(a, '*', b),
            Index::Div(a, b) => binary(a, '/', b),
            Index::Rem(a, b) => binary(a, '%', b),
            Index::Monus(a, b) | Index::Minus(a, b) => binary(a, '-', b),
            Index::Typed(_, a) => self.index(a),
            Index::Wrapped(kind, a) => format!("{} as {}", inner(a), kind.name),
            Index::Min(a, b) => format!("min({}, {})", self.index(a), self.index(b)),
        }
    }

    /// A parameter as the user wrote it, without the spaces of tokens and without `self`.
    fn text(&self, parameter: u32) -> String {
        readable(&self.0.parameters[parameter as usize].own)
    }

    /// A node as a formula that holds together at least as tightly as `needed`.
    fn formula(&self, id: NodeId, needed: Tie) -> String {
        let (text, tie) = self.tied(id);
        if tie >= needed { text } else { format!("({text})") }
    }

    fn tied(&self, id: NodeId) -> (String, Tie) {
        let graph = &self.0.graph;
        match graph.node(id) {
            Node::Constant(bits) => (f64::from_bits(bits).to_string(), Tie::Power),
            Node::Parameter(parameter) => {
                let text = self.text(parameter.0);
                let whole = text.chars().all(|letter| letter.is_alphanumeric() || "_.:[]()".contains(letter))
                    || is_grouped(&text);
                (text, if whole { Tie::Power } else { Tie::Sum })
            }
            Node::Coordinate(element) => (self.coordinate(element), Tie::Power),
            Node::Time | Node::Middle => ("t".to_owned(), Tie::Power),
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
            Node::External(id, arguments) => {
                let arguments: Vec<String> =
                    arguments.iter().map(|argument| self.formula(argument, Tie::Sum)).collect();
                (self.0.externals[id.0 as usize].written(&arguments.join(", ")), Tie::Power)
            }
            Node::Binary(function, a, b) => {
                let (a, b) = (self.formula(a, Tie::Sum), self.formula(b, Tie::Sum));
                (format!("{}({a}, {b})", function.name()), Tie::Power)
            }
            Node::Compare(comparison, a, b) => {
                let (a, b) = (self.formula(a, Tie::Sum), self.formula(b, Tie::Sum));
                (format!("{a} {} {b}", sign(comparison)), Tie::Sum)
            }
            Node::CompareIndex(comparison, a, b) => {
                (format!("{} {} {}", self.index(a), sign(comparison), self.index(b)), Tie::Sum)
            }
            Node::Flag(parameter) => (self.text(parameter.0), Tie::Power),
            Node::And(a, b) => {
                (format!("{} and {}", self.formula(a, Tie::Power), self.formula(b, Tie::Power)), Tie::Sum)
            }
            Node::Or(a, b) => (format!("{} or {}", self.formula(a, Tie::Power), self.formula(b, Tie::Power)), Tie::Sum),
            Node::Not(a) => (format!("not {}", self.formula(a, Tie::Power)), Tie::Sum),
            // That an item behind the end of a list adds nothing goes without saying.
            Node::Select(condition, a, b) if self.ends_a_list(condition) && graph.as_constant(b) == Some(0.0) => {
                self.tied(a)
            }
            Node::Select(condition, a, b) => {
                let [condition, a, b] = [condition, a, b].map(|id| self.formula(id, Tie::Sum));
                (format!("{{{a} if {condition}, else {b}}}"), Tie::Power)
            }
            Node::Sum(by, body) => (format!("{} {}", self.sigma(by), self.formula(body, Tie::Product)), Tie::Product),
        }
    }

    /// Whether a condition is that an index is not behind the end of a list.
    fn ends_a_list(&self, condition: NodeId) -> bool {
        let graph = &self.0.graph;
        matches!(graph.node(condition), Node::CompareIndex(Comparison::Less, _, end) if graph.loops.mentions_lists(end))
    }

    /// The summands of a node that are not polynomials of degree two at most in the momenta.
    pub(super) fn not_quadratic(&self, id: NodeId) -> String {
        match self.0.graph.node(id) {
            Node::Add(a, b) => {
                let offends = |id| self.0.graph.degree(id, Part::Momentum).is_none_or(|degree| degree > 2);
                self.not_quadratic(if offends(a) { a } else { b })
            }
            _ => self.shown(id),
        }
    }
}

fn sign(comparison: Comparison) -> &'static str {
    match comparison {
        Comparison::Less => "<",
        Comparison::LessOrEqual => "<=",
        Comparison::Equal => "==",
    }
}

/// Whether the first parenthesis closes at the very end.
fn is_grouped(text: &str) -> bool {
    let mut depth = 0;
    text.starts_with('(')
        && text.char_indices().all(|(at, letter)| {
            match letter {
                '(' => depth += 1,
                ')' => depth -= 1,
                _ => {}
            }
            depth > 0 || at + 1 == text.len()
        })
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

/// Tokens with the spaces that a person would leave, and without `self.`.
fn readable(text: &TokenStream) -> String {
    let mut text = text.to_string().replace("self .", "").replace("self.", "");
    for (spaced, tight) in [(" . ", "."), (" :: ", "::"), (" [", "["), ("( ", "("), (" )", ")"), (" ,", ",")] {
        text = text.replace(spaced, tight);
    }
    let mut tight = String::new();
    for word in text.split_whitespace() {
        // A call has no space in front of its arguments, and a sign none behind it; an operator has both.
        let call = word.starts_with('(') && tight.ends_with(|last: char| last.is_alphanumeric() || last == '_');
        let sign = tight == "-" || tight.ends_with("(-") || tight.ends_with("+ -") || tight.ends_with("* -");
        if !(tight.is_empty() || call || sign) {
            tight.push(' ');
        }
        tight.push_str(word);
    }
    tight
}

/// The doc comment of a prepared constant: its formula.
pub(super) fn documentation(model: &Model, id: Option<NodeId>) -> TokenStream {
    let Some(id) = id else { return TokenStream::new() };
    let text = format!(" `{}`", Formulas(model).shown(id));
    quote!(#[doc = #text])
}
