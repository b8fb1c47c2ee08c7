//! Splits into more than two parts, into symmetric pairs and into coupled copies of the state: the orders of compositions,
//! against hand-written flows and closed forms.

mod doubled;
mod inner_steps;
mod many_parts;
mod pairs;
#[path = "../support/slope.rs"]
mod slope;
mod time;
