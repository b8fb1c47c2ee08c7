//! The motion of implicit methods: the state in the user's own shape, whatever layout the flows of the system have.

use crate::{
    error::Unsolved,
    scalar::real::Real,
    state::{coords::Coords, phase::Phase, precision::Precision},
    system::{
        counts::Counts,
        motion::{Motion, Plain, Prepared},
    },
};
use alloc::vec::Vec;

/// State and constants of a run.
#[derive(Clone)]
pub struct Implicit<R: Real, C: Coords, P: Prepared<R>> {
    pub(super) state: Plain<R, C, P>,
    /// The constants of each lane, for derivatives and for the flows of `T` and of `V`.
    pub(super) constants: Vec<P::Single>,
    /// A point in the shape of the coordinates.
    pub(super) shape: Phase<C::With<f64>>,
    /// The faults of lanes that stand still; empty if none does.
    pub(super) unsolved: Vec<Option<Unsolved>>,
    /// The number of evaluations of the field.
    pub(super) evaluations: u64,
}

impl<R: Real, C: Coords, P: Prepared<R>> Motion<C, P::Single> for Implicit<R, C, P> {
    fn load(constants: &[&P::Single], states: &[&Phase<C>]) -> Self {
        Self {
            state: Plain::load(constants, states),
            constants: constants.iter().map(|constants| (*constants).clone()).collect(),
            shape: Phase { q: states[0].q.map(Precision::to_f64), p: states[0].p.map(Precision::to_f64) },
            unsolved: Vec::new(),
            evaluations: 0,
        }
    }
    #[inline(always)]
    fn store(&self, lane: usize, to: &mut Phase<C>) {
        self.state.store(lane, to);
    }
    #[inline(always)]
    fn copy_state(&mut self, from: &Self) {
        self.state.copy_state(&from.state);
        self.unsolved.clone_from(&from.unsolved);
        self.evaluations = from.evaluations;
    }
    fn unsolved(&self, lane: usize) -> Option<&Unsolved> {
        self.unsolved.get(lane)?.as_ref()
    }
    fn counts(&self) -> Option<Counts> {
        Some(Counts::of_evaluations(self.evaluations))
    }
    #[inline(always)]
    fn finite(&self) -> bool {
        self.unsolved.is_empty() && self.state.finite()
    }
}
