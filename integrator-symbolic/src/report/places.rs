//! What flows and energies compute, by what it is computed for.
//!
//! In: gradients and energies with their pattern. Out: the operations of the functions that are generated for them. Always
//! true: the lines are scheduled here as they are for generated code.

use super::{Each, Place};
use crate::{
    differentiate::Contribution,
    graph::{Graph, Node, NodeId, Part, Tally, index::LoopSet},
    model::{Model, is_leaf},
    pattern::{
        Pattern,
        all_pairs::AllPairs,
        bodies::OfBodies,
        sites, stencil_of_energy,
        stores::{lower_roots, passes},
    },
    program::{
        Constraints, Program, Sink, Store, schedule_with,
        tally::{Around, ByScopes, Counting},
    },
    prose,
    stencil::Stencil,
};

/// The drift and the kick, along these gradients.
pub(super) fn of_flows(model: &mut Model, gradients: [&[Contribution]; 2], pattern: &Pattern) -> [Vec<Place>; 2] {
    match pattern {
        Pattern::AllPairs(pairs) => of_bodies(model, pairs),
        Pattern::Sites(stencils) => [Part::Momentum, Part::Position].map(|part| {
            let number = usize::from(part == Part::Position);
            let mut found = Found::default();
            match &stencils[number] {
                Some(stencil) => found.add_sites(model, stencil),
                None => {
                    for pass in passes(model, gradients[number], part) {
                        found.add(model, Each::Iterations, &pass.stores);
                    }
                }
            }
            found.places(model)
        }),
    }
}

/// The energies `T` and `V`.
pub(super) fn of_energies(model: &mut Model, energies: [NodeId; 2], pattern: &Pattern) -> [Vec<Place>; 2] {
    let mut places = [energies[0], energies[1]].map(|energy| of_energy(model, energy, pattern));
    if let Pattern::AllPairs(pairs) = pattern
        && let Some(of_bodies) = &pairs.energies
    {
        let mut potential = Found::default();
        potential.add_bodies(model, Each::Pairs, &of_bodies.pair, Tally { additions: 1, ..Tally::default() });
        if let Some(alone) = &of_bodies.alone {
            potential.add_bodies(model, Each::Bodies, alone, Tally { additions: 1, ..Tally::default() });
        }
        potential.add_beside(model, pairs.others.as_ref().map(|others| others.energy));
        places[1] = potential.places(model);
        if let Some(beside) = of_bodies.kinetic_beside {
            let mut kinetic = Found::default();
            // Half the sum of the products of momenta and velocities.
            let products = Tally { multiplications: pairs.dimension, ..Tally::default() };
            if let Some(drift) = &pairs.drift {
                kinetic.add_bodies(model, Each::Bodies, drift, products);
            }
            kinetic.add_beside(model, Some(beside));
            places[0] = kinetic.places(model);
        }
    }
    // Nothing moves: contributions are added up.
    for place in places.iter_mut().flatten() {
        place.operations.additions += std::mem::take(&mut place.operations.coordinates);
    }
    places
}

fn of_energy(model: &mut Model, energy: NodeId, pattern: &Pattern) -> Vec<Place> {
    let mut found = Found::default();
    let of_flow = match pattern {
        Pattern::Sites([_, Some(stencil)]) => Some(sites::lowered(model, stencil)),
        _ => None,
    };
    match of_flow.and_then(|of_flow| stencil_of_energy(model, energy, &of_flow)) {
        Some(stencil) => found.add_sites(model, &stencil),
        None => found.add_value(model, energy),
    }
    found.places(model)
}

/// The flows of bodies that act on each other in pairs.
fn of_bodies(model: &Model, pairs: &AllPairs) -> [Vec<Place>; 2] {
    let (mut drift, mut kick, none) = (Found::default(), Found::default(), Tally::default);
    if let Some(of_body) = &pairs.drift {
        drift.add_bodies(model, Each::Bodies, of_body, none());
    }
    // The runtime multiplies the displacement by a central force, and adds the reaction.
    let mut beside = Tally::default();
    if pairs.central {
        beside.multiplications += pairs.dimension;
        beside.coordinates += pairs.dimension;
    }
    if pairs.reciprocal {
        beside.coordinates += pairs.dimension;
    }
    let each = if pairs.reciprocal { Each::Pairs } else { Each::OrderedPairs };
    kick.add_bodies(model, each, &pairs.force, beside);
    if let Some(alone) = &pairs.alone {
        kick.add_bodies(model, Each::Bodies, alone, none());
    }
    if let Some(embedded) = &pairs.embedded {
        kick.add_bodies(model, Each::OrderedPairs, &embedded.densities, none());
        kick.add_bodies(model, Each::Bodies, &embedded.weights, none());
    }
    if let Some(others) = &pairs.others {
        kick.add(model, Each::Iterations, &others.gradient);
    }
    [drift.places(model), kick.places(model)]
}

