//! Numbers from a normal distribution.

use std::f64::consts::TAU;

/// Returns a number from the normal distribution with mean 0 and variance 1 (Box and Muller 1958).
pub(crate) fn normal(random: &mut fastrand::Rng) -> f64 {
    // The first number is never zero.
    (-2.0 * (1.0 - random.f64()).ln()).sqrt() * (TAU * random.f64()).cos()
}
