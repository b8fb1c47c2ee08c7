//! Parts that read a momentum `p_i` only as a kinetic momentum `p_i - a(q)`, where `a` depends on `q_i`.
//!
//! The canonical shift `p -> p - ∂G/∂q` with an antiderivative `G` of `a` with respect to `q_i` turns `p_i - a` into `p_i`.
//! If that leaves a shear, the flow of the part is this shear between the shift and the opposite shift (Wu, Forest and Robin
//! 2003, Phys. Rev. E 68, 046502).

use super::{
    Element, Graph, Node, NodeId, Part,
    exact::{Exact, Obstacle},
};
use std::collections::{HashMap, HashSet};

/// A part as a shear between two canonical shifts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Shifted {
    /// The part with momenta in the places of kinetic momenta: a shear.
    pub(crate) shear: NodeId,
    /// The shifts, which commute.
    pub(crate) shifts: Vec<Shift>,
}

/// The shift of a momentum, and of what follows from it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Shift {
    pub(crate) momentum: Element,
    /// The momentum minus its kinetic momentum, `a`, but for what does not depend on the position.
    pub(crate) difference: NodeId,
    /// The function `G` whose gradient the momenta are shifted by.
    pub(crate) generator: NodeId,
}

impl Shifted {
    /// Everything that its flow is computed from.
    pub(crate) fn values(&mut self) -> impl Iterator<Item = &mut NodeId> {
        let of_shifts = self.shifts.iter_mut().flat_map(|shift| [&mut shift.difference, &mut shift.generator]);
        [&mut self.shear].into_iter().chain(of_shifts)
    }
}

/// What keeps a part with a kinetic momentum from being a shear between shifts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Unshifted {
    /// The term of `a` whose antiderivative is not known, and the momentum.
    Antiderivative(Element, NodeId),
    /// The shift of the first momentum moves the second one, which the part reads, too.
    Moved(Element, Element),
    /// After the shift, it still reads this position and this momentum.
    Conjugates(Element, Element),
}

/// A shear between shifts; no obstacle for a part without a kinetic momentum.
pub(super) fn shifted(graph: &mut Graph, energy: NodeId) -> Result<Exact, Option<Obstacle>> {
    let (mut shear, mut shifts) = (energy, Vec::<Shift>::new());
    while let Some((momentum, at)) = graph.kinetic_momentum(shear)
        && shifts.iter().all(|shift| shift.momentum != momentum)
    {
        let found = graph.without_shift(shear, momentum, at);
        // A shift by what depends on momenta would move positions, too.
        let Some((difference, rest)) = found.filter(|(a, _)| !graph.reads(*a, Part::Momentum)) else { break };
        let unknown = |term| Some(Obstacle::Shift(Unshifted::Antiderivative(momentum, term)));
        let integral = graph.antiderivative(difference, momentum.partner()).map_err(unknown)?;
        let loops = graph.loops.of_element(momentum);
        let generator = loops.iter().fold(integral, |integral, by| graph.sum(by, integral));
        // In iterations of another loop, other numbers are subtracted from the same momentum.
        if !graph.loops_of(generator).is_empty() {
            return Err(None);
        }
        shifts.push(Shift { momentum, difference, generator });
        shear = rest;
    }
    if shifts.is_empty() {
        return Err(None);
    }
    let obstacle = shifts.iter().find_map(|shift| graph.moved_by(shift, shear));
    let obstacle = obstacle.or_else(|| graph.conjugates(shear).map(|[q, p]| Unshifted::Conjugates(q, p)));
    match obstacle {
        Some(obstacle) => Err(Some(Obstacle::Shift(obstacle))),
        None => Ok(Exact::Shifted(Shifted { shear, shifts })),
    }
}

impl Graph {
    /// A momentum that is added to something that reads its position, and the sum; none that a condition decides about.
    fn kinetic_momentum(&self, energy: NodeId) -> Option<(Element, NodeId)> {
        let (mut open, mut seen) = (vec![energy], HashSet::new());
        while let Some(id) = open.pop() {
            if !seen.insert(id) || !self.is_mixed(id) {
                continue;
            }
            let mut addends = Vec::new();
            self.scaled_addends(id, &mut addends);
            let momentum = addends.iter().find_map(|addend| match self.node(*addend) {
                Node::Coordinate(p) if p.part == Part::Momentum => {
                    let reads = self.reading_any(id, p.partner());
                    addends.iter().any(|other| reads[other.position()]).then_some(p)
                }
                _ => None,
            });
            if let Some(momentum) = momentum {
                return Some((momentum, id));
            }
            let decides = |id: &NodeId| matches!(self.node(*id), Node::Select(..) | Node::Fold(..));
            open.extend(addends.into_iter().filter(|id| !decides(id)).flat_map(|id| self.node(id).children()));
        }
        None
    }

