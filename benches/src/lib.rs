//! Shared code of the benches: systems, hand-written steppers, interleaved timing, tables and pictures.
//!
//! | module | contents |
//! |---|---|
//! | [`problems`], [`starts`] | systems and initial states |
//! | [`by_hand`] | hand-written steppers, over the vectors of `vector`, `x86`, `functions`, reached through `enter` |
//! | [`plan`] | a composition as numbers, for hand-written steppers |
//! | [`race`] | interleaved computations, medians and ratios |
//! | [`precision`] | work against error |
//! | [`plot`] | pictures |
//! | [`table`] | plain tables and CSV |
//! | [`counts`] | instructions per step, stored and measured |

#![allow(clippy::needless_range_loop, reason = "formulas number their axes, and closures are compiled without vectors")]

#[cfg(feature = "by_hand")]
pub mod by_hand;
pub mod counts;
#[cfg(feature = "by_hand")]
mod enter;
#[cfg(feature = "by_hand")]
pub mod functions;
#[cfg(feature = "by_hand")]
pub mod plan;
pub mod plot;
pub mod precision;
pub mod problems;
pub mod race;
pub mod starts;
pub mod table;
#[cfg(feature = "by_hand")]
pub mod vector;
#[cfg(all(feature = "by_hand", target_arch = "x86_64"))]
mod x86;

#[cfg(feature = "by_hand")]
pub use enter::Instructions;
