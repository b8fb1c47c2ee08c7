//! Nearest images in a periodic box, whose squares get one form however they are written.
//!
//! In: an energy. Out: the same energy up to rounding, with `x - L round(x / L)` in place of other images. Those among the nearest
//! boxes only, as by branches or by the shorter one of both ways, shift by one side at most, by two comparisons with half a side: these take
//! as long as rounding, and a bound on the rounded number takes longer. Both forms are odd in `x`, so the bodies of a pair may be exchanged.
//!
//! Proved property: the square is the same for every displacement and every side above zero, but at `x = (n + 1/2) L`, where both
//! images are as far. If each operation of an image results in `n x / L + m / 2` with integers, `|n| <= 1`, then its edges are at
//! multiples of `L / 4`. So one place between each two of these determines the whole function. The function continues so
//! beyond the last place: integers in each period differ from those in the period before by as much as there, and no number whose sign
//! decides comes closer to zero.

use super::{
    order::rewritten,
    shifted::{Shifted, sides_in},
};
use crate::graph::{
    Comparison, Element, Graph, Node, NodeId, ParameterId, Part,
    index::{Index, LoopId},
    rename::Parameters,
};
use std::collections::HashMap;

/// An energy in which squares of images have one form. Sums over two others of a body read the images themselves too, so they keep them.
pub(crate) fn with_one_form(graph: &mut Graph, energy: NodeId, parameters: &mut dyn Parameters) -> NodeId {
    rewritten(graph, energy, |graph, id| match graph.node(id) {
        Node::Power(image, 4) => {
            let image = in_one_form(graph, image, parameters).or_else(|| with_ties_to_even(graph, image))?;
            Some(graph.power(image, 4))
        }
        Node::Sum(by, body) => has_inner_sum(graph, by, body).then_some(id),
        _ => None,
    })
}

/// Whether a sum over the partners of a body has a sum over further bodies inside of it.
fn has_inner_sum(graph: &Graph, by: LoopId, body: NodeId) -> bool {
    let Some(outer) = graph.loops.get(by).parent else { return false };
    let ends = [outer, by].map(|by| graph.loops.get(by).to);
    graph.summed_in(body).iter().any(|inner| {
        let to = graph.loops.get(inner).to;
        ends.contains(&to) || matches!(graph.loops.index(to), Index::Running(_))
    })
}

/// The maximum number of operations in an image.
const OPERATIONS: usize = 64;

/// The form of an image, up to its sign; `None` if it is not a nearest image.
fn in_one_form(graph: &mut Graph, image: NodeId, parameters: &mut dyn Parameters) -> Option<NodeId> {
    let inside = graph.reachable([image]);
    if inside.len() > OPERATIONS {
        return None;
    }
    let (pair, both) = displacement(graph, &inside)?;
    let mut multiples = HashMap::new();
    for id in &inside {
        if let Node::Parameter(parameter) = graph.node(*id) {
            multiples.insert(*id, parameters.multiple(graph, parameter));
        }
    }
    let sides: Vec<_> = inside.iter().flat_map(|node| sides_in(graph, *node, pair)).collect();
    let (side, kind) = sides.into_iter().find_map(|side| {
        let kind = Kind::of(&Images { graph, inside: &inside, multiples: &multiples, both, side, image })?;
        Some((side, kind))
    })?;
    let [x, _] = both;
    Some(match kind {
        Kind::Periodic => {
            let quotient = graph.div(x, side);
            let whole = graph.call("round_ties_even", quotient);
            let shift = graph.mul(side, whole);
            graph.sub(x, shift)
        }
        Kind::AmongNearest => {
            let [two, zero] = [2.0, 0.0].map(|number| graph.constant(number));
            let half = graph.div(side, two);
            let minus_half = graph.neg(half);
            let shift = |graph: &mut Graph, less, greater| {
                let is_beyond = graph.compare(Comparison::Less, less, greater);
                graph.select(is_beyond, side, zero)
            };
            let [down, up] = [shift(graph, half, x), shift(graph, x, minus_half)];
            let lowered = graph.sub(x, down);
            graph.add(lowered, up)
        }
    })
}

