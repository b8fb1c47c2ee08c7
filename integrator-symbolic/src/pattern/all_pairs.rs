//! All pairs: the motion of a body, and the force of one body on another, for systems with pair interactions.

use super::{
    bodies::{Constants, OfBodies},
    stores::stores,
    triplets::TripletsOfBodies,
};
use crate::{
    differentiate::{Contribution, fold_branches, gradient},
    graph::{
        Element, Graph, Node, NodeId, ParameterId, Part, Scope,
        index::{Index, IndexId, LoopId},
    },
    model::{Length, Model, Texts},
    pairs::{
        Cutoff, Density, Embedded, Pairs, Visited, acting, moving, over_all, pairs, per_body, points, pull,
        with_one_form, written_out,
    },
    program::{Sink, Store, is_direct, lanes::FEWEST_COORDINATES},
    reason::Reason,
};
use std::collections::BTreeSet;

/// The fewest bodies whose neighbours within a cutoff are listed: with fewer, all pairs of a liquid are as fast.
pub(crate) const LISTED_FROM: u64 = 384;

/// The fewest bodies, where their number is known, whose pairs are summed apart from other terms, and in order where they may
/// not be exchanged: fewer are as fast as written, and devices keep them in registers.
const APART_FROM: u64 = 33;

/// The most bodies whose state is one row.
pub(crate) const ROW: u64 = 8;

/// A potential of pairs with a kinetic energy of bodies.
pub(crate) struct AllPairs {
    /// The loops over the two bodies of a pair.
    pub(crate) pair: [LoopId; 2],
    /// All loops over these bodies in the user's text.
    pub(crate) visited: Vec<Visited>,
    /// How many coordinates a body has.
    pub(crate) dimension: u64,
    /// What is prepared of each body.
    pub(crate) constants: Constants,
    /// What the flow of `T` does to a body; `None` of a part of H that has no `T`.
    pub(crate) drift: Option<OfBodies>,
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
    /// The energies of bodies that depend on sums over their partners.
    pub(crate) embedded: Option<EmbeddedOfBodies>,
    /// The terms of a body and two others within a cutoff.
    pub(crate) triplets: Option<TripletsOfBodies>,
    /// Why a sum over a body and two others is among other terms.
    pub(crate) triplet_obstacle: Option<Reason>,
    /// The terms of the potential that are neither of pairs nor of bodies alone.
    pub(crate) others: Option<Others>,
    /// The energies of pairs and bodies; `None` if bodies are one row or in Jacobi coordinates, or energies read more of a body
    /// than forces do.
    pub(crate) energies: Option<EnergiesOfBodies>,
    /// The condition under which neighbours within a cutoff are listed, or why they are not.
    pub(crate) listed: Result<Listed, Reason>,
    /// Which pairs lists do not leave out.
    pub(crate) included: Option<Included>,
    /// How many bodies there are.
    pub(crate) of: Bodies,
    /// The constant that is the number of a body, where pairs do nothing but compare it with that of the other body.
    pub(crate) number: Option<usize>,
}

/// Terms beside pairs, in the user's own coordinates.
pub(crate) struct Others {
    /// Their energy.
    pub(crate) energy: NodeId,
    /// Its gradient, collected in a buffer; empty where they do not depend on positions.
    pub(crate) gradient: Vec<Store>,
}

/// How many bodies there are, if not as many as coordinates.
pub(crate) struct Bodies {
    /// The number of components of a point, where coordinates are flat.
    pub(crate) flat: Option<u64>,
    /// How many bodies act on each other, if not all.
    pub(crate) acting: Option<First>,
    /// How many bodies the flow of `T` moves, if not all.
    pub(crate) moving: Option<First>,
}

/// The first bodies, as many as a number of the system.
#[derive(Clone, Copy, PartialEq)]
pub(crate) struct First {
    pub(crate) number: ParameterId,
    /// Whether there may be fewer bodies.
    pub(crate) or_all: bool,
}

