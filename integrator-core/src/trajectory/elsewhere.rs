//! Runs of which something else knows a part of the state: what they have in the middle of the current step, for a
//! slab of a long lattice, which receives its ends from others.

use crate::{
    state::{coords::Coords, phase::Phase},
    trajectory::{
        checkpoint::{CheckpointError, Stored},
        run::Run,
    },
};

/// The state of a run in the middle of the current step.
pub fn unfinished<C: Coords>(run: &Run<C>) -> Phase<C> {
    run.unfinished_lane(0)
}

/// Returns the number of position components in a checkpoint.
///
/// # Errors
/// Bytes that are no checkpoint.
pub fn positions_in(checkpoint: &[u8]) -> Result<usize, CheckpointError> {
    Ok(Stored::of_bytes(checkpoint)?.record.q.len())
}

/// Returns the start time of the clock, and the number of steps after which the state was last changed from outside.
pub fn began<C: Coords>(run: &Run<C>) -> (f64, u64) {
    (run.clock.t0, run.opened)
}

/// Sets the state of a run after this number of steps, since its state was changed after `opened` of them.
pub fn go_on_from<C: Coords>(run: &mut Run<C>, steps: u64, opened: u64, state: &Phase<C>) {
    run.show_step();
    (run.clock.steps, run.opened) = (steps, opened);
    run.resume_lanes(state, &[]);
}
