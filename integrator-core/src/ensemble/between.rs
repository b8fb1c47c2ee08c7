//! The states of members between the steps of an ensemble.

use crate::{
    state::{coords::Coords, point::Point},
    trajectory::run::Run,
};
use alloc::{boxed::Box, vec::Vec};
use core::any::Any;

/// The states that an ensemble shows between its steps, without the type of the coordinates, so that it is compiled
/// once.
pub(crate) struct Between {
    pub(crate) time: f64,
    /// The state of each member that is shown, if the member is in progress.
    pub(super) members: Vec<Option<Shown>>,
}

/// A member between two steps of its own.
pub(super) struct Shown {
    pub(super) state: Box<dyn Point>,
    /// The run of the member alone, where it has taken more steps than all have together.
    pub(super) ahead: Option<Box<dyn Any + Send + Sync>>,
}

impl Between {
    fn shown(&self, member: usize) -> Option<&Shown> {
        self.members.get(member)?.as_ref()
    }

    pub(crate) fn state(&self, member: usize) -> Option<&dyn Point> {
        Some(&*self.shown(member)?.state)
    }

    pub(super) fn ahead<C: Coords>(&self, member: usize) -> Option<&Run<C>> {
        self.shown(member)?.ahead.as_deref()?.downcast_ref()
    }
}
