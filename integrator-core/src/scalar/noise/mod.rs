//! Random numbers by counter, for steps with noise.
//!
//! Comes in: a key of a run and a counter for each lane. Goes out: words or standard normal numbers. Always true: a number
//! depends on its key and its counter only, not on numbers drawn before it, on threads or on the width of vectors.

mod gaussian;
mod philox;
#[cfg(test)]
mod tests;

pub(crate) use gaussian::{Counter, gaussians};
#[cfg(test)]
use philox::philox;
