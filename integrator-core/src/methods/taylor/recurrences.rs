//! The interface of generated recurrences.

use super::{edges::Watch, table::Coefficients};
use crate::{scalar::real::Real, system::System};

/// A Hamiltonian with recurrences for the Taylor coefficients of its motion. Written by `#[hamiltonian(taylor)]`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no Taylor recurrences",
    label = "generated without `taylor`",
    note = "write `#[hamiltonian(taylor)]` to generate them"
)]
pub trait Recurrences: System {
    /// The coefficients that recurrences read.
    type Tape<R: Real>: Default + Send + Sync + 'static;

    /// Whether one function serves all orders, since there are loops over coordinates or the code of each order is long.
    const ROLLED: bool;

    /// Whether every iteration of the loops reads coordinates of its own first, so that iterations read whole vectors
    /// where points are distributed over vectors cyclically.
    const INTERLEAVED: bool;

    /// The number of orders that a call computes.
    const ORDERS_PER_CALL: usize;

    /// Computes the coefficients of order `order + 1` of all coordinates from those of lower orders, and of the next
    /// ones up to `ORDERS_PER_CALL`.
    ///
    /// `length` is the number of numbers or points. `time` is that of the expansion.
    fn order<R: Real>(
        parameters: &Self::Parameters<R>,
        length: usize,
        q: &mut Coefficients<'_, R>,
        p: &mut Coefficients<'_, R>,
        tape: &mut Self::Tape<R>,
        order: usize,
        time: R,
    );

    /// Whether the formula changes at edges, where a step has to end.
    const HAS_EDGES: bool = false;

    /// Shows `watch` the conditions of the Hamiltonian at a state, whose coordinates are the coefficients of order 0, and
    /// evaluates what depends on them on the sides that `watch` answers with.
    fn edges<R: Real>(
        _parameters: &Self::Parameters<R>,
        _length: usize,
        _q: &Coefficients<'_, R>,
        _p: &Coefficients<'_, R>,
        _time: R,
        _watch: &mut dyn Watch<R>,
    ) {
    }
}
