//! The compositions of this crate: declared by their coefficients, proved when the crate compiles.
//!
//! Coefficients without a closed form have 36 digits, and the proof holds them to 31. One drift and one kick are left to
//! the macro as `_`, so that the sums are 1 by construction.
//!
//! Where to begin: [`Verlet`] at loose tolerances; for quadratic `T` then [`BlanesMoanSrkn6`], [`BlanesMoanSrkn11`] and
//! [`Teloy8C`]; for every other `T` [`BlanesMoan4`], [`BlanesMoan6`], [`SofroniouSpaletta8`] and
//! [`SofroniouSpaletta10`], in order of tighter tolerances.

mod basic;
mod general;
mod gradient;
mod near_integrable;
mod nystrom;
mod processed;
mod symmetric;

pub use basic::*;
pub use general::*;
pub use gradient::*;
pub use near_integrable::*;
pub use nystrom::*;
pub use processed::*;
pub use symmetric::*;
