//! What `#[hamiltonian(taylor)]` writes.

use super::table::Coefficients;
use crate::{hamiltonian::Hamiltonian, scalar::real::Real};

/// A Hamiltonian with recurrences for the Taylor coefficients of its motion. Written by `#[hamiltonian(taylor)]`.
#[diagnostic::on_unimplemented(
    message = "no recurrences were written for `{Self}`",
    label = "has no Taylor series",
    note = "they are only written where they are asked for: `#[hamiltonian(taylor)]`"
)]
pub trait Recurrences: Hamiltonian {
    /// The coefficients that recurrences read.
    type Tape<R: Real>: Default + Send + Sync + 'static;

    /// Whether there are loops over coordinates, so that orders need no code of their own.
    const ROLLED: bool;

    /// Whether every iteration of the loops reads coordinates of its own first, so that whole registers are read where
    /// points are dealt out to registers.
    const INTERLEAVED: bool;

    /// How many orders are found at once.
    const AT_ONCE: usize;

    /// Finds the coefficients of order `k + 1` of all coordinates from those of lower orders, and those of the orders
    /// behind it that are found at once.
    ///
    /// `length` is how many numbers or points the coordinates are. `time` is that of the expansion.
    fn order<R: Real>(
        parameters: &Self::Parameters<R>,
        length: usize,
        q: &mut Coefficients<'_, R>,
        p: &mut Coefficients<'_, R>,
        tape: &mut Self::Tape<R>,
        k: usize,
        time: R,
    );
}
