//! The motion under a time transformation: the state with its time, and what conjugates to it.

#[cfg(feature = "checkpoint")]
use crate::system::motion::Beside;
use crate::{
    error::Unsolved,
    scalar::real::{Mask, Real},
    state::{coords::Coords, phase::Phase, precision::Slot},
    system::motion::{Motion, Plain, Prepared, from_lanes},
};
use alloc::{sync::Arc, vec::Vec};

/// The largest ratio of the numbers that a drift and a kick divide by. They are equal up to the errors of the steps. If
/// these are so large, a step has leapt over the edge of the domain, or close to it.
const APART: f64 = 10.0;

/// The constants of a run.
pub struct Constants<P> {
    /// The parameters of the system.
    pub(super) parameters: Arc<P>,
    /// The exponent `g` of a power.
    pub(super) exponent: f64,
    /// Whether energies are transformed, and not a pace of the user's.
    pub(super) transforms_energy: bool,
}

/// State and time of a run.
#[derive(Clone)]
pub struct Timed<R: Real, C: Coords, P> {
    pub(super) state: Plain<R, C, P>,
    /// The time since the state was last changed from outside, and its rounding error.
    pub(super) time: [R; 2],
    /// The additional number of the transformation: the momentum `B` that is conjugate to the time, or a pace `W`.
    pub(super) beside: R,
    /// Whether `beside` was set.
    pub(super) begun: bool,
    pub(super) exponent: f64,
    /// Whether energies are transformed, and not a pace of the user's.
    transforms_energy: bool,
    /// The number that the last drift divided by: `T + B`, or a pace `W`.
    drifted_by: R,
    /// The number that the kick since then divided by: `-V`, or the pace by the user's function; NaN without a kick.
    kicked_by: R,
    /// The faults of lanes that stand still; empty if none does.
    unsolved: Vec<Option<Unsolved>>,
}

impl<R: Real, C: Coords, P> Timed<R, C, P> {
    /// Adds the duration of a drift to the time, after the number that the drift divided by was checked.
    #[inline(always)]
    pub(super) fn pass(&mut self, duration: R, divided_by: R) {
        self.check_drift(divided_by);
        (self.drifted_by, self.kicked_by) = (divided_by, R::of(f64::NAN));
        self.time.add(duration);
    }

    /// Checks the number that a drift divides by: it is positive, and it or the one before the kick is within [`APART`] of what
    /// the kick divided by. All three are equal but for the errors of the steps.
    #[inline(always)]
    pub(super) fn check_drift(&mut self, divided_by: R) {
        self.check_sign(divided_by);
        let (factor, kick) = (R::of(APART), self.kicked_by);
        let (low, high) = (self.drifted_by.min(divided_by), self.drifted_by.max(divided_by));
        let apart = (factor * kick).less(low).or((factor * high).less(kick));
        if apart.any() {
            self.fall_apart(apart, divided_by);
        }
    }

    /// Stops the lanes where the numbers that a drift and a kick divide by are far apart.
    #[cold]
    #[inline(never)]
    fn fall_apart(&mut self, apart: R::Mask, divided_by: R) {
        let (numbers, transforms_energy) = ([divided_by, self.kicked_by], self.transforms_energy);
        self.stop(apart, |lane| {
            let [followed, value] = numbers.map(|number| number.lane(lane));
            match transforms_energy {
                true => Unsolved::EnergiesApart { followed, value },
                false => Unsolved::RatesApart { followed, value },
            }
        });
    }

    /// Checks the number that a kick divided by, and keeps it for the next drift.
    #[inline(always)]
    pub(super) fn kick_by(&mut self, divided_by: R) {
        self.check_sign(divided_by);
        self.kicked_by = divided_by;
    }

    #[inline(always)]
    fn check_sign(&mut self, divided_by: R) {
        let outside = divided_by.less_or_equal(R::of(0.0));
        if outside.any() {
            self.leave_domain(outside, divided_by);
        }
    }

