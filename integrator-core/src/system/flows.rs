//! The flows that compositions call, those of a single motion and those of several.

use crate::{
    scalar::real::Real,
    state::precision::Precision,
    system::{QuadraticKinetic, System},
};

/// The flows that a composition calls. The executor decides to which motions they are applied.
pub trait Flows<H: System> {
    /// Whether coordinates are compensated, so that the durations of stages need corrections for rounding as well.
    const COMPENSATED: bool;

    /// Sets the midpoint time of the current step: [`System::begin_step`].
    fn begin_step(&mut self, _middle: f64) {}
    /// Applies the flow of `T`.
    fn drift(&mut self, duration: f64, time: f64);
    /// Applies the flow of `V`.
    fn kick(&mut self, duration: f64, time: f64);
    /// Applies the flows of the parts between the first and the last: [`System::middle`].
    fn middle(&mut self, duration: f64, time: f64, backwards: bool);
    /// Applies the flow of `duration·V + gradient·|∇V|²`.
    fn gradient_kick(&mut self, duration: f64, gradient: f64, time: f64)
    where
        H: QuadraticKinetic;
}

/// One motion.
pub(crate) struct Single<'m, H: System, R: Real, K: Precision>(pub(crate) &'m mut H::Motion<R, K>);

impl<H: System, R: Real, K: Precision> Flows<H> for Single<'_, H, R, K> {
    const COMPENSATED: bool = K::COMPENSATED;

    #[inline(always)]
    fn begin_step(&mut self, middle: f64) {
        H::begin_step::<R, K>(self.0, middle);
    }
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn drift(&mut self, duration: f64, time: f64) {
        H::drift::<R, K>(self.0, duration, time);
    }
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn kick(&mut self, duration: f64, time: f64) {
        H::kick::<R, K>(self.0, duration, time);
    }
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn middle(&mut self, duration: f64, time: f64, backwards: bool) {
        H::middle::<R, K>(self.0, duration, time, backwards);
    }
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn gradient_kick(&mut self, duration: f64, gradient: f64, time: f64)
    where
        H: QuadraticKinetic,
    {
        H::gradient_kick::<R, K>(self.0, duration, gradient, time);
    }
}

/// Several motions, stage by stage.
///
/// Unoptimised, a flow in vectors that was inlined at every stage would take megabytes of stack.
pub(crate) struct Together<'m, H: System, R: Real, K: Precision, const N: usize>(
    pub(crate) &'m mut [H::Motion<R, K>; N],
);

impl<H: System, R: Real, K: Precision, const N: usize> Flows<H> for Together<'_, H, R, K, N> {
    const COMPENSATED: bool = K::COMPENSATED;

    #[inline(always)]
    fn begin_step(&mut self, middle: f64) {
        for motion in self.0.iter_mut() {
            H::begin_step::<R, K>(motion, middle);
        }
    }
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn drift(&mut self, duration: f64, time: f64) {
        for motion in self.0.iter_mut() {
            H::drift::<R, K>(motion, duration, time);
        }
    }
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn kick(&mut self, duration: f64, time: f64) {
        H::kick_together::<R, K, N>(self.0, duration, time);
    }
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn middle(&mut self, duration: f64, time: f64, backwards: bool) {
        for motion in self.0.iter_mut() {
            H::middle::<R, K>(motion, duration, time, backwards);
        }
    }
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn gradient_kick(&mut self, duration: f64, gradient: f64, time: f64)
    where
        H: QuadraticKinetic,
    {
        for motion in self.0.iter_mut() {
            H::gradient_kick::<R, K>(motion, duration, gradient, time);
        }
    }
}