/// An image by a quotient, if the text does not show that it is one by the side, such as a product with another parameter:
/// rounded with ties to even, which takes one instruction and is odd.
fn with_ties_to_even(graph: &mut Graph, image: NodeId) -> Option<NodeId> {
    let inside = graph.reachable([image]);
    let (pair, both) = displacement(graph, &inside)?;
    let sides: Vec<_> = inside.iter().flat_map(|node| sides_in(graph, *node, pair)).collect();
    if !sides.into_iter().any(|side| Shifted::new(graph, side, both).is_displacement(image)) {
        return None;
    }
    Some(rewritten(graph, image, |graph, id| {
        let Node::Unary(function, number) = graph.node(id) else { return None };
        let number = match (function.name(), graph.node(number)) {
            ("round", _) => number,
            ("floor", Node::Add(number, half)) if graph.as_constant(half) == Some(0.5) => number,
            _ => return None,
        };
        Some(graph.call("round_ties_even", number))
    }))
}

/// The loops over the only two bodies whose coordinates are read, along one axis, and their displacement with either sign.
fn displacement(graph: &mut Graph, inside: &[NodeId]) -> Option<([LoopId; 2], [NodeId; 2])> {
    let read = inside.iter().filter_map(|id| match graph.node(*id) {
        Node::Coordinate(element) => Some((*id, element)),
        _ => None,
    });
    let read: Vec<_> = read.collect();
    let [(first, a), (second, b)] = read[..] else { return None };
    let by = |element: Element| match graph.loops.index(element.index) {
        Index::Running(by) if element.part == Part::Position => Some(by),
        _ => None,
    };
    let pair = [by(a)?, by(b)?];
    let both = [graph.sub(first, second), graph.sub(second, first)];
    (a.component == b.component).then_some((pair, both))
}

/// How far an image looks for the nearest one.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    /// Among all boxes.
    Periodic,
    /// Among the box itself and those beside it.
    AmongNearest,
}

/// A function that may be the nearest image of a displacement.
struct Images<'g> {
    graph: &'g Graph,
    /// The nodes that it is made of, children first.
    inside: &'g [NodeId],
    /// The parameters among them as multiples of others.
    multiples: &'g HashMap<NodeId, (f64, ParameterId)>,
    /// The displacement, with either sign.
    both: [NodeId; 2],
    side: NodeId,
    image: NodeId,
}

/// Places in each period of a side.
const PLACES: i64 = 4;

/// The number of periods on either side of zero that are compared.
const PERIODS: i64 = 4;

impl Kind {
    fn of(images: &Images<'_>) -> Option<Self> {
        let range = -PERIODS * PLACES..PERIODS * PLACES;
        let places: Vec<_> = range.clone().map(|at| At::new(images, at)).collect();
        let nearest = |kind: Self| {
            places.iter().all(|place| {
                let boxes = (2 * place.at + 1 + PLACES).div_euclid(2 * PLACES);
                let boxes = if kind == Self::Periodic { boxes } else { boxes.clamp(-1, 1) };
                let image = Affine { length: 1, slope: 1, halves: -2 * boxes };
                place.values.get(&images.image).is_some_and(|value| [image, -image].map(Value::Affine).contains(value))
            })
        };
        let kind = [Self::Periodic, Self::AmongNearest].into_iter().find(|kind| nearest(*kind))?;
        let (count, period) = (places.len(), PLACES as usize);
        let goes_on = |place: usize| {
            let (first, last) = (place, place + period);
            let (end, before_end) = (count - 1 - first, count - 1 - last);
            places[last].goes_on_to(&places[first]) && places[before_end].goes_on_to(&places[end])
        };
        (0..period).all(goes_on).then_some(kind)
    }
}

/// `slope x + halves side / 2` for the power one of `length`, and the same over the side for zero.
#[derive(Clone, Copy, PartialEq)]
struct Affine {
    length: i32,
    slope: i64,
    halves: i64,
}

