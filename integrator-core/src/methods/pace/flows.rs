//! The flows of a Hamiltonian `f(T + B) - f(-V)`, whose time is the fictitious one (Mikkola and Tanikawa 1999; Preto and
//! Tremaine 1999).
//!
//! A drift moves the positions and the time, a kick the momenta. Exact solutions of both are the flows of `T` and of `V`
//! for a duration that stays the same: `h f'(T + B)` and `h f'(-V)`.

use super::{TimeTransformed, motion::Timed};
use crate::{
    composition::{Composition, Lead},
    hamiltonian::{Flows, Hamiltonian, QuadraticKinetic, Shaped},
    scalar::real::Real,
    state::precision::Precision,
};
use core::marker::PhantomData;

/// The motion of a system.
pub(super) type TimedOf<H, R, K> = Timed<R, Shaped<H, K>, <H as Hamiltonian>::Parameters<R>>;

/// The function `f` of a time transformation.
pub trait Transformation: Copy + Send + Sync + 'static {
    /// `duration f'(energy)`.
    fn rate<R: Real>(duration: R, energy: R, exponent: f64) -> R;
    /// The exact flow of `-f(-V)`.
    fn kick<H: TimeTransformed, R: Real, K: Precision>(motion: &mut TimedOf<H, R, K>, duration: R);
}

/// `ln`.
#[derive(Clone, Copy)]
pub struct Ln;

impl Transformation for Ln {
    #[inline(always)]
    fn rate<R: Real>(duration: R, energy: R, _exponent: f64) -> R {
        duration / energy
    }
    #[inline(always)]
    fn kick<H: TimeTransformed, R: Real, K: Precision>(motion: &mut TimedOf<H, R, K>, duration: R) {
        H::logarithmic_kick::<R, K>(&mut motion.state, duration);
    }
}

/// `x^g`.
#[derive(Clone, Copy)]
pub struct ToPower;

impl Transformation for ToPower {
    #[inline(always)]
    fn rate<R: Real>(duration: R, energy: R, exponent: f64) -> R {
        duration * R::of(exponent) * energy.powf(R::of(exponent - 1.0))
    }
    #[inline(always)]
    fn kick<H: TimeTransformed, R: Real, K: Precision>(motion: &mut TimedOf<H, R, K>, duration: R) {
        let energy = -H::potential_of::<R, K>(&motion.state);
        motion.pass(R::of(0.0), energy);
        let rate = Self::rate(duration, energy, motion.exponent);
        H::kick_for::<R, K>(&mut motion.state, rate);
    }
}

/// The flows of one motion, for the composition `X`.
///
/// The drift comes first: of the two orders of the flows of `ln`, this one stays on the orbit of two bodies exactly, and
/// the other does not. A composition that begins with a kick has its letters exchanged, which leaves the order of one of
/// general class as it is, since its proof knows nothing that tells the letters apart.
pub(super) struct Transformed<'m, F, X, H: TimeTransformed, R: Real, K: Precision> {
    motion: &'m mut TimedOf<H, R, K>,
    marker: PhantomData<(F, X)>,
}

impl<'m, F: Transformation, X, H: TimeTransformed, R: Real, K: Precision> Transformed<'m, F, X, H, R, K> {
    pub(super) fn new(motion: &'m mut TimedOf<H, R, K>) -> Self {
        Self { motion, marker: PhantomData }
    }

    /// Gives the time its momentum, once.
    #[inline(always)]
    pub(super) fn begin(&mut self) {
        if !self.motion.begun {
            let state = &self.motion.state;
            let energy = H::kinetic_of::<R, K>(state) + H::potential_of::<R, K>(state);
            self.motion.momentum = R::parameter(&|lane| -energy.lane(lane));
            self.motion.begun = true;
        }
    }

    #[inline(always)]
    fn first(&mut self, duration: f64) {
        let energy = H::kinetic_of::<R, K>(&self.motion.state) + self.motion.momentum;
        let rate = F::rate(R::of(duration), energy, self.motion.exponent);
        H::drift_for::<R, K>(&mut self.motion.state, rate);
        self.motion.pass(rate, energy);
    }

    #[inline(always)]
    fn second(&mut self, duration: f64) {
        F::kick::<H, R, K>(self.motion, R::of(duration));
    }
}

impl<F, X, H, R, K> Flows<H> for Transformed<'_, F, X, H, R, K>
where
    F: Transformation,
    X: Composition<H>,
    H: TimeTransformed,
    R: Real,
    K: Precision,
{
    const COMPENSATED: bool = K::COMPENSATED;

    #[inline(always)]
    fn drift(&mut self, duration: f64, _time: f64) {
        if const { matches!(X::STAGES.lead, Lead::Drift) } {
            self.first(duration);
        } else {
            self.second(duration);
        }
    }
    #[inline(always)]
    fn kick(&mut self, duration: f64, _time: f64) {
        if const { matches!(X::STAGES.lead, Lead::Drift) } {
            self.second(duration);
        } else {
            self.first(duration);
        }
    }
    /// There is no third part.
    #[inline(always)]
    fn middle(&mut self, _duration: f64, _backwards: bool) {}
    /// Compositions with these kicks are refused, since `f(T + B)` is not quadratic in the momenta.
    #[inline(always)]
    fn gradient_kick(&mut self, _duration: f64, _gradient: f64, _time: f64)
    where
        H: QuadraticKinetic,
    {
    }
}
