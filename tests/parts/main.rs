//! Splits into more than two parts, into symmetric pairs, into parts that take inner steps and into coupled copies of the
//! state: the orders of compositions, against hand-written flows and closed forms.

#[path = "../../integrator-core/src/composition/catalogue_list.rs"]
mod catalogue;
#[path = "../support/derivatives.rs"]
mod derivatives;
mod doubled;
mod inner_counts;
mod inner_kinds;
mod inner_orders;
mod inner_runs;
mod inner_steps;
#[path = "../support/instruction_sets.rs"]
mod instruction_sets;
mod many_parts;
mod pairs;
mod pairs_in_parts;
mod shifts;
#[path = "../support/slope.rs"]
mod slope;
mod time;
