//! The flows of time transformations.
//!
//! Those of a Hamiltonian `f(T + B) - f(-V)` in the fictitious time (Mikkola and Tanikawa 1999; Preto and Tremaine 1999) are
//! the flows of `T` and of `V` for durations that stay the same on the way: `h f'(T + B)` and `h f'(-V)`.

use super::{Rated, TimeTransformed, motion::Timed, rated_kick};
use crate::{
    composition::{Composition, Lead},
    scalar::real::{Mask, Real},
    state::precision::Precision,
    system::{QuadraticKinetic, Shaped, System, flows::Flows},
};
use core::marker::PhantomData;

/// The motion of a system.
pub(super) type TimedOf<H, R, K> = Timed<R, Shaped<H, K>, <H as System>::Parameters<R>>;

/// A time transformation: two exact flows, of which one moves positions and time, the other one momenta.
///
/// Each flow checks at its own state that the number it divides by, or takes a power of, is positive. These are the only
/// checks, so that no outcome depends on where a call of `advance` ends.
pub trait Transformation<H: System>: 'static {
    /// Returns the number that the motion has beside its state and time, at the start; with derivatives if requested.
    fn begin<R: Real, K: Precision>(motion: &TimedOf<H, R, K>, along_starts: bool) -> R;
    /// Moves positions and time.
    fn drift<R: Real, K: Precision>(motion: &mut TimedOf<H, R, K>, duration: R);
    /// Moves momenta.
    fn kick<R: Real, K: Precision>(motion: &mut TimedOf<H, R, K>, duration: R);
    /// Returns the number that a drift divides by, or takes a power of. It equals that of a kick up to the errors of
    /// the steps.
    fn followed<R: Real, K: Precision>(motion: &TimedOf<H, R, K>) -> R;
}

/// `f = ln`.
pub struct Ln;

impl<H: TimeTransformed> Transformation<H> for Ln {
    #[inline(always)]
    fn begin<R: Real, K: Precision>(motion: &TimedOf<H, R, K>, along_starts: bool) -> R {
        momentum_of_time::<H, R, K>(motion, along_starts)
    }
    #[inline(always)]
    fn drift<R: Real, K: Precision>(motion: &mut TimedOf<H, R, K>, duration: R) {
        let energy = <Self as Transformation<H>>::followed::<R, K>(motion);
        let duration = duration / energy;
        H::drift_for::<R, K>(&mut motion.state, duration);
        motion.pass(duration, energy);
    }
    #[inline(always)]
    fn kick<R: Real, K: Precision>(motion: &mut TimedOf<H, R, K>, duration: R) {
        let energy = -H::logarithmic_kick::<R, K>(&mut motion.state, duration);
        if const { H::KEEPS_SIGN } {
            let outside = energy.less_or_equal(R::of(0.0));
            if outside.any() {
                leave_domain::<H, R, K>(motion, outside);
            }
        } else {
            motion.kick_by(energy);
        }
    }
    #[inline(always)]
    fn followed<R: Real, K: Precision>(motion: &TimedOf<H, R, K>) -> R {
        H::kinetic_plus::<R, K>(&motion.state, motion.beside)
    }
}

/// Stops the lanes where a kick found `V >= 0` by its sign alone. `V` is computed here, for the error.
#[cold]
#[inline(never)]
fn leave_domain<H: TimeTransformed, R: Real, K: Precision>(motion: &mut TimedOf<H, R, K>, outside: R::Mask) {
    let energy = -H::potential_of::<R, K>(&motion.state);
    motion.leave_domain(outside, energy);
}

/// `f = x^g`.
pub struct ToPower;

impl<H: TimeTransformed> Transformation<H> for ToPower {
    #[inline(always)]
    fn begin<R: Real, K: Precision>(motion: &TimedOf<H, R, K>, along_starts: bool) -> R {
        momentum_of_time::<H, R, K>(motion, along_starts)
    }
    #[inline(always)]
    fn drift<R: Real, K: Precision>(motion: &mut TimedOf<H, R, K>, duration: R) {
        let energy = <Self as Transformation<H>>::followed::<R, K>(motion);
        let duration = duration * slope_of_power(energy, motion.exponent);
        H::drift_for::<R, K>(&mut motion.state, duration);
        motion.pass(duration, energy);
    }
    #[inline(always)]
    fn kick<R: Real, K: Precision>(motion: &mut TimedOf<H, R, K>, duration: R) {
        let energy = -H::potential_of::<R, K>(&motion.state);
        motion.kick_by(energy);
        H::kick_for::<R, K>(&mut motion.state, duration * slope_of_power(energy, motion.exponent));
    }
    #[inline(always)]
    fn followed<R: Real, K: Precision>(motion: &TimedOf<H, R, K>) -> R {
        H::kinetic_plus::<R, K>(&motion.state, motion.beside)
    }
}

