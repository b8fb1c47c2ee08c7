//! Parts of H whose exact flow is known: the judgement of a part by its formula.

use super::{Graph, NodeId, Part};

/// The form of a part, which its exact flow follows from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Exact {
    /// A function of the momenta alone: they stay, and the positions move along straight lines.
    OfMomenta,
    /// A function of the positions alone.
    OfPositions,
}

impl Graph {
    /// The form of a part, or for each form what keeps the part from being of it, in the order in which they are tried.
    pub(crate) fn exact(&self, energy: NodeId) -> Result<Exact, Vec<String>> {
        match [Part::Position, Part::Momentum].map(|part| self.reads(energy, part)) {
            [false, true] => Ok(Exact::OfMomenta),
            [true, false] => Ok(Exact::OfPositions),
            _ => Err(vec!["it depends on q and p".to_owned()]),
        }
    }
}