impl First {
    /// The bodies that loops to this end run over; `None` for all. `Err` if the end is not a supported number of bodies.
    fn of(model: &Model, end: IndexId, all: IndexId) -> Result<Option<Self>, ()> {
        let loops = &model.graph.loops;
        let found = match loops.index(end) {
            _ if end == all => return Ok(None),
            _ if !matches!(model.shape.length, Length::OfStart) => None,
            Index::Parameter(number) => Some(Self { number, or_all: false }),
            Index::Min(a, b) => [a, b].into_iter().find_map(|end| match loops.index(end) {
                Index::Parameter(number) => Some(Self { number, or_all: true }),
                _ => None,
            }),
            _ => None,
        };
        found.map(Some).ok_or(())
    }
}

/// The energies of bodies.
struct Energies {
    kinetic: NodeId,
    potential: NodeId,
    /// How many coordinates a body has.
    dimension: u64,
    /// The number of bodies.
    all: IndexId,
    /// Whether the coordinates of the user are flat.
    is_flat: bool,
}

impl Energies {
    /// The energies in the user's coordinates, if these are points or numbers.
    fn of(model: &Model) -> Option<Self> {
        let dimension = match &model.shape.inner[..] {
            [] => 1,
            [dimension] => dimension.literal()?,
            _ => return None,
        };
        let (kinetic, potential, all) = (model.kinetic, model.potential, *model.lengths.first()?);
        Some(Self { kinetic, potential, dimension, all, is_flat: false })
    }

    /// The energies of points whose coordinates are flat.
    fn of_flat(model: &mut Model) -> Option<Self> {
        let is_short = model.shape.numbers().is_some_and(|numbers| numbers < FEWEST_COORDINATES);
        if is_short || !model.shape.inner.is_empty() || model.jacobi().is_some() {
            return None;
        }
        let dimension = points::components(&model.graph, model.potential)?;
        if model.shape.numbers().is_some_and(|numbers| numbers % dimension != 0) {
            return None;
        }
        let Model { graph, parameters, running, kinetic, potential, lengths, root, .. } = &mut *model;
        let length = *lengths.first()?;
        let mut texts = Texts::new(parameters, running, root);
        let mut of = |energy| points::of_points(graph, energy, dimension, length, &mut texts);
        let (kinetic, potential) = (of(*kinetic)?, of(*potential)?);
        let all = points::number_of_points(graph, length, dimension);
        Some(Self { kinetic, potential, dimension, all, is_flat: true })
    }
}

impl AllPairs {
    /// That of a model, if its potential is one of pairs and its kinetic energy one of bodies.
    pub(crate) fn of(model: &mut Model) -> Result<Self, Reason> {
        let of_flat = match Energies::of_flat(model) {
            Some(energies) => Self::with(model, &energies),
            None => Err(Reason::BodyShape),
        };
        of_flat.or_else(|of_flat| {
            let energies = Energies::of(model).ok_or(Reason::BodyShape)?;
            // If flat coordinates are points, the obstacle is that of the points.
            Self::with(model, &energies).map_err(|reason| if of_flat == Reason::BodyShape { reason } else { of_flat })
        })
    }