    /// What a value is the sum of, but for factors of parameters.
    fn scaled_addends(&self, id: NodeId, all: &mut Vec<NodeId>) {
        match self.node(id) {
            Node::Add(a, b) => [a, b].into_iter().for_each(|side| self.scaled_addends(side, all)),
            Node::Neg(a) => self.scaled_addends(a, all),
            Node::Mul(factor, a) | Node::Mul(a, factor) if self.is_prepared(factor) => self.scaled_addends(a, all),
            Node::Div(a, divisor) if self.is_prepared(divisor) => self.scaled_addends(a, all),
            _ => all.push(id),
        }
    }

    /// What is subtracted from a momentum in a sum, as far as it reads the position, and the energy with the momentum in
    /// place of the difference.
    fn without_shift(&mut self, energy: NodeId, momentum: Element, sum: NodeId) -> Option<(NodeId, NodeId)> {
        let coordinate = self.coordinate(momentum);
        let [of_momentum, of_position] = [momentum, momentum.partner()].map(|of| self.reading_any(energy, of));
        let known = HashMap::new();
        let mut shifting = Shifting { graph: self, coordinate, of_momentum, of_position, difference: None, known };
        let terms = shifting.terms(sum);
        let difference = shifting.subtracted(terms)?;
        shifting.difference = Some(difference);
        Some((difference, shifting.rest(energy)))
    }

    /// Whether a shift moves another momentum that a value reads.
    fn moved_by(&self, shift: &Shift, value: NodeId) -> Option<Unshifted> {
        let (positions, momenta) = (self.elements(shift.generator), self.elements(value));
        let own = [shift.momentum.partner(), shift.momentum];
        positions.iter().find_map(|q| {
            let moved = momenta.iter().find(|p| [*q, **p] != own && self.may_be_conjugates(*q, **p));
            moved.map(|p| Unshifted::Moved(shift.momentum, *p))
        })
    }
}

/// The replacement of a kinetic momentum by the momentum.
struct Shifting<'g> {
    graph: &'g mut Graph,
    coordinate: NodeId,
    /// Whether a node reads what may be the momentum or the position, by its place in the graph.
    of_momentum: Vec<bool>,
    of_position: Vec<bool>,
    /// What is subtracted from the momentum, once it is known.
    difference: Option<NodeId>,
    known: HashMap<NodeId, NodeId>,
}

/// What a sum multiplies the momentum by, its terms that read the position, and its other terms.
type Terms = [NodeId; 3];

impl Shifting<'_> {
    /// A value after the replacement.
    fn rest(&mut self, id: NodeId) -> NodeId {
        if !self.of_momentum[id.position()] {
            return id;
        }
        if let Some(known) = self.known.get(&id) {
            return *known;
        }
        let terms @ [slope, of_position, others] = self.terms(id);
        let here = self.subtracted(terms);
        let mut rest = others;
        if here.is_none() || here != self.difference {
            rest = self.graph.add(rest, of_position);
        }
        if let (Some(here), Some(difference)) = (here, self.difference) {
            let momentum =
                if here == difference { self.coordinate } else { self.graph.add(self.coordinate, difference) };
            let multiple = self.graph.mul(slope, momentum);
            rest = self.graph.add(rest, multiple);
        }
        self.known.insert(id, rest);
        rest
    }

    /// What a sum subtracts from the momentum.
    fn subtracted(&mut self, [slope, of_position, _]: Terms) -> Option<NodeId> {
        let has_momentum = self.graph.as_constant(slope) != Some(0.0);
        has_momentum.then(|| {
            let quotient = self.graph.div(of_position, slope);
            self.graph.neg(quotient)
        })
    }

    fn terms(&mut self, id: NodeId) -> Terms {
        let zero = self.graph.constant(0.0);
        let reads = [&self.of_momentum, &self.of_position].map(|reads| reads[id.position()]);
        match self.graph.node(id) {
            _ if id == self.coordinate => [self.graph.constant(1.0), zero, zero],
            _ if reads == [false; 2] => [zero, zero, id],
            Node::Add(a, b) => {
                let (a, b) = (self.terms(a), self.terms(b));
                [0, 1, 2].map(|kind| self.graph.add(a[kind], b[kind]))
            }
            Node::Neg(a) => self.terms(a).map(|terms| self.graph.neg(terms)),
            Node::Mul(factor, a) | Node::Mul(a, factor) if self.graph.is_prepared(factor) => {
                self.terms(a).map(|terms| self.graph.unless_zero(terms, |graph| graph.mul(factor, terms)))
            }
            Node::Div(a, divisor) if self.graph.is_prepared(divisor) => {
                self.terms(a).map(|terms| self.graph.unless_zero(terms, |graph| graph.div(terms, divisor)))
            }
            _ if !reads[0] => [zero, id, zero],
            _ if self.difference.is_none() => [zero, zero, id],
            node => {
                let children: HashMap<NodeId, NodeId> =
                    node.children().map(|child| (child, self.rest(child))).collect();
                [zero, zero, self.rebuilt(node.map(|child| children[&child]))]
            }
        }
    }

    /// A node with other children, after signs moved outwards and powers of powers were joined.
    fn rebuilt(&mut self, node: Node) -> NodeId {
        match node {
            Node::Power(a, halves) => self.graph.power(a, halves),
            Node::Mul(a, b) => self.graph.mul(a, b),
            node => self.graph.rebuilt(node),
        }
    }
}
