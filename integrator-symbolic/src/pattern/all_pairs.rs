//! All pairs: the motion of a body, and the force of one body on another, for systems with pair interactions.

use super::{
    bodies::{Constants, OfBodies},
    stores::stores,
};
use crate::{
    differentiate::{Contribution, fold_branches},
    graph::{NodeId, Part, Scope, index::LoopId, rename::End},
    model::{Model, Texts},
    pairs::{Cutoff, Pairs, cutoff, pairs, per_body, pull},
    program::{Sink, Store, is_direct},
};

/// The fewest bodies whose neighbours within a cutoff are listed: with fewer, all pairs of a liquid are as fast.
pub(crate) const LISTED_FROM: u64 = 384;

/// The fewest bodies, where their number is known, whose pairs are summed apart from other terms, and in order where they may
/// not be exchanged: fewer are as fast as written, and devices keep them in registers.
const APART_FROM: u64 = 33;

/// A potential of pairs with a kinetic energy of bodies.
pub(crate) struct AllPairs {
    /// The loops over the two bodies of a pair.
    pub(crate) pair: [LoopId; 2],
    /// The ends at which these bodies have no partner.
    pub(crate) ends: [Option<End>; 2],
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
    /// The terms of the potential that are neither of pairs nor of bodies alone.
    pub(crate) others: Option<Others>,
    /// The condition under which neighbours within a cutoff are listed.
    pub(crate) listed: Option<Listed>,
}

/// Terms beside pairs, in the user's own coordinates.
pub(crate) struct Others {
    /// Their energy.
    pub(crate) energy: NodeId,
    /// Its gradient, collected in a buffer; empty where they do not depend on positions.
    pub(crate) gradient: Vec<Store>,
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
        let (in_jacobi, count) = (model.jacobi().is_some(), model.shape.length.literal());
        let fewer_than = |bound| count.is_some_and(|count| count < bound);
        let are_many = !in_jacobi && !fewer_than(APART_FROM);
        let Model { graph, parameters, running, kinetic, potential, lengths, root, .. } = &mut *model;
        let mut texts = Texts::new(parameters, running, root);
        let length = *lengths.first()?;
        let Pairs { bodies, pair, ends, energy, written, force, reciprocal, energy_alone, alone, others } =
            pairs(graph, *potential, length, are_many, &mut texts)?;
        let (energy_of_others, others) = others;
        let velocity = per_body(graph, *kinetic, length, Part::Momentum, &mut texts)?;
        let velocity = fold_branches(graph, &velocity);
        if velocity.is_empty() || force.is_empty() || !is_direct(&model.graph.loops, &velocity) {
            return None;
        }
        Texts::new(&mut model.parameters, &mut model.running, &model.root).name_in_place(bodies, pair[0], &pair);

        let cutoff = match in_jacobi || fewer_than(LISTED_FROM) {
            true => None,
            false => {
                let Model { graph, parameters, running, root, .. } = &mut *model;
                let mut texts = Texts::new(parameters, running, root);
                cutoff(graph, written, (pair, ends), bodies, dimension, &mut texts)
            }
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
        let others = match model.graph.as_constant(energy_of_others) {
            Some(0.0) => None,
            _ => Some(Others { energy: energy_of_others, gradient: stores(model, &others, Sink::Collect) }),
        };
        let listed = match cutoff {
            None => None,
            Some(cutoff) => {
                let energies = [energy, energy_alone];
                Some(Listed::of(model, &mut constants, bodies, pair, &cutoff, energies)?)
            }
        };
        Some(Self { pair, ends, dimension, constants, drift, acts, force, central, reciprocal, alone, others, listed })
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
