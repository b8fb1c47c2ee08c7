//! Parts of `H` with an exact flow: classification of a part by its formula.

use super::{
    Element, Graph, Node, NodeId, Part,
    index::IndexId,
    kepler::{Orbits, Stray},
    quadratic::quadratic,
    same_product::FactorsOf,
    shift::{Shifted, Unshifted, shifted},
};

/// The form of a part, which its exact flow follows from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Exact {
    /// A function of the momenta alone: they stay, and the positions move along straight lines.
    OfMomenta,
    /// A function of the positions alone.
    OfPositions,
    /// A shear: whatever it reads has a conjugate that it does not read, and so stays, while these conjugates move along
    /// straight lines.
    Shear,
    /// A quadratic form in all coordinates, whose coefficients depend on parameters alone: the value that its second
    /// derivatives are taken of.
    Quadratic(NodeId),
    /// A shear between two canonical shifts.
    Shifted(Shifted),
    /// Kepler orbits about the origin, a sum over bodies.
    Kepler(Vec<Orbits>),
    /// Any: the user has written the flow.
    Own,
}

/// What keeps a part from being of a form.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Obstacle {
    /// A coordinate and its conjugate are both in it.
    Conjugates(Element, Element),
    /// It is a polynomial of this degree in all coordinates.
    Degree(u32),
    /// It is a quadratic form, but reads the time.
    Time,
    /// A sum of coordinates is multiplied by itself.
    ProductOfSums,
    /// It is no polynomial in the coordinates.
    NoPolynomial,
    /// It reads a kinetic momentum, but is no shear between shifts.
    Shift(Unshifted),
    /// It has terms `k/|q|`, but is no sum over Kepler parts; with the terms that are to blame, where these are known.
    Orbits(Stray, Vec<NodeId>),
}

/// The judgement whether a part that reads q and p is of one form; no obstacle if the part is far from it.
type Judgement = fn(&mut Graph, NodeId) -> Result<Exact, Option<Obstacle>>;

/// The judgements in their order.
const JUDGEMENTS: [Judgement; 3] = [
    |graph, energy| shear(graph, energy).map_err(Some),
    |graph, energy| quadratic(graph, energy).map_err(Some),
    shifted,
];

impl Graph {
    /// The form of a part, or for each form what keeps the part from being of it, in the order in which they are tried.
    ///
    /// `extents` is the number of numbers or points of the coordinates, and that of the components of a point;
    /// `factors_of` returns the factors of parameters.
    pub(crate) fn exact(
        &mut self,
        energy: NodeId,
        extents: &[IndexId],
        factors_of: FactorsOf<'_>,
    ) -> Result<Exact, Vec<Obstacle>> {
        match [Part::Position, Part::Momentum].map(|part| self.reads(energy, part)) {
            [false, _] => return Ok(Exact::OfMomenta),
            [_, false] => return Ok(Exact::OfPositions),
            [true, true] => {}
        }
        let mut obstacles = Vec::new();
        for judgement in JUDGEMENTS {
            match judgement(self, energy) {
                Ok(form) => return Ok(form),
                // No other form is near to a quadratic form.
                Err(_) if obstacles.last() == Some(&Obstacle::ProductOfSums) => {}
                Err(obstacle) => obstacles.extend(obstacle),
            }
        }
        match self.orbits(energy, extents, factors_of) {
            Ok(orbits) => return Ok(Exact::Kepler(orbits)),
            Err(stray) => obstacles.extend(stray.map(|(stray, terms)| Obstacle::Orbits(stray, terms))),
        }
        Err(obstacles)
    }

    /// Whether it has the flow of a shear, as functions of one part alone have.
    pub(super) fn is_shear(&self, energy: NodeId) -> bool {
        shear(self, energy).is_ok()
    }

    /// Whether two coordinates of different parts may be conjugates of each other, whatever the indices of loops are.
    pub(super) fn may_be_conjugates(&self, a: Element, b: Element) -> bool {
        let components = a.component.zip(b.component).is_none_or(|(a, b)| !self.loops.differ(a, b));
        a.part != b.part && !self.loops.differ(a.index, b.index) && components
    }

    /// The coordinates that a value reads.
    pub(super) fn elements(&self, value: NodeId) -> Vec<Element> {
        let read = self.reachable([value]).into_iter().filter_map(|id| match self.node(id) {
            Node::Coordinate(element) => Some(element),
            _ => None,
        });
        read.collect()
    }

    /// A position and a momentum that a value reads and that may be conjugates.
    pub(super) fn conjugates(&self, value: NodeId) -> Option<[Element; 2]> {
        let read = self.elements(value);
        read.iter().enumerate().find_map(|(number, a)| {
            let b = read[..number].iter().find(|b| self.may_be_conjugates(*a, **b))?;
            Some(if a.part == Part::Position { [*a, *b] } else { [*b, *a] })
        })
    }
}

/// A shear, where no coordinate that is read has a conjugate that is read.
fn shear(graph: &Graph, energy: NodeId) -> Result<Exact, Obstacle> {
    match graph.conjugates(energy) {
        Some([q, p]) => Err(Obstacle::Conjugates(q, p)),
        None => Ok(Exact::Shear),
    }
}
