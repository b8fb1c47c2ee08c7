//! Kepler's problem: two coordinates in the lanes of a register, with all sums unrolled.
//!
//! With `u = x² + y²` and `w = u^(-3/2)`, `wₖ = - Σ vⱼ wₖ₋ⱼ - Σ j vⱼ wₖ₋ⱼ / 2k` where `v = u / u₀`. The two lanes
//! contain the two sums, and no division is needed. The products of the newest order with order 0 form a matrix, the
//! tidal tensor of Newton's law. Positions of order `k + 2` follow from it and those of order `k`; everything else is
//! computed in parallel. Products with order 1 come next.

use super::{
    course::{COEFFICIENTS, Course, orders_from_one, with_order},
    planar::{Force, Trajectory},
    weights::INTEGRALS,
};
use crate::{enter::enter_pair, vector::Two};
use integrator_core::Phase;

#[inline(always)]
fn total<T: Two>(x: T) -> T {
    x + x.swap()
}

#[derive(Clone)]
struct Planet;

impl Force for Planet {
    #[inline(always)]
    fn orders<T: Two, const N: usize>([q, p]: [T; 2], z: &mut [T; COEFFICIENTS], momenta: &mut [T; COEFFICIENTS]) {
        let (zero, half) = (T::splat(0.0), T::splat(0.5));
        // `half_u` and `w` repeat half of u and w in both lanes. `multiple` contains half of u, and this times its
        // order.
        let [half_u, w, multiple] = &mut [[zero; COEFFICIENTS]; 3];
        let square = total(q * q);
        w[0] = square.over_cube(T::splat(1.0));
        let inverse = T::splat(1.0) / square;
        let of_half = inverse + inverse;
        let tide = T::splat(-3.0) * w[0] * inverse;
        let direct = (tide * q).fma(q, w[0]);
        let across = tide * q.firsts() * q.seconds();
        (z[0], z[1]) = (q, p);
        momenta[0] = p;
        momenta[1] = zero - w[0] * q;
        z[2] = momenta[1] * half;
        macro_rules! orders {
            ($($k:literal)*) => {$(
                let k: usize = $k;
                if k < N {
                    // Half of u without the products with order 0.
                    let (mut sum, mut other) = (zero, zero);
                    if k.is_multiple_of(2) {
                        sum = half * z[k / 2] * z[k / 2];
                    }
                    for j in (1..k.div_ceil(2)).rev() {
                        if j % 2 == 0 {
                            sum = z[j].fma(z[k - j], sum);
                        } else {
                            other = z[j].fma(z[k - j], other);
                        }
                    }
                    let part = total(sum + other);
                    let newest = total(q * z[k]);
                    half_u[k] = part + newest;
                    multiple[k] = half_u[k] * T::of(1.0, k as f64);

                    // The known part of w; the two newest products are added separately.
                    let mut known = tide * part;
                    if k > 1 {
                        let (mut sum, mut other) = (zero, zero);
                        for j in (2..k / 2 + 1).rev() {
                            sum = multiple[j].fma(w[k - j], sum);
                        }
                        for j in usize::max(2, k / 2 + 1)..k - 1 {
                            other = multiple[j].fma(w[k - j], other);
                        }
                        let both = (sum + other) * (of_half * T::of(-1.0, -0.5 / k as f64));
                        let weight = |j: usize| T::splat(-1.0 - 0.5 * j as f64 / k as f64);
                        let first = of_half * half_u[1];
                        known = (weight(1) * first).fma(w[k - 1], known);
                        if k > 2 {
                            known = (weight(k - 1) * of_half * w[1]).fma(half_u[k - 1], known);
                        }
                        known = known + total(both);
                    }
                    w[k] = tide.fma(newest, known);

                    let (mut sum, mut other) = (zero, zero);
                    for j in (2..k / 2 + 1).rev() {
                        sum = z[j].fma(w[k - j], sum);
                    }
                    for j in usize::max(2, k / 2 + 1)..k {
                        other = z[j].fma(w[k - j], other);
                    }
                    other = sum + other;
                    if k > 1 {
                        other = z[1].fma(w[k - 1], other);
                    }
                    let known = q.fma(known, other);
                    let near = direct.fma(z[k], across * z[k].swap());
                    z[k + 2] = (near + known) * T::splat(-INTEGRALS.twice[k]);
                    momenta[k + 1] = z[k + 2] * T::splat((k + 2) as f64);
                }
            )*};
        }
        orders_from_one!(orders);
    }
}

/// Integrates the planet, passes its states to `see`, and returns the number of steps.
///
/// # Panics
/// If the order is not one of [`ORDERS`](super::ORDERS).
pub fn kepler(start: &Phase<[f64; 2]>, course: Course, see: &mut dyn FnMut(Phase<[f64; 2]>)) -> u64 {
    with_order!(course.order, N => enter_pair(Trajectory::<Planet, N>::new(start, course, see)))
}
