//! The conditions of the system under which the functions evaluate an expression of parameters.
//!
//! It is prepared once per run for every turn of its loops, and there, too, is evaluated only where the function does it:
//! `if i > 0 { self.long[i - 1] * q[i] }` asks for no element before the first.

use super::{Reader, value::Opaque};
use crate::graph::{
    Comparison, Node, NodeId,
    index::{IndexId, LoopSet},
};
use proc_macro2::{Delimiter, TokenStream, TokenTree};
use quote::quote;

impl Reader<'_> {
    /// What `read` gives where a condition holds, or where it does not.
    pub(super) fn under<T>(&mut self, condition: Option<NodeId>, holds: bool, read: impl FnOnce(&mut Self) -> T) -> T {
        let depth = self.conditions.len();
        self.conditions.extend(condition.map(|condition| (condition, holds)));
        let value = read(self);
        self.conditions.truncate(depth);
        value
    }

    /// The text of a parameter, evaluated under those conditions around it that may keep it from being so.
    pub(super) fn guarded_text(
        &self,
        text: TokenStream,
        loops: LoopSet,
        otherwise: &TokenStream,
    ) -> (TokenStream, LoopSet) {
        let needs = needs(&text);
        if needs == Needs::Nothing {
            return (text, loops);
        }
        let mut open: Vec<(NodeId, bool)> = self.conditions.iter().rev().copied().collect();
        let mut guards: Vec<Opaque> = Vec::new();
        while let Some((condition, holds)) = open.pop() {
            match (self.graph.node(condition), holds) {
                (Node::Not(inner), _) => open.push((inner, !holds)),
                (Node::And(a, b), true) | (Node::Or(a, b), false) => open.extend([(b, holds), (a, holds)]),
                (Node::CompareIndex(_, a, b), _) if !self.bears_on(a, b, needs) => {}
                (_, true) => guards.extend(self.condition_text(condition)),
                (_, false) => guards.extend(
                    self.condition_text(condition)
                        .map(|Opaque { text, loops }| Opaque { text: quote!(!(#text)), loops }),
                ),
            }
        }
        let known = |guard: &Opaque| guard.loops.is_subset(loops);
        let texts: Vec<TokenStream> =
            guards.iter().filter(|guard| known(guard)).map(|guard| guard.text.clone()).collect();
        if texts.is_empty() {
            return (text, loops);
        }
        (quote!((if #(#texts)&&* { #text } else { #otherwise })), loops)
    }

    /// Whether a comparison of integers may say that an element is there.
    fn bears_on(&self, a: IndexId, b: IndexId, needs: Needs) -> bool {
        needs == Needs::All || self.graph.loops.bounds_from_above(a, b)
    }

    /// A condition of parameters and indices as text.
    fn condition_text(&self, condition: NodeId) -> Option<Opaque> {
        let of = |text, loops| Some(Opaque { text, loops });
        match self.graph.node(condition) {
            Node::CompareIndex(comparison, a, b) => {
                let (loops, sign) = (&self.graph.loops, sign(comparison));
                let both = loops.of_index(a).union(loops.of_index(b));
                let (a, b) = (self.index_text(a), self.index_text(b));
                of(quote!((#a) #sign (#b)), both)
            }
            Node::Flag(parameter) => {
                let text = &self.parameters[parameter.0 as usize].text;
                of(quote!((#text)), self.graph.loops.of_parameter(parameter))
            }
            Node::Not(inner) => {
                let Opaque { text, loops } = self.condition_text(inner)?;
                of(quote!(!(#text)), loops)
            }
            Node::And(a, b) | Node::Or(a, b) => {
                let (a, b) = (self.condition_text(a)?, self.condition_text(b)?);
                let loops = a.loops.union(b.loops);
                let (a, b) = (a.text, b.text);
                match self.graph.node(condition) {
                    Node::And(..) => of(quote!((#a && #b)), loops),
                    _ => of(quote!((#a || #b)), loops),
                }
            }
            Node::Compare(comparison, a, b) => {
                let ((a, first), (b, second)) = (self.number_text(a)?, self.number_text(b)?);
                let sign = sign(comparison);
                of(quote!((#a) #sign (#b)), first.union(second))
            }
            _ => None,
        }
    }

    /// A number that is a parameter or a literal, as text.
    fn number_text(&self, number: NodeId) -> Option<(TokenStream, LoopSet)> {
        match self.graph.node(number) {
            Node::Parameter(parameter) => {
                let text = &self.parameters[parameter.0 as usize].text;
                Some((quote!(#text), self.graph.loops.of_parameter(parameter)))
            }
            Node::Constant(_) => {
                let Opaque { text, loops } = self.opaque(&super::value::Value::Real(number))?;
                Some((text, loops))
            }
            _ => None,
        }
    }
}

fn sign(comparison: Comparison) -> TokenStream {
    match comparison {
        Comparison::Less => quote!(<),
        Comparison::LessOrEqual => quote!(<=),
        Comparison::Equal => quote!(==),
    }
}

/// What a text asks of the conditions around it.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Needs {
    /// It has a value wherever it stands.
    Nothing,
    /// It reads lists by indices as they are: these may be too large.
    Bounds,
    /// It computes something that may have no value elsewhere.
    All,
}

/// Methods that have a value for every receiver, beside those of floats.
const TOTAL: [&str; 6] = ["len", "is_empty", "is_some", "is_none", "is_ok", "is_err"];

/// Paths alone, and numbers made of them, have a value everywhere.
fn needs(text: &TokenStream) -> Needs {
    let mut name = String::new();
    let mut most = Needs::Nothing;
    for token in text.clone() {
        let own = match &token {
            TokenTree::Group(group) if group.delimiter() == Delimiter::Bracket => {
                match &group.stream().into_iter().collect::<Vec<_>>()[..] {
                    [TokenTree::Ident(_) | TokenTree::Literal(_)] => Needs::Bounds,
                    _ => Needs::All,
                }
            }
            TokenTree::Group(group) if group.stream().is_empty() && !TOTAL.contains(&name.as_str()) => Needs::All,
            TokenTree::Group(group) => needs(&group.stream()),
            // A cast is made of integers, which are not below zero.
            TokenTree::Ident(word) if word == "as" => Needs::All,
            _ => Needs::Nothing,
        };
        most = most.max(own);
        name = token.to_string();
    }
    most
}
