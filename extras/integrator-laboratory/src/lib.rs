//! Measures and plots the results of a course on numerical integration, for any Hamiltonian, on one page.
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
//! The page contains for each method:
//!
//! - its formula and the quantities that it conserves;
//! - phase portraits, with steps large enough to show gains and losses of energy;
//! - energies, and the modified energies that symplectic steps conserve;
//! - errors against the step and against the work;
//! - areas, orbits forward and back, stability limits.
//!
//! A table lists the claims, each with the expected and the measured number. A claim that fails for a system is a
//! result: forward Euler gains energy if the potential is convex along the orbit, but not necessarily otherwise.
//!
//! | module | content |
//! |---|---|
//! | `laboratory` | the options, and the files that are written |
//! | `problem`, `plan` | a system with its start; the amount of measurements |
//! | `study`, `measured` | all measurements, of a system and of a method |
//! | `methods`, `rows` | the methods and their descriptions |
//! | `adaptive`, `blob`, `brackets`, `errors`, `limits`, `modified`, `portrait`, `reversal`, `shifted` | one measurement each |
//! | `models` | model problems, the same for all systems: `linear` maps, `multistep` roots, the `radius` of series, `gear` |
//! | `roots`, `equations` | roots of polynomials; the derived equations in the symbols of the page |
//! | `claims` | claims, each with the number that decides it |
//! | `pictures`, `page` | pictures and pages; `formula` writes MathML, `numbers` formats numbers |

mod adaptive;
mod admitted;
mod blob;
mod brackets;
mod claims;
mod equations;
mod errors;
mod extrapolation;
mod formula;
mod gear;
mod laboratory;
mod limits;
mod linear;
mod measured;
mod methods;
mod models;
mod modified;
mod multistep;
mod numbers;
mod page;
mod pictures;
mod plan;
mod portrait;
mod problem;
mod radius;
mod reversal;
mod roots;
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
