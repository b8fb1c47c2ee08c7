//! The library as a user sees it: annotated Hamiltonians run, and what they do is measured.
//!
//! All of it holds on every instruction set. A process uses one, so [`instruction_sets`] runs these tests again in a
//! process for each of the others.

mod axis;
#[macro_use]
mod beside_pairs;
mod by_hand;
#[path = "../../integrator-core/src/composition/catalogue_list.rs"]
mod catalogue;
mod changed_states;
mod conditions_on_indices;
mod densities;
mod divergence;
mod ends_of_loops;
mod energies_in_lanes;
mod ensemble;
mod ensemble_checkpoints;
mod ensemble_times;
mod external;
mod first_bodies;
mod generic;
mod in_lanes;
#[path = "../support/instruction_sets.rs"]
mod instruction_sets;
mod invariants;
mod kepler;
mod layouts;
mod limits;
mod lists_of_lists;
mod measured_order;
mod orders;
mod pace;
mod pace_checkpoints;
mod pace_domain;
mod pace_driven;
mod pairs;
mod pairs_in_parts;
mod panics;
mod parts;
mod pieces;
mod precision;
mod pythagorean;
mod refusals;
mod reversible;
mod semantics;
mod sides;
#[path = "../support/slope.rs"]
mod slope;
mod squares;
mod systems;
mod time_dependent;
mod triplets;
mod units;