/// The operations found so far.
#[derive(Default)]
struct Found(Vec<(Each, ByScopes)>);

impl Found {
    fn add(&mut self, model: &Model, each: Each, stores: &[Store]) {
        let program = schedule_with(
            &model.graph,
            stores,
            |graph, id| is_leaf(graph, &model.parameters, id),
            &Constraints::default(),
        );
        self.add_program(model, each, &program.hoisted(&model.graph));
    }

    fn add_value(&mut self, model: &mut Model, value: NodeId) {
        let value = lower_roots(model, &[value])[0];
        self.add(model, Each::Iterations, &[Store { context: Vec::new(), sink: Sink::Return, value }]);
    }

    /// An energy that is added to those of bodies and pairs.
    fn add_beside(&mut self, model: &mut Model, energy: Option<NodeId>) {
        if let Some(energy) = energy.filter(|energy| model.graph.as_constant(*energy) != Some(0.0)) {
            self.add_runtime(Each::Iterations, Tally { additions: 1, ..Tally::default() });
            self.add_value(model, energy);
        }
    }

    /// What the runtime does itself.
    fn add_runtime(&mut self, each: Each, operations: Tally) {
        self.0.push((each, ByScopes::from([(Around::default(), operations)])));
    }

    fn add_sites(&mut self, model: &mut Model, stencil: &Stencil) {
        let stencil = sites::lowered(model, stencil);
        let around: Vec<_> = stencil.directions.iter().map(|along| along.place).collect();
        let leaf = |graph: &_, id| is_leaf(graph, &model.parameters, id);
        let program = schedule_with(&model.graph, &sites::stores(&stencil), leaf, &Constraints::default());
        self.add_program(model, Each::Sites, &program.hoisted(&model.graph).within(&around));
    }

    /// A function of bodies, with what the runtime does beside it.
    fn add_bodies(&mut self, model: &Model, each: Each, of: &OfBodies, beside: Tally) {
        let leaf =
            |graph: &Graph, id| matches!(graph.node(id), Node::Coordinate(_)) || is_leaf(graph, &model.parameters, id);
        let constraints = Constraints { selects: true, ..Constraints::default() };
        let program = schedule_with(&model.graph, &of.stores, leaf, &constraints);
        let program = program.hoisted(&model.graph).within(&of.of);
        self.add_program(model, each, &program);
        self.add_runtime(each, beside);
    }

    fn add_program(&mut self, model: &Model, each: Each, program: &Program) {
        let Model { graph, parameters, externals, .. } = model;
        let counting = Counting {
            graph,
            leaf: &|id| is_leaf(graph, parameters, id),
            external: &|id| externals[id.0 as usize].to_string(),
        };
        let mut found = ByScopes::new();
        counting.add(program, &mut found);
        self.0.push((each, found));
    }

    /// The operations in words, those of equal words together.
    fn places(self, model: &Model) -> Vec<Place> {
        let mut places: Vec<Place> = Vec::new();
        let all = self.0.into_iter().flat_map(|(each, found)| found.into_iter().map(move |(at, of)| (each, at, of)));
        for (each, Around { loops, conditions }, operations) in all {
            if operations == Tally::default() {
                continue;
            }
            let loops: Vec<_> = loops.iter().flat_map(|by| prose::ranges(model, LoopSet::of(*by))).collect();
            let conditions =
                conditions.iter().filter_map(|(id, holds)| prose::condition_of_indices(model, *id, *holds));
            let mut conditions: Vec<_> = conditions.collect();
            conditions.dedup();
            let is_here =
                |known: &&mut Place| (known.each, &known.loops, &known.conditions) == (each, &loops, &conditions);
            match places.iter_mut().find(is_here) {
                Some(known) => known.operations.add(operations),
                None => places.push(Place { each, loops, conditions, operations }),
            }
        }
        places
    }
}
