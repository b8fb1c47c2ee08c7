//! Python modules of your own Hamiltonian systems.
//!
//! [`module!`] makes a Python module of a type with `#[hamiltonian]`. Its fields become keyword arguments, states become
//! NumPy arrays, and errors become exceptions. `maturin develop --release` installs the module.
//!
//! ```
//! use integrator_core::prelude::*;
//! use serde::{Deserialize, Serialize};
//!
//! #[derive(Clone, Deserialize, Serialize)]
//! struct Galaxy {
//!     core: f64,
//!     flattening: f64,
//! }
//!
//! #[hamiltonian(compose = BlanesMoanSrkn11)]
//! impl Galaxy {
//!     fn kinetic(&self, p: [f64; 3]) -> f64 {
//!         (p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) / 2.0
//!     }
//!     fn potential(&self, q: [f64; 3]) -> f64 {
//!         (self.core.powi(2) + q[0] * q[0] + q[1] * q[1] + (q[2] / self.flattening).powi(2)).ln() / 2.0
//!     }
//! }
//!
//! integrator_python::module! {
//!     /// A flattened logarithmic potential. Unit of velocities: the circular velocity at large radii.
//!     galaxy: Galaxy
//! }
//! ```
//!
//! The page on Python in the guide shows the Python side.

mod arrays;
mod ensemble;
mod errors;
mod expression;
mod interrupt;
mod methods;
mod module;
mod parameters;
mod python;
mod run;
mod system;

pub use methods::Row;
pub use module::Contents;
pub use parameters::Parameters;
pub use pyo3;
pub use python::system::PySystem as System;
pub use system::{Exported, Function};
