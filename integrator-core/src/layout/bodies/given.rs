//! The state that a motion was loaded from, where its coordinates are not the user's own: the map there and back rounds.

use crate::state::{coords::Coords, phase::Phase, precision::Precision};
use alloc::{sync::Arc, vec::Vec};

/// The user's states of all lanes, positions before momenta. Always true: they are there until the first flow, and from there
/// on no more, so that the motion shows what was given bit for bit as long as nothing has moved it.
#[derive(Clone)]
pub(super) struct Given<K>(Option<Arc<[Vec<K>]>>);

impl<K> Default for Given<K> {
    fn default() -> Self {
        Self(None)
    }
}

impl<K: Precision> Given<K> {
    /// The states in lanes.
    pub(super) fn of<C: Coords<Leaf = K>>(states: &[&Phase<C>]) -> Self {
        let mut lanes = Vec::with_capacity(states.len());
        for state in states {
            let (q, p) = (state.q.flat(), state.p.flat());
            let mut lane = Vec::with_capacity(q.len() + p.len());
            lane.extend_from_slice(q);
            lane.extend_from_slice(p);
            lanes.push(lane);
        }
        Self(Some(lanes.into()))
    }

    /// The states in lanes of others; none, where one of these has moved.
    pub(super) fn gathered(lanes: &[(&Self, usize)]) -> Self {
        let mut states = Vec::with_capacity(lanes.len());
        for (given, lane) in lanes {
            let Some(given) = &given.0 else { return Self(None) };
            states.push(given[*lane].clone());
        }
        Self(Some(states.into()))
    }

    /// Writes the state of a lane, if it is still there.
    pub(super) fn show<C: Coords<Leaf = K>>(&self, lane: usize, to: &mut Phase<C>) -> bool {
        let Some(lanes) = &self.0 else { return false };
        let (q, p) = (to.q.flat_mut(), to.p.flat_mut());
        let (given_q, given_p) = lanes[lane].split_at(q.len());
        q.copy_from_slice(given_q);
        p.copy_from_slice(given_p);
        true
    }

    /// Copies the given states of another motion of the same lanes.
    #[inline(always)]
    pub(super) fn copy(&mut self, from: &Self) {
        if self.0.is_some() || from.0.is_some() {
            self.replace(from);
        }
    }

    #[cold]
    #[inline(never)]
    fn replace(&mut self, from: &Self) {
        self.0.clone_from(&from.0);
    }

    /// Forgets the states: what every flow begins with.
    #[inline(always)]
    pub(super) fn forget(&mut self) {
        if self.0.is_some() {
            self.replace(&Self(None));
        }
    }
}
