//! The motion of implicit methods: the state in the user's own shape, whatever layout the flows of the system have, and the time
//! that has passed if steps are equal in a fictitious one.

use super::field::Variable;
#[cfg(feature = "checkpoint")]
use crate::system::motion::Beside;
use crate::{
    error::Unsolved,
    scalar::real::Real,
    state::{
        coords::Coords,
        phase::Phase,
        precision::{Precision, Slot},
    },
    system::{
        counts::Counts,
        motion::{Motion, Plain, Prepared, from_lanes},
    },
};
use alloc::vec::Vec;
use core::marker::PhantomData;

/// The number of lanes of a member: its own, which may have those of its tangents after it.
pub(super) const fn together<R: Real>() -> usize {
    R::LANES / R::MEMBERS
}

/// State and constants of a run.
#[derive(Clone)]
pub struct Implicit<F, R: Real, C: Coords, P: Prepared<R>> {
    pub(super) state: Plain<R, C, P>,
    /// The constants of each lane, for derivatives and for the flows of `T` and of `V`.
    pub(super) constants: Vec<P::Single>,
    /// A point in the shape of the coordinates.
    pub(super) shape: Phase<C::With<f64>>,
    /// The faults of lanes whose steps are of no use; empty if there is none.
    pub(super) unsolved: Vec<Option<Unsolved>>,
    /// The number of evaluations of the field.
    pub(super) evaluations: u64,
    /// The time since the state was last changed from outside, and its rounding error.
    pub(super) time: [R; 2],
    /// The momentum that is conjugate to the time, once the motion has begun.
    pub(super) conjugate: Option<R>,
    variable: PhantomData<F>,
}

impl<F, R: Real, C: Coords, P: Prepared<R>> Implicit<F, R, C, P> {
    /// One in the lanes of members with a fault.
    #[cold]
    #[inline(never)]
    pub(super) fn stopped(&self) -> R {
        R::state(&|lane| f64::from(u8::from(self.unsolved[lane - lane % together::<R>()].is_some())))
    }

    /// Stops the lanes with a fault.
    pub(super) fn stop(&mut self, faults: Vec<Option<Unsolved>>) {
        if self.unsolved.is_empty() {
            self.unsolved = faults;
        } else {
            for (own, fault) in self.unsolved.iter_mut().zip(faults) {
                *own = own.take().or(fault);
            }
        }
    }
}

impl<F: Variable, R: Real, C: Coords, P: Prepared<R>> Motion<C, P::Single> for Implicit<F, R, C, P> {
    const TIMED: bool = F::IS_FICTITIOUS;

    fn load(constants: &[&P::Single], states: &[&Phase<C>]) -> Self {
        Self {
            state: Plain::load(constants, states),
            constants: constants.iter().map(|constants| (*constants).clone()).collect(),
            shape: Phase { q: states[0].q.map(Precision::to_f64), p: states[0].p.map(Precision::to_f64) },
            unsolved: Vec::new(),
            evaluations: 0,
            time: Slot::<R>::zero(),
            conjugate: None,
            variable: PhantomData,
        }
    }
    fn take_over<'a>(&mut self, of_lane: &dyn Fn(usize) -> (usize, &'a Self))
    where
        Self: 'a,
    {
        let at = |read: &dyn Fn(&Self) -> R| from_lanes(of_lane, read);
        self.time = [at(&|from| from.time[0]), at(&|from| from.time[1])];
        self.conjugate = of_lane(0).1.conjugate.map(|own| at(&|from| from.conjugate.unwrap_or(own)));
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
        (self.time, self.conjugate) = (from.time, from.conjugate);
    }
    fn unsolved(&self, lane: usize) -> Option<&Unsolved> {
        self.unsolved.get(lane)?.as_ref()
    }
    fn counts(&self) -> Option<Counts> {
        Some(Counts::of_evaluations(self.evaluations))
    }
    fn elapsed(&self, lane: usize) -> Option<[f64; 2]> {
        F::IS_FICTITIOUS.then(|| self.time.map(|part| part.lane(lane)))
    }
    #[cfg(feature = "checkpoint")]
    fn beside(&self) -> Option<Beside> {
        let conjugate = self.conjugate.map(|conjugate| conjugate.lane(0));
        Some(Beside { time: self.elapsed(0)?, conjugate, exponent: 0.0 })
    }
    #[cfg(feature = "checkpoint")]
    fn put_beside(&mut self, Beside { time, conjugate, .. }: &Beside) {
        let [value, carried] = *time;
        self.time = [R::of(value), R::of(carried)];
        self.conjugate = conjugate.map(R::of);
    }
    #[inline(always)]
    fn finite(&self) -> bool {
        self.unsolved.is_empty() && self.state.finite() && self.time[0].finite()
    }
}
