//! Exchange symmetry: whether expressions are equal up to the order of sums and products, optionally with two indices
//! exchanged.
//!
//! Expressions are compared in a normal form: sums and products as sorted lists, with signs outside. Equal forms are
//! equal expressions. Some equal expressions have different forms; they count as different.

use super::order::Order;
use crate::graph::{
    Comparison, Element, Graph, Node, NodeId, ParameterId,
    function::{Function, Parity},
    index::{IndexId, LoopId},
    rename::{Parameters, Renaming},
};
use std::collections::HashMap;

/// A normal form with its sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(super) struct Signed {
    form: u32,
    negative: bool,
}

impl Signed {
    pub(super) fn opposite(self) -> Self {
        Self { negative: !self.negative, ..self }
    }

    fn negated_if(self, negative: bool) -> Self {
        Self { negative: self.negative != negative, ..self }
    }

    fn unsigned_if(self, unsigned: bool) -> Self {
        Self { negative: self.negative && !unsigned, ..self }
    }
}

/// A normal form.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
enum Form {
    /// A node that does not depend on the two indices.
    Fixed(NodeId),
    /// A parameter that is no product.
    Parameter(ParameterId),
    FromIndex(IndexId),
    Coordinate(Element),
    /// Addends in order.
    Terms(Vec<Signed>),
    /// A number, by its bits, and bases in order, each with twice its exponent.
    Factors(u64, Vec<(Signed, i32)>),
    Unary(Function, Signed),
    Binary(Function, Signed, Signed),
    /// A number within two opposite bounds, by the bits of the upper one.
    Clamped(u64, Signed),
    Entry(NodeId, Signed, Signed),
    Sum(LoopId, Signed),
    Compare(Comparison, Signed, Signed),
    Not(Signed),
    And([Signed; 2]),
    Or([Signed; 2]),
    Select([Signed; 3]),
}

/// The forms known so far.
pub(super) struct Forms<'p> {
    pair: [LoopId; 2],
    /// The order of the bodies, by which constants are chosen.
    order: Option<Order>,
    parameters: &'p mut dyn Parameters,
    ids: HashMap<Form, u32>,
    known: HashMap<(NodeId, bool), Signed>,
}

/// Whether an expression stays the same if the indices of a pair are exchanged; `None` where a parameter cannot be.
pub(super) fn is_symmetric(
    graph: &mut Graph,
    id: NodeId,
    pair: [LoopId; 2],
    parameters: &mut dyn Parameters,
) -> Option<bool> {
    let mut forms = Forms::new(pair, None, parameters);
    Some(forms.of(graph, id, false)? == forms.of(graph, id, true)?)
}

/// Whether two expressions are equal up to the order of their sums and products.
pub(crate) fn are_equal(
    graph: &mut Graph,
    [a, b]: [NodeId; 2],
    pair: [LoopId; 2],
    parameters: &mut dyn Parameters,
) -> Option<bool> {
    let mut forms = Forms::new(pair, None, parameters);
    Some(forms.of(graph, a, false)? == forms.of(graph, b, false)?)
}

/// Whether an expression changes its sign if the indices of a pair are exchanged; `None` if it becomes another one, or if a
/// parameter cannot be exchanged.
pub(crate) fn sign_of_exchange(
    graph: &mut Graph,
    id: NodeId,
    pair: [LoopId; 2],
    parameters: &mut dyn Parameters,
) -> Option<bool> {
    let mut forms = Forms::new(pair, None, parameters);
    let (here, there) = (forms.of(graph, id, false)?, forms.of(graph, id, true)?);
    let opposite = here.opposite() == there;
    (here == there || opposite).then_some(opposite)
}

impl<'p> Forms<'p> {
    pub(super) fn new(pair: [LoopId; 2], order: Option<Order>, parameters: &'p mut dyn Parameters) -> Self {
        Self { pair, order, parameters, ids: HashMap::new(), known: HashMap::new() }
    }

    /// The form of a node, with the indices of the pair exchanged or not; `None` where a parameter cannot be.
    pub(super) fn of(&mut self, graph: &mut Graph, id: NodeId, exchanged: bool) -> Option<Signed> {
        if let Some(known) = self.known.get(&(id, exchanged)) {
            return Some(*known);
        }
        let ordered = self.order.filter(|_| exchanged).and_then(|order| order.exchanged(graph, id));
        let form = match ordered {
            Some(negative) => self.of(graph, id, false)?.negated_if(negative),
            None => self.form(graph, id, exchanged)?,
        };
        self.known.insert((id, exchanged), form);
        Some(form)
    }