impl std::ops::Neg for Affine {
    type Output = Self;

    fn neg(self) -> Self {
        Self { slope: -self.slope, halves: -self.halves, ..self }
    }
}

impl Affine {
    fn sum(self, other: Self) -> Option<Self> {
        let sum = Self { slope: self.slope + other.slope, halves: self.halves + other.halves, ..self };
        (self.length == other.length).then_some(sum)
    }

    fn product(self, other: Self) -> Option<Self> {
        let (number, of) = if self.slope == 0 { (self, other) } else { (other, self) };
        let [slope, halves] = [number.halves * of.slope, number.halves * of.halves];
        let is_whole = number.slope == 0 && slope % 2 == 0 && halves % 2 == 0;
        is_whole.then_some(Self { length: self.length + other.length, slope: slope / 2, halves: halves / 2 })
    }

    fn reciprocal(self) -> Option<Self> {
        let is_whole = self.slope == 0 && self.halves != 0 && 4 % self.halves == 0;
        is_whole.then(|| Self { length: -self.length, slope: 0, halves: 4 / self.halves })
    }

    fn whole(number: i64) -> Self {
        Self { length: 0, slope: 0, halves: 2 * number }
    }
}

/// What a node is in a place.
#[derive(Clone, Copy, PartialEq)]
enum Value {
    /// A number, of either length if it is zero.
    Number(f64),
    Affine(Affine),
    Truth(bool),
}

/// An image in a place between multiples of a quarter of the side.
struct At {
    /// The number of quarters before it.
    at: i64,
    values: HashMap<NodeId, Value>,
    /// Numbers that decide by their signs, or are rounded.
    decisions: Vec<Affine>,
}

impl At {
    fn new(images: &Images<'_>, at: i64) -> Self {
        let mut place = Self { at, values: HashMap::new(), decisions: Vec::new() };
        for id in images.inside {
            if let Some(value) = place.value(images, *id) {
                place.values.insert(*id, value);
            }
        }
        place
    }

    /// A number in eighths of the side.
    fn eighths(&self, Affine { slope, halves, .. }: Affine) -> i64 {
        slope * (2 * self.at + 1) + 4 * halves
    }

    /// Whether decisions in the same place one period further out are the same, and are so in all periods after it.
    fn goes_on_to(&self, further: &Self) -> bool {
        let stays = |(here, there): (&Affine, &Affine)| {
            let [a, b] = [self.eighths(*here), further.eighths(*there)];
            here.slope == there.slope && (a - b) % 8 == 0 && a.signum() == b.signum() && a.abs() <= b.abs()
        };
        self.decisions.len() == further.decisions.len() && self.decisions.iter().zip(&further.decisions).all(stays)
    }

    /// The sign of a number, which decides.
    fn sign(&mut self, number: Affine) -> i64 {
        self.decisions.push(number);
        self.eighths(number).signum()
    }