    fn with(model: &mut Model, energies: &Energies) -> Result<Self, Reason> {
        let &Energies { kinetic, potential, dimension, all, is_flat } = energies;
        let (in_jacobi, count) = (model.jacobi().is_some(), model.graph.loops.literal(all));
        // A body alone has no pairs.
        if count.is_some_and(|count| count < 2) {
            return Err(Reason::OneBody);
        }
        let fewer_than = |bound| count.is_some_and(|count| count < bound);
        let are_many = !in_jacobi && !fewer_than(APART_FROM);
        let acting = acting(&model.graph, potential, all)?;
        let has_kinetic = model.graph.as_constant(kinetic) != Some(0.0);
        let moving = if has_kinetic { moving(&model.graph, kinetic, all).ok_or(Reason::Kinetic)? } else { all };
        let [first_acting, first_moving] = [acting, moving].map(|end| First::of(model, end, all));
        let first_acting = first_acting.map_err(|()| Reason::Unrecognised)?;
        let first_moving = first_moving.map_err(|()| Reason::Unrecognised)?;
        let is_length = !is_flat && first_acting.is_none();
        let Model { graph, parameters, running, root, .. } = &mut *model;
        let mut texts = Texts::of_bodies(parameters, running, root, is_length);
        let mut potential = written_out(graph, potential, &mut texts);
        // The energies of other bodies are those that the user writes, which evaluate a condition as forces do.
        let reads_middle = |graph: &Graph, roots: &[NodeId]| {
            graph.reachable(roots.iter().copied()).into_iter().any(|id| graph.node(id) == Node::Middle)
        };
        if !in_jacobi && !fewer_than(LISTED_FROM) && !reads_middle(graph, &[potential, kinetic]) {
            potential = with_one_form(graph, potential, &mut texts);
        }
        let listed_dimension = match (in_jacobi, fewer_than(LISTED_FROM)) {
            (true, _) => Err(Reason::ListsInJacobi),
            (_, true) => Err(Reason::FewBodiesForLists),
            (false, false) => Ok(dimension),
        };
        let Pairs {
            bodies,
            pair,
            visited,
            cutoff,
            included,
            energy,
            force,
            reciprocal,
            energy_alone,
            alone,
            embedded,
            triplets,
            triplet_obstacle,
            others,
        } = pairs(graph, potential, acting, are_many, listed_dimension, &mut texts)?;
        let (mut energy_of_others, mut others) = others;
        if is_flat {
            energy_of_others = points::of_numbers(graph, energy_of_others, dimension);
            others = gradient(graph, energy_of_others, Part::Position);
        }
        let per_body = per_body(graph, kinetic, moving, Part::Momentum, &mut texts);
        let (kinetic, kinetic_beside, velocity) = per_body.ok_or(Reason::Kinetic)?;
        let velocity = fold_branches(graph, &velocity);
        if has_kinetic && (velocity.is_empty() || !is_direct(&graph.loops, &velocity)) {
            return Err(Reason::Kinetic);
        }
        if force.is_empty() && triplets.is_none() {
            return Err(Reason::Unrecognised);
        }
        let [every, moved] = [all, moving].map(|end| over_all(graph, end));
        let mut texts = Texts::new(&mut model.parameters, &mut model.running, &model.root);
        for by in BTreeSet::from([bodies, every, moved]) {
            texts.name_in_place(by, pair[0], &pair);
        }

        let mut constants = Constants::new(every);
        let embedded = match &embedded.densities[..] {
            [] => None,
            _ => Some(EmbeddedOfBodies::of(model, &mut constants, bodies, dimension, &embedded)?),
        };
        let drift = match has_kinetic {
            true => Some(OfBodies::new(model, &mut constants, &[moved], &velocity, Sink::Update)?),
            false => None,
        };
        let acts = match condition(&force) {
            None => None,
            Some((condition, holds)) => Some((OfBodies::value(model, &mut constants, &pair, condition)?, holds)),
        };
        let pull = match &force[..] {
            [] => None,
            force => pull(&mut model.graph, pair, force, dimension),
        };
        let central = pull.is_some();
        let force = match pull {
            Some(pull) => OfBodies::value(model, &mut constants, &pair, pull)?,
            None => OfBodies::gradient(model, &mut constants, &pair, &force)?,
        };
        let alone = match &alone[..] {
            [] => None,
            alone => Some(OfBodies::gradient(model, &mut constants, &[bodies], alone)?),
        };
        let triplets = match &triplets {
            None => None,
            Some(triplets) => Some(TripletsOfBodies::of(model, &mut constants, bodies, dimension, triplets)?),
        };
        let of_triplet = triplets.as_ref().map(|triplets| triplets.written);
        let others = match model.graph.as_constant(energy_of_others) {
            Some(0.0) => None,
            _ => Some(Others { energy: energy_of_others, gradient: stores(model, &others, Sink::Collect) }),
        };
        let listed = match cutoff {
            Err(reason) => Err(reason),
            Ok(cutoff) => Ok(Listed::of(model, &mut constants, bodies, &cutoff)?),
        };
        // Steps read conditions on the time in their middle, energies at their own time.
        let energies = match in_jacobi || fewer_than(ROW + 1) {
            false
                if !reads_middle(&model.graph, &[energy, energy_alone, energy_of_others])
                    && !of_triplet.is_some_and(|energy| reads_middle(&model.graph, &[energy])) =>
            {
                let has_form =
                    has_kinetic && model.graph.is_form_of_momenta(kinetic) && !reads_middle(&model.graph, &[kinetic]);
                let of_densities =
                    embedded.as_ref().map_or(energy_alone, |embedded| model.graph.add(energy_alone, embedded.energy));
                let (known, of_pair, of_body) = (constants.count(), (pair, energy), (bodies, of_densities));
                let found =
                    EnergiesOfBodies::of(model, &mut constants, of_pair, of_body, has_form.then_some(kinetic_beside));
                // What energies alone read would make the data of every force longer.
                let found = found.ok().filter(|_| listed.is_ok() || constants.count() == known);
                if found.is_none() {
                    constants.nodes.truncate(known);
                }
                found
            }
            _ => None,
        };
        let shared = constants.count();
        let included = match included {
            None => None,
            Some(condition) => {
                let condition = OfBodies::value(model, &mut constants, &pair, condition)?;
                Some(Included { condition, own: constants.count() - shared })
            }
        };
        let of = Bodies { flat: is_flat.then_some(dimension), acting: first_acting, moving: first_moving };
        let of_pairs = [
            Some(&force),
            acts.as_ref().map(|(acts, _)| acts),
            energies.as_ref().map(|energies| &energies.pair),
            embedded.as_ref().map(|embedded| &embedded.densities),
        ];
        let of_pairs: Vec<_> = of_pairs.into_iter().flatten().collect();
        let of_one = energies.iter().flat_map(|energies| &energies.alone);
        let of_three = triplets.iter().flat_map(|triplets| [&triplets.force, &triplets.energy]);
        let weights = embedded.iter().map(|embedded| &embedded.weights);
        let of_lists = included.iter().map(|included| &included.condition);
        let of_bodies: Vec<_> =
            drift.iter().chain(&alone).chain(of_one).chain(of_three).chain(weights).chain(of_lists).collect();
        let number = constants.number(&model.graph, &of_pairs, &of_bodies);
        Ok(Self {
            pair,
            visited,
            dimension,
            constants,
            drift,
            acts,
            force,
            central,
            reciprocal,
            alone,
            embedded,
            triplets,
            triplet_obstacle,
            others,
            energies,
            listed,
            included,
            of,
            number,
        })
    }

