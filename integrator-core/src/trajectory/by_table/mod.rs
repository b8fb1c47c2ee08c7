//! Any composition by one loop: its table is a value that the loop reads, and not a constant that it was compiled for.
//!
//! In: the stages of a composition that may integrate a system. Out: the same steps to the last bit, of a method for checks, which go
//! through the whole catalogue, and of systems with large flows. Always true: flows are compiled for a system and not for each of its
//! compositions, so that a program that goes through the whole catalogue compiles about as much as for one of them.

mod letters;
#[cfg(feature = "check")]
mod method;
pub(crate) mod slopes;
mod walk;

#[cfg(feature = "check")]
pub(crate) use method::{ByTable, WithGradients};

use crate::{
    composition::Scheme,
    scalar::real::Real,
    state::{clock::Clock, precision::Precision},
    system::{System, flows::Flows},
    trajectory::{
        by_table::{
            letters::Table,
            walk::{Portion, walk},
        },
        step_functions::Executor,
    },
};

/// Kicks of the potential alone.
pub(crate) struct Plain;

/// The way in which kicks of a table are applied.
pub(crate) trait Kicks<H: System>: Send + Sync + 'static {
    /// Whether there are kicks with gradients.
    const GRADIENTS: bool;
    /// The flow of `duration·V + gradient·|∇V|²`.
    fn gradient_kick(flows: &mut impl Flows<H>, duration: f64, gradient: f64, time: f64);
}

impl<H: System> Kicks<H> for Plain {
    const GRADIENTS: bool = false;
    #[inline(always)]
    fn gradient_kick(_: &mut impl Flows<H>, _: f64, _: f64, _: f64) {}
}

/// Takes this number of steps with motions of [large flows](System::LARGE_FLOWS), by a composition without force
/// gradients.
pub(super) fn advance<H: System, X: Scheme, R: Real, K: Precision, E: Executor>(
    motions: &mut [H::Motion<R, K>],
    clock: Clock,
    steps: u64,
    threads: Option<usize>,
) {
    for motion in motions {
        walk::<H, Plain, R, K, E>(motion, Table::of::<H, X>(), clock, Portion::Steps(steps), threads);
    }
}

/// Completes the current step, or undoes the processor after it, in the same way.
pub(super) fn end<H: System, X: Scheme, R: Real, K: Precision, E: Executor, const SHOWN: bool>(
    motion: &mut H::Motion<R, K>,
    clock: Clock,
    threads: Option<usize>,
) {
    let portion = if SHOWN { Portion::Undoing } else { Portion::Closing };
    walk::<H, Plain, R, K, E>(motion, Table::of::<H, X>(), clock, portion, threads);
}
