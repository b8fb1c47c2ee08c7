//! The recurrences of Taylor coefficients as Rust.

mod ahead;
mod implementation;
mod moves;
mod nest;
pub(super) mod orders;
mod pass;
mod recurrence;
mod tape;
mod unrolled;
