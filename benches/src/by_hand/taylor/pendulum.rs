//! The pendulum: sine and cosine in the two lanes of a register, with all sums unrolled.
//!
//! With `ω = q'` and `z = e^(iq)`, `k zₖ = i Σ ωⱼ zₖ₋₁₋ⱼ`. The code uses `yₖ = zₖ / iᵏ`, for which
//! `k yₖ = Σ ωⱼ i⁻ʲ yₖ₋₁₋ⱼ`: the newest coefficient follows from the previous one by a real factor. For odd `j`, the
//! factor `i⁻ʲ` swaps the lanes; the signs are stored with `ω`.

use super::{
    course::{COEFFICIENTS, Course, Expansion, Kept, follow, orders_from_one, with_order},
    estrin::estrin,
    horizon::{Sizes, reach},
};
use crate::{
    enter::{PairKernel, enter_pair},
    functions::sine_and_cosine,
    problems,
    vector::Two,
};
use integrator_core::Phase;

/// Sign of the real or imaginary part of `iᵏ yₖ`, and of `i⁻ᵏ` with swapped lanes.
#[inline(always)]
fn sign(k: usize) -> f64 {
    if k % 4 < 2 { 1.0 } else { -1.0 }
}

/// Returns the lane of `yₖ` that is the sine up to a sign, in both lanes.
#[inline(always)]
fn part<T: Two>(y: &[T; COEFFICIENTS], k: usize) -> T {
    if k.is_multiple_of(2) { y[k].seconds() } else { y[k].firsts() }
}

/// Computes the signed `ω` of order `k` from this lane of order `k - 1`.
#[inline(always)]
fn rotate<T: Two>(pull: T, k: usize) -> T {
    let weight = -sign(k - 1) * sign(k) / k as f64;
    pull * T::of(weight, if k.is_multiple_of(2) { weight } else { -weight })
}

/// Returns the factor of `ω` of order `j`.
#[inline(always)]
fn factor<T: Two>(y: &[T; COEFFICIENTS], turned: &[T; COEFFICIENTS], j: usize, k: usize) -> T {
    if j.is_multiple_of(2) { y[k] } else { turned[k] }
}

#[derive(Clone)]
struct Pendulum<T, const N: usize> {
    tolerance: f64,
    mobility: f64,
    torque: f64,
    /// Angle and momentum.
    state: Kept<T>,
    /// Coefficients of angle and momentum.
    series: [T; COEFFICIENTS],
}

impl<T: Two, const N: usize> Expansion for Pendulum<T, N> {
    type State = Phase<[f64; 1]>;