    /// That of a part of H that is a function of positions, if its energy is a sum over pairs of many bodies. A part that reads the
    /// middle of the step, which its rows do not have, is none.
    pub(crate) fn of_part(model: &mut Model, energy: NodeId) -> Option<Self> {
        let graph = &mut model.graph;
        let reads_middle = graph.reachable([energy]).into_iter().any(|id| graph.node(id) == Node::Middle);
        let is_short = model.shape.numbers().is_some_and(|numbers| numbers < APART_FROM);
        if reads_middle || is_short {
            return None;
        }
        let zero = graph.constant(0.0);
        let whole = [std::mem::replace(&mut model.kinetic, zero), std::mem::replace(&mut model.potential, energy)];
        let pairs = Self::of(model).ok();
        [model.kinetic, model.potential] = whole;
        pairs
    }

    /// Whether all bodies act on each other, and their number is the length of the coordinates.
    pub(crate) fn are_of_length(&self) -> bool {
        self.of.flat.is_none() && self.of.acting.is_none()
    }
}

/// The pairs that lists do not leave out.
pub(crate) struct Included {
    /// The condition, which reads no coordinates.
    pub(crate) condition: OfBodies,
    /// The number of constants of a body that nothing else reads, the last ones.
    pub(crate) own: usize,
}

