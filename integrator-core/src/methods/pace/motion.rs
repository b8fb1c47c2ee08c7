//! The motion under a time transformation: the state with its time, and what conjugates to it.

#[cfg(feature = "checkpoint")]
use crate::system::motion::Beside;
use crate::{
    error::Unsolved,
    scalar::real::{Mask, Real},
    state::{coords::Coords, phase::Phase, precision::Slot},
    system::motion::{Motion, Plain, Prepared},
};
use alloc::{sync::Arc, vec::Vec};

/// The constants of a run.
pub struct Constants<P> {
    /// Those of the system.
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
    /// What the transformation has beside them: the momentum `B` that is conjugate to the time, or a pace `W`.
    pub(super) beside: R,
    /// Whether `beside` was set.
    pub(super) begun: bool,
    pub(super) exponent: f64,
    /// Whether energies are transformed, and not a pace of the user's.
    transforms_energy: bool,
    /// In the lanes that left the domain, the energy that is not positive there; else one.
    pub(super) left: R,
    /// Why lanes stand still, where some do.
    pub(super) unsolved: Vec<Option<Unsolved>>,
}

impl<R: Real, C: Coords, P> Timed<R, C, P> {
    /// Adds to the time, which is no number any more in the lanes whose energy is not positive. The state goes on there
    /// to wherever it does: steps are taken back to the last time that is a number.
    #[inline(always)]
    pub(super) fn pass(&mut self, duration: R, energy: R) {
        let left = energy.less_or_equal(R::of(0.0));
        self.left = R::select(left, energy, self.left);
        self.time.add(R::select(left, R::of(f64::NAN), duration));
    }

    /// Notes why lanes stand still.
    pub(super) fn note_unsolved(&mut self) {
        let left = self.left;
        if !left.less_or_equal(R::of(0.0)).any() {
            return;
        }
        let reason = |lane| {
            let value: f64 = left.lane(lane);
            (value <= 0.0).then_some(match self.transforms_energy {
                true => Unsolved::Domain { value },
                false => Unsolved::Rate { value },
            })
        };
        self.unsolved = (0..R::LANES).map(reason).collect();
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
            left: R::of(1.0),
            unsolved: Vec::new(),
        }
    }
    fn take_over<'a>(&mut self, of_lane: &dyn Fn(usize) -> (usize, &'a Self))
    where
        Self: 'a,
    {
        let at = |read: &dyn Fn(&Self) -> R| {
            R::state(&|lane| {
                let (lane, from) = of_lane(lane);
                read(from).lane(lane)
            })
        };
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
        self.left = from.left;
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