    #[inline(always)]
    fn expand(&mut self) -> f64 {
        let begin = self.state.value;
        let zero = T::splat(0.0);
        let [sine, cosine] = sine_and_cosine(begin.firsts());
        let [y, turned] = &mut [[zero; COEFFICIENTS]; 2];
        // Includes the signs of i⁻ʲ and of the lane that -i negates.
        let omega = &mut [zero; COEFFICIENTS];
        y[0] = T::of(cosine.first(), sine.first());
        turned[0] = y[0].swap();
        let mobility = T::splat(self.mobility);
        let momentum = begin.swap().firsts();
        omega[0] = momentum * mobility;
        let pull = T::splat(self.torque * self.mobility);
        let (fall, drift) = (T::splat(-self.torque), T::splat(self.mobility));
        // Sine at order 0.
        let first = y[0].seconds();
        self.series[0] = begin;
        self.series[1] = T::of((momentum * drift).first(), (first * fall).first());
        omega[1] = first * rotate(pull, 1);
        macro_rules! orders {
            ($($k:literal)*) => {$(
                let k: usize = $k;
                if k < N {
                    // From the middle outwards. The newest terms come last, and their weights are computed in advance.
                    let (mut sum, mut other) = (zero, zero);
                    for j in (3..k / 2 + 1).rev() {
                        sum = omega[j].fma(factor(y, turned, j, k - 1 - j), sum);
                    }
                    for j in usize::max(3, k / 2 + 1)..usize::max(3, k - usize::min(k, 2)) {
                        other = omega[j].fma(factor(y, turned, j, k - 1 - j), other);
                    }
                    let inverse = T::splat(1.0 / k as f64);
                    let mut next = (sum + other) * inverse;
                    if k > 4 {
                        next = (rotate(pull, k - 2) * inverse * factor(y, turned, k - 2, 1)).fma(part(y, k - 3), next);
                    }
                    if k > 2 {
                        next = (omega[2] * inverse).fma(factor(y, turned, 2, k - 3), next);
                    }
                    if k > 3 {
                        next = (rotate(pull, k - 1) * inverse * factor(y, turned, k - 1, 0)).fma(part(y, k - 2), next);
                    }
                    if k > 1 {
                        next = (omega[1] * inverse).fma(factor(y, turned, 1, k - 2), next);
                    }
                    next = (omega[0] * inverse).fma(y[k - 1], next);
                    y[k] = next;
                    turned[k] = next.swap();
                    let part = part(y, k);
                    let after = sign(k) / (k + 1) as f64;
                    let momentum = part * (fall * T::splat(after));
                    self.series[k + 1] = T::of(self.series[k + 1].first(), momentum.first());
                    if k + 1 < N {
                        let angle = part * (fall * drift * T::splat(after / (k + 2) as f64));
                        self.series[k + 2] = T::of(angle.first(), 0.0);
                        omega[k + 1] = part * rotate(pull, k + 1);
                    }
                }
            )*};
        }
        // The second coefficient of the angle follows from the sine at order 0.
        self.series[2] = T::of((first * fall * drift).first() * 0.5, 0.0);
        orders_from_one!(orders);
        let size = |k: usize| (self.series[k].first().abs(), self.series[k].swap().first().abs());
        let (value, slope, before, last) = (size(0), size(1), size(N - 1), size(N));
        reach::<N>(
            self.tolerance,
            [
                Sizes { value: value.0, slope: slope.0, before: before.0, last: last.0 },
                Sizes { value: value.1, slope: slope.1, before: before.1, last: last.1 },
            ],
        )
    }

    #[inline(always)]
    fn proceed(&mut self, by: f64) {
        self.state.add(estrin::<T, N>(&self.series, T::splat(by)));
    }

    #[inline(always)]
    fn state(&self) -> Self::State {
        Phase::new([self.state.value.first()], [self.state.value.swap().first()])
    }
}

struct Trajectory<'s, const N: usize> {
    system: &'s problems::Pendulum,
    start: &'s Phase<[f64; 1]>,
    course: Course,
    see: &'s mut dyn FnMut(Phase<[f64; 1]>),
}

impl<const N: usize> PairKernel for Trajectory<'_, N> {
    type Out = u64;
    #[inline(always)]
    fn run<T: Two>(self) -> u64 {
        let problems::Pendulum { mass, length, gravity } = *self.system;
        let pendulum = Pendulum::<T, N> {
            tolerance: self.course.tolerance,
            mobility: 1.0 / (mass * length * length),
            torque: mass * gravity * length,
            state: Kept::of(T::of(self.start.q[0], self.start.p[0])),
            series: [T::splat(0.0); COEFFICIENTS],
        };
        follow(self.course, pendulum, self.see)
    }
}

/// Integrates the pendulum, passes its states to `see`, and returns the number of steps.
///
/// # Panics
/// If the order is not one of [`ORDERS`](super::ORDERS).
pub fn pendulum(
    system: &problems::Pendulum,
    start: &Phase<[f64; 1]>,
    course: Course,
    see: &mut dyn FnMut(Phase<[f64; 1]>),
) -> u64 {
    with_order!(course.order, N => enter_pair(Trajectory::<N> { system, start, course, see }))
}