/// The condition under which neighbours within a cutoff are listed.
pub(crate) struct Listed {
    /// The square of the cutoff.
    pub(crate) square: OfBodies,
    /// The sides of the box.
    pub(crate) sides: Option<OfBodies>,
}

/// The energies of pairs and of bodies, whose sums are the runtime's.
pub(crate) struct EnergiesOfBodies {
    /// The energy of a pair.
    pub(crate) pair: OfBodies,
    /// The potential energy of a body alone.
    pub(crate) alone: Option<OfBodies>,
    /// What the kinetic energy is beside those of bodies, a number of the system, if these follow from velocities.
    pub(crate) kinetic_beside: Option<NodeId>,
}

impl EnergiesOfBodies {
    fn of(
        model: &mut Model,
        constants: &mut Constants,
        (pair, energy): ([LoopId; 2], NodeId),
        (bodies, alone): (LoopId, NodeId),
        kinetic_beside: Option<NodeId>,
    ) -> Result<Self, Reason> {
        let is_alone = model.graph.as_constant(alone) != Some(0.0);
        Ok(Self {
            pair: OfBodies::value(model, constants, &pair, energy)?,
            alone: match is_alone {
                true => Some(OfBodies::value(model, constants, &[bodies], alone)?),
                false => None,
            },
            kinetic_beside,
        })
    }
}

/// Sums over the partners of a body, and the energies that depend on these.
pub(crate) struct EmbeddedOfBodies {
    /// What the second body of a pair adds to each.
    pub(crate) densities: OfBodies,
    /// The derivatives of the energies by each.
    pub(crate) weights: OfBodies,
    /// The energies.
    energy: NodeId,
}

impl EmbeddedOfBodies {
    fn of(
        model: &mut Model,
        constants: &mut Constants,
        bodies: LoopId,
        dimension: u64,
        embedded: &Embedded,
    ) -> Result<Self, Reason> {
        let Embedded { energies, densities } = embedded;
        let pair = densities.first().ok_or(Reason::NoPairs)?.pair;
        if densities.len() as u64 > dimension || densities.iter().any(|density| density.pair != pair) {
            return Err(Reason::Densities);
        }
        let (mut addends, mut weights) = (Vec::new(), Vec::new());
        for (place, Density { number, addend, .. }) in (0..).zip(densities) {
            constants.keep_density(model, *number, bodies).ok_or(Reason::Densities)?;
            let loops = &mut model.graph.loops;
            let index = loops.intern(Index::Running(bodies));
            let component = (dimension > 1).then(|| loops.intern(Index::Literal(place)));
            let element = Element { part: Part::Position, index, component };
            let weight = embedded.weight(&mut model.graph, *number).ok_or(Reason::Densities)?;
            addends.push(Contribution { context: Vec::new(), element, value: *addend });
            weights.push(Contribution { context: Vec::new(), element, value: weight });
        }
        let energy = energies.iter().copied().reduce(|sum, energy| model.graph.add(sum, energy));
        Ok(Self {
            densities: OfBodies::new(model, constants, &pair, &addends, Sink::Assign)?,
            weights: OfBodies::new(model, constants, &[bodies], &weights, Sink::Assign)?,
            energy: energy.ok_or(Reason::Densities)?,
        })
    }
}

impl Listed {
    pub(super) fn of(
        model: &mut Model,
        constants: &mut Constants,
        bodies: LoopId,
        Cutoff { square, sides }: &Cutoff,
    ) -> Result<Self, Reason> {
        Ok(Self {
            square: OfBodies::value(model, constants, &[], *square)?,
            sides: match &sides[..] {
                [] => None,
                sides => Some(OfBodies::new(model, constants, &[bodies], sides, Sink::Assign)?),
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
