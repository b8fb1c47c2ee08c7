//! Hand-written Taylor integrators for the five problems. The benches compare them with the code that
//! `#[hamiltonian(taylor)]` generates.
//!
//! They take the same steps as the generated integrators (rule of Jorba and Zou, up to a few per cent), with the same
//! orders and compensated states. Errors are therefore equal, and only times differ.
//!
//! | file | contents |
//! |---|---|
//! | `course` | integration along a trajectory, from polynomial to polynomial |
//! | `horizon` | step size, in integer arithmetic |
//! | `weights` | powers of a step that multiply the coefficients of accelerations |
//! | `estrin` | polynomials of the small systems |
//! | `pendulum` | sine and cosine in two lanes |
//! | `planar` | common code of the next two: two coordinates in two lanes |
//! | `henon_heiles` | the Hénon–Heiles system |
//! | `kepler` | Kepler's problem, with a tidal tensor |
//! | `bodies` | the outer solar system: pairs in the lanes of two registers |
//! | `springs` | the chain of 32 sites: bonds in the lanes of four registers and one |
//!
//! Common to all:
//!
//! - Newton's equations give the coefficients of positions from those of accelerations two orders below, so momenta
//!   have no coefficients of their own.
//! - Two orders at a time are computed from the known ones, so each coefficient is loaded once for both.
//! - The end of a step is a weighted sum of accelerations with the same weights for all coordinates, instead of
//!   Horner's scheme.

pub(crate) mod bodies;
pub(crate) mod course;
pub(crate) mod estrin;
pub(crate) mod henon_heiles;
pub(crate) mod horizon;
pub(crate) mod kepler;
pub(crate) mod pendulum;
pub(crate) mod planar;
pub(crate) mod springs;
pub(crate) mod weights;

pub use bodies::solar;
pub use course::{Course, ORDERS};
pub use henon_heiles::henon_heiles;
pub use kepler::kepler;
pub use pendulum::pendulum;
pub use springs::chain;
