//! Friction and noise: compositions with the letter `O`.
//!
//! In: a system with a rate of friction for each coordinate, and perhaps a temperature. Out: runs whose steps apply the flows
//! of `T`, `V` and `O` in the order of a composition. `O` multiplies momenta by `exp(-γt)` and, with a temperature, adds
//! normally distributed numbers: the exact solution of the Ornstein–Uhlenbeck process. Always true: a random number depends
//! only on the seed, the member, the step, the stage and the coordinate.

mod applied;
mod apply;
pub(crate) mod catalogue;
mod factors;
mod metropolis;
mod motion;
mod rates;
mod scheme;
mod steps;

pub use metropolis::{Metropolis, Metropolised};
pub use motion::{Damped, DampedOf, FrictionConstants};
pub use rates::are_rates;
pub use scheme::{FrictionScheme, Letter, facts_with_friction};
pub use steps::steps_with_friction;