/// `B = -H`. The map of `(q, p)` is symplectic at a fixed `B`, a number without a tangent; starts have one of their own each.
#[inline(always)]
fn momentum_of_time<H: TimeTransformed, R: Real, K: Precision>(motion: &TimedOf<H, R, K>, along_starts: bool) -> R {
    let energy = H::kinetic_plus::<R, K>(&motion.state, H::potential_of::<R, K>(&motion.state));
    if along_starts { -energy } else { R::parameter(&|lane| -energy.lane(lane)) }
}

/// The derivative of `x^g`.
#[inline(always)]
fn slope_of_power<R: Real>(x: R, exponent: f64) -> R {
    R::of(exponent) * x.powf(R::of(exponent - 1.0))
}

/// A pace of the user's own, `Ω(q)`, and an auxiliary variable `W` that follows it: `dW/dt` is the derivative of `Ω` along the
/// velocity (Mikkola and Aarseth 2002, Celest. Mech. Dyn. Astron. 84, 343). A drift takes the time `h/W`, a kick `h/Ω`.
pub struct OfRate;

impl<H: Rated> Transformation<H> for OfRate {
    #[inline(always)]
    fn begin<R: Real, K: Precision>(motion: &TimedOf<H, R, K>, _along_starts: bool) -> R {
        H::rate_of::<R, K>(&motion.state)
    }
    #[inline(always)]
    fn drift<R: Real, K: Precision>(motion: &mut TimedOf<H, R, K>, duration: R) {
        let rate = <Self as Transformation<H>>::followed::<R, K>(motion);
        let duration = duration / rate;
        H::drift_for::<R, K>(&mut motion.state, duration);
        motion.pass(duration, rate);
    }
    #[inline(always)]
    fn kick<R: Real, K: Precision>(motion: &mut TimedOf<H, R, K>, duration: R) {
        let [rate, more] = rated_kick::<H, R, K>(&mut motion.state, duration);
        motion.kick_by(rate);
        motion.beside += more;
    }
    #[inline(always)]
    fn followed<R: Real, K: Precision>(motion: &TimedOf<H, R, K>) -> R {
        motion.beside
    }
}

/// The flows of one motion, for the composition `X`.
///
/// The drift comes first: of the two orders of the flows of `ln`, this one stays on the orbit of two bodies exactly, and
/// the other does not. A composition that begins with a kick has its letters exchanged, which leaves the order of one of
/// general class as it is, since its proof does not distinguish the letters.
pub(super) struct Transformed<'m, F, X, H: System, R: Real, K: Precision> {
    motion: &'m mut TimedOf<H, R, K>,
    marker: PhantomData<(F, X)>,
}

impl<'m, F: Transformation<H>, X, H: System, R: Real, K: Precision> Transformed<'m, F, X, H, R, K> {
    pub(super) fn new(motion: &'m mut TimedOf<H, R, K>) -> Self {
        Self { motion, marker: PhantomData }
    }

    /// Gives the motion what it has beside its state and time, once.
    #[inline(always)]
    pub(super) fn begin(&mut self, along_starts: bool) {
        if !self.motion.begun {
            self.motion.beside = F::begin::<R, K>(self.motion, along_starts);
            self.motion.begun = true;
        }
    }
}

impl<F, X, H, R, K> Flows<H> for Transformed<'_, F, X, H, R, K>
where
    F: Transformation<H>,
    X: Composition<H>,
    H: System,
    R: Real,
    K: Precision,
{
    const COMPENSATED: bool = K::COMPENSATED;

    #[inline(always)]
    fn drift(&mut self, duration: f64, _time: f64) {
        if const { matches!(X::STAGES.lead, Lead::Drift) } {
            F::drift::<R, K>(self.motion, R::of(duration));
        } else {
            F::kick::<R, K>(self.motion, R::of(duration));
        }
    }
    #[inline(always)]
    fn kick(&mut self, duration: f64, _time: f64) {
        if const { matches!(X::STAGES.lead, Lead::Drift) } {
            F::kick::<R, K>(self.motion, R::of(duration));
        } else {
            F::drift::<R, K>(self.motion, R::of(duration));
        }
    }
    /// Does nothing, since there is no third part.
    #[inline(always)]
    fn middle(&mut self, _duration: f64, _time: f64, _backwards: bool) {}
    /// Compositions with these kicks are rejected, since `f(T + B)` is not quadratic in the momenta.
    #[inline(always)]
    fn gradient_kick(&mut self, _duration: f64, _gradient: f64, _time: f64)
    where
        H: QuadraticKinetic,
    {
    }
}