    fn form(&mut self, graph: &mut Graph, id: NodeId, exchanged: bool) -> Option<Signed> {
        let loops = graph.loops_of(id);
        let fixed = graph.is_prepared(id) && !self.pair.iter().any(|by| loops.contains(*by));
        let by = Renaming::exchange(self.pair);
        if let Some((bound, inner)) = clamped(graph, id) {
            let inner = self.of(graph, inner, exchanged)?;
            let form = self.id(Form::Clamped(bound.to_bits(), inner.unsigned_if(true)));
            return Some(form.negated_if(inner.negative));
        }
        let form = match graph.node(id) {
            Node::Constant(_) | Node::Parameter(_) | Node::Mul(..) | Node::Div(..) | Node::Power(..) => {
                return self.product(graph, id, exchanged);
            }
            Node::Neg(a) => return Some(self.of(graph, a, exchanged)?.opposite()),
            Node::Add(a, b) => {
                let mut terms = Vec::new();
                self.addends(graph, a, exchanged, false, &mut terms)?;
                self.addends(graph, b, exchanged, false, &mut terms)?;
                return Some(self.sum(terms));
            }
            _ if fixed => Form::Fixed(id),
            Node::FromIndex(index) if exchanged => Form::FromIndex(by.index(graph, index)?),
            Node::FromIndex(index) => Form::FromIndex(index),
            Node::Coordinate(element) if exchanged => {
                Form::Coordinate(Element { index: by.index(graph, element.index)?, ..element })
            }
            Node::Coordinate(element) => Form::Coordinate(element),
            Node::Unary(function, a) => {
                let a = self.of(graph, a, exchanged)?;
                let parity = function.row().parity;
                let form = self.id(Form::Unary(function, a.unsigned_if(parity != Parity::Neither)));
                return Some(form.negated_if(a.negative && parity == Parity::Odd));
            }
            Node::Binary(function, a, b) => {
                let mut arguments = [self.of(graph, a, exchanged)?, self.of(graph, b, exchanged)?];
                let row = function.row();
                if row.parity == Parity::Even {
                    arguments = arguments.map(|argument| argument.unsigned_if(true));
                }
                if row.commutative {
                    arguments.sort();
                }
                let [first, second] = arguments;
                let odd = row.parity == Parity::Odd;
                let form = self.id(Form::Binary(function, first.unsigned_if(odd), second));
                return Some(form.negated_if(odd && first.negative));
            }
            Node::Entry(table, a, b) if graph.is_symmetric(table) => {
                let [a, b] = self.sorted(graph, [a, b], exchanged)?;
                Form::Entry(table, a, b)
            }
            Node::Entry(table, a, b) => {
                Form::Entry(table, self.of(graph, a, exchanged)?, self.of(graph, b, exchanged)?)
            }
            Node::Sum(by, body) => {
                let body = self.of(graph, body, exchanged)?;
                let form = self.id(Form::Sum(by, body.unsigned_if(true)));
                return Some(form.negated_if(body.negative));
            }
            Node::Compare(Comparison::Equal, a, b) => {
                let [a, b] = self.sorted(graph, [a, b], exchanged)?;
                Form::Compare(Comparison::Equal, a, b)
            }
            // a < b is -b < -a
            Node::Compare(comparison, a, b) => {
                let (a, b) = (self.of(graph, a, exchanged)?, self.of(graph, b, exchanged)?);
                let (a, b) = (a, b).min((b.opposite(), a.opposite()));
                Form::Compare(comparison, a, b)
            }
            Node::Not(a) => Form::Not(self.of(graph, a, exchanged)?),
            Node::And(a, b) => Form::And(self.sorted(graph, [a, b], exchanged)?),
            Node::Or(a, b) => Form::Or(self.sorted(graph, [a, b], exchanged)?),
            Node::Select(condition, a, b) => Form::Select([
                self.of(graph, condition, exchanged)?,
                self.of(graph, a, exchanged)?,
                self.of(graph, b, exchanged)?,
            ]),
            Node::Time | Node::Middle | Node::Step => Form::Fixed(id),
            Node::Fold(..) | Node::External(..) | Node::CompareIndex(..) | Node::Flag(_) => return None,
        };
        Some(self.id(form))
    }

    fn sorted(&mut self, graph: &mut Graph, [a, b]: [NodeId; 2], exchanged: bool) -> Option<[Signed; 2]> {
        let (a, b) = (self.of(graph, a, exchanged)?, self.of(graph, b, exchanged)?);
        Some([a.min(b), a.max(b)])
    }

