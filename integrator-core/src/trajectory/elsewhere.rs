//! Runs of which something else knows a part of the state: what they have in the middle of the step under way, for whoever
//! moves a slab of a long lattice and learns its ends from others.

use crate::{
    state::{coords::Coords, phase::Phase},
    trajectory::run::Run,
};
use core::slice;

/// The state of a run in the middle of the step under way.
pub fn unfinished<C: Coords>(run: &Run<C>) -> Phase<C> {
    run.unfinished_lane(0)
}

/// Lets a run go on from such a state after so many steps.
pub fn go_on_from<C: Coords>(run: &mut Run<C>, steps: u64, state: &Phase<C>) {
    run.show_step();
    run.clock.steps = steps;
    run.resume_lanes(slice::from_ref(state));
}
