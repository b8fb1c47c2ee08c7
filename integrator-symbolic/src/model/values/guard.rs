//! The conditions of the system under which functions evaluate a parameter expression.
//!
//! Such an expression is prepared once per run for every iteration of its loops, and is evaluated only where the
//! function evaluates it: `if i > 0 { self.long[i - 1] * q[i] }` reads no element before the first.

use crate::graph::{
    Access, Comparison, Node, NodeId,
    index::{Index, IndexId, Loop, LoopId, LoopSet},
};
use crate::model::{
    Reader,
    parameters::{presence::looked_up, running_index::running_index},
    values::value::Opaque,
};
use proc_macro2::{Delimiter, TokenStream, TokenTree};
use quote::quote;

/// A condition around what is being read, and whether it holds there.
#[derive(Clone, Copy)]
pub(crate) struct Condition {
    pub(crate) node: NodeId,
    pub(crate) holds: bool,
    /// How many loops are around it.
    depth: usize,
}

impl Reader<'_> {
    /// What `read` gives where a condition holds, or where it does not.
    pub(crate) fn under<T>(&mut self, condition: Option<NodeId>, holds: bool, read: impl FnOnce(&mut Self) -> T) -> T {
        let (known, depth) = (self.conditions.len(), self.frames.len());
        self.conditions.extend(condition.map(|node| Condition { node, holds, depth }));
        let value = read(self);
        self.conditions.truncate(known);
        value
    }

    /// From here on a condition does not hold.
    pub(crate) fn past(&mut self, condition: NodeId) {
        let depth = self.frames.len();
        self.conditions.push(Condition { node: condition, holds: false, depth });
    }

    /// The text of a parameter, evaluated under those loops and conditions around it that may keep it from being so.
    ///
    /// Whether a condition on coordinates holds is not known then: a number after one is looked up where it is there,
    /// and NaN elsewhere. Returns whether that is so, too.
    pub(crate) fn guarded_text(
        &self,
        text: TokenStream,
        kind: &str,
        loops: LoopSet,
        otherwise: &TokenStream,
    ) -> (TokenStream, bool) {
        let guard = match needs(&text) {
            Needs::Nothing => None,
            // What a condition computes may have no value either where another one does not hold.
            Needs::Bounds if self.conditions.iter().any(|condition| self.computes(condition.node)) => {
                self.guard(loops, Needs::All)
            }
            own => match self.guard(loops, own) {
                // What a guard needs is asked in front of it.
                Some(guard) if needs(&guard.text) > own => self.guard(loops, Needs::All),
                guard => guard,
            },
        };
        let is_looked_up = matches!(kind, "number" | "operand")
            && self.is_on_coordinates()
            && !self.is_as_long_as_the_coordinates(&text, loops);
        let found = is_looked_up.then(|| looked_up(&text, &self.input.root)).flatten();
        let may_be_missing = found.is_some();
        let text = found.unwrap_or(text);
        let text = match guard {
            Some(Opaque { text: guard, .. }) => quote!((if #guard { #text } else { #otherwise })),
            None => text,
        };
        (text, may_be_missing)
    }

    /// Whether some condition around what is being read is not one of parameters.
    fn is_on_coordinates(&self) -> bool {
        self.conditions.iter().any(|condition| !self.graph.is_prepared(condition.node))
    }

    /// Whether a text reads lists by the indices of loops over the coordinates, or over lists, alone.
    fn is_as_long_as_the_coordinates(&self, text: &TokenStream, table: LoopSet) -> bool {
        let is_bounded = |by: LoopId| self.graph.loops.is_bounded_by_lists(by);
        needs(text) <= Needs::Bounds && !has_fixed_index(text) && table.iter().all(is_bounded)
    }

    /// Whether the functions evaluate a text in some iteration of the loops that it does not depend on, as far as
    /// parameters tell.
    fn guard(&self, loops: LoopSet, needs: Needs) -> Option<Opaque> {
        let inner = self.conditions_at(self.frames.len(), needs);
        self.frames.iter().enumerate().rev().fold(inner, |inner, (depth, frame)| {
            let inner = self.in_iterations(frame.by, loops, needs, inner);
            both(self.conditions_at(depth, needs), inner)
        })
    }

    /// The conditions with this number of loops around them that bear on a text.
    fn conditions_at(&self, depth: usize, needs: Needs) -> Option<Opaque> {
        let here = self.conditions.iter().filter(|condition| condition.depth == depth);
        here.flat_map(|condition| self.parts_on(condition.node, condition.holds, needs)).map(Some).fold(None, both)
    }

    /// The parts of a condition that bear on a text.
    fn parts_on(&self, condition: NodeId, holds: bool, needs: Needs) -> Vec<Opaque> {
        match (self.graph.node(condition), holds) {
            (Node::Not(inner), _) => self.parts_on(inner, !holds, needs),
            (Node::And(a, b), true) | (Node::Or(a, b), false) => {
                [a, b].into_iter().flat_map(|part| self.parts_on(part, holds, needs)).collect()
            }
            (Node::CompareIndex(_, a, b), _) if !self.bears_on(a, b, needs) => Vec::new(),
            (_, true) => self.condition_text(condition).into_iter().collect(),
            (_, false) => {
                let not = |Opaque { text, loops }| Opaque { text: quote!(!(#text)), loops };
                self.condition_text(condition).map(not).into_iter().collect()
            }
        }
    }

    /// What holds in an iteration of a loop, seen from outside of it; the loops of the text have a table.
    fn in_iterations(&self, by: LoopId, table: LoopSet, needs: Needs, inner: Option<Opaque>) -> Option<Opaque> {
        let Loop { from, to, .. } = self.graph.loops.get(by);
        let around = self.graph.loops.of_range(by);
        let [first, end] = [from, to].map(|bound| self.bound_text(bound));
        match inner {
            Some(inner) if table.contains(by) => {
                let name = running_index(by);
                // The table has no more than the longest iterations.
                let inside = Opaque { text: quote!(#first <= #name && #name < #end), loops: around };
                both((!around.is_subset(table)).then_some(inside), Some(inner))
            }
            None if table.contains(by) => None,
            Some(Opaque { text, loops }) if loops.contains(by) => {
                let name = running_index(by);
                let text = quote!((#first..#end).any(|#name: usize| #text));
                Some(Opaque { text, loops: loops.without(by).union(around) })
            }
            inner => {
                let is_full = match needs {
                    Needs::Division => self.graph.loops.always_has_iterations(by),
                    // A list that is read up to some index in one iteration is as long in another, and a table has as
                    // many elements as the iterations of its loops say.
                    Needs::Bounds => {
                        let loops = &self.graph.loops;
                        let is_from_zero = loops.literal(from) == Some(0);
                        let ends = table.iter().any(|inner| {
                            loops.of_index(loops.get(inner).to).contains(by)
                                || is_from_zero && loops.ends_after(inner, to)
                        });
                        loops.has_iterations(by) || !around.is_empty() || ends
                    }
                    _ => self.graph.loops.has_iterations(by),
                };
                let entered = Opaque { text: quote!(#first < #end), loops: around };
                both((!is_full).then_some(entered), inner)
            }
        }
    }

    /// Whether a condition of parameters computes an integer that there may not be.
    fn computes(&self, condition: NodeId) -> bool {
        self.graph.is_prepared(condition) && self.graph.access(condition) == Access::WhereWritten
    }

    /// Whether a comparison of integers may say that an element is there.
    fn bears_on(&self, a: IndexId, b: IndexId, needs: Needs) -> bool {
        needs > Needs::Bounds || self.graph.loops.bounds_from_above(a, b)
    }

    /// Whether the conditions around a coordinate keep its index below a length, as `i + 1 < 6` does that of `q[i +
    /// 1]`.
    pub(crate) fn is_kept_below(&mut self, position: IndexId, length: u64) -> bool {
        let mut open: Vec<_> = self.conditions.iter().map(|condition| (condition.node, condition.holds)).collect();
        while let Some((condition, holds)) = open.pop() {
            let is_kept = match (self.graph.node(condition), holds) {
                _ if self.graph.as_truth(condition).is_some_and(|always| always != holds) => true,
                (Node::Not(inner), _) => {
                    open.push((inner, !holds));
                    false
                }
                (Node::And(a, b), true) | (Node::Or(a, b), false) => {
                    open.extend([(a, holds), (b, holds)]);
                    false
                }
                (Node::CompareIndex(Comparison::Equal, a, b), false) => {
                    [(a, b), (b, a)].into_iter().any(|(index, last)| {
                        let is_last =
                            self.last_of(index).is_some() && self.last_of(index) == self.graph.loops.literal(last);
                        is_last && self.is_below((index, last, 0), position, length)
                    })
                }
                (Node::CompareIndex(comparison, a, b), _) => {
                    ordered(comparison, a, b, holds).iter().any(|order| self.is_below(*order, position, length))
                }
                _ => false,
            };
            if is_kept {
                self.graph.loops.declare_guarded(position);
                return true;
            }
        }
        false
    }

    /// The greatest value of an integer, if it is a number.
    fn last_of(&mut self, index: IndexId) -> Option<u64> {
        self.graph.loops.upper(index).and_then(|last| self.graph.loops.literal(last))
    }

    /// Whether an order of two integers says that an index is below a length.
    fn is_below(&mut self, (less, end, closed): Order, position: IndexId, length: u64) -> bool {
        let end = self.last_of(end);
        let ((base, further), (own, offset)) = (self.with_offset(less), self.with_offset(position));
        // less < end, so that position = less - further + offset is below end - further + offset.
        base == own && end.is_some_and(|end| end.saturating_add(closed + offset) <= length.saturating_add(further))
    }

    /// An index as another one and a literal that is added to it.
    fn with_offset(&self, index: IndexId) -> (IndexId, u64) {
        let Index::Add(base, by) = self.graph.loops.index(index) else { return (index, 0) };
        self.graph.loops.literal(by).map_or((index, 0), |by| (base, by))
    }

    /// A condition of parameters and indices as text, for where all conditions around it have been asked.
    pub(crate) fn condition_text(&self, condition: NodeId) -> Option<Opaque> {
        let of = |text, loops| Some(Opaque { text, loops });
        match self.graph.node(condition) {
            Node::CompareIndex(comparison, a, b) => {
                let (loops, sign) = (&self.graph.loops, sign(comparison));
                let both = loops.of_index(a).union(loops.of_index(b));
                let [a, b] = self.compared_texts([a, b]);
                of(quote!((#a) #sign (#b)), both)
            }
            Node::Flag(parameter) => {
                let text = &self.parameters[parameter.0 as usize].own;
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

    /// A number made of parameters, indices and literals, as text.
    fn number_text(&self, number: NodeId) -> Option<(TokenStream, LoopSet)> {
        let two = |a, b| {
            let ((a, first), (b, second)) = (self.number_text(a)?, self.number_text(b)?);
            Some((a, b, first.union(second)))
        };
        match self.graph.node(number) {
            Node::Parameter(parameter) => {
                let text = &self.parameters[parameter.0 as usize].own;
                Some((quote!(#text), self.graph.loops.of_parameter(parameter)))
            }
            Node::Constant(_) => {
                let Opaque { text, loops } = self.opaque(&crate::model::values::value::Value::Real(number))?;
                Some((text, loops))
            }
            Node::FromIndex(index) => {
                let text = self.signed_text(index);
                Some((quote!((#text as f64)), self.graph.loops.of_index(index)))
            }
            Node::Neg(inner) => self.number_text(inner).map(|(text, loops)| (quote!((-(#text))), loops)),
            Node::Add(a, b) => two(a, b).map(|(a, b, loops)| (quote!(((#a) + (#b))), loops)),
            Node::Mul(a, b) => two(a, b).map(|(a, b, loops)| (quote!(((#a) * (#b))), loops)),
            Node::Div(a, b) => two(a, b).map(|(a, b, loops)| (quote!(((#a) / (#b))), loops)),
            _ => None,
        }
    }
}

/// An integer that is below another one, or below that and so much more.
type Order = (IndexId, IndexId, u64);

/// What a comparison says of the order of two integers where it holds, or does not.
fn ordered(comparison: Comparison, a: IndexId, b: IndexId, holds: bool) -> Vec<Order> {
    match (comparison, holds) {
        (Comparison::Less, true) => vec![(a, b, 0)],
        (Comparison::Less, false) => vec![(b, a, 1)],
        (Comparison::LessOrEqual, true) => vec![(a, b, 1)],
        (Comparison::LessOrEqual, false) => vec![(b, a, 0)],
        (Comparison::Equal, true) => vec![(a, b, 1), (b, a, 1)],
        (Comparison::Equal, false) => Vec::new(),
    }
}

/// The condition that two hold, the second asked after the first.
fn both(first: Option<Opaque>, second: Option<Opaque>) -> Option<Opaque> {
    match (first, second) {
        (Some(first), Some(second)) => {
            let (a, b) = (first.text, second.text);
            Some(Opaque { text: quote!(#a && #b), loops: first.loops.union(second.loops) })
        }
        (first, second) => first.or(second),
    }
}

fn sign(comparison: Comparison) -> TokenStream {
    match comparison {
        Comparison::Less => quote!(<),
        Comparison::LessOrEqual => quote!(<=),
        Comparison::Equal => quote!(==),
    }
}

/// What a text requires of the conditions around it.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Needs {
    /// It has a value wherever it stands.
    Nothing,
    /// It reads lists by indices as they are: these may be too large.
    Bounds,
    /// It computes something that may have no value elsewhere.
    All,
    /// It divides by how many coordinates there are.
    Division,
}

/// Whether a list is read by a literal.
fn has_fixed_index(text: &TokenStream) -> bool {
    text.clone().into_iter().any(|token| match token {
        TokenTree::Group(group) if group.delimiter() == Delimiter::Bracket => {
            matches!(group.stream().into_iter().next(), Some(TokenTree::Literal(_))) || has_fixed_index(&group.stream())
        }
        TokenTree::Group(group) => has_fixed_index(&group.stream()),
        _ => false,
    })
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
            TokenTree::Ident(word) if word == "length" && matches!(name.as_str(), "/" | "%") => Needs::Division,
            _ => Needs::Nothing,
        };
        most = most.max(own);
        name = token.to_string();
    }
    most
}
