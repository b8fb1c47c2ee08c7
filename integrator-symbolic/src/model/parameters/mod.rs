//! Expressions of parameters: their tokens, and the loops and conditions around them.

mod choices;
mod classes;
mod composed;
pub(crate) mod entries;
mod extremes;
pub(crate) mod factors;
mod flags;
mod joined;
mod membership;
mod multiples;
pub(crate) mod numbers;
pub(crate) mod parameter_text;
pub(crate) mod prepared;
pub(crate) mod presence;
pub(crate) mod ragged;
pub(crate) mod running_index;
pub(crate) mod text;