    /// Stops the lanes where a number that a flow divides by is not positive.
    #[cold]
    #[inline(never)]
    pub(super) fn leave_domain(&mut self, outside: R::Mask, divided_by: R) {
        let transforms_energy = self.transforms_energy;
        self.stop(outside, |lane| {
            let value = divided_by.lane(lane);
            if transforms_energy { Unsolved::Domain { value } } else { Unsolved::Rate { value } }
        });
    }

    /// Stops lanes: their time is no number any more, so that their steps are taken back to the last one that ended before.
    fn stop(&mut self, lanes: R::Mask, reason: impl Fn(usize) -> Unsolved) {
        self.time[0] = R::select(lanes, R::of(f64::NAN), self.time[0]);
        let stopped = R::select(lanes, R::of(1.0), R::of(0.0));
        self.unsolved.resize(R::LANES, None);
        for (lane, unsolved) in self.unsolved.iter_mut().enumerate() {
            if stopped.lane(lane) == 1.0 && unsolved.is_none() {
                *unsolved = Some(reason(lane));
            }
        }
    }
}

impl<R: Real, C: Coords, P: Prepared<R>> Motion<C, Constants<P::Single>> for Timed<R, C, P> {
    const TIMED: bool = true;

    fn load(constants: &[&Constants<P::Single>], states: &[&Phase<C>]) -> Self {
        let parameters: Vec<&P::Single> = constants.iter().map(|constants| &*constants.parameters).collect();
        Self {
            state: Plain::load(&parameters, states),
            time: Slot::<R>::zero(),
            beside: R::of(0.0),
            begun: false,
            exponent: constants.first().map_or(1.0, |constants| constants.exponent),
            transforms_energy: constants.first().is_some_and(|constants| constants.transforms_energy),
            drifted_by: R::of(1.0),
            kicked_by: R::of(f64::NAN),
            unsolved: Vec::new(),
        }
    }
    fn take_over<'a>(&mut self, of_lane: &dyn Fn(usize) -> (usize, &'a Self))
    where
        Self: 'a,
    {
        let at = |read: &dyn Fn(&Self) -> R| from_lanes(of_lane, read);
        let (value, carried, beside) = (at(&|from| from.time[0]), at(&|from| from.time[1]), at(&|from| from.beside));
        self.time = [value, carried];
        self.beside = beside;
        self.begun = of_lane(0).1.begun;
    }
    #[inline(always)]
    fn store(&self, lane: usize, to: &mut Phase<C>) {
        self.state.store(lane, to);
    }
    #[inline(always)]
    fn copy_state(&mut self, from: &Self) {
        self.state.copy_state(&from.state);
        (self.time, self.beside, self.begun) = (from.time, from.beside, from.begun);
        (self.drifted_by, self.kicked_by) = (from.drifted_by, from.kicked_by);
        self.unsolved.clone_from(&from.unsolved);
    }
    fn unsolved(&self, lane: usize) -> Option<&Unsolved> {
        self.unsolved.get(lane)?.as_ref()
    }
    fn elapsed(&self, lane: usize) -> Option<[f64; 2]> {
        Some(self.time.map(|part| part.lane(lane)))
    }
    #[cfg(feature = "checkpoint")]
    fn beside(&self) -> Option<Beside> {
        let conjugate = self.begun.then(|| self.beside.lane(0));
        Some(Beside { time: self.elapsed(0)?, conjugate, exponent: self.exponent })
    }
    #[cfg(feature = "checkpoint")]
    fn put_beside(&mut self, Beside { time, conjugate, .. }: &Beside) {
        let [value, carried] = *time;
        self.time = [R::of(value), R::of(carried)];
        self.begun = conjugate.is_some();
        self.beside = R::of(conjugate.unwrap_or(0.0));
    }
    #[inline(always)]
    fn finite(&self) -> bool {
        self.state.finite() && self.time[0].finite()
    }
}
