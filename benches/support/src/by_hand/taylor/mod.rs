//! Taylor integrators by hand, for the five problems: the yardsticks of the recurrences that `#[hamiltonian(taylor)]`
//! writes.
//!
//! They take the steps of the generated ones (Jorba and Zou's rule, up to a few per cent of a step), with the same
//! orders and compensated states, so that their errors are the same and times alone differ.
//!
//! | file | holds |
//! |---|---|
//! | `course` | the way along a trajectory, from polynomial to polynomial |
//! | `horizon` | how far a polynomial reaches, in integers |
//! | `weights` | the powers of a step by which coefficients of accelerations move a state |
//! | `estrin` | polynomials of the small ones |
//! | `pendulum` | sine and cosine side by side |
//! | `planar` | what the next two have in common: two coordinates side by side |
//! | `henon_heiles` | a star |
//! | `kepler` | a planet, with a tide |
//! | `bodies` | the outer solar system: pairs in the lanes of two registers |
//! | `springs` | the chain of 32 sites: bonds in the lanes of four registers and one |
//!
//! What they have in common: Newton's equations make the coefficients of positions from those of accelerations two
//! orders below, so that momenta have none, two orders at a time are computed from what was there before, each
//! coefficient that is read serves both, and the end of a step is a sum over accelerations with weights that are the same
//! for all coordinates, instead of Horner's chain.

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
