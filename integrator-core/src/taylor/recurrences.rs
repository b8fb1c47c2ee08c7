//! What `#[hamiltonian(taylor)]` writes.

use super::series::Series;
use crate::{hamiltonian::Hamiltonian, real::Real};

/// A Hamiltonian with recurrences for the Taylor coefficients of its motion. Written by `#[hamiltonian(taylor)]`.
#[diagnostic::on_unimplemented(
    message = "no recurrences were written for `{Self}`",
    label = "has no Taylor series",
    note = "they are only written where they are asked for: `#[hamiltonian(taylor)]`"
)]
pub trait Recurrences: Hamiltonian {
    /// The coefficients that recurrences read.
    type Tape<R: Real>: Clone + Default + Send + Sync + 'static;

    /// Adds `k + 1` times the coefficients of order `k + 1` of all coordinates to what is there, from those of lower orders.
    ///
    /// Coordinates are flat; `length` is how many numbers or points they are. `time` is that of the expansion.
    fn order<R: Real>(
        parameters: &Self::Parameters<R>,
        length: usize,
        q: &mut [Series<R>],
        p: &mut [Series<R>],
        tape: &mut Self::Tape<R>,
        k: usize,
        time: f64,
    );
}