    /// The addends of a node, sums in sums included.
    fn addends(
        &mut self,
        graph: &mut Graph,
        id: NodeId,
        exchanged: bool,
        negative: bool,
        terms: &mut Vec<Signed>,
    ) -> Option<()> {
        match graph.node(id) {
            Node::Add(a, b) => {
                self.addends(graph, a, exchanged, negative, terms)?;
                self.addends(graph, b, exchanged, negative, terms)
            }
            Node::Neg(a) => self.addends(graph, a, exchanged, !negative, terms),
            _ => {
                terms.push(self.of(graph, id, exchanged)?.negated_if(negative));
                Some(())
            }
        }
    }

    /// A sum whose first addend is positive, or the negative of one.
    fn sum(&mut self, mut terms: Vec<Signed>) -> Signed {
        terms.sort();
        let negative = terms.first().is_some_and(|first| first.negative);
        let terms = terms.into_iter().map(|term| term.negated_if(negative)).collect();
        self.id(Form::Terms(terms)).negated_if(negative)
    }

    fn product(&mut self, graph: &mut Graph, id: NodeId, exchanged: bool) -> Option<Signed> {
        let (mut number, mut factors) = (1.0, Vec::new());
        self.factors(graph, id, exchanged, 2, &mut number, &mut factors)?;
        factors.sort();
        let mut merged: Vec<(Signed, i32)> = Vec::new();
        for (base, halves) in factors {
            match merged.last_mut() {
                Some((known, exponent)) if *known == base => *exponent += halves,
                _ => merged.push((base, halves)),
            }
        }
        let form = Form::Factors(f64::abs(number).to_bits(), merged);
        Some(self.id(form).negated_if(number.is_sign_negative()))
    }

    /// The factors of a node to the power of `halves / 2`, products in products included.
    fn factors(
        &mut self,
        graph: &mut Graph,
        id: NodeId,
        exchanged: bool,
        halves: i32,
        number: &mut f64,
        factors: &mut Vec<(Signed, i32)>,
    ) -> Option<()> {
        let whole = halves % 2 == 0;
        match graph.node(id) {
            Node::Constant(bits) => *number *= f64::from_bits(bits).powf(f64::from(halves) / 2.0),
            Node::Parameter(parameter) if whole => {
                let parameter = match exchanged {
                    true => self.parameters.rename(graph, parameter, Renaming::exchange(self.pair))?,
                    false => parameter,
                };
                for (factor, exponent) in self.parameters.factors(graph, parameter) {
                    let base = self.id(Form::Parameter(factor));
                    factors.push((base, exponent * halves));
                }
            }
            Node::Neg(a) if whole => {
                *number *= if halves % 4 == 0 { 1.0 } else { -1.0 };
                return self.factors(graph, a, exchanged, halves, number, factors);
            }
            Node::Mul(a, b) if whole => {
                self.factors(graph, a, exchanged, halves, number, factors)?;
                return self.factors(graph, b, exchanged, halves, number, factors);
            }
            Node::Div(a, b) if whole => {
                self.factors(graph, a, exchanged, halves, number, factors)?;
                return self.factors(graph, b, exchanged, -halves, number, factors);
            }
            Node::Power(a, own) if whole && own.checked_mul(halves / 2).is_some() => {
                return self.factors(graph, a, exchanged, own * (halves / 2), number, factors);
            }
            Node::Parameter(_) | Node::Power(..) | Node::Mul(..) | Node::Div(..) => {
                let base = self.product(graph, id, exchanged)?;
                factors.push((base, halves));
            }
            _ => {
                let base = self.of(graph, id, exchanged)?;
                let negative = base.negative && whole;
                *number *= if negative && halves % 4 != 0 { -1.0 } else { 1.0 };
                factors.push((base.negated_if(negative), halves));
            }
        }
        Some(())
    }

    fn id(&mut self, form: Form) -> Signed {
        let next = self.ids.len() as u32;
        Signed { form: *self.ids.entry(form).or_insert(next), negative: false }
    }
}

/// The upper one of two opposite bounds, and the number that is kept within them.
fn clamped(graph: &Graph, id: NodeId) -> Option<(f64, NodeId)> {
    let bounded = |id, name| match graph.node(id) {
        Node::Binary(function, a, b) if function.name() == name => {
            [(a, b), (b, a)].into_iter().find_map(|(number, bound)| Some((number, graph.as_constant(bound)?)))
        }
        _ => None,
    };
    let (inner, upper) = bounded(id, "min")?;
    let (number, lower) = bounded(inner, "max")?;
    (upper > 0.0 && upper == -lower).then_some((upper, number))
}
