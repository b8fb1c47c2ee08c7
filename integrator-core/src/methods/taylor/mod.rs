//! The Taylor method: the multiderivative method of any order, with recurrences that `#[hamiltonian(taylor)]` writes.
//!
//! In: a system whose recurrences are generated. Out: runs at the precision of the scalar, whose steps are chosen by a
//! tolerance and whose states between them cost an evaluation of a polynomial. Always true: the polynomials do not
//! depend on where a run is looked at, so that its states do not either.
//!
//! Nothing of it is written unless the annotation asks for it, and what is written costs no time to build until a run
//! is by this method: its first one takes the compiler 2 s for a pendulum and 5 s for pairs of bodies, and 150 to 400
//! kB of program, because each order of a pendulum and each instruction set has code of its own; the first ensemble
//! takes 6 to 9 s and 0.4 to 0.7 MB, since there is code for lanes of each instruction set. Checks of errors
//! take their exact motion from it, which adds 0.3 s and 65 kB to a program that calls them.
//!
//! A polynomial follows the branch that its beginning is in. So a step ends where the motion crosses an edge: where a
//! condition of an `if`, `max`, `clamp` or `abs` changes, on coordinates or on the time, where `floor` jumps, or where the
//! root of a sum of squares is zero. The next step begins on the other side. Where such a root begins at zero, the first step goes along
//! the derivative for a rounding of a step.
//!
//! It is not symplectic: it is the reference, the method for errors near the rounding, and what symplectic runs are
//! held against. Its energy error does not oscillate but accumulates, however slowly.
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
