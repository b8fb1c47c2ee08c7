//! Saving the samples of a run: as CSV, as NPZ for NumPy, or by a function of your own.
//!
//! Comes in: the samples of a run, or its crossings, or whatever iterator adaptors leave of them. Goes out: one record
//! for each, and how many there are.
//!
//! Always true: numbers read back equal, bit for bit; if the run fails, everything up to there is written, and the
//! error comes with the count. Of [compensated](crate::Compensated) coordinates the value is written and not the error
//! that it carries.
//!
//! ```
//! use integrator_core::{output, prelude::*};
//!
//! struct Oscillator;
//!
//! #[hamiltonian]
//! impl Oscillator {
//!     fn kinetic(&self, p: [f64; 1]) -> f64 { p[0] * p[0] / 2.0 }
//!     fn potential(&self, q: [f64; 1]) -> f64 { q[0] * q[0] / 2.0 }
//! }
//!
//! let run = Oscillator.run(Phase::new([1.0], [0.0]), 0.25)?;
//! let mut table = Vec::new(); // or a file
//! output::csv(run.samples(4).take(2), &mut table)?;
//! let text = String::from_utf8(table)?;
//! assert!(text.starts_with("t,q0,p0,energy\n0.0,1.0,0.0,0.5\n1.0,0.5"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod each;
mod npz;
mod table;

pub use each::{OutputError, each};
pub use npz::npz;
pub use table::csv;
