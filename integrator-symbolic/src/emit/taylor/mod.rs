//! Rust code for the recurrences of Taylor coefficients.

mod accumulation;
pub(super) mod edges;
mod implementation;
mod kernel;
mod line;
pub(super) mod orders;
mod orders_per_call;
mod pairs;
mod recurrence;
mod second_order;
mod tape;
mod unrolled;
mod writer;
