//! What a course in numerical integration claims, measured and drawn for any Hamiltonian, on one page.
//!
//! ```no_run
//! use integrator_core::prelude::*;
//! use integrator_laboratory as laboratory;
//!
//! struct Duffing {
//!     stiffening: f64,
//! }
//!
//! #[hamiltonian]
//! impl Duffing {
//!     fn kinetic(&self, p: [f64; 1]) -> f64 {
//!         0.5 * p[0] * p[0]
//!     }
//!     fn potential(&self, q: [f64; 1]) -> f64 {
//!         0.5 * q[0] * q[0] + 0.25 * self.stiffening * q[0].powi(4)
//!     }
//! }
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let start = Phase::new([1.0], [0.0]);
//! let report = laboratory::report(&Duffing { stiffening: 1.0 }, start, 4.77, "target/laboratory")?;
//! println!("{}", report.page.display()); // target/laboratory/Duffing.html
//! # Ok(())
//! # }
//! ```
//!
//! The page has each method with its formula and what it conserves, portraits in steps in which gains and losses are seen,
//! energies, what symplectic steps conserve in their place, errors against the step and the work, areas, orbits there and back, limits of stability, and a table of claims:
//! what is expected, what was measured. A claim that does not hold for a system is a finding: forward Euler gains energy
//! where the potential is convex along the motion, and need not elsewhere.
//!
//! | module | holds |
//! |---|---|
//! | `laboratory` | what is asked for, and the files that it becomes |
//! | `problem`, `plan` | a system with where it starts; how much is measured |
//! | `study`, `measured` | all that is measured, of a system and of a method |
//! | `methods`, `rows` | the methods; what is said of each |
//! | `blob`, `errors`, `limits`, `modified`, `portrait`, `reversal`, `shifted` | one measurement each |
//! | `claims` | claims, each with the number that decides it |
//! | `pictures`, `page` | what is drawn and written; `formula` makes MathML, `numbers` plain numbers |

mod admitted;
mod blob;
mod claims;
mod errors;
mod extrapolation;
mod formula;
mod laboratory;
mod limits;
mod measured;
mod methods;
mod modified;
mod numbers;
mod page;
mod pictures;
mod plan;
mod portrait;
mod problem;
mod reversal;
mod rows;
mod shifted;
mod study;
mod tangents;
#[cfg(test)]
mod tests;

pub use claims::Verdict;
pub use laboratory::{Drawing, Laboratory, Report, report, write};
pub use numbers::{plain, signed};
pub use plan::Plan;
pub use rows::colour;

/// The program of the README.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
