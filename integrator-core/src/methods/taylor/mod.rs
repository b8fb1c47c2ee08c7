//! Taylor's method: integration by power series of any order, with recurrences that `#[hamiltonian(taylor)]` generates.
//!
//! In: a system with generated recurrences. Out: runs at the precision of the scalar. A tolerance controls the steps,
//! and a state between two steps costs the evaluation of a polynomial. Always true: the polynomials do not depend on
//! the output times, so neither do the states.
//!
//! The method costs no compile time until it is used:
//!
//! - The recurrences are generated only if the annotation requests them.
//! - The first run costs 2 s of compile time for a pendulum, 5 s for pairs of bodies, and 150 to 400 kB of program.
//!   Each order of a pendulum and each instruction set has code of its own.
//! - The first ensemble costs 6 to 9 s and 0.4 to 0.7 MB, since lanes of each instruction set have code of their own.
//! - Error checks use the method as the exact orbit, which adds 0.3 s and 65 kB to a program that calls them.
//!
//! A polynomial describes one branch of the Hamiltonian. A step therefore ends where the orbit crosses an edge, and the
//! next step begins on the other side. Edges are:
//!
//! - a change of a condition of an `if`, `max`, `clamp` or `abs`, on coordinates or on the time;
//! - a jump of `floor`;
//! - a zero of the square root of a sum of squares. If such a root is zero at the start, the first step goes along the
//!   derivative for a tiny fraction of a step, of the size of the rounding.
//!
//! The method is not symplectic. Use it as a reference, for errors near the rounding. Its energy error does not
//! oscillate but accumulates, although slowly.
//!
//! ```
//! use integrator_core::{prelude::*, taylor::Taylor};
//!
//! struct Pendulum;
//!
//! #[hamiltonian(taylor)]
//! impl Pendulum {
//!     fn kinetic(&self, p: [f64; 1]) -> f64 {
//!         0.5 * p[0] * p[0]
//!     }
//!     fn potential(&self, q: [f64; 1]) -> f64 {
//!         -q[0].cos()
//!     }
//! }
//!
//! // The step of the run is how far apart its states are; the method takes steps of its own.
//! let mut run = Pendulum.run_with(Taylor::tolerance(1e-16), Phase::new([2.0], [0.0]), 0.01)?;
//! let energy = run.energy();
//! run.advance(100_000)?;
//! assert!((run.energy() - energy).abs() < 1e-13);
//! # Ok::<(), Error>(())
//! ```

mod access_pattern;
mod along_derivative;
pub(crate) mod edges;
mod expansion;
mod half;
#[cfg(feature = "std")]
mod in_lanes;
pub(crate) mod inverse_mass;
pub(crate) mod iterations;
mod limit;
pub(crate) mod line;
mod logarithm;
mod method;
mod rates;
mod recurrences;
mod scatter_add;
mod schedule;
mod segment;
pub(crate) mod series;
mod states;
mod step_size;
pub(crate) mod table;
mod time;
mod visit;

pub use method::Taylor;
pub use recurrences::Recurrences;
pub use visit::RecurrencesVisitor;
