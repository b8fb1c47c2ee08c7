//! Parts of `H` with an exact flow: classification of a part by its formula.

use super::{
    Element, Graph, Node, NodeId, Part,
    index::IndexId,
    kepler::{Orbits, Stray},
    quadratic::quadratic,
    same_product::FactorsOf,
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
    /// It has terms `k/|q|`, but is no sum over Kepler parts; with the terms that are to blame, where these are known.
    Orbits(Stray, Vec<NodeId>),
}

/// The judgement whether a part that reads q and p is of one form.
type Judgement = fn(&Graph, NodeId) -> Result<Exact, Obstacle>;

/// The judgements in their order.
const JUDGEMENTS: [Judgement; 2] = [shear, quadratic];

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
                Err(obstacle) => obstacles.push(obstacle),
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
    fn may_be_conjugates(&self, a: Element, b: Element) -> bool {
        let components = a.component.zip(b.component).is_none_or(|(a, b)| !self.loops.differ(a, b));
        a.part != b.part && !self.loops.differ(a.index, b.index) && components
    }
}

/// A shear, where no coordinate that is read has a conjugate that is read.
fn shear(graph: &Graph, energy: NodeId) -> Result<Exact, Obstacle> {
    let read = graph.reachable([energy]).into_iter().filter_map(|id| match graph.node(id) {
        Node::Coordinate(element) => Some(element),
        _ => None,
    });
    let read: Vec<_> = read.collect();
    for (number, a) in read.iter().enumerate() {
        if let Some(b) = read[..number].iter().find(|b| graph.may_be_conjugates(*a, **b)) {
            let [q, p] = if a.part == Part::Position { [*a, *b] } else { [*b, *a] };
            return Err(Obstacle::Conjugates(q, p));
        }
    }
    Ok(Exact::Shear)
}
