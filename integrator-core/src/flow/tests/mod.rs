//! Tests of exact flows, by systems that have them.

#[cfg(all(feature = "check", feature = "checkpoint"))]
mod doubled;