    fn value(&mut self, images: &Images<'_>, id: NodeId) -> Option<Value> {
        let graph = images.graph;
        let affine = |slope, halves| Some(Value::Affine(Affine { length: 1, slope, halves }));
        if id == images.side {
            return affine(0, 2);
        }
        if let (Some((number, of)), Some((by, side))) = (images.multiples.get(&id), images.multiples.get(&images.side))
            && of == side
        {
            return affine(0, whole(2.0 * number / by)?);
        }
        if let Some(number) = images.both.iter().position(|displacement| *displacement == id) {
            return affine(if number == 0 { 1 } else { -1 }, 0);
        }
        let node = graph.node(id);
        let truth = |place: &Self, id| match place.values.get(&id) {
            Some(Value::Truth(truth)) => Some(*truth),
            _ => None,
        };
        let value = match node {
            Node::Constant(bits) => return Some(Value::Number(f64::from_bits(bits))),
            Node::Select(condition, a, b) => {
                let chosen = if truth(self, condition)? { a } else { b };
                return self.values.get(&chosen).copied();
            }
            Node::And(a, b) => return Some(Value::Truth(truth(self, a)? && truth(self, b)?)),
            Node::Or(a, b) => return Some(Value::Truth(truth(self, a)? || truth(self, b)?)),
            Node::Not(a) => return Some(Value::Truth(!truth(self, a)?)),
            Node::Compare(comparison, a, b) => {
                let [a, b] = self.alike(a, b)?;
                let sign = self.sign(a.sum(-b)?);
                return Some(Value::Truth(match comparison {
                    Comparison::Less => sign < 0,
                    Comparison::LessOrEqual => sign <= 0,
                    Comparison::Equal => sign == 0,
                }));
            }
            Node::Neg(a) => -self.affine(a, None)?,
            Node::Add(a, b) => {
                let [a, b] = self.alike(a, b)?;
                a.sum(b)?
            }
            Node::Mul(a, b) => self.affine(a, Some(0))?.product(self.affine(b, Some(0))?)?,
            Node::Div(a, b) => self.affine(a, Some(0))?.product(self.affine(b, Some(0))?.reciprocal()?)?,
            Node::Power(a, -2) => self.affine(a, Some(0))?.reciprocal()?,
            Node::Unary(function, a) => self.unary(function.name(), self.affine(a, None)?)?,
            Node::Binary(function, a, b) => {
                let [a, b] = self.alike(a, b)?;
                match function.name() {
                    "min" | "max" => {
                        let is_first = (self.sign(a.sum(-b)?) < 0) == (function.name() == "min");
                        if is_first { a } else { b }
                    }
                    "remainder" if b.slope == 0 && b.halves.abs() == 2 => {
                        let whole = self.unary("trunc", Affine { length: 0, ..a })?;
                        a.sum(-Affine { length: a.length, ..whole })?
                    }
                    _ => return None,
                }
            }
            _ => return None,
        };
        (value.slope.abs() <= 1).then_some(Value::Affine(value))
    }

    fn unary(&mut self, name: &str, number: Affine) -> Option<Affine> {
        match name {
            "abs" => return Some(if self.sign(number) < 0 { -number } else { number }),
            "signum" => return Some(Affine::whole(if self.sign(number) < 0 { -1 } else { 1 })),
            _ => {}
        }
        let (sign, eighths) = (self.sign(number), self.eighths(number));
        let (below, nearest) = (eighths.div_euclid(8), (eighths + 4).div_euclid(8));
        let is_tie = eighths.rem_euclid(8) == 4;
        let whole = match name {
            "floor" => below,
            "ceil" => -(-eighths).div_euclid(8),
            "trunc" => eighths / 8,
            "round" if is_tie && sign < 0 => below,
            "round_ties_even" if is_tie => below + below.rem_euclid(2),
            "round" | "round_ties_even" => nearest,
            _ => return None,
        };
        (number.length == 0).then(|| Affine::whole(whole))
    }

    /// A node as a number of this length.
    fn affine(&self, id: NodeId, length: Option<i32>) -> Option<Affine> {
        match (self.values.get(&id)?, length) {
            (Value::Affine(value), _) => Some(*value),
            (Value::Number(0.0), Some(length)) => Some(Affine { length, slope: 0, halves: 0 }),
            (Value::Number(number), Some(0)) => Some(Affine { length: 0, slope: 0, halves: whole(2.0 * number)? }),
            _ => None,
        }
    }

    /// Two nodes as numbers of the same length.
    fn alike(&self, a: NodeId, b: NodeId) -> Option<[Affine; 2]> {
        let length = [a, b].iter().find_map(|id| match self.values.get(id) {
            Some(Value::Affine(value)) => Some(value.length),
            _ => None,
        })?;
        let both = [self.affine(a, Some(length))?, self.affine(b, Some(length))?];
        (both[0].length == both[1].length).then_some(both)
    }
}

/// A number as a small integer.
fn whole(number: f64) -> Option<i64> {
    (number.fract() == 0.0 && number.abs() <= 1e6).then_some(number as i64)
}
