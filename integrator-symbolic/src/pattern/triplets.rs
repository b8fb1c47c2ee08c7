//! Terms of a body and two others: the functions of three bodies that the runtime sums.

use super::{
    all_pairs::Listed,
    bodies::{Constants, OfBodies},
};
use crate::{
    differentiate::gradient,
    graph::{
        NodeId, Part,
        index::{Index, LoopId},
    },
    model::Model,
    pairs::Triplets,
    reason::Reason,
};

/// Terms of a body and two others within a cutoff.
pub(crate) struct TripletsOfBodies {
    /// The gradient of the energy by the coordinates of one of the others, and then by those of the other one.
    pub(crate) force: OfBodies,
    pub(crate) energy: OfBodies,
    /// The cutoff around the body in the middle.
    pub(crate) cutoff: Listed,
    /// The energy as a node.
    pub(super) written: NodeId,
}

impl TripletsOfBodies {
    pub(super) fn of(
        model: &mut Model,
        constants: &mut Constants,
        bodies: LoopId,
        dimension: u64,
        Triplets { bodies: three, energy, cutoff }: &Triplets,
    ) -> Result<Self, Reason> {
        let mut force = Vec::new();
        for mut contribution in gradient(&mut model.graph, *energy, Part::Position) {
            let loops = &mut model.graph.loops;
            let of = three.iter().position(|by| loops.index(contribution.element.index) == Index::Running(*by));
            let place = match contribution.element.component {
                None => 0,
                Some(component) => loops.literal(component).ok_or(Reason::TripletReads)?,
            };
            // The gradient by the body in the middle follows from both others.
            let first = match of.ok_or(Reason::TripletReads)? {
                0 => continue,
                1 => 0,
                _ => dimension,
            };
            contribution.element.index = loops.intern(Index::Running(bodies));
            contribution.element.component = Some(loops.intern(Index::Literal(first + place)));
            force.push(contribution);
        }
        Ok(Self {
            force: OfBodies::gradient(model, constants, three, &force)?,
            energy: OfBodies::value(model, constants, three, *energy)?,
            cutoff: Listed::of(model, constants, bodies, cutoff)?,
            written: *energy,
        })
    }
}
