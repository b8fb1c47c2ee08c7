//! The orbits that could not be solved.

use crate::error::Unsolved;
use alloc::{sync::Arc, vec::Vec};

/// The first fault of each lane. Always true: nothing is stored as long as all orbits were solved.
#[derive(Clone, Default)]
pub(crate) struct Faults(Option<Arc<Vec<Option<Unsolved>>>>);

impl Faults {
    /// Returns the fault of a lane.
    pub(crate) fn of_lane(&self, lane: usize) -> Option<&Unsolved> {
        self.0.as_ref()?.get(lane)?.as_ref()
    }

    /// Copies the faults of other motions.
    #[inline(always)]
    pub(crate) fn copy(&mut self, from: &Self) {
        if self.0.is_some() || from.0.is_some() {
            self.replace(from);
        }
    }

    #[cold]
    #[inline(never)]
    fn replace(&mut self, from: &Self) {
        self.0.clone_from(&from.0);
    }

    /// Notes the faults of lanes that have none yet.
    #[cold]
    #[inline(never)]
    pub(crate) fn note(&mut self, lanes: usize, fault: &dyn Fn(usize) -> Option<Unsolved>) {
        let mut faults = self.0.as_ref().map_or_else(Vec::new, |faults| Vec::clone(faults));
        faults.resize(lanes, None);
        for (lane, noted) in faults.iter_mut().enumerate() {
            if noted.is_none() {
                *noted = fault(lane);
            }
        }
        self.0 = Some(Arc::new(faults));
    }
}
