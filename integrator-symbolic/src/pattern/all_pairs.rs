//! All pairs: the motion of a body, and the force of one body on another, for systems with pair interactions.

use super::bodies::{Constants, OfBodies};
use crate::{
    differentiate::{Contribution, fold_branches},
    graph::{NodeId, Part, Scope, index::LoopId},
    model::{Model, Texts},
    pairs::{Cutoff, Pairs, cutoff, pairs, per_body, pull},
    program::{Sink, is_direct},
};

/// The fewest bodies whose neighbours within a cutoff are listed: with fewer, all pairs of a liquid are as fast.
pub(crate) const LISTED_FROM: u64 = 384;

/// A potential of pairs with a kinetic energy of bodies.
pub(crate) struct AllPairs {
    /// The loops over the two bodies of a pair.
    pub(crate) pair: [LoopId; 2],
    /// How many coordinates a body has.
    pub(crate) dimension: u64,
    /// What is prepared of each body.
    pub(crate) constants: Constants,
    /// What the flow of `T` does to a body.
    pub(crate) drift: OfBodies,
    /// Whether a pair interacts, and whether that condition has to hold.
    pub(crate) acts: Option<(OfBodies, bool)>,
    /// The gradient of the energy of a pair by the coordinates of its first body, or what their displacement is to be multiplied by.
    pub(crate) force: OfBodies,
    /// Whether it is that factor.
    pub(crate) central: bool,
    /// Whether action is reaction.
    pub(crate) reciprocal: bool,
    /// The gradient of what a body has alone.
    pub(crate) alone: Option<OfBodies>,
    /// The condition under which neighbours within a cutoff are listed.
    pub(crate) listed: Option<Listed>,
}

impl AllPairs {
    /// That of a model, if its potential is one of pairs and its kinetic energy one of bodies.
    pub(crate) fn of(model: &mut Model) -> Option<Self> {
        let dimension = match &model.shape.inner[..] {
            [] => 1,
            [dimension] => dimension.literal()?,
            _ => return None,
        };
        // A body alone has no pairs.
        if model.shape.length.literal().is_some_and(|length| length < 2) {
            return None;
        }
        let Model { graph, parameters, running, kinetic, potential, lengths, .. } = &mut *model;
        let mut texts = Texts::new(parameters, running);
        let length = *lengths.first()?;
        let Pairs { bodies, pair, energy, force, reciprocal, energy_alone, alone } =
            pairs(graph, *potential, length, &mut texts)?;
        let velocity = per_body(graph, *kinetic, length, Part::Momentum, &mut texts)?;
        let velocity = fold_branches(graph, &velocity);
        if velocity.is_empty() || force.is_empty() || !is_direct(&model.graph.loops, &velocity) {
            return None;
        }
        Texts::new(&mut model.parameters, &mut model.running).name_in_place(bodies, pair[0], &pair);

        let few = model.shape.length.literal().is_some_and(|length| length < LISTED_FROM);
        let cutoff = match few || model.jacobi().is_some() {
            true => None,
            false => cutoff(&mut model.graph, energy, pair, bodies, dimension),
        };
        let mut constants = Constants::new(bodies);
        let drift = OfBodies::new(model, &mut constants, &[bodies], &velocity, Sink::Update)?;
        let acts = match condition(&force) {
            None => None,
            Some((condition, holds)) => Some((OfBodies::value(model, &mut constants, &pair, condition)?, holds)),
        };
        let pull = pull(&mut model.graph, pair, &force, dimension);
        let central = pull.is_some();
        let force = match pull {
            Some(pull) => OfBodies::value(model, &mut constants, &pair, pull)?,
            None => OfBodies::gradient(model, &mut constants, &pair, &force)?,
        };
        let alone = match &alone[..] {
            [] => None,
            alone => Some(OfBodies::gradient(model, &mut constants, &[bodies], alone)?),
        };
        let listed = match cutoff {
            None => None,
            Some(cutoff) => {
                let energies = [energy, energy_alone];
                Some(Listed::of(model, &mut constants, bodies, pair, &cutoff, energies)?)
            }
        };
        Some(Self { pair, dimension, constants, drift, acts, force, central, reciprocal, alone, listed })
    }
}

/// The condition under which neighbours within a cutoff are listed.
pub(crate) struct Listed {
    /// The square of the cutoff.
    pub(crate) square: OfBodies,
    /// The sides of the box.
    pub(crate) sides: Option<OfBodies>,
    /// The energy of a pair.
    pub(crate) energy: OfBodies,
    /// That of a body alone.
    pub(crate) energy_alone: Option<OfBodies>,
}

impl Listed {
    fn of(
        model: &mut Model,
        constants: &mut Constants,
        bodies: LoopId,
        pair: [LoopId; 2],
        Cutoff { square, sides }: &Cutoff,
        [energy, energy_alone]: [NodeId; 2],
    ) -> Option<Self> {
        let is_alone = model.graph.as_constant(energy_alone) != Some(0.0);
        Some(Self {
            square: OfBodies::value(model, constants, &[], *square)?,
            sides: match &sides[..] {
                [] => None,
                sides => Some(OfBodies::new(model, constants, &[bodies], sides, Sink::Assign)?),
            },
            energy: OfBodies::value(model, constants, &pair, energy)?,
            energy_alone: match is_alone {
                true => Some(OfBodies::value(model, constants, &[bodies], energy_alone)?),
                false => None,
            },
        })
    }
}

/// The condition that a whole gradient is under, if there is one, and whether it has to hold.
fn condition(gradient: &[Contribution]) -> Option<(NodeId, bool)> {
    let outermost = |contribution: &Contribution| match contribution.context.first() {
        Some(Scope::Branch(condition, holds)) => Some((*condition, *holds)),
        _ => None,
    };
    let first = outermost(gradient.first()?)?;
    gradient.iter().all(|contribution| outermost(contribution) == Some(first)).then_some(first)
}
