//! Edges: the surfaces in phase space at which the formula of a Hamiltonian changes.
//!
//! In: the polynomials of a step, and generated code that evaluates the conditions of the Hamiltonian. Out: the time at
//! which the motion crosses the first edge, where the step has to end. Always true: conditions are enclosed by interval
//! arithmetic over whole ranges of time, so that no crossing between two times is missed; the outcome depends on the
//! polynomials alone.

mod observer;
mod polynomials;
mod search;

pub use observer::{Level, Watch};
pub(super) use search::{Edge, Search};

use super::table::Coefficients;
use crate::scalar::{dual::Dual, interval::Interval};
use observer::Observer;
pub(super) use polynomials::Polynomials;

/// An enclosure of a value and of its derivative with respect to time.
pub(super) type Enclosure = Dual<Interval>;

/// The number of lanes of an enclosure: the bounds of the value and of the derivative.
pub(super) const BOUNDS: usize = 4;

/// Evaluates the conditions at these positions and momenta and at this time.
pub(super) type Conditions<'c> =
    dyn Fn(&Coefficients<'_, Enclosure>, &Coefficients<'_, Enclosure>, Enclosure, &mut dyn Watch<Enclosure>) + 'c;
