//! Saving the samples of a run: as CSV, as NPZ for NumPy, or by a function of your own.
//!
//! The functions accept samples, crossings, and iterator adaptors of both. They write one record for each sample and return
//! the number of records.
//!
//! - Numbers that are read back are bitwise identical.
//! - If the run fails, all samples before are written, and the error contains their number.
//! - For [compensated](crate::Compensated) coordinates, the value is written without its correction.
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
pub use table::{csv, csv_with_names};
